// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/process/milling/stiffness_estimator.h"

/// The laws, one revolution at a time. Pure but for the two numbers the PI law carries; all run in the cycle: no
/// allocation, lock, throw or I/O. Forces in N ≥ 0, feeds in mm/s or mm/rev ≥ 0. FeedController chooses and guards.
namespace kerf::milling {

/// Feed the machine accepts.
struct FeedRange {
    double min_mmPerS{0.0};
    double max_mmPerS{4.0};
};

/// PI law in velocity form, the paper's, with its misprint corrected:
///
///   u(i) = u(i−1) + k0 (e(i) − α e(i−1)),  k0 = k_p, α = (k_p − k_i)/k_p,  e = r − F_y   (22-27)
///
/// The print has the other sign of e, which stalls the feed. The stored u is the clamped one (anti-windup).
/// Gains hold for `nominalRevolution_s`; at another speed they follow T, so that the loop per revolution stays the
/// same.
class PiLaw {
 public:
    struct Params {
        double kp_mmPerSPerN{0.75 * 0.0254};  ///< k_p: pulse/s per N times the pulse, > 0
        double ki_mmPerSPerN{0.15 * 0.0254};  ///< k_i, ≥ 0
        double nominalRevolution_s{0.1};
    };
    PiLaw() noexcept = default;
    explicit PiLaw(const Params& params) noexcept : m_params(params) {}

    /// Feed for the coming revolution; `error_N` = reference − averaged force, `revolution_s` > 0.
    [[nodiscard]] double update(double error_N, double revolution_s, const FeedRange& range) noexcept;
    /// Continue from another law's feed: the next output differs from it only by what the error does from here on.
    void resume(double feed_mmPerS, double error_N) noexcept {
        m_feed_mmPerS = feed_mmPerS;
        m_lastError_N = error_N;
    }

 private:
    Params m_params{};
    double m_feed_mmPerS{0.0};
    double m_lastError_N{0.0};
};

/// What a model law plans one revolution with.
struct InversionModel {
    double exponent{0.85};
    double forceAngle_deg{45.0};
    double kx_NPerMm{70.0 * kNewtonPerKilogramForce};
};

/// The two feeds a model law steers between.
struct Inversion {
    double deadbeat_mmPerRev{0.0};  ///< reaches the reference within this revolution; may be negative
    double steady_mmPerRev{0.0};    ///< keeps the reference for ever
};

/// Feed per revolution that brings F_y from `force_N` to `reference_N` > 0 if ln(C b) is `lnCb` in the coming
/// revolution: l* = (F_c*/(C b))^(1/m); steady f = l*; deadbeat f = l* + δ_x* − δ_x (equations 1-6 solved for f_r).
[[nodiscard]] Inversion invert(const InversionModel& model, double lnCb, double force_N, double reference_N) noexcept;

/// How far F_y follows in the same revolution when the feed changes: b0 of docs/milling.md as a tangent, in N/mm, near
/// `feed_mmPerRev` > 0 at the reference.
[[nodiscard]] double forcePerFeed_NPerMm(const InversionModel& model, double reference_N,
                                         double feed_mmPerRev) noexcept;

/// How a model law mixes the two: all the way when it must back off, more gently when it may recover; and how far it
/// trusts the slope of the estimate, more when the cut grows harder. Each for a clean force and for a noisy one.
struct ModelLawParams {
    double backOff{1.2};    ///< share of the deadbeat feed when the force is above the reference, [0, 1]
    double recover{0.884};  ///< when it is below, [0, backOff]
    double recoverNoisy{0.4};
    double leadHarder{1.075};  ///< revolutions ahead on a rising slope
    double leadHarderNoisy{2.2};
    double leadEasier{0.628};  ///< on a falling one
    double leadEasierNoisy{0.55};
    double entryShare{0.121};  ///< of both shares during the first `entryRevolutions` in the work
    double entryLead{0.208};   ///< revolutions further ahead then: how late a force comes is not known yet
    int entryRevolutions{33};
    double aheadShare{1.01};  ///< of both shares for each revolution predicted since the last force
    double aheadShareNoisy{1.375};
    double aheadLead{0.936};  ///< of the lead
    double aheadLeadNoisy{0.7};
    double caution{0.238};  ///< ln(C b) is taken for larger by this share of its standard deviation above `sure`
    double sure{0.0127};

    /// A noisy force: the model's feed counts `modelShare`, the rest is feedback from the last feed given,
    ///   f = f_last + (c_p (e − e_last) + c_i e_last)/b0,
    /// the paper's law with gains that follow the tool learnt. Two answers to the same noise shake less than one. The
    /// noisier, the calmer: from `noisy` to `veryNoisy` with the logarithm of the noise.
    struct Feedback {
        double modelShare;
        double proportional;  ///< c_p
        double integral;      ///< c_i
    };
    Feedback noisy{0.22, 0.834, 0.24};
    Feedback veryNoisy{0.17, 0.65, 0.18};
    double entryProportional{0.8};  ///< while the force of the entry builds up
    double entryIntegral{0.14};
    int settledFrom{40};           ///< revolutions in the work from which the other gains hold
    double leastB0_NPerMm{360.0};  ///< a softer tool is not given more gain

    /// What exponent, angle and k_x leave wrong is constant for a while: the force aimed at is trimmed by the sum of
    /// the errors, each at most `trimClip` of the reference (a step is the model's own affair), the sum at most
    /// `trimMost`.
    double trimGain{0.12};  ///< per revolution, of a clean force; of a noisy one, by the square of `quiet`
    double trimClip{0.04};
    double trimMost{0.03};
    double trimLeak{0.025};  ///< forgotten per revolution

    /// The safety net. The force is held from below: by `below` of the reference, by more where it comes late and the
    /// depth turns or where it is noisy. Where the depth turns often (a comb) it cannot be foretold: the model's feed
    /// counts less there.
    double below{0.0105};
    double belowNoisy{0.012};  ///< further, in a noisy force
    double belowLate{0.025};   ///< further, for each period of lateness, when the depth turns
    double shareTurning{0.5};
    double shareTurningLate{0.2};
};

/// Feed per revolution of the model law; `knownChange`: change of ln b in the coming revolution from a blank profile.
[[nodiscard]] double modelFeed_mmPerRev(const ModelLawParams& params, const InversionModel& model,
                                        const StiffnessEstimate& estimate, double knownChange, double reference_N,
                                        int revolutionsInWork) noexcept;

/// Gains for a force whose noise is `noiseShare` ≥ 0 of the reference.
[[nodiscard]] ModelLawParams::Feedback feedbackAt(const ModelLawParams& params, double noiseShare,
                                                  int revolutionsInWork) noexcept;

/// Feed per revolution after `lastFeed_mmPerRev` by the error e = reference − averaged force alone; `b0_NPerMm` > 0.
[[nodiscard]] double feedbackFeed_mmPerRev(const ModelLawParams::Feedback& gains, double b0_NPerMm,
                                           double lastFeed_mmPerRev, double error_N, double lastError_N) noexcept;

}  // namespace kerf::milling
