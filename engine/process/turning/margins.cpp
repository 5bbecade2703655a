// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/turning/margins.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace kerf::turning {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kScan = 20000;
constexpr double kPole = 1e4;  ///< a sign change through a pole is no crossing

double omegaAt(int i) {
    // Half of the points logarithmic up to .1 rad, half linear to π.
    constexpr int kLow = kScan / 2;
    constexpr double kLowest = 1e-6;
    constexpr double kKnee = 0.1;
    return i < kLow ? kLowest * std::pow(kKnee / kLowest, static_cast<double>(i) / kLow)
                    : kKnee + (kPi - kKnee) * static_cast<double>(i - kLow) / (kScan - kLow);
}

template <class F>
double bisect(F f, double low, double high) {
    const bool sign = f(low) > 0.0;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2.0;
        ((f(middle) > 0.0) == sign ? low : high) = middle;
    }
    return (low + high) / 2.0;
}

std::complex<double> piResponse(double omega) {
    const PiGains gains;
    const std::complex<double> back = std::polar(1.0, -omega);
    return (gains.now() + gains.before() * back) / (1.0 - back);
}

}  // namespace

double gainLimit(const LoopResponse& loop) {
    double limit = std::numeric_limits<double>::infinity();
    const auto consider = [&](double omega) {
        const double real = loop(omega).real();
        if (real < 0.0) {
            limit = std::min(limit, -1.0 / real);
        }
    };
    double before = omegaAt(0);
    for (int i = 1; i <= kScan; ++i) {
        const double here = omegaAt(i);
        if ((loop(before).imag() > 0.0) != (loop(here).imag() > 0.0)) {
            consider(bisect([&](double omega) { return loop(omega).imag(); }, before, here));
        }
        before = here;
    }
    consider(kPi);
    return limit;
}

Margins margins(const LoopResponse& loop) {
    Margins result;
    result.gain = std::numeric_limits<double>::infinity();
    result.phase_deg = 180.0;
    result.delay_samples = std::numeric_limits<double>::infinity();
    result.modulus = std::numeric_limits<double>::infinity();
    // Where the loop crosses the negative real axis left of −1 less gain, right of it more gain is the limit.
    const auto considerGain = [&](double omega) {
        const double real = loop(omega).real();
        if (real < -1.0) {
            result.gainLow = std::max(result.gainLow, -1.0 / real);
        } else if (real < 0.0) {
            result.gain = std::min(result.gain, -1.0 / real);
        }
    };
    double before = omegaAt(0);
    std::complex<double> valueBefore = loop(before);
    for (int i = 1; i <= kScan; ++i) {
        const double here = omegaAt(i);
        const std::complex<double> value = loop(here);
        result.modulus = std::min(result.modulus, std::abs(1.0 + value));
        const bool bounded = std::abs(value) < kPole && std::abs(valueBefore) < kPole;
        if (bounded && (valueBefore.imag() > 0.0) != (value.imag() > 0.0)) {
            considerGain(bisect([&](double omega) { return loop(omega).imag(); }, before, here));
        }
        if ((std::abs(valueBefore) > 1.0) != (std::abs(value) > 1.0)) {
            const double crossing = bisect([&](double omega) { return std::abs(loop(omega)) - 1.0; }, before, here);
            double phase_rad = std::arg(loop(crossing)) + kPi;
            phase_rad = phase_rad > kPi ? phase_rad - 2.0 * kPi : phase_rad;
            result.phase_deg = std::min(result.phase_deg, std::abs(phase_rad) * 180.0 / kPi);
            if (phase_rad > 0.0) {
                result.delay_samples = std::min(result.delay_samples, phase_rad / crossing);
            }
        }
        before = here;
        valueBefore = value;
    }
    considerGain(kPi);
    return result;
}

std::array<NamedLimit, 5> paperLimits(const ProcessParams& process) {
    const auto delayed = [](double omega) { return std::polar(1.0, -omega); };
    const auto slide = [](double omega) { return 0.006 / 0.24 / (1.0 - 0.994 * std::polar(1.0, -omega)); };
    const auto pc = [process](double omega) { return process.response(omega) * piResponse(omega); };
    return {{{"l_pc", "P·C·z⁻¹", gainLimit([&](double w) { return pc(w) * delayed(w); })},
             {"l_c", "C·z⁻¹", gainLimit([&](double w) { return piResponse(w) * delayed(w); })},
             {"l_pc_over_dc_gain", "P·C/.24·z⁻¹", gainLimit([&](double w) { return pc(w) / 0.24 * delayed(w); })},
             {"r0_one_delay", ".02·P·C·z⁻¹", gainLimit([&](double w) { return 0.02 * pc(w) * delayed(w); })},
             {"r1_one_delay", ".3·P·C·(.006/.24)/(1 − .994z⁻¹)·z⁻¹",
              gainLimit([&](double w) { return 0.3 * pc(w) * slide(w) * delayed(w); })}}};
}

Margins lawMargins(PlantKind plant, const PiGains& gains, const ProcessParams& process, const ProcessParams& truth) {
    const DepthPath path(plant, process, 0.994, 0.24);
    return margins([&](double omega) {
        return gains.gain * piResponse(omega) * path.response(omega) * truth.response(omega) / process.response(omega);
    });
}

Margins defaultMargins(const StandingLaw& standing, const ProcessParams& process, const ProcessParams& truth,
                       double sampleRate_Hz) {
    struct Resonator {
        std::complex<double> turn;
        std::complex<double> inverse;
        double share;
    };
    const DepthPath path(PlantKind::B2, process, 0.994, 0.24);
    std::vector<Resonator> resonators;
    for (const FollowedTone& tone : standing.tones) {
        const double omega = 2.0 * kPi * tone.frequency_Hz / sampleRate_Hz;
        resonators.push_back({std::polar(1.0, omega), 1.0 / path.response(omega), tone.share});
    }
    const auto still = [](const auto& weights) {
        return std::ranges::all_of(weights, [](double w) { return w == 0.0; });
    };
    if (resonators.empty() && still(standing.plain) && still(standing.underTones)) {
        const double none = std::numeric_limits<double>::infinity();
        return {none, 0.0, 180.0, none, 1.0};
    }
    return margins([&](double omega) {
        const std::complex<double> back = std::polar(1.0, -omega);
        std::complex<double> command{0.0, 0.0};    // w = −command·e
        std::complex<double> predicted{0.0, 0.0};  // of the next sample
        for (const Resonator& r : resonators) {
            const std::complex<double> plus = 1.0 / (1.0 - r.turn * back);
            const std::complex<double> minus = 1.0 / (1.0 - std::conj(r.turn) * back);
            command += 0.5 * r.share * (r.inverse * plus + std::conj(r.inverse) * minus);
            predicted += 0.5 * r.share * back * (r.turn * plus + std::conj(r.turn) * minus);
        }
        const std::complex<double> way = path.response(omega);
        const std::complex<double> ratio = truth.response(omega) / process.response(omega);
        const double share = standing.toneShare;
        const std::complex<double> whole =
            share * command * way +
            back * ((1.0 - share) * (1.0 + predicted) * BroadbandPredictor::response(standing.plain, omega) +
                    share * BroadbandPredictor::response(standing.underTones, omega));
        return ratio * whole / (1.0 + predicted - whole);
    });
}

Margins guaranteedMargins(const ProcessParams& identified, const std::array<double, 3>& half95,
                          const std::function<Margins(const ProcessParams&)>& ofTruth) {
    Margins worst = ofTruth(identified);
    for (int corner = 0; corner < 8; ++corner) {
        const auto moved = [&](double value, std::size_t i) {
            return value + (((corner >> i) & 1) != 0 ? half95[i] : -half95[i]);
        };
        const ProcessParams truth{moved(identified.a1, 0), moved(identified.b0, 1), moved(identified.b1, 2)};
        if (!truth.usable()) {
            continue;  // the gain at rest of such a corner contradicts the cut itself
        }
        const Margins here = ofTruth(truth);
        worst.gain = std::min(worst.gain, here.gain);
        worst.gainLow = std::max(worst.gainLow, here.gainLow);
        worst.phase_deg = std::min(worst.phase_deg, here.phase_deg);
        worst.delay_samples = std::min(worst.delay_samples, here.delay_samples);
        worst.modulus = std::min(worst.modulus, here.modulus);
    }
    return worst;
}

Margins cancellerMargins(double highestTone_Hz, double sampleRate_Hz) noexcept {
    return {std::numeric_limits<double>::infinity(), 0.0, 90.0, sampleRate_Hz / (4.0 * highestTone_Hz), 1.0};
}

}  // namespace kerf::turning
