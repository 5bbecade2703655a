// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/thermal/replay.h"

#include <algorithm>
#include <cmath>

namespace kerf::thermal {
namespace {

const Eigen::MatrixXd& referenceDrift(const ThermalHistory& history) {
    return history.trueDrift_um.size() > 0 ? history.trueDrift_um : history.drift_um;
}

void measure(ThermalEstimator& estimator, const ThermalModel& model, const ThermalHistory& history, Eigen::Index row) {
    PerAxis drift_um{};
    std::array<bool, kAxes> known{};
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const double value_um = history.drift_um(row, static_cast<Eigen::Index>(axis));
        known[axis] = model.axes[axis] && history.axes[axis] && std::isfinite(value_um);
        drift_um[axis] = known[axis] ? value_um : 0.0;
    }
    estimator.measured(drift_um, known);
}

}  // namespace

Replay replay(const ThermalModel& model, const ThermalHistory& history, double measureEvery_min) {
    ThermalEstimator estimator(model);
    std::vector<std::optional<Eigen::Index>> columns;
    for (const ModelSensor& sensor : model.sensors) {
        columns.push_back(history.sensorIndex(sensor.name));
    }
    std::vector<Reading> readings(columns.size());
    Replay out;
    PerAxis held_um{};
    PerAxis heldHalf_um{};
    double nextMeasurement_min = measureEvery_min;
    for (Eigen::Index row = 0; row < history.rows(); ++row) {
        const auto k = static_cast<std::size_t>(row);
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const bool present = columns[i] && history.present(row, *columns[i]);
            readings[i] = present ? Reading{history.temp_degC(row, *columns[i]), 0, Quality::Good} : Reading{};
        }
        if (history.time_min[k] < 0.0) {
            estimator.baseline(history.time_min[k], readings);
            continue;
        }
        const std::optional<double> speed_rpm =
            history.speed_rpm.empty() ? std::nullopt : std::optional(history.speed_rpm[k]);
        ReplayedMinute minute{history.time_min[k], estimator.update(history.time_min[k], speed_rpm, readings)};
        if (minute.prediction.usable) {
            held_um = minute.prediction.drift_um;
            heldHalf_um = minute.prediction.half_um;
        } else {
            minute.prediction.drift_um = held_um;
            for (std::size_t axis = 0; axis < kAxes; ++axis) {  // from here it may be anywhere a day has ever been
                const Range& seen = model.drift_um[axis];
                minute.prediction.half_um[axis] =
                    heldHalf_um[axis] +
                    std::max({std::abs(held_um[axis] - seen.low), std::abs(seen.high - held_um[axis]), seen.span()});
            }
        }
        out.minutes.push_back(minute);
        if (measureEvery_min > 0.0 && minute.time_min >= nextMeasurement_min - 1e-9) {
            nextMeasurement_min = (std::floor(minute.time_min / measureEvery_min + 1e-9) + 1.0) * measureEvery_min;
            if (history.drift_um.size() > 0) {
                measure(estimator, model, history, row);
            }
        }
    }
    for (std::size_t i = 0; i < estimator.sensors(); ++i) {
        out.sensors.push_back(estimator.health().state(i));
    }
    return out;
}

Replay perfectReplay(const ThermalHistory& history) {
    Replay out;
    for (Eigen::Index row = history.baselineRows(); row < history.rows(); ++row) {
        ReplayedMinute minute{history.time_min[static_cast<std::size_t>(row)], {}};
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
            minute.prediction.drift_um[axis] = referenceDrift(history)(row, static_cast<Eigen::Index>(axis));
        }
        minute.prediction.usable = true;
        out.minutes.push_back(minute);
    }
    return out;
}

std::vector<CompensatedMinute> compensate(const Replay& replay, const ThermalHistory& history,
                                          const CompensationOptions& options) {
    const Eigen::MatrixXd& drift = referenceDrift(history);
    const Eigen::Index first = history.baselineRows();
    std::vector<CompensatedMinute> out;
    PerAxis shift_um{};
    PerAxis trusted_um{};
    double next_min = options.period_min;
    for (std::size_t k = 0; k < replay.minutes.size(); ++k) {
        const ReplayedMinute& minute = replay.minutes[k];
        CompensatedMinute row;
        row.time_min = minute.time_min;
        const bool due = minute.time_min >= next_min - 1e-9;
        if (due) {
            next_min = (std::floor(minute.time_min / options.period_min + 1e-9) + 1.0) * options.period_min;
        }
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
            if (due && minute.prediction.usable) {
                trusted_um[axis] +=
                    holdShare(minute.prediction.outside) * (minute.prediction.drift_um[axis] - trusted_um[axis]);
                const ShiftCommand command = nextShift(trusted_um[axis], shift_um[axis], options.limits);
                shift_um[axis] = command.total_um;
                row.limited = row.limited || command.sizeLimited || command.rateLimited;
            }
            row.shift_um[axis] = shift_um[axis];
            row.residual_um[axis] =
                drift(first + static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(axis)) + shift_um[axis];
        }
        out.push_back(row);
    }
    return out;
}

ErrorSummary summaryOf(const Eigen::MatrixXd& errors_um) {
    ErrorSummary out;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const auto column = errors_um.col(static_cast<Eigen::Index>(axis));
        std::vector<double> sorted;
        for (const double value : column) {
            sorted.push_back(std::abs(value));
        }
        std::ranges::sort(sorted);
        out.rms_um[axis] = std::sqrt(column.squaredNorm() / static_cast<double>(column.size()));
        out.worst_um[axis] = sorted.back();
        const auto rank = static_cast<std::size_t>(std::ceil(0.95 * static_cast<double>(sorted.size())));
        out.p95_um[axis] = sorted[std::max<std::size_t>(rank, 1) - 1];
    }
    return out;
}

}  // namespace kerf::thermal
