// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

namespace kerf::headless {
namespace {

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) {
        return {};
    }
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string_view> fields(std::string_view line) {
    std::vector<std::string_view> out;
    for (std::size_t begin = 0;;) {
        const auto comma = line.find(',', begin);
        out.push_back(trimmed(line.substr(begin, comma - begin)));
        if (comma == std::string_view::npos) {
            return out;
        }
        begin = comma + 1;
    }
}

}  // namespace

std::string readFile(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file || std::filesystem::is_directory(path)) {
        throw BadInput(fmt::format("{}: cannot be read; expected an existing file.", path));
    }
    std::ostringstream text;
    text << file.rdbuf();
    return std::move(text).str();
}

Table Table::read(const std::string& path, Gaps gaps) {
    const std::string text = readFile(path);
    Table table;
    table.m_path = path;
    std::string_view rest = text;
    if (rest.starts_with("\xEF\xBB\xBF")) {
        rest.remove_prefix(3);
    }
    std::size_t lineNumber = 0;
    while (!rest.empty()) {
        const auto end = rest.find('\n');
        const std::string_view line = trimmed(rest.substr(0, end));
        rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
        ++lineNumber;
        if (line.empty() || line.front() == '#') {
            continue;
        }
        const auto cells = fields(line);
        if (table.m_names.empty()) {
            for (const auto cell : cells) {
                if (cell.empty() || std::ranges::find(table.m_names, cell) != table.m_names.end()) {
                    throw BadInput(
                        fmt::format("{}, line {}: column name '{}' is empty or stands twice.", path, lineNumber, cell));
                }
                table.m_names.emplace_back(cell);
            }
            table.m_columns.resize(table.m_names.size());
            continue;
        }
        if (cells.size() != table.m_names.size()) {
            throw BadInput(fmt::format("{}, line {}: {} fields; expected {} as in the header.", path, lineNumber,
                                       cells.size(), table.m_names.size()));
        }
        for (std::size_t i = 0; i < cells.size(); ++i) {
            if (gaps == Gaps::Allowed && (cells[i].empty() || cells[i] == "nan")) {
                table.m_columns[i].push_back(std::numeric_limits<double>::quiet_NaN());
                continue;
            }
            double value = 0.0;
            const auto [stop, error] = std::from_chars(cells[i].data(), cells[i].data() + cells[i].size(), value);
            if (error != std::errc{} || stop != cells[i].data() + cells[i].size() || !std::isfinite(value)) {
                throw BadInput(
                    fmt::format("{}, line {}, column {}: '{}' is not a number; expected a finite decimal number.", path,
                                lineNumber, table.m_names[i], cells[i]));
            }
            table.m_columns[i].push_back(value);
        }
        table.m_lines.push_back(lineNumber);
    }
    if (table.m_names.empty()) {
        throw BadInput(fmt::format("{}: empty; expected a header line with column names.", path));
    }
    return table;
}

bool Table::has(std::string_view name) const {
    return std::ranges::find(m_names, name) != m_names.end();
}

const std::vector<double>& Table::column(std::string_view name) const {
    const auto found = std::ranges::find(m_names, name);
    if (found == m_names.end()) {
        throw BadInput(
            fmt::format("{}, line 1: column {} is missing; found {}.", m_path, name, fmt::join(m_names, ",")));
    }
    return m_columns[static_cast<std::size_t>(found - m_names.begin())];
}

std::string Table::where(std::size_t row, std::string_view name) const {
    return fmt::format("{}, line {}, column {}: ", m_path, m_lines.at(row), name);
}

void Table::requireRange(std::string_view name, double low, double high) const {
    const auto& values = column(name);
    for (std::size_t row = 0; row < values.size(); ++row) {
        if (values[row] < low || values[row] > high) {
            throw BadInput(
                fmt::format("{}{} is out of range; expected {} to {}.", where(row, name), values[row], low, high));
        }
    }
}

}  // namespace kerf::headless
