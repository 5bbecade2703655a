// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace kerf::ui {

/// Sizes of type. Nothing on the screen is smaller than Label.
enum class TextSize { Label, Body, Card, Page };
/// Distances: 2-4-8-16 at 96 dpi.
enum class Space { Hair, Small, Medium, Large };
/// Widths of pens.
enum class Stroke { Thin, Normal, Bold };

/// Logical millimetres to pixels. The only place with literal sizes: everything else asks by name.
class Metrics {
 public:
    static constexpr double kMinScale = 0.8;
    static constexpr double kMaxScale = 2.5;

    /// @param dpi logical dots per inch of the screen; @param scale the user's factor, clamped to kMinScale…kMaxScale
    explicit Metrics(double dpi = 96.0, double scale = 1.0);

    [[nodiscard]] double scale() const { return m_scale; }
    [[nodiscard]] double pxPerMm() const { return m_pxPerMm; }
    [[nodiscard]] int px(double size_mm) const;
    [[nodiscard]] int text(TextSize size) const;  ///< font pixel size
    [[nodiscard]] int space(Space step) const;
    [[nodiscard]] double stroke(Stroke width) const;
    [[nodiscard]] int touch() const;     ///< smallest side of anything to be touched: 15 mm
    [[nodiscard]] int touchGap() const;  ///< between two such things: 3 mm
    [[nodiscard]] int lamp() const;
    [[nodiscard]] int icon() const;    ///< diameter of a lamp
    [[nodiscard]] int corner() const;  ///< radius of a card's corner
    [[nodiscard]] int navWidth() const;
    [[nodiscard]] int sideWidth() const;  ///< a column beside a chart: keypad, next part
    [[nodiscard]] int sparkline() const;  ///< height
    [[nodiscard]] int chart() const;      ///< smallest useful height of a chart with axes

 private:
    double m_scale;
    double m_pxPerMm;
};

}  // namespace kerf::ui
