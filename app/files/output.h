// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <initializer_list>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace kerf::headless {

/// CSV on stdout, collected first: nothing half-written if an error comes in between. Numbers with the fewest digits
/// that give the same number back.
class CsvOutput {
 public:
    explicit CsvOutput(std::string_view header) : m_text(header) { m_text += '\n'; }
    /// One row; doubles print with their shortest digits, integers plainly, empty strings as empty fields.
    template <class... Cells>
    void row(const Cells&... cells) {
        bool first = true;
        ((cell(cells, first), first = false), ...);
        m_text += '\n';
    }
    /// @throws BadInput when standard output did not take everything
    void flush();

 private:
    template <class Cell>
    void cell(const Cell& value, bool first) {
        if (!first) {
            m_text += ',';
        }
        if constexpr (std::is_floating_point_v<Cell>) {
            fmt::format_to(std::back_inserter(m_text), "{}", value);
        } else if constexpr (std::is_same_v<Cell, bool>) {
            m_text += value ? '1' : '0';
        } else {
            fmt::format_to(std::back_inserter(m_text), "{}", value);
        }
    }
    std::string m_text;
};

/// A JSON document on stdout, indented, keys in the order they were set.
void printJson(const nlohmann::ordered_json& document);

}  // namespace kerf::headless
