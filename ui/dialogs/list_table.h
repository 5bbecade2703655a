// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHeaderView>
#include <QList>
#include <QScroller>
#include <QStringList>
#include <QTableWidget>
#include <set>

#include "ui/theme/look.h"

namespace kerf::ui {

/// A list on a sheet, of which one row is touched: as wide as its words, what is left to the `wide` columns, scrolled
/// by hand. Row `bold` (from 0; none: −1) is the one that holds.
inline QTableWidget* makeListTable(Look& look, const char* name, const QStringList& heads,
                                   const QList<QStringList>& rows, const std::set<int>& wide, QWidget* parent,
                                   int bold = -1) {
    auto* table = new QTableWidget(static_cast<int>(rows.size()), static_cast<int>(heads.size()), parent);
    table->setObjectName(QLatin1String(name));
    table->setHorizontalHeaderLabels(heads);
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setSelectionMode(QAbstractItemView::SingleSelection);
    table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table->verticalHeader()->hide();
    table->verticalHeader()->setDefaultSectionSize(look.metrics().touch());
    table->setShowGrid(false);
    QScroller::grabGesture(table->viewport(), QScroller::TouchGesture);
    for (int row = 0; row < table->rowCount(); ++row) {
        for (int column = 0; column < table->columnCount(); ++column) {
            auto* item = new QTableWidgetItem(rows[row].value(column));
            QFont font = item->font();
            font.setBold(row == bold);
            item->setData(Qt::FontRole, row == bold ? QVariant(font) : QVariant());
            table->setItem(row, column, item);
        }
    }
    table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    for (int column = 0; column < table->columnCount(); ++column) {
        table->horizontalHeader()->setSectionResizeMode(
            column, wide.contains(column) ? QHeaderView::Stretch : QHeaderView::ResizeToContents);
    }
    return table;
}

}  // namespace kerf::ui
