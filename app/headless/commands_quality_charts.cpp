// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "app/files/labelled_table.h"
#include "app/files/output.h"
#include "app/files/slip.h"
#include "app/files/table.h"
#include "app/headless/commands_boring.h"
#include "app/headless/commands_quality.h"
#include "app/headless/quality_lot.h"
#include "app/headless/read_options.h"
#include "engine/process/boring/feed_law.h"
#include "engine/process/boring/one_step_error.h"
#include "engine/quality/charts.h"

namespace kerf::headless {
namespace {

using nlohmann::ordered_json;

struct ChartsOptions {
    std::string file{};
    std::string folder{};
    std::vector<std::string> lots{};
    std::vector<std::string> rules{};
    std::string column{"value"};
    std::optional<double> target{};
    std::optional<double> sigma{};
    quality::ChartParams params{};
    bool startLimits{false};
    BoringOptions boring{};
    bool json{false};
    bool csv{false};
    std::shared_ptr<files::ReadOptions> read{};
};

/// One point, whatever it came from.
struct Point {
    std::string part{};
    std::optional<double> value{};
    double error{0.0};
    std::optional<double> tSquared{};
    std::optional<double> tSquaredLimit{};
    std::optional<double> action{};
    bool perturbed{false};
    bool begins{false};  ///< the charts begin anew before it: another lot, an announced change
    std::string lot{};   ///< of several
    quality::ChartPoint chart{};
};

struct Series {
    std::string source{};
    std::vector<Point> points{};
    std::optional<double> centre{};
    std::optional<double> sigma{};
    std::string sentence{};
};

quality::RuleSet rulesOf(const std::vector<std::string>& keys) {
    if (keys.empty()) {
        return quality::kDefaultRules;
    }
    quality::RuleSet set;
    for (const std::string& key : keys) {
        if (key == "nelson" || key == "western") {
            for (std::size_t i = 0; i < quality::kRules; ++i) {
                const std::string name = quality::ruleKey(static_cast<quality::Rule>(i));
                set[i] = set[i] || name.starts_with(key);
            }
            continue;
        }
        const auto rule = quality::ruleOf(key);
        if (!rule) {
            throw CLI::ValidationError(
                "--rules",
                "'" + key + "' is none of nelson1 to nelson8, western1 to western4, ewma, cusum, nelson, western");
        }
        set[static_cast<std::size_t>(*rule)] = true;
    }
    return set;
}

std::string partName(const LabelledTable& table, std::size_t row) {
    return table.has("part") ? table.text(row, table.column("part")) : std::to_string(row + 1);
}

/// Bores: the law is estimated part by part as the console does, and its one-step errors are charted.
Series ofBores(const ChartsOptions& options, const LabelledTable& table, const char* column) {
    const auto part = table.numbers("part");
    const auto overhang = table.numbers("overhang_mm");
    const auto feed = table.numbers("feed_mm_per_rev");
    const auto deflection = table.numbers(column);
    const boring::EstimatorParams params = options.boring.params();
    requireSpindleOverhang(table.table(), overhang, boring::FeedLawParams{}, options.read->acceptImplausible);
    boring::EstimatorState state = boring::initialState(params);
    Series series{"one-step error of the bores", {}, {}, {}, {}};
    for (std::size_t row = 0; row < table.rows();) {
        boring::PartVisit visit;
        const bool sane = part[row] >= 1.0 && part[row] <= 1e9 && part[row] == std::floor(part[row]);
        if (!sane) {
            throw BadInput(fmt::format("{}{} is no number from 1.", table.table().where(row, "part"), part[row]));
        }
        visit.part = static_cast<std::uint32_t>(part[row]);
        for (; row < table.rows() && static_cast<double>(visit.part) == part[row]; ++row) {
            if (!(overhang[row] > 0.0 && feed[row] > 0.0 && deflection[row] > 0.0) || visit.count == kMaxBoreDepths) {
                throw BadInput(
                    fmt::format("{}overhang, feed and deflection must be above 0, and a part has at most {} bores.",
                                table.table().where(row, column), kMaxBoreDepths));
            }
            visit.rows[visit.count] = {overhang[row], feed[row], deflection[row], false};
            const auto verdict = boring::judgeEntry(state, params, visit.rows[visit.count++]);
            if (verdict.verdict != boring::GateVerdict::Accept) {
                const std::string what = fmt::format("{}{} cannot be meant: {}", table.table().where(row, column),
                                                     deflection[row], verdict.reason.english());
                files::refuseUnless(options.read->acceptImplausible, table.table(), what);
            }
        }
        const boring::OneStepError error = boring::oneStepError(state, params, visit);
        std::array<boring::RowOutcome, kMaxBoreDepths> outcomes{};
        state = boring::step(state, params, visit, std::span(outcomes).first(visit.count));
        if (error.count > 0) {
            Point point;
            point.part = std::to_string(visit.part);
            point.error = error.level;
            point.tSquared = error.tSquared;
            point.tSquaredLimit = quality::tSquaredLimit(error.count);
            point.action = visit.rows[0].feed_mmPerRev;
            point.perturbed = outcomes[visit.count - 1U].perturbed;
            series.points.push_back(std::move(point));
        }
    }
    tellNotes(table.table());
    return series;
}

Series ofFile(const ChartsOptions& options) {
    LabelledTable table = LabelledTable::read(options.file, *options.read);
    if (table.has("deflection_mm")) {
        return ofBores(options, table, "deflection_mm");
    }
    if (table.has(kSimulatedDeflection) && table.has("overhang_mm")) {
        table.dropGaps(table.column(kSimulatedDeflection));  // where a simulated part is only looked at
        return ofBores(options, table, kSimulatedDeflection);
    }
    const bool errors = table.has("error") && !table.has(options.column);
    const std::size_t column = errors ? table.column("error") : table.valueColumn(options.column);
    table.dropGaps(column);
    const auto values = table.numbers(column);
    if (!errors) {
        askAboutSlips(table, column, values, options.read->acceptImplausible);
    }
    Series series;
    const quality::CentreLine line = quality::centreLine(values);
    series.source = errors ? "standardised errors of the file" : "values of the file";
    series.centre = errors ? 0.0 : options.target.value_or(line.centre);
    series.sigma = errors ? 1.0 : options.sigma.value_or(line.sigma);
    if (!(*series.sigma > 0.0)) {
        throw BadInput(fmt::format("{}: the values do not vary, so there is no σ; give --sigma.", options.file));
    }
    for (std::size_t row = 0; row < values.size(); ++row) {
        Point point;
        point.part = partName(table, row);
        point.value = values[row];
        point.error = (values[row] - *series.centre) / *series.sigma;
        series.points.push_back(std::move(point));
    }
    tellNotes(table.table());
    return series;
}

/// Adds the points of one lot; `several`: they name their lot.
void addLot(const ChartsOptions& options, const std::string& name, bool several, Series& series) {
    const StoredLot stored = storedLot(options.folder, name);
    const LotQuality quality = analyseLot(stored.history, stored.limits, stored.announced, options.params);
    const bool bores = stored.history.lot.process == ProcessId::Boring;
    series.source = bores ? "one-step error of the bores" : "first judged figure";
    const std::string lot = stored.history.lot.name.empty() ? name : stored.history.lot.name;
    series.sentence += series.sentence.empty() ? "" : " ";
    series.sentence += (several ? "Lot " + lot + ": " : std::string()) + quality.sentence.english();
    bool first = true;
    for (const ChartedPart& part : quality.charted) {
        Point point;
        point.begins = first || part.announced;
        point.lot = several ? lot : std::string();
        first = false;
        point.part = std::to_string(part.number);
        point.error = part.error;
        if (bores) {
            point.tSquared = part.tSquared;
            point.tSquaredLimit = part.tSquaredLimit;
            point.action = part.action;
        }
        point.perturbed = part.perturbed;
        series.points.push_back(std::move(point));
    }
}

Series ofLots(const ChartsOptions& options) {
    Series series;
    for (const std::string& lot : options.lots) {
        addLot(options, lot, options.lots.size() > 1, series);
    }
    return series;
}

void run(const quality::ChartParams& params, Series& series) {
    quality::ChartState chart(params);
    for (Point& point : series.points) {
        if (point.begins) {
            chart.reset();
        }
        const auto beyond =
            point.tSquared ? std::optional(*point.tSquared > point.tSquaredLimit.value_or(0.0)) : std::nullopt;
        point.chart = chart.push(point.error, beyond);
        if (point.perturbed) {
            chart.reset();
        }
    }
}

std::string firedText(const quality::RuleSet& fired) {
    std::string text;
    for (std::size_t i = 0; i < quality::kRules; ++i) {
        if (fired[i]) {
            text += text.empty() ? "" : " ";
            text += quality::ruleKey(static_cast<quality::Rule>(i));
        }
    }
    return text;
}

std::string orEmpty(const std::optional<double>& value) {
    return value ? fmt::format("{}", *value) : std::string{};
}

ordered_json orNull(const std::optional<double>& value) {
    return value ? ordered_json(*value) : ordered_json(nullptr);
}

void printCsv(const Series& series) {
    const bool several = !series.points.empty() && !series.points.front().lot.empty();
    const std::string columns =
        "part,value,error,t_squared,t_squared_limit,ewma,ewma_limit,cusum_high,cusum_low,action,perturbed,signals";
    CsvOutput csv(columns + (several ? ",lot" : ""));
    for (const Point& point : series.points) {
        const auto row = [&](const auto&... behind) {
            csv.row(point.part, orEmpty(point.value), point.error, orEmpty(point.tSquared),
                    orEmpty(point.tSquaredLimit), point.chart.ewma, point.chart.ewmaLimit, point.chart.cusumHigh,
                    point.chart.cusumLow, orEmpty(point.action), point.perturbed, firedText(point.chart.fired),
                    behind...);
        };
        several ? row(point.lot) : row();
    }
    csv.flush();
}

void printReport(const ChartsOptions& options, const Series& series) {
    ordered_json report;
    report["source"] = series.source;
    report["n"] = series.points.size();
    report["centre"] = orNull(series.centre);
    report["sigma"] = orNull(series.sigma);
    report["rules"] = ordered_json::array();
    for (std::size_t i = 0; i < quality::kRules; ++i) {
        if (options.params.active[i]) {
            report["rules"].push_back(quality::ruleKey(static_cast<quality::Rule>(i)));
        }
    }
    report["lambda"] = options.params.ewmaLambda;
    report["width"] = options.params.ewmaWidth;
    report["k"] = options.params.cusumAllowance;
    report["h"] = options.params.cusumLimit;
    if (series.centre && series.sigma) {
        const double half = quality::ewmaLimit(*series.sigma, options.params.ewmaLambda, options.params.ewmaWidth);
        report["ewma_lower"] = *series.centre - half;
        report["ewma_upper"] = *series.centre + half;
        report["cusum_limit"] = options.params.cusumLimit * *series.sigma;
    }
    ordered_json fired = ordered_json::array();
    ordered_json points = ordered_json::array();
    for (std::size_t index = 0; index < series.points.size(); ++index) {
        const Point& point = series.points[index];
        ordered_json row;
        row["part"] = point.part;
        row["value"] = orNull(point.value);
        row["error"] = point.error;
        row["t_squared"] = orNull(point.tSquared);
        row["t_squared_limit"] = orNull(point.tSquaredLimit);
        row["ewma"] = point.chart.ewma;
        row["ewma_limit"] = point.chart.ewmaLimit;
        row["cusum_high"] = point.chart.cusumHigh;
        row["cusum_low"] = point.chart.cusumLow;
        row["action"] = orNull(point.action);
        row["perturbed"] = point.perturbed;
        row["signals"] = ordered_json::array();
        if (!point.lot.empty()) {
            row["lot"] = point.lot;
        }
        for (std::size_t i = 0; i < quality::kRules; ++i) {
            if (point.chart.fired[i]) {
                const auto rule = static_cast<quality::Rule>(i);
                row["signals"].push_back(quality::ruleKey(rule));
                fired.push_back({{"point", index + 1},
                                 {"part", point.part},
                                 {"rule", quality::ruleKey(rule)},
                                 {"text", quality::ruleText(rule)}});
                if (!point.lot.empty()) {
                    fired.back()["lot"] = point.lot;
                }
            }
        }
        points.push_back(std::move(row));
    }
    report["in_control"] = fired.empty();
    report["sentence"] = series.sentence;
    report["signals"] = std::move(fired);
    report["points"] = std::move(points);
    printJson(report);
}

void charts(ChartsOptions options) {
    if (options.file.empty() == options.lots.empty()) {
        throw CLI::ValidationError("FILE or --lot", "exactly one of them must be given");
    }
    options.params.active = rulesOf(options.rules);
    options.params.ewmaSteadyState = !options.startLimits;
    Series series = options.file.empty() ? ofLots(options) : ofFile(options);
    run(options.params, series);
    options.csv ? printCsv(series) : printReport(options, series);
}

}  // namespace

void addQualityCharts(CLI::App& quality) {
    const auto options = std::make_shared<ChartsOptions>();
    CLI::App* command = quality.add_subcommand(
        "charts",
        "Control charts of a file or of a stored lot: standardised error, T², EWMA, CUSUM and the rules that fired.\n"
        "FILE.csv: column value (or --column) against --target and --sigma, by default the mean and the mean moving\n"
        "range; or column error, already standardised; or part,overhang_mm,feed_mm_per_rev,deflection_mm: bores, "
        "whose\n"
        "one-step errors are charted after the law, as on the console.\n"
        "--lot: a lot of the data file. JSON: signals and points; --csv: one row per point.");
    command->add_option("file", options->file, "CSV file");
    options->read = addReadOptions(*command);
    command->add_option("--data", options->folder, "Folder of kerf.db (default: the user's data folder)");
    command->add_option("--lot", options->lots, "name or number of a lot; repeat for several, one after the other")
        ->allow_extra_args(false);
    command
        ->add_option("--rules", options->rules,
                     "nelson1 to nelson8, western1 to western4, ewma, cusum; nelson and western mean all of theirs; "
                     "default nelson1,ewma")
        ->delimiter(',');
    command->add_option("--column", options->column, "column of the values")->capture_default_str();
    command->add_option("--target", options->target, "centre line of the values");
    command->add_option("--sigma", options->sigma, "standard deviation of the values")->check(CLI::PositiveNumber);
    command->add_option("--lambda", options->params.ewmaLambda, "λ of the EWMA")
        ->check(CLI::Range(0.001, 1.0))
        ->capture_default_str();
    command->add_option("--width", options->params.ewmaWidth, "half width of the EWMA's limits, in its σ")
        ->check(CLI::Range(0.1, 20.0))
        ->capture_default_str();
    command->add_flag("--start-limits", options->startLimits, "the EWMA's exact, narrower limits at the start");
    command->add_option("--k", options->params.cusumAllowance, "allowance of the CUSUM, in σ")
        ->check(CLI::Range(0.0, 10.0))
        ->capture_default_str();
    command->add_option("--h", options->params.cusumLimit, "limit of the CUSUM, in σ")
        ->check(CLI::Range(0.01, 100.0))
        ->capture_default_str();
    options->boring.addTo(*command);
    CLI::Option* json = command->add_flag("--json", options->json, "JSON (default)");
    command->add_flag("--csv", options->csv, "CSV")->excludes(json);
    command->callback([options] { charts(*options); });
}

}  // namespace kerf::headless
