// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theme/metrics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace kerf::ui {
namespace {
constexpr double kMillimetrePerInch = 25.4;
constexpr double kStepDpi = 96.0;
}  // namespace

Metrics::Metrics(double dpi, double scale)
    : m_scale(std::clamp(scale, kMinScale, kMaxScale)), m_pxPerMm(dpi / kMillimetrePerInch * m_scale) {}

int Metrics::px(double size_mm) const {
    return static_cast<int>(std::lround(size_mm * m_pxPerMm));
}

int Metrics::text(TextSize size) const {
    constexpr std::array<double, 4> sizes_mm{2.8, 3.4, 6.0, 9.0};
    return static_cast<int>(std::ceil(sizes_mm[static_cast<std::size_t>(size)] * m_pxPerMm));
}

int Metrics::space(Space step) const {
    constexpr std::array<double, 4> steps{2.0, 4.0, 8.0, 16.0};
    return px(steps[static_cast<std::size_t>(step)] / kStepDpi * kMillimetrePerInch);
}

double Metrics::stroke(Stroke width) const {
    constexpr std::array<double, 3> widths{1.0, 1.75, 2.75};
    return widths[static_cast<std::size_t>(width)] / kStepDpi * kMillimetrePerInch * m_pxPerMm;
}

int Metrics::touch() const {
    return static_cast<int>(std::ceil(15.0 * m_pxPerMm));
}
int Metrics::touchGap() const {
    return static_cast<int>(std::ceil(3.0 * m_pxPerMm));
}
int Metrics::lamp() const {
    return px(3.6);
}
int Metrics::icon() const {
    return px(5.2);
}
int Metrics::corner() const {
    return px(0.8);
}
int Metrics::navWidth() const {
    return px(52.0);
}
int Metrics::sideWidth() const {
    return px(87.0);
}
int Metrics::sparkline() const {
    return px(12.0);
}
int Metrics::chart() const {
    return px(42.0);
}

}  // namespace kerf::ui
