// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "engine/port/machine_port.h"

namespace kerf::milling {

/// Sees the onset of chatter in the raw force: energy at frequencies that are no multiple of the spindle's.
///
///   r(φ) = F(φ) − g F(φ − 1)      φ in revolutions; g the mean of the last tooth's pitch over the same a revolution
///   ago A² = max_k min(−R(k), R(2k))  R the autocovariance of r, k in samples: half a period of what swings
///
/// A cut that repeats itself leaves nothing in r, whatever teeth, run-out or a missing flute do; depth that changes is
/// in g. Noise of a sensor has no period, so it does not reach A. Chatter: in three windows running (whole revolutions,
/// 256 samples at least) A is at least 4 % of the mean force and A² three tenths of the variance of r; it is over when
/// A is half of that in three running.
///
/// Range: 2 to 40 samples per period, so 125 to 2500 Hz at 5 kHz; up to 8192 samples a revolution. A frequency within
/// 3 % of the spindle's from one of its multiples is not seen. A is that of r: for a steady swing of amplitude a it is
/// √2 a |sin(π f T)|. Forces in N. All functions run in the cycle: no allocation, lock, throw or I/O.
class ChatterWatch {
 public:
    void begin(int flutes) noexcept;
    void add(const FastSample& sample) noexcept;

    [[nodiscard]] bool chatters() const noexcept { return m_chatters; }
    /// Of the last window.
    [[nodiscard]] double amplitude_N() const noexcept { return m_amplitude_N; }
    /// Half a sample exact; 0 until something swings.
    [[nodiscard]] double frequency_Hz() const noexcept { return m_frequency_Hz; }

 private:
    struct Pitch {
        double now_N{0.0}, then_N{0.0};
    };
    void forget() noexcept;
    void takeDifference(double difference_N) noexcept;
    void judge() noexcept;
    void newWindow() noexcept;

    static constexpr std::size_t kKept = 8192;
    static constexpr std::size_t kLags = 41;  ///< R(0) … R(40)
    int m_flutes{4};
    std::array<double, kKept> m_angle_rev{};  ///< a ring
    std::array<float, kKept> m_force_N{};
    std::size_t m_taken{0};  ///< samples since the last gap
    std::size_t m_then{0};   ///< the last one not after the angle one revolution ago
    std::int64_t m_last_ns{0};
    std::int64_t m_tooth{0};
    Pitch m_pitch{};                             ///< sums over the present tooth's pitch
    double m_gain{1.0};                          ///< g
    std::array<double, kLags> m_difference_N{};  ///< r, a ring
    std::size_t m_differences{0};
    double m_windowFrom_rev{0.0};
    double m_sum_N{0.0};  ///< of r in this window
    double m_forceSum_N{0.0};
    double m_time_s{0.0};
    std::size_t m_count{0};
    std::array<double, kLags> m_products_N2{};
    int m_swinging{0}, m_calm{0};  ///< windows running
    bool m_chatters{false};
    double m_amplitude_N{0.0};
    double m_frequency_Hz{0.0};
};

}  // namespace kerf::milling
