// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

#include "ui/units/unit_system.h"

namespace kerf::ui {

/// What the operator types for one diameter, and what it means.
///
/// A bore gauge is read by its last two figures, and only those are typed: the figures in front come from the bore
/// that is expected. "1 2" on a bore of 50.010 is 50.012; "9 8" is 49.998, the nearest diameter that ends so. Field,
/// two figures, Enter: three touches with the field preselected. Anything with a decimal mark, or longer, is the whole
/// diameter as typed. What Enter will store is always shown in full.
///
/// An entry keeps the unit it was begun in until it is entered or cleared: switching units never changes it.
class DiameterInput {
 public:
    static constexpr int kTailDigits = 2;
    static constexpr int kLongest = 16;

    /// @param expected_mm predicted diameter, else the target; ≤ 0: no completion
    void expect(double expected_mm, const UnitSystem& units);

    void type(const QString& text);
    void backspace();
    void clear();
    void set_mm(double diameter_mm);  ///< the gauge's reading; the next figure typed begins anew
    /// The next figure typed begins anew (the value is in question).
    void beginAnew() { m_anew = true; }

    [[nodiscard]] const QString& typed() const { return m_typed; }
    [[nodiscard]] bool empty() const { return m_typed.isEmpty(); }
    [[nodiscard]] const UnitSystem& units() const { return m_units; }
    [[nodiscard]] bool completing() const;  ///< the figures in front come from the expected bore

    /// What the field shows: head (completed), typed, open places.
    struct Shown {
        QString head{};
        QString typed{};
        QString open{};
        [[nodiscard]] QString all() const { return head + typed + open; }
    };
    [[nodiscard]] Shown shown() const;
    /// The diameter that Enter would store; empty while it is none.
    [[nodiscard]] std::optional<double> value_mm() const;
    /// The other diameter with the same last figures, one step farther from the expected one.
    [[nodiscard]] std::optional<double> alternative_mm() const;

 private:
    struct Tails {
        long long nearest;
        long long second;
    };
    [[nodiscard]] int decimals() const;
    [[nodiscard]] Tails completions() const;
    [[nodiscard]] QString text(long long steps) const;
    [[nodiscard]] double stepsTo_mm(long long steps) const;

    UnitSystem m_nextUnits{};
    UnitSystem m_units{};
    double m_expected_mm{0.0};
    QString m_typed;
    bool m_anew{false};
    std::optional<double> m_gauge_mm{};  ///< exact value behind a text set by set_mm
};

}  // namespace kerf::ui
