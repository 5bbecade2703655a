// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/labelled_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>

#include "app/files/table.h"

namespace kerf::headless {
namespace {

std::string trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r");
    return first == std::string_view::npos
               ? std::string{}
               : std::string(text.substr(first, text.find_last_not_of(" \t\r") - first + 1));
}

std::vector<std::string> fieldsOf(std::string_view line, char between) {
    std::vector<std::string> fields;
    std::string field;
    bool quoted = false;
    bool wasQuoted = false;
    const auto end = [&] {
        fields.push_back(wasQuoted ? field : trimmed(field));
        field.clear();
        wasQuoted = false;
    };
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (quoted && c == '"' && i + 1 < line.size() && line[i + 1] == '"') {
            field += '"';
            ++i;
        } else if (c == '"' && (quoted || trimmed(field).empty())) {
            quoted = !quoted;
            wasQuoted = true;
            if (quoted) {
                field.clear();
            }
        } else if (c == between && !quoted) {
            end();
        } else if (c != '\r' && !(wasQuoted && !quoted)) {
            field += c;
        }
    }
    end();
    return fields;
}

}  // namespace

LabelledTable LabelledTable::read(const std::string& path) {
    const std::string text = readFile(path);
    LabelledTable table;
    table.m_path = path;
    std::string_view rest = text;
    if (rest.starts_with("\xEF\xBB\xBF")) {
        rest.remove_prefix(3);
    }
    char between = ',';
    for (std::size_t number = 1; !rest.empty(); ++number) {
        const auto end = rest.find('\n');
        const std::string_view line = rest.substr(0, end);
        rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
        const std::string plain = trimmed(line);
        if (plain.empty() || plain.front() == '#') {
            continue;
        }
        if (table.m_names.empty()) {
            between = plain.find(';') != std::string::npos && plain.find(',') == std::string::npos ? ';' : ',';
            for (std::string& name : fieldsOf(line, between)) {
                if (name.empty() || table.has(name)) {
                    throw BadInput(
                        fmt::format("{}, line {}: column name '{}' is empty or stands twice.", path, number, name));
                }
                table.m_names.push_back(std::move(name));
            }
            continue;
        }
        std::vector<std::string> fields = fieldsOf(line, between);
        if (fields.size() != table.m_names.size()) {
            throw BadInput(fmt::format("{}, line {}: {} fields; expected {} as in the header.", path, number,
                                       fields.size(), table.m_names.size()));
        }
        std::ranges::move(fields, std::back_inserter(table.m_cells));
        table.m_lines.push_back(number);
    }
    if (table.m_names.empty()) {
        throw BadInput(fmt::format("{}: empty; expected a header line with column names.", path));
    }
    return table;
}

bool LabelledTable::has(std::string_view name) const {
    return std::ranges::find(m_names, name) != m_names.end();
}

std::size_t LabelledTable::column(std::string_view name) const {
    const auto found = std::ranges::find(m_names, name);
    if (found == m_names.end()) {
        throw BadInput(
            fmt::format("{}, line 1: column {} is missing; found {}.", m_path, name, fmt::join(m_names, ",")));
    }
    return static_cast<std::size_t>(found - m_names.begin());
}

std::size_t LabelledTable::valueColumn(std::string_view name) const {
    return m_names.size() == 1 && !has(name) ? 0 : column(name);
}

std::vector<double> LabelledTable::numbers(std::size_t column) const {
    std::vector<double> values;
    values.reserve(rows());
    for (std::size_t row = 0; row < rows(); ++row) {
        const std::string& cell = text(row, column);
        double value = 0.0;
        const auto [stop, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
        if (error != std::errc{} || stop != cell.data() + cell.size() || !std::isfinite(value)) {
            throw BadInput(
                fmt::format("{}, line {}, column {}: '{}' is not a number; expected a finite decimal number.", m_path,
                            m_lines[row], m_names[column], cell));
        }
        values.push_back(value);
    }
    return values;
}

}  // namespace kerf::headless
