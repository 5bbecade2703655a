// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <QStyledItemDelegate>
#include <optional>
#include <vector>

#include "db/api/rows.h"
#include "ui/link/alarm_list.h"
#include "ui/theme/look.h"

namespace kerf::ui {

/// One line of the alarm table, from this run or from the history.
struct AlarmLine {
    AlarmCode code{0};
    int priority{3};
    std::string detailText{};
    std::vector<SentenceArg> detailArgs{};
    QDateTime raised{};
    std::optional<QDateTime> cleared{};
    std::optional<QDateTime> acknowledged{};
    QString acknowledgedBy{};
    bool firstOut{false};
    bool endedByRestart{false};
};
[[nodiscard]] AlarmLine alarmLine(const AlarmEntry& entry);
[[nodiscard]] AlarmLine alarmLine(const AlarmRow& row);

class AlarmModel : public QAbstractTableModel {
    Q_OBJECT
 public:
    enum Column { SignColumn, AlarmColumn, RaisedColumn, StateColumn, kColumns };

    AlarmModel(Look& look, const AlarmList& alarms, QObject* parent = nullptr);

    void setLines(std::vector<AlarmLine> lines);
    [[nodiscard]] const AlarmLine* line(int row) const;
    [[nodiscard]] QString detail(const AlarmLine& line) const;
    void retranslate();

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
    [[nodiscard]] QString stateText(const AlarmLine& line) const;

    Look& m_look;
    const AlarmList& m_alarms;
    std::vector<AlarmLine> m_lines;
};

/// Draws the sign of the priority into the first column.
class SignDelegate : public QStyledItemDelegate {
    Q_OBJECT
 public:
    explicit SignDelegate(Look& look, QObject* parent = nullptr) : QStyledItemDelegate(parent), m_look(look) {}
    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
    Look& m_look;
};

}  // namespace kerf::ui
