// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/core/sentence.h"
#include "engine/machine/sensors/sensor_memory.h"

namespace kerf::sensors {

/// One sentence for the person in front of the machine.
[[nodiscard]] constexpr const char* causeText(Cause cause) noexcept {
    switch (cause) {
        case Cause::None:
            return KERF_TEXT("Reads.");
        case Cause::NotYetRead:
            return KERF_TEXT("Not read yet.");
        case Cause::NoAnswer:
            return KERF_TEXT("No answer: the module is off, its cable is out, or the address is wrong.");
        case Cause::Refused:
            return KERF_TEXT("The module has no such register: another one than the sensor file says.");
        case Cause::InvalidCode:
            return KERF_TEXT("The module says that there is no measurement: the thermocouple is broken or loose.");
        case Cause::BadStatus:
            return KERF_TEXT("The module's status says that the value is not to be used.");
        case Cause::NoNumber:
            return KERF_TEXT("The register holds no number: are its words swapped?");
        case Cause::OutOfRange:
            return KERF_TEXT("Outside what it can be: wrong type, scale or word order?");
        case Cause::Jump:
            return KERF_TEXT("Jumped; believed again when three readings agree.");
        case Cause::NotLinked:
            return KERF_TEXT("No signal is linked to the pin.");
        case Cause::Fault:
            return KERF_TEXT("The control reports a fault of this channel.");
    }
    return "";
}

}  // namespace kerf::sensors
