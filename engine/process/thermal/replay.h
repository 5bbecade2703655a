// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "engine/process/thermal/compensation.h"
#include "engine/process/thermal/history.h"
#include "engine/process/thermal/thermal_estimator.h"
#include "engine/process/thermal/thermal_model.h"

/// A recorded day run through the estimator and the compensation of the cycle, as fast as it can.
namespace kerf::thermal {

struct ReplayedMinute {
    double time_min{0.0};
    ThermalPrediction prediction{};  ///< while not usable: the last usable drift, held
};

/// What happened to the sensors during the day, in the model's order; the last state of each.
struct Replay {
    std::vector<ReplayedMinute> minutes{};
    std::vector<SensorState> sensors{};
};

/// A sensor of the model that the history has no column for counts as open.
/// @param measureEvery_min > 0: the measured drift of every such minute (the first one at that, not at the reference
/// itself) is taken as a measurement of the origin made then, and used from the next row on
[[nodiscard]] Replay replay(const ThermalModel& model, const ThermalHistory& history, double measureEvery_min = 0.0);

/// Predictions of a perfect predictor, for comparison: the true (or measured) drift itself.
[[nodiscard]] Replay perfectReplay(const ThermalHistory& history);

struct CompensationOptions {
    double period_min{1.0};
    ShiftLimits limits{};
};
struct CompensatedMinute {
    double time_min{0.0};
    PerAxis shift_um{};     ///< total shift in force
    PerAxis residual_um{};  ///< drift + shift; the true drift if known, else the measured one
    bool limited{false};
};
/// Shifts every period from the first full one on; within a minute the shift is in force before the residual is taken.
/// Outside the training range the shift fades to hold (see holdShare). @pre history has a true or a measured drift
[[nodiscard]] std::vector<CompensatedMinute> compensate(const Replay& replay, const ThermalHistory& history,
                                                        const CompensationOptions& options);

struct ErrorSummary {
    PerAxis rms_um{};
    PerAxis worst_um{};
    PerAxis p95_um{};  ///< 95 % of |values| are at or below
};
/// @pre at least one row; rows × 3
[[nodiscard]] ErrorSummary summaryOf(const Eigen::MatrixXd& errors_um);

}  // namespace kerf::thermal
