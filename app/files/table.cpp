// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/core/utf8.h"

namespace kerf::files {
namespace {

constexpr std::size_t kMostCells = 40'000'000;
constexpr std::size_t kOddKept = 1000;  ///< texts kept per column for complaints
constexpr std::size_t kLongestQuoted = 60;

/// For a sentence: short, and cut between letters.
std::string shown(std::string_view text) {
    std::string out(beginOf(text, kLongestQuoted));
    std::ranges::replace_if(
        out, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }, ' ');
    if (out.size() < text.size()) {
        out += "…";
    }
    return out;
}

std::string shownNames(const std::vector<std::string>& names) {
    std::string out;
    for (const std::string& name : names) {
        if (name.empty()) continue;
        if (!out.empty()) out += ',';
        if (out.size() > 400) {
            out += "…";
            break;
        }
        out += shown(name);
    }
    return out;
}

}  // namespace

Table Table::read(const std::string& path, const ReadOptions& options, std::vector<std::string>* texts) {
    return parse(readFile(path), utf8Of(path), options, texts);
}

Table Table::parse(std::string_view bytes, const std::string& name, const ReadOptions& options,
                   std::vector<std::string>* texts) {
    Table table;
    table.m_path = name;
    const DecodedText text = decodeText(bytes, options.encoding);
    if (text.utf8.find('\0') != std::string::npos) {
        throw BadInput(
            fmt::format("{}: holds zero bytes; expected a text file (UTF-8, UTF-16, Windows-1252 or CP949).", name));
    }
    const std::vector<Line> lines = linesOf(text.utf8);
    const TableLayout layout = findLayout(lines, options, name);
    if (text.encoding != Encoding::Utf8 && !text.ascii) {
        table.note(fmt::format("{}: read as {}.", name, files::nameOf(text.encoding)));
    }
    if (text.damaged) {
        table.note(
            fmt::format("{}: some characters fit no encoding; expected UTF-8, UTF-16, Windows-1252 or CP949.", name));
    }
    if (!layout.leftOut.empty()) {
        table.note(layout.leftOut);
    }
    table.take(lines, layout, options, texts);
    return table;
}

void Table::take(const std::vector<Line>& lines, const TableLayout& layout, const ReadOptions& options,
                 std::vector<std::string>* texts) {
    m_headerLine = layout.headerLine;
    m_separator = layout.separator;
    m_decimal = options.decimal != 0 ? options.decimal : layout.decimal;
    m_names = layout.names;
    for (std::size_t i = 0; i < m_names.size(); ++i) {
        m_parsed.push_back(columnName(m_names[i]));
        if (!layout.units[i].empty() && m_parsed[i].unit.empty()) {
            m_parsed[i].unit = layout.units[i];
            m_parsed[i].bracketed = true;
        }
    }
    const std::size_t width = m_names.size();
    m_columns.resize(width);
    m_kinds.resize(width);
    m_texts.resize(width);
    m_marks.resize(width);
    m_markLines.resize(width);
    m_odd.resize(width);
    const bool lvm = !layout.format.empty();
    std::vector<ClockColumn> clocks(width);
    std::vector<std::vector<std::uint32_t>> clockRows(width);
    Fields row;
    std::size_t blocks = 0;
    for (const TableLayout::Range& range : layout.rows) {
        blocks += range.end > range.begin ? 1U : 0U;
        for (std::size_t i = range.begin; i < range.end; ++i) {
            if (trimmedCell(lines[i].text).empty() || isComment(lines[i].text)) {
                continue;
            }
            row.cut(lines[i].text, m_separator);
            const std::size_t filled = row.width();
            if (filled == 0) {
                continue;
            }
            if (filled == 1 && row[0] == "overrun") {
                throw BadInput(
                    fmt::format("{}, line {}: HAL's sampler lost samples here (overrun); keep the lines before or "
                                "behind it.",
                                m_path, lines[i].number));
            }
            if (filled > width || (row.size() < width && !lvm)) {
                const char* hint = m_separator == ',' && filled > width
                                       ? " Decimal commas need another separator than the comma."
                                       : "";
                throw WrongWidth(fmt::format("{}, line {}: {} fields; expected {} as in the header.{}", m_path,
                                             lines[i].number, row.size(), width, hint),
                                 lines[i].number, row.size());
            }
            if ((m_lines.size() + 1) * width > kMostCells) {
                throw BadInput(fmt::format("{}, line {}: more than {} fields; split the record.", m_path,
                                           lines[i].number, kMostCells));
            }
            for (std::size_t k = 0; k < width; ++k) {
                const std::string_view text = k < row.size() ? row[k] : std::string_view();
                if (texts != nullptr) {
                    texts->emplace_back(text);
                }
                const Cell cell = readCell(text, m_decimal);
                m_columns[k].push_back(cell.kind == CellKind::Number ? cell.value : 0.0);
                if (cell.kind == CellKind::Text && m_texts[k] == clockRows[k].size()) {
                    if (const auto time = readClock(text)) {
                        clocks[k].add(*time);
                        clockRows[k].push_back(static_cast<std::uint32_t>(m_columns[k].size() - 1));
                    }
                }
                m_kinds[k].push_back(cell.kind);
                if (cell.kind != CellKind::Number) {
                    m_texts[k] += cell.kind == CellKind::Text ? 1U : 0U;
                    if (!text.empty() && m_odd[k].size() < kOddKept) {
                        m_odd[k].emplace(lines[i].number, shown(text));
                    }
                } else if (cell.marks != Marks::None) {
                    const auto mark = static_cast<std::size_t>(cell.marks);
                    if (m_marks[k][mark]++ == 0) {
                        m_markLines[k][mark] = lines[i].number;
                    }
                }
            }
            m_lines.push_back(lines[i].number);
        }
    }
    for (std::size_t k = 0; k < width; ++k) {
        if (clocks[k].size() > 0 && clocks[k].size() == m_texts[k] &&
            std::ranges::find(m_kinds[k], CellKind::Number) == m_kinds[k].end()) {
            std::ranges::replace(m_kinds[k], CellKind::Text, CellKind::Number);
            m_texts[k] = 0;
            countClock(k, clocks[k].counted(options.dates), clockRows[k]);
            m_parsed[k].unit = std::string("s");  // counted from the first row, whatever unit stands in the name
            m_parsed[k].bracketed = true;
        }
    }
    markSentinels();
    if (blocks > 1) {
        note(fmt::format("{}: {} blocks under the same header, read as one.", m_path, blocks));
    }
    addTime(layout, options);
}

void Table::countClock(std::size_t column, const ClockColumn::Counted& counted,
                       const std::vector<std::uint32_t>& rows) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
        m_columns[column][rows[i]] = counted.seconds[i];
    }
    if (counted.doubt) {
        const std::size_t row = rows[*counted.doubt];
        m_datesInDoubt.emplace(
            column, fmt::format("{}'{}' may have its day or its month first, and no other date of the column "
                                "tells; say which with --dates day-first, month-first or year-first.",
                                where(row, m_names[column]), cellText(row, column)));
    }
}

/// -9999 among numbers nowhere near it is how loggers write "no value".
void Table::markSentinels() {
    constexpr double kSentinel = -9999.0, kLongSentinel = -99999.0;
    constexpr double kNear = 0.5;  // share of the sentinel that is a value like it
    for (std::size_t k = 0; k < m_columns.size(); ++k) {
        const auto isSentinel = [&](std::size_t row) {
            return m_kinds[k][row] == CellKind::Number &&
                   (m_columns[k][row] == kSentinel || m_columns[k][row] == kLongSentinel);
        };
        std::vector<std::size_t> found;
        double lowest = 0.0;
        for (std::size_t row = 0; row < rows(); ++row) {
            if (isSentinel(row)) {
                found.push_back(row);
            } else if (m_kinds[k][row] == CellKind::Number) {
                lowest = std::min(lowest, m_columns[k][row]);
            }
        }
        if (lowest < kNear * kSentinel || found.size() == rows()) {
            continue;
        }
        for (const std::size_t row : found) {
            m_kinds[k][row] = CellKind::OverRange;
            if (m_odd[k].size() < kOddKept) m_odd[k].emplace(m_lines[row], fmt::format("{}", m_columns[k][row]));
            m_columns[k][row] = 0.0;
        }
    }
}

void Table::addTime(const TableLayout& layout, const ReadOptions& options) {
    const double step_s = options.period_s > 0.0 ? options.period_s : layout.step_s;
    if (!(step_s > 0.0)) {
        return;
    }
    if (options.period_s > 0.0 && has("t_s")) {
        throw BadInput(fmt::format("{}, line {}: there is a time column already; --period-s is for files without one.",
                                   m_path, m_headerLine));
    }
    std::vector<double> time_s(rows());
    for (std::size_t k = 0; k < time_s.size(); ++k) {
        time_s[k] = layout.x0_s + step_s * static_cast<double>(k);
    }
    m_names.emplace_back("t_s");
    m_parsed.push_back(columnName("t_s"));
    m_columns.push_back(std::move(time_s));
    m_kinds.emplace_back(rows(), CellKind::Number);
    m_texts.push_back(0);
    m_marks.push_back({});
    m_markLines.push_back({});
    m_odd.emplace_back();
}

void Table::note(std::string sentence) const {
    if (std::ranges::find(m_notes, sentence) == m_notes.end()) {
        m_notes.push_back(std::move(sentence));
    }
}

bool Table::sameCells(std::size_t one, std::size_t other) const {
    return rows() > 1 && m_names[one] == m_names[other] && m_columns[one] == m_columns[other] &&
           m_kinds[one] == m_kinds[other] && m_texts[one] == 0;
}

std::optional<std::size_t> Table::find(std::string_view name) const {
    const ColumnName wanted = columnName(name);
    const auto pick = [&](const auto& matches) -> std::optional<std::size_t> {
        std::optional<std::size_t> found;
        for (std::size_t i = 0; i < m_names.size(); ++i) {
            if (m_names[i].empty() || !matches(i)) {
                continue;
            }
            if (found && sameCells(*found, i)) {
                continue;  // LabVIEW writes the time beside every channel
            }
            if (found) {
                throw BadInput(fmt::format("{}, line {}: column name '{}' stands twice ({} and {}); rename one.",
                                           m_path, m_headerLine, name, m_names[*found], m_names[i]));
            }
            found = i;
        }
        return found;
    };
    const auto unitFits = [&](std::size_t i) {
        return !m_parsed[i].unit.empty() && !wanted.unit.empty() &&
               unitChange(m_parsed[i].unit, wanted.unit).has_value();
    };
    if (const auto i = pick([&](std::size_t k) { return m_names[k] == name; })) return i;
    if (const auto i = pick([&](std::size_t k) { return m_parsed[k].whole == wanted.whole; })) return i;
    if (const auto i =
            pick([&](std::size_t k) { return m_parsed[k].base == wanted.base && m_parsed[k].unit == wanted.unit; }))
        return i;
    if (const auto i = pick([&](std::size_t k) { return m_parsed[k].base == wanted.base && unitFits(k); })) return i;
    // "T1" of a model is "T1 (°C)" of a logger.
    if (const auto i = pick([&](std::size_t k) { return wanted.unit.empty() && m_parsed[k].base == wanted.base; })) {
        return i;
    }
    if (const auto i = pick([&](std::size_t k) {
            return sameThing(m_parsed[k].base, wanted.base) &&
                   (unitFits(k) || (wanted.unit.empty() && m_parsed[k].unit.empty()));
        }))
        return i;
    if (const auto i = pick([&](std::size_t k) { return m_parsed[k].base == wanted.base && m_parsed[k].unit.empty(); }))
        return i;
    return pick([&](std::size_t k) { return sameThing(m_parsed[k].base, wanted.base) && m_parsed[k].unit.empty(); });
}

std::size_t Table::need(std::string_view name) const {
    const auto found = find(name);
    if (!found) {
        const ColumnName wanted = columnName(name);
        for (std::size_t i = 0; i < m_names.size(); ++i) {
            if (m_parsed[i].base == wanted.base && !m_parsed[i].unit.empty() && !wanted.unit.empty()) {
                throw BadInput(fmt::format("{}, line {}: column '{}' is in {}; expected {}.", m_path, m_headerLine,
                                           m_names[i], m_parsed[i].unit, wanted.unit));
            }
        }
        const bool time = wanted.base == "t" && !wanted.unit.empty();
        throw BadInput(fmt::format("{}, line {}: column {} is missing; found {}.{}", m_path, m_headerLine, name,
                                   shownNames(m_names),
                                   time ? " Rows at equal times: say how far apart with --period-s." : ""));
    }
    return *found;
}

UnitChange Table::changeFor(std::size_t column, std::string_view name) const {
    return changeTo(column, columnName(name).unit, name);
}

UnitChange Table::changeTo(std::size_t column, std::string_view unit, std::string_view name) const {
    const std::string& own = m_parsed[column].unit;
    if (own.empty() || unit.empty() || own == unit) {
        return {};
    }
    const auto change = unitChange(own, unit);
    if (!change) {
        return {};  // asked for by its whole name
    }
    if (change->factor != 1.0 || change->offset != 0.0) {
        note(fmt::format("{}: column '{}' is in {} and was converted for {}.", m_path, m_names[column], own, name));
    }
    return *change;
}

void Table::requireOneMark(std::size_t column) const {
    if (const auto doubt = m_datesInDoubt.find(column); doubt != m_datesInDoubt.end()) {
        throw BadInput(doubt->second);
    }
    if (m_decimal != 0) {
        return;
    }
    const auto count = [](const auto& marks, Marks mark) { return marks[static_cast<std::size_t>(mark)]; };
    std::array<std::size_t, kMarks> file{};
    for (const auto& one : m_marks) {
        for (std::size_t k = 0; k < kMarks; ++k) {
            file[k] += one[k];
        }
    }
    const auto& own = m_marks[column];
    const auto points = [&](const auto& m) { return count(m, Marks::Point) + count(m, Marks::PointThousands); };
    const auto commas = [&](const auto& m) { return count(m, Marks::Comma) + count(m, Marks::CommaThousands); };
    const auto refuse = [&](Marks mark, const char* doubt) {
        throw BadInput(fmt::format("{}, line {}, column {}: {}; say which with --decimal.", m_path,
                                   m_markLines[column][static_cast<std::size_t>(mark)], m_names[column], doubt));
    };
    if (points(own) > 0 && commas(own) > 0) {
        refuse(count(own, Marks::Comma) > 0 ? Marks::Comma : Marks::CommaThousands,
               "some numbers have a decimal comma and others a decimal point");
    }
    if (count(own, Marks::CommaMaybe) > 0) {
        const bool said = commas(own) > 0 || (points(own) == 0 && commas(file) > 0 && points(file) == 0);
        const bool excel = m_separator == ';' && points(file) == 0 && count(file, Marks::PointMaybe) == 0;
        if (!said && !excel) {
            refuse(Marks::CommaMaybe, "the comma may be a decimal comma or stand for thousands");
        }
    }
    if (count(own, Marks::PointMaybe) > 0) {
        const bool said = points(own) > 0;
        const bool doubt = commas(own) > 0 || (!said && (commas(file) > 0 || count(file, Marks::CommaMaybe) > 0));
        if (doubt) {
            refuse(Marks::PointMaybe, "the point may be a decimal point or stand for thousands");
        }
    }
}

void Table::refuseCell(std::size_t row, std::size_t column) const {
    const auto odd = m_odd[column].find(m_lines[row]);
    const std::string text = odd == m_odd[column].end() ? std::string() : odd->second;
    const char* why = "is not a number";
    if (m_kinds[column][row] == CellKind::Missing && !text.empty()) why = "means no value";
    if (m_kinds[column][row] == CellKind::OverRange) why = "means beyond the range";
    throw BadInput(fmt::format("{}, line {}, column {}: '{}' {}; expected a finite decimal number.", m_path,
                               m_lines[row], m_names[column], text, why));
}

const std::vector<double>& Table::column(std::string_view name) const {
    if (const auto asked = m_asked.find(name); asked != m_asked.end()) {
        return asked->second;
    }
    const std::size_t column = need(name);
    requireOneMark(column);
    for (std::size_t row = 0; row < rows(); ++row) {
        if (m_kinds[column][row] != CellKind::Number) {
            refuseCell(row, column);
        }
    }
    const UnitChange change = changeFor(column, name);
    std::vector<double> values = m_columns[column];
    if (change.factor != 1.0 || change.offset != 0.0) {
        for (double& value : values) {
            value = change.factor * value + change.offset;
        }
    }
    return m_asked.emplace(std::string(name), std::move(values)).first->second;
}

std::vector<double> Table::column(std::size_t column) const {
    requireOneMark(column);
    for (std::size_t row = 0; row < rows(); ++row) {
        if (m_kinds[column][row] != CellKind::Number) {
            refuseCell(row, column);
        }
    }
    return m_columns[column];
}

std::vector<std::optional<double>> Table::columnWithGaps(std::string_view name) const {
    const std::size_t column = need(name);
    requireOneMark(column);
    const UnitChange change = changeFor(column, name);
    std::vector<std::optional<double>> out(rows());
    for (std::size_t row = 0; row < rows(); ++row) {
        if (m_kinds[column][row] == CellKind::Text) {
            refuseCell(row, column);
        }
        if (m_kinds[column][row] == CellKind::Number) {
            out[row] = change.factor * m_columns[column][row] + change.offset;
        }
    }
    return out;
}

std::vector<std::optional<double>> Table::columnWithGaps(std::size_t column, std::string_view unit) const {
    requireOneMark(column);
    const UnitChange change = changeTo(column, unit, unit);
    std::vector<std::optional<double>> out(rows());
    for (std::size_t row = 0; row < rows(); ++row) {
        if (m_kinds[column][row] == CellKind::Number) {
            out[row] = change.factor * m_columns[column][row] + change.offset;
        }
    }
    return out;
}

bool Table::hasGaps(std::string_view name) const {
    const auto& kinds = m_kinds[need(name)];
    return std::ranges::any_of(kinds, [](CellKind kind) { return kind != CellKind::Number; });
}

std::string Table::cellText(std::size_t row, std::size_t column) const {
    const auto odd = m_odd.at(column).find(m_lines.at(row));
    if (odd != m_odd[column].end()) {
        return odd->second;
    }
    return m_kinds[column][row] == CellKind::Number ? fmt::format("{}", m_columns[column][row]) : std::string();
}

void Table::dropRowsWithGaps(const std::vector<std::string_view>& names) {
    std::vector<bool> drop(rows(), false);
    for (const std::string_view name : names) {
        const std::size_t column = need(name);
        std::size_t count = 0;
        std::size_t first = 0;
        for (std::size_t row = 0; row < rows(); ++row) {
            if (m_kinds[column][row] == CellKind::Text) {
                refuseCell(row, column);
            }
            if (m_kinds[column][row] != CellKind::Number) {
                first = count++ == 0 ? row : first;
                drop[row] = true;
            }
        }
        if (count > 0) {
            note(fmt::format(
                "{}'{}' is no value; {} left out.", where(first, m_names[column]), cellText(first, column),
                count == 1 ? std::string("the row was") : fmt::format("this and {} more rows were", count - 1)));
        }
    }
    keepRows(drop);
}

void Table::dropRows(const std::vector<std::size_t>& which) {
    std::vector<bool> drop(rows(), false);
    for (const std::size_t row : which) {
        drop.at(row) = true;
    }
    keepRows(drop);
}

void Table::keepRows(const std::vector<bool>& drop) {
    std::size_t kept = 0;
    for (std::size_t row = 0; row < drop.size(); ++row) {
        if (drop[row]) continue;
        for (std::size_t k = 0; k < m_columns.size(); ++k) {
            m_columns[k][kept] = m_columns[k][row];
            m_kinds[k][kept] = m_kinds[k][row];
        }
        m_lines[kept++] = m_lines[row];
    }
    for (std::size_t k = 0; k < m_columns.size(); ++k) {
        m_columns[k].resize(kept);
        m_kinds[k].resize(kept);
    }
    m_lines.resize(kept);
    m_asked.clear();
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

}  // namespace kerf::files
