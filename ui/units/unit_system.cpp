// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/units/unit_system.h"

#include <QLocale>
#include <algorithm>
#include <array>
#include <cmath>

#include "engine/core/units.h"

namespace kerf::ui {
namespace {

struct InchRow {
    std::string_view stored;
    const char* metric;
    const char* inch;
    double inchFactor;
    int inchDecimals;  ///< more decimals in inch
};

constexpr double kPerInch = 1.0 / kMillimetrePerInch;
constexpr double kMicroinchPerMicrometre = 1000.0 / kMillimetrePerInch;
// 0.001 mm is 0.00004 in: two more decimals keep what the gauge resolved.
constexpr double kNewtonPerPoundForce = 4.4482216152605;  // as defined
constexpr double kPoundForcePerNewton = 1.0 / kNewtonPerPoundForce;
// What an American shop says: feeds in in/min or in/rev, forces in lbf, stiffness in lbf/in.
constexpr std::array<InchRow, 9> kLengths{{
    {"mm", "mm", "in", kPerInch, 2},
    {"um", "µm", "µin", kMicroinchPerMicrometre, -1},
    {"mm/rev", "mm/rev", "in/rev", kPerInch, 2},
    {"mm/s", "mm/s", "in/min", 60.0 * kPerInch, 0},
    {"mm/min", "mm/min", "in/min", kPerInch, 1},
    {"mm/tooth", "mm/tooth", "in/tooth", kPerInch, 2},
    {"N", "N", "lbf", kPoundForcePerNewton, 1},
    {"N/mm", "N/mm", "lbf/in", kPoundForcePerNewton* kMillimetrePerInch, -1},
    {"N/um", "N/µm", "lbf/in", kPoundForcePerNewton * 1000.0 * kMillimetrePerInch, -3},
}};

}  // namespace

int DisplayUnit::decimals(int storedDecimals) const {
    return std::max(0, storedDecimals + extraDecimals);
}

DisplayUnit UnitSystem::of(std::string_view stored) const {
    for (const InchRow& row : kLengths) {
        if (row.stored == stored) {
            return m_length == LengthUnit::Millimetre
                       ? DisplayUnit{QString::fromUtf8(row.metric)}
                       : DisplayUnit{QString::fromUtf8(row.inch), row.inchFactor, 0.0, row.inchDecimals};
        }
    }
    const bool celsius = m_temperature == TemperatureUnit::Celsius;
    if (stored == "degC") {
        return celsius ? DisplayUnit{QStringLiteral("°C")} : DisplayUnit{QStringLiteral("°F"), 1.8, 32.0, 0};
    }
    if (stored == "K") {
        return celsius ? DisplayUnit{QStringLiteral("K")} : DisplayUnit{QStringLiteral("°F"), 1.8, 0.0, 0};
    }
    return DisplayUnit{QString::fromUtf8(stored.data(), static_cast<qsizetype>(stored.size()))};
}

QString UnitSystem::number(double stored, std::string_view unit, int decimals) const {
    const DisplayUnit shown = of(unit);
    return fixed(shown.toShown(stored), shown.decimals(decimals));
}

QString UnitSystem::withUnit(double stored, std::string_view unit, int decimals) const {
    const DisplayUnit shown = of(unit);
    const QString digits = fixed(shown.toShown(stored), shown.decimals(decimals));
    return shown.symbol.isEmpty() ? digits : digits + QChar(QChar::Nbsp) + shown.symbol;
}

QString UnitSystem::difference(double stored, std::string_view unit, int decimals) const {
    const DisplayUnit shown = of(unit);
    return fixed(stored * shown.factor, shown.decimals(decimals));
}

QString UnitSystem::fixed(double shown, int decimals) {
    QString digits = QString::number(std::abs(shown), 'f', decimals);
    const bool zero = std::none_of(digits.cbegin(), digits.cend(), [](QChar c) { return c >= u'1' && c <= u'9'; });
    if (shown < 0.0 && !zero) {
        digits.prepend(QChar(0x2212));
    }
    return digits;
}

bool UnitSystem::parse(const QString& typed, double& shown) {
    QString text = typed.trimmed();
    text.replace(u',', u'.');
    text.replace(QChar(0x2212), u'-');
    bool ok = false;
    const double value = QLocale::c().toDouble(text, &ok);
    if (!ok || !std::isfinite(value)) {
        return false;
    }
    shown = value;
    return true;
}

}  // namespace kerf::ui
