// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPainter>
#include <QPdfWriter>
#include <QStringList>
#include <functional>
#include <optional>
#include <vector>

#include "engine/core/result.h"
#include "ui/services/quality_service.h"
#include "ui/units/unit_system.h"

namespace kerf::console {

inline constexpr int kReportResolution_dpi = 300;
inline constexpr double kReportMargin_mm = 18.0;

/// A pen that walks down the pages of a report; everything in millimetres.
class ReportSheet {
 public:
    explicit ReportSheet(QPdfWriter& pdf);

    [[nodiscard]] QPainter& painter() { return m_painter; }
    [[nodiscard]] double mm(double length) const { return length * m_perMm; }
    [[nodiscard]] double width() const { return m_width; }
    [[nodiscard]] double y() const { return m_y; }
    void skip(double height_mm) { m_y += mm(height_mm); }
    void font(double size_pt, bool bold = false);
    /// A line of text, wrapped where it is too long.
    void line(const QString& text, double height_mm = 6.0);
    /// Cells beside each other; each takes its share of the width.
    void row(const QStringList& cells, const std::vector<double>& shares);
    void rule();
    /// A new page when less than this is left.
    void reserve(double height_mm);

 private:
    QPdfWriter& m_pdf;
    QPainter m_painter;
    double m_perMm;
    double m_width;
    double m_y{0.0};
};

/// A value of a characteristic in the unit that is shown, without it; a dash where there is none.
[[nodiscard]] QString characteristicValue(const Characteristic& characteristic, const std::optional<double>& value,
                                          const ui::UnitSystem& units);

/// A report of one file: A4, title, Kerf's margins; `prepare` has the writer before the first stroke (attachments). It
/// takes its name last; a folder that is not there is made.
[[nodiscard]] Result<void> writeReport(const QString& title, const QString& file,
                                       const std::function<void(ReportSheet& sheet)>& draw,
                                       const std::function<void(QPdfWriter& pdf)>& prepare = {});

}  // namespace kerf::console
