// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/core/sentence.h"
#include "engine/process/boring/boring_types.h"
#include "engine/process/boring/estimator.h"

/// From an estimate to the feed schedule of the next part, to the bore it predicts, and to the gate for entries.
namespace kerf::boring {

/// What the feed schedule may be. Feed mm/rev, overhang mm.
struct FeedLawParams {
    double targetDeflection_mm{kTableTargetDeflection_mm};  ///< d0 > 0
    double firstFeed_mmPerRev{0.5};                         ///< S0: constant, until the law is known
    double minFeed_mmPerRev{0.005};                         ///< > 0
    double maxFeed_mmPerRev{2.0};                           ///< > min
    double minAlpha{0.25};                                  ///< > 0: α used by the law is clipped here …
    double maxAlpha{1.2};                                   ///< … to here
    /// What a clipped α leaves of the law. true: the most probable law with that α, see clippedLaw(). false: ln C and β
    /// as they were estimated, as the paper has it.
    bool clipKeepsMeasured{true};
    double overhangFrom_mm{kTableOverhangFrom_mm};
    double overhangTo_mm{kTableOverhangTo_mm};
    double spindleSpeed_rpm{400.0};
    /// Deflections of a good bore, both > 0 and d0 between them: where the feed is chosen for a law that is known too
    /// badly to keep them, see aimedDeflection_mm(). 0: the feed is always chosen for d0.
    double allowedFrom_mm{0.0}, allowedTo_mm{0.0};
};
/// Limits that belong to an estimator. Both clamp the feed as the paper does, to [.005, 2]; a part type's recipe may be
/// narrower. The paper leaves α alone, so its clip is a mere guard against a division by zero that moves nothing else.
[[nodiscard]] FeedLawParams feedLawParams(EstimatorKind kind, double targetDeflection_mm, double firstFeed_mmPerRev);

/// What the feed is chosen for. d0, as long as three standard deviations s of ln d (the wider one of the bore's two
/// ends) fit between it and the nearer limit, in ln; else as far from that limit as they need, but no further than the
/// middle of the limits in ln, from where both are missed equally often. A deflection errs by factors and is allowed
/// millimetres, so that the middle lies below d0: towards less feed.
///   mm; s dimensionless; between allowedFrom_mm and allowedTo_mm
[[nodiscard]] double aimedDeflection_mm(const FeedLawParams& params, double spreadLn) noexcept;

/// The estimate with α clipped to [minAlpha, maxAlpha]: the most probable law among those with that α, which is the
/// conditional mean of N(θ̂, P). P says at which feeds and overhangs the law is known, so that what the bores have shown
/// is kept at both ends, however far the feed falls in between. An α clipped from below only makes the steps from part
/// to part smaller: each end closes in on d0, slower than with the α̂ that was estimated.
///   ln C += (α − α̂)·P01/P11, β += (α − α̂)·P12/P11
[[nodiscard]] LawConstants clippedLaw(const Estimate& estimate, const FeedLawParams& params) noexcept;

struct FeedAdvice {
    BoringSchedule schedule{};
    bool limited{false};  ///< α clipped, or the optimum lies outside the feed range somewhere on the bore
    Sentence reason{};    ///< why it is limited; empty when it is not
};

/// Eq. 3 with the estimate, α clipped.
[[nodiscard]] FeedAdvice adviseFeed(const EstimatorState& state, const FeedLawParams& params) noexcept;
[[nodiscard]] FeedAdvice adviseFeed(const Estimate& estimate, const FeedLawParams& params) noexcept;

/// A first part that teaches: S0 over most of the bore, a fifth of it near the far end, measured at three depths. ln S
/// is then no straight line in ln L, so that α, β and ln C can be told apart from this one part. The feed only falls
/// from S0, which the setter has found good enough for feed and finish, and stays within the limits.
///
///   schedule  a law so steep (α 1, β kTeachSteepness) that it runs from S0 down to the lower feed within 4 % of L,
///             clamped to these two: what carries any schedule carries this one
///   α̂'s spread from the part alone ≈ (σ/d)·√(1 + .08 + .52)/ln 5 for depths at 40, 175 and 310 mm
inline constexpr std::size_t kTeachDepths = 3;
inline constexpr double kTeachRatio = 5.0;
inline constexpr double kTeachSteepness = 40.0;
[[nodiscard]] BoringSchedule teachSchedule(const FeedLawParams& params) noexcept;
[[nodiscard]] inline bool teaches(const BoringSchedule& schedule) noexcept {
    return schedule.constantFeed_mmPerRev == 0.0 && schedule.beta == kTeachSteepness;
}
/// The third depth: the middle of the bore, well above where the feed falls.
[[nodiscard]] double teachMiddle_mm(const FeedLawParams& params) noexcept;

/// A measurement of a part that was cut with `schedule` (or really cut with `feed_mmPerRev`, where the trace says so).
[[nodiscard]] Measurement measurementAt(const BoringSchedule& schedule, double overhang_mm,
                                        double deflection_mm) noexcept;

/// The deflection that will be measured, with the 95 % interval of the measurement (estimate and gauge).
struct DeflectionPrediction {
    double deflection_mm{0.0};
    double half95_mm{0.0};
};
/// Empty before the first part. @pre feed and overhang positive
[[nodiscard]] std::optional<DeflectionPrediction> predict(const EstimatorState& state, const EstimatorParams& params,
                                                          double feed_mmPerRev, double overhang_mm) noexcept;

/// |ln(d/d_predicted)| above this asks "measure again or confirm".
inline constexpr double kGateLn = 1.2;

enum class GateVerdict : std::uint8_t { Accept, Ask, Refuse };
struct GateAnswer {
    GateVerdict verdict{GateVerdict::Accept};
    Sentence reason{};
};
/// Judges a deflection before anything is stored. Before the first part the prior of the law stands in for the
/// prediction.
[[nodiscard]] GateAnswer judgeEntry(const EstimatorState& state, const EstimatorParams& params,
                                    const Measurement& measurement) noexcept;

}  // namespace kerf::boring
