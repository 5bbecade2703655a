// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/entry/diameter_input.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace kerf::ui {
namespace {
constexpr int kStoredDecimals = 3;  // a bore gauge resolves 0.001 mm
constexpr int kInchDecimals = 4;    // or 0.0001 in
constexpr QChar kOpenPlace(0x25AF);
}  // namespace

void DiameterInput::expect(double expected_mm, const UnitSystem& units) {
    m_expected_mm = expected_mm;
    m_nextUnits = units;
    if (m_typed.isEmpty()) {
        m_units = units;
    }
}

int DiameterInput::decimals() const {
    return m_units.length() == LengthUnit::Inch ? kInchDecimals : kStoredDecimals;
}

void DiameterInput::type(const QString& text) {
    if (m_anew) {
        clear();
    }
    for (const QChar c : text) {
        if (c.isPrint() && m_typed.size() < kLongest) {
            m_typed += c;
        }
    }
    m_gauge_mm.reset();
}

void DiameterInput::backspace() {
    m_gauge_mm.reset();
    m_anew = false;
    m_typed.chop(1);
    if (m_typed.isEmpty()) {
        m_units = m_nextUnits;
    }
}

void DiameterInput::clear() {
    m_typed.clear();
    m_gauge_mm.reset();
    m_anew = false;
    m_units = m_nextUnits;
}

void DiameterInput::set_mm(double diameter_mm) {
    m_units = m_nextUnits;
    m_typed = m_units.number(diameter_mm, "mm", kStoredDecimals);
    m_gauge_mm = diameter_mm;
    m_anew = true;
}

bool DiameterInput::completing() const {
    const bool figures = std::all_of(m_typed.cbegin(), m_typed.cend(), [](QChar c) { return c >= u'0' && c <= u'9'; });
    return m_expected_mm > 0.0 && figures && m_typed.size() <= kTailDigits;
}

QString DiameterInput::text(long long steps) const {
    return UnitSystem::fixed(static_cast<double>(steps) / std::pow(10.0, decimals()), decimals());
}

double DiameterInput::stepsTo_mm(long long steps) const {
    // Through the text, so that the stored value is exactly the number the operator read.
    return m_units.of("mm").toStored(text(steps).toDouble());
}

// The two diameters nearest to the expected one that end with the typed figures. With one figure typed, the middle of
// its ten counts.
DiameterInput::Tails DiameterInput::completions() const {
    const double perStep = std::pow(10.0, decimals());
    const auto expected = static_cast<long long>(std::llround(m_units.of("mm").toShown(m_expected_mm) * perStep));
    const bool whole = m_typed.size() == kTailDigits;
    const long long tail = whole ? m_typed.toLongLong() : m_typed.toLongLong() * 10 + 5;
    const long long base = expected - expected % 100;
    std::array<long long, 3> candidates{base - 100 + tail, base + tail, base + 100 + tail};
    std::sort(candidates.begin(), candidates.end(),
              [expected](long long a, long long b) { return std::llabs(a - expected) < std::llabs(b - expected); });
    return {candidates[0], candidates[1]};
}

DiameterInput::Shown DiameterInput::shown() const {
    if (!completing()) {
        return {{}, m_typed, {}};
    }
    Shown result;
    const auto places = static_cast<qsizetype>(kTailDigits);
    const QString full =
        m_typed.isEmpty()
            ? m_units.number(m_expected_mm, "mm", kStoredDecimals).left(text(completions().nearest).size())
            : text(completions().nearest);
    result.head = full.left(full.size() - places);
    result.typed = m_typed;
    result.open = QString(places - m_typed.size(), kOpenPlace);
    return result;
}

std::optional<double> DiameterInput::value_mm() const {
    if (m_gauge_mm) {
        return m_gauge_mm;
    }
    if (completing()) {
        return m_typed.size() == kTailDigits ? std::optional(stepsTo_mm(completions().nearest)) : std::nullopt;
    }
    double shown = 0.0;
    if (!UnitSystem::parse(m_typed, shown)) {
        return std::nullopt;
    }
    return m_units.of("mm").toStored(shown);
}

std::optional<double> DiameterInput::alternative_mm() const {
    if (!completing() || m_typed.size() != kTailDigits) {
        return std::nullopt;
    }
    const long long steps = completions().second;
    return steps > 0 ? std::optional(stepsTo_mm(steps)) : std::nullopt;
}

}  // namespace kerf::ui
