// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string_view>

namespace kerf::ui {

enum class LengthUnit { Millimetre, Inch };
enum class TemperatureUnit { Celsius, Fahrenheit };

/// How one stored unit is shown: shown = stored·factor + offset.
struct DisplayUnit {
    QString symbol{};  ///< "mm", "in", "µm", "°F"; empty for a ratio
    double factor{1.0};
    double offset{0.0};
    int extraDecimals{0};  ///< decimals the shown unit needs beyond the stored one's

    [[nodiscard]] double toShown(double stored) const { return stored * factor + offset; }
    [[nodiscard]] double toStored(double shown) const { return (shown - offset) / factor; }
    [[nodiscard]] int decimals(int storedDecimals) const;
};

/// The only place where a stored value becomes a shown one. Stored units are never changed by switching: only the view.
class UnitSystem {
 public:
    UnitSystem() = default;
    UnitSystem(LengthUnit length, TemperatureUnit temperature) : m_length(length), m_temperature(temperature) {}

    [[nodiscard]] LengthUnit length() const { return m_length; }
    [[nodiscard]] TemperatureUnit temperature() const { return m_temperature; }

    /// @param stored "mm", "um", "mm/rev", "mm/s", "mm/min", "mm/tooth", "degC", "K", "N", "rpm", "s", "%", "" …;
    /// a unit that is not known is shown as it is.
    [[nodiscard]] DisplayUnit of(std::string_view stored) const;

    /// Shown number with fixed decimals (`decimals` counts those of the stored unit), without the unit.
    [[nodiscard]] QString number(double stored, std::string_view unit, int decimals) const;
    /// The same with the unit behind it.
    [[nodiscard]] QString withUnit(double stored, std::string_view unit, int decimals) const;
    /// A difference or half width (no offset): ±0.004, 3 K as 5.4 °F.
    [[nodiscard]] QString difference(double stored, std::string_view unit, int decimals) const;

    /// Fixed decimals, a real minus sign, no "-0".
    [[nodiscard]] static QString fixed(double shown, int decimals);
    /// Read what a person typed in the shown unit (point or comma); empty string or rubbish gives no value.
    [[nodiscard]] static bool parse(const QString& typed, double& shown);

    friend bool operator==(const UnitSystem&, const UnitSystem&) = default;

 private:
    LengthUnit m_length{LengthUnit::Millimetre};
    TemperatureUnit m_temperature{TemperatureUnit::Celsius};
};

}  // namespace kerf::ui
