// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace kerf::headless {

/// Bad input: one sentence with file, line, column and what was expected. main() prints it and exits with 3.
class BadInput : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

/// A CSV file of numbers with a header line, read whole and checked whole before anything is computed.
///
/// Comma-separated, '.' decimal point, optional UTF-8 byte order mark, empty lines skipped, '#' comment lines skipped.
class Table {
 public:
    /// Allowed: an empty field or "nan" is read as not-a-number, for the caller to turn into a missing reading.
    enum class Gaps : std::uint8_t { Refused, Allowed };
    /// @throws BadInput when the file cannot be read, a row has the wrong number of fields, or a field is no finite
    /// number.
    [[nodiscard]] static Table read(const std::string& path, Gaps gaps = Gaps::Refused);

    [[nodiscard]] std::size_t rows() const noexcept { return m_lines.size(); }
    [[nodiscard]] const std::vector<std::string>& names() const noexcept { return m_names; }
    [[nodiscard]] bool has(std::string_view name) const;
    /// @throws BadInput naming the file and the missing column.
    [[nodiscard]] const std::vector<double>& column(std::string_view name) const;
    /// Sentence head for a complaint about one cell: "FILE, line 12, column feed_mm_per_rev: ".
    [[nodiscard]] std::string where(std::size_t row, std::string_view name) const;
    /// @throws BadInput unless low <= value <= high in every row.
    void requireRange(std::string_view name, double low, double high) const;

 private:
    std::string m_path;
    std::vector<std::string> m_names;
    std::vector<std::vector<double>> m_columns;
    std::vector<std::size_t> m_lines;
};

/// Whole text of a file. @throws BadInput
[[nodiscard]] std::string readFile(const std::string& path);

}  // namespace kerf::headless
