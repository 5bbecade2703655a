// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "engine/machine/linuxcnc/link_memory.h"
#include "engine/port/machine_description.h"
#include "engine/port/machine_port.h"

namespace kerf::linuxcnc {

/// The force pin of every servo period as samples of the port: newtons, with the quality they deserve.
///
///   Bad        the amplifier's own fault bit, not a number, or the same number for .1 s and five times 1/bandwidth:
///              what stands so still is frozen. A sample that is Bad carries no number (0)
///   Saturated  at the end of the described range
///
/// Sign as described by the scale: into the work is positive. next() runs in the cycle.
class ForceSamples {
 public:
    explicit ForceSamples(const DescribedForce& described) noexcept : m_described(described) {}

    void fit(double servoPeriod_s, double bandwidth_Hz) noexcept {
        const double still_s = std::max(kStill_s, bandwidth_Hz > 0.0 ? kStillCycles / bandwidth_Hz : 0.0);
        m_stillPeriods = std::lround(still_s / std::max(servoPeriod_s, 1e-6));
    }
    [[nodiscard]] FastSample next(const ServoPeriod& period, std::int64_t now_ns) noexcept {
        FastSample sample;
        sample.stamp_ns = std::min(period.stamp_ns, now_ns);
        sample.spindleAngle_rev = period.spindle_rev;
        const double force_N = period.force * m_described.scale_NPerUnit;
        m_same = period.force == m_last ? m_same + 1 : 0;
        m_last = period.force;
        const bool sound = std::isfinite(force_N) && !period.forceFault && m_same < m_stillPeriods;
        const bool end = sound && m_described.range_N && std::abs(force_N) >= *m_described.range_N;
        sample.quality = !sound ? Quality::Bad : end ? Quality::Saturated : Quality::Good;
        sample.force_N = sound ? force_N : 0.0;
        return sample;
    }

 private:
    static constexpr double kStill_s = 0.1;
    static constexpr double kStillCycles = 5.0;

    DescribedForce m_described;
    long m_stillPeriods{100};
    long m_same{0};
    double m_last{0.0};
};

}  // namespace kerf::linuxcnc
