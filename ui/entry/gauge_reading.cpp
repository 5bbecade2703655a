// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/entry/gauge_reading.h"

#include <QRegularExpression>
#include <cmath>

#include "engine/core/units.h"

namespace kerf::ui {
namespace {

constexpr double kNear = 0.1;        ///< "the same size": within 10 %
constexpr double kDeviation = 0.02;  ///< of the bore: smaller is no diameter of it, however the point slipped

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

std::optional<GaugeReading> parseRadio(const QString& frame) {
    static const QRegularExpression radio(QStringLiteral("^DT1(\\d{4})([+-])(\\d{1,6})\\.(\\d{1,6})([MI])$"));
    const QRegularExpressionMatch match = radio.match(frame);
    if (!match.hasMatch()) {
        return std::nullopt;
    }
    GaugeReading reading;
    reading.channel = match.captured(1).toInt();
    reading.value = (match.captured(2) + match.captured(3) + u'.' + match.captured(4)).toDouble();
    reading.unit = match.captured(5) == QLatin1String("I") ? LengthUnit::Inch : LengthUnit::Millimetre;
    reading.frame = frame;
    return reading;
}

}  // namespace

std::optional<GaugeReading> parseGaugeFrame(const QString& frame) {
    // A label must be set off from the number, else it is a bar code: A1250.5.
    static const QRegularExpression plain(QStringLiteral(
        "^(?:(?<mux>\\d{1,2})[A-Z]\\s*|(?:CH|ch|Ch|#)\\s?(?<ch>\\d{1,2})\\s*[:=\\s]\\s*|(?<no>\\d{1,2})\\s*[:;]\\s*|"
        "(?:[A-Z][A-Za-z0-9]{0,7}\\s*[:=]\\s*|[A-Z][A-Za-z]{0,7}\\s+|[A-Z]{0,3}(?=[+-])))?"
        "(?<sign>[+-]?)\\s*(?<whole>\\d{0,7})[.,](?<part>\\d{1,6})\\s*(?<unit>mm|MM|in|IN|inch|INCH|\"|'')?"
        "\\s*[,;]?\\s*(?:OK|GO|NG|NOGO|LO|HI|LL|HH|\\+NG|-NG|>|<|=)?$"));
    const QString text = frame.trimmed();
    if (std::optional<GaugeReading> raw = parseRaw(text)) {
        return raw;
    }
    if (std::optional<GaugeReading> radio = parseRadio(text)) {
        return radio;
    }
    const QRegularExpressionMatch match = plain.match(text);
    if (!match.hasMatch()) {
        return std::nullopt;
    }
    GaugeReading reading;
    reading.value =
        (match.captured(QStringLiteral("whole")) + u'.' + match.captured(QStringLiteral("part"))).toDouble();
    if (match.captured(QStringLiteral("sign")) == QLatin1String("-")) {
        reading.value = -reading.value;
    }
    for (const char* name : {"mux", "ch", "no"}) {
        const QString channel = match.captured(QLatin1String(name));
        if (!channel.isEmpty()) {
            reading.channel = channel.toInt();
        }
    }
    const QString unit = match.captured(QStringLiteral("unit")).toLower();
    if (!unit.isEmpty()) {
        reading.unit = unit == QLatin1String("mm") ? LengthUnit::Millimetre : LengthUnit::Inch;
    }
    reading.frame = text;
    return reading;
}

GaugeJudgement judgeReading(const GaugeReading& reading, double expected_mm, LengthUnit shown, double ring_mm) {
    const LengthUnit unit = reading.unit.value_or(shown);
    GaugeJudgement judgement;
    judgement.value_mm = inMillimetre(reading.value, unit);
    if (ring_mm > 0.0 && std::abs(judgement.value_mm) < kDeviation * ring_mm) {
        judgement.value_mm += ring_mm;  // and so never half a diameter
        return judgement;
    }
    if (expected_mm > 0.0 && std::abs(judgement.value_mm) < kDeviation * expected_mm) {
        judgement.doubt = GaugeDoubt::Deviation;
        return judgement;
    }
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
