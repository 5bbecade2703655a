// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/headless/commands_quality.h"

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <optional>

#include "app/files/labelled_table.h"
#include "app/files/output.h"
#include "app/files/slip.h"
#include "app/files/table.h"
#include "app/headless/commands.h"
#include "app/headless/read_options.h"
#include "engine/quality/capability.h"
#include "engine/quality/charts.h"
#include "engine/quality/gauge_study.h"
#include "engine/quality/steadiness.h"

namespace kerf::headless {
namespace {

using nlohmann::ordered_json;

template <class Value>
ordered_json orNull(const std::optional<Value>& value) {
    return value ? ordered_json(*value) : ordered_json(nullptr);
}

struct CapabilityOptions {
    std::string file{};
    std::string column{"value"};
    std::optional<double> lower{};
    std::optional<double> upper{};
    std::optional<double> target{};
    double confidence{quality::kCapabilityConfidence};
    bool json{false};
    std::shared_ptr<files::ReadOptions> read{};
};

void put(ordered_json& report, const char* key, const std::optional<quality::IndexWithInterval>& index) {
    const std::string name = key;
    report[name] = index ? ordered_json(index->value) : ordered_json(nullptr);
    report[name + "_low"] = index ? ordered_json(index->low) : ordered_json(nullptr);
    report[name + "_high"] = index ? ordered_json(index->high) : ordered_json(nullptr);
}

/// Values in another unit than the limits they are judged by.
void requireUnitOf(const LabelledTable& table, std::size_t column, std::vector<double> values, double lower,
                   double upper, bool accepted) {
    const double meant = 0.5 * (lower + upper);
    const double width = upper - lower;
    if (values.empty() || width > 0.2 * std::abs(meant)) {
        return;  // around zero, or too wide to tell
    }
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    if (const auto slip = files::slipTo(*middle, meant, 2.0 * width / std::abs(meant))) {
        files::refuseUnless(
            accepted, table.table(),
            fmt::format("{}values around {:.6g} do not fit a tolerance of {} to {}; {}",
                        table.table().where(0, table.table().names()[column]), *middle, lower, upper, slip->guess));
    }
}

void capability(const CapabilityOptions& options) {
    if (!options.lower && !options.upper) {
        throw CLI::ValidationError("--lower, --upper", "at least one of them must be given");
    }
    if (options.lower && options.upper && !(*options.lower < *options.upper)) {
        throw CLI::ValidationError("--lower", "must be below --upper");
    }
    LabelledTable table = LabelledTable::read(options.file, *options.read);
    const std::size_t column = table.valueColumn(options.column);
    table.dropGaps(column);
    const std::vector<double> values = table.numbers(column);
    askAboutSlips(table, column, values, options.read->acceptImplausible);
    if (options.lower && options.upper) {
        requireUnitOf(table, column, values, *options.lower, *options.upper, options.read->acceptImplausible);
    }
    const bool quiet = quality::isSteadySeries(values);
    const quality::Capability result =
        quality::capability(values, {options.lower, options.upper, {}}, quiet, options.confidence);
    const quality::CentreLine line = quality::centreLine(values);
    ordered_json report;
    report["n"] = result.count;
    const auto from = [&](std::size_t least, double figure) {
        return result.count >= least ? ordered_json(figure) : ordered_json(nullptr);
    };
    report["mean"] = from(1, result.mean);
    report["s"] = from(2, result.deviation);
    report["s_moving_range"] = from(2, line.sigma);
    report["lower"] = orNull(options.lower);
    report["upper"] = orNull(options.upper);
    report["target"] = orNull(options.target);
    report["off_target"] = options.target ? from(1, result.mean - *options.target) : ordered_json(nullptr);
    put(report, "pp", result.pp);
    put(report, "ppk", result.ppk);
    put(report, "cp", result.cp);
    put(report, "cpk", result.cpk);
    report["confidence"] = options.confidence;
    report["preliminary"] = result.preliminary;
    report["quiet"] = quiet;
    report["below"] = options.lower ? std::ranges::count_if(values, [&](double v) { return v < *options.lower; }) : 0;
    report["above"] = options.upper ? std::ranges::count_if(values, [&](double v) { return v > *options.upper; }) : 0;
    report["reason"] = result.reason.english();
    printJson(report);
    tellNotes(table.table());
}

struct StudyOptions {
    std::string file{};
    std::string method{};
    std::optional<double> tolerance{};
    std::optional<double> reference{};
    bool json{false};
    std::shared_ptr<files::ReadOptions> read{};
};

ordered_json typeOne(const StudyOptions& options, const LabelledTable& table) {
    if (!options.tolerance) {
        throw CLI::ValidationError("--tolerance", "is needed for --method type1");
    }
    const std::vector<double> values = table.numbers(table.valueColumn("value"));
    const auto study = quality::typeOneStudy(values, *options.tolerance, options.reference);
    if (!study) {
        throw BadInput(fmt::format("{}: {}", options.file, study.error().english()));
    }
    ordered_json report;
    report["method"] = options.method;
    report["n"] = study->count;
    report["mean"] = study->mean;
    report["s"] = study->deviation;
    report["s_low"] = study->deviationLow;
    report["s_high"] = study->deviationHigh;
    report["tolerance"] = *options.tolerance;
    report["reference"] = orNull(options.reference);
    report["bias"] = orNull(study->bias);
    report["cg"] = study->cg;
    report["cgk"] = orNull(study->cgk);
    report["ev"] = study->deviation;
    report["pass"] = study->pass;
    return report;
}

/// Labels in the order they first stand in the file, counted from 0.
class Labels {
 public:
    std::uint32_t number(const std::string& label) {
        const auto found = std::ranges::find(m_labels, label);
        if (found != m_labels.end()) {
            return static_cast<std::uint32_t>(found - m_labels.begin());
        }
        m_labels.push_back(label);
        return static_cast<std::uint32_t>(m_labels.size() - 1);
    }
    [[nodiscard]] std::size_t count() const noexcept { return m_labels.size(); }
    [[nodiscard]] const std::string& label(std::size_t number) const { return m_labels[number]; }

 private:
    std::vector<std::string> m_labels{};
};

/// Every person has read every part equally often; what is missing or stands twice is told in the file's own words.
void requireCrossed(const std::string& path, const LabelledTable& table,
                    const std::vector<quality::StudyReading>& readings, const Labels& parts, const Labels& persons,
                    const Labels& trials) {
    using Cell = std::array<std::uint32_t, 3>;
    const auto named = [&](const Cell& at) {
        return fmt::format("part {}, person {}, trial {}", parts.label(at[0]), persons.label(at[1]),
                           trials.label(at[2]));
    };
    std::map<Cell, std::size_t> there;
    for (std::size_t row = 0; row < readings.size(); ++row) {
        const Cell at{readings[row].part, readings[row].person, readings[row].trial};
        if (const auto [first, fresh] = there.emplace(at, row); !fresh) {
            throw BadInput(fmt::format("{}{} stands twice; each reading stands once.",
                                       table.table().where(row, "value"), named(at)));
        }
    }
    if (there.size() == parts.count() * persons.count() * trials.count()) {
        return;
    }
    for (std::uint32_t part = 0; part < parts.count(); ++part) {
        for (std::uint32_t person = 0; person < persons.count(); ++person) {
            for (std::uint32_t trial = 0; trial < trials.count(); ++trial) {
                if (!there.contains({part, person, trial})) {
                    throw BadInput(fmt::format(
                        "{}: {} is missing; every person reads each of the {} parts in each of the {} trials.", path,
                        named({part, person, trial}), parts.count(), trials.count()));
                }
            }
        }
    }
}

ordered_json crossed(const StudyOptions& options, const LabelledTable& table) {
    const std::size_t part = table.column("part");
    const std::size_t person = table.column("person");
    const std::size_t trial = table.column("trial");
    const std::vector<double> values = table.numbers("value");
    Labels parts;
    Labels persons;
    Labels trials;
    std::vector<quality::StudyReading> readings;
    for (std::size_t row = 0; row < values.size(); ++row) {
        readings.push_back({parts.number(table.text(row, part)), persons.number(table.text(row, person)),
                            trials.number(table.text(row, trial)), values[row]});
    }
    requireCrossed(options.file, table, readings, parts, persons, trials);
    const bool anova = options.method == "anova";
    const auto study = quality::crossedStudy(
        readings, anova ? quality::StudyMethod::Anova : quality::StudyMethod::AverageRange, options.tolerance);
    if (!study) {
        throw BadInput(fmt::format("{}: {}", options.file, study.error().english()));
    }
    ordered_json report;
    report["method"] = options.method;
    report["parts"] = study->parts;
    report["persons"] = study->persons;
    report["trials"] = study->trials;
    report["ev"] = study->ev;
    report["ev_low"] = study->evLow;
    report["ev_high"] = study->evHigh;
    report["av"] = study->av;
    report["grr"] = study->grr;
    report["pv"] = study->pv;
    report["tv"] = study->tv;
    report["grr_percent"] = study->grrPercent;
    report["grr_percent_of_tolerance"] = orNull(study->grrPercentOfTolerance);
    report["ndc"] = study->ndc;
    ordered_json set = ordered_json::array();
    const auto negative = [&](bool is, const char* what) {
        if (is) {
            set.push_back(what);
        }
    };
    negative(study->avNegative, "av");
    negative(study->pvNegative, "pv");
    negative(study->interactionNegative, "interaction");
    if (anova) {
        report["ss_person"] = study->ssPerson;
        report["ss_part"] = study->ssPart;
        report["ss_interaction"] = study->ssInteraction;
        report["ss_repeatability"] = study->ssRepeatability;
        report["ss_total"] = study->ssTotal;
        report["f_interaction"] = orNull(study->fInteraction);
        report["p_interaction"] = study->pInteraction;
        report["pooled"] = study->pooled;
        report["interaction"] = study->interaction;
    } else {
        report["mean_range"] = study->meanRange;
        report["person_diff"] = study->personDiff;
        report["part_range"] = study->partRange;
    }
    report["negative_set_to_0"] = std::move(set);
    return report;
}

void gaugeStudy(const StudyOptions& options) {
    LabelledTable table = LabelledTable::read(options.file, *options.read);
    const std::size_t column = table.valueColumn("value");
    if (options.method == "type1") {
        table.dropGaps(column);  // the other studies need every reading
    }
    askAboutSlips(table, column, table.numbers(column), options.read->acceptImplausible);
    printJson(options.method == "type1" ? typeOne(options, table) : crossed(options, table));
    tellNotes(table.table());
}

}  // namespace

void askAboutSlips(const LabelledTable& table, std::size_t column, const std::vector<double>& values, bool accepted) {
    if (const auto slipped = files::slippedAmongItsLike(values)) {
        files::askAbout(table.table(), table.table().names()[column], values[slipped->row], slipped, accepted);
    }
}

void addQualityCapability(CLI::App& quality) {
    const auto options = std::make_shared<CapabilityOptions>();
    CLI::App* command =
        quality.add_subcommand("capability",
                               "Performance and capability of the values of a CSV file against a tolerance, as JSON: "
                               "n, mean, s, pp, ppk, cp,\n"
                               "cpk, each index with _low and _high. pp is null for a one-sided tolerance; cp and cpk "
                               "are null while the chart\n"
                               "of the values shows a signal; below 10 values nothing, below 50 \"preliminary\".");
    command->add_option("file", options->file, "CSV with a column value (or the one --column names)")->required();
    options->read = addReadOptions(*command);
    command->add_option("--column", options->column, "column of the values")->capture_default_str();
    command->add_option("--lower", options->lower, "lower limit of the tolerance");
    command->add_option("--upper", options->upper, "upper limit of the tolerance");
    command->add_option("--target", options->target, "what the mean should be");
    command->add_option("--confidence", options->confidence, "of the two-sided intervals")
        ->check(CLI::Range(0.5, 0.9999))
        ->capture_default_str();
    command->add_flag("--json", options->json, "JSON (the only form)");
    command->callback([options] { capability(*options); });
}

void addQualityGaugeStudy(CLI::App& quality) {
    const auto options = std::make_shared<StudyOptions>();
    CLI::App* command = quality.add_subcommand(
        "gauge-study",
        "A gauge study of the readings in a CSV file, as JSON.\n"
        "type1: column value, one reference, at least 25 readings: cg, cgk (with --reference), s with its interval.\n"
        "average-range, anova: columns part,person,trial,value, every person measures every part equally often: ev, "
        "av,\n"
        "grr, pv, tv, grr_percent, ndc; anova also ss_person, ss_part, ss_interaction, ss_repeatability, ss_total,\n"
        "f_interaction and whether it was pooled.");
    command->add_option("file", options->file, "CSV file")->required();
    options->read = addReadOptions(*command);
    command->add_option("--method", options->method, "type1, average-range or anova")
        ->required()
        ->check(CLI::IsMember({"type1", "average-range", "anova"}));
    command->add_option("--tolerance", options->tolerance, "T, width of the tolerance the gauge is for");
    command->add_option("--reference", options->reference, "type1: true size of the ring");
    command->add_flag("--json", options->json, "JSON (the only form)");
    command->callback([options] { gaugeStudy(*options); });
}

void addQualityCommands(CLI::App& kerf) {
    CLI::App* quality = kerf.add_subcommand(
        "quality", "Charts of a steered process, capability, gauge studies and Q-DAS files (see docs/quality.md)");
    quality->require_subcommand(1);
    addQualityCharts(*quality);
    addQualityCapability(*quality);
    addQualityGaugeStudy(*quality);
    addQualityDfq(*quality);
    addQualityRunLength(*quality);
}

}  // namespace kerf::headless
