// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/turning/tone_canceller.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kerf::turning {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kKnownSpread_Hz = 0.6;  ///< how far a known tone may be from its name
constexpr double kFoundSpread_Hz = 0.15;
constexpr double kKnownAmplitude_um2 = 0.5;    ///< prior variance of a known tone
constexpr std::size_t kFrequenciesFree = 300;  ///< samples before frequencies are followed
constexpr std::size_t kEarliest = 500;         ///< samples before known tones may act
constexpr double kSureFrequency_Hz = 0.12;
constexpr double kFoundLevel_um2 = 0.01;   ///< variance of a level that a search has found
constexpr double kWorthwhile = 0.1;        ///< squared amplitude over noise variance below which a tone is left alone
constexpr double kStartMemory = 150.0;     ///< samples in which amplitudes are followed at the start
constexpr double kAllowedRise = 2.0;       ///< power of x_i over what it would be without the law
constexpr double kExplained = 0.015;       ///< share of the power known tones may leave to act at once
constexpr double kAuthorityStep = 0.0025;  ///< per sample: full trim after 400
constexpr double kAuthorityDrop = 0.05;    ///< per sample: none after 20, 4 ms
constexpr double kPowerMemory = 0.998;
constexpr double kFastMemory = 0.99;
constexpr std::size_t kWorseSamples = 1000;
constexpr std::size_t kBroadbandFrom =
    1010;                               ///< samples before the prediction may act: the first search has its signal
constexpr double kShareMemory = 0.998;  ///< .1 s
constexpr double kShareStep = 0.0025;   ///< of β per sample upwards
constexpr double kShareDrop = 0.01;
constexpr double kEarnMemory = 0.9993;  ///< .3 s
constexpr double kEarnFrom = 0.1;
constexpr double kEarnWhole = 0.25;
constexpr double kAfterNewTone = 0.01;
constexpr double kSlowShare = 1e-3;  ///< .2 s
constexpr double kWorseBy = 1.1;
constexpr std::size_t kFirstPause = 5000;      ///< samples without trim after letting go; doubled each time
constexpr std::size_t kLongestPause = 600000;  ///< 2 min
constexpr double kLowest_Hz = 8.5;
constexpr double kHighest_Hz = 410.0;
constexpr double kDuplicate_Hz = 1.2;
constexpr double kOwned_Hz = 2.5;                   ///< a residual peak this near a tone is that tone's own unrest
constexpr double kBlindLeakPerSample = 1.0 - 2e-6;  ///< 100 s at 5 kHz

}  // namespace

double visibility(double frequency_Hz, std::size_t revolutionSamples, double sampleRate_Hz) noexcept {
    return 2.0 * std::abs(std::sin(kPi * frequency_Hz * static_cast<double>(revolutionSamples) / sampleRate_Hz));
}

ToneCanceller::ToneCanceller(const Params& params, const DepthPath& path) noexcept
    : m_params(params),
      m_freshPath(path),
      m_path(path),
      m_freshBack(path.inverse()),
      m_back(path.inverse()),
      m_tracker(params.tracker) {
    reset();
}

void ToneCanceller::reset() noexcept {
    m_path = m_freshPath;
    m_back = m_freshBack;
    m_reference.reset();
    m_guard.reset();
    m_underGuard.reset();
    m_underNext_um = m_plainNext_um = m_slow_um = m_slowPlain_um = 0.0;
    m_plain.reset();
    m_underTones.reset();
    m_toneNext_um = m_share = m_cross_um2 = m_apart_um2 = m_plainLeft_um2 = m_underLeft_um2 = 0.0;
    m_tracker.reset(0.0, m_params.levelVariance_um2);
    m_acting = false;
    m_authority = m_command_um = m_reference_um = 0.0;
    m_remaining_um2 = m_untreated_um2 = m_innovation_um2 = 0.0;
    m_samples = m_worse = m_nextInverse = m_pause = 0;
    m_pauseLength = kFirstPause;
    startKnown();
    m_finder.begin();
}

void ToneCanceller::startKnown() noexcept {
    const double toOmega = 2.0 * kPi / m_params.sampleRate_Hz;
    for (std::size_t j = 0; j < m_params.knownCount; ++j) {
        Tone tone;
        tone.omega_radPerSample = m_params.knownTones_Hz[j] * toOmega;
        if (m_tracker.add(tone, kKnownAmplitude_um2, 0.0)) {
            m_inverse[j] = 1.0 / m_path.response(tone.omega_radPerSample);
        }
    }
}

void ToneCanceller::setProcess(const ProcessParams& process) noexcept {
    m_path.setProcess(process);
    m_freshPath.setProcess(process);
    m_back.setProcess(process);
    m_freshBack.setProcess(process);
}

bool ToneCanceller::blind(std::size_t index) const noexcept {
    return visibility(m_tracker.tone(index).frequency_Hz(m_params.sampleRate_Hz), m_params.revolutionSamples,
                      m_params.sampleRate_Hz) < kBlindBelow;
}

/// 0 while a tone's amplitude could be chance, 1 when it stands well above its own uncertainty.
double ToneCanceller::trust(std::size_t index) const noexcept {
    const Tone& tone = m_tracker.tone(index);
    const double power_um2 = tone.a_um * tone.a_um + tone.b_um * tone.b_um;
    const double least_um2 =
        std::max(8.0 * m_tracker.amplitudeVariance_um2(index), kWorthwhile * m_tracker.noise_um2());
    return std::clamp(0.5 * (power_um2 / least_um2 - 1.0), 0.0, 1.0);
}

void ToneCanceller::refreshInverse() noexcept {
    if (m_tracker.count() == 0) {
        return;
    }
    m_nextInverse = m_nextInverse + 1 < m_tracker.count() ? m_nextInverse + 1 : 0;
    m_inverse[m_nextInverse] = 1.0 / m_path.response(m_tracker.tone(m_nextInverse).omega_radPerSample);
}

double ToneCanceller::update(double inner_um) noexcept {
    m_samples = m_pause > 0 ? 0 : m_samples + 1;
    m_pause -= m_pause > 0 ? 1 : 0;
    if (m_pause == 1) {
        m_tracker.reset(m_tracker.level_um(), m_params.levelVariance_um2);
        startKnown();
        m_finder.begin();
    }
    const double shape = m_path.entryShape();
    const double disturbance_um = inner_um - m_path.step_um(m_command_um);
    if (!m_acting && m_samples == kFrequenciesFree) {
        m_tracker.freeFrequencies(std::pow(kKnownSpread_Hz * 2.0 * kPi / m_params.sampleRate_Hz, 2));
    }
    const double innovation_um = m_tracker.update(disturbance_um, shape, m_acting);
    // On the machine a sensor that drifts or an edge that wears must not look like motion: the level is followed fast.
    m_reference_um = m_params.meanGuard ? m_tracker.level_um() * shape
                                        : m_reference.update_um(
                                              disturbance_um, shape,
                                              m_params.forceOnly ? CutReference::kLongMemory : CutReference::kMemory);
    judge(inner_um, disturbance_um, innovation_um);
    refreshInverse();
    if (m_pause == 0 && m_finder.step(m_acting ? innovation_um : disturbance_um, shape)) {
        adopt();
    }
    // From the force alone slow motion is half the observer's own drift: under tones it is left alone.
    m_underLeft_um = m_untreatedNow_um - m_toneNext_um - m_underNext_um;
    if (m_params.forceOnly) {
        m_slow_um += kSlowShare * (m_underLeft_um - m_slow_um);
        m_underLeft_um -= m_slow_um;
        m_slowPlain_um += kSlowShare * (m_untreatedNow_um - m_plainNext_um - m_slowPlain_um);
    }
    m_plainLeft_um = m_untreatedNow_um - m_plainNext_um - m_slowPlain_um;
    const double plain_um = m_plainNext_um = m_plain.update(m_untreatedNow_um);
    double under_um = m_underTones.update(m_untreatedNow_um - m_toneNext_um);
    if (m_params.forceOnly) {
        under_um = m_underGuard.pass_um(under_um);
    }
    m_underNext_um = under_um;
    weigh();
    const double tones_um = toneCommand_um();
    const bool on = !m_silent && m_pause == 0 && (m_acting || m_samples >= kBroadbandFrom);
    m_authority = std::clamp(m_authority + (on ? kAuthorityStep : -kAuthorityDrop), 0.0, 1.0);
    double foreseen_um = m_authority * (plain_um + m_share * (under_um - plain_um));
    if (m_params.meanGuard) {
        foreseen_um = m_guard.pass_um(foreseen_um, MeanGuard::kHastyShare);
    }
    m_command_um = m_authority * m_share * tones_um + m_back.step_um(-foreseen_um);
    return m_command_um;
}

/// β from what either prediction has left of the last samples. Tones have to earn their place: by a tenth of what is
/// left without them.
void ToneCanceller::weigh() noexcept {
    const double plain_um = m_plainLeft_um;
    const double under_um = m_underLeft_um;
    const double apart_um = plain_um - under_um;
    const auto follow = [](double& mean, double value, double memory) { mean = memory * mean + value; };
    follow(m_cross_um2, plain_um * apart_um, kShareMemory);
    follow(m_apart_um2, apart_um * apart_um, kShareMemory);
    follow(m_plainLeft_um2, plain_um * plain_um, kEarnMemory);
    follow(m_underLeft_um2, under_um * under_um, kEarnMemory);
    const double gain = 1.0 - m_underLeft_um2 / std::max(m_plainLeft_um2, 1e-12);
    const double earned = std::clamp((gain - kEarnFrom) / (kEarnWhole - kEarnFrom), 0.0, 1.0);
    const double best =
        m_apart_um2 > 1e-12 && m_acting ? earned * std::clamp(m_cross_um2 / m_apart_um2, 0.0, 1.0) : 0.0;
    m_share += std::clamp(best - m_share, -kShareDrop, kShareStep);
}

/// Command that cancels all tones whole, and what they foresee of the next sample.
double ToneCanceller::toneCommand_um() noexcept {
    double command_um = 0.0;
    m_toneNext_um = 0.0;
    for (std::size_t j = 0; m_acting && j < m_tracker.count(); ++j) {
        const Tone& tone = m_tracker.tone(j);
        if (m_params.forceOnly && blind(j)) {
            m_tracker.leak(j, kBlindLeakPerSample);
        }
        const std::complex<double>& inverse = m_inverse[j];
        const double real_um = tone.a_um * inverse.real() + tone.b_um * inverse.imag();
        const double imag_um = tone.a_um * inverse.imag() - tone.b_um * inverse.real();
        const double trusted = trust(j);
        command_um -= trusted * (real_um * tone.cosine - imag_um * tone.sine);
        m_toneNext_um += trusted * (tone.a_um * std::cos(tone.phase_rad) + tone.b_um * std::sin(tone.phase_rad));
    }
    return command_um;
}

/// Decides when to start and when to let go.
void ToneCanceller::judge(double inner_um, double disturbance_um, double innovation_um) noexcept {
    const double remaining_um = inner_um - m_reference_um;
    const double untreated_um = disturbance_um - m_reference_um;
    m_untreatedNow_um = untreated_um;
    m_innovation_um = innovation_um;
    m_remaining_um2 += (1.0 - kPowerMemory) * (remaining_um * remaining_um - m_remaining_um2);
    m_untreated_um2 += (1.0 - kPowerMemory) * (untreated_um * untreated_um - m_untreated_um2);
    m_innovation_um2 += (1.0 - kFastMemory) * (innovation_um * innovation_um - m_innovation_um2);
    if (!m_acting && m_samples >= kEarliest && m_innovation_um2 < kExplained * m_untreated_um2 && settled()) {
        begin();
    }
    const bool whole = m_authority >= 1.0;
    m_worse = whole && m_remaining_um2 > kWorseBy * m_untreated_um2 ? m_worse + 1 : 0;
    if (m_worse > kWorseSamples || (whole && m_remaining_um2 > kAllowedRise * m_untreated_um2)) {
        letGo();
    }
}

void ToneCanceller::letGo() noexcept {
    m_worse = m_samples = 0;
    m_acting = false;
    m_pause = m_pauseLength;
    m_pauseLength = std::min(2 * m_pauseLength, kLongestPause);
    m_tracker.reset(m_tracker.level_um(), m_params.levelVariance_um2);
    m_plain.reset();
    m_underTones.reset();
    m_cross_um2 = m_apart_um2 = m_plainLeft_um2 = m_underLeft_um2 = 0.0;
    startKnown();
    m_finder.begin();
}

/// The frequencies of all tones that count are known well enough to act on.
bool ToneCanceller::settled() const noexcept {
    const double toHz = m_params.sampleRate_Hz / (2.0 * kPi);
    bool any = false;
    for (std::size_t j = 0; j < m_tracker.count(); ++j) {
        if (trust(j) > 0.0) {
            any = true;
            if (std::sqrt(m_tracker.frequencyVariance_rad2(j)) * toHz > kSureFrequency_Hz) {
                return false;
            }
        }
    }
    return any;
}

void ToneCanceller::begin() noexcept {
    m_acting = true;
    m_tracker.expectAmplitudeChange(kStartMemory);
    m_finder.begin();
}

/// A search has ended: before the law acts its tones replace the known ones, later they join them.
void ToneCanceller::adopt() noexcept {
    bool starting = false;
    bool added = false;
    if (!m_acting) {
        m_tracker.reset(m_finder.level_um(), kFoundLevel_um2);
        starting = true;
    } else {
        tidy();
    }
    const double toHz = m_params.sampleRate_Hz / (2.0 * kPi);
    std::size_t standing = m_tracker.count();
    for (std::size_t i = 0; i < m_finder.count(); ++i) {
        // This sample's tracker step is done: the tone must hold for the next one.
        const Tone found = m_finder.tone(i, m_finder.age());
        // A residual peak near a tone is that tone's own unrest; larger than the tone itself, it is the tone.
        bool owned = false;
        for (std::size_t j = 0; j < std::min(standing, m_tracker.count()); ++j) {
            const Tone& tone = m_tracker.tone(j);
            const bool near = std::abs(tone.omega_radPerSample - found.omega_radPerSample) * toHz < kOwned_Hz;
            if (near && found.amplitude_um() > tone.amplitude_um()) {
                drop(j);
                --standing;
                owned = false;
                break;
            }
            owned = owned || near;
        }
        const double power_um2 = found.a_um * found.a_um + found.b_um * found.b_um;
        const double variance_um2 =
            4.0 * m_finder.noise_um2() / static_cast<double>(ToneFinder::kPoints * ToneFinder::kDecimation) +
            0.01 * power_um2;
        const bool credible = power_um2 < 8.0 * m_finder.power_um2();
        if (!owned && credible && m_tracker.add(found, variance_um2, std::pow(kFoundSpread_Hz / toHz, 2))) {
            m_inverse[m_tracker.count() - 1] = 1.0 / m_path.response(found.omega_radPerSample);
            added = true;
        }
    }
    if (added) {  // what the tones leave is another signal from here on
        m_underTones.forget(kAfterNewTone);
        for (double* mean : {&m_cross_um2, &m_apart_um2, &m_plainLeft_um2, &m_underLeft_um2}) {
            *mean *= kAfterNewTone;
        }
    }
    if (starting) {
        begin();
    }
    m_finder.begin();
}

/// Drops tones that are only chance, and the weaker of two that have run into each other.
void ToneCanceller::tidy() noexcept {
    const double toHz = m_params.sampleRate_Hz / (2.0 * kPi);
    for (std::size_t j = m_tracker.count(); j-- > 0;) {
        const double here_Hz = m_tracker.tone(j).frequency_Hz(m_params.sampleRate_Hz);
        bool useless = trust(j) <= 0.0 || here_Hz < kLowest_Hz || here_Hz > kHighest_Hz;
        for (std::size_t i = 0; i < m_tracker.count() && !useless; ++i) {
            const double apart_Hz =
                std::abs(m_tracker.tone(i).omega_radPerSample - m_tracker.tone(j).omega_radPerSample) * toHz;
            useless = i != j && apart_Hz < kDuplicate_Hz &&
                      m_tracker.tone(i).amplitude_um() >= m_tracker.tone(j).amplitude_um();
        }
        if (useless) {
            drop(j);
        }
    }
}

void ToneCanceller::drop(std::size_t index) noexcept {
    m_tracker.remove(index);
    for (std::size_t i = index; i + 1 < kMaxTones; ++i) {
        m_inverse[i] = m_inverse[i + 1];
    }
}

}  // namespace kerf::turning
