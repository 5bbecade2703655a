// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/turning/margins.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace kerf::turning {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kScan = 20000;

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
    result.gain = gainLimit(loop);
    result.phase_deg = 180.0;
    result.delay_samples = std::numeric_limits<double>::infinity();
    result.modulus = std::numeric_limits<double>::infinity();
    double before = omegaAt(0);
    for (int i = 1; i <= kScan; ++i) {
        const double here = omegaAt(i);
        result.modulus = std::min(result.modulus, std::abs(1.0 + loop(here)));
        const auto excess = [&](double omega) { return std::abs(loop(omega)) - 1.0; };
        if ((excess(before) > 0.0) != (excess(here) > 0.0)) {
            const double crossing = bisect(excess, before, here);
            double phase_rad = std::arg(loop(crossing)) + kPi;
            phase_rad = phase_rad > kPi ? phase_rad - 2.0 * kPi : phase_rad;
            result.phase_deg = std::min(result.phase_deg, std::abs(phase_rad) * 180.0 / kPi);
            if (phase_rad > 0.0) {
                result.delay_samples = std::min(result.delay_samples, phase_rad / crossing);
            }
        }
        before = here;
    }
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

Margins lawMargins(PlantKind plant, const PiGains& gains, const ProcessParams& process) {
    const DepthPath path(plant, process, 0.994, 0.24);
    return margins([&](double omega) { return gains.gain * piResponse(omega) * path.response(omega); });
}

Margins cancellerMargins(double highestTone_Hz, double sampleRate_Hz) noexcept {
    return {std::numeric_limits<double>::infinity(), 90.0, sampleRate_Hz / (4.0 * highestTone_Hz), 1.0};
}

}  // namespace kerf::turning
