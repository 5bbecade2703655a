// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "app/files/cell.h"
#include "app/files/table_layout.h"

namespace kerf::files {
namespace {

/// Numbers, dates and clock times begin with a digit, behind a sign or a mark.
bool looksLikeData(std::string_view field) noexcept {
    if (field.empty() || field == "error") {  // a logger's mark for no value, and a column of the charts
        return false;
    }
    if (readCell(field).kind != CellKind::Text) {
        return true;
    }
    return isDigit(field[0]);
}

}  // namespace

void Fields::cut(std::string_view line, char separator) {
    m_fields.clear();
    m_unquoted.clear();
    const bool blanks = separator == ' ';
    if (blanks) {
        line = trimmedCell(line);
    }
    std::size_t at = 0;
    const auto isSeparator = [&](char c) { return blanks ? c == ' ' || c == '\t' : c == separator; };
    while (true) {
        std::size_t start = at;
        while (start < line.size() && (line[start] == ' ' || (line[start] == '\t' && separator != '\t'))) {
            ++start;
        }
        if (start < line.size() && line[start] == '"') {
            std::string text;
            std::size_t i = start + 1;
            bool closed = false;
            for (; i < line.size(); ++i) {
                if (line[i] != '"') {
                    text += line[i];
                } else if (i + 1 < line.size() && line[i + 1] == '"') {
                    text += '"';
                    ++i;
                } else {
                    closed = true;
                    ++i;
                    break;
                }
            }
            if (closed) {
                while (i < line.size() && !isSeparator(line[i])) {
                    text += line[i++];
                }
                m_unquoted.push_back(std::move(text));
                m_fields.push_back(trimmedCell(m_unquoted.back()));
                at = i;
            } else {  // an inch mark, or a quote that nobody closed: taken as it stands
                start = at;
                while (at < line.size() && !isSeparator(line[at]))
                    ++at;
                m_fields.push_back(trimmedCell(line.substr(start, at - start)));
            }
        } else {
            start = at;
            while (at < line.size() && !isSeparator(line[at]))
                ++at;
            m_fields.push_back(trimmedCell(line.substr(start, at - start)));
        }
        if (at >= line.size()) {
            return;
        }
        ++at;
        while (blanks && at < line.size() && (line[at] == ' ' || line[at] == '\t')) {
            ++at;
        }
    }
}

std::size_t Fields::width() const noexcept {
    std::size_t width = m_fields.size();
    while (width > 0 && m_fields[width - 1].empty()) {
        --width;
    }
    return width;
}

std::size_t Fields::dataLike() const noexcept {
    return static_cast<std::size_t>(std::ranges::count_if(m_fields, looksLikeData));
}

std::size_t Fields::filled() const noexcept {
    return static_cast<std::size_t>(std::ranges::count_if(m_fields, [](auto field) { return !field.empty(); }));
}

bool Fields::isData() const noexcept {
    const std::size_t data = dataLike();
    const auto first = std::ranges::find_if(m_fields, [](auto field) { return !field.empty(); });
    return data > 0 && (looksLikeData(*first) || 2 * data > filled());
}

bool isComment(std::string_view line) noexcept {
    line = trimmedCell(line);
    if (!line.starts_with('#')) {
        return false;
    }
    const std::size_t end = line.find_first_of(",;\t| ");
    return readCell(line.substr(0, end)).kind == CellKind::Text ||
           line.substr(0, end).find_first_not_of('#') == std::string_view::npos;
}

std::vector<Line> linesOf(std::string_view text) {
    constexpr std::size_t kLongestQuote = 50;  // lines
    std::vector<Line> lines;
    std::uint32_t number = 0;
    std::size_t at = 0;
    const auto endOf = [&](std::size_t from) { return std::min(text.find_first_of("\r\n", from), text.size()); };
    const auto behind = [&](std::size_t end) {
        return end + (text.substr(end).starts_with("\r\n") ? 2U : end < text.size() ? 1U : 0U);
    };
    const auto opens = [](std::string_view line) {
        if (std::ranges::count(line, '"') % 2 == 0) return false;
        const auto quote = line.rfind('"');
        const auto before = trimmedCell(line.substr(0, quote));
        return before.empty() || std::string_view(",;|").find(before.back()) != std::string_view::npos ||
               line[quote - 1] == '\t';
    };
    while (at < text.size()) {
        std::size_t end = endOf(at);
        ++number;
        std::uint32_t taken = 0;
        if (opens(text.substr(at, end - at))) {
            std::size_t further = end;
            for (std::size_t k = 0; k < kLongestQuote && further < text.size(); ++k) {
                const std::size_t begin = behind(further);
                further = endOf(begin);
                ++taken;
                if (std::ranges::count(text.substr(begin, further - begin), '"') % 2 == 1) {
                    end = further;
                    break;
                }
            }
            if (end != further) taken = 0;
        }
        lines.push_back({text.substr(at, end - at), number});
        number += taken;
        at = behind(end);
    }
    return lines;
}

std::string separatorName(char separator) {
    switch (separator) {
        case '\t':
            return "tab";
        case ' ':
            return "blank";
        default:
            return fmt::format("'{}'", separator);
    }
}

}  // namespace kerf::files
