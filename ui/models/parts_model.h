// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <optional>
#include <vector>

#include "db/api/part_reader.h"
#include "ui/units/unit_system.h"

namespace kerf::ui {

/// Parts as a table, newest first, read page by page as the view scrolls. Values are shown in the operator's unit;
/// switching it changes no stored value and reads nothing again. Texts are asked for anew after retranslate().
class PartsModel final : public QAbstractTableModel {
    Q_OBJECT
 public:
    enum Column { Part, Serial, PartType, Lot, Ended, Result, Diameters, Changes, ColumnCount };
    enum Role {
        PartIdRole = Qt::UserRole + 1,  ///< qlonglong
        CompleteRole,                   ///< bool: false for an aborted part
        ChangedRole,                    ///< bool: a measurement of it was corrected or voided
    };
    static constexpr std::uint32_t kPageSize = 100;
    static constexpr std::uint64_t kCountedAtMost = 100'000;

    /// `reader` must outlive the model.
    explicit PartsModel(PartReader& reader, QObject* parent = nullptr);

    /// Which parts; paging fields are ignored. Reads the first page.
    void setQuery(const PartQuery& query);
    [[nodiscard]] const PartQuery& query() const { return m_query; }
    void setUnits(const UnitSystem& units);
    void retranslate();
    /// Takes in what is new: parts on top, and changed measurements of parts shown on the first page. Keeps the
    /// selection.
    void update();

    /// How many parts match, counted up to kCountedAtMost.
    [[nodiscard]] std::uint64_t matches() const { return m_matches; }
    [[nodiscard]] std::optional<PartRow> row(int index) const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    [[nodiscard]] bool canFetchMore(const QModelIndex& parent) const override;
    void fetchMore(const QModelIndex& parent) override;

 signals:
    /// Reading failed; the table shows what it had.
    void problem(const kerf::Sentence& sentence);

 private:
    [[nodiscard]] std::optional<std::vector<PartRow>> read(const PartQuery& query);
    void count();
    [[nodiscard]] QString text(const PartRow& part, int column) const;

    PartReader& m_reader;
    PartQuery m_query{};
    UnitSystem m_units{};
    std::vector<PartRow> m_rows;
    bool m_more{false};
    std::uint64_t m_matches{0};
};

}  // namespace kerf::ui
