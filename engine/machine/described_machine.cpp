// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/machine/described_machine.h"

#include <algorithm>

namespace kerf {
namespace {

constexpr std::size_t kX = 0;
constexpr std::size_t kZ = 2;

double travel_mm(const AxisTravel& axis) {
    return axis.high_mm - axis.low_mm;
}

}  // namespace

void describe(Capabilities& capabilities, const MachineDescription& machine) noexcept {
    if (!machine.name.empty()) {
        capabilities.machineName = {};
        std::copy_n(machine.name.begin(), std::min(machine.name.size(), capabilities.machineName.size() - 1),
                    capabilities.machineName.begin());
    }
    capabilities.limits = machine.limits;
    if (machine.force.bandwidth_Hz && capabilities.force.bandwidth_Hz > 0.0) {
        capabilities.force.bandwidth_Hz = std::min(capabilities.force.bandwidth_Hz, *machine.force.bandwidth_Hz);
    }
    for (std::size_t i = 0; i < kProcessPlaces; ++i) {
        if (!machine.hosts[i] && capabilities.process[i].fitted) {
            capabilities.process[i] = {false,
                                       Sentence(KERF_TEXT("The machine file does not name this process under hosts."))};
        }
    }
}

std::optional<Sentence> whyOutside(const StartProgram& start, const MachineDescription& machine) noexcept {
    if (machine.highestSpeed_rpm && start.spindleSpeed_rpm > *machine.highestSpeed_rpm) {
        return Sentence(KERF_TEXT("The program wants %1 rpm; the machine file allows the spindle %2 rpm."),
                        SentenceArg(start.spindleSpeed_rpm, 0), SentenceArg(*machine.highestSpeed_rpm, 0));
    }
    const auto beyond = [](double length_mm, const AxisTravel& axis) {
        return Sentence(KERF_TEXT("The program is %1 mm long; the machine file gives this axis %2 mm."),
                        SentenceArg(length_mm, 1), SentenceArg(travel_mm(axis), 1));
    };
    const double length_mm = start.to_mm - start.from_mm;
    if (start.process == ProcessId::Milling && machine.axes[kX] && length_mm > travel_mm(*machine.axes[kX])) {
        return beyond(length_mm, *machine.axes[kX]);
    }
    if (!machine.axes[kZ]) {
        return std::nullopt;
    }
    const AxisTravel& z = *machine.axes[kZ];
    if (start.process == ProcessId::Tapping && start.pitch_mm * start.revolutions > travel_mm(z)) {
        return beyond(start.pitch_mm * start.revolutions, z);
    }
    if (start.process != ProcessId::Boring) {
        return std::nullopt;
    }
    if (length_mm > travel_mm(z)) {
        return beyond(length_mm, z);
    }
    if (machine.overhangAtZ0_mm &&
        (*machine.overhangAtZ0_mm - start.to_mm < z.low_mm || *machine.overhangAtZ0_mm - start.from_mm > z.high_mm)) {
        return Sentence(KERF_TEXT("Overhangs from %1 to %2 mm lie beyond what Z reaches by the machine file."),
                        SentenceArg(start.from_mm, 1), SentenceArg(start.to_mm, 1));
    }
    return std::nullopt;
}

Result<void> DescribedMachine::connect() {
    const auto connected = m_machine.connect();
    m_capabilities = m_machine.capabilities();
    describe(m_capabilities, m_description);
    return connected;
}

void DescribedMachine::read(std::int64_t now_ns, MachineInputs& inputs) noexcept {
    m_machine.read(now_ns, inputs);
    if (inputs.reply.number != m_machineReply.number || inputs.reply.state != m_machineReply.state) {
        m_machineReply = inputs.reply;
        m_refused = {};
    }
    if (m_refused.number != 0) {
        inputs.reply = m_refused;
    }
}

void DescribedMachine::write(const MachineOutputs& outputs) noexcept {
    const auto* start = std::get_if<StartProgram>(&outputs.request.action);
    const auto why = start != nullptr ? whyOutside(*start, m_description) : std::nullopt;
    if (!why) {
        m_machine.write(outputs);
        return;
    }
    m_refused = {outputs.request.number, RequestState::Refused, *why};
    MachineOutputs rest = outputs;
    rest.request = PortRequest{};
    m_machine.write(rest);
}

}  // namespace kerf
