// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/rehearsal/faults.h"

#include <algorithm>
#include <initializer_list>

namespace kerf::rehearsal {
namespace {

template <SignalFault InjectedFaults::*Signal, SignalFault Fault>
void setSignal(InjectedFaults& faults, const Event& /*event*/) {
    faults.*Signal = Fault;
}

template <bool InjectedFaults::*Flag, bool On>
void setFlag(InjectedFaults& faults, const Event& /*event*/) {
    faults.*Flag = On;
}

template <double InjectedFaults::*Number>
void setNumber(InjectedFaults& faults, const Event& event) {
    faults.*Number = event.value;
}

template <CoupleFaultKind Kind>
void setCouple(InjectedFaults& faults, const Event& event) {
    auto place = std::ranges::find_if(faults.couples, [&](const CoupleFault& fault) {
        return fault.kind != CoupleFaultKind::None && fault.couple == event.channel;
    });
    if (place == faults.couples.end()) {
        place = std::ranges::find(faults.couples, CoupleFaultKind::None, &CoupleFault::kind);
    }
    if (place != faults.couples.end()) {
        *place = {event.channel, Kind};
    }
}

constexpr FaultSpec kSpecs[] = {
    {"force_missing", FaultNeeds::Nothing, setSignal<&InjectedFaults::force, SignalFault::Unplugged>},
    {"force_stale", FaultNeeds::Nothing, setSignal<&InjectedFaults::force, SignalFault::Stale>},
    {"force_stuck", FaultNeeds::Nothing, setSignal<&InjectedFaults::force, SignalFault::Stuck>},
    {"force_saturated", FaultNeeds::Nothing, setSignal<&InjectedFaults::force, SignalFault::Saturated>},
    {"force_not_a_number", FaultNeeds::Nothing, setSignal<&InjectedFaults::force, SignalFault::NotANumber>},
    {"force_collapsed", FaultNeeds::Nothing, setSignal<&InjectedFaults::force, SignalFault::Collapsed>},
    {"force_ok", FaultNeeds::Nothing, setSignal<&InjectedFaults::force, SignalFault::None>},
    {"tool_broken", FaultNeeds::Nothing, setFlag<&InjectedFaults::toolBroken, true>},
    {"flute_chipped", FaultNeeds::Nothing, setFlag<&InjectedFaults::fluteChipped, true>},
    {"tool_changed", FaultNeeds::Nothing, setFlag<&InjectedFaults::toolBroken, false>},
    {"link_down", FaultNeeds::Nothing, setFlag<&InjectedFaults::linkDown, true>},
    {"link_up", FaultNeeds::Nothing, setFlag<&InjectedFaults::linkDown, false>},
    {"emergency_stop", FaultNeeds::Nothing, setFlag<&InjectedFaults::emergencyStop, true>},
    {"emergency_stop_reset", FaultNeeds::Nothing, setFlag<&InjectedFaults::emergencyStop, false>},
    {"machine_off", FaultNeeds::Nothing, setFlag<&InjectedFaults::machineOff, true>},
    {"machine_on", FaultNeeds::Nothing, setFlag<&InjectedFaults::machineOff, false>},
    {"operator_hold", FaultNeeds::Nothing, setFlag<&InjectedFaults::operatorFeedHold, true>},
    {"operator_resume", FaultNeeds::Nothing, setFlag<&InjectedFaults::operatorFeedHold, false>},
    {"override", FaultNeeds::Value, setNumber<&InjectedFaults::operatorOverride>},
    {"spindle_override", FaultNeeds::Value, setNumber<&InjectedFaults::spindleOverride>},
    {"spindle_stopped", FaultNeeds::Nothing, setFlag<&InjectedFaults::spindleStopped, true>},
    {"spindle_turns", FaultNeeds::Nothing, setFlag<&InjectedFaults::spindleStopped, false>},
    {"spindle_speed_missing", FaultNeeds::Nothing, setSignal<&InjectedFaults::spindleSpeed, SignalFault::Unplugged>},
    {"spindle_speed_stale", FaultNeeds::Nothing, setSignal<&InjectedFaults::spindleSpeed, SignalFault::Stale>},
    {"spindle_speed_stuck", FaultNeeds::Nothing, setSignal<&InjectedFaults::spindleSpeed, SignalFault::Stuck>},
    {"spindle_speed_ok", FaultNeeds::Nothing, setSignal<&InjectedFaults::spindleSpeed, SignalFault::None>},
    {"feed_missing", FaultNeeds::Nothing, setSignal<&InjectedFaults::actualFeed, SignalFault::Unplugged>},
    {"feed_stale", FaultNeeds::Nothing, setSignal<&InjectedFaults::actualFeed, SignalFault::Stale>},
    {"feed_stuck", FaultNeeds::Nothing, setSignal<&InjectedFaults::actualFeed, SignalFault::Stuck>},
    {"feed_ok", FaultNeeds::Nothing, setSignal<&InjectedFaults::actualFeed, SignalFault::None>},
    {"overhang_missing", FaultNeeds::Nothing, setSignal<&InjectedFaults::overhang, SignalFault::Unplugged>},
    {"overhang_stale", FaultNeeds::Nothing, setSignal<&InjectedFaults::overhang, SignalFault::Stale>},
    {"overhang_stuck", FaultNeeds::Nothing, setSignal<&InjectedFaults::overhang, SignalFault::Stuck>},
    {"overhang_ok", FaultNeeds::Nothing, setSignal<&InjectedFaults::overhang, SignalFault::None>},
    {"temperatures_missing", FaultNeeds::Nothing, setSignal<&InjectedFaults::temperatures, SignalFault::Unplugged>},
    {"temperatures_ok", FaultNeeds::Nothing, setSignal<&InjectedFaults::temperatures, SignalFault::None>},
    {"gaps_missing", FaultNeeds::Nothing, setSignal<&InjectedFaults::gaps, SignalFault::Unplugged>},
    {"gaps_ok", FaultNeeds::Nothing, setSignal<&InjectedFaults::gaps, SignalFault::None>},
    {"work_offset_ignored", FaultNeeds::Nothing, setFlag<&InjectedFaults::workOffsetIgnored, true>},
    {"work_offset_obeyed", FaultNeeds::Nothing, setFlag<&InjectedFaults::workOffsetIgnored, false>},
    {"thermocouple_open", FaultNeeds::Channel, setCouple<CoupleFaultKind::Open>},
    {"thermocouple_short", FaultNeeds::Channel, setCouple<CoupleFaultKind::Short>},
    {"thermocouple_stuck", FaultNeeds::Channel, setCouple<CoupleFaultKind::Stuck>},
    {"thermocouple_offset", FaultNeeds::Channel, setCouple<CoupleFaultKind::Offset>},
    {"thermocouple_noisy", FaultNeeds::Channel, setCouple<CoupleFaultKind::Noisy>},
    {"thermocouple_ok", FaultNeeds::Channel, setCouple<CoupleFaultKind::None>},
    {"servo_signal_lost", FaultNeeds::Nothing, setSignal<&InjectedFaults::spindleAngle, SignalFault::Unplugged>},
    {"servo_signal_ok", FaultNeeds::Nothing, setSignal<&InjectedFaults::spindleAngle, SignalFault::None>},
    {kCycleStall, FaultNeeds::Seconds, nullptr},
    {kConsoleRestart, FaultNeeds::Nothing, nullptr},
};

}  // namespace

std::span<const FaultSpec> faultSpecs() noexcept {
    return kSpecs;
}

bool failsFor(ProcessId process, const InjectedFaults& faults) noexcept {
    const auto any = [](std::initializer_list<SignalFault> signals) {
        return std::ranges::any_of(signals, [](SignalFault fault) { return fault != SignalFault::None; });
    };
    switch (process) {
        case ProcessId::Boring:
            return any({faults.overhang, faults.spindleSpeed});
        case ProcessId::Milling:
            return any({faults.force, faults.actualFeed, faults.spindleSpeed});
        case ProcessId::Turning:
            return any({faults.force});
        case ProcessId::Tapping:
            return any({faults.spindleAngle});
        case ProcessId::Thermal:
            break;
    }
    return false;
}

bool concerns(std::string_view fault, ProcessId process) noexcept {
    const auto oneOf = [&](std::initializer_list<const char*> begins) {
        return std::ranges::any_of(begins, [&](const char* begin) { return fault.starts_with(begin); });
    };
    const bool mills = process == ProcessId::Milling;
    if (oneOf({"force_", "tool_"})) {
        return mills || process == ProcessId::Turning;
    }
    if (oneOf({"flute_"})) {
        return mills;
    }
    if (oneOf({"servo_signal_"})) {
        return mills || process == ProcessId::Tapping;
    }
    if (oneOf({"overhang_"})) {
        return process == ProcessId::Boring;
    }
    if (oneOf({"spindle_speed_", "feed_"})) {
        return mills || process == ProcessId::Boring || process == ProcessId::Thermal;
    }
    if (oneOf({"thermocouple_", "temperatures_", "gaps_", "work_offset_"})) {
        return process == ProcessId::Thermal;
    }
    return true;
}

const FaultSpec* findFault(std::string_view name) noexcept {
    const auto* const found = std::ranges::find_if(kSpecs, [name](const FaultSpec& spec) { return name == spec.name; });
    return found == std::end(kSpecs) ? nullptr : found;
}

}  // namespace kerf::rehearsal
