// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "engine/process/milling/axis_follow.h"
#include "engine/process/milling/blank_profile.h"
#include "engine/process/milling/feed_law.h"
#include "engine/process/milling/late_force_estimator.h"
#include "engine/process/milling/milling_types.h"

namespace kerf::milling {

using LawKind = MillingLaw;

/// What is known after one spindle revolution, or after the whole revolutions of one period (setPeriod()).
struct RevolutionInput {
    std::optional<double> force_N{};  ///< F_y averaged over it; empty: none that can be trusted
    double feed_mmPerRev{0.0};        ///< what the axis moved in it
    double position_mm{0.0};          ///< axis along the path at its end
    double revolution_s{0.1};         ///< its measured duration T, > 0
    bool overridden{false};           ///< somebody else limits the feed: a law with memory must not wind up
    bool advised{false};              ///< somebody else makes the feed: it says nothing about ours
};

/// Feed for the coming revolution, with what stands behind it.
struct FeedDecision {
    double feed_mmPerS{0.0};
    bool inAir{false};         ///< the tool does not cut: entry feed at most
    bool blind{false};         ///< no trusted force: never faster than before, never above the programmed feed
    bool limited{false};       ///< the law wanted a feed outside the range
    double blend_mmPerS{0.0};  ///< rest of the step of the last change of law
};

/// The four laws behind one call per revolution, with what is common to them: the estimate of the cutting stiffness
/// (always running), air and entry, missing force, limits, and bumpless change between laws while cutting.
///
///   constant  the programmed feed          pi       the paper's (PiLaw)
///   model     inversion of the plant with the estimated stiffness (modelFeed_mmPerRev); the more feedback the noisier
///             the force; knows how late what is measured arrives and how the axis follows; the default
///   preview   the same, told beforehand how ln b changes by a blank profile
///
/// Bumpless: at a change the new law's output is offset to the feed in force; the offset decays by `blendMemory` per
/// revolution, and goes at once when it would feed faster above the reference. All functions run in the cycle.
class FeedController {
 public:
    struct Params {
        double reference_N{40.0 * kNewtonPerKilogramForce};
        double programmedFeed_mmPerS{1.53};  ///< of the constant law, and the most a blind loop allows
        double entryFeed_mmPerS{1.0};        ///< in air and until a first revolution in the work
        bool entryGuard{true};               ///< false: the bare PI law of the paper, which enters at full feed
        FeedRange range{};
        PiLaw::Params pi{};
        StiffnessEstimator::Params stiffness{};
        ModelLawParams model{};
        double toolRadius_mm{5.0};
        double blendMemory{0.7};
    };
    explicit FeedController(const Params& params, LawKind law) noexcept;

    [[nodiscard]] FeedDecision update(const RevolutionInput& input) noexcept;
    /// Change of law while cutting. Preview without a profile behaves as model.
    void select(LawKind law) noexcept;
    void setReference(double reference_N) noexcept;
    void setProgrammedFeed(double feed_mmPerS) noexcept { m_params.programmedFeed_mmPerS = feed_mmPerS; }
    void setRange(const FeedRange& range) noexcept { m_params.range = range; }
    void setBlank(const BlankProfile& blank) noexcept {
        m_blank = blank;
        m_depthKnown = false;
    }
    /// Something else set the feed (advise, override, pause): continue from there.
    void follow(double feed_mmPerS) noexcept;
    /// The feed stood still and goes on: from the entry feed or the last one, whichever is lower.
    void resumeAfterPause() noexcept;
    /// A new cut begins, in air; k_x learnt so far stays.
    void beginCut() noexcept;

    /// Averages now span `revolutions` spindle revolutions (≥ 1): per period the tool feeds that much more, and ln(C b)
    /// changes by −m ln(new/old).
    void setPeriod(int revolutions) noexcept;
    [[nodiscard]] int period() const noexcept { return m_period; }
    /// A new tool: k_x is learnt anew.
    void newTool() noexcept;
    /// Between cuts: k_x as learnt before (StiffnessEstimator::kxLogWeights).
    bool restoreKx(const std::array<double, StiffnessEstimator::kFilters>& weights) noexcept {
        return m_estimator.setKxLogWeights(weights);
    }
    [[nodiscard]] const std::array<double, StiffnessEstimator::kFilters>& kxLogWeights() const noexcept {
        return m_estimator.kxLogWeights();
    }

    [[nodiscard]] LawKind law() const noexcept { return m_law; }
    [[nodiscard]] const StiffnessEstimate& stiffness() const noexcept { return m_estimator.estimate(); }
    [[nodiscard]] const AxisFollow& axis() const noexcept { return m_axis; }
    /// Periods by which the force alone comes late.
    [[nodiscard]] std::size_t forceLate() const noexcept { return m_estimator.late(); }
    [[nodiscard]] const Params& params() const noexcept { return m_params; }

 private:
    [[nodiscard]] FeedDecision decide(const RevolutionInput& input) noexcept;
    [[nodiscard]] double lawFeed_mmPerS(const RevolutionInput& input, double knownChange) noexcept;
    [[nodiscard]] double lnDepthAt(double position_mm) const noexcept;
    /// Of ln b from the revolution just measured to the coming one, by the profile: for preview alone, another law may
    /// have been chosen because the profile is wrong.
    [[nodiscard]] double knownChange() const noexcept;
    /// Force the model laws steer for: a little below the reference.
    [[nodiscard]] double aim_N() const noexcept { return m_params.reference_N * (1.0 - m_below); }
    void takeAim() noexcept;
    /// By what the force has lately been beside the aim, for what the model leaves wrong.
    void trimAim(const RevolutionInput& input) noexcept;
    /// How much the depth has been turning from harder to easier and back lately, 0 … 1.
    void watchTurns() noexcept;
    [[nodiscard]] double modelShare(const RevolutionInput& input, double noisyShare) const noexcept;
    /// While the forces of the entry rather speak for another lateness than the one believed: the model may not raise
    /// the feed faster than the PI, which does not ask for it.
    [[nodiscard]] double mostDoubted_mm(const RevolutionInput& input, double error_N) const noexcept;
    void estimate(const RevolutionInput& input) noexcept;
    [[nodiscard]] std::size_t late() const noexcept { return m_axis.late() + m_estimator.late(); }

    Params m_params;
    LawKind m_law;
    LateForceEstimator m_estimator;
    AxisFollow m_axis{};
    PiLaw m_pi;
    BlankProfile m_blank{};
    double m_feed_mmPerS{0.0};  ///< last decision
    double m_lastError_N{0.0};
    double m_trim_N{0.0};  ///< added to the aim of the model's feed
    double m_below{0.0};   ///< share of the reference
    double m_turns{0.0};   ///< of the slope, slowly forgotten
    int m_slopeSign{0};    ///< of the last one that counted
    double m_blend_mmPerS{0.0};
    bool m_changed{false};  ///< law changed since the last revolution
    int m_period{1};
    int m_revolutionsInWork{0};
    double m_lnDepthBefore{0.0};  ///< of the revolution just measured, by the blank profile
    double m_lnDepthNow{0.0};     ///< of the coming one
    bool m_depthKnown{false};     ///< both belong to the present profile
};

}  // namespace kerf::milling
