// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>

namespace kerf {

inline constexpr double kNewtonPerKilogramForce = 9.80665;
inline constexpr double kMillimetrePerInch = 25.4;
inline constexpr double kNanosecondPerSecond = 1e9;

/// A double that cannot be mixed up with another of the same unit: `Diameter_mm` is no `Radius_mm`.
template <class Tag>
struct Quantity {
    double value{0.0};
    constexpr Quantity() = default;
    constexpr explicit Quantity(double v) : value(v) {}
    friend constexpr auto operator<=>(const Quantity&, const Quantity&) = default;
    friend constexpr Quantity operator+(Quantity a, Quantity b) { return Quantity(a.value + b.value); }
    friend constexpr Quantity operator-(Quantity a, Quantity b) { return Quantity(a.value - b.value); }
};

using Diameter_mm = Quantity<struct DiameterTag>;
using Radius_mm = Quantity<struct RadiusTag>;
using Deflection_mm = Quantity<struct DeflectionTag>;

[[nodiscard]] constexpr Radius_mm radiusOf(Diameter_mm d) {
    return Radius_mm(d.value / 2.0);
}
[[nodiscard]] constexpr Diameter_mm diameterOf(Radius_mm r) {
    return Diameter_mm(r.value * 2.0);
}

}  // namespace kerf
