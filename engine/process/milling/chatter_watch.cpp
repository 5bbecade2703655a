// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/milling/chatter_watch.h"

#include <algorithm>
#include <cmath>

namespace kerf::milling {
namespace {
constexpr std::size_t kLeastSamples = 256;
constexpr double kLeastShare = 0.04;   // of the mean force
constexpr double kOverShare = 0.02;    // below it is over
constexpr double kPeriodicPart = 0.3;  // of the variance of r
constexpr double kAsGood = 0.7;
constexpr int kWindows = 3;
constexpr double kLeastForce_N = 20.0;  // below: air
constexpr double kMostGain = 2.0;       // a step is cut into within several revolutions
}  // namespace

void ChatterWatch::begin(int flutes) noexcept {
    m_flutes = std::max(flutes, 1);
    m_chatters = false;
    m_amplitude_N = 0.0;
    m_frequency_Hz = 0.0;
    forget();
}

void ChatterWatch::forget() noexcept {
    m_taken = 0;
    m_then = 0;
    m_pitch = {};
    m_gain = 1.0;
    m_swinging = 0;
    m_calm = 0;
    newWindow();
}

void ChatterWatch::newWindow() noexcept {
    m_windowFrom_rev = m_taken > 0 ? m_angle_rev[(m_taken - 1) % kKept] : 0.0;
    m_differences = 0;
    m_sum_N = 0.0;
    m_forceSum_N = 0.0;
    m_time_s = 0.0;
    m_count = 0;
    m_products_N2 = {};
}

void ChatterWatch::add(const FastSample& sample) noexcept {
    const bool good =
        sample.quality == Quality::Good && std::isfinite(sample.force_N) && std::isfinite(sample.spindleAngle_rev);
    const double last_rev = m_taken > 0 ? m_angle_rev[(m_taken - 1) % kKept] : 0.0;
    if (!good || (m_taken > 0 && (sample.spindleAngle_rev < last_rev || sample.spindleAngle_rev > last_rev + 0.125))) {
        forget();
        return;
    }
    if (m_taken > 0 && sample.spindleAngle_rev == last_rev) {  // the spindle stands
        return;
    }
    const double angle_rev = sample.spindleAngle_rev;
    m_angle_rev[m_taken % kKept] = angle_rev;
    m_force_N[m_taken % kKept] = static_cast<float>(sample.force_N);
    const double step_s = m_taken > 0 ? static_cast<double>(sample.stamp_ns - m_last_ns) * 1e-9 : 0.0;
    m_last_ns = sample.stamp_ns;
    ++m_taken;
    while (m_then + 1 < m_taken && m_angle_rev[(m_then + 1) % kKept] <= angle_rev - 1.0) {
        ++m_then;
    }
    if (m_taken > kKept && m_then < m_taken - kKept) {  // more samples in a revolution than are kept
        m_then = m_taken - kKept;
        return;
    }
    const double from_rev = m_angle_rev[m_then % kKept];
    if (from_rev > angle_rev - 1.0 || m_then + 1 >= m_taken) {
        m_windowFrom_rev = angle_rev;
        return;
    }
    const double to_rev = m_angle_rev[(m_then + 1) % kKept];
    const double share = (angle_rev - 1.0 - from_rev) / (to_rev - from_rev);
    const double then_N = std::lerp(static_cast<double>(m_force_N[m_then % kKept]),
                                    static_cast<double>(m_force_N[(m_then + 1) % kKept]), share);
    const auto tooth = static_cast<std::int64_t>(std::floor(angle_rev * m_flutes));
    if (tooth != m_tooth) {
        m_tooth = tooth;
        m_gain = m_pitch.then_N > 0.0 ? std::clamp(m_pitch.now_N / m_pitch.then_N, 1.0 / kMostGain, kMostGain) : 1.0;
        m_pitch = {};
    }
    m_pitch.now_N += sample.force_N;
    m_pitch.then_N += then_N;
    m_forceSum_N += sample.force_N;
    m_time_s += step_s;
    takeDifference(sample.force_N - m_gain * then_N);
    if (m_count >= kLeastSamples && angle_rev - m_windowFrom_rev >= 1.0) {
        judge();
        newWindow();
    }
}

void ChatterWatch::takeDifference(double difference_N) noexcept {
    m_difference_N[m_differences % kLags] = difference_N;
    const std::size_t lags = std::min(m_differences, kLags - 1);
    for (std::size_t lag = 0; lag <= lags; ++lag) {
        m_products_N2[lag] += difference_N * m_difference_N[(m_differences - lag) % kLags];
    }
    m_sum_N += difference_N;
    ++m_differences;
    ++m_count;
}

void ChatterWatch::judge() noexcept {
    const auto count = static_cast<double>(m_count);
    const double mean_N = m_sum_N / count;
    const auto covariance_N2 = [&](std::size_t lag) {
        return m_products_N2[lag] / static_cast<double>(m_count - lag) - mean_N * mean_N;
    };
    std::array<double, kLags> periodic_N2{};
    for (std::size_t lag = 1; 2 * lag < kLags; ++lag) {
        periodic_N2[lag] = std::min(-covariance_N2(lag), covariance_N2(2 * lag));
    }
    // Odd multiples of half a period fit about as well: the first that does is the half period.
    const double most_N2 = std::max(*std::ranges::max_element(periodic_N2), 0.0);
    std::size_t half = 0;
    while (most_N2 > 0.0 && periodic_N2[half] < kAsGood * most_N2) {
        ++half;
    }
    m_amplitude_N = std::sqrt(most_N2);
    m_frequency_Hz = half > 0 && m_time_s > 0.0 ? count / m_time_s / (2.0 * static_cast<double>(half)) : 0.0;
    const double force_N = m_forceSum_N / count;
    const bool cuts = force_N > kLeastForce_N;
    const bool swings =
        cuts && m_amplitude_N > kLeastShare * force_N && most_N2 > kPeriodicPart * std::max(covariance_N2(0), 0.0);
    const bool calm = !cuts || m_amplitude_N < kOverShare * force_N;
    m_swinging = swings ? m_swinging + 1 : 0;
    m_calm = calm ? m_calm + 1 : 0;
    m_chatters = m_chatters ? m_calm < kWindows : m_swinging >= kWindows;
}

}  // namespace kerf::milling
