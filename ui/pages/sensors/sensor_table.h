// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHeaderView>
#include <QScroller>
#include <QTableWidget>

namespace kerf::ui {

/// A table for reading by touch; rows as high as their words.
[[nodiscard]] inline QTableWidget* makeSensorTable(const char* name, int columns, QWidget* parent) {
    auto* table = new QTableWidget(0, columns, parent);
    table->setObjectName(QLatin1String(name));
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setSelectionMode(QAbstractItemView::SingleSelection);
    table->setWordWrap(true);
    table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    table->verticalHeader()->hide();
    table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    // A column that becomes narrower, for a scroll bar too, has words in more lines.
    QObject::connect(table->horizontalHeader(), &QHeaderView::sectionResized, table,
                     &QTableWidget::resizeRowsToContents, Qt::QueuedConnection);
    QScroller::grabGesture(table->viewport(), QScroller::TouchGesture);
    return table;
}

inline void setSensorCell(QTableWidget* table, int row, int column, const QString& text) {
    QTableWidgetItem* item = table->item(row, column);
    if (item == nullptr) {
        item = new QTableWidgetItem;
        table->setItem(row, column, item);
    }
    if (item->text() != text) {
        item->setText(text);
    }
}

}  // namespace kerf::ui
