// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "engine/core/alarm.h"

/// Alarms of the thermal loop, codes 400-499.
namespace kerf::thermal_alarm {

inline constexpr AlarmCode kSensorLeftOut = 400;
inline constexpr AlarmCode kTooManyLost = 401;
inline constexpr AlarmCode kShiftAtLimit = 402;
inline constexpr AlarmCode kShiftTooFast = 403;
inline constexpr AlarmCode kShiftNotTaken = 404;
inline constexpr AlarmCode kMeasureNow = 405;
inline constexpr AlarmCode kOutside = 406;
inline constexpr AlarmCode kNoTemperatures = 407;

inline constexpr AlarmCode kDayDiffers = 408;

inline constexpr std::array kSpecs{
    AlarmSpec{kSensorLeftOut, 3, KERF_TEXT("A thermocouple is left out"),
              KERF_TEXT("It is open, shorted, stuck, noisy or away from what its neighbours expect."),
              KERF_TEXT("The model goes on without it; its interval is wider."),
              KERF_TEXT("Check its plug and its mounting.")},
    AlarmSpec{kTooManyLost, 2, KERF_TEXT("Too many thermocouples lost"),
              KERF_TEXT("More than two of the model's own thermocouples are left out."),
              KERF_TEXT("Nothing is predicted; the last shift stays."),
              KERF_TEXT("Repair the thermocouples named on the thermal page, or go live with a model without them.")},
    AlarmSpec{kShiftAtLimit, 2, KERF_TEXT("Shift of the work origin at its limit"),
              KERF_TEXT("The predicted drift is larger than the largest shift allowed."),
              KERF_TEXT("The rest of the drift is in the part."),
              KERF_TEXT("Measure the origin, then set it anew or allow a larger shift.")},
    AlarmSpec{kShiftTooFast, 3, KERF_TEXT("Drift faster than the shift may follow"),
              KERF_TEXT("The predicted drift moves faster than the rate allowed."),
              KERF_TEXT("The shift lags behind for some minutes."),
              KERF_TEXT("Look at the thermocouples: heat does not move that fast.")},
    AlarmSpec{kShiftNotTaken, 2, KERF_TEXT("The control does not take the shift"),
              KERF_TEXT("The work offset the control reports is not the one commanded."),
              KERF_TEXT("The drift is in the part."),
              KERF_TEXT("Check that external work offset is allowed at the control.")},
    AlarmSpec{kMeasureNow, 3, KERF_TEXT("Measure the origin now"),
              KERF_TEXT("The interval of the prediction is wider than the part allows."),
              KERF_TEXT("The shift may be wrong by more than the part allows."),
              KERF_TEXT("Put the test bar in and measure from the thermal page.")},
    AlarmSpec{kOutside, 3, KERF_TEXT("Temperatures outside the training range"),
              KERF_TEXT("The machine is in a state the model has never seen."),
              KERF_TEXT("The compensation fades to hold the last shift."),
              KERF_TEXT("Measure the origin; record this state and train again.")},
    AlarmSpec{kNoTemperatures, 2, KERF_TEXT("No temperatures from the machine"),
              KERF_TEXT("The machine sends no temperatures any more."),
              KERF_TEXT("Nothing is predicted; the last shift stays."),
              KERF_TEXT("Check the temperature module and its cable.")},
    AlarmSpec{kDayDiffers, 3, KERF_TEXT("Today differs from the days trained on: measure"),
              KERF_TEXT("The measurements of today fit a machine that behaves otherwise."),
              KERF_TEXT("The interval is wider; the model learns from every measurement."),
              KERF_TEXT("Measure the origin every hour; record this state and train again.")},
};

}  // namespace kerf::thermal_alarm
