// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "engine/core/random.h"
#include "engine/port/machine_port.h"
#include "engine/process/milling/moving_cut.h"
#include "engine/process/milling/sampled_force.h"

namespace kerf::linuxcnc {

/// A simulated force sensor on a simulated LinuxCNC: the milling plant moved by what the control reports, its position
/// along X and its spindle revolutions. Only for the simulator; a real machine brings a real sensor.
class SimulatedForce {
 public:
    SimulatedForce();

    /// A new cut begins at `axis_mm`; the blank is a stair of 1, 2, 3, 2, 1 mm over 100 mm, with air around it.
    void begin(double axis_mm, double spindle_rev, std::int64_t now_ns) noexcept;
    /// Fills `inputs.fast` from where the axis and the spindle have got to since the last call; `cutting` false: out of
    /// the work.
    void step(double axis_mm, double spindle_rev, bool cutting, std::int64_t now_ns, MachineInputs& inputs) noexcept;

 private:
    static constexpr std::size_t kSamplesPerCycle = 5;
    static constexpr double kSampleNoise_N = 5.0;

    milling::PlantParams m_plant{};
    milling::BlankProfile m_blank{};
    milling::ForceShape m_shape{};
    milling::MovingCut m_cut{};
    Random m_noise{1};
    double m_lastAngle_rev{0.0};
    std::int64_t m_last_ns{0};
};

}  // namespace kerf::linuxcnc
