// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "engine/process/thermal/day_layer.h"
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

/// A day as a law that was trained without it has it; rows × axes, the rows from time 0 on.
struct LeftOutDay {
    std::size_t day{0};
    Eigen::MatrixXd predicted_um{};
    Eigen::MatrixXd error_um{};  ///< measured − predicted
};
/// A regression (see trainRegression) with the days left out of it, by the set of coefficients that holds for a start
/// at rest; empty with a single day.
struct JudgedRegression {
    ThermalModel model{};
    std::vector<Eigen::Index> sensors{};
    std::vector<LeftOutDay> leftOut{};
};
[[nodiscard]] Result<JudgedRegression> trainJudgedRegression(const std::vector<ThermalHistory>& days,
                                                             const TrainingOptions& options,
                                                             const TrainingProgress& progress);

/// trainHierarchical() when the regression has been trained already.
[[nodiscard]] Result<ThermalModel> hierarchicalOn(const JudgedRegression& regression,
                                                  const std::vector<ThermalHistory>& days,
                                                  const TrainingOptions& options, const TrainingProgress& progress);

/// Between-day law of one axis by maximum likelihood from days left out. Each entry: what a law trained without the day
/// makes of it, thinned. Days unlike the others count less (multivariate t).
struct LawDay {
    Eigen::VectorXd time_min{};
    Eigen::MatrixXd x{};        ///< rows × terms, scaled as in DayInstant::term
    Eigen::MatrixXd z{};        ///< as DayInstant::lever
    Eigen::VectorXd mean_um{};  ///< predicted without the day
    Eigen::VectorXd error_um{};
};
[[nodiscard]] DayLaw fitDayLaw(const std::vector<LawDay>& days, double noise_um);
/// Covariance of the errors of a day under the law. rows × rows
[[nodiscard]] Eigen::MatrixXd covarianceOf(const LawDay& day, const DayLaw& law);

}  // namespace kerf::thermal::detail
