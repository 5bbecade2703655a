// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "engine/api/command.h"
#include "engine/core/alarm.h"
#include "engine/core/process.h"
#include "engine/limits/loop_outputs.h"
#include "engine/port/machine_port.h"

namespace kerf {

struct PartRecord;
struct Status;
struct Sample;
struct EventSink;

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
    /// The alarms this loop can raise; the array lives as long as the program.
    [[nodiscard]] virtual std::span<const AlarmSpec> alarms() const noexcept = 0;
    /// A command for this process, already numbered. Refusal carries the operator's sentence.
    [[nodiscard]] virtual CommandResult handle(const Command& command) noexcept = 0;
    /// The mode asked by the operator. Off and Advise must be bumpless at once.
    virtual void setMode(LoopMode mode) noexcept = 0;
    /// One cycle, in every mode. `outputs` arrives empty; unless the mode is Control, the cycle discards what the loop
    /// puts there (so advising runs exactly the code of controlling), but for stops and what tells of them.
    /// inputs.stops are those that stand, whoever keeps them. A verdict of Faulted is a stop, too.
    [[nodiscard]] virtual LoopVerdict step(const MachineInputs& inputs, const Capabilities& capabilities,
                                           LoopOutputs& outputs, EventSink& events) noexcept = 0;
    /// Whose work the next part is. A part that was being cut when the engine started is of the order named first.
    void nameOrder(const WorkOrder& order) noexcept;
    [[nodiscard]] const WorkOrder& order() const noexcept { return m_order; }
    /// Copy the loop's own figures into its part of the status.
    virtual void report(Status& status) const noexcept = 0;
    /// Put the loop's own figures into a chart sample; called about 100 times a second.
    virtual void sample(Sample& sample) const noexcept = 0;

 protected:
    /// A part begins: what every record has, and its order, which is the one in force now.
    [[nodiscard]] PartRecord beginRecord(const MachineInputs& inputs) noexcept;
    void beginOrder() noexcept;
    /// The part has ended: the record gets its order back and goes to the database.
    void finishRecord(PartRecord& part, std::int64_t now_ns, bool complete, EventSink& events) noexcept;

 private:
    WorkOrder m_order{};
    WorkOrder m_partOrder{};
    bool m_named{false};
    bool m_inPart{false};
};

}  // namespace kerf
