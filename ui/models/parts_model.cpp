// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/parts_model.h"

#include <QDateTime>
#include <QLocale>
#include <algorithm>
#include <utility>

#include "ui/link/texts.h"
#include "ui/link/verdict_text.h"

namespace kerf::ui {
namespace {

constexpr int kDiameterDecimals = 3;  // of the stored mm

bool changed(const PartRow& part) {
    return std::any_of(part.measurements.begin(), part.measurements.end(),
                       [](const MeasurementRow& row) { return row.kind != MeasurementKind::Entry; });
}

bool sameContent(const PartRow& a, const PartRow& b) {
    return a.id == b.id && a.serial == b.serial && a.measurements.size() == b.measurements.size();
}

}  // namespace

PartsModel::PartsModel(PartReader& reader, QObject* parent) : QAbstractTableModel(parent), m_reader(reader) {}

void PartsModel::setQuery(const PartQuery& query) {
    PartQuery wanted = query;
    wanted.before.reset();
    wanted.after.reset();
    wanted.oldestFirst = false;
    wanted.limit = kPageSize;
    const PartQuery before = std::exchange(m_query, wanted);
    m_oldest.reset();
    m_lookedAt = 0;
    std::optional<std::vector<PartRow>> page = readOn();
    if (!page) {
        m_query = before;
        return;
    }
    beginResetModel();
    m_rows = std::move(*page);
    count();
    endResetModel();
}

std::optional<std::vector<PartRow>> PartsModel::readOn() {
    std::vector<PartRow> shown;
    PartQuery next = m_query;
    for (std::uint32_t looked = 0; looked < kLookedAt && shown.size() < kPageSize;) {
        next.before = m_oldest;
        std::optional<std::vector<PartRow>> page = read(next);
        if (!page) {
            m_more = false;  // no endless asking; update() or setQuery() begins anew
            return std::nullopt;
        }
        m_more = page->size() == kPageSize;
        looked += static_cast<std::uint32_t>(page->size());
        m_lookedAt += page->size();
        if (!page->empty()) {
            m_oldest = page->back().id;
        }
        for (PartRow& part : *page) {
            if (!m_onlyBad || isBad(verdict(part))) {
                shown.push_back(std::move(part));
            }
        }
        if (!m_more || !m_onlyBad) {
            break;
        }
    }
    return shown;
}

void PartsModel::setUnits(const UnitSystem& units) {
    if (units == m_units) {
        return;
    }
    m_units = units;
    retranslate();
}

void PartsModel::retranslate() {
    emit headerDataChanged(Qt::Horizontal, 0, ColumnCount - 1);
    if (!m_rows.empty()) {
        emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
    }
}

void PartsModel::update() {
    if (m_onlyBad) {
        setQuery(m_query);  // a correction may take a part in or out
        return;
    }
    std::optional<std::vector<PartRow>> page = read(m_query);
    if (!page) {
        return;
    }
    const PartId newestShown = m_rows.empty() ? 0 : m_rows.front().id;
    const auto known = std::find_if(page->begin(), page->end(), [&](const PartRow& p) { return p.id <= newestShown; });
    if (m_rows.empty() || (known == page->end() && page->size() == kPageSize)) {
        setQuery(m_query);  // more has come than one page: begin again
        return;
    }
    const auto added = static_cast<int>(known - page->begin());
    if (added > 0) {
        beginInsertRows({}, 0, added - 1);
        m_rows.insert(m_rows.begin(), page->begin(), known);
        endInsertRows();
    }
    for (std::size_t i = static_cast<std::size_t>(added); i < page->size() && i < m_rows.size(); ++i) {
        PartRow& fresh = (*page)[i];
        if (m_rows[i].id == fresh.id && !sameContent(m_rows[i], fresh)) {
            m_rows[i] = std::move(fresh);
            emit dataChanged(index(static_cast<int>(i), 0), index(static_cast<int>(i), ColumnCount - 1));
        }
    }
    if (added > 0) {
        count();
    }
}

std::optional<PartRow> PartsModel::row(int index) const {
    if (index < 0 || index >= rowCount()) {
        return std::nullopt;
    }
    return m_rows[static_cast<std::size_t>(index)];
}

int PartsModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int PartsModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant PartsModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid)) {
        return {};
    }
    const PartRow& part = m_rows[static_cast<std::size_t>(index.row())];
    switch (role) {
        case Qt::DisplayRole:
            return text(part, index.column());
        case Qt::TextAlignmentRole:
            return QVariant::fromValue(index.column() == Part || index.column() == Diameters
                                           ? Qt::Alignment(Qt::AlignRight | Qt::AlignVCenter)
                                           : Qt::Alignment(Qt::AlignLeft | Qt::AlignVCenter));
        case PartIdRole:
            return static_cast<qlonglong>(part.id);
        case CompleteRole:
            return part.complete;
        case ChangedRole:
            return changed(part);
        default:
            return {};
    }
}

QString PartsModel::text(const PartRow& part, int column) const {
    switch (column) {
        case Part:
            return QString::number(part.number);
        case Serial:
            return QString::fromStdString(part.serial);
        case PartType:
            return QString::fromStdString(part.partTypeName);
        case Lot:
            return QString::fromStdString(part.lotName);
        case Ended:
            return QDateTime::fromMSecsSinceEpoch(part.endedUtc_ms).toString(QStringLiteral("yyyy-MM-dd HH:mm"));
        case Result:
            return part.complete ? tr("finished") : tr("aborted");
        case Diameters: {
            if (!part.figures.empty()) {
                return figureText(part.process, part.figures.front(), m_units);
            }
            std::vector<MeasurementRow> rows = effectiveMeasurements(part.measurements);
            std::stable_sort(rows.begin(), rows.end(),
                             [](const MeasurementRow& a, const MeasurementRow& b) { return a.station < b.station; });
            QString shown;
            for (const MeasurementRow& row : rows) {
                shown += (shown.isEmpty() ? QString() : QStringLiteral("   ")) +
                         m_units.number(*row.diameter_mm, "mm", kDiameterDecimals);
            }
            return shown;
        }
        case Changes: {
            const auto count = [&part](MeasurementKind kind) {
                return static_cast<int>(std::count_if(part.measurements.begin(), part.measurements.end(),
                                                      [kind](const MeasurementRow& row) { return row.kind == kind; }));
            };
            const int corrected = count(MeasurementKind::Correction);
            const int voided = count(MeasurementKind::Void);
            QStringList words;
            if (corrected > 0) {
                words << tr("%1 corrected").arg(corrected);
            }
            if (voided > 0) {
                words << tr("%1 voided").arg(voided);
            }
            return words.join(QStringLiteral(", "));
        }
        case Verdict:
            return verdictText(verdict(part));
        default:
            return {};
    }
}

QVariant PartsModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
        return QAbstractTableModel::headerData(section, orientation, role);
    }
    switch (section) {
        case Part:
            return tr("Part");
        case Serial:
            return tr("Serial number");
        case PartType:
            return tr("Part type");
        case Lot:
            return tr("Lot");
        case Ended:
            return tr("Ended");
        case Result:
            return tr("Result");
        case Diameters:
            return tr("Measured, bores in %1").arg(m_units.of("mm").symbol);
        case Changes:
            return tr("Changes");
        case Verdict:
            return tr("Verdict");
        default:
            return {};
    }
}

bool PartsModel::canFetchMore(const QModelIndex& parent) const {
    return !parent.isValid() && m_more;
}

void PartsModel::fetchMore(const QModelIndex& parent) {
    if (!canFetchMore(parent)) {
        return;
    }
    std::optional<std::vector<PartRow>> page = readOn();
    if (page && !page->empty()) {
        beginInsertRows({}, rowCount(), rowCount() + static_cast<int>(page->size()) - 1);
        m_rows.insert(m_rows.end(), std::make_move_iterator(page->begin()), std::make_move_iterator(page->end()));
        endInsertRows();
    }
}

std::optional<std::vector<PartRow>> PartsModel::read(const PartQuery& query) {
    auto rows = m_reader.parts(query);
    if (!rows) {
        emit problem(rows.error());
        return std::nullopt;
    }
    return std::move(*rows);
}

void PartsModel::count() {
    if (const auto counted = m_reader.count(m_query, kCountedAtMost)) {
        m_matches = *counted;
    }
}

}  // namespace kerf::ui
