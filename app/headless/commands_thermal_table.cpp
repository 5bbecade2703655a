// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "app/files/table.h"
#include "app/files/thermal_files.h"
#include "app/headless/thermal_commands.h"
#include "engine/process/thermal/replay.h"
#include "engine/process/thermal/training.h"

namespace kerf::headless {
namespace {

using namespace thermal;

struct TableArguments {
    std::string folder{};
    std::vector<std::string> training{"H0_train.csv", "H1_train.csv", "H2_train.csv"};
};

/// Files of the folder that are days to judge by, in the order of their names.
std::vector<std::string> judgedDays(const TableArguments& arguments) {
    if (!std::filesystem::is_directory(arguments.folder)) {
        throw BadInput(
            fmt::format("{}: not a folder; expected one with training days and days to judge by.", arguments.folder));
    }
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(arguments.folder)) {
        const std::string name = entry.path().filename().string();
        if (name.ends_with(".csv") && std::ranges::find(arguments.training, name) == arguments.training.end()) {
            names.push_back(name);
        }
    }
    std::ranges::sort(names);
    if (names.empty()) {
        throw BadInput(fmt::format("{}: no CSV but the training days; expected days to judge by.", arguments.folder));
    }
    return names;
}

class Report {
 public:
    explicit Report(const TableArguments& arguments) {
        for (const std::string& name : judgedDays(arguments)) {
            m_days.push_back(readThermalHistory(arguments.folder + "/" + name, HistoryUse::Prediction));
            if (m_days.back().trueDrift_um.size() == 0) {
                throw BadInput(
                    fmt::format("{}/{}, line 1: columns y?_true are missing; the table compares with the true drift.",
                                arguments.folder, name));
            }
        }
        fmt::print(
            "| model | sensors | X | Y | Z | inside the interval | warm start, worst "
            "|\n|---|---|---|---|---|---|---|\n");
    }
    /// `model` null: uncompensated.
    void row(const std::string& name, const ThermalModel* model, bool perfect = false) const {
        std::vector<Eigen::MatrixXd> cold;
        PerAxis warmWorst_um{};
        double inside = 0.0;
        double values = 0.0;
        for (const ThermalHistory& day : m_days) {
            const Replay replayed = model != nullptr ? replay(*model, day) : perfectReplay(day);
            Eigen::MatrixXd errors = day.trueDrift_um.bottomRows(day.workRows());
            for (std::size_t k = 0; k < replayed.minutes.size(); ++k) {
                for (std::size_t axis = 0; axis < kAxes; ++axis) {
                    double& error = errors(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(axis));
                    if (model != nullptr) {
                        error -= replayed.minutes[k].prediction.drift_um[axis];
                        inside += std::abs(error) <= replayed.minutes[k].prediction.half_um[axis] ? 1.0 : 0.0;
                        values += 1.0;
                    } else if (perfect) {
                        error = 0.0;
                    }
                }
            }
            if (isWarmStart(day)) {
                for (std::size_t axis = 0; axis < kAxes; ++axis) {
                    warmWorst_um[axis] =
                        std::max(warmWorst_um[axis], errors.col(static_cast<Eigen::Index>(axis)).cwiseAbs().maxCoeff());
                }
            } else {
                cold.push_back(std::move(errors));
            }
        }
        Eigen::Index rows = 0;
        for (const auto& part : cold) {
            rows += part.rows();
        }
        Eigen::MatrixXd all(rows, 3);
        rows = 0;
        for (const auto& part : cold) {
            all.middleRows(rows, part.rows()) = part;
            rows += part.rows();
        }
        const ErrorSummary s = summaryOf(all);
        fmt::print("| {} | {} |", name, model != nullptr ? std::to_string(model->sensors.size()) : "-");
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
            fmt::print(" {:.2f}/{:.1f} |", s.rms_um[axis], s.worst_um[axis]);
        }
        fmt::print(" {} | {:.1f} {:.1f} {:.1f} |\n",
                   model != nullptr ? fmt::format("{:.0f} %", 100.0 * inside / values) : "-", warmWorst_um[0],
                   warmWorst_um[1], warmWorst_um[2]);
    }
    /// Residual after compensation on the first day.
    void compensation(const ThermalModel& model) const {
        const ThermalHistory& day = m_days.front();
        fmt::print("\n| residual on {} | X max/95 % | Y | Z |\n|---|---|---|---|\n", day.label);
        for (const double period_min : {1.0, 5.0}) {
            for (const bool perfect : {false, true}) {
                CompensationOptions options;
                options.period_min = period_min;
                const auto minutes = compensate(perfect ? perfectReplay(day) : replay(model, day), day, options);
                Eigen::MatrixXd residuals(static_cast<Eigen::Index>(minutes.size()), 3);
                for (std::size_t k = 0; k < minutes.size(); ++k) {
                    residuals.row(static_cast<Eigen::Index>(k)) =
                        Eigen::RowVector3d::Map(minutes[k].residual_um.data());
                }
                const ErrorSummary s = summaryOf(residuals);
                fmt::print("| {} min, {} |", period_min, perfect ? "perfect predictor" : "default model");
                for (std::size_t axis = 0; axis < kAxes; ++axis) {
                    fmt::print(" {:.1f}/{:.1f} |", s.worst_um[axis], s.p95_um[axis]);
                }
                fmt::print("\n");
            }
        }
    }

 private:
    /// The baseline falls or rises: the machine was not at rest when the origin was measured.
    static bool isWarmStart(const ThermalHistory& day) {
        const Eigen::Index last = day.baselineRows() - 1;
        return last > 0 && (day.temp_degC.row(last) - day.temp_degC.row(0)).cwiseAbs().mean() > 0.3;
    }
    std::vector<ThermalHistory> m_days{};
};

ThermalModel need(Result<ThermalModel> model) {
    if (!model) {
        throw BadInput(model.error().english());
    }
    return std::move(*model);
}

void printTable(const TableArguments& arguments) {
    std::vector<std::string> paths;
    for (const std::string& name : arguments.training) {
        paths.push_back(arguments.folder + "/" + name);
    }
    const std::vector<ThermalHistory> days = readThermalHistories(paths);
    const std::vector<ThermalHistory> firstDay{days.front()};
    const TrainingOptions options;
    const Report report(arguments);
    report.row("uncompensated", nullptr);
    const ThermalModel printed = need(trainNetwork(ModelKind::GmdhPaper, firstDay, options));
    report.row("network as printed, one day", &printed);
    const ThermalModel guarded = need(trainNetwork(ModelKind::Gmdh, firstDay, options));
    report.row("guarded network, one day", &guarded);
    const ThermalModel guardedAll = need(trainNetwork(ModelKind::Gmdh, days, options));
    report.row(fmt::format("guarded network, {} days", days.size()), &guardedAll);
    const ThermalModel regression = need(trainRegression(days, options));
    report.row(fmt::format("regression, {} days", days.size()), &regression);
    const ThermalModel best = need(trainHierarchical(days, options));
    report.row(fmt::format("default (hierarchical), {} days", days.size()), &best);
    report.row("perfect predictor", nullptr, true);
    report.compensation(best);
}

}  // namespace

void addThermalTable(CLI::App& thermal) {
    auto* command = thermal.add_subcommand(
        "table",
        "The comparison of docs/thermal.md: rms/worst error in um on every day of a folder that is not trained on.");
    auto arguments = std::make_shared<TableArguments>();
    command->add_option("--data", arguments->folder, "Folder with the days as CSV")->required();
    command
        ->add_option("--train", arguments->training,
                     "Training days in that folder; the first alone trains the networks")
        ->capture_default_str();
    command->callback([arguments] { printTable(*arguments); });
}

}  // namespace kerf::headless
