// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "engine/api/command.h"
#include "engine/core/alarm.h"
#include "engine/core/process.h"
#include "engine/machine/machine_port.h"

namespace kerf {

struct Status;
struct EventSink;

/// What one loop would like in this cycle. Empty fields leave the machine as it is. engine/limits decides.
struct LoopOutputs {
    std::optional<double> feedScale{};
    bool feedHold{false};
    std::array<std::optional<double>, kAxisCount> workOffset_um{};
    std::optional<double> toolTrim_um{};
    PortRequest request{};  ///< number is filled by the cycle
};

/// The state of a loop with the sentence that says why.
struct LoopVerdict {
    LoopState state{LoopState::Off};
    Sentence reason{};
};

/// Binds one law to the machine port: states, alarms, commands. One object per process, owned by the cycle.
///
/// All methods run in the cycle: no allocation, lock, throw, log or I/O. Time comes with the inputs.
class ProcessLoop {
   public:
    ProcessLoop() = default;
    ProcessLoop(const ProcessLoop&) = delete;
    ProcessLoop& operator=(const ProcessLoop&) = delete;
    virtual ~ProcessLoop() = default;

    [[nodiscard]] virtual ProcessId id() const noexcept = 0;
    /// A command for this process, already numbered. Refusal carries the operator's sentence.
    [[nodiscard]] virtual CommandResult handle(const Command& command) noexcept = 0;
    /// The mode asked by the operator. Off and Advise must be bumpless at once.
    virtual void setMode(LoopMode mode) noexcept = 0;
    /// One cycle. `outputs` arrives empty; in Advise the cycle discards what the loop puts there.
    [[nodiscard]] virtual LoopVerdict step(const MachineInputs& inputs, const Capabilities& capabilities,
                                           LoopOutputs& outputs, EventSink& events) noexcept = 0;
    /// Copy the loop's own figures into its part of the status.
    virtual void report(Status& status) const noexcept = 0;
};

}  // namespace kerf
