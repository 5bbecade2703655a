// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace kerf::headless {

/// A CSV file whose columns may hold names ("A", "Kim") as well as numbers. Header line, comma or semicolon apart, '.'
/// decimal point, optional byte order mark, empty and '#' lines skipped; fields may stand in double quotes.
class LabelledTable {
 public:
    /// @throws BadInput when the file cannot be read or a row has the wrong number of fields
    [[nodiscard]] static LabelledTable read(const std::string& path);

    [[nodiscard]] std::size_t rows() const noexcept { return m_lines.size(); }
    [[nodiscard]] bool has(std::string_view name) const;
    /// @throws BadInput naming the file and the missing column
    [[nodiscard]] std::size_t column(std::string_view name) const;
    /// The named column, or the only one there is.
    [[nodiscard]] std::size_t valueColumn(std::string_view name) const;
    [[nodiscard]] const std::string& text(std::size_t row, std::size_t column) const {
        return m_cells[row * m_names.size() + column];
    }
    /// A column of finite numbers. @throws BadInput with file, line and column
    [[nodiscard]] std::vector<double> numbers(std::size_t column) const;

 private:
    std::string m_path;
    std::vector<std::string> m_names;
    std::vector<std::string> m_cells;  ///< row by row
    std::vector<std::size_t> m_lines;
};

}  // namespace kerf::headless
