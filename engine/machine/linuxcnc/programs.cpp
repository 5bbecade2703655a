// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/machine/linuxcnc/programs.h"

#include <cmath>
#include <initializer_list>

#include "engine/core/number_text.h"

namespace kerf::linuxcnc {
namespace {

std::string call(const char* name, std::initializer_list<double> arguments) {
    std::string line = std::string("set mdi o<") + name + "> call";
    for (const double argument : arguments) {
        line += " [" + fixedText(argument, 6) + "]";
    }
    return line;
}

bool positive(std::initializer_list<double> values) {
    double product = 1.0;
    for (const double value : values) {
        if (!(value > 0.0)) {
            return false;
        }
        product *= value;
    }
    return std::isfinite(product);
}

Result<std::string> cutLine(const StartProgram& start, double number) {
    const double length_mm = start.to_mm - start.from_mm;
    const double feed_mmPerMin = start.programmedFeed_mmPerRev * start.spindleSpeed_rpm;
    const bool sound = positive({start.programmedFeed_mmPerRev, start.spindleSpeed_rpm, length_mm});
    if (start.process == ProcessId::Boring) {
        if (!sound) {
            return fail(KERF_TEXT(
                "The boring program needs feed, speed and overhangs above zero, the end deeper than the start."));
        }
        return call("kerf_bore", {length_mm, feed_mmPerMin, start.spindleSpeed_rpm, number});
    }
    if (!sound) {
        return fail(KERF_TEXT("The milling program needs feed and speed above zero and an end beyond its start."));
    }
    return call("kerf_mill", {start.from_mm, start.to_mm, feed_mmPerMin, start.spindleSpeed_rpm, number});
}

Result<std::string> tapLine(const StartProgram& start, double number) {
    if (!positive({start.pitch_mm, start.revolutions, start.spindleSpeed_rpm}) || start.revolutions <= kTapRunUp_rev) {
        return fail(KERF_TEXT("The tapping program needs pitch and speed above zero and more than %1 revolutions."),
                    SentenceArg{kTapRunUp_rev, 0});
    }
    const double runUp_mm = kTapRunUp_rev * start.pitch_mm;
    const double depth_mm = start.revolutions * start.pitch_mm - runUp_mm;
    const double lift_mm = start.air ? depth_mm + runUp_mm : 0.0;
    return call("kerf_tap", {depth_mm, start.pitch_mm, start.spindleSpeed_rpm, runUp_mm, lift_mm, number});
}

}  // namespace

Result<std::string> programLine(const StartProgram& start, std::uint32_t request) {
    const double number = startNumber(request);
    switch (start.process) {
        case ProcessId::Boring:
        case ProcessId::Milling:
            return cutLine(start, number);
        case ProcessId::Tapping:
            return tapLine(start, number);
        default:
            return fail(KERF_TEXT("This control has no program for that process."));
    }
}

std::string originShiftLine(const std::array<double, 3>& shift_um) {
    return call("kerf_shift", {shift_um[0], shift_um[1], shift_um[2]});
}

std::string originReportLine() {
    return "set mdi o<kerf_shift_report> call";
}

}  // namespace kerf::linuxcnc
