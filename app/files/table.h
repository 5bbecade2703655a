// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/files/cell.h"
#include "app/files/column_name.h"
#include "app/files/table_layout.h"
#include "app/files/whole_file.h"

namespace kerf::files {

/// A row that has another number of fields than the header.
class WrongWidth : public BadInput {
 public:
    WrongWidth(const std::string& sentence, std::uint32_t line, std::size_t fields)
        : BadInput(sentence), m_line(line), m_fields(fields) {}
    [[nodiscard]] std::uint32_t line() const noexcept { return m_line; }
    [[nodiscard]] std::size_t fields() const noexcept { return m_fields; }

 private:
    std::uint32_t m_line;
    std::size_t m_fields;
};

/// A table of numbers out of any program's file, read whole. What is read and what is refused: docs/data.md.
///
/// Columns are found by name when they are asked for, in any order, whatever case and whatever spelling of the unit; a
/// column declared in another unit of the same kind is converted, and told. Columns nobody asks for are never looked
/// at. Everything that was found out rather than known is in notes().
class Table {
 public:
    /// @throws BadInput when the file cannot be read, or a row has the wrong number of fields
    /// `texts`, if given, gets every field as it stands in the file, row by row.
    [[nodiscard]] static Table read(const std::string& path, const ReadOptions& options = {},
                                    std::vector<std::string>* texts = nullptr);
    /// `name` stands in front of every complaint. @throws BadInput
    [[nodiscard]] static Table parse(std::string_view bytes, const std::string& name, const ReadOptions& options = {},
                                     std::vector<std::string>* texts = nullptr);

    [[nodiscard]] const std::string& file() const noexcept { return m_path; }
    [[nodiscard]] std::size_t rows() const noexcept { return m_lines.size(); }
    /// As they stand in the file; a column without a name is "".
    [[nodiscard]] const std::vector<std::string>& names() const noexcept { return m_names; }
    [[nodiscard]] const ColumnName& nameOf(std::size_t column) const { return m_parsed.at(column); }
    /// The column that is meant by `name`; nothing when there is none. @throws BadInput when two could be meant
    [[nodiscard]] std::optional<std::size_t> find(std::string_view name) const;
    [[nodiscard]] bool has(std::string_view name) const { return find(name).has_value(); }
    /// Every value. @throws BadInput naming the file and the missing column, or line and column of a cell without one
    [[nodiscard]] const std::vector<double>& column(std::string_view name) const;
    /// The same by position, in its own unit.
    [[nodiscard]] std::vector<double> column(std::size_t column) const;
    /// A missing or over-range cell is empty. @throws BadInput for a missing column, or for a cell that is text
    [[nodiscard]] std::vector<std::optional<double>> columnWithGaps(std::string_view name) const;
    /// The same by position, in the unit `unit` (normalised; empty: as it is).
    [[nodiscard]] std::vector<std::optional<double>> columnWithGaps(std::size_t column, std::string_view unit) const;
    [[nodiscard]] bool hasGaps(std::string_view name) const;
    /// Some cell is a word that is no mark for "no value".
    [[nodiscard]] bool isText(std::size_t column) const { return m_texts.at(column) > 0; }
    [[nodiscard]] std::size_t texts(std::size_t column) const { return m_texts.at(column); }
    [[nodiscard]] CellKind kind(std::size_t row, std::size_t column) const { return m_kinds.at(column).at(row); }
    /// As it stands in the file.
    [[nodiscard]] std::string cellText(std::size_t row, std::size_t column) const;

    /// Leaves out rows in which one of these columns has no value, and notes them.
    /// @throws BadInput for a missing column, or for a cell that is text
    void dropRowsWithGaps(const std::vector<std::string_view>& names);

    /// Leaves out these rows (ascending), without a note.
    void dropRows(const std::vector<std::size_t>& which);

    /// Of a row, or of the header; from 1.
    [[nodiscard]] std::uint32_t lineOf(std::size_t row) const { return m_lines.at(row); }
    [[nodiscard]] std::uint32_t headerLine() const noexcept { return m_headerLine; }
    /// Sentence head for a complaint about one cell: "FILE, line 12, column feed_mm_per_rev: ".
    [[nodiscard]] std::string where(std::size_t row, std::string_view name) const;
    /// @throws BadInput unless low <= value <= high in every row.
    void requireRange(std::string_view name, double low, double high) const;

    /// What a person should know about how the file was read, a sentence each.
    [[nodiscard]] const std::vector<std::string>& notes() const noexcept { return m_notes; }
    void note(std::string sentence) const;

 private:
    Table() = default;
    void take(const std::vector<Line>& lines, const TableLayout& layout, const ReadOptions& options,
              std::vector<std::string>* texts);
    void countClock(std::size_t column, const ClockColumn::Counted& counted, const std::vector<std::uint32_t>& rows);
    void markSentinels();
    [[nodiscard]] bool sameCells(std::size_t one, std::size_t other) const;
    void addTime(const TableLayout& layout, const ReadOptions& options);
    [[nodiscard]] std::size_t need(std::string_view name) const;
    [[nodiscard]] UnitChange changeFor(std::size_t column, std::string_view name) const;
    [[nodiscard]] UnitChange changeTo(std::size_t column, std::string_view unit, std::string_view name) const;
    void requireOneMark(std::size_t column) const;
    void keepRows(const std::vector<bool>& drop);
    [[noreturn]] void refuseCell(std::size_t row, std::size_t column) const;

    static constexpr std::size_t kMarks = 7;
    std::string m_path{};
    std::uint32_t m_headerLine{1};
    char m_separator{','};
    char m_decimal{0};
    std::vector<std::string> m_names{};
    std::vector<ColumnName> m_parsed{};
    std::vector<std::vector<double>> m_columns{};  ///< of a cell without a number: 0, see m_kinds
    std::vector<std::vector<CellKind>> m_kinds{};
    std::vector<std::size_t> m_texts{};                      ///< cells of a column that are text
    std::vector<std::array<std::size_t, kMarks>> m_marks{};  ///< cells of a column by the marks they are written with
    std::vector<std::map<std::uint32_t, std::string>> m_odd{};     ///< by line: the first cells that are no numbers
    std::vector<std::array<std::uint32_t, kMarks>> m_markLines{};  ///< the first line of each
    std::vector<std::uint32_t> m_lines{};
    std::map<std::size_t, std::string> m_datesInDoubt{};  ///< by column: why it is refused when it is asked for
    mutable std::map<std::string, std::vector<double>, std::less<>> m_asked{};
    mutable std::vector<std::string> m_notes{};
};

}  // namespace kerf::files

namespace kerf::headless {
using files::BadInput;
using files::readFile;
using files::ReadOptions;
using files::Table;
}  // namespace kerf::headless
