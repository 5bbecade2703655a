// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "engine/core/random.h"
#include "engine/machine/simulated/simulated_process.h"
#include "engine/process/tapping/tap_drive.h"
#include "engine/process/tapping/tapping_alarms.h"

namespace kerf {

/// Tapping spindle and Z of the simulated machine: tapping::TapDrive behind the port, one tick per millisecond of
/// machine time. Z counts down into the hole, as on a real machine. Each tap's load and friction scatter; the recorded
/// Z has noise. Signals of a cycle are those before its tick; a trim written in one cycle acts in the next.
class SimulatedTapping final : public SimulatedProcess {
 public:
    struct Params {
        tapping::DriveParams drive{};
        double programPitch_mm{0.0};  ///< > 0: the control's own program has another pitch than the one asked
        double noise_um{0.0};
        double loadSpread{0.0};  ///< each tap's load is scaled by 1 ± this
        double frictionSpread{0.0};
        std::uint64_t seed{1};
    };
    explicit SimulatedTapping(const Params& params);

    [[nodiscard]] ProcessId id() const noexcept override { return ProcessId::Tapping; }
    void fit(Capabilities& capabilities) const override;
    [[nodiscard]] Result<void> begin(const StartProgram& program, std::uint32_t partSequence) noexcept override;
    /// Both axes stop where they are, power off.
    void abort() noexcept override;
    [[nodiscard]] Result<void> setGains(const ServoGains& gains) noexcept override;
    [[nodiscard]] Result<void> retractInSync() noexcept override;
    [[nodiscard]] bool standsInWork() const noexcept override;
    [[nodiscard]] AlarmCode inWorkAlarm() const noexcept override { return tapping_alarm::kInHole; }
    void takenOut() noexcept override;
    bool advance(const SimulationStep& step, MachineInputs& inputs) noexcept override;

 private:
    void tick(const MachineOutputs& outputs) noexcept;
    [[nodiscard]] tapping::TapTrajectory::Point retractCommand() noexcept;

    Params m_params;
    tapping::DriveParams m_gains;  ///< the drive with the gains set last
    tapping::TapTrajectory m_path;
    tapping::TapDrive m_drive;
    tapping::TapTrajectory::Point m_command{};
    Random m_scatter;
    Random m_noise;
    double m_angleZero_rev{0.0};
    double m_owed_s{0.0};
    std::int64_t m_ticks{0};
    std::int64_t m_lastTick{0};  ///< ends the program
    bool m_running{false};
    bool m_retracting{false};
    Reading m_lastAngle_rev{};
};

}  // namespace kerf
