// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "engine/core/alarm.h"

/// Alarms of the milling loop, codes 200-299.
namespace kerf::milling_alarm {

inline constexpr AlarmCode kForceUnknown = 200;
inline constexpr AlarmCode kToolBroken = 201;
inline constexpr AlarmCode kOverload = 202;
inline constexpr AlarmCode kSpindleStopped = 203;
inline constexpr AlarmCode kFeedUnknown = 204;
inline constexpr AlarmCode kToolWorn = 205;
inline constexpr AlarmCode kReferenceOutOfReach = 206;
inline constexpr AlarmCode kChatter = 207;
inline constexpr AlarmCode kZeroUnknown = 208;
inline constexpr AlarmCode kZeroDrifted = 209;

inline constexpr std::array kSpecs{
    AlarmSpec{
        kForceUnknown, 2, KERF_TEXT("Cutting force unknown"),
        KERF_TEXT("The force signal is missing, old, stuck, at the end of its range or not a number."),
        KERF_TEXT("The feed is not controlled: it stays, or falls to the planned feed if it was faster. Overload and "
                  "breakage are not noticed."),
        KERF_TEXT("Check the force sensor, its plug and its amplifier. Control goes on by itself when the signal "
                  "is back.")},
    AlarmSpec{
        kToolBroken, 1, KERF_TEXT("Tool broken?"),
        KERF_TEXT("The cutting force collapsed within half a revolution while the tool was in the work."),
        KERF_TEXT(
            "Under control the feed is held, in every mode from then on; advising, Kerf only reports it. Nothing is "
            "started until a person has released the stop."),
        KERF_TEXT("Retract and look at the tool. Change it if it is broken, then release the stop on the Milling "
                  "page.")},
    AlarmSpec{
        kOverload, 1, KERF_TEXT("Cutting force above its limit"),
        KERF_TEXT("The depth of cut is larger than expected, the tool is blunt, or the material is harder."),
        KERF_TEXT(
            "Under control the feed is held, in every mode from then on; advising, Kerf only reports it. Nothing is "
            "started until a person has released the stop."),
        KERF_TEXT("Look at tool and blank. If both are sound, raise the limit or lower the reference, then release "
                  "the stop on the Milling page.")},
    AlarmSpec{
        kSpindleStopped, 1, KERF_TEXT("Spindle stopped in the cut"),
        KERF_TEXT("The spindle turns slower than half its programmed speed, or its speed is unknown."),
        KERF_TEXT(
            "Under control the feed is held, in every mode from then on; advising, Kerf only reports it. Nothing is "
            "started until a person has released the stop."),
        KERF_TEXT("Find out why the spindle stopped. When it turns again, release the stop on the Milling page.")},
    AlarmSpec{kFeedUnknown, 2, KERF_TEXT("Feed really made is unknown"),
              KERF_TEXT("The feed signal of the axis is missing, old or not a number."),
              KERF_TEXT("The feed is not controlled: it stays, or falls to the planned feed if it was faster."),
              KERF_TEXT("Check the axis' position signal. Control goes on by itself when it is back.")},
    AlarmSpec{kToolWorn, 3, KERF_TEXT("Tool wear above its threshold"),
              KERF_TEXT("The same cut needs a larger force than with the new tool."),
              KERF_TEXT("The wall stays flat, but the feed falls with the wear and the tool may break."),
              KERF_TEXT("Change the tool and press New tool on the Milling page.")},
    AlarmSpec{kReferenceOutOfReach, 3, KERF_TEXT("Reference force out of reach"),
              KERF_TEXT("The feed sits at its limit: the blank is too thin or too thick for the reference."),
              KERF_TEXT("The force differs from the reference, so the wall is not as flat as it could be."),
              KERF_TEXT("Change the reference or the feed limits, or accept the deviation.")},
    AlarmSpec{
        kChatter, 2, KERF_TEXT("Chatter"),
        KERF_TEXT("The force swings at a frequency that is no multiple of the spindle's: at this depth and speed the "
                  "cut excites tool and work."),
        KERF_TEXT("The wall gets marks, the tool wears fast and may break. The feed goes on holding the mean force: "
                  "it does not cure chatter."),
        KERF_TEXT("Change the spindle speed by 5 to 15 %, take less depth, or clamp tool and work shorter.")},
    AlarmSpec{
        kZeroUnknown, 2, KERF_TEXT("Zero of the force unknown"),
        KERF_TEXT(
            "The force sensor does not keep its zero, and it was not taken before this cut, or is too old for its "
            "drift."),
        KERF_TEXT(
            "The force counts as unknown: the feed stays, or falls to the planned feed if it was faster. Overload "
            "and breakage are not noticed."),
        KERF_TEXT("Let the path begin in the air. If it comes back in a long cut: check the sensor's insulation, or "
                  "divide the cut.")},
    AlarmSpec{kZeroDrifted, 3, KERF_TEXT("The zero of the force has drifted"),
              KERF_TEXT("Behind the last cut the sensor's zero was not where it was before."),
              KERF_TEXT("The force of that cut was wrong by as much at its end. The next cut trusts the zero for a "
                        "shorter time."),
              KERF_TEXT("Check cable and insulation of the sensor: moisture lets its charge leak.")},
};

}  // namespace kerf::milling_alarm
