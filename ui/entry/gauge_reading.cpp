// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/entry/gauge_reading.h"

#include <QRegularExpression>
#include <cmath>

#include "engine/core/units.h"

namespace kerf::ui {
namespace {

constexpr double kNear = 0.1;  ///< "the same size": within 10 %

bool near(double value_mm, double expected_mm) {
    return std::abs(value_mm - expected_mm) <= kNear * expected_mm;
}

double inMillimetre(double value, LengthUnit unit) {
    return unit == LengthUnit::Inch ? value * kMillimetrePerInch : value;
}

std::optional<GaugeReading> parseRaw(const QString& frame) {
    static const QRegularExpression raw(QStringLiteral("^FFFF([08])(\\d{6})([0-5])([01])$"));
    const QRegularExpressionMatch match = raw.match(frame);
    if (!match.hasMatch()) {
        return std::nullopt;
    }
    GaugeReading reading;
    reading.value = match.captured(2).toDouble() / std::pow(10.0, match.captured(3).toInt());
    if (match.captured(1) == QLatin1String("8")) {
        reading.value = -reading.value;
    }
    reading.unit = match.captured(4) == QLatin1String("1") ? LengthUnit::Inch : LengthUnit::Millimetre;
    reading.frame = frame;
    return reading;
}

}  // namespace

std::optional<GaugeReading> parseGaugeFrame(const QString& frame) {
    static const QRegularExpression plain(
        QStringLiteral("^(?:\\d{1,2}[A-Z])?\\s*([+-]?)\\s*(\\d{0,7})[.,](\\d{1,6})\\s*(mm|MM|in|IN|inch|\"|'')?$"));
    const QString text = frame.trimmed();
    if (std::optional<GaugeReading> raw = parseRaw(text)) {
        return raw;
    }
    const QRegularExpressionMatch match = plain.match(text);
    if (!match.hasMatch()) {
        return std::nullopt;
    }
    GaugeReading reading;
    reading.value = (match.captured(2) + u'.' + match.captured(3)).toDouble();
    if (match.captured(1) == QLatin1String("-")) {
        reading.value = -reading.value;
    }
    const QString unit = match.captured(4).toLower();
    if (!unit.isEmpty()) {
        reading.unit = unit == QLatin1String("mm") ? LengthUnit::Millimetre : LengthUnit::Inch;
    }
    reading.frame = text;
    return reading;
}

GaugeJudgement judgeReading(const GaugeReading& reading, double expected_mm, LengthUnit shown) {
    const LengthUnit unit = reading.unit.value_or(shown);
    GaugeJudgement judgement;
    judgement.value_mm = inMillimetre(reading.value, unit);
    if (expected_mm <= 0.0 || judgement.value_mm <= 0.0 || near(judgement.value_mm, expected_mm)) {
        return judgement;  // what the process makes of it is the service's question
    }
    const LengthUnit other = unit == LengthUnit::Inch ? LengthUnit::Millimetre : LengthUnit::Inch;
    const double otherUnit_mm = inMillimetre(reading.value, other);
    if (!reading.unit && near(otherUnit_mm, expected_mm)) {
        judgement.doubt = GaugeDoubt::OtherUnit;
        judgement.otherUnit_mm = otherUnit_mm;
        return judgement;
    }
    const double decades = std::round(std::log10(judgement.value_mm / expected_mm));
    if (decades != 0.0 && near(judgement.value_mm / std::pow(10.0, decades), expected_mm)) {
        judgement.doubt = GaugeDoubt::DecadeSlip;
    }
    return judgement;
}

}  // namespace kerf::ui
