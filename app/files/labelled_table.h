// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "app/files/table.h"

namespace kerf::headless {

/// A table whose columns may hold names ("A", "Kim") as well as numbers; read as every table is.
class LabelledTable {
 public:
    /// @throws BadInput when the file cannot be read or a row has the wrong number of fields
    [[nodiscard]] static LabelledTable read(const std::string& path, const ReadOptions& options = {});

    [[nodiscard]] std::size_t rows() const noexcept { return m_table.rows(); }
    [[nodiscard]] bool has(std::string_view name) const { return m_table.has(name); }
    /// @throws BadInput naming the file and the missing column
    [[nodiscard]] std::size_t column(std::string_view name) const;
    /// The named column, or the only one there is.
    [[nodiscard]] std::size_t valueColumn(std::string_view name) const;
    [[nodiscard]] const std::string& text(std::size_t row, std::size_t column) const {
        return m_cells[row * m_table.names().size() + column];
    }
    /// A column of finite numbers in its own unit, or in the one that `name` ends in.
    /// @throws BadInput with file, line and column
    [[nodiscard]] std::vector<double> numbers(std::size_t column) const;
    [[nodiscard]] std::vector<double> numbers(std::string_view name) const { return m_table.column(name); }
    /// Leaves out the rows that have no value there, and notes them.
    void dropGaps(std::size_t column);

    [[nodiscard]] const Table& table() const noexcept { return m_table; }

 private:
    explicit LabelledTable(Table table) : m_table(std::move(table)) {}

    Table m_table;
    std::vector<std::string> m_cells;  ///< row by row
};

}  // namespace kerf::headless
