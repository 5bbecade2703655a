// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/process/thermal/history.h"
#include "engine/process/thermal/thermal_model.h"

/// Trains thermal models from recorded days. Seconds of work: on a worker, never in the cycle.
namespace kerf::thermal {

/// Called now and then with the share done, 0…1; returning false cancels the training.
using TrainingProgress = std::function<bool(double)>;

struct TrainingOptions {
    int maxSensors{10};         ///< of a regression, 2…kMaxRegressionSensors
    double smallestGain{0.01};  ///< a further sensor must lower the score by this, or the choice ends
    GmdhCriterion criterion{GmdhCriterion::Combined};
    /// Check rows of every day as minutes from…to (both included); empty: the last third.
    std::optional<std::pair<double, double>> check_min{};
    FeatureSpec features{};
};

/// Ridge regression per axis on the terms of few sensors (see features.h), the default model.
///
/// Sensors are chosen one by one: each time the one that most lowers Σ_axes log(mean square error on the left-out day),
/// averaged over the two sets of coefficients (temperatures alone; with heat terms). The ridge of each axis is chosen
/// from a grid by the same error. With one day, four blocks of it stand in for days.
///
/// The judgement and the interval come from days that took no part in anything: sensors and ridge are chosen again
/// without the day they are judged on. Measurement noise is taken off by using products of errors 1…5 min apart; the
/// interval is 1.7 × that rms: days left out leave fewer to train on, which makes the rms itself pessimistic.
[[nodiscard]] Result<ThermalModel> trainRegression(const std::vector<ThermalHistory>& days,
                                                   const TrainingOptions& options,
                                                   const TrainingProgress& progress = {});

/// The default: a mean law, and what a day may differ from it by (see day_layer.h).
///
/// The mean law is the regression above, or one of the same form fitted by generalised least squares on block means,
/// (Σ_d X_dᵀ S_d⁻¹ X_d + λ·diag)·w = Σ_d X_dᵀ S_d⁻¹ y_d, S_d the covariance of a whole day under the between-day law:
/// minutes of a day are no independent samples, and a direction in which days differ pulls less. Terms, leaks and λ are
/// those with the smallest error on days left out; of λ within one standard error of the best (a tenth of it with three
/// days, all of it from ten on) the largest is taken, down to no law at all. Of what the law says only the share is
/// corrected for that days left out bear out (DayLaw::trust, usual, doubt). The between-day law is fitted to the errors
/// on days left out and scaled until the 95 % interval holds there, wider by Student's t for few days.
/// Needs two days.
[[nodiscard]] Result<ThermalModel> trainHierarchical(const std::vector<ThermalHistory>& days,
                                                     const TrainingOptions& options,
                                                     const TrainingProgress& progress = {});

/// The paper's network (GmdhPaper: absolute temperatures now and one step before, as printed) or the guarded one (Gmdh:
/// rises and leaky means, bilinear, ridge, clamps, at most 3 layers). Training rows are cut into two contiguous halves.
[[nodiscard]] Result<ThermalModel> trainNetwork(ModelKind kind, const std::vector<ThermalHistory>& days,
                                                const TrainingOptions& options, const TrainingProgress& progress = {});

/// One line of the comparison `auto` makes.
struct Candidate {
    ModelKind kind{ModelKind::Regression};
    Judgement judgement{};
    std::size_t sensors{0};
};
struct AutoTraining {
    ThermalModel best{};
    std::vector<Candidate> compared{};
};
/// Trains the network as printed, the guarded one, the regression and the hierarchical model, for comparison, and keeps
/// the hierarchical one: no worse than the regression on days left out, and the only one that learns from a measurement
/// of the day. With a single day no day can be left out: the guarded network, the most cautious of them outside its
/// range, is kept.
[[nodiscard]] Result<AutoTraining> trainAuto(const std::vector<ThermalHistory>& days, const TrainingOptions& options,
                                             const TrainingProgress& progress = {});

/// σ² of the measured drift's noise per axis, from second differences (a robust estimate; the drift itself is smooth).
[[nodiscard]] PerAxis measurementVariance_um2(const std::vector<ThermalHistory>& days);

}  // namespace kerf::thermal
