// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <functional>
#include <optional>
#include <vector>

#include "db/api/part_reader.h"
#include "engine/quality/verdict.h"
#include "ui/units/unit_system.h"

namespace kerf::ui {

/// Parts as a table, newest first, read page by page as the view scrolls. Values are shown in the operator's unit;
/// switching it changes no stored value and reads nothing again. Texts are asked for anew after retranslate().
class PartsModel final : public QAbstractTableModel {
    Q_OBJECT
 public:
    enum Column { Part, Serial, PartType, Lot, Ended, Result, Diameters, Changes, Verdict, ColumnCount };
    enum Role {
        PartIdRole = Qt::UserRole + 1,  ///< qlonglong
        CompleteRole,                   ///< bool: false for an aborted part
        ChangedRole,                    ///< bool: a measurement of it was corrected or voided
    };
    static constexpr std::uint32_t kPageSize = 100;
    static constexpr std::uint64_t kCountedAtMost = 100'000;
    /// Parts looked at for one more page of parts out of tolerance: what is further back comes as the view scrolls on.
    static constexpr std::uint32_t kLookedAt = 2'000;
    using VerdictOf = std::function<quality::Verdict(const PartRow&)>;

    /// `reader` must outlive the model.
    explicit PartsModel(PartReader& reader, QObject* parent = nullptr);

    /// Which parts; paging fields are ignored. Reads the first page.
    void setQuery(const PartQuery& query);
    [[nodiscard]] const PartQuery& query() const { return m_query; }
    /// Who judges the parts; without one none is judged.
    void setVerdicts(VerdictOf verdictOf) { m_verdictOf = std::move(verdictOf); }
    /// Only parts that are out of tolerance, from the next setQuery() on.
    void setOnlyBad(bool onlyBad) { m_onlyBad = onlyBad; }
    [[nodiscard]] bool onlyBad() const { return m_onlyBad; }
    void setUnits(const UnitSystem& units);
    void retranslate();
    /// Takes in what is new: parts on top, and changed measurements of parts shown on the first page. Keeps the
    /// selection.
    void update();

    /// How many parts match, counted up to kCountedAtMost.
    [[nodiscard]] std::uint64_t matches() const { return m_matches; }
    /// With onlyBad(): parts looked at so far; the rows are those of them that are out of tolerance.
    [[nodiscard]] std::uint64_t lookedAt() const { return m_lookedAt; }
    [[nodiscard]] quality::Verdict verdict(const PartRow& part) const {
        return m_verdictOf ? m_verdictOf(part) : quality::Verdict::NotJudged;
    }
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
    /// The next parts behind m_oldest that are to be shown, sets m_more.
    [[nodiscard]] std::optional<std::vector<PartRow>> readOn();
    void count();
    [[nodiscard]] QString text(const PartRow& part, int column) const;

    PartReader& m_reader;
    PartQuery m_query{};
    UnitSystem m_units{};
    std::vector<PartRow> m_rows;
    VerdictOf m_verdictOf{};
    bool m_onlyBad{false};
    std::optional<PartId> m_oldest{};  ///< of the parts read
    std::uint64_t m_lookedAt{0};
    bool m_more{false};
    std::uint64_t m_matches{0};
};

}  // namespace kerf::ui
