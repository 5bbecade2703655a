// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <array>
#include <charconv>
#include <memory>
#include <optional>

#include "app/files/output.h"
#include "app/files/thermal_files.h"
#include "app/files/thermal_model_json.h"
#include "app/headless/commands.h"
#include "app/headless/read_options.h"
#include "app/headless/thermal_commands.h"
#include "engine/process/thermal/replay.h"
#include "engine/process/thermal/training.h"

namespace kerf::headless {
namespace {

using namespace thermal;
using Json = nlohmann::ordered_json;

/// An axis that is not known is null.
Json axes(const PerAxis& values, const std::array<bool, kAxes>& known = {true, true, true}) {
    Json out;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        out[std::string(1, "xyz"[axis])] = known[axis] ? Json(values[axis]) : Json();
    }
    return out;
}

/// Three fields; an axis that is not known stays empty.
std::string cells(const PerAxis& values, const std::array<bool, kAxes>& known) {
    std::string out;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        out += axis > 0 ? "," : "";
        out += known[axis] ? fmt::format("{}", values[axis]) : "";
    }
    return out;
}

/// "240-359": minutes from … to, both included.
std::pair<double, double> minutesFrom(const std::string& text) {
    double from = 0.0;
    double to = 0.0;
    const char* end = text.data() + text.size();
    const auto first = std::from_chars(text.data(), end, from);
    if (first.ec == std::errc{} && first.ptr != end && *first.ptr == '-') {
        const auto second = std::from_chars(first.ptr + 1, end, to);
        if (second.ec == std::errc{} && second.ptr == end && from >= 0.0 && to > from) {
            return {from, to};
        }
    }
    throw BadInput(
        fmt::format("--check-rows: '{}' is no range; expected FROM-TO in minutes, 0 <= FROM < TO, as 240-359.", text));
}

void printJudgement(const char* kind, std::size_t sensors, const Judgement& judgement) {
    fmt::print(stderr, "{:<11} {:>2} sensors  rms {:.3g} {:.3g} {:.3g} um  worst {:.3g} {:.3g} {:.3g} um  ({})\n", kind,
               sensors, judgement.rms_um[0], judgement.rms_um[1], judgement.rms_um[2], judgement.worst_um[0],
               judgement.worst_um[1], judgement.worst_um[2],
               judgement.heldOut ? "each day judged by the others" : "own check rows: not held out");
}

struct TrainArguments {
    std::vector<std::string> histories{};
    std::string kind{"auto"};
    std::string criterion{"combined"};
    std::string checkRows{};
    std::string output{};
    double rest_min{0.0};
    int maxSensors{TrainingOptions{}.maxSensors};
    bool report{false};
    std::shared_ptr<files::ReadOptions> read{};
};

ThermalModel checked(Result<ThermalModel> model) {
    if (!model) {
        throw BadInput(model.error().english());
    }
    return std::move(*model);
}

void addRest(CLI::App& command, double& rest_min) {
    command
        .add_option("--rest-min", rest_min,
                    "Minutes the machine stood at the beginning, of a file whose clock counts from its first row (by "
                    "default until the spindle first turns)")
        ->check(CLI::Range(1e-6, 1440.0));
}

void train(const TrainArguments& arguments) {
    TrainingOptions options;
    options.maxSensors = arguments.maxSensors;
    options.criterion = arguments.criterion == "regularity" ? GmdhCriterion::Regularity
                        : arguments.criterion == "unbiased" ? GmdhCriterion::Unbiased
                                                            : GmdhCriterion::Combined;
    if (!arguments.checkRows.empty()) {
        options.check_min = minutesFrom(arguments.checkRows);
    }
    for (const std::string& history : arguments.histories) {
        if (files::sameFile(arguments.output, history)) {
            throw BadInput(fmt::format("{}: is a history to train on; expected another name for the model (-o).",
                                       files::utf8Of(arguments.output)));
        }
    }
    std::vector<std::string> notes;
    const std::vector<ThermalHistory> days =
        readThermalHistories(arguments.histories, *arguments.read, &notes, arguments.rest_min);
    ThermalModel model;
    std::vector<Candidate> compared;
    if (arguments.kind == "auto") {
        auto trained = trainAuto(days, options);
        if (!trained) {
            throw BadInput(trained.error().english());
        }
        compared = std::move(trained->compared);
        model = std::move(trained->best);
    } else if (arguments.kind == "regression") {
        model = checked(trainRegression(days, options));
    } else if (arguments.kind == "hierarchical") {
        model = checked(trainHierarchical(days, options));
    } else {
        model = checked(trainNetwork(arguments.kind == "gmdh" ? ModelKind::Gmdh : ModelKind::GmdhPaper, days, options));
    }
    files::writeFile(arguments.output, formats::thermalModelToJson(model));
    tell(notes);
    for (const Candidate& candidate : compared) {
        printJudgement(modelKindKey(candidate.kind), candidate.sensors, candidate.judgement);
    }
    if (!arguments.report) {
        return;
    }
    Json report;
    report["model"] = modelKindKey(model.kind);
    report["trained_on"] = model.trainedOn;
    report["rows"] = model.trainingRows;
    Json sensors = Json::array();
    for (const ModelSensor& sensor : model.sensors) {
        sensors.push_back(sensor.name);
    }
    report["sensors"] = std::move(sensors);
    report["held_out"] = model.judgement.heldOut;
    report["rms_um"] = axes(model.judgement.rms_um, model.axes);
    report["worst_um"] = axes(model.judgement.worst_um, model.axes);
    if (!compared.empty()) {
        Json table = Json::array();
        for (const Candidate& candidate : compared) {
            table.push_back({{"model", modelKindKey(candidate.kind)},
                             {"sensors", candidate.sensors},
                             {"held_out", candidate.judgement.heldOut},
                             {"rms_um", axes(candidate.judgement.rms_um, model.axes)},
                             {"worst_um", axes(candidate.judgement.worst_um, model.axes)}});
        }
        report["compared"] = std::move(table);
    }
    report["formula"] = formulaLines(model);
    printJson(report);
}

/// A model sensor without a column is taken as open, up to the number the model can lose.
void requireSensors(const ThermalModel& model, const ThermalHistory& history, const std::string& path) {
    std::vector<std::string> missing;
    for (const ModelSensor& sensor : model.sensors) {
        if (!history.sensorIndex(sensor.name)) {
            missing.push_back(sensor.name);
        }
    }
    if (missing.size() > static_cast<std::size_t>(ThermalEstimator::kMaxLost)) {
        throw BadInput(fmt::format("{}, line 1: columns {} of the model are missing; expected all but two at most.",
                                   path, fmt::join(missing, ",")));
    }
    if (!missing.empty()) {
        fmt::print(stderr, "kerf: {}: no column {}; taken as open thermocouples.\n", path, fmt::join(missing, ","));
    }
}

void tellSensors(const ThermalModel& model, const Replay& replay) {
    constexpr std::array<const char*, 8> kStates{"healthy", "suspect", "open",   "short",
                                                 "stuck",   "noisy",   "offset", "disagrees with its neighbours"};
    for (std::size_t i = 0; i < replay.sensors.size(); ++i) {
        if (replay.sensors[i] != SensorState::Healthy) {
            fmt::print(stderr, "kerf: thermocouple {}: {}; left out.\n", model.sensors[i].name,
                       kStates[static_cast<std::size_t>(replay.sensors[i])]);
        }
    }
    const auto unusable = std::ranges::find_if(replay.minutes, [](const auto& m) { return !m.prediction.usable; });
    if (unusable != replay.minutes.end()) {
        fmt::print(stderr, "kerf: more than two sensors lost from minute {}: the last prediction is held.\n",
                   unusable->time_min);
    }
}

/// Measurements need a model that can learn from them, and their columns.
void requireMeasurements(const ThermalModel& model, const ThermalHistory& history, const std::string& path) {
    if (!model.days) {
        throw BadInput(
            fmt::format("--measure-every-min: a {} model learns nothing from a measurement; expected a "
                        "hierarchical one (kerf thermal train).",
                        modelKindKey(model.kind)));
    }
    bool any = false;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        any = any || (model.axes[axis] && history.axes[axis]);
    }
    if (history.drift_um.size() == 0 || !any) {
        throw BadInput(
            fmt::format("{}, line 1: columns yx_meas, yy_meas, yz_meas of the model's axes are missing; "
                        "needed as measurements.",
                        path));
    }
}

void tellChange(const Replay& replay) {
    const auto first =
        std::ranges::find_if(replay.minutes, [](const auto& m) { return m.prediction.changed >= kDayDiffers; });
    if (first != replay.minutes.end()) {
        fmt::print(stderr, "kerf: today differs from the days trained on (from minute {}): measure.\n",
                   first->time_min);
    }
}

struct ReplayedDay {
    HistoryFile day{};
    Replay replay{};
    std::array<bool, kAxes> axes{};
};

ReplayedDay replayedDay(const std::string& modelPath, const std::string& historyPath, const files::ReadOptions& read,
                        double rest_min, double measureEvery_min) {
    const ThermalModel model = readThermalModel(modelPath);
    HistoryOptions options{HistoryUse::Prediction, {}, true, read, rest_min};
    for (const ModelSensor& sensor : model.sensors) {
        options.sensors.push_back(sensor.name);
    }
    ReplayedDay out{readHistoryFile(historyPath, options), {}, model.axes};
    requireSensors(model, out.day.history, files::utf8Of(historyPath));
    if (measureEvery_min > 0.0) {
        requireMeasurements(model, out.day.history, files::utf8Of(historyPath));
    }
    out.replay = replay(model, out.day.history, measureEvery_min);
    tellSensors(model, out.replay);
    tellChange(out.replay);
    return out;
}

struct PredictArguments {
    std::string model{};
    std::string history{};
    std::shared_ptr<files::ReadOptions> read{};
    double rest_min{0.0};
    double measureEvery_min{0.0};  ///< 0: nothing is measured
    std::string sensors{};         ///< not empty: instead of a history
    double seconds{60.0};
};

void predict(const PredictArguments& arguments) {
    const ReplayedDay day = replayedDay(arguments.model, arguments.history, *arguments.read, arguments.rest_min,
                                        arguments.measureEvery_min);
    CsvOutput out("t_min,x_um,y_um,z_um,x_half_um,y_half_um,z_half_um");
    for (const ReplayedMinute& minute : day.replay.minutes) {
        const ThermalPrediction& p = minute.prediction;
        out.row(minute.time_min, cells(p.drift_um, day.axes), cells(p.half_um, day.axes));
    }
    out.flush();
    tell(day.day.notes);
}

struct CompensateArguments {
    std::string model{};
    std::string history{};
    CompensationOptions options{};
    double rest_min{0.0};
    double measureEvery_min{0.0};
    bool summary{false};
    std::shared_ptr<files::ReadOptions> read{};
};

void compensateHistory(const CompensateArguments& arguments) {
    const ReplayedDay day = replayedDay(arguments.model, arguments.history, *arguments.read, arguments.rest_min,
                                        arguments.measureEvery_min);
    const ThermalHistory& history = day.day.history;
    if (history.trueDrift_um.size() == 0 && history.drift_um.size() == 0) {
        throw BadInput(
            fmt::format("{}, line 1: columns yx_true or yx_meas (and y, z) are missing; needed for the residual.",
                        arguments.history));
    }
    if (arguments.options.limits.maxShift_um < arguments.options.limits.quantum_um ||
        arguments.options.limits.maxStep_um < arguments.options.limits.quantum_um) {
        throw BadInput("--max-shift-um and --max-step-um must be at least --quantum-um.");
    }
    requireMicrometres(history, arguments.history);
    std::array<bool, kAxes> known{};
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        known[axis] = day.axes[axis] && history.axes[axis];
    }
    const std::vector<CompensatedMinute> minutes = compensate(day.replay, history, arguments.options);
    tell(day.day.notes);
    if (arguments.summary) {
        Eigen::MatrixXd residuals(static_cast<Eigen::Index>(minutes.size()), 3);
        for (std::size_t k = 0; k < minutes.size(); ++k) {
            residuals.row(static_cast<Eigen::Index>(k)) = Eigen::RowVector3d::Map(minutes[k].residual_um.data());
        }
        const ErrorSummary summary = summaryOf(residuals);
        printJson({{"period_min", arguments.options.period_min},
                   {"minutes", minutes.size()},
                   {"limited_minutes", std::ranges::count_if(minutes, [](const auto& m) { return m.limited; })},
                   {"max_um", axes(summary.worst_um, known)},
                   {"p95_um", axes(summary.p95_um, known)},
                   {"rms_um", axes(summary.rms_um, known)}});
        return;
    }
    CsvOutput out("t_min,shift_x_um,shift_y_um,shift_z_um,residual_x_um,residual_y_um,residual_z_um");
    for (const CompensatedMinute& m : minutes) {
        out.row(m.time_min, cells(m.shift_um, day.axes), cells(m.residual_um, known));
    }
    out.flush();
}

void addTrain(CLI::App& thermal) {
    auto* command = thermal.add_subcommand("train", "Train a model from recorded days and write it as JSON.");
    auto arguments = std::make_shared<TrainArguments>();
    command->add_option("--history", arguments->histories, "CSV of one day; repeat for more days")->required();
    command->add_option("--model", arguments->kind, "auto: hierarchical, compared with all on days left out")
        ->check(CLI::IsMember({"gmdh-paper", "gmdh", "regression", "hierarchical", "auto"}))
        ->capture_default_str();
    command->add_option("--criterion", arguments->criterion, "What a network is grown by")
        ->check(CLI::IsMember({"combined", "regularity", "unbiased"}))
        ->capture_default_str();
    command->add_option("--check-rows", arguments->checkRows,
                        "Check minutes of every day for networks, as 240-359 (default: last third)");
    command->add_option("--max-sensors", arguments->maxSensors, "Sensors a regression may use")
        ->check(CLI::Range(2, static_cast<int>(kMaxRegressionSensors)))
        ->capture_default_str();
    command->add_option("-o,--output", arguments->output, "Model file to write")->required();
    command->add_flag("--report", arguments->report, "Print sensors, errors and formula as JSON");
    arguments->read = addReadOptions(*command);
    addRest(*command, arguments->rest_min);
    command->callback([arguments] { train(*arguments); });
}

void addPredict(CLI::App& thermal) {
    auto* command =
        thermal.add_subcommand("predict", "Drift minute by minute with the half width of its 95 % interval, as CSV.");
    auto arguments = std::make_shared<PredictArguments>();
    command->add_option("--model", arguments->model, "Model file")->required();
    auto* source = command->add_option_group("source", "Where the temperatures come from");
    auto* history = source->add_option("--history", arguments->history, "CSV of one day");
    auto* live = source->add_option("--sensors", arguments->sensors, "Sensor file: read the machine, a row a second");
    source->require_option(1);
    command
        ->add_option("--seconds", arguments->seconds,
                     "With --sensors: how long; the first half, 5 s at most, is the baseline")
        ->check(CLI::Range(1.0, 864'000.0))
        ->needs(live)
        ->excludes(history)
        ->capture_default_str();
    command
        ->add_option("--measure-every-min", arguments->measureEvery_min,
                     "With --history: its y?_meas every so many minutes are measurements of the origin made then, "
                     "used from the next minute on")
        ->check(CLI::Range(1.0, 1440.0))
        ->excludes(live);
    arguments->read = addReadOptions(*command);
    addRest(*command, arguments->rest_min);
    command->callback([arguments] {
        if (arguments->sensors.empty()) {
            predict(*arguments);
        } else {
            predictLive(arguments->model, arguments->sensors, arguments->seconds);
        }
    });
}

void addCompensate(CLI::App& thermal) {
    auto* command =
        thermal.add_subcommand("compensate", "Shift the work origin over a recorded day: shifts and residuals as CSV.");
    auto arguments = std::make_shared<CompensateArguments>();
    command->add_option("--model", arguments->model, "Model file")->required();
    command->add_option("--history", arguments->history, "CSV of one day with measured or true drift")->required();
    command->add_option("--period-min", arguments->options.period_min, "Time between shifts, min")
        ->check(CLI::Range(0.1, 1440.0))
        ->capture_default_str();
    command->add_option("--quantum-um", arguments->options.limits.quantum_um, "Smallest shift, um")
        ->check(CLI::Range(0.01, 100.0))
        ->capture_default_str();
    command->add_option("--max-shift-um", arguments->options.limits.maxShift_um, "Largest total shift, um")
        ->check(CLI::Range(1.0, 4095.0))
        ->capture_default_str();
    command->add_option("--max-step-um", arguments->options.limits.maxStep_um, "Largest change in one update, um")
        ->check(CLI::Range(1.0, 4095.0))
        ->capture_default_str();
    command
        ->add_option("--measure-every-min", arguments->measureEvery_min,
                     "The y?_meas every so many minutes are measurements of the origin made then")
        ->check(CLI::Range(1.0, 1440.0));
    command->add_flag("--summary", arguments->summary, "Only the residuals' max, 95 % and rms, as JSON");
    arguments->read = addReadOptions(*command);
    addRest(*command, arguments->rest_min);
    command->callback([arguments] { compensateHistory(*arguments); });
}

}  // namespace

void addThermalCommands(CLI::App& kerf) {
    auto* thermal =
        kerf.add_subcommand("thermal", "Thermal drift of the machine origin: train, predict, compensate, simulate.");
    thermal->require_subcommand(1);
    addTrain(*thermal);
    addPredict(*thermal);
    addCompensate(*thermal);
    addThermalVolumetric(*thermal);
    addThermalSimulate(*thermal);
    addThermalTable(*thermal);
    addThermalRobust(*thermal);
}

}  // namespace kerf::headless
