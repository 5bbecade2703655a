// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "app/files/output.h"
#include "app/headless/commands_boring.h"
#include "app/headless/commands_quality.h"
#include "engine/process/boring/feed_law.h"
#include "engine/process/boring/one_step_error.h"
#include "engine/process/boring/plant.h"
#include "engine/quality/charts.h"

namespace kerf::headless {
namespace {

using nlohmann::ordered_json;

struct RunLengthOptions {
    std::uint32_t parts{1000};
    std::uint32_t runs{100};
    std::uint64_t seed{1};
    double shift{1.5};
    std::uint32_t shiftRuns{1000};
    std::uint32_t before{60};
    double width{quality::ChartParams{}.ewmaWidth};
    double lambda{quality::ChartParams{}.ewmaLambda};
    std::vector<double> measureAt_mm{40.0, 310.0};
    BoringOptions boring{};
};

constexpr std::uint32_t kLearning = 20;   // parts in which the law is learned; charted, not counted
constexpr std::uint32_t kRawPhase = 30;   // parts a raw chart takes its centre and σ from
constexpr std::uint32_t kWithin = 12;     // parts within which a shift should be signalled
constexpr std::uint32_t kPatience = 200;  // parts after a shift

/// One part of a simulated lot that the loop steers.
struct Part {
    boring::OneStepError error{};
    double raw_mm{0.0};  ///< measured deflection less its target, first depth
    bool perturbed{false};
};

/// A lot as the loop cuts it. From part `shiftAt` on (0: never) the law makes `shift_mm` more deflection at the target.
class Lot {
 public:
    Lot(const RunLengthOptions& options, std::uint32_t run)
        : m_options(options),
          m_params(options.boring.params()),
          m_feed(boring::feedLawParams(m_params.kind, options.boring.targetDeflection_mm, 0.5)),
          m_state(boring::initialState(m_params)),
          m_noise(Random(options.seed).stream(run)) {}

    Part cut(std::uint32_t number, double shift_mm) {
        boring::LawConstants law = boring::TruthPlan::table().at(1);
        law.lnC += std::log1p(shift_mm / m_feed.targetDeflection_mm);
        const BoringSchedule schedule = boring::adviseFeed(m_state, m_feed).schedule;
        boring::PartVisit visit;
        visit.part = number;
        for (const double overhang_mm : m_options.measureAt_mm) {
            const double true_mm = boring::deflection_mm(law, schedule.feed_mmPerRev(overhang_mm), overhang_mm);
            const double measured_mm = boring::measured_mm(true_mm, m_params.sigma_mm(), m_noise.gauss());
            if (measured_mm > 0.0) {
                visit.rows[visit.count++] = boring::measurementAt(schedule, overhang_mm, measured_mm);
            }
        }
        Part part;
        if (visit.count > 0) {
            part.error = boring::oneStepError(m_state, m_params, visit);
            std::array<boring::RowOutcome, kMaxBoreDepths> outcomes{};
            m_state = boring::step(m_state, m_params, visit, std::span(outcomes).first(visit.count));
            part.perturbed = outcomes[visit.count - 1U].perturbed;
            part.raw_mm = visit.rows[0].deflection_mm - m_feed.targetDeflection_mm;
        }
        return part;
    }

 private:
    const RunLengthOptions& m_options;
    boring::EstimatorParams m_params;
    boring::FeedLawParams m_feed;
    boring::EstimatorState m_state;
    Random m_noise;
};

/// A set of rules on the residuals, or on raw deviations as a shop without a law would chart them.
struct Chart {
    const char* name;
    quality::RuleSet rules;
    bool raw{false};
    // figures
    std::uint64_t counted{0};
    std::uint64_t alarms{0};
    std::vector<std::uint32_t> delays{};  ///< parts from the shift to the first signal; kPatience + 1: none
};

quality::RuleSet family(const char* key) {
    quality::RuleSet set;
    for (std::size_t i = 0; i < quality::kRules; ++i) {
        set[i] = std::string(quality::ruleKey(static_cast<quality::Rule>(i))).starts_with(key);
    }
    return set;
}

std::vector<Chart> charts() {
    using quality::Rule;
    using quality::rules;
    return {{"default: nelson1 (T²) and ewma", quality::kDefaultRules},
            {"nelson1 (T²)", rules({Rule::Nelson1})},
            {"ewma", rules({Rule::Ewma})},
            {"nelson1 (T²) and cusum", rules({Rule::Nelson1, Rule::Cusum})},
            {"cusum", rules({Rule::Cusum})},
            {"all eight of Nelson", family("nelson")},
            {"all of Western Electric", family("western")},
            {"raw: nelson1", rules({Rule::Western1}), true},
            {"raw: nelson1 and ewma", rules({Rule::Western1, Rule::Ewma}), true},
            {"raw: all eight of Nelson", family("nelson"), true},
            {"raw: all of Western Electric", family("western"), true}};
}

/// One chart over one lot.
class Watch {
 public:
    Watch(const RunLengthOptions& options, const Chart& chart) : m_chart(chart) {
        quality::ChartParams params;
        params.active = chart.rules;
        params.ewmaWidth = options.width;
        params.ewmaLambda = options.lambda;
        m_state = quality::ChartState(params);
    }

    /// Whether the part signals. The chart begins anew after a signal (somebody has looked) and after a change the
    /// estimator noticed itself.
    bool takes(const Part& part) {
        std::optional<quality::ChartPoint> point;
        if (m_chart.raw) {
            if (m_phase.size() < kLearning + kRawPhase) {
                m_phase.push_back(part.raw_mm);
                return false;
            }
            if (m_line.sigma <= 0.0) {
                m_line = quality::centreLine(std::span(m_phase).subspan(kLearning));
            }
            point = m_state.push((part.raw_mm - m_line.centre) / m_line.sigma);
        } else if (part.error.count > 0) {
            point = m_state.push(part.error.level, part.error.tSquared > quality::tSquaredLimit(part.error.count));
        }
        const bool fired = point && point->fired.any();
        if (fired || (part.perturbed && !m_chart.raw)) {
            m_state.reset();
        }
        return fired;
    }
    [[nodiscard]] std::uint32_t firstCounted() const { return m_chart.raw ? kLearning + kRawPhase + 1 : kLearning + 1; }

 private:
    const Chart& m_chart;
    quality::ChartState m_state{};
    std::vector<double> m_phase{};
    quality::CentreLine m_line{};
};

void runInControl(const RunLengthOptions& options, std::vector<Chart>& all) {
    for (std::uint32_t run = 1; run <= options.runs; ++run) {
        Lot lot(options, run);
        std::vector<Watch> watches;
        for (const Chart& chart : all) {
            watches.emplace_back(options, chart);
        }
        for (std::uint32_t number = 1; number <= options.parts; ++number) {
            const Part part = lot.cut(number, 0.0);
            for (std::size_t i = 0; i < all.size(); ++i) {
                const bool fired = watches[i].takes(part);
                if (number >= watches[i].firstCounted()) {
                    ++all[i].counted;
                    all[i].alarms += fired ? 1U : 0U;
                }
            }
        }
    }
}

void runShifted(const RunLengthOptions& options, std::vector<Chart>& all) {
    const double shift_mm = options.shift * options.boring.sigma_mm;
    for (std::uint32_t run = 1; run <= options.shiftRuns; ++run) {
        Lot lot(options, options.runs + run);
        std::vector<Watch> watches;
        for (Chart& chart : all) {
            watches.emplace_back(options, chart);
            chart.delays.push_back(kPatience + 1);
        }
        for (std::uint32_t number = 1; number <= options.before + kPatience; ++number) {
            const bool shifted = number > options.before;
            const Part part = lot.cut(number, shifted ? shift_mm : 0.0);
            for (std::size_t i = 0; i < all.size(); ++i) {
                if (watches[i].takes(part) && shifted) {
                    all[i].delays.back() = std::min(all[i].delays.back(), number - options.before);
                }
            }
        }
    }
}

ordered_json figuresOf(Chart& chart) {
    ordered_json json;
    json["chart"] = chart.name;
    json["parts"] = chart.counted;
    json["alarms"] = chart.alarms;
    json["run_length"] = chart.alarms > 0
                             ? ordered_json(static_cast<double>(chart.counted) / static_cast<double>(chart.alarms))
                             : ordered_json(nullptr);
    json["false_alarms_per_1000_parts"] =
        chart.counted > 0 ? 1000.0 * static_cast<double>(chart.alarms) / static_cast<double>(chart.counted) : 0.0;
    if (!chart.delays.empty()) {
        std::ranges::sort(chart.delays);
        const std::uint32_t median = chart.delays[chart.delays.size() / 2];
        const auto within = std::ranges::upper_bound(chart.delays, kWithin) - chart.delays.begin();
        json["shift_median_parts"] = median > kPatience ? ordered_json(nullptr) : ordered_json(median);
        json["shift_within_12"] = static_cast<double>(within) / static_cast<double>(chart.delays.size());
    }
    return json;
}

void runLength(const RunLengthOptions& options) {
    if (options.before <= kLearning + kRawPhase) {
        throw CLI::ValidationError("--before", fmt::format("must be above {}", kLearning + kRawPhase));
    }
    std::vector<Chart> all = charts();
    runInControl(options, all);
    if (options.shiftRuns > 0) {
        runShifted(options, all);
    }
    ordered_json report;
    report["sigma_mm"] = options.boring.sigma_mm;
    report["estimator"] = options.boring.estimator;
    report["depths"] = options.measureAt_mm.size();
    report["lots"] = options.runs;
    report["parts_per_lot"] = options.parts;
    report["shift_sigma"] = options.shift;
    report["shifted_lots"] = options.shiftRuns;
    report["seed"] = options.seed;
    report["ewma_lambda"] = options.lambda;
    report["ewma_width"] = options.width;
    report["charts"] = ordered_json::array();
    for (Chart& chart : all) {
        report["charts"].push_back(figuresOf(chart));
    }
    printJson(report);
}

}  // namespace

void addQualityRunLength(CLI::App& quality) {
    const auto options = std::make_shared<RunLengthOptions>();
    CLI::App* command = quality.add_subcommand(
        "run-length",
        "How often charts alarm on simulated boring lots that the loop steers: run_length, the mean number of parts\n"
        "between false alarms of a law that does not change, and how many parts after a lasting shift of the law the\n"
        "first signal comes. \"raw\" charts take the deviations from the target instead of the one-step errors, with\n"
        "centre and σ from 30 parts, as for a process that nobody corrects. The first 20 parts of a lot are not "
        "counted.");
    command->add_option("--parts", options->parts, "parts per lot")
        ->check(CLI::Range(100U, 100000U))
        ->capture_default_str();
    command->add_option("--runs", options->runs, "lots without a shift")
        ->check(CLI::Range(1U, 100000U))
        ->capture_default_str();
    command->add_option("--shift", options->shift, "lasting shift of the deflection at the target, in σ of the gauge")
        ->check(CLI::Range(-3.0, 10.0))
        ->capture_default_str();
    command->add_option("--shift-runs", options->shiftRuns, "lots with a shift")
        ->check(CLI::Range(0U, 100000U))
        ->capture_default_str();
    command->add_option("--before", options->before, "parts before the shift")
        ->check(CLI::Range(51U, 10000U))
        ->capture_default_str();
    command->add_option("--lambda", options->lambda, "λ of the EWMA")
        ->check(CLI::Range(0.01, 1.0))
        ->capture_default_str();
    command->add_option("--width", options->width, "half width of the EWMA's limits, in its σ")
        ->check(CLI::Range(0.1, 20.0))
        ->capture_default_str();
    command->add_option("--measure-at", options->measureAt_mm, "overhangs measured, mm")->delimiter(',');
    command->add_option("--seed", options->seed, "same seed, same digits")->capture_default_str();
    options->boring.addTo(*command);
    command->callback([options] {
        if (options->measureAt_mm.empty() || options->measureAt_mm.size() > kMaxBoreDepths) {
            throw CLI::ValidationError("--measure-at", fmt::format("expects 1 to {} overhangs", kMaxBoreDepths));
        }
        runLength(*options);
    });
}

}  // namespace kerf::headless
