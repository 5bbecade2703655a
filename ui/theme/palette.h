// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <array>
#include <cstddef>

namespace kerf::ui {

enum class Brightness { Light, Dark };

/// What a colour means. Grey is the normal case; a colour has one meaning everywhere.
enum class Token {
    Ground,     ///< page
    Panel,      ///< card
    Raised,     ///< control
    Line,       ///< separators, axes
    Text,       ///< values
    Dim,        ///< labels, units
    Measured,   ///< the live curve, the measured point
    Wanted,     ///< reference, schedule, target: drawn dashed
    Predicted,  ///< model; its interval is band()
    Limit,      ///< tolerance and limit lines, thin
    Past,       ///< earlier parts, first tap
    Alarm1,     ///< act now; always with an octagon and a word
    Alarm2,     ///< act soon; with a triangle
    Alarm3,     ///< know; with a diamond
    Acting,     ///< a loop that is controlling: a small lamp, never an area
};
inline constexpr std::size_t kTokenCount = 15;
inline constexpr std::array<Token, kTokenCount> kAllTokens{
    Token::Ground, Token::Panel,    Token::Raised, Token::Line,      Token::Text,
    Token::Dim,    Token::Measured, Token::Wanted, Token::Predicted, Token::Limit,
    Token::Past,   Token::Alarm1,   Token::Alarm2, Token::Alarm3,    Token::Acting};

/// The only place with literal colours (a test in tests/arch sees to it).
class Palette {
 public:
    explicit Palette(Brightness brightness = Brightness::Light) : m_brightness(brightness) {}

    [[nodiscard]] Brightness brightness() const { return m_brightness; }
    [[nodiscard]] QColor color(Token token) const;
    /// The token as an area: 18 % of it, for intervals.
    [[nodiscard]] QColor band(Token token) const;
    /// Grid lines: Line at half strength.
    [[nodiscard]] QColor grid() const;
    /// Token of an alarm priority 1…3.
    [[nodiscard]] static Token alarm(int priority);
    /// Text that stands on an area filled with `token`: whichever of the two extremes reads better.
    [[nodiscard]] static QColor on(const QColor& area);

    /// WCAG contrast ratio, 1…21.
    [[nodiscard]] static double contrast(const QColor& a, const QColor& b);

 private:
    Brightness m_brightness;
};

}  // namespace kerf::ui
