// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/report_sheet.h"

#include <QBuffer>
#include <QDir>
#include <QFileInfo>
#include <QSaveFile>
#include <algorithm>

namespace kerf::console {
namespace {

constexpr double kLine_mm = 6.0;
constexpr double kMillimetresPerInch = 25.4;

}  // namespace

QString characteristicValue(const Characteristic& characteristic, const std::optional<double>& value,
                            const ui::UnitSystem& units) {
    if (!value) {
        return QStringLiteral("–");
    }
    return characteristic.unit == "mm" ? units.number(*value, "mm", characteristic.decimals)
                                       : ui::UnitSystem::fixed(*value, characteristic.decimals);
}

ReportSheet::ReportSheet(QPdfWriter& pdf)
    : m_pdf(pdf), m_painter(&pdf), m_perMm(kReportResolution_dpi / kMillimetresPerInch), m_width(pdf.width()) {}

void ReportSheet::font(double size_pt, bool bold) {
    QFont font(QStringLiteral("Noto Sans"));
    font.setFamilies({QStringLiteral("Noto Sans"), QStringLiteral("Noto Sans CJK KR")});
    font.setPointSizeF(size_pt);
    font.setBold(bold);
    m_painter.setFont(font);
}

void ReportSheet::line(const QString& text, double height_mm) {
    const QRectF wanted(0.0, m_y, m_width, mm(4.0 * height_mm));
    QRectF used;
    m_painter.drawText(wanted, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, text, &used);
    m_y += std::max(mm(height_mm), used.height());
}

void ReportSheet::row(const QStringList& cells, const std::vector<double>& shares) {
    double x = 0.0;
    double height = mm(kLine_mm);
    for (qsizetype i = 0; i < cells.size(); ++i) {
        const double cell = shares[static_cast<std::size_t>(i)] * m_width;
        QRectF used;
        m_painter.drawText(QRectF(x, m_y, cell - mm(2.0), mm(4.0 * kLine_mm)),
                           Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, cells[i], &used);
        height = std::max(height, used.height() + mm(1.0));
        x += cell;
    }
    m_y += height;
}

void ReportSheet::rule() {
    m_painter.drawLine(QPointF(0.0, m_y), QPointF(m_width, m_y));
    m_y += mm(1.5);
}

void ReportSheet::reserve(double height_mm) {
    if (m_y + mm(height_mm) > m_pdf.height()) {
        m_pdf.newPage();
        m_y = 0.0;
    }
}

Result<void> writeReport(const QString& title, const QString& file, const std::function<void(ReportSheet& sheet)>& draw,
                         const std::function<void(QPdfWriter& pdf)>& prepare) {
    QBuffer bytes;
    bytes.open(QIODevice::WriteOnly);
    {
        QPdfWriter pdf(&bytes);
        if (prepare) {
            prepare(pdf);
        }
        pdf.setResolution(kReportResolution_dpi);
        pdf.setPageSize(QPageSize(QPageSize::A4));
        pdf.setPageMargins(QMarginsF(kReportMargin_mm, kReportMargin_mm, kReportMargin_mm, kReportMargin_mm),
                           QPageLayout::Millimeter);
        pdf.setTitle(title);
        pdf.setCreator(QStringLiteral("Kerf"));
        ReportSheet sheet(pdf);
        draw(sheet);
    }
    QDir().mkpath(QFileInfo(file).absolutePath());
    QSaveFile target(file);
    if (!target.open(QIODevice::WriteOnly) || target.write(bytes.data()) != bytes.size() || !target.commit()) {
        return fail(KERF_TEXT("The file cannot be written there. Choose another folder."));
    }
    return {};
}

}  // namespace kerf::console
