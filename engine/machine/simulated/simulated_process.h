// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "engine/machine/simulated/injected_faults.h"
#include "engine/port/machine_port.h"

namespace kerf {

/// What the simulated machine knows beside the plants: the same for all of them in one step.
struct SimulationStep {
    double dt_s{0.0};
    std::int64_t now_ns{0};
    double feedFactor{1.0};        ///< feed scale × operator's knob, 0 in a feed hold
    double spindleFactor{1.0};     ///< 0 when the spindle is stopped
    double spindleAngle_rev{0.0};  ///< accumulated, at the begin of the step
    const MachineOutputs* outputs{nullptr};
    const InjectedFaults* faults{nullptr};
};

/// One process's plant inside the simulated machine: physics in the room, movement and signals here. All but the
/// constructor runs in the cycle.
class SimulatedProcess {
 public:
    SimulatedProcess() = default;
    SimulatedProcess(const SimulatedProcess&) = delete;
    SimulatedProcess& operator=(const SimulatedProcess&) = delete;
    virtual ~SimulatedProcess() = default;

    [[nodiscard]] virtual ProcessId id() const noexcept = 0;
    /// Add what this plant brings (sensors, outputs it obeys) to the machine's capabilities. Not in the cycle.
    virtual void fit(Capabilities& capabilities) const = 0;
    /// Refusal carries the reason.
    [[nodiscard]] virtual Result<void> begin(const StartProgram& program, std::uint32_t partSequence) noexcept = 0;
    virtual void abort() noexcept = 0;
    /// Requests of tapping; a plant that has none refuses.
    [[nodiscard]] virtual Result<void> setGains(const ServoGains&) noexcept {
        return fail(KERF_TEXT("This simulated machine does not have it."));
    }
    [[nodiscard]] virtual Result<void> retractInSync() noexcept {
        return fail(KERF_TEXT("This simulated machine does not have it."));
    }
    /// Work offset the control still has from before this program started; empty: nothing to say. Asked once, before
    /// the first step.
    [[nodiscard]] virtual std::optional<std::array<double, kAxisCount>> keptWorkOffset_um() const noexcept {
        return std::nullopt;
    }
    /// Something of this process stands in the work and its program does not run.
    [[nodiscard]] virtual bool standsInWork() const noexcept { return false; }
    /// Alarm that tells of it.
    [[nodiscard]] virtual AlarmCode inWorkAlarm() const noexcept { return 0; }
    /// A person has taken out what stood in the work.
    virtual void takenOut() noexcept {}
    /// Advance by step.dt_s and fill (inputs.spindleAngle_rev arrives with the angle so far; a plant that knows the
    /// angle itself sets it) this process's signals; called every step, cutting or not. Returns true while its program
    /// runs.
    virtual bool advance(const SimulationStep& step, MachineInputs& inputs) noexcept = 0;
};

/// A reading of a simulated signal, with the injected fault applied. `stuck` keeps the value the fault began with.
[[nodiscard]] Reading simulatedReading(double value, std::int64_t now_ns, SignalFault fault, Reading previous) noexcept;

}  // namespace kerf
