// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/lot_report.h"

#include <fmt/format.h>

#include <QCoreApplication>
#include <QDateTime>
#include <QPageLayout>
#include <QPageSize>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "app/console/report_sheet.h"
#include "app/service/quality/lot_dfq.h"
#include "ui/charts/decimate.h"
#include "ui/link/texts.h"
#include "ui/pages/quality/gauge_sheet.h"
#include "ui/pages/quality/quality_panels.h"

namespace kerf::console {
namespace {

struct LotReport {
    Q_DECLARE_TR_FUNCTIONS(LotReport)
};

constexpr double kChart_mm = 48.0;
constexpr std::size_t kChartedParts = 200;
constexpr double kLimit = 3.0;

QString text(const std::string& utf8) {
    return QString::fromStdString(utf8);
}

QString when(std::int64_t utc_ms) {
    return QDateTime::fromMSecsSinceEpoch(utc_ms).toString(QStringLiteral("yyyy-MM-dd HH:mm"));
}

/// Points over part numbers, with horizontal lines.
void drawChart(ReportSheet& sheet, const QString& title, const QPolygonF& points, const std::vector<double>& lines,
               int decimals) {
    sheet.reserve(kChart_mm + 10.0);
    sheet.font(9.0, true);
    sheet.line(title, 5.0);
    if (points.isEmpty()) {
        sheet.font(9.0);
        sheet.line(LotReport::tr("Nothing to show yet."));
        return;
    }
    double low = points.front().y();
    double high = low;
    for (const QPointF& p : points) {
        low = std::min(low, p.y());
        high = std::max(high, p.y());
    }
    for (const double line : lines) {
        low = std::min(low, line);
        high = std::max(high, line);
    }
    const double margin = std::max(1e-9, 0.05 * (high - low));
    low -= margin;
    high += margin;
    const double first = points.front().x();
    const double last = std::max(points.back().x(), first + 1.0);
    const QRectF plot(sheet.mm(16.0), sheet.y(), sheet.width() - sheet.mm(18.0), sheet.mm(kChart_mm - 8.0));
    const auto place = [&](double x, double y) {
        return QPointF(plot.left() + (x - first) / (last - first) * plot.width(),
                       plot.bottom() - (y - low) / (high - low) * plot.height());
    };
    QPainter& painter = sheet.painter();
    sheet.font(7.0);
    painter.setPen(QPen(Qt::lightGray, sheet.mm(0.15)));
    painter.drawRect(plot);
    for (const double line : lines) {
        painter.setPen(QPen(Qt::darkYellow, sheet.mm(0.25), Qt::DashLine));
        painter.drawLine(place(first, line), place(last, line));
        painter.setPen(Qt::black);
        painter.drawText(QRectF(0.0, place(first, line).y() - sheet.mm(3.0), sheet.mm(14.5), sheet.mm(6.0)),
                         Qt::AlignRight | Qt::AlignVCenter, ui::UnitSystem::fixed(line, decimals));
    }
    painter.setPen(QPen(Qt::darkBlue, sheet.mm(0.3)));
    QPolygonF placed;
    for (const QPointF& p : points) {
        placed << place(p.x(), p.y());
    }
    painter.drawPolyline(placed);
    painter.setBrush(Qt::darkBlue);
    for (const QPointF& p : placed) {
        painter.drawEllipse(p, sheet.mm(0.5), sheet.mm(0.5));
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(Qt::black);
    painter.drawText(QRectF(plot.left(), plot.bottom(), plot.width(), sheet.mm(5.0)), Qt::AlignLeft | Qt::AlignTop,
                     LotReport::tr("part %1").arg(first));
    painter.drawText(QRectF(plot.left(), plot.bottom(), plot.width(), sheet.mm(5.0)), Qt::AlignRight | Qt::AlignTop,
                     LotReport::tr("part %1").arg(points.back().x()));
    sheet.skip(kChart_mm - 2.0);
}

QString titleOf(const QualityLot& lot, bool firstArticle) {
    const LotRow& row = lot.history.lot;
    if (row.id < 0) {
        return LotReport::tr("%1: newest parts").arg(ui::processName(row.process));
    }
    return firstArticle ? LotReport::tr("First article of %2, lot %1").arg(text(row.name), text(row.partTypeName))
                        : LotReport::tr("Lot %1 of %2").arg(text(row.name), text(row.partTypeName));
}

void drawHeader(ReportSheet& sheet, const QualityLot& lot, const LotPapers& papers) {
    const LotRow& row = lot.history.lot;
    sheet.font(18.0, true);
    sheet.line(titleOf(lot, papers.firstArticle), 10.0);
    sheet.font(10.0);
    if (row.id > 0) {
        sheet.line(LotReport::tr("%1 on %2, recipe revision %3, opened %4")
                       .arg(ui::processName(row.process), text(row.machineName))
                       .arg(lot.quality.recipeRevision)
                       .arg(when(row.openedUtc_ms)));
        sheet.line(LotReport::tr("Drawing, order: ____________________"));
    }
    if (papers.firstArticle && !lot.quality.parts.empty()) {
        const LotPart& part = lot.quality.parts.front();
        sheet.line(LotReport::tr("Part %1").arg(part.number) + QStringLiteral(", ") + when(part.endedUtc_ms));
        sheet.font(12.0, true);
        sheet.line(LotReport::tr("Verdict: %1").arg(ui::verdictText(part.judgement.verdict)));
        sheet.skip(2.0);
        return;
    }
    if (!lot.history.parts.empty()) {
        sheet.line(LotReport::tr("Parts %1 to %2, %3 to %4")
                       .arg(lot.history.parts.front().part.number)
                       .arg(lot.history.parts.back().part.number)
                       .arg(when(lot.history.parts.front().part.endedUtc_ms),
                            when(lot.history.parts.back().part.endedUtc_ms)));
    }
    sheet.line(LotReport::tr("%1 parts: %2 good, %3 rework possible, %4 scrap, %5 not judged")
                   .arg(lot.quality.parts.size())
                   .arg(lot.quality.good)
                   .arg(lot.quality.rework)
                   .arg(lot.quality.scrap)
                   .arg(lot.quality.notJudged));
    sheet.line(ui::sentenceText(lot.quality.sentence));
    sheet.skip(2.0);
}

/// The only part, characteristic by characteristic.
void drawFirstArticle(ReportSheet& sheet, const QualityLot& lot, const ui::UnitSystem& units) {
    const std::vector<double> shares{0.36, 0.14, 0.28, 0.22};
    sheet.font(10.0, true);
    sheet.row(
        {LotReport::tr("Characteristic"), LotReport::tr("Found"), LotReport::tr("Tolerance"), LotReport::tr("Verdict")},
        shares);
    sheet.rule();
    sheet.font(10.0);
    for (std::size_t i = 0; i < lot.quality.characteristics.size() && !lot.quality.parts.empty(); ++i) {
        const Characteristic& what = lot.quality.characteristics[i];
        const JudgedValue& found = lot.quality.parts.front().judgement.values[i];
        sheet.row({ui::characteristicName(what), characteristicValue(what, found.value, units),
                   LotReport::tr("%1 to %2")
                       .arg(characteristicValue(what, found.tolerance.lower, units),
                            characteristicValue(what, found.tolerance.upper, units)),
                   ui::verdictText(found.verdict)},
                  shares);
    }
    sheet.skip(4.0);
}

void drawCharacteristics(ReportSheet& sheet, const QualityLot& lot, const ui::UnitSystem& units) {
    const LotQuality& quality = lot.quality;
    for (std::size_t i = 0; i < quality.characteristics.size(); ++i) {
        const Characteristic& what = quality.characteristics[i];
        sheet.reserve(kChart_mm + 40.0);
        sheet.font(11.0, true);
        sheet.line(ui::characteristicName(what));
        sheet.font(9.0);
        sheet.line(LotReport::tr("Tolerance %1 to %2, mean %3, s %4")
                       .arg(characteristicValue(what, what.tolerance.lower, units),
                            characteristicValue(what, what.tolerance.upper, units),
                            characteristicValue(what, quality.capability[i].mean, units),
                            ui::UnitSystem::fixed(quality.capability[i].deviation, what.decimals + 2)),
                   5.0);
        sheet.line(ui::capabilityText(quality.capability[i], units), 5.0);
        std::array<std::uint32_t, 4> verdicts{};
        for (const LotPart& part : quality.parts) {
            ++verdicts[static_cast<std::size_t>(part.judgement.values[i].verdict)];
        }
        const auto count = [&verdicts](quality::Verdict verdict) {
            return verdicts[static_cast<std::size_t>(verdict)];
        };
        sheet.line(LotReport::tr("Verdicts: %1 good, %2 rework possible, %3 scrap, %4 not judged")
                       .arg(count(quality::Verdict::Good))
                       .arg(count(quality::Verdict::Rework))
                       .arg(count(quality::Verdict::Scrap))
                       .arg(count(quality::Verdict::NotJudged)),
                   5.0);
        QPolygonF points;
        for (const LotPart& part : quality.parts) {
            if (const auto& value = part.judgement.values[i].value) {
                points << QPointF(part.number, *value);
            }
        }
        std::vector<double> lines;
        for (const auto& limit : {what.tolerance.lower, what.tolerance.upper}) {
            if (limit) {
                lines.push_back(*limit);
            }
        }
        drawChart(sheet, LotReport::tr("Measured, with tolerance"),
                  points.size() > static_cast<qsizetype>(kChartedParts) ? points.last(kChartedParts) : points, lines,
                  what.decimals);
    }
    QPolygonF errors;
    for (const ChartedPart& part : quality.charted) {
        errors << QPointF(part.number, part.error);
    }
    drawChart(sheet, LotReport::tr("Error against the law, σ"),
              errors.size() > static_cast<qsizetype>(kChartedParts) ? errors.last(kChartedParts) : errors,
              {-kLimit, kLimit}, 1);
}

void drawBadParts(ReportSheet& sheet, const QualityLot& lot, const std::map<PartId, Disposition>& dispositions,
                  const ui::UnitSystem& units) {
    sheet.reserve(30.0);
    sheet.font(11.0, true);
    sheet.line(LotReport::tr("Parts out of tolerance"));
    sheet.font(9.0);
    const std::vector<double> shares{0.12, 0.2, 0.38, 0.3};
    bool any = false;
    for (const LotPart& part : lot.quality.parts) {
        if (part.judgement.verdict != quality::Verdict::Scrap && part.judgement.verdict != quality::Verdict::Rework) {
            continue;
        }
        any = true;
        QStringList values;
        for (std::size_t i = 0; i < part.judgement.values.size(); ++i) {
            values << characteristicValue(lot.quality.characteristics[i], part.judgement.values[i].value, units);
        }
        const auto decided = dispositions.find(part.id);
        sheet.reserve(10.0);
        sheet.row({LotReport::tr("part %1").arg(part.number), ui::verdictText(part.judgement.verdict),
                   values.join(QStringLiteral(" / ")),
                   decided == dispositions.end()
                       ? LotReport::tr("no decision yet")
                       : ui::engineText(decided->second.what.c_str()) + QStringLiteral(", ") +
                             text(decided->second.author) + QStringLiteral(", ") + when(decided->second.utc_ms)},
                  shares);
    }
    if (!any) {
        sheet.line(LotReport::tr("None."));
    }
}

void drawCorrections(ReportSheet& sheet, const QualityLot& lot, const ui::UnitSystem& units) {
    sheet.reserve(30.0);
    sheet.font(11.0, true);
    sheet.line(LotReport::tr("Corrections"));
    sheet.font(9.0);
    bool any = false;
    for (const PartDetail& detail : lot.history.parts) {
        for (const MeasurementRow& row : detail.part.measurements) {
            if (!row.replaces) {
                continue;
            }
            any = true;
            const auto before = std::ranges::find(detail.part.measurements, *row.replaces, &MeasurementRow::id);
            const auto shown = [&units](const std::optional<double>& value_mm) {
                return value_mm ? units.number(*value_mm, "mm", 3) : LotReport::tr("taken out");
            };
            sheet.reserve(10.0);
            sheet.line(
                LotReport::tr("Part %1: %2 → %3, %4, %5: %6")
                    .arg(detail.part.number)
                    .arg(before == detail.part.measurements.end() ? QStringLiteral("–") : shown(before->diameter_mm),
                         shown(row.diameter_mm), text(row.author), when(row.acceptedUtc_ms), text(row.reason)),
                5.0);
        }
    }
    if (!any) {
        sheet.line(LotReport::tr("None."));
    }
}

QString changeText(const std::string& key) {
    return key == "reground"   ? LotReport::tr("tool reground")
           : key == "material" ? LotReport::tr("other material")
           : key == "insert"   ? LotReport::tr("new insert")
                               : LotReport::tr("no change after all");
}

void drawSignals(ReportSheet& sheet, const QualityLot& lot, const LotPapers& papers) {
    sheet.reserve(30.0);
    sheet.font(11.0, true);
    sheet.line(LotReport::tr("Signals and changes of the process"));
    sheet.font(9.0);
    for (const auto& [part, change] : papers.changes) {
        sheet.reserve(8.0);
        sheet.line(LotReport::tr("From part %1 on: %2").arg(part).arg(changeText(change)), 5.0);
    }
    for (const QualitySignal& signal : lot.quality.found) {
        sheet.reserve(8.0);
        sheet.line(LotReport::tr("Part %1: %2").arg(signal.part).arg(ui::engineText(quality::ruleText(signal.rule))),
                   5.0);
    }
    for (const ChartedPart& part : lot.quality.charted) {
        if (part.perturbed) {
            sheet.reserve(8.0);
            sheet.line(LotReport::tr("Part %1: the estimator noticed a process change.").arg(part.number), 5.0);
        }
    }
    if (papers.changes.empty() && lot.quality.found.empty() &&
        std::ranges::none_of(lot.quality.charted, &ChartedPart::perturbed)) {
        sheet.line(LotReport::tr("None."));
    }
}

void drawAlarms(ReportSheet& sheet, const LotPapers& papers, const AlarmSpecOf& specOf) {
    sheet.reserve(30.0);
    sheet.font(11.0, true);
    sheet.line(LotReport::tr("Alarms during the lot"));
    sheet.font(9.0);
    for (const AlarmRow& row : papers.alarms) {
        sheet.reserve(8.0);
        const ui::AlarmText words = ui::alarmText(specOf ? specOf(row.code) : nullptr, row.code);
        QString line = when(row.raisedUtc_ms) + QStringLiteral(": ") + words.title;
        if (const QString detail = ui::sentenceText(row.detailText, row.detailArgs); !detail.isEmpty()) {
            line += QStringLiteral(" – ") + detail;
        }
        if (row.acknowledgedUtc_ms) {
            line += QStringLiteral(", ") + LotReport::tr("acknowledged by %1").arg(text(row.acknowledgedBy));
        }
        sheet.line(line, 5.0);
    }
    if (papers.alarms.empty()) {
        sheet.line(LotReport::tr("None."));
    }
}

void drawGauges(ReportSheet& sheet, const QualityLot& lot, const LotPapers& papers, const ui::UnitSystem& units) {
    sheet.reserve(30.0);
    sheet.font(11.0, true);
    sheet.line(LotReport::tr("Gauges"));
    sheet.font(9.0);
    const std::int64_t now_ms = QDateTime::currentMSecsSinceEpoch();
    for (const Gauge& gauge : papers.gauges) {
        sheet.line(text(gauge.identity) + QStringLiteral(": ") + ui::dueText(gauge, now_ms) +
                       (gauge.sigma_mm ? QStringLiteral(", σ ") + units.withUnit(*gauge.sigma_mm, "mm", 4) : QString()),
                   5.0);
        if (const QString study = ui::studyFigures(gauge, units); !study.isEmpty()) {
            sheet.line(study + QStringLiteral(": ") +
                           (gauge.pass ? LotReport::tr("good enough") : LotReport::tr("not good enough")),
                       5.0);
        }
    }
    QStringList sources;
    for (const PartGroup& group : lot.quality.groups) {
        if (group.by == PartGroup::By::Source) {
            std::size_t values = 0;
            for (const quality::Capability& capability : group.capability) {
                values += capability.count;
            }
            sources << LotReport::tr("%1: %2", "where from, how many").arg(ui::groupName(group)).arg(values);
        }
    }
    if (!sources.isEmpty()) {
        sheet.line(LotReport::tr("Values: %1").arg(sources.join(QStringLiteral("; "))), 5.0);
    }
    if (lot.quality.gaugeSigma_mm > 0.0) {
        sheet.line(LotReport::tr("σ of the estimator: %1").arg(units.withUnit(lot.quality.gaugeSigma_mm, "mm", 4)),
                   5.0);
    }
}

void drawSignature(ReportSheet& sheet, const LotPapers& papers) {
    sheet.reserve(36.0);
    sheet.skip(4.0);
    sheet.font(7.0);
    sheet.line(
        LotReport::tr("Head of the audit chain: entry %1, %2").arg(papers.auditEntry).arg(text(papers.auditHash)));
    sheet.skip(14.0);
    sheet.rule();
    sheet.font(9.0);
    sheet.line(LotReport::tr("Date, name, signature"), 5.0);
    sheet.font(7.0);
    sheet.line(LotReport::tr("Kerf %1, written %2. The data is attached as DFQ and CSV.")
                   .arg(QStringLiteral(KERF_VERSION), when(QDateTime::currentMSecsSinceEpoch())));
}

/// A serial number as one field of a CSV file.
std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) {
        return text;
    }
    std::string field = "\"";
    for (const char c : text) {
        field += c == '"' ? "\"\"" : std::string(1, c);
    }
    return field + '"';
}

}  // namespace

std::string lotCsv(const QualityLot& lot) {
    std::string csv = "number,serial,characteristic,value,unit,lower,upper,verdict,part_verdict\n";
    const auto number = [](const std::optional<double>& value) {
        return value ? fmt::format("{:.17g}", *value) : std::string{};
    };
    for (const LotPart& part : lot.quality.parts) {
        for (std::size_t i = 0; i < part.judgement.values.size(); ++i) {
            const Characteristic& what = lot.quality.characteristics[i];
            const JudgedValue& found = part.judgement.values[i];
            fmt::format_to(std::back_inserter(csv), "{},{},{},{},{},{},{},{},{}\n", part.number, quoted(part.serial),
                           what.key, number(found.value), what.unit, number(found.tolerance.lower),
                           number(found.tolerance.upper), quality::verdictKey(found.verdict),
                           quality::verdictKey(part.judgement.verdict));
        }
    }
    return csv;
}

Result<void> writeLotReport(const QualityLot& lot, const LotPapers& papers, const ui::UnitSystem& units,
                            const AlarmSpecOf& specOf, const QString& file) {
    const auto attach = [&lot](QPdfWriter& pdf) {
        pdf.setPdfVersion(QPagedPaintDevice::PdfVersion_A1b);
        pdf.addFileAttachment(QStringLiteral("lot.dfq"),
                              QByteArray::fromStdString(dfq::write(lotDfq(lot.history, lot.quality))),
                              QStringLiteral("application/octet-stream"));
        pdf.addFileAttachment(QStringLiteral("lot.csv"), QByteArray::fromStdString(lotCsv(lot)),
                              QStringLiteral("text/csv"));
    };
    const auto draw = [&](ReportSheet& sheet) {
        drawHeader(sheet, lot, papers);
        papers.firstArticle ? drawFirstArticle(sheet, lot, units) : drawCharacteristics(sheet, lot, units);
        drawBadParts(sheet, lot, papers.dispositions, units);
        drawCorrections(sheet, lot, units);
        if (!papers.firstArticle) {
            drawSignals(sheet, lot, papers);
            drawAlarms(sheet, papers, specOf);
        }
        drawGauges(sheet, lot, papers, units);
        drawSignature(sheet, papers);
    };
    return writeReport(titleOf(lot, papers.firstArticle), file, draw, attach);
}

}  // namespace kerf::console
