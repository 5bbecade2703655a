// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/files/clock.h"
#include "app/files/text_encoding.h"
#include "app/files/whole_file.h"

/// Where in a text the table is, and how its rows are cut into fields.
namespace kerf::files {

/// What the person says about a file; what is not said is found out, or refused when it is in doubt.
struct ReadOptions {
    char separator{0};  ///< , ; tab | or a blank (runs of blanks); 0: found out
    char decimal{0};    ///< . or , ; 0: found out
    std::optional<Encoding> encoding{};
    std::vector<std::string> names{};  ///< of the columns, for a file without a header; "-" leaves one out
    std::optional<DateOrder> dates{};  ///< of dates that stand for two days; nothing: the column must tell
    double period_s{0.0};              ///< > 0: a time column t_s is added, for a file without one
    bool acceptImplausible{false};     ///< what cannot be meant is taken all the same, and told
};

struct Line {
    std::string_view text{};
    std::uint32_t number{0};  ///< from 1
};

/// One line cut into trimmed fields.
class Fields {
 public:
    void cut(std::string_view line, char separator);
    [[nodiscard]] std::size_t size() const noexcept { return m_fields.size(); }
    [[nodiscard]] std::string_view operator[](std::size_t i) const noexcept { return m_fields[i]; }
    /// Without empty ones at the end.
    [[nodiscard]] std::size_t width() const noexcept;
    /// Of fields with something in them: numbers, dates, marks for no value; and all.
    [[nodiscard]] std::size_t dataLike() const noexcept;
    [[nodiscard]] std::size_t filled() const noexcept;
    [[nodiscard]] bool isData() const noexcept;
    [[nodiscard]] const std::vector<std::string_view>& all() const noexcept { return m_fields; }

 private:
    std::vector<std::string_view> m_fields{};
    std::deque<std::string> m_unquoted{};
};

/// Lines of any ending (LF, CRLF, CR); a quoted field may go over several.
[[nodiscard]] std::vector<Line> linesOf(std::string_view text);
[[nodiscard]] bool isComment(std::string_view line) noexcept;

/// Numbers where a header was expected.
class HeaderMissing : public BadInput {
 public:
    HeaderMissing(const std::string& sentence, std::uint32_t line) : BadInput(sentence), m_line(line) {}
    [[nodiscard]] std::uint32_t line() const noexcept { return m_line; }

 private:
    std::uint32_t m_line;
};

struct TableLayout {
    char separator{','};
    char decimal{0};  ///< when the file itself says it
    std::vector<std::string> names{};
    std::vector<std::string> units{};  ///< by column, empty where none is declared
    std::uint32_t headerLine{1};
    struct Range {
        std::size_t begin{0}, end{0};  ///< indices of lines
    };
    std::vector<Range> rows{};
    std::string leftOut{};            ///< a sentence on another table in the same file
    std::size_t headerBlockLines{0};  ///< lines before the header that are no table
    std::string format{};             ///< "LabVIEW measurement" and the like, empty for a plain table
    double x0_s{0.0}, step_s{0.0};    ///< step > 0: the file holds no time column, but says how far apart its rows are
};

/// @throws BadInput with `name` in front of the sentence
[[nodiscard]] TableLayout findLayout(const std::vector<Line>& lines, const ReadOptions& options,
                                     const std::string& name);
/// "';'", "tab", …
[[nodiscard]] std::string separatorName(char separator);

}  // namespace kerf::files
