// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/shift_report.h"

#include <QCoreApplication>
#include <QDateTime>

#include "app/console/report_sheet.h"
#include "ui/link/shift_texts.h"
#include "ui/link/texts.h"

namespace kerf::console {
namespace {

struct ShiftReport {
    Q_DECLARE_TR_FUNCTIONS(ShiftReport)
};

constexpr qsizetype kMostRows = 9;  // of each list: one page holds them all

QString minuteOf(std::int64_t utc_ms) {
    return QDateTime::fromMSecsSinceEpoch(utc_ms).toString(QStringLiteral("HH:mm"));
}

void list(ReportSheet& sheet, const QString& title, const QList<QStringList>& rows, const std::vector<double>& shares,
          const QString& none) {
    sheet.skip(3.0);
    sheet.font(11.0, true);
    sheet.line(title);
    sheet.font(9.0);
    for (qsizetype i = 0; i < qMin(kMostRows, rows.size()); ++i) {
        sheet.row(rows[i], shares);
    }
    if (rows.isEmpty()) {
        sheet.line(none, 5.0);
    } else if (rows.size() > kMostRows) {
        sheet.line(ShiftReport::tr("and %n more", nullptr, static_cast<int>(rows.size() - kMostRows)), 5.0);
    }
}

void draw(ReportSheet& sheet, const ShiftView& shift, const AlarmSpecOf& specOf) {
    sheet.font(18.0, true);
    sheet.line(ShiftReport::tr("Shift"), 10.0);
    sheet.font(11.0);
    const auto instant = [](std::int64_t utc_ms) {
        return QDateTime::fromMSecsSinceEpoch(utc_ms).toString(QStringLiteral("yyyy-MM-dd HH:mm"));
    };
    sheet.line(ShiftReport::tr("%1 to %2").arg(instant(shift.fromUtc_ms), instant(shift.toUtc_ms)));
    QList<QStringList> parts;
    for (const ShiftParts& row : shift.parts) {
        parts << QStringList{ui::processName(row.process), ui::shiftPartsText(row)};
    }
    list(sheet, ShiftReport::tr("Parts"), parts, {.2, .8}, ShiftReport::tr("No part was finished."));
    sheet.font(9.0);
    sheet.line(ui::shiftSavingText(shift.saving), 5.0);
    QList<QStringList> stops;
    for (const ShiftStop& stop : shift.stops) {
        stops << QStringList{
            QStringLiteral("%1–%2").arg(minuteOf(stop.fromUtc_ms), minuteOf(stop.toUtc_ms)),
            ShiftReport::tr("%n minutes", nullptr, static_cast<int>((stop.toUtc_ms - stop.fromUtc_ms) / 60'000)),
            ui::stopReasonText(stop.reason), QString::fromStdString(stop.author)};
    }
    list(sheet, ShiftReport::tr("Stops"), stops, {.2, .2, .35, .25},
         ShiftReport::tr("Nothing stood longer than three minutes."));
    QList<QStringList> changes;
    for (const ShiftChange& change : shift.changes) {
        changes << QStringList{minuteOf(change.utc_ms), QString::fromStdString(change.author), ui::changeText(change)};
    }
    list(sheet, ShiftReport::tr("Changes"), changes, {.1, .22, .68}, ShiftReport::tr("Nothing was changed."));
    QList<QStringList> alarms;
    for (const ShiftAlarm& alarm : shift.alarms) {
        alarms << QStringList{minuteOf(alarm.lastUtc_ms), ui::alarmText(specOf(alarm.code), alarm.code).title,
                              QStringLiteral("%1×").arg(alarm.times)};
    }
    list(sheet, ShiftReport::tr("Alarms"), alarms, {.1, .75, .15}, ShiftReport::tr("No alarm came."));
    QList<QStringList> notes;
    for (const ShiftNote& note : shift.notes) {
        notes << QStringList{minuteOf(note.utc_ms), QString::fromStdString(note.author),
                             QString::fromStdString(note.text)};
    }
    list(sheet, ShiftReport::tr("Notes"), notes, {.1, .22, .68}, ShiftReport::tr("No note was left."));
    sheet.skip(10.0);
    sheet.font(9.0);
    sheet.row(
        {ShiftReport::tr("Handed over: ____________________"), ShiftReport::tr("Taken over: ____________________")},
        {.5, .5});
}

}  // namespace

Result<void> writeShiftReport(const ShiftView& shift, const ui::UnitSystem&, const AlarmSpecOf& specOf,
                              const QString& file) {
    return writeReport(ShiftReport::tr("Shift"), file, [&](ReportSheet& sheet) { draw(sheet, shift, specOf); });
}

}  // namespace kerf::console
