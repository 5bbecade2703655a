// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "engine/core/alarm.h"

/// Alarms of the parts' quality, codes 600-699. They are raised beside the engine, where measurements are stored.
namespace kerf::quality_alarm {

inline constexpr AlarmCode kOutOfTolerance = 600;
inline constexpr AlarmCode kChartSignal = 601;
inline constexpr AlarmCode kGaugeOverdue = 602;
inline constexpr AlarmCode kFileNotWritten = 603;
inline constexpr AlarmCode kToolLife = 604;

inline constexpr std::array kSpecs{
    AlarmSpec{kOutOfTolerance, 2, KERF_TEXT("A part is out of tolerance"),
              KERF_TEXT("Tool, blank, clamping or gauge: the charts of the Quality page say whether it stands alone."),
              KERF_TEXT("The part waits for a decision. The loop goes on and learns from the value."),
              KERF_TEXT("Measure it again. Set the part aside and say on the Quality page what was done with it.")},
    AlarmSpec{kChartSignal, 3, KERF_TEXT("The law no longer predicts the parts"),
              KERF_TEXT("Something has changed that the law does not know: insert, material, clamping, gauge."),
              KERF_TEXT("Parts may leave the tolerance sooner than the loop can follow. No capability is claimed."),
              KERF_TEXT("Look at tool, blank and gauge of that part. Announce a change on the Boring page.")},
    AlarmSpec{kGaugeOverdue, 3, KERF_TEXT("A gauge is overdue"),
              KERF_TEXT("The date until which it was checked has passed."),
              KERF_TEXT("Its readings are taken as before, but nobody vouches for them."),
              KERF_TEXT("Have it checked, and enter the new date on the Quality page under Gauges.")},
    AlarmSpec{kFileNotWritten, 3, KERF_TEXT("A Q-DAS file was not written"),
              KERF_TEXT("The folder is not there, is full, or may not be written to."),
              KERF_TEXT("The values are stored here; the system that reads the folder does not have them."),
              KERF_TEXT("Make the folder reachable. The file is tried again with the next part.")},
    AlarmSpec{kToolLife, 3, KERF_TEXT("A tool comes to the end of its life"),
              KERF_TEXT("It has made nine tenths of the parts that were set for it, or more."),
              KERF_TEXT("Nothing is stopped. Wear beyond its life changes the parts, and the loop has to follow it."),
              KERF_TEXT("Have the next tool ready. After the change touch the strip under the header, and New tool.")},
};

}  // namespace kerf::quality_alarm
