// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/part_report.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QPainter>
#include <algorithm>

#include "app/console/report_sheet.h"
#include "app/service/quality/characteristics.h"
#include "ui/charts/decimate.h"
#include "ui/link/texts.h"
#include "ui/link/verdict_text.h"
#include "ui/pages/quality/quality_panels.h"

namespace kerf::console {
namespace {

struct PartReport {
    Q_DECLARE_TR_FUNCTIONS(PartReport)
};

constexpr double kChart_mm = 70.0;
constexpr int kPointsOfCurve = 64;
constexpr int kDecimals = 3;

using Sheet = ReportSheet;

void drawFeed(Sheet& sheet, const PartDetail& part, const ui::UnitSystem& units) {
    const BoringSchedule& schedule = part.schedule->schedule;
    const ui::DisplayUnit across = units.of("mm");
    const ui::DisplayUnit up = units.of("mm/rev");
    const double from = across.toShown(schedule.overhangFrom_mm);
    const double to = across.toShown(schedule.overhangTo_mm);
    QPolygonF wanted;
    QPolygonF cut;
    double highest = 0.0;
    for (int i = 0; i < kPointsOfCurve; ++i) {
        const double overhang_mm =
            std::lerp(schedule.overhangFrom_mm, schedule.overhangTo_mm, i / (kPointsOfCurve - 1.0));
        wanted << QPointF(across.toShown(overhang_mm), up.toShown(schedule.feed_mmPerRev(overhang_mm)));
        highest = std::max(highest, wanted.last().y());
    }
    for (std::size_t i = 0; i < part.feed.count; ++i) {
        cut << QPointF(across.toShown(static_cast<double>(part.feed.overhang_mm[i])),
                       up.toShown(static_cast<double>(part.feed.feed_mmPerRev[i])));
        highest = std::max(highest, cut.last().y());
    }
    const ui::AxisRange yRange = ui::roundRange(0.0, highest);
    const ui::AxisRange xRange = ui::roundRange(from, to);
    const QRectF plot(sheet.mm(14.0), sheet.y(), sheet.width() - sheet.mm(16.0), sheet.mm(kChart_mm - 12.0));
    const auto place = [&](const QPointF& p) {
        return QPointF(plot.left() + (p.x() - from) / (to - from) * plot.width(),
                       plot.bottom() - (p.y() - yRange.from) / (yRange.to - yRange.from) * plot.height());
    };
    QPainter& painter = sheet.painter();
    sheet.font(8.0);
    const double thin = sheet.mm(0.15);
    for (double tick = yRange.from; tick <= yRange.to + yRange.step / 2.0; tick += yRange.step) {
        const double y = place({from, tick}).y();
        painter.setPen(QPen(Qt::lightGray, thin));
        painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
        painter.setPen(Qt::black);
        painter.drawText(QRectF(0.0, y - sheet.mm(3.0), sheet.mm(12.5), sheet.mm(6.0)),
                         Qt::AlignRight | Qt::AlignVCenter, ui::UnitSystem::fixed(tick, yRange.decimals));
    }
    for (double tick = xRange.from; tick <= to + 1e-9; tick += xRange.step) {
        if (tick < from - 1e-9) {
            continue;
        }
        const double x = place({tick, 0.0}).x();
        painter.setPen(QPen(Qt::lightGray, thin));
        painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
        painter.setPen(Qt::black);
        painter.drawText(QRectF(x - sheet.mm(10.0), plot.bottom() + sheet.mm(0.5), sheet.mm(20.0), sheet.mm(5.0)),
                         Qt::AlignCenter, ui::UnitSystem::fixed(tick, xRange.decimals));
    }
    const auto curve = [&](const QPolygonF& points, const QPen& pen) {
        QPolygonF placed;
        for (const QPointF& p : points) {
            placed << place(p);
        }
        painter.setPen(pen);
        painter.drawPolyline(placed);
    };
    curve(cut, QPen(Qt::darkBlue, sheet.mm(0.5)));
    curve(wanted, QPen(Qt::black, sheet.mm(0.3), Qt::DashLine));
    painter.setPen(Qt::black);
    sheet.skip(kChart_mm - 6.0);
    sheet.line(PartReport::tr("Feed over overhang, %1 over %2: dashed the schedule, solid as cut.", "units")
                   .arg(up.symbol, across.symbol));
}

QString whatHappened(const MeasurementRow& row) {
    QString what;
    switch (row.kind) {
        case MeasurementKind::Entry:
            what = ui::sourceText(row.source, row.sourceName);
            break;
        case MeasurementKind::Correction:
            what = PartReport::tr("correction") + QStringLiteral(", ") + ui::sourceText(row.source, row.sourceName);
            break;
        case MeasurementKind::Void:
            what = PartReport::tr("taken out");
            break;
    }
    if (row.confirmed) {
        what += QStringLiteral(", ") + PartReport::tr("confirmed");
    }
    return row.reason.empty() ? what : what + QStringLiteral(": ") + QString::fromStdString(row.reason);
}

void drawMeasurements(Sheet& sheet, const PartRow& part, const ui::UnitSystem& units) {
    const std::vector<double> shares{0.14, 0.16, 0.3, 0.4};
    sheet.font(10.0, true);
    sheet.row({PartReport::tr("Depth"), PartReport::tr("⌀, %1").arg(units.of("mm").symbol), PartReport::tr("By, when"),
               PartReport::tr("What, why")},
              shares);
    sheet.rule();
    sheet.font(10.0);
    for (const MeasurementRow& row : part.measurements) {
        const bool replaced = std::ranges::any_of(
            part.measurements, [&row](const MeasurementRow& later) { return later.replaces == row.id; });
        const QString value = row.diameter_mm ? units.number(*row.diameter_mm, "mm", kDecimals) : QStringLiteral("–");
        QString what = whatHappened(row);
        if (replaced && row.kind != MeasurementKind::Void) {
            what += QStringLiteral(" – ") + PartReport::tr("no longer holds");
        }
        sheet.row({units.withUnit(row.position_mm, "mm", 0), value,
                   QString::fromStdString(row.author) + QStringLiteral(", ") +
                       QDateTime::fromMSecsSinceEpoch(row.acceptedUtc_ms).toString(QStringLiteral("yyyy-MM-dd HH:mm")),
                   what},
                  shares);
    }
    if (part.measurements.empty()) {
        sheet.line(PartReport::tr("Nothing was measured."));
    }
}

void drawVerdicts(Sheet& sheet, const PartRow& part, const std::vector<Characteristic>& characteristics,
                  const std::optional<Disposition>& decided, const ui::UnitSystem& units) {
    const PartJudgement judged = judgePart(part, characteristics);
    sheet.font(11.0, true);
    sheet.line(PartReport::tr("Verdict: %1").arg(ui::verdictText(judged.verdict)));
    if (judged.verdict == quality::Verdict::Rework || judged.verdict == quality::Verdict::Scrap) {
        sheet.font(10.0);
        sheet.line(
            decided
                ? PartReport::tr("Decided: %1, by %2, %3")
                      .arg(ui::engineText(decided->what.c_str()), QString::fromStdString(decided->author),
                           QDateTime::fromMSecsSinceEpoch(decided->utc_ms).toString(QStringLiteral("yyyy-MM-dd HH:mm")))
                : PartReport::tr("Nobody has decided yet what is done with it."));
    }
    sheet.font(10.0);
    const std::vector<double> shares{0.34, 0.14, 0.32, 0.2};
    for (std::size_t i = 0; i < characteristics.size(); ++i) {
        const Characteristic& what = characteristics[i];
        const auto text = [&](const std::optional<double>& value) { return characteristicValue(what, value, units); };
        sheet.row({ui::characteristicName(what), text(judged.values[i].value),
                   PartReport::tr("%1 to %2", "limits").arg(text(what.tolerance.lower), text(what.tolerance.upper)),
                   ui::verdictText(judged.values[i].verdict)},
                  shares);
    }
}

QString titleOf(const PartRow& part) {
    return part.lotName.empty()
               ? PartReport::tr("Part %1").arg(part.number)
               : PartReport::tr("Part %1, lot %2").arg(part.number).arg(QString::fromStdString(part.lotName));
}

void draw(ReportSheet& sheet, const PartDetail& detail, const std::vector<Characteristic>& characteristics,
          const std::optional<Disposition>& decided, const ui::UnitSystem& units) {
    const PartRow& part = detail.part;
    sheet.font(18.0, true);
    sheet.line(titleOf(part), 10.0);
    sheet.font(11.0);
    sheet.line(part.serial.empty() ? PartReport::tr("No serial number")
                                   : PartReport::tr("Serial number %1").arg(QString::fromStdString(part.serial)));
    const double time_s = static_cast<double>(part.machineEnd_ns - part.machineBegin_ns) * 1e-9;
    QStringList facts{ui::processName(part.process), QString::fromStdString(part.partTypeName),
                      QDateTime::fromMSecsSinceEpoch(part.endedUtc_ms).toString(QStringLiteral("yyyy-MM-dd HH:mm")),
                      PartReport::tr("cut in %1 s").arg(ui::UnitSystem::fixed(time_s, 0)),
                      part.complete ? PartReport::tr("finished") : PartReport::tr("aborted")};
    facts.removeAll(QString());
    sheet.line(facts.join(QStringLiteral(" · ")));
    for (const PartFigure& figure : part.figures) {
        sheet.line(ui::figureText(part.process, figure, units));
    }
    if (std::ranges::any_of(detail.states, &EstimatorStateRow::perturbed)) {
        sheet.line(PartReport::tr("The estimator noticed a process change with this part."));
    }
    sheet.skip(2.0);
    drawVerdicts(sheet, part, characteristics, decided, units);
    sheet.skip(4.0);
    if (detail.schedule && part.process == ProcessId::Boring) {
        drawFeed(sheet, detail, units);
        sheet.skip(4.0);
        drawMeasurements(sheet, part, units);
    }
    sheet.skip(6.0);
    sheet.font(8.0);
    sheet.line(PartReport::tr("Kerf %1, written %2")
                   .arg(QStringLiteral(KERF_VERSION),
                        QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd HH:mm"))));
}

}  // namespace

Result<void> writePartReport(const PartDetail& part, const std::vector<Characteristic>& characteristics,
                             const std::optional<Disposition>& decided, const ui::UnitSystem& units,
                             const QString& file) {
    return writeReport(titleOf(part.part), file,
                       [&](ReportSheet& sheet) { draw(sheet, part, characteristics, decided, units); });
}

}  // namespace kerf::console
