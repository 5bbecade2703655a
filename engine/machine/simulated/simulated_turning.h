// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "engine/core/random.h"
#include "engine/machine/simulated/simulated_process.h"
#include "engine/process/turning/plant.h"
#include "engine/process/turning/tones.h"

namespace kerf {

/// Diamond turning slide of the simulated machine: faces from one place to the other at the programmed feed, with the
/// physical plant (x_i = d_a − w, force the process of the chip) in samples of .2 ms.
///
///   air (.3 s) → touch, depth built up within a revolution → cut → depth back to zero → air (.2 s) → finished
///
/// The tool trim acts in the next sample: positive moves the tool into the work. Force: process + residual + drift +
/// noise, missing out of connection. The cycle must be .2 ms; with a longer one the plant runs several samples per
/// cycle, the trim is held in between, and the loop refuses to act.
class SimulatedTurning final : public SimulatedProcess {
 public:
    struct Params {
        std::uint64_t seed{1};
        turning::ProcessParams process{};
        double white_um{0.05};
        double forceNoise_N{0.005};
        double residualForce_N{0.08};
        double drift_NPerS{0.0005};
        double motionSensorNoise_um{0.0};  ///< > 0: a sensor shows the tool's motion (toolMotion_um)
        double forceRange_N{20.0};
    };
    explicit SimulatedTurning(const Params& params) noexcept;

    [[nodiscard]] ProcessId id() const noexcept override { return ProcessId::Turning; }
    void fit(Capabilities& capabilities) const override;
    [[nodiscard]] Result<void> begin(const StartProgram& program, std::uint32_t partSequence) noexcept override;
    void abort() noexcept override { m_running = false; }
    bool advance(const SimulationStep& step, MachineInputs& inputs) noexcept override;

    /// True motion of the tool in the last sample, for tests.
    [[nodiscard]] double inner_um() const noexcept { return m_inner_um; }
    /// A chip breaks off the edge: the process's gain jumps by this factor. Tests and the fault panel, same thread.
    void chipTool(double factor) noexcept { m_chip = factor; }
    /// The disturbance grows by this factor.
    void shake(double factor) noexcept { m_shake = factor; }

 private:
    [[nodiscard]] double disturbance_um() noexcept;

    Params m_params;
    Random m_random;
    turning::Plant m_plant;
    StartProgram m_program{};
    double m_time_s{0.0};  ///< of the plant, never reset: phases go on
    double m_programTime_s{0.0};
    double m_position_mm{0.0};
    double m_depth_um{0.0};
    double m_drift_N{0.0};
    double m_trim_um{0.0};
    double m_inner_um{0.0};
    double m_chip{1.0};
    double m_shake{1.0};
    double m_air_s{0.0};
    double m_owed_s{0.0};
    bool m_cutDone{false};
    bool m_running{false};
    Reading m_lastForce_N{};
};

}  // namespace kerf
