// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "engine/core/alarm.h"

/// Alarms of the turning loop, codes 300-399.
namespace kerf::turning_alarm {

inline constexpr AlarmCode kForceLost = 300;
inline constexpr AlarmCode kForceSaturated = 301;
inline constexpr AlarmCode kToolChipped = 302;
inline constexpr AlarmCode kZeroDrifted = 303;
inline constexpr AlarmCode kMeanForceOff = 304;
inline constexpr AlarmCode kTrimAtLimit = 305;
inline constexpr AlarmCode kBlindTone = 306;
inline constexpr AlarmCode kZeroUnknown = 307;

inline constexpr std::array kSpecs{
    AlarmSpec{
        kForceLost, 1, KERF_TEXT("Force signal lost"),
        KERF_TEXT("The force sensor is unplugged, its values are old, not numbers, or do not change any more."),
        KERF_TEXT(
            "The trim has gone to zero; the cut goes on without force feedback. No part is started until a person has "
            "released the stop."),
        KERF_TEXT("Check sensor, amplifier and cable. Measure this surface. Then release the stop.")},
    AlarmSpec{kForceSaturated, 2, KERF_TEXT("Force sensor at the end of its range"),
              KERF_TEXT("The cut is deeper or the amplifier more sensitive than the sensor's range allows."),
              KERF_TEXT("The trim has gone to zero for the rest of this part."),
              KERF_TEXT("Check depth of cut and amplifier range before the next part.")},
    AlarmSpec{
        kToolChipped, 1, KERF_TEXT("The cutting force has jumped: the tool may be chipped"),
        KERF_TEXT("The same depth takes clearly more force than at the start of this cut."),
        KERF_TEXT(
            "The trim has gone to zero; the surface after the jump is doubtful. No part is started until a person "
            "has released the stop."),
        KERF_TEXT("Look at the tool's edge. Change it if it is chipped, then release the stop.")},
    AlarmSpec{kZeroDrifted, 3, KERF_TEXT("The force sensor has drifted"),
              KERF_TEXT("The piezo sensor's zero out of the cut is not where it was."),
              KERF_TEXT("The zero was taken again; the force shown is right."),
              KERF_TEXT("None, unless it comes back with every part: then check the sensor's insulation.")},
    AlarmSpec{kMeanForceOff, 2, KERF_TEXT("The trim leans to one side"),
              KERF_TEXT("The mean of the trim is not zero: the loop would change the depth of cut."),
              KERF_TEXT("The trim has gone to zero for the rest of this part; the depth is the programmed one."),
              KERF_TEXT("Check depth of cut and touch-off before the next part.")},
    AlarmSpec{kTrimAtLimit, 3, KERF_TEXT("The trim sits at its limit"),
              KERF_TEXT("The disturbance is larger than the trim may correct."),
              KERF_TEXT("Part of the disturbance stays on the surface."),
              KERF_TEXT("Find the source of the vibration; see the spectrum's tones.")},
    AlarmSpec{kBlindTone, 3, KERF_TEXT("The force cannot see a tone at this spindle speed"),
              KERF_TEXT("A vibration repeats with every revolution, so the force does not change with it."),
              KERF_TEXT("The tone is held only for about a minute; then it comes back on the surface."),
              KERF_TEXT("Choose the spindle speed that the page suggests.")},
    AlarmSpec{kZeroUnknown, 2, KERF_TEXT("Zero of the force unknown"),
              KERF_TEXT("The force sensor does not keep its zero, and it was not taken before this cut, or is too old "
                        "for its drift."),
              KERF_TEXT("There is no trim in this part, or in the rest of it."),
              KERF_TEXT("Let the tool stand in the air before it touches. If it comes back in a long cut: check the "
                        "sensor's insulation, or divide the cut.")},
};

}  // namespace kerf::turning_alarm
