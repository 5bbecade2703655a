// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "app/sensors/sensor_file.h"

/// What gauges send over a serial line. Pure text in, value out.
namespace kerf::sensors {

struct GaugeFrame {
    double value{0.0};
    bool inch{false};
    std::string channel{};  ///< empty: the gauge has one only
};

/// One line without its end. Empty: an error frame, or no reading.
///
///   Digimatic   01A+00012.345      channel, A = reading, sign, figures      errors 911, 912: no data, wrong format
///   Mahr        +12.3456mm         blanks anywhere, point or comma, unit mm or in or none
///   Sylvac      +12.345            ditto
///   pattern     the file's regular expression: group 1 the value, group 2 the channel
[[nodiscard]] std::optional<GaugeFrame> parseGaugeFrame(const Gauge& gauge, const std::string& line);

/// Number of the measured depth that the file gives this channel, from 1; empty: none, the page learns it.
[[nodiscard]] std::optional<int> depthOf(const Gauge& gauge, const std::string& channel);
/// The same reading as a keyboard wedge would type it, channel first ("02A+50.01200mm"): the number of a channel that
/// is one and has no depth in the file.
[[nodiscard]] std::string wedgeFrame(const Gauge& gauge, const std::string& channel, double value, bool inch);

/// Reason against a pattern (%1), a KERF_TEXT; null: it can be used.
[[nodiscard]] const char* whyNotAPattern(const std::string& pattern);

}  // namespace kerf::sensors
