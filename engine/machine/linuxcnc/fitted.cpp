// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/machine/linuxcnc/fitted.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace kerf::linuxcnc {
namespace {

void set(Capability& capability, bool fitted, const Sentence& why) {
    capability.fitted = fitted;
    capability.why = fitted ? Sentence{} : why;
}

constexpr double kUnstatedDrift_NPerS = 0.05;
constexpr double kSimulatedRate_Hz = 5000.0;  // SimulatedForce

/// The signal that the bridge hands over; a bandwidth of 0: nobody has stated one.
ForceSignal signalOf(const Fitted& machine, const DescribedForce& described) noexcept {
    ForceSignal signal;
    const double rate_Hz = 1.0 / std::max(machine.servoPeriod_s, 1e-6);
    if (!machine.forceLinked) {
        signal.rate_Hz = kSimulatedRate_Hz;
        signal.bandwidth_Hz = 0.5 * rate_Hz;  // it looks at the axis once per servo period
        return signal;
    }
    signal.rate_Hz = rate_Hz;
    const bool inHal = std::isfinite(machine.forceBandwidth_Hz) && machine.forceBandwidth_Hz > 0.0;
    if (inHal || described.bandwidth_Hz) {
        signal.bandwidth_Hz = 0.5 * rate_Hz;
        signal.bandwidth_Hz = inHal ? std::min(signal.bandwidth_Hz, machine.forceBandwidth_Hz) : signal.bandwidth_Hz;
        signal.bandwidth_Hz = std::min(signal.bandwidth_Hz, described.bandwidth_Hz.value_or(signal.bandwidth_Hz));
    }
    signal.zeroInAir = described.zeroInAir;
    signal.drift_NPerS = described.zeroInAir ? described.drift_NPerS.value_or(kUnstatedDrift_NPerS) : 0.0;
    signal.reset_s = described.reset_s;
    return signal;
}

}  // namespace

Capabilities capabilitiesOf(const std::optional<Fitted>& fitted, const DescribedForce& force) noexcept {
    const bool known = fitted.has_value();
    const Fitted machine = fitted.value_or(Fitted{});
    const Sentence unknown(KERF_TEXT("LinuxCNC has not been reached yet: what it can do is not known."));
    const auto why = [&](const Sentence& reason) { return known ? reason : unknown; };

    Capabilities c;
    constexpr std::string_view kName = "LinuxCNC";
    std::ranges::copy(kName, c.machineName.begin());
    c.maxFeedScale = machine.maxFeedScale;
    // A bridge that comes late must not leave the highest feed behind; what is not known yet is not ruled out.
    set(c.feedScale, !known || machine.lossScale,
        Sentence(KERF_TEXT("kerf.loss-scale is not linked: a bridge that comes late would leave the highest feed. Take "
                           "kerf.hal of this version.")));
    set(c.cycleStart, true, {});
    set(c.workOffset, machine.externalOffsets || machine.originShift,
        why(Sentence(KERF_TEXT("This LinuxCNC has no external offsets: set OFFSET_AV_RATIO in its ini."))));
    set(c.servoGains, machine.servoGains,
        why(Sentence(KERF_TEXT("The gains of Z cannot be set on this LinuxCNC: add kerf-tapping.hal."))));
    c.force = signalOf(machine, force);
    const bool sampled = !machine.forceLinked || machine.force;
    set(c.forceSensor, machine.forceLinked ? machine.force && c.force.bandwidth_Hz > 0.0 : machine.simulator,
        why(!machine.forceLinked ? Sentence(KERF_TEXT("This LinuxCNC brings no cutting force: no sensor is connected."))
            : !sampled ? Sentence(KERF_TEXT("kerf.force is linked, but sampler.0.pin.6 is not linked to the same "
                                            "signal: take kerf.hal of this version and kerf-force.hal."))
                       : Sentence(KERF_TEXT("The bandwidth of the force signal is not stated: set "
                                            "kerf.force-bandwidth, or force.bandwidth_hz in the machine file."))));
    set(c.forceReset, machine.forceReset,
        why(Sentence(KERF_TEXT("kerf.force-reset is not linked: the amplifier is not reset by Kerf."))));
    const Sentence noSignal = why(Sentence(KERF_TEXT("This LinuxCNC brings no such signal over HAL.")));
    for (Capability* capability : {&c.temperatures, &c.gapSensors, &c.toolMotion, &c.zTrim, &c.toolTrim, &c.gauge}) {
        set(*capability, false, noSignal);
    }
    const auto host = [&c](ProcessId id) -> Capability& { return c.process[static_cast<std::size_t>(id)]; };
    for (std::size_t place = 0; place < kProcessPlaces; ++place) {
        set(c.process[place], false, why(Sentence(KERF_TEXT("Kerf does not know this process on a LinuxCNC."))));
    }
    set(host(ProcessId::Boring), c.feedScale.fitted, c.feedScale.why);
    // What is not known yet is not ruled out: a mode kept from yesterday waits for the machine.
    set(host(ProcessId::Milling), !known || (c.feedScale.fitted && c.forceSensor.fitted),
        c.feedScale.fitted ? c.forceSensor.why : c.feedScale.why);
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
    for (Capability* capability :
         {&c.feedScale, &c.workOffset, &c.servoGains, &c.zTrim, &c.toolTrim, &c.cycleStart, &c.forceReset}) {
        set(*capability, false, why);
    }
    for (Capability& host : c.process) {
        set(host, false, why);
    }
}

}  // namespace kerf::linuxcnc
