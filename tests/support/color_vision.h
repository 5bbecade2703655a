// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <array>
#include <cmath>

namespace kerf::test {

/// The red-green deficiencies, as full dichromacy.
enum class Vision { Normal, Protan, Deutan };

inline double toLinear(double c) {
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

/// Linear RGB as seen by that eye. Matrices: Machado, Oliveira & Fernandes (2009), severity 1.0.
inline std::array<double, 3> seen(const QColor& color, Vision vision) {
    const std::array<double, 3> rgb{toLinear(color.redF()), toLinear(color.greenF()), toLinear(color.blueF())};
    using Matrix = std::array<std::array<double, 3>, 3>;
    constexpr Matrix normal{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    constexpr Matrix protan{
        {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}};
    constexpr Matrix deutan{
        {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}};
    const Matrix& m = vision == Vision::Protan ? protan : vision == Vision::Deutan ? deutan : normal;
    std::array<double, 3> out{};
    for (std::size_t i = 0; i < 3; ++i) {
        out[i] = std::clamp(m[i][0] * rgb[0] + m[i][1] * rgb[1] + m[i][2] * rgb[2], 0.0, 1.0);
    }
    return out;
}

/// CIE L*a*b* (D65) of linear RGB.
inline std::array<double, 3> lab(const std::array<double, 3>& rgb) {
    const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0; };
    const double x = f((0.4124 * rgb[0] + 0.3576 * rgb[1] + 0.1805 * rgb[2]) / 0.95047);
    const double y = f(0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]);
    const double z = f((0.0193 * rgb[0] + 0.1192 * rgb[1] + 0.9505 * rgb[2]) / 1.08883);
    return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

/// CIE76 distance of two colours for that eye; about 2 is just noticeable side by side, 10 is plain at a glance.
inline double distance(const QColor& a, const QColor& b, Vision vision) {
    const auto la = lab(seen(a, vision));
    const auto lb = lab(seen(b, vision));
    return std::sqrt(std::pow(la[0] - lb[0], 2) + std::pow(la[1] - lb[1], 2) + std::pow(la[2] - lb[2], 2));
}

}  // namespace kerf::test
