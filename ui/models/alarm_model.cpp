// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/alarm_model.h"

#include <QPainter>

#include "ui/link/texts.h"
#include "ui/widgets/sign.h"

namespace kerf::ui {
namespace {

QString when(const QDateTime& time) {
    const bool today = time.date() == QDate::currentDate();
    return time.toString(today ? QStringLiteral("HH:mm:ss") : QStringLiteral("yyyy-MM-dd HH:mm"));
}

std::optional<QDateTime> local(const std::optional<std::int64_t>& utc_ms) {
    return utc_ms ? std::optional(QDateTime::fromMSecsSinceEpoch(*utc_ms)) : std::nullopt;
}

}  // namespace

AlarmLine alarmLine(const AlarmEntry& entry) {
    AlarmLine line;
    line.code = entry.code;
    line.priority = entry.priority;
    line.detailText = entry.detail.text;
    line.detailArgs.assign(entry.detail.args.begin(), entry.detail.args.begin() + entry.detail.argCount);
    line.raised = entry.raised;
    line.cleared = entry.cleared;
    line.acknowledged = entry.acknowledged;
    line.acknowledgedBy = entry.acknowledgedBy;
    line.firstOut = entry.firstOut;
    return line;
}

AlarmLine alarmLine(const AlarmRow& row) {
    AlarmLine line;
    line.code = row.code;
    line.priority = row.priority;
    line.detailText = row.detailText;
    line.detailArgs = row.detailArgs;
    line.raised = QDateTime::fromMSecsSinceEpoch(row.raisedUtc_ms);
    line.cleared = local(row.clearedUtc_ms);
    line.acknowledged = local(row.acknowledgedUtc_ms);
    line.acknowledgedBy = QString::fromStdString(row.acknowledgedBy);
    line.endedByRestart = row.endedByRestart;
    return line;
}

AlarmModel::AlarmModel(Look& look, const AlarmList& alarms, QObject* parent)
    : QAbstractTableModel(parent), m_look(look), m_alarms(alarms) {}

void AlarmModel::setLines(std::vector<AlarmLine> lines) {
    beginResetModel();
    m_lines = std::move(lines);
    endResetModel();
}

const AlarmLine* AlarmModel::line(int row) const {
    return row >= 0 && row < static_cast<int>(m_lines.size()) ? &m_lines[static_cast<std::size_t>(row)] : nullptr;
}

QString AlarmModel::detail(const AlarmLine& line) const {
    return sentenceText(line.detailText, line.detailArgs, m_look.units());
}

void AlarmModel::retranslate() {
    emit headerDataChanged(Qt::Horizontal, 0, kColumns - 1);
    if (!m_lines.empty()) {
        emit dataChanged(index(0, 0), index(static_cast<int>(m_lines.size()) - 1, kColumns - 1));
    }
}

int AlarmModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_lines.size());
}

int AlarmModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : kColumns;
}

QString AlarmModel::stateText(const AlarmLine& line) const {
    if (!line.cleared && !line.endedByRestart) {
        return line.acknowledged ? tr("stands, seen by %1").arg(line.acknowledgedBy) : tr("stands");
    }
    if (line.endedByRestart) {
        return tr("stood at the last restart");
    }
    return line.acknowledged ? tr("gone %1, seen by %2").arg(when(*line.cleared), line.acknowledgedBy)
                             : tr("gone %1").arg(when(*line.cleared));
}

QVariant AlarmModel::data(const QModelIndex& index, int role) const {
    const AlarmLine* at = line(index.row());
    if (at == nullptr) {
        return {};
    }
    if (role == Qt::UserRole) {
        return at->priority;
    }
    if (role == Qt::DisplayRole) {
        switch (index.column()) {
            case SignColumn:
                return QString::number(at->priority);
            case AlarmColumn: {
                const QString title = alarmText(m_alarms.spec(at->code), at->code).title;
                const QString numbers = detail(*at);
                return numbers.isEmpty() ? title : title + QStringLiteral(" – ") + numbers;
            }
            case RaisedColumn:
                return at->firstOut ? tr("%1, first").arg(when(at->raised)) : when(at->raised);
            case StateColumn:
                return stateText(*at);
            default:
                return {};
        }
    }
    if (role == Qt::FontRole && index.column() == AlarmColumn && !at->acknowledged) {
        return m_look.font(TextSize::Body, QFont::DemiBold);
    }
    return {};
}

QVariant AlarmModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
        return {};
    }
    switch (section) {
        case SignColumn:
            return tr("Prio.");
        case AlarmColumn:
            return tr("Alarm");
        case RaisedColumn:
            return tr("Since");
        case StateColumn:
            return tr("State");
        default:
            return {};
    }
}

void SignDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
    QStyleOptionViewItem plain = option;
    initStyleOption(&plain, index);
    const int priority = index.data(Qt::UserRole).toInt();
    const int side = m_look.metrics().touch() * 2 / 5;
    const QRectF cell = option.rect;
    const QRectF box(cell.left() + m_look.space(Space::Medium), cell.center().y() - side / 2.0, side, side);
    paintSign(*painter, box, signOfAlarm(priority), m_look);
    painter->setFont(m_look.font(TextSize::Body));
    painter->setPen(m_look.color(Token::Text));
    painter->drawText(cell.adjusted(side + 2 * m_look.space(Space::Medium), 0, 0, 0), Qt::AlignVCenter | Qt::AlignLeft,
                      plain.text);
}

QSize SignDelegate::sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const {
    return {m_look.metrics().touch(), m_look.metrics().touch()};
}

}  // namespace kerf::ui
