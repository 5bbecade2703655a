// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/machine/linuxcnc/fitted.h"

#include <algorithm>
#include <string_view>

namespace kerf::linuxcnc {
namespace {

void set(Capability& capability, bool fitted, const Sentence& why) {
    capability.fitted = fitted;
    capability.why = fitted ? Sentence{} : why;
}

}  // namespace

Capabilities capabilitiesOf(const std::optional<Fitted>& fitted) noexcept {
    const bool known = fitted.has_value();
    const Fitted machine = fitted.value_or(Fitted{});
    const Sentence unknown(KERF_TEXT("LinuxCNC has not been reached yet: what it can do is not known."));
    const auto why = [&](const Sentence& reason) { return known ? reason : unknown; };

    Capabilities c;
    constexpr std::string_view kName = "LinuxCNC";
    std::ranges::copy(kName, c.machineName.begin());
    c.maxFeedScale = machine.maxFeedScale;
    set(c.feedScale, true, {});
    set(c.cycleStart, true, {});
    set(c.workOffset, machine.externalOffsets || machine.originShift,
        why(Sentence(KERF_TEXT("This LinuxCNC has no external offsets: set OFFSET_AV_RATIO in its ini."))));
    set(c.servoGains, machine.servoGains,
        why(Sentence(KERF_TEXT("The gains of Z cannot be set on this LinuxCNC: add kerf-tapping.hal."))));
    set(c.forceSensor, machine.simulator,
        why(Sentence(KERF_TEXT("This LinuxCNC brings no cutting force: no sensor is connected."))));
    const Sentence noSignal = why(Sentence(KERF_TEXT("This LinuxCNC brings no such signal over HAL.")));
    for (Capability* capability : {&c.temperatures, &c.gapSensors, &c.toolMotion, &c.zTrim, &c.toolTrim, &c.gauge}) {
        set(*capability, false, noSignal);
    }
    const auto host = [&c](ProcessId id) -> Capability& { return c.process[static_cast<std::size_t>(id)]; };
    set(host(ProcessId::Boring), true, {});
    // What is not known yet is not ruled out: a mode kept from yesterday waits for the machine.
    set(host(ProcessId::Milling), !known || c.forceSensor.fitted, c.forceSensor.why);
    set(host(ProcessId::Tapping), !known || (machine.servoGains && machine.servoRecord), c.servoGains.why);
    set(host(ProcessId::Thermal), false,
        why(Sentence(KERF_TEXT("This LinuxCNC brings no temperatures: without them nothing can be predicted."))));
    set(host(ProcessId::Turning), false,
        why(Sentence(KERF_TEXT("Diamond turning trims the tool every 0.2 ms; this control moves once per ms."))));
    if (known && machine.units != MachineUnits::Millimetre) {
        refuseAll(
            c, machine.units == MachineUnits::Inch
                   ? Sentence(KERF_TEXT("This LinuxCNC counts in inches ([TRAJ]LINEAR_UNITS): Kerf commands machines "
                                        "in mm only, and reads this one."))
                   : Sentence(KERF_TEXT("The units of this LinuxCNC are not known ([TRAJ]LINEAR_UNITS): Kerf "
                                        "commands nothing before it knows them.")));
    }
    return c;
}

void refuseAll(Capabilities& c, const Sentence& why) noexcept {
    for (Capability* capability : {&c.feedScale, &c.workOffset, &c.servoGains, &c.zTrim, &c.toolTrim, &c.cycleStart}) {
        set(*capability, false, why);
    }
    for (Capability& host : c.process) {
        set(host, false, why);
    }
}

}  // namespace kerf::linuxcnc
