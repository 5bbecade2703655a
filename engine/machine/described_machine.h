// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/port/machine_description.h"
#include "engine/port/machine_port.h"

namespace kerf {

/// What the description says of a machine's capabilities: name, limits of the outputs, who hosts what. It takes away
/// and never adds.
void describe(Capabilities& capabilities, const MachineDescription& machine) noexcept;

/// Why this program would leave what the machine is described to have (travel, spindle speed); empty when it would not.
[[nodiscard]] std::optional<Sentence> whyOutside(const StartProgram& start, const MachineDescription& machine) noexcept;

/// A machine as its file describes it, in front of one that knows nothing of files. Starts beyond what is described are
/// answered here and never reach it.
class DescribedMachine final : public MachinePort {
 public:
    DescribedMachine(MachinePort& machine, MachineDescription description)
        : m_machine(machine), m_description(std::move(description)) {}

    void onlyRead() noexcept override { m_machine.onlyRead(); }
    [[nodiscard]] Result<void> endOtherClaim() override { return m_machine.endOtherClaim(); }
    [[nodiscard]] Result<void> connect() override;
    void disconnect() noexcept override { m_machine.disconnect(); }
    [[nodiscard]] const Capabilities& capabilities() const noexcept override { return m_capabilities; }
    void read(std::int64_t now_ns, MachineInputs& inputs) noexcept override;
    void write(const MachineOutputs& outputs) noexcept override;

 private:
    MachinePort& m_machine;
    MachineDescription m_description;
    Capabilities m_capabilities{};
    RequestReply m_refused{};       ///< number 0: none
    RequestReply m_machineReply{};  ///< newer than ours when it changes
};

}  // namespace kerf
