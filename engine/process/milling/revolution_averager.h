// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "engine/core/reading.h"
#include "engine/port/machine_port.h"

namespace kerf::milling {

/// The force of exactly one spindle revolution.
struct RevolutionForce {
    std::int64_t revolution{0};  ///< number of the revolution, floor of the spindle's accumulated angle at its begin
    std::int64_t begin_ns{0};    ///< interpolated times of the two once-per-revolution marks
    std::int64_t end_ns{0};
    double mean_N{0.0};        ///< average over the angle; valid while quality is Good
    double peak_N{0.0};        ///< highest sample
    double low_N{0.0};         ///< lowest sample
    double trustedShare{0.0};  ///< part of the revolution covered by good samples, 0…1
    Quality quality{Quality::Missing};

    [[nodiscard]] double duration_s() const noexcept { return static_cast<double>(end_ns - begin_ns) * 1e-9; }
};

/// Averages a sampled force over exactly one spindle revolution, by the spindle's angle and not by a clock: tooth and
/// run-out ripple cancel, whatever the speed does. What the paper's integrator did, read and reset by the spindle mark.
///
///   mean = ∫ F dφ over one revolution, φ the spindle's angle in revolutions, F linear between samples; the two marks
///   lie between samples and are interpolated.
///
/// Range 60…12,000 rpm at 5 kHz (25 samples per revolution at the top). A revolution is Good when at least 95 % of its
/// angle is covered by good samples no further than 1/8 revolution apart and the samples are not all the same number
/// (a stuck sensor shows Bad); else it carries the worst quality seen. An angle that runs backwards by less than a
/// revolution is waited out (the marks are not passed twice); a jump starts afresh. Sign: as the samples.
/// add() runs in the cycle: no allocation, lock, throw or I/O.
class RevolutionAverager {
 public:
    struct Params {
        double minTrustedShare{0.95};
        double maxGap_rev{0.125};
        double stuckBand_N{0.0};   ///< a whole revolution within this band is a stuck sensor, unless near zero
        double stuckAbove_N{1.0};  ///< below: the tool is out of the work and the force may well be constant
    };
    RevolutionAverager() noexcept = default;
    explicit RevolutionAverager(const Params& params) noexcept : m_params(params) {}

    /// Next sample in time order; the finished revolution when its mark lies between the last sample and this one.
    [[nodiscard]] std::optional<RevolutionForce> add(const FastSample& sample) noexcept;
    void reset() noexcept;
    /// Angle since the last mark that finished a revolution, 0…1 (more when samples stay away).
    [[nodiscard]] double progress_rev() const noexcept {
        return m_started ? m_last.spindleAngle_rev - m_mark_rev : 0.0;
    }

 private:
    void startAt(double mark_rev, std::int64_t time_ns) noexcept;
    void accumulate(double from_rev, double to_rev, double from_N, double to_N, bool trusted) noexcept;
    void note(const FastSample& sample) noexcept;
    [[nodiscard]] RevolutionForce finish(std::int64_t end_ns) const noexcept;

    Params m_params{};
    bool m_started{false};
    bool m_marked{false};  ///< a mark has been passed: the sum belongs to a revolution from its begin
    FastSample m_last{};
    double m_mark_rev{0.0};
    std::int64_t m_begin_ns{0};
    double m_sum_Nrev{0.0};
    double m_trusted_rev{0.0};
    double m_peak_N{0.0};
    double m_low_N{0.0};
    bool m_any{false};
    Quality m_worst{Quality::Good};
};

}  // namespace kerf::milling
