// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/table_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <utility>

#include "app/files/cell.h"
#include "app/files/column_name.h"
#include "app/files/whole_file.h"

namespace kerf::files {
namespace {

constexpr std::array<char, 5> kSeparators{'\t', ';', '|', ',', ' '};
constexpr std::size_t kSampleRows = 200;
constexpr std::size_t kSampleLines = 4000;  ///< a header block longer than this is none
constexpr double kConsistent = 0.8;         ///< share of rows as wide as the header that makes a separator likely

bool isUnitWord(std::string_view field) {
    const std::string text = normalised(field);
    return isUnit(text);
}

/// "min;rpm;°C": under the header, every field a unit or nothing.
bool isUnitsRow(const Fields& row) {
    std::size_t units = 0;
    for (const std::string_view field : row.all()) {
        if (isUnitWord(field)) {
            ++units;
        } else if (!field.empty() && readCell(field).kind != CellKind::Missing && field != "1") {
            return false;
        }
    }
    return units > 0;
}

/// "NO.;Time;ms;degC;degC;A1234567890": a logger's second header line, that has words for columns without a unit.
bool isMostlyUnits(const Fields& row) {
    const auto units = static_cast<std::size_t>(std::ranges::count_if(row.all(), isUnitWord));
    return units > 1 && 2 * units >= row.filled() && row.dataLike() == 0;
}

bool isHeader(const Fields& row) {
    return row.filled() > 0 && row.dataLike() == 0;
}

struct Candidate {
    char separator{','};
    bool found{false};
    std::size_t header{0}, units{0};  ///< indices of lines; units == header: no units row
    std::size_t firstRow{0};
    std::size_t width{0};
    double consistent{0.0};
    double numeric{0.0};
    std::size_t otherHeader{0}, otherRows{0};  ///< a shorter table under other names
    bool reordered{false};                     ///< under the same names in another order
};

bool fits(const Fields& row, std::size_t width, std::size_t full) {
    return row.width() <= width && (row.size() >= width || row.size() == full);
}

/// Judges the rows behind the header.
void judge(const std::vector<Line>& lines, Candidate& candidate) {
    std::size_t rows = 0, fitting = 0, cells = 0, numbers = 0;
    Fields fields;
    for (std::size_t i = candidate.firstRow; i < lines.size() && rows < kSampleRows; ++i) {
        if (trimmedCell(lines[i].text).empty() || isComment(lines[i].text)) {
            continue;
        }
        fields.cut(lines[i].text, candidate.separator);
        if (fields.filled() == 0) {
            continue;
        }
        ++rows;
        fitting += fits(fields, candidate.width, candidate.width) ? 1U : 0U;
        for (const std::string_view field : fields.all()) {
            cells += field.empty() ? 0U : 1U;
            numbers += !field.empty() && readCell(field).kind != CellKind::Text ? 1U : 0U;
        }
    }
    candidate.consistent = rows > 0 ? static_cast<double>(fitting) / static_cast<double>(rows) : 0.0;
    candidate.numeric = cells > 0 ? static_cast<double>(numbers) / static_cast<double>(cells) : 0.0;
}

bool isDataLine(std::string_view line, char separator) {
    Fields row;
    row.cut(line, separator);
    return row.isData() && !isComment(line);
}

/// Rows of data that follow, up to the next words.
std::size_t rowsBehind(const std::vector<Line>& lines, const Candidate& candidate) {
    std::size_t rows = 0;
    Fields row;
    for (std::size_t i = candidate.firstRow; i < std::min(lines.size(), kSampleLines); ++i) {
        row.cut(lines[i].text, candidate.separator);
        if (row.filled() == 0 || isComment(lines[i].text)) {
            continue;
        }
        if (!row.isData()) {
            break;
        }
        ++rows;
    }
    return rows;
}

/// Of tables of several kinds in one file the longest; a table may come in several blocks.
class Longest {
 public:
    void add(const std::vector<Line>& lines, const Candidate& candidate) {
        const std::string_view head = trimmedCell(lines[candidate.header].text);
        auto known = std::ranges::find(m_tables, head, &One::head);
        if (known == m_tables.end()) {
            m_tables.push_back({head, candidate, 0});
            known = m_tables.end() - 1;
        }
        known->rows += rowsBehind(lines, candidate);
    }
    [[nodiscard]] bool empty() const noexcept { return m_tables.empty(); }
    [[nodiscard]] std::optional<Candidate> best() const {
        const auto most = std::ranges::max_element(m_tables, {}, &One::rows);
        if (most == m_tables.end()) {
            return std::nullopt;
        }
        Candidate out = most->first;
        for (const One& other : m_tables) {
            if (&other != &*most && !out.reordered) {
                out.otherHeader = other.first.header;
                out.otherRows = other.rows;
                out.reordered = sorted(other.head, out.separator) == sorted(most->head, out.separator);
            }
        }
        return out;
    }

 private:
    struct One {
        std::string_view head;
        Candidate first;
        std::size_t rows;
    };
    static std::vector<std::string> sorted(std::string_view head, char separator) {
        Fields fields;
        fields.cut(head, separator);
        std::vector<std::string> names(fields.all().begin(), fields.all().end());
        std::ranges::sort(names);
        return names;
    }

    std::vector<One> m_tables{};
};

/// The first row of data that stands under a header as wide as itself.
Candidate look(const std::vector<Line>& lines, char separator, std::size_t leastWidth, bool named,
               std::size_t namedWidth) {
    Candidate out;
    out.separator = separator;
    Candidate loose;  // a header that does not fit its row: for the complaint
    Longest found;
    Fields row, before, above;
    std::size_t previous = lines.size(), beforePrevious = lines.size();
    bool previousIsData = false;
    for (std::size_t i = 0; i < std::min(lines.size(), kSampleLines); ++i) {
        const std::string_view text = trimmedCell(lines[i].text);
        if (text.empty() || isComment(text)) {
            continue;
        }
        row.cut(lines[i].text, separator);
        if (row.filled() == 0) {
            continue;
        }
        const bool data = row.isData() && (previousIsData || !isUnitsRow(row));
        if (row.isData() && named && row.width() <= namedWidth && row.size() >= namedWidth) {
            out.found = true;
            out.header = out.units = lines.size();
            out.firstRow = i;
            out.width = namedWidth;
            judge(lines, out);
            return out;
        }
        const bool first = !std::exchange(previousIsData, data) && data;
        if (first && !named && previous < lines.size()) {
            before.cut(lines[previous].text, separator);
            bool header = isHeader(before) || isUnitsRow(before);
            std::size_t at = previous;
            const bool units = isUnitsRow(before);
            if (header && (units || isMostlyUnits(before)) && beforePrevious < lines.size()) {
                above.cut(lines[beforePrevious].text, separator);
                const bool names = units || (!isMostlyUnits(above) && above.filled() == before.filled());
                if (isHeader(above) && above.width() >= before.width() && names) {
                    at = beforePrevious;
                    before = above;
                }
            }
            Candidate candidate;
            candidate.separator = separator;
            candidate.header = at;
            candidate.units = previous;
            candidate.firstRow = i;
            candidate.width = before.width();
            header = header && candidate.width >= leastWidth;
            // A later header stands apart from the rows before it; else it is a row gone wrong.
            const bool apart = header && (at == 0 || found.empty() || !isDataLine(lines[at - 1].text, separator));
            if (apart && fits(row, candidate.width, before.size())) {
                candidate.found = true;
                found.add(lines, candidate);
            }
            if (header && loose.width == 0) {
                loose = candidate;
            }
        }
        beforePrevious = previous;
        previous = i;
    }
    if (const auto best = found.best()) {
        out = *best;
        judge(lines, out);
        return out;
    }
    if (loose.width > 0) {
        judge(lines, loose);
        loose.found = false;
        return loose;
    }
    return out;
}

std::size_t lineBeforeAnyRow(const std::vector<Line>& lines) {
    std::size_t first = 0;
    while (first < lines.size() && (trimmedCell(lines[first].text).empty() || isComment(lines[first].text))) {
        ++first;
    }
    return first;
}

/// "sep=;" on the first line is a word of Excel's to itself.
std::optional<char> separatorLine(std::string_view line) {
    line = trimmedCell(line);
    return line.size() == 5 && (line.starts_with("sep=") || line.starts_with("SEP=")) ? std::optional(line[4])
                                                                                      : std::nullopt;
}

void setNames(TableLayout& layout, const Fields& header) {
    for (const std::string_view field : header.all()) {
        layout.names.emplace_back(field);
        for (char& c : layout.names.back()) {  // a quoted name may go over lines, a sentence with it does not
            c = static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? ' ' : c;
        }
    }
    layout.names.resize(header.width());
    layout.units.resize(layout.names.size());
}

void setUnits(TableLayout& layout, const Fields& units) {
    for (std::size_t i = 0; i < std::min(units.size(), layout.names.size()); ++i) {
        if (isUnitWord(units[i])) {
            layout.units[i] = normalised(units[i]);
        }
    }
}

bool sameNames(const Fields& row, const std::vector<std::string>& names) {
    if (row.width() != names.size()) {
        return false;
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (row[i] != names[i]) {
            return false;
        }
    }
    return true;
}

/// The last lines that repeat the header or hold data.
struct Last {
    std::size_t header{0}, data{0};
    std::size_t row{0};  ///< data as wide as the header
};
Last lastOf(const std::vector<Line>& lines, std::size_t first, const TableLayout& layout) {
    Last last;
    Fields row;
    for (std::size_t i = first; i < lines.size(); ++i) {
        row.cut(lines[i].text, layout.separator);
        if (sameNames(row, layout.names)) {
            last.header = i;
        } else if (row.isData() && !isComment(lines[i].text)) {
            last.data = i;
            if (row.size() >= layout.names.size()) last.row = i;
        }
    }
    return last;
}

/// Rows from the header to the end: further blocks begin with the same header, and a note may stand at the end.
void findRows(const std::vector<Line>& lines, std::size_t first, const std::string& name, TableLayout& layout) {
    Fields row;
    TableLayout::Range range{first, first};
    std::vector<TableLayout::Range> ranges;
    std::optional<Last> ahead;
    bool inside = true;
    bool apart = false;  // behind a blank line
    for (std::size_t i = first; i < lines.size(); ++i) {
        const std::string_view text = trimmedCell(lines[i].text);
        if (text.empty() || isComment(text)) {
            apart = apart || text.empty();
            continue;
        }
        const bool behindBlank = std::exchange(apart, false);
        row.cut(lines[i].text, layout.separator);
        if (sameNames(row, layout.names)) {
            if (inside) ranges.push_back(range);
            inside = true;
            range = {i + 1, i + 1};
            continue;
        }
        if (!inside || row.filled() == 0) {
            continue;
        }
        if (range.begin == range.end && range.begin > first && isUnitsRow(row)) {
            range = {i + 1, i + 1};
            continue;
        }
        // Words where numbers were: the head of another block, if its names follow; else a row to complain about.
        if (!row.isData() && row.width() != layout.names.size()) {
            if (!ahead) ahead = lastOf(lines, first, layout);
            const bool note = behindBlank ? ahead->row < i : ahead->data < i && row.filled() == 1;
            if (ahead->header > i || note) {
                if (ahead->header <= i && (ahead->data > i || row.filled() > 1) && layout.leftOut.empty()) {
                    layout.leftOut =
                        fmt::format("{}, line {}: another table begins here; it is left out.", name, lines[i].number);
                }
                ranges.push_back(range);
                inside = false;
                continue;
            }
        }
        range.end = i + 1;
    }
    if (inside) ranges.push_back(range);
    layout.rows = std::move(ranges);
}

double numberAt(const Fields& fields, std::size_t i, char decimal) {
    const Cell cell = i < fields.size() ? readCell(fields[i], decimal) : Cell{};
    return cell.kind == CellKind::Number ? cell.value : 0.0;
}

/// LabVIEW's LVM: a head, then segments of a head, a header and rows each; it names its own separator.
TableLayout lvmLayout(const std::vector<Line>& lines, const ReadOptions& options, const std::string& name) {
    TableLayout layout;
    layout.format = "LabVIEW measurement";
    layout.separator = options.separator != 0 ? options.separator : '\t';
    layout.decimal = options.decimal != 0 ? options.decimal : '.';
    Fields fields;
    bool columns = true;  // X stands in a column
    bool segment = false;
    bool header = false;
    std::vector<std::string> units, firstNames;
    double step_s = 0.0, x0_s = 0.0;
    TableLayout::Range range;
    const auto close = [&](std::size_t end) {
        if (range.end == 0 && range.begin > 0) {
            range.end = end;
            layout.rows.push_back(range);
        }
        range = {};
    };
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::string_view text = trimmedCell(lines[i].text);
        fields.cut(lines[i].text, layout.separator);
        if (text.empty()) {
            continue;
        }
        if (options.separator == 0 && range.begin == 0 && text.starts_with("Separator")) {
            const std::string value = normalised(text.substr(std::string_view("Separator").size()));
            layout.separator = value == "comma" ? ',' : value == "semicolon" ? ';' : '\t';
            continue;
        }
        const std::string_view key = fields[0];
        if (text.starts_with("***End_of_Header***")) {
            header = segment;
            continue;
        }
        if (header) {
            header = false;
            if (layout.names.empty()) {
                setNames(layout, fields);
                firstNames = layout.names;
                layout.headerLine = lines[i].number;
                for (std::size_t k = 0; k < layout.names.size(); ++k) {
                    const bool x = layout.names[k] == "X_Value";
                    const std::size_t channel = layout.names[0] == "X_Value" ? k : k + 1;
                    layout.units[k] = x ? "s" : channel > 0 && channel < units.size() ? units[channel] : std::string();
                }
                if (!columns) {
                    layout.step_s = step_s;
                    layout.x0_s = x0_s;
                    for (auto& one : layout.names) {
                        if (one == "X_Value") one.clear();
                    }
                }
            } else if (!sameNames(fields, firstNames)) {
                throw BadInput(
                    fmt::format("{}, line {}: this segment has other columns than the first; split the file.", name,
                                lines[i].number));
            }
            range.begin = i + 1;
            segment = false;
            continue;
        }
        if (range.begin > 0) {
            if (key == "Channels" || key == "Samples") {
                close(i);
                segment = key == "Channels";
            }
            continue;
        }
        if (key == "Decimal_Separator" && options.decimal == 0) {
            layout.decimal = fields.size() > 1 && fields[1] == "," ? ',' : text.ends_with(',') ? ',' : '.';
        } else if (key == "X_Columns") {
            columns = normalised(fields.size() > 1 ? fields[1] : std::string_view()) != "no";
        } else if (key == "Channels") {
            segment = true;
        } else if (key == "Y_Unit_Label") {
            units.clear();
            for (const std::string_view unit : fields.all())
                units.push_back(normalised(unit));
        } else if (key == "X0" && segment) {
            x0_s = numberAt(fields, 1, layout.decimal);
        } else if (key == "Delta_X" && segment) {
            step_s = numberAt(fields, 1, layout.decimal);
        }
    }
    close(lines.size());
    if (layout.names.empty()) {
        throw BadInput(fmt::format("{}: a LabVIEW measurement without data behind ***End_of_Header***.", name));
    }
    layout.headerBlockLines = layout.headerLine - 1;
    return layout;
}

[[noreturn]] void refuseSeparator(const std::string& name, char one, char other) {
    throw BadInput(
        fmt::format("{}: {} and {} both cut every row into the same kind of fields; say which with --separator.", name,
                    separatorName(one), separatorName(other)));
}

}  // namespace

TableLayout findLayout(const std::vector<Line>& all, const ReadOptions& options, const std::string& name) {
    std::size_t first = lineBeforeAnyRow(all);
    if (first == all.size()) {
        throw BadInput(fmt::format("{}: empty; expected a header line with column names.", name));
    }
    if (trimmedCell(all[first].text).starts_with("LabVIEW Measurement")) {
        return lvmLayout(all, options, name);
    }
    char said = options.separator;
    if (const auto own = separatorLine(all[first].text)) {
        said = said != 0 ? said : *own;
        ++first;
    }
    const std::vector<Line> lines(all.begin() + static_cast<std::ptrdiff_t>(first), all.end());
    std::vector<char> tried(kSeparators.begin(), kSeparators.end());
    if (said != 0) {
        tried = {said};
    }
    const bool named = !options.names.empty();
    std::vector<Candidate> good;
    Candidate loose;
    for (const char separator : tried) {
        const Candidate one = look(lines, separator, said != 0 ? 1 : 2, named, options.names.size());
        if (one.found && (one.consistent >= kConsistent || said != 0)) {
            good.push_back(one);
        } else if (one.width > loose.width ||
                   (one.width > 0 && one.width == loose.width && one.consistent > loose.consistent)) {
            loose = one;
        }
    }
    std::ranges::stable_sort(good, [](const Candidate& a, const Candidate& b) {
        return a.numeric != b.numeric ? a.numeric > b.numeric : a.consistent > b.consistent;
    });
    // Blanks may stand beside any separator; they only count alone.
    if (good.size() > 1 && good[1].numeric == good[0].numeric && good[1].consistent == good[0].consistent) {
        if (good[0].separator != ' ' && good[1].separator != ' ') {
            refuseSeparator(name, good[0].separator, good[1].separator);
        }
        if (good[0].separator == ' ') std::swap(good[0], good[1]);
    }
    TableLayout layout;
    Candidate chosen;
    if (!good.empty()) {
        chosen = good.front();
    } else if (loose.width > 0) {
        chosen = loose;
    } else {
        if (named) {
            throw BadInput(
                fmt::format("{}: no row has the {} columns that --columns names.", name, options.names.size()));
        }
        chosen = look(lines, said != 0 ? said : ',', 1, false, 0);
        if (said == 0 && chosen.width <= 1 && !(chosen.found && chosen.consistent >= kConsistent)) {
            // One column: no separator between its fields, so a comma in them is a decimal one.
            const Candidate single = look(lines, ';', 1, false, 0);
            if (single.found && single.consistent >= kConsistent) chosen = single;
        }
        if (chosen.width == 0) {  // no rows, or no header
            const std::size_t begin = lineBeforeAnyRow(lines);
            if (begin == lines.size()) {
                throw BadInput(fmt::format("{}: empty; expected a header line with column names.", name));
            }
            Fields row;
            char best = said != 0 ? said : ',';
            std::size_t most = 0;
            for (const char separator : tried) {
                row.cut(lines[begin].text, separator);
                if (separator != ' ' && row.width() > most) {
                    most = row.width();
                    best = separator;
                }
            }
            Fields blanks;
            blanks.cut(lines[begin].text, ' ');
            row.cut(lines[begin].text, best);
            if ((row.isData() && readCell(row[0]).kind == CellKind::Number) ||
                (blanks.size() > 1 && blanks.isData() && readCell(blanks[0]).kind == CellKind::Number)) {
                throw HeaderMissing(
                    fmt::format("{}, line {}: numbers without a header line; expected column names, or say them with "
                                "--columns.",
                                name, lines[begin].number),
                    lines[begin].number);
            }
            chosen.separator = best;
            chosen.header = chosen.units = begin;
            chosen.firstRow = begin + 1;
        }
    }
    layout.separator = chosen.separator;
    if (chosen.reordered) {
        throw BadInput(fmt::format("{}, line {}: a block with the columns of line {} in another order; split the file.",
                                   name, lines[std::max(chosen.otherHeader, chosen.header)].number,
                                   lines[std::min(chosen.otherHeader, chosen.header)].number));
    }
    if (chosen.otherRows > 0) {
        layout.leftOut = fmt::format("{}, line {}: another table begins here; its {} rows are left out.", name,
                                     lines[chosen.otherHeader].number, chosen.otherRows);
    }
    Fields fields;
    if (named) {
        layout.names = options.names;
        std::ranges::replace(layout.names, std::string("-"), std::string());
        layout.units.resize(layout.names.size());
        layout.headerLine = lines[chosen.firstRow].number;
    } else {
        fields.cut(lines[chosen.header].text, layout.separator);
        setNames(layout, fields);
        layout.headerLine = lines[chosen.header].number;
        if (chosen.units != chosen.header) {
            fields.cut(lines[chosen.units].text, layout.separator);
            setUnits(layout, fields);
        }
        for (std::size_t i = 0; i < chosen.header; ++i) {
            layout.headerBlockLines += trimmedCell(lines[i].text).empty() || isComment(lines[i].text) ? 0U : 1U;
        }
    }
    findRows(lines, chosen.firstRow, name, layout);
    for (auto& range : layout.rows) {  // lines were counted without what stood before them
        range.begin += first;
        range.end += first;
    }
    return layout;
}

}  // namespace kerf::files
