// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace kerf::milling {

/// How the feed that was measured follows the feed that was decided, learnt from both: late by 0 to 2 periods of the
/// law (a measurement that arrives late), and reached with a time constant of 0 to 3 periods (the axis).
///
///   f(i) = c + (v − c) s,  v' = c + (v − c) e^(−1/τ),  s = τ (1 − e^(−1/τ)),  c = decided(i − 1 − d)
///
/// with f the mean feed of a period, v the feed at its begin, v' at its end, τ in periods. Every pair (d, τ) of a grid
/// predicts each measured feed from the ones before; the errors are forgotten over some 60 periods. They count by their
/// logarithm (heavy tails): a few changes that the machine made at its own rate do not outweigh the many small ones.
/// Before there is evidence, and while none of them explains what happens: d = 0, τ = 0. Feeds in mm per period, ≥ 0.
/// All functions run in the cycle: no allocation, lock, throw or I/O.
class AxisFollow {
 public:
    static constexpr std::size_t kLates = 3;
    static constexpr std::size_t kLags = 8;

    /// What was measured of the last period, then what is decided for the coming one.
    void measured(double feed_mm) noexcept;
    void decided(double feed_mm) noexcept;
    /// Decided feeds of before say nothing about what comes (pause, another hand on the feed).
    void forget() noexcept { m_known = 0; }
    /// The period of the law is another one.
    void reset() noexcept { *this = AxisFollow(); }

    [[nodiscard]] std::size_t late() const noexcept { return m_best / kLags; }
    [[nodiscard]] double lag_periods() const noexcept;
    /// Periods that have passed, or are bound to, since the last one measured: late() of them, oldest first.
    [[nodiscard]] std::span<const double> pending_mm() const noexcept { return {m_pending_mm.data(), late()}; }
    /// Feed to decide so that the coming period makes `wanted_mm` on average.
    [[nodiscard]] double toMake_mm(double wanted_mm) const noexcept;

 private:
    struct Lag {
        double decay{0.0};  ///< e^(−1/τ)
        double share{0.0};  ///< s
    };
    [[nodiscard]] static Lag lagOf(std::size_t index) noexcept;
    [[nodiscard]] static double next_mm(const Lag& lag, double before_mm, double decidedBefore_mm,
                                        double decided_mm) noexcept;
    void learn(std::size_t late, double feed_mm) noexcept;
    void predictPending() noexcept;

    std::array<double, 4> m_decided_mm{};  ///< newest first
    std::size_t m_known{0};                ///< of them
    double m_measured_mm{0.0};
    bool m_hasMeasured{false};
    std::array<double, kLates * kLags> m_lnDoubt{};  ///< forgotten sums of ln(error² + what is usual)
    std::array<double, kLates * kLags> m_lnError{};  ///< the same of ln(error² + what does not count)
    double m_usual_mm2{1e-6};                        ///< error² of the best pair, as a geometric mean
    double m_count{0.0};
    std::size_t m_best{0};
    std::array<double, kLates> m_pending_mm{};
    double m_last_mm{0.0};         ///< newest of measured and pending
    double m_lastDecided_mm{0.0};  ///< what that one was made with
};

}  // namespace kerf::milling
