// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "engine/process/thermal/training.h"

/// Shared by the trainers; not for others.
namespace kerf::thermal::detail {

/// The sentence when the days cannot be trained on together.
[[nodiscard]] std::optional<Sentence> whyNotTogether(const std::vector<ThermalHistory>& days);

/// Measured drift from time 0 on.
[[nodiscard]] Eigen::MatrixXd measuredDrift(const ThermalHistory& day);

/// Baseline pattern of a machine at rest: what each sensor reads against the mean of all, over the days that began at
/// rest.
struct RestPattern {
    Eigen::VectorXd pattern_K{};
    std::vector<bool> atRest{};  ///< per day
};
[[nodiscard]] RestPattern restPatternOf(const std::vector<ThermalHistory>& days);

/// Fills everything of the model that is not the regression or the networks, for the chosen sensor columns.
[[nodiscard]] ThermalModel modelFrame(ModelKind kind, const std::vector<ThermalHistory>& days,
                                      const std::vector<Eigen::Index>& sensors, const FeatureSpec& spec);

/// rms of a slowly varying error under independent measurement noise: products of values 1…5 steps apart.
/// Each entry of `errors` is one uninterrupted series (rows × axes).
[[nodiscard]] PerAxis noiseFreeRms(const std::vector<Eigen::MatrixXd>& errors);
[[nodiscard]] PerAxis worstOf(const std::vector<Eigen::MatrixXd>& errors);

inline constexpr double kSmallestRms_um = 0.05;

}  // namespace kerf::thermal::detail
