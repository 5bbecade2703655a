// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstdint>
#include <optional>
#include <string>

#include "ui/units/unit_system.h"

namespace kerf::ui {

/// One value as a hand gauge sent it through its keyboard wedge.
struct GaugeReading {
    double value{0.0};                 ///< in the gauge's own unit
    std::optional<LengthUnit> unit{};  ///< empty: the frame carries none
    QString frame{};                   ///< what was sent, without the end key
    std::optional<int> channel{};      ///< of a multiplexer, 1 …; empty: the frame carries none
    std::optional<std::uint8_t>
        depth{};          ///< where it was measured, from 0, as the sensor file says; goes before channel
    std::string gauge{};  ///< identity in the register, where the sensor file says it; else by channel
};

/// Reads the frames in use. Anything else, and anything without a decimal mark, is no gauge frame: whole numbers are
/// typed by people and sent by bar code readers.
///
///   50.011   +50,011   50.011mm   1.96894 in   1.96894"   "  50.011 "   plain, padded, point or comma, sign, unit
///   01A+00050.011   CH2: 50.011   2:50.011   #2 50.011                  multiplexer: channel, sign, value
///   D=50.011   DIA 50.011 mm   OD: +50.011                              a label in front
///   50.011 OK   50.011,GO   50.011 mm NG                                a verdict of the gauge behind: not looked at
///   DT10002+0050.011M                                                   radio base: channel, sign, value, M mm/I in
///   FFFF005001130    (FFFF, sign 0/8, six figures, point 0-5, unit 0 mm/1 in)       Digimatic raw
[[nodiscard]] std::optional<GaugeReading> parseGaugeFrame(const QString& frame);

/// What may be wrong with a reading before anybody looks at the process.
enum class GaugeDoubt {
    None,
    OtherUnit,   ///< fits the bore only when read in the other unit
    DecadeSlip,  ///< a power of ten away from the bore
    Deviation,   ///< the gauge shows how far the bore is from its setting ring, and no ring is known
};
struct GaugeJudgement {
    double value_mm{
        0.0};  ///< the diameter: read in the frame's unit, else in the shown one; with a ring ring + reading
    GaugeDoubt doubt{GaugeDoubt::None};
    double otherUnit_mm{0.0};  ///< OtherUnit: read in the other unit
};
/// @param expected_mm the bore that is waited for, > 0
/// @param shown unit on the screen, taken when the frame carries none
/// @param ring_mm setting ring of a comparator, whose readings are deviations from it; 0: the gauge shows diameters
[[nodiscard]] GaugeJudgement judgeReading(const GaugeReading& reading, double expected_mm, LengthUnit shown,
                                          double ring_mm = 0.0);

}  // namespace kerf::ui
