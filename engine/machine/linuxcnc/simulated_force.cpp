// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/machine/linuxcnc/simulated_force.h"

#include <cmath>

namespace kerf::linuxcnc {

SimulatedForce::SimulatedForce() {
    constexpr double kStairs_mm[] = {1.0, 2.0, 3.0, 2.0, 1.0};
    constexpr double kStair_mm = 20.0;
    m_blank =
        milling::BlankProfile::ofSegments(kStairs_mm, kStair_mm).value_or(milling::BlankProfile{}).inAir(true, true);
}

void SimulatedForce::begin(double axis_mm, double spindle_rev, std::int64_t now_ns) noexcept {
    m_cut.begin(m_plant, m_blank, m_plant.cuttingCoefficient, axis_mm);
    m_lastAngle_rev = spindle_rev;
    m_last_ns = now_ns;
}

void SimulatedForce::step(double axis_mm, double spindle_rev, bool cutting, std::int64_t now_ns,
                          MachineInputs& inputs) noexcept {
    const double before_N = m_cut.force_N();
    const double turned_rev = spindle_rev - m_lastAngle_rev;
    if (cutting) {
        m_cut.step(axis_mm - m_cut.axis_mm(), turned_rev, 1.0);
    } else {
        m_cut.begin(m_plant, m_blank, m_plant.cuttingCoefficient, axis_mm);
    }
    for (std::size_t i = 0; i < kSamplesPerCycle; ++i) {
        const double share = static_cast<double>(i + 1) / static_cast<double>(kSamplesPerCycle);
        FastSample& sample = inputs.fast[i];
        sample.spindleAngle_rev = m_lastAngle_rev + turned_rev * share;
        sample.stamp_ns = now_ns - static_cast<std::int64_t>((1.0 - share) * static_cast<double>(now_ns - m_last_ns));
        sample.force_N =
            milling::sampledForce_N(m_shape, std::lerp(before_N, m_cut.force_N(), share), sample.spindleAngle_rev) +
            kSampleNoise_N * m_noise.gauss();
        sample.quality = Quality::Good;
    }
    inputs.fastCount = kSamplesPerCycle;
    m_lastAngle_rev = spindle_rev;
    m_last_ns = now_ns;
}

}  // namespace kerf::linuxcnc
