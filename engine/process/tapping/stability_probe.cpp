// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/tapping/stability_probe.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include "engine/process/tapping/tap_drive.h"
#include "engine/process/tapping/trim_learning.h"

namespace kerf::tapping {
namespace {

using Complex = std::complex<double>;

constexpr double kSweep_mm = 0.06;
constexpr double kLowest_Hz = 4.0;
constexpr double kHighest_Hz = 220.0;
constexpr double kHighestOfRate = 0.3;
constexpr double kRingOut_s = 0.25;
constexpr double kShortestSweep_s = 0.3;
constexpr double kGridRatio = 1.006;
constexpr double kSmoothAbove_Hz = 80.0;
constexpr double kGainMargin = 2.5;  ///< 8 dB
constexpr double kFromMinusOne = 0.5;
constexpr double kNoiseCounted = 2.0;  ///< standard deviations
constexpr double kGainGrid = 1.02;
constexpr double kWidestSearch = 40.0;  ///< of the gain probed

double highest_Hz(double tick_s) {
    return std::min(kHighest_Hz, kHighestOfRate / tick_s);
}

Complex transform(std::span<const double> signal, double frequency_Hz, double tick_s) {
    const Complex turn = std::polar(1.0, -2.0 * std::numbers::pi * frequency_Hz * tick_s);
    Complex phase = 1.0;
    Complex sum = 0.0;
    for (const double value : signal) {
        sum += value * phase;
        phase *= turn;
    }
    return sum;
}

/// Open loop at the gain probed, one frequency.
struct Point {
    double frequency_Hz{0.0};
    Complex loop{};
    double spread{0.0};  ///< standard deviation of |loop| from the recorded noise
};

std::vector<Point> openLoopOf(std::span<const double> probe_mm, std::span<const double> answer_mm, double noise_mm,
                              double tick_s) {
    std::vector<Point> points;
    const double noise = noise_mm * std::sqrt(static_cast<double>(answer_mm.size()));
    for (double f_Hz = kLowest_Hz; f_Hz < highest_Hz(tick_s); f_Hz *= kGridRatio) {
        const Complex sent = transform(probe_mm, f_Hz, tick_s);
        const Complex closed = transform(answer_mm, f_Hz, tick_s) / sent;
        const Complex rest = 1.0 - closed;
        points.push_back({f_Hz, closed / rest, noise / std::abs(sent) / std::norm(rest)});
    }
    // A resonance of 2 % damping is 4 % wide: neighbours may be averaged where they are independent.
    std::vector<Point> smooth = points;
    for (std::size_t i = 2; i + 2 < points.size(); ++i) {
        if (points[i].frequency_Hz < kSmoothAbove_Hz) continue;
        smooth[i].loop = (points[i - 2].loop + points[i].loop + points[i + 2].loop) / 3.0;
        smooth[i].spread = points[i].spread / std::numbers::sqrt3;
    }
    return smooth;
}

/// Largest gain over the probed one with every smaller gain far enough from −1.
double widestGain(const std::vector<Point>& points) {
    double widest = 0.1;
    for (double gain = 0.1; gain < kWidestSearch; gain *= kGainGrid) {
        for (const Point& point : points) {
            const double blur = kNoiseCounted * point.spread;
            if (std::abs(1.0 + gain * point.loop) - std::min(gain * blur, 0.25) < kFromMinusOne) return widest;
        }
        widest = gain;
    }
    return widest;
}

/// Gain over the probed one that reaches −1: the least where the locus crosses the negative real axis. Beyond the sweep
/// the loop is taken to lag no less than at its end: without a crossing the last point counts.
double criticalGain(const std::vector<Point>& points) {
    double least = kWidestSearch;
    Point last{};
    const auto here = [](const Point& point) { return 1.0 / (std::abs(point.loop) + kNoiseCounted * point.spread); };
    for (const Point& point : points) {
        if (last.frequency_Hz > 0.0 && point.loop.real() < 0.0 && last.loop.real() < 0.0 &&
            point.loop.imag() * last.loop.imag() <= 0.0) {
            least = std::min({least, here(point), here(last)});
        }
        last = point;
    }
    return std::min(least, here(last));
}

// ── fit of the model ────────────────────────────────────────────────────────────────────────────────────────────────

constexpr std::array<double DriveParams::*, 6> kFitted{&DriveParams::zBandwidth_perS,   &DriveParams::zIntegral_perS,
                                                       &DriveParams::zTorqueLag_s,      &DriveParams::zResonance_Hz,
                                                       &DriveParams::zResonanceDamping, &DriveParams::zResonanceShare};
constexpr std::array<double, 6> kPriorSpread{0.5, 0.5, 1.0, 0.1, 0.7, 0.7};
constexpr std::size_t kRigid = 3;

DriveParams bounded(DriveParams out, const DriveParams& assumed) {
    out.zBandwidth_perS = std::clamp(out.zBandwidth_perS, 0.2 * assumed.zBandwidth_perS, 4.0 * assumed.zBandwidth_perS);
    out.zIntegral_perS = std::clamp(out.zIntegral_perS, 0.1 * assumed.zIntegral_perS, 6.0 * assumed.zIntegral_perS);
    out.zTorqueLag_s = std::clamp(out.zTorqueLag_s, 1.01 * assumed.tick_s / assumed.substeps, 0.05);
    out.zResonanceDamping = std::clamp(out.zResonanceDamping, 0.005, 0.5);
    out.zResonanceShare = std::clamp(out.zResonanceShare, 0.0, 2.0);
    return out;
}

struct Fit {
    DriveParams model{};
    double misfit_mm2{0.0};
};

/// Levenberg-Marquardt on the logarithms; `start` is the prior's middle.
Fit fitTo(const DriveParams& start, std::span<const double> probe_mm, std::span<const double> answer_mm,
          double noise_mm) {
    const std::size_t count = start.zResonance_Hz > 0.0 ? kFitted.size() : kRigid;
    const double noise2_mm2 = std::pow(std::max(noise_mm, 0.0005), 2);
    const auto misfit = [&](const DriveParams& model, std::span<const double> predicted_mm) {
        double sum_mm2 = 0.0;
        for (std::size_t k = 0; k < predicted_mm.size(); ++k)
            sum_mm2 += std::pow(answer_mm[k] - predicted_mm[k], 2);
        for (std::size_t i = 0; i < count; ++i)
            sum_mm2 += noise2_mm2 * std::pow(std::log(model.*kFitted[i] / start.*kFitted[i]) / kPriorSpread[i], 2);
        return sum_mm2;
    };
    Fit fit{start, 0.0};
    std::vector<double> base = trimResponse(fit.model, probe_mm);
    fit.misfit_mm2 = misfit(fit.model, base);
    double damping = 1e-3;
    constexpr int kSteps = 12;
    constexpr double kStep = 0.01;
    for (int iteration = 0; iteration < kSteps; ++iteration) {
        const auto n = static_cast<Eigen::Index>(count);
        Eigen::MatrixXd slopes(static_cast<Eigen::Index>(base.size()), n);
        Eigen::VectorXd left(static_cast<Eigen::Index>(base.size()));
        for (std::size_t k = 0; k < base.size(); ++k)
            left(static_cast<Eigen::Index>(k)) = answer_mm[k] - base[k];
        Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(n, n);
        Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
        for (std::size_t i = 0; i < count; ++i) {
            DriveParams aside = fit.model;
            aside.*kFitted[i] *= std::exp(kStep);
            const std::vector<double> moved = trimResponse(aside, probe_mm);
            const auto column = static_cast<Eigen::Index>(i);
            for (std::size_t k = 0; k < base.size(); ++k)
                slopes(static_cast<Eigen::Index>(k), column) = (moved[k] - base[k]) / kStep;
            const double weight = noise2_mm2 / (kPriorSpread[i] * kPriorSpread[i]);
            normal(column, column) += weight;
            right(column) += weight * std::log(start.*kFitted[i] / fit.model.*kFitted[i]);
        }
        normal += slopes.transpose() * slopes;
        right += slopes.transpose() * left;
        bool better = false;
        double gained = 0.0;
        for (int attempt = 0; attempt < 5 && !better; ++attempt) {
            Eigen::MatrixXd damped = normal;
            damped.diagonal() *= 1.0 + damping;
            const Eigen::VectorXd step = damped.ldlt().solve(right).cwiseMax(-0.5).cwiseMin(0.5);
            DriveParams candidate = fit.model;
            for (std::size_t i = 0; i < count; ++i)
                candidate.*kFitted[i] *= std::exp(step(static_cast<Eigen::Index>(i)));
            candidate = bounded(candidate, start);
            std::vector<double> predicted = trimResponse(candidate, probe_mm);
            const double now_mm2 = misfit(candidate, predicted);
            better = now_mm2 < fit.misfit_mm2;
            damping = better ? 0.1 * damping : std::max(10.0 * damping, 1e-2);
            if (!better) continue;
            gained = fit.misfit_mm2 - now_mm2;
            fit = {candidate, now_mm2};
            base = std::move(predicted);
        }
        if (!better || gained < 1e-4 * fit.misfit_mm2) break;
    }
    return fit;
}

/// A start for the resonance: where the measured loop lies farthest from the rigid model's.
bool findResonance(const std::vector<Point>& points, DriveParams& model) {
    constexpr double kSure = 4.0;       // standard deviations
    constexpr double kLeastRise = 0.3;  // of the rigid loop
    const auto rise = [&](const Point& point) {
        const Complex rigid = model.zKp_perS * openLoop(model, 2.0 * std::numbers::pi * point.frequency_Hz);
        return std::pair{std::abs(point.loop / rigid - 1.0), point.spread / std::abs(rigid)};
    };
    std::size_t best = points.size();
    double most = 0.0;
    double peak = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i].frequency_Hz < 10.0) continue;
        const auto [height, spread] = rise(points[i]);
        const double excess = height * std::abs(points[i].loop) / (1.0 + height);  // what counts is where it is large
        if (height > kLeastRise && height > kSure * spread && excess > peak) {
            most = height;
            peak = excess;
            best = i;
        }
    }
    if (best == points.size()) return false;
    std::size_t low = best;
    std::size_t high = best;
    while (low > 0 && rise(points[low]).first > std::numbers::sqrt2 / 2.0 * most)
        --low;
    while (high + 1 < points.size() && rise(points[high]).first > std::numbers::sqrt2 / 2.0 * most)
        ++high;
    const double width_Hz = points[high].frequency_Hz - points[low].frequency_Hz;
    model.zResonance_Hz = points[best].frequency_Hz;
    model.zResonanceDamping = std::clamp(0.5 * width_Hz / model.zResonance_Hz, 0.01, 0.3);
    model.zResonanceShare = 2.0 * model.zResonanceDamping * most;
    return true;
}

/// Z follows the slow part of the sweep.
bool answers(const std::vector<Point>& points) {
    constexpr double kSlow_Hz = 8.0;
    double sum = 0.0;
    double count = 0.0;
    for (const Point& point : points) {
        if (point.frequency_Hz > kSlow_Hz) break;
        sum += std::abs(point.loop / (1.0 + point.loop));
        count += 1.0;
    }
    return count > 0.0 && sum > 0.5 * count && sum < 2.0 * count;
}

}  // namespace

std::vector<double> probeTrim_mm(std::size_t ticks, double tick_s) {
    std::vector<double> probe_mm(ticks, 0.0);
    const double length_s = static_cast<double>(ticks) * tick_s - kRingOut_s;
    if (length_s < kShortestSweep_s) return probe_mm;
    constexpr double kFade_s = 0.02;
    for (std::size_t k = 0; k < ticks; ++k) {
        const double t_s = static_cast<double>(k) * tick_s;
        if (t_s >= length_s) break;
        const double turns = kLowest_Hz * t_s + 0.5 * (highest_Hz(tick_s) - kLowest_Hz) * t_s * t_s / length_s;
        const double fade = std::min({1.0, t_s / kFade_s, (length_s - t_s) / kFade_s});
        probe_mm[k] = kSweep_mm * fade * std::sin(2.0 * std::numbers::pi * turns);
    }
    return probe_mm;
}

std::optional<MeasuredLoop> measureLoop(const DriveParams& assumed, const TapSettings& settings,
                                        std::span<const double> probe_mm, const TapSignals& plus,
                                        const TapSignals& minus) {
    const double tick_s = assumed.tick_s;
    std::vector<double> answer_mm(std::min(plus.z_mm.size(), minus.z_mm.size()));
    for (std::size_t k = 0; k < answer_mm.size(); ++k)
        answer_mm[k] = 0.5 * (plus.z_mm[k] - minus.z_mm[k]);
    const double noise_mm = errorNoise_mm(answer_mm);
    const std::vector<Point> points = openLoopOf(probe_mm, answer_mm, noise_mm, tick_s);
    if (!answers(points)) return std::nullopt;
    MeasuredLoop loop;
    loop.critical_perS = settings.zKp_perS * criticalGain(points);
    loop.highest_perS = std::min(loop.critical_perS / kGainMargin, settings.zKp_perS * widestGain(points));
    const DriveParams start = withSettings(assumed, settings);
    const std::span<const double> sent(probe_mm.data(), answer_mm.size());
    const Fit rigid = fitTo(start, sent, answer_mm, noise_mm);
    loop.fitted = rigid.model;
    DriveParams swinging = rigid.model;
    if (findResonance(points, swinging)) {
        constexpr double kWorth = 0.8;  // of the rigid model's misfit
        const Fit fit = fitTo(swinging, sent, answer_mm, noise_mm);
        if (fit.misfit_mm2 < kWorth * rigid.misfit_mm2) {
            loop.fitted = fit.model;
            loop.resonance_Hz = fit.model.zResonance_Hz;
        }
    }
    return loop;
}

}  // namespace kerf::tapping
