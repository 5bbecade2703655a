// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "engine/core/alarm.h"

/// Alarms of the tapping loop, codes 500-599.
namespace kerf::tapping_alarm {

inline constexpr AlarmCode kErrorLimit = 500;
inline constexpr AlarmCode kSignalLost = 501;
inline constexpr AlarmCode kInHole = 502;
inline constexpr AlarmCode kDrift = 503;
inline constexpr AlarmCode kGainsNotTaken = 504;
inline constexpr AlarmCode kNotCounted = 505;
inline constexpr AlarmCode kWrongPitch = 506;

inline constexpr std::array kSpecs{
    AlarmSpec{
        kErrorLimit, 2, KERF_TEXT("Tapping error beyond its limit"),
        KERF_TEXT("Z and spindle were further apart than the abort limit during a tap."),
        KERF_TEXT("In control the tap is turned out in sync and the gains are rolled back. The thread may be torn."),
        KERF_TEXT("Gauge the thread. Look at the record before the next trial.")},
    AlarmSpec{kSignalLost, 2, KERF_TEXT("Tapping signal lost"),
              KERF_TEXT("Spindle angle or Z position were missing for more than 20 ms during a tap."),
              KERF_TEXT("In control the tap is turned out in sync. It does not count."),
              KERF_TEXT("Check the encoders. Gauge the thread.")},
    AlarmSpec{
        kInHole, 1, KERF_TEXT("The tap stands in the hole"),
        KERF_TEXT("An emergency stop or an abort at the control stopped the tap before it was out."),
        KERF_TEXT(
            "A move of Z or spindle alone breaks the tap. Kerf starts nothing and moves no axis until it is out."),
        KERF_TEXT(
            "Make the machine ready, then turn the tap out in sync from the tapping page; or say there that it is "
            "gone.")},
    AlarmSpec{kDrift, 3, KERF_TEXT("Tapping error has grown"),
              KERF_TEXT("The sum of errors of the last taps lies above that of the first taps after the tuning."),
              KERF_TEXT("Threads are still made; their tolerance is used up slowly."),
              KERF_TEXT("Check tap and lubrication, then tune again.")},
    AlarmSpec{kGainsNotTaken, 2, KERF_TEXT("The drive did not take the gains"),
              KERF_TEXT("The gains sent to the drive were refused or did not read back within a second."),
              KERF_TEXT("No tap is made."), KERF_TEXT("Check that the control allows setting gains, then try again.")},
    AlarmSpec{kNotCounted, 3, KERF_TEXT("Tap not counted"),
              KERF_TEXT("More than 5 % of its samples are missing, or the loop was switched during the tap."),
              KERF_TEXT("The tuner does not learn from it."), KERF_TEXT("Repeat the tap.")},
    AlarmSpec{kWrongPitch, 1, KERF_TEXT("Wrong pitch"),
              KERF_TEXT("Z moves by another distance per revolution than the pitch entered."),
              KERF_TEXT("In control the tap is turned out in sync."),
              KERF_TEXT("Compare pitch entered, program and tool before the next tap.")},
};

}  // namespace kerf::tapping_alarm
