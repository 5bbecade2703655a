// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theme/palette.h"

#include <algorithm>
#include <cmath>

namespace kerf::ui {
namespace {

struct Pair {
    QRgb light;
    QRgb dark;
};

// In the order of Token. Chosen so that the checks in tests/ui hold: contrast on every surface, and a distance that
// red-green-blind eyes still see (measured against predicted differ in lightness, not only in hue).
constexpr std::array<Pair, kTokenCount> kColors{{
    {0xFFD6D9DB, 0xFF15191C},  // ground
    {0xFFE6E8E9, 0xFF1E2428},  // panel
    {0xFFF4F5F5, 0xFF283035},  // raised
    {0xFFB4BABE, 0xFF3A444A},  // line
    {0xFF1B2126, 0xFFE8ECEE},  // text
    {0xFF525B62, 0xFF9AA6AD},  // dim
    {0xFF145079, 0xFF4F9DD0},  // measured
    {0xFF1B2126, 0xFFE8ECEE},  // wanted
    {0xFF8468BE, 0xFFCBBFF3},  // predicted
    {0xFF6E5610, 0xFFD9C27A},  // limit
    {0xFF9AA3A8, 0xFF5C686F},  // past
    {0xFFC62828, 0xFFFF6B60},  // alarm 1
    {0xFFCC6600, 0xFFFF9426},  // alarm 2
    {0xFFD0AE00, 0xFFFFD84A},  // alarm 3
    {0xFF2E7D5B, 0xFF5CC79A},  // acting
}};

double linear(double channel) {
    return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double luminance(const QColor& c) {
    return 0.2126 * linear(c.redF()) + 0.7152 * linear(c.greenF()) + 0.0722 * linear(c.blueF());
}

}  // namespace

QColor Palette::color(Token token) const {
    const Pair& pair = kColors[static_cast<std::size_t>(token)];
    return QColor::fromRgb(m_brightness == Brightness::Light ? pair.light : pair.dark);
}

QColor Palette::band(Token token) const {
    QColor c = color(token);
    c.setAlphaF(0.18F);
    return c;
}

QColor Palette::grid() const {
    QColor c = color(Token::Line);
    c.setAlphaF(0.5F);
    return c;
}

Token Palette::alarm(int priority) {
    return priority <= 1 ? Token::Alarm1 : priority == 2 ? Token::Alarm2 : Token::Alarm3;
}

QColor Palette::on(const QColor& area) {
    const QColor ink = Palette(Brightness::Light).color(Token::Text);
    const QColor paper = Palette(Brightness::Dark).color(Token::Text);
    return contrast(ink, area) >= contrast(paper, area) ? ink : paper;
}

double Palette::contrast(const QColor& a, const QColor& b) {
    const double la = luminance(a);
    const double lb = luminance(b);
    return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

}  // namespace kerf::ui
