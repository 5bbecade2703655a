// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/milling/cut_log.h"

#include <QCoreApplication>
#include <QHeaderView>
#include <QScroller>
#include <QTableWidget>

#include "ui/link/texts.h"
#include "ui/pages/milling/milling_texts.h"

namespace kerf::ui {
namespace {

struct MillingCutLog {
    Q_DECLARE_TR_FUNCTIONS(MillingCutLog)
};

void fillRow(QTableWidget& table, int row, const MillingCutView& view, const UnitSystem& units) {
    const MillingCut& cut = view.cut;
    const QStringList cells{
        view.complete ? QString::number(view.number) : MillingCutLog::tr("%1, aborted").arg(view.number),
        lawName(cut.law),
        cut.advised ? modeName(LoopMode::Advise) : modeName(LoopMode::Control),
        units.number(cut.plannedTime_s, "s", 1),
        units.number(cut.controlledTime_s, "s", 1),
        units.number(cut.peakForce_N, "N", kForceDecimals),
        units.number(cut.peakAt_mm, "mm", 1),
        units.number(cut.waviness_um, "um", kWallDecimals),
        QString::number(cut.stops),
    };
    for (int column = 0; column < cells.size(); ++column) {
        auto* item = new QTableWidgetItem(cells[column]);
        item->setTextAlignment(Qt::AlignVCenter | (column == 1 || column == 2 ? Qt::AlignLeft : Qt::AlignRight));
        table.setItem(row, column, item);
    }
}

}  // namespace

void openMillingCutLog(SheetHost& host, Look& look, const MillingService& service) {
    const UnitSystem& units = look.units();
    Sheet* sheet =
        host.open(MillingCutLog::tr("Last cuts"),
                  MillingCutLog::tr("An advised cut was made at the planned feed; its controlled time is what "
                                    "control would have taken."));
    auto* table = new QTableWidget(sheet);
    table->setObjectName(QStringLiteral("millingCutLog"));
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setSelectionMode(QAbstractItemView::NoSelection);
    table->verticalHeader()->hide();
    table->verticalHeader()->setDefaultSectionSize(look.metrics().touch() / 2);
    QScroller::grabGesture(table->viewport(), QScroller::TouchGesture);
    const QStringList titles{MillingCutLog::tr("cut"),
                             MillingCutLog::tr("law"),
                             MillingCutLog::tr("mode"),
                             MillingCutLog::tr("planned\n%1").arg(units.of("s").symbol),
                             MillingCutLog::tr("controlled\n%1").arg(units.of("s").symbol),
                             MillingCutLog::tr("peak\n%1").arg(units.of("N").symbol),
                             MillingCutLog::tr("at\n%1").arg(units.of("mm").symbol),
                             MillingCutLog::tr("waviness\n%1").arg(units.of("um").symbol),
                             MillingCutLog::tr("stops")};
    table->setColumnCount(static_cast<int>(titles.size()));
    table->setHorizontalHeaderLabels(titles);
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
    const std::vector<MillingCutView>& cuts = service.view().cuts;
    table->setRowCount(static_cast<int>(cuts.size()));
    for (int row = 0; row < table->rowCount(); ++row) {
        fillRow(*table, row, cuts[cuts.size() - 1 - static_cast<std::size_t>(row)], units);
    }
    table->setMinimumHeight(5 * look.metrics().touch());
    sheet->body()->addWidget(table);
    sheet->addButton(MillingCutLog::tr("Close"), {})->setObjectName(QStringLiteral("millingCutLogClose"));
}

}  // namespace kerf::ui
