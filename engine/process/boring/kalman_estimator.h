// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "engine/process/boring/estimate.h"

namespace kerf::boring {

/// Our estimator: two Kalman filters in θ, weighted by how well each explains the bores, and one change test per part.
///
///   measured    d = exp(xᵀθ) + σ·z                    the noise is in mm, so the update solves in mm (Gauss-Newton, ≤
///   12
///                                                     steps, from the ln d solution), not in ln d with a scaled R
///   quiet       θ' = θ + w, w ~ (0, quiet)            a tool that does not change: errors shrink as 1/√n
///   moving      θ' = θ + w, w ~ (0, moving)           wear or warming: follows 1.5 %/part
///   weights     interacting multiple models (Blom & Bar-Shalom 1988), switching once per part
///   test        T² = least cost of the part's bores and of θ against the weighted prediction, = νᵀS⁻¹ν when linear,
///               against the χ² quantile at 2·10⁻⁴ with as many degrees of freedom as bores measured so far
///   change      T² above: prediction widened by `change`, the same part used again, weights begin anew
///
/// Spreads are given in coordinates centred at the part's mean ln S and ln L, where level, α and β hardly mix.
/// Source of model and law: Lee (1983), see model.h. Cost: some microseconds, no allocation.
/// Pure functions of their input: same state and measurements, same digits.
struct KalmanParams {
    /// Standard deviations of level = ln C + α·mean(ln S) + β·mean(ln L), of α and of β.
    struct Spread {
        double level{0.0};
        double alpha{0.0};
        double beta{0.0};
    };
    double sigma_mm{kTableSigma_mm};                ///< > 0, standard deviation of a measured deflection
    LawConstants prior{-2.4407, 0.55, kTableBeta};  ///< before the first measurement
    Spread priorSpread{1.0, 0.15, 0.25};
    Spread quiet{0.003, 0.002, 0.002};  ///< process noise per part
    Spread moving{0.03, 0.01, 0.01};    ///< process noise per part
    Spread change{0.5, 0.15, 0.15};     ///< added once at a process change
    Spread ceiling{2.0, 0.4, 0.6};      ///< no spread grows beyond this without excitation
    double startMoving{0.02};           ///< probability per part that quiet turns into moving, (0, 1)
    double stopMoving{0.1};             ///< and the other way round, (0, 1)
};

enum KalmanModel : std::size_t { kQuiet, kMoving, kKalmanModels };

struct KalmanMode {
    LawConstants law{};
    Covariance covariance{};
    friend bool operator==(const KalmanMode&, const KalmanMode&) = default;
};

struct KalmanState {
    bool ready{false};
    std::uint32_t part{0};   ///< newest part measured
    double lnFeed{0.0};      ///< its mean ln S …
    double lnOverhang{0.0};  ///< … and mean ln L: the working point
    std::array<KalmanMode, kKalmanModels> modes{};
    double movingProbability{0.0};
    friend bool operator==(const KalmanState&, const KalmanState&) = default;
};

/// What a caller may know about a part beyond its bores.
enum class ChangeKnowledge : std::uint8_t {
    Unknown,  ///< the test decides
    Changed,  ///< told: the process changed with this part (tool replaced)
    Same,     ///< told: it did not
};

/// Quiet and moving as one estimate: mean and covariance of the weighted mixture.
[[nodiscard]] Estimate combined(const KalmanState& state) noexcept;

/// χ² quantile the part test uses for 1…kMaxBoreDepths bores.
[[nodiscard]] double changeThreshold(std::size_t bores) noexcept;

/// What is believed of θ just before `visit` is seen: the estimate with the process noise of the parts between.
[[nodiscard]] Estimate predictedFor(const KalmanState& before, const KalmanParams& params,
                                    const PartVisit& visit) noexcept;

/// Takes one part with all its bores measured so far. A bore that comes later means: step again from the state before.
/// A visit without bores leaves the state as it is. `outcome` and `lnEvidence` (how probable the bores were, up to a
/// constant common to all parameters; a change counts with its probability) may be null.
[[nodiscard]] KalmanState update(const KalmanState& before, const KalmanParams& params, const PartVisit& visit,
                                 RowOutcome* outcome, ChangeKnowledge knowledge = ChangeKnowledge::Unknown,
                                 double* lnEvidence = nullptr) noexcept;

}  // namespace kerf::boring
