// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "engine/core/alarm.h"

/// Alarms of the boring loop, codes 100-199.
namespace kerf::boring_alarm {

inline constexpr AlarmCode kOverhangLost = 100;
inline constexpr AlarmCode kSpindleSpeedLost = 101;
inline constexpr AlarmCode kFeedNotFollowing = 102;
inline constexpr AlarmCode kEstimateDiffers = 110;  ///< raised by the service, not by the loop

inline constexpr std::array kSpecs{
    AlarmSpec{
        kOverhangLost, 2, KERF_TEXT("Spindle overhang unknown"),
        KERF_TEXT("The position of the boring spindle is missing, old, not a number, or stands still while it feeds."),
        KERF_TEXT("The feed falls to the lowest of the schedule and does not follow it, so the bore may taper."),
        KERF_TEXT("Check the spindle's position signal. Measure this part at both depths.")},
    AlarmSpec{kSpindleSpeedLost, 2, KERF_TEXT("Spindle speed unknown"),
              KERF_TEXT("The spindle's speed signal is missing, old or not a number."),
              KERF_TEXT("The feed falls to the lowest of the schedule and does not follow it, so the bore may taper."),
              KERF_TEXT("Check the spindle encoder. Measure this part at both depths.")},
    AlarmSpec{kFeedNotFollowing, 3, KERF_TEXT("The feed does not follow the schedule"),
              KERF_TEXT("The operator's feed knob, a limit of the control, or its acceleration keeps the feed away "
                        "from the schedule."),
              KERF_TEXT("The bore is cut with another feed than planned. The estimate uses the feed really cut."),
              KERF_TEXT("Set the feed knob to 100 %, or accept the deviation.")},
    AlarmSpec{kEstimateDiffers, 3, KERF_TEXT("The estimate differs from the stored one"),
              KERF_TEXT("The lot was computed again from its stored measurements and gave another state than the one "
                        "stored with the last of them: another version of the program, or a changed file."),
              KERF_TEXT("The newly computed estimate and feed schedule are used."),
              KERF_TEXT("Compare the next part with its prediction. Keep the data file for the service.")},
};
inline constexpr const AlarmSpec& kRestartDiffers = kSpecs.back();

}  // namespace kerf::boring_alarm
