// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/core/force_signal.h"
#include "engine/core/sentence.h"
#include "engine/cycle/force_zero.h"
#include "engine/port/machine_port.h"
#include "engine/process/milling/milling_types.h"

/// What a machine's force signal allows: how fast the loop may decide, which spindle speeds it can follow, whether
/// single teeth are seen.
namespace kerf::milling {

/// Shortest time between two decisions: .06 s (three lags of a usual drive), and 1/(2 B) of a signal of bandwidth B, so
/// that the loop is never faster than its sensor (1/(2 B) is three of the sensor's time constants).
[[nodiscard]] double shortestPeriod_s(const ForceSignal& signal) noexcept;

/// Empty, or why the force of a revolution cannot be averaged at this speed: less than eight values per revolution.
[[nodiscard]] Sentence whyTooSlow(const ForceSignal& signal, double speed_rpm) noexcept;

/// A tooth that breaks is told from its neighbours: four values per tooth at least, and half the tooth frequency within
/// the bandwidth.
[[nodiscard]] bool teethSeen(const ForceSignal& signal, double speed_rpm, int flutes) noexcept;

/// A tooth shows as 5 % of the reference; the zero may be wrong by 2 %.
[[nodiscard]] ForceZeroParams zeroParams(const Capabilities& capabilities, const MillingSetup& setup) noexcept;

/// Why the force cannot be trusted, for the alarm.
[[nodiscard]] Sentence forceDetail(Quality quality) noexcept;
/// Why its zero cannot.
[[nodiscard]] Sentence zeroDetail(const ForceZero& zero) noexcept;

}  // namespace kerf::milling
