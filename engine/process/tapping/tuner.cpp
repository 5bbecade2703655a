// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/tapping/tuner.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/process/tapping/trim_learning.h"

namespace kerf::tapping {
namespace {

/// What all four share: the count of taps, the settings to fall back to, taps that do not count.
class TrialTuner : public Tuner {
 public:
    explicit TrialTuner(const TunerSetup& setup)
        : m_setup(setup), m_current(setup.initial), m_accepted(setup.initial), m_safe(safeSet(setup.assumed)) {
        if (setup.measured) {
            m_setup.assumed = setup.measured->fitted;
            m_safe = safeSet(m_setup.assumed);
        }
    }

    [[nodiscard]] const TapSettings& settings() const final { return m_current; }

    TunerStep observe(const TapSignals& tap) final {
        TunerStep step;
        const ContourFigures figures =
            contourFigures(tap.spindle_rev, tap.z_mm, tap.valid, m_setup.assumed.pitch_mm, m_setup.assumed.engage_rev);
        const auto total = static_cast<double>(std::max<std::size_t>(tap.z_mm.size(), 1));
        if (static_cast<double>(figures.missing) > kMaxMissingShare * total || figures.samples == 0) {
            step.counted = false;
            step.safe = m_safe;
            step.next = m_current;
            step.reason = Sentence(KERF_TEXT("%1 % of the samples are missing: this tap does not count, repeat it."),
                                   {100.0 * static_cast<double>(figures.missing) / total, 1});
            return step;
        }
        ++m_taps;
        decide(tap, figures, step);
        if (!step.finished && m_taps >= m_setup.maxTaps) {
            step.finished = true;
            step.next = settingsToKeep();
            step.reason = Sentence(KERF_TEXT("All %1 taps are used."), {static_cast<double>(m_taps), 0});
        }
        step.safe = m_safe;
        m_current = step.next;
        return step;
    }
    void rollBack() final { m_current = m_accepted; }

 protected:
    /// Fills `step` but for `safe`; m_current are the settings of this tap.
    virtual void decide(const TapSignals& tap, const ContourFigures& figures, TunerStep& step) = 0;
    [[nodiscard]] virtual TapSettings settingsToKeep() const { return m_accepted; }

    /// Measured when there was a probe, else estimated from the assumed and the fitted servo.
    [[nodiscard]] SafeGains safeSet(const DriveParams& fitted) const {
        const double initial_perS = m_setup.initial.zKp_perS;
        const auto& measured = m_setup.measured;
        return measured ? safeGains(measured->critical_perS, measured->highest_perS, fitted.pitch_mm, initial_perS)
                        : safeGains(m_setup.assumed, fitted, initial_perS);
    }

    void acceptIfBest(const ContourFigures& figures, TunerStep& step) {
        step.accepted = m_taps == 1 || figures.saec_mm < m_acceptedSaec_mm;
        if (step.accepted) {
            m_accepted = m_current;
            m_acceptedSaec_mm = figures.saec_mm;
        }
    }

    TunerSetup m_setup;
    TapSettings m_current;
    TapSettings m_accepted;
    SafeGains m_safe;
    double m_acceptedSaec_mm{0.0};
    int m_taps{0};
};

/// `paper` and `signed`. The printed rule has no bound but its own: the wide clamp, or a tenth per step when signed.
class RuleTuner final : public TrialTuner {
 public:
    explicit RuleTuner(const TunerSetup& setup) : TrialTuner(setup), m_eta(setup.eta) {}

 private:
    static constexpr double kProbe = 0.97;
    static constexpr double kLargestStep = 0.1;

    void decide(const TapSignals&, const ContourFigures& figures, TunerStep& step) override {
        acceptIfBest(figures, step);
        const bool isSigned = m_setup.kind == TunerKind::Signed;
        const double gain_perS = m_current.zKp_perS;
        const double change_mm = figures.saec_mm - m_lastSaec_mm;
        double next_perS = gain_perS;
        if (m_taps == 1 && (isSigned || m_setup.probe)) {
            next_perS = kProbe * gain_perS;
        } else if (isSigned) {
            const double direction = gain_perS >= m_lastGain_perS ? 1.0 : -1.0;
            next_perS = std::clamp(gain_perS - m_eta * change_mm * direction, (1.0 - kLargestStep) * gain_perS,
                                   (1.0 + kLargestStep) * gain_perS);
            if (change_mm > 0.0) m_eta *= 0.5;
            next_perS = std::clamp(next_perS, m_safe.lowest_perS, m_safe.highest_perS);
        } else {
            const double initial_perS = m_setup.initial.zKp_perS;
            next_perS =
                std::clamp(gain_perS - m_eta * change_mm, kPaperLowest * initial_perS, kPaperHighest * initial_perS);
        }
        m_lastSaec_mm = figures.saec_mm;
        m_lastGain_perS = gain_perS;
        step.next = m_current;
        step.next.zKp_perS = next_perS;
        step.reason = Sentence(KERF_TEXT("Sum of errors changed by %1 mm: gain from %2 to %3 1/s."), {change_mm, 1},
                               {gain_perS, 2}, {next_perS, 2});
        m_last = step.next;
    }
    /// The printed rule ends where it stands; the signed one keeps its best.
    [[nodiscard]] TapSettings settingsToKeep() const override {
        return m_setup.kind == TunerKind::Paper ? m_current : m_accepted;
    }

    double m_eta;
    double m_lastSaec_mm{0.0};
    double m_lastGain_perS{0.0};
    TapSettings m_last;
};

/// Error the same tap would have had with other gains: only the difference of two predictions is used, so what the
/// model does not know (load, friction, the spindle) stays as recorded.
std::vector<double> errorWith(const DriveParams& model, const TapSettings& made, const TapSettings& asked,
                              std::span<const double> spindle_rev, std::span<const double> error_mm) {
    const std::vector<double> before = predictZ(model, made, spindle_rev);
    std::vector<double> after = predictZ(model, asked, spindle_rev);
    for (std::size_t k = 0; k < after.size(); ++k)
        after[k] = error_mm[k] - (after[k] - before[k]);
    return after;
}

/// Gain with the least predicted SAEC inside the safe set: scan, then golden section.
double bestGain_perS(const DriveParams& model, const TapSettings& made, const SafeGains& safe,
                     std::span<const double> spindle_rev, std::span<const double> error_mm) {
    const std::vector<double> before = predictZ(model, made, spindle_rev);
    const auto saec = [&](double gain_perS) {
        TapSettings asked = made;
        asked.zKp_perS = gain_perS;
        const std::vector<double> after = predictZ(model, asked, spindle_rev);
        double sum_mm = 0.0;
        for (std::size_t k = 0; k < after.size(); ++k)
            sum_mm += std::abs(error_mm[k] - (after[k] - before[k]));
        return sum_mm;
    };
    constexpr int kScan = 12;
    const double ratio = std::pow(safe.highest_perS / safe.lowest_perS, 1.0 / kScan);
    double best_perS = safe.lowest_perS;
    double least_mm = saec(best_perS);
    for (int i = 1; i <= kScan; ++i) {
        const double gain_perS = safe.lowest_perS * std::pow(ratio, i);
        const double sum_mm = saec(gain_perS);
        if (sum_mm < least_mm) {
            least_mm = sum_mm;
            best_perS = gain_perS;
        }
    }
    constexpr double kGolden = 0.6180339887498949;
    double low = std::max(best_perS / ratio, safe.lowest_perS);
    double high = std::min(best_perS * ratio, safe.highest_perS);
    double inner = high - kGolden * (high - low);
    double outer = low + kGolden * (high - low);
    double atInner = saec(inner);
    double atOuter = saec(outer);
    while (high - low > 2e-4 * best_perS) {
        if (atInner < atOuter) {
            high = outer;
            outer = inner;
            atOuter = atInner;
            inner = high - kGolden * (high - low);
            atInner = saec(inner);
        } else {
            low = inner;
            inner = outer;
            atInner = atOuter;
            outer = low + kGolden * (high - low);
            atOuter = saec(outer);
        }
    }
    return 0.5 * (low + high);
}

/// Each tap tells where the optimum lies; taps made near it tell it best. The answer is their weighted mean.
class GainTuner final : public TrialTuner {
 public:
    using TrialTuner::TrialTuner;

 private:
    static constexpr double kSteady = 0.001;   ///< relative change of the answer that ends the search
    static constexpr double kNear = 0.004;     ///< spread of one tap's answer made at the optimum
    static constexpr double kFarShare = 0.05;  ///< model error of the answer, share of the distance
    static constexpr int kLeastTaps = 4;

    void decide(const TapSignals& tap, const ContourFigures& figures, TunerStep& step) override {
        acceptIfBest(figures, step);
        const DriveParams model = fitServo(m_setup.assumed, m_current, tap);
        m_safe = safeSet(model);
        const std::vector<double> error_mm = contourError(tap, m_setup.assumed.pitch_mm);
        const double found_perS = bestGain_perS(model, m_current, m_safe, tap.spindle_rev, error_mm);
        const double far = std::log(found_perS / m_current.zKp_perS);
        const double weight = 1.0 / (kNear * kNear + kFarShare * kFarShare * far * far);
        m_weight += weight;
        m_weighted += weight * std::log(found_perS);
        const double next_perS = std::clamp(std::exp(m_weighted / m_weight), m_safe.lowest_perS, m_safe.highest_perS);
        step.next = m_current;
        step.next.zKp_perS = next_perS;
        m_keep = step.next;
        m_keep.zKp_perS = next_perS;
        const double change = std::abs(std::log(next_perS / m_current.zKp_perS));
        step.expectedSaec_mm = sumAbs_mm(errorWith(model, m_current, step.next, tap.spindle_rev, error_mm));
        if (m_taps >= kLeastTaps && change < kSteady) {
            step.finished = true;
            step.reason = Sentence(KERF_TEXT("The best gain no longer moves: %1 1/s."), {next_perS, 2});
        } else {
            step.reason = Sentence(KERF_TEXT("Least error expected at a gain of %1 1/s: %2 mm instead of %3 mm."),
                                   {next_perS, 2}, {step.expectedSaec_mm, 1}, {figures.saec_mm, 1});
        }
    }
    [[nodiscard]] TapSettings settingsToKeep() const override { return m_keep; }

    double m_weight{0.0};
    double m_weighted{0.0};
    TapSettings m_keep;
};

/// Tap 1: matched gain and feed-forward, and the trim that the model says is left. Later taps: the trim alone, learned
/// from what is left, whole while the model's error shows, then as a running mean so that what does not repeat (load,
/// friction, noise) averages out. A tap that is clearly worse is taken back half way.
class DefaultTuner final : public TrialTuner {
 public:
    using TrialTuner::TrialTuner;

 private:
    static constexpr double kWorth = 0.08;         ///< predicted share of SAEC a further tap must promise
    static constexpr double kWorse = 1.5;          ///< SAEC against the accepted one that takes a tap back …
    static constexpr double kWorseInitial = 0.25;  ///< … if it is also above this share of the first tap's
    static constexpr double kModelShows = 0.03;    ///< of the first tap's SAEC: above it the model's error shows …
    static constexpr double kHalved = 0.5;         ///< … on tap 2, then while SAEC falls below this share of the last
    static constexpr double kClearlyWorse = 1.3;   ///< SAEC over the best tap's that gives the best tap's settings
    static constexpr double kWorthKeeping = 0.95;  ///< of the first tap's SAEC: more is no reason to change the machine
    static constexpr int kMeanTaps = 3;            ///< taps without a new best that end the tuning
    static constexpr double kHighestVelocityFf = 1.2;
    static constexpr double kHighestAccelFf = 5.0;

    void decide(const TapSignals& tap, const ContourFigures& figures, TunerStep& step) override {
        const std::vector<double> error_mm = contourError(tap, m_setup.assumed.pitch_mm);
        const double noise_mm = errorNoise_mm(error_mm);
        const DriveParams model = fitServo(m_setup.assumed, m_current, tap);
        m_safe = safeSet(model);
        if (m_taps == 1) m_firstSaec_mm = figures.saec_mm;
        step.accepted = m_taps == 1 || figures.saec_mm < kWorse * m_acceptedSaec_mm ||
                        figures.saec_mm < kWorseInitial * m_firstSaec_mm;
        if (!step.accepted) {
            step.next = between(m_accepted, m_current, 0.5);
            step.reason = Sentence(KERF_TEXT("Worse than before (%1 mm against %2 mm): back half way."),
                                   {figures.saec_mm, 1}, {m_acceptedSaec_mm, 1});
            return;
        }
        m_accepted = m_current;
        m_acceptedSaec_mm = figures.saec_mm;
        const bool best = m_taps == 1 || figures.saec_mm < (1.0 - kWorth) * m_leastSaec_mm;
        if (m_taps == 1) m_firstPp_um = figures.engagedPp_um;
        m_acceptedPp_um = figures.engagedPp_um;
        const double bound_mm = m_taps == 1 ? figures.saec_mm : std::min(m_bestSaec_mm, kWorthKeeping * m_firstSaec_mm);
        if (figures.saec_mm <= bound_mm && figures.engagedPp_um <= m_firstPp_um) {
            m_best = m_current;
            m_bestSaec_mm = figures.saec_mm;
        }
        m_leastSaec_mm = m_taps == 1 ? figures.saec_mm : std::min(m_leastSaec_mm, figures.saec_mm);
        m_sinceBest = best ? 0 : m_sinceBest + 1;

        TapSettings next = m_current;
        std::vector<double> left_mm = error_mm;
        if (!m_setup.trim) {
            match(model, tap.spindle_rev, error_mm, next, left_mm);
            matchOnly(figures, next, sumAbs_mm(left_mm), step);
            return;
        }
        double share = 1.0;
        if (m_taps == 1) {
            match(model, tap.spindle_rev, error_mm, next, left_mm);
        } else {
            const bool modelShows = m_averaged == 1 && figures.saec_mm > kModelShows * m_firstSaec_mm &&
                                    (m_taps == 2 || figures.saec_mm < kHalved * m_lastSaec_mm);
            if (!modelShows) share = 1.0 / static_cast<double>(++m_averaged);
        }
        m_lastSaec_mm = figures.saec_mm;
        const TrimUpdate update = trimFor(withSettings(model, next), left_mm, noise_mm);
        double predicted_mm = 0.0;
        next.zTrim_mm.resize(left_mm.size(), 0.0);
        for (std::size_t k = 0; k < left_mm.size(); ++k) {
            predicted_mm += std::abs(left_mm[k] - update.explained_mm[k]);
            next.zTrim_mm[k] =
                std::clamp(next.zTrim_mm[k] + share * update.trim_mm[k], -m_safe.highestTrim_mm, m_safe.highestTrim_mm);
        }
        step.expectedSaec_mm = predicted_mm;
        if (m_taps > 2 && (predicted_mm > (1.0 - kWorth) * figures.saec_mm || m_sinceBest >= kMeanTaps)) {
            step.finished = true;
            step.next = settingsToKeep();
            step.reason = Sentence(KERF_TEXT("What is left (%1 mm) is noise and scatter: further taps would not help."),
                                   {figures.saec_mm, 1});
            return;
        }
        step.next = std::move(next);
        if (m_taps == 1) {
            step.reason =
                Sentence(KERF_TEXT("Matched gain %1 1/s, feed-forward %2 and a learned trim: %3 mm expected."),
                         {step.next.zKp_perS, 2}, {step.next.zVelocityFf, 4}, {predicted_mm, 1});
        } else {
            step.reason = Sentence(KERF_TEXT("Refine the learned trim: %1 mm expected instead of %2 mm."),
                                   {predicted_mm, 1}, {figures.saec_mm, 1});
        }
    }

    /// Without a trim: the match again from every tap, until it promises nothing more.
    void matchOnly(const ContourFigures& figures, TapSettings& next, double predicted_mm, TunerStep& step) const {
        step.expectedSaec_mm = predicted_mm;
        if (m_taps > 1 && (predicted_mm > (1.0 - kWorth) * figures.saec_mm || m_sinceBest >= kMeanTaps)) {
            step.finished = true;
            step.next = settingsToKeep();
            step.reason = Sentence(KERF_TEXT("What is left (%1 mm) is not a matter of gain or feed-forward."),
                                   {figures.saec_mm, 1});
            return;
        }
        step.next = std::move(next);
        step.reason = Sentence(KERF_TEXT("Matched gain %1 1/s and feed-forward %2: %3 mm expected."),
                               {step.next.zKp_perS, 2}, {step.next.zVelocityFf, 4}, {predicted_mm, 1});
    }

    /// Gain and feed-forward into `next`; the error they are expected to leave into `left_mm`.
    void match(const DriveParams& model, std::span<const double> spindle_rev, std::span<const double> error_mm,
               TapSettings& next, std::vector<double>& left_mm) const {
        next.zKp_perS = bestGain_perS(model, m_current, m_safe, spindle_rev, error_mm);
        left_mm = errorWith(model, m_current, next, spindle_rev, error_mm);
        const FeedForward forward = feedForwardFor(model, next, spindle_rev, left_mm);
        next.zVelocityFf = std::clamp(next.zVelocityFf + forward.velocity, -kHighestVelocityFf, kHighestVelocityFf);
        next.zAccelFf = std::clamp(next.zAccelFf + forward.accel, -kHighestAccelFf, kHighestAccelFf);
        left_mm = errorWith(model, m_current, next, spindle_rev, error_mm);
    }

    [[nodiscard]] static TapSettings between(const TapSettings& from, const TapSettings& to, double share) {
        TapSettings out = from;
        out.zKp_perS += share * (to.zKp_perS - from.zKp_perS);
        out.zVelocityFf += share * (to.zVelocityFf - from.zVelocityFf);
        out.zAccelFf += share * (to.zAccelFf - from.zAccelFf);
        out.zTrim_mm.resize(std::max(from.zTrim_mm.size(), to.zTrim_mm.size()), 0.0);
        for (std::size_t k = 0; k < to.zTrim_mm.size(); ++k)
            out.zTrim_mm[k] += share * (to.zTrim_mm[k] - out.zTrim_mm[k]);
        return out;
    }

    /// The last accepted settings, a mean over several records; those of the best tap when it was clearly better. Never
    /// what made sum or peak-to-peak worse than the first tap's.
    [[nodiscard]] TapSettings settingsToKeep() const override {
        const bool keep = m_acceptedSaec_mm <= kClearlyWorse * m_bestSaec_mm &&
                          m_acceptedSaec_mm <= kWorthKeeping * m_firstSaec_mm && m_acceptedPp_um <= m_firstPp_um;
        return keep ? m_accepted : m_best;
    }

    TapSettings m_best;
    double m_bestSaec_mm{0.0};
    double m_acceptedPp_um{0.0};
    double m_firstPp_um{0.0};
    double m_firstSaec_mm{0.0};
    double m_leastSaec_mm{0.0};
    double m_lastSaec_mm{0.0};
    int m_averaged{1};  ///< records in the running mean of the trim
    int m_sinceBest{0};
};

}  // namespace

const char* tunerKey(TunerKind kind) {
    switch (kind) {
        case TunerKind::Paper:
            return "paper";
        case TunerKind::Signed:
            return "signed";
        case TunerKind::Gain:
            return "gain";
        case TunerKind::Default:
            break;
    }
    return "default";
}

std::unique_ptr<Tuner> makeTuner(const TunerSetup& setup) {
    switch (setup.kind) {
        case TunerKind::Paper:
        case TunerKind::Signed:
            return std::make_unique<RuleTuner>(setup);
        case TunerKind::Gain:
            return std::make_unique<GainTuner>(setup);
        case TunerKind::Default:
            break;
    }
    return std::make_unique<DefaultTuner>(setup);
}

}  // namespace kerf::tapping
