// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/boring/measurement_list.h"

#include <QHeaderView>
#include <QScroller>

#include "ui/pages/boring/boring_texts.h"

namespace kerf::ui {
namespace {
enum ItemRole { PartRole = Qt::UserRole, DepthRole, MeasurementRole };
}

MeasurementList::MeasurementList(Look& look, const BoringService& service, QWidget* parent)
    : QTableWidget(parent), m_look(look), m_service(service) {
    setObjectName(QStringLiteral("boringMeasurementList"));
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionMode(QAbstractItemView::NoSelection);
    setShowGrid(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    verticalHeader()->hide();
    verticalHeader()->setDefaultSectionSize(m_look.metrics().touch());
    verticalHeader()->setMinimumSectionSize(m_look.metrics().touch());
    QScroller::grabGesture(viewport(), QScroller::TouchGesture);
    setMinimumHeight(5 * m_look.metrics().touch());
    connect(this, &QTableWidget::cellClicked, this, [this](int row, int column) {
        const QTableWidgetItem* touched = item(row, column);
        if (touched == nullptr || column == 0) {
            return;
        }
        const qint64 part = touched->data(PartRole).toLongLong();
        const int depth = touched->data(DepthRole).toInt();
        const qint64 measurement = touched->data(MeasurementRole).toLongLong();
        if (measurement != 0) {
            emit measurementTouched(part, depth, measurement);
        } else {
            emit openPlaceTouched(part, depth);
        }
    });
    refreshView();
}

void MeasurementList::refreshView() {
    const BoringServiceView& view = m_service.view();
    const int depths = static_cast<int>(view.depths.size());
    setColumnCount(depths + 1);
    QStringList titles{tr("part")};
    for (const DepthView& depth : view.depths) {
        titles << tr("⌀ %1").arg(depthName(depth)) + QStringLiteral(", ") + m_look.units().of("mm").symbol;
    }
    setHorizontalHeaderLabels(titles);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    setRowCount(static_cast<int>(view.parts.size()));
    for (int row = 0; row < rowCount(); ++row) {
        const BorePartView& part = view.parts[view.parts.size() - 1 - static_cast<std::size_t>(row)];
        setItem(row, 0, new QTableWidgetItem(QString::number(part.number)));
        for (int depth = 0; depth < depths; ++depth) {
            const BoreMeasurementView* m = measurementAt(part, static_cast<std::uint8_t>(depth));
            auto* cell = new QTableWidgetItem;
            if (m == nullptr) {
                cell->setText(tr("enter"));
                cell->setForeground(m_look.color(Token::Dim));
            } else {
                const QString value = m_look.units().number(m->diameter_mm, "mm", kDiameterDecimals);
                const quality::Verdict verdict = boreVerdict(view, m->diameter_mm);
                QString text = m->corrected ? tr("%1 (corrected)").arg(value) : value;
                if (isBad(verdict)) {
                    text += QStringLiteral(" · ") + verdictText(verdict);
                    cell->setForeground(
                        m_look.color(verdict == quality::Verdict::Scrap ? Token::Alarm1 : Token::Alarm2));
                }
                cell->setText(text);
            }
            cell->setData(PartRole, static_cast<qlonglong>(part.id));
            cell->setData(DepthRole, depth);
            cell->setData(MeasurementRole, m == nullptr ? 0LL : static_cast<qlonglong>(m->id));
            setItem(row, depth + 1, cell);
        }
    }
}

}  // namespace kerf::ui
