// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "app/files/dfq.h"
#include "app/files/dfq_description.h"
#include "app/files/dfq_field.h"
#include "app/files/dfq_findings.h"
#include "app/files/dfq_line.h"
#include "app/files/dfq_loose.h"
#include "engine/core/utf8.h"

namespace kerf::dfq {
namespace {

constexpr std::uint32_t kMostCharacteristics = 100'000;

class Reader : public Findings {
 public:
    Reader(File& file, SlashDates slashes, bool said) : Findings(file), m_slashes(slashes), m_said(said) {
        for (const Entry& entry : file.entries) {
            note(entry);
        }
        for (std::size_t i = 0; i < file.values.size(); ++i) {
            Track& track = m_tracks[file.values[i].characteristic];
            track.values.push_back(i);
            track.row = std::max(track.row, file.values[i].row);
            m_row = std::max(m_row, track.row);
        }
    }

    /// A date was met that only makes sense with the day first: the whole file is to be read so.
    [[nodiscard]] bool wantsDayFirst() const noexcept { return m_dayFirst; }

    tl::expected<void, Problem> run(std::string_view bytes) {
        Encoding encoding{};
        const std::string text = decoded(bytes, encoding);
        m_file.encoding = encoding;
        if (encoding != Encoding::Windows1252) {
            odd(0, fmt::format("the text is {}, not Windows-1252", encodingName(encoding)));
        }
        if (m_slashes == SlashDates::DayFirst) {
            odd(0, "dates with the day in front of the month and slashes");
        }
        bool bareFeeds = false;
        bool pairs = false;
        bool blanks = false;
        for (std::size_t begin = 0; begin < text.size() && !m_problem;) {
            const auto end = std::min(text.find_first_of("\r\n", begin), text.size());
            ++m_line;
            const std::string_view line = std::string_view(text).substr(begin, end - begin);
            const bool pair = end + 1 < text.size() && text[end] == '\r' && text[end + 1] == '\n';
            bareFeeds = bareFeeds || (end < text.size() && !pair);
            pairs = pairs || pair;
            blanks = blanks || line.ends_with(' ') || line.ends_with('\t');
            takeLine(line);
            begin = end + (pair ? 2 : 1);
        }
        if (bareFeeds) {
            odd(0, pairs ? "some lines end without CR LF" : "lines end without CR LF");
        }
        if (blanks) {
            odd(0, "blanks at the ends of lines");
        }
        if (m_problem) {
            return tl::unexpected(*m_problem);
        }
        return finish();
    }

 private:
    /// What is known of one characteristic's values.
    struct Track {
        std::vector<std::size_t> values{};
        std::uint32_t row{0};
        std::set<int> keys{};  ///< of the newest value, as far as K lines made it
        bool byLine{false};    ///< the newest value came in a value line
    };

    /// A K field has come: what stood in front of it was a title.
    void leavePreface() {
        if (m_preface) {
            odd(m_preface->line, "words in front of the first key, left out");
            m_preface.reset();
        }
    }

    void note(const Entry& entry) {
        if (entry.key == 2004 && !entry.text.empty()) {
            m_kinds[entry.index.value_or(1)] = entry.text;
        }
        if (entry.key >= 2000 && entry.key < 3000) {
            m_described = std::max(m_described, entry.index.value_or(1));
        }
    }

    void takeLine(std::string_view line) {
        if (line.find('\0') != std::string_view::npos) {
            bad("line", "a zero byte; this is no text file");
            return;
        }
        std::string_view plain = trimmed(line);
        if (plain.empty()) {
            return;
        }
        std::string bare;
        if (plain.size() > 2 && plain.front() == '"' && plain.back() == '"' && plain.find('"', 1) == plain.size() - 1) {
            oddOnce("lines in quotes");
            bare = plain.substr(1, plain.size() - 2);
            line = bare;
            plain = trimmed(line);
        }
        if (plain == "\x1A") {  // the end mark of old editors
            return;
        }
        const bool isKey =
            plain.size() >= 2 && (plain[0] == 'K' || plain[0] == 'k') && plain[1] >= '0' && plain[1] <= '9';
        if (isKey) {
            leavePreface();
            if (plain.size() != line.size() && line.front() != 'K' && line.front() != 'k') {
                odd(m_line, "blanks in front of the key");
            }
            takeKeyLine(plain);
            return;
        }
        const bool numeric = plain.find_first_of("0123456789+-.,") == 0;
        const bool separated = line.find(kBetweenFields) != std::string_view::npos ||
                               line.find(kBetweenCharacteristics) != std::string_view::npos;
        const bool remark = (m_file.entries.empty() || !m_file.values.empty()) && isRemark(plain);
        if (!separated && remark) {
            odd(m_line, fmt::format("'{}' left out: a remark", beginOf(plain, 40)));
        } else if (numeric || separated) {
            if (m_preface) {
                m_problem = m_preface;  // a table, not a Q-DAS file
                return;
            }
            takeValueLine(line);
        } else if (m_described == 0 && m_file.entries.empty() && m_file.values.empty()) {
            if (!m_preface) {
                m_preface = Problem{m_line, "line", "neither a K field nor values; expected a DFQ, DFD or DFX file"};
            }
        } else if (!m_file.values.empty()) {
            bad("K0001", fmt::format("'{}' is neither a K field nor values", beginOf(plain, 40)));
        } else if (!m_file.entries.empty()) {
            odd(m_line, fmt::format("a line without a key, taken as more of {}", keyName(m_file.entries.back().key)));
            std::string& text = m_file.entries.back().text;
            text += text.empty() ? "" : " ";
            text += plain;
        }
    }

    /// `Knnnn`, `Knnnn/i`, `Knnnn/i/j`, then blank or tab, then text.
    void takeKeyLine(std::string_view line) {
        if (line[0] == 'k') {
            oddOnce("a key in small letters");
        }
        std::size_t at = 1;
        int key = 0;
        while (at < line.size() && at < 6 && line[at] >= '0' && line[at] <= '9') {
            key = key * 10 + (line[at++] - '0');
        }
        const std::size_t digits = at - 1;
        if (digits != 4) {
            odd(m_line, fmt::format("a key of {} digits", digits));
        }
        std::optional<std::uint32_t> index;
        std::string sub;
        const std::size_t blank = std::min(line.find_first_of(" \t", at), line.size());
        std::string_view address = line.substr(at, blank - at);
        std::string text(trimmed(line.substr(blank)));
        takeSign(address, text);
        if (!address.empty() && address.front() == '/') {
            address.remove_prefix(1);
            const auto slash = std::min(address.find('/'), address.size());
            const std::string_view number = address.substr(0, slash);
            sub = address.substr(std::min(slash + 1, address.size()));
            if (number.empty()) {
                odd(m_line, "an empty index, taken as 1");
                index = 1;
            } else {
                std::uint32_t value = 0;
                const auto [stop, error] = std::from_chars(number.data(), number.data() + number.size(), value);
                if (error != std::errc{} || stop != number.data() + number.size() || value > kMostCharacteristics) {
                    bad(keyName(key), fmt::format("'{}' is no index", number));
                    return;
                }
                index = value;
            }
        } else if (!address.empty()) {
            odd(m_line, "no blank between key and text");
            text = std::string(address) + (text.empty() ? "" : " " + text);
        }
        if (key == 100) {
            std::uint32_t count = 0;
            const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), count);
            if (text.empty()) {
                odd(m_line, "K0100 without its number");
                return;
            }
            const auto whole = numberOf(text);  // "2.0"
            if (whole && *whole == std::floor(*whole) && *whole >= 0.0 && *whole <= kMostCharacteristics) {
                count = static_cast<std::uint32_t>(*whole);
            } else if (error != std::errc{} || stop != text.data() + text.size() || count > kMostCharacteristics) {
                bad("K0100", fmt::format("'{}' is no number of characteristics", text));
                return;
            }
            if (m_announced) {
                odd(m_line, "K0100 once more: files put one behind the other");
                beginAnother();
            }
            m_announced = count;
            m_count = count;
        } else if (key > 0 && key < 100) {
            takeValueKey(key, index.value_or(1), sub, std::move(text));
        } else {
            if (!sub.empty() && key < 4000) {
                odd(m_line, "a value's index on a key of the description");
            }
            if (isNumeric(key) && !text.empty() && !numberOf(text) && !looseNumberOf(withoutUnit(text, {}))) {
                odd(m_line, fmt::format("{} '{}' is no number, kept as text", keyName(key), beginOf(text, 40)));
            }
            m_file.entries.push_back({key, index, std::move(sub), std::move(text)});
            note(m_file.entries.back());
        }
    }

    /// Another file begins within this one.
    void beginAnother() {
        settle();
        m_begin = m_file.entries.size();
        m_unsettled = true;
        m_before = std::max(m_described, m_tracks.empty() ? 0U : m_tracks.rbegin()->first);
        m_offset = 0;
    }

    /// Before its first value: does it describe the same characteristics once more, or others?
    void settle() {
        if (!std::exchange(m_unsettled, false)) {
            return;
        }
        m_offset = countOn(m_file.entries, m_begin, m_before, m_count);
        if (m_offset == 0) {
            return;
        }
        odd(m_line, fmt::format("a description of others behind the first: its characteristics are counted on from {}",
                                m_offset + 1));
        m_announced = m_offset + m_count;
        m_described = 0;
        m_kinds.clear();
        for (const Entry& entry : m_file.entries) {
            note(entry);
        }
    }

    /// "K2002(1) text", "K2002/1=text", "K2002/1: text": the index as it should stand, what follows it in front of the
    /// text.
    void takeSign(std::string_view& address, std::string& text) {
        std::size_t end = 1;
        while (end < address.size() && address[end] >= '0' && address[end] <= '9') {
            ++end;
        }
        const bool brackets = address.starts_with('(') || address.starts_with('[');
        if (end == 1 || (!brackets && !address.starts_with('/'))) {
            return;
        }
        const std::string_view rest = address.substr(end);
        const bool closed = brackets && (rest.starts_with(')') || rest.starts_with(']'));
        const bool sign = !brackets && (rest.starts_with('=') || rest.starts_with(':') || rest.starts_with(';'));
        if (!closed && !sign) {
            return;
        }
        odd(0, closed ? "an index in brackets" : "a sign between index and text");
        if (rest.size() > 1) {
            text = std::string(rest.substr(1)) + (text.empty() ? "" : " " + text);
        }
        m_address = '/' + std::string(address.substr(1, end - 1));
        address = m_address;
    }

    void takeValueKey(int key, std::uint32_t characteristic, const std::string& sub, std::string text) {
        settle();
        characteristic += characteristic > 0 ? m_offset : 0;
        if (!sub.empty()) {
            takeIndexedKey(key, characteristic, sub, std::move(text));
            return;
        }
        if (characteristic > 0) {
            addByKey(characteristic, key, std::move(text));
            return;
        }
        bool any = false;
        for (auto& [number, track] : m_tracks) {
            if (number > m_offset && !track.values.empty() && m_file.values[track.values.back()].row == m_row) {
                addByKey(number, key, text);
                any = true;
            }
        }
        if (!any) {
            odd(m_line, fmt::format("{} for all characteristics before any value, kept for the first", keyName(key)));
            m_inFront = true;
            m_pending.push_back({key, std::move(text)});
        }
    }

    /// K…/i/j: the j-th value of characteristic i; 0 stands for all.
    void takeIndexedKey(int key, std::uint32_t characteristic, const std::string& sub, std::string text) {
        std::uint32_t place = 0;
        const auto [stop, error] = std::from_chars(sub.data(), sub.data() + sub.size(), place);
        if (error != std::errc{} || stop != sub.data() + sub.size()) {
            bad(keyName(key), fmt::format("'{}' is no index of a value", sub));
            return;
        }
        bool any = false;
        for (auto& [number, track] : m_tracks) {
            if (characteristic != 0 ? number != characteristic : number <= m_offset) {
                continue;
            }
            for (std::size_t i = 0; i < track.values.size(); ++i) {
                if (place == 0 || i + 1 == place) {
                    set(m_file.values[track.values[i]], key, text);
                    any = true;
                }
            }
        }
        if (!any) {
            bad(keyName(key), fmt::format("there is no value {} of characteristic {}", sub, characteristic));
        }
    }

    /// K lines in front of a value line have begun its value.
    [[nodiscard]] bool isBegun(const Track& track) const {
        if (!m_inFront || track.values.empty() || track.byLine) {
            return false;
        }
        const Value& newest = m_file.values[track.values.back()];
        return newest.find(1) == nullptr && newest.find(20) == nullptr;
    }

    void addByKey(std::uint32_t characteristic, int key, std::string text) {
        Track& track = m_tracks[characteristic];
        const bool opens = key == 1 || key == 20;
        // Where such lines stand in front of their part, one that comes again is of the next part.
        const bool ofTheNext = m_inFront && key != 9 && track.keys.contains(key);
        const bool another = track.values.empty() || (track.byLine ? opens || ofTheNext : track.keys.contains(key));
        if (another && !opens && m_row == 0 && !m_inFront) {
            m_inFront = true;
            oddOnce(fmt::format("{} in front of the value it belongs to", keyName(key)));
        }
        if (another) {
            begin(characteristic, track, track.row + 1, false);
        }
        const std::string* before = m_file.values[track.values.back()].find(key);
        if (track.byLine && before != nullptr && !before->empty()) {
            odd(m_line, fmt::format("{} stands twice for one value", keyName(key)));
        }
        track.keys.insert(key);
        set(m_file.values[track.values.back()], key, std::move(text));
    }

    void begin(std::uint32_t characteristic, Track& track, std::uint32_t row, bool byLine) {
        track.values.push_back(m_file.values.size());
        track.row = row;
        track.keys.clear();
        track.byLine = byLine;
        m_row = std::max(m_row, row);
        m_file.values.push_back({characteristic, row, {}, {}, kValid, {}, {}});
        if (track.values.size() == 1) {
            for (const Field& field : m_pending) {
                set(m_file.values.back(), field.key, field.text);
                track.keys.insert(field.key);
            }
        }
        if (characteristic > m_described && m_missing.insert(characteristic).second) {
            odd(m_line, fmt::format("a value of characteristic {}, which nothing describes", characteristic));
        }
    }

    /// Checks a field, brings it to the form that is written, and keeps it.
    void set(Value& value, int key, std::string text) {
        const std::string given = text;
        FieldReader reader(*this, m_file, m_slashes);
        if (!reader.take(value, key, text)) {
            m_dayFirst = m_dayFirst || reader.wantsDayFirst();
            return;
        }
        m_monthFirst = m_monthFirst || reader.sawMonthFirst();
        if (reader.sawEither() && !m_either) m_either = Problem{m_line, keyName(key), eitherOrder(given)};
        const auto same = std::ranges::find(value.fields, key, &Field::key);
        if (same != value.fields.end() && key != 9) {
            same->text = std::move(text);
        } else {
            value.fields.push_back({key, std::move(text)});
        }
    }

    void takeValueLine(std::string_view given) {
        settle();
        std::string line(given);
        for (std::string& oddity : repairSeparators(line)) {
            odd(0, std::move(oddity));
        }
        LineFields characteristics;
        if (line.find(kBetweenFields) == std::string::npos && line.find(kBetweenCharacteristics) == std::string::npos &&
            !numberOf(trimmed(line))) {
            characteristics = splitAtBlanks(line, std::max(m_described, m_announced.value_or(0)) - m_offset);
            if (characteristics.empty()) {
                bad("K0001", fmt::format("'{}' is no number", beginOf(trimmed(line), 40)));
                return;
            }
            odd(0, "values apart by blanks instead of 0x14 and 0x0F");
        } else {
            characteristics = splitAtSeparators(line);
        }
        const bool begun = std::ranges::any_of(m_tracks, [&](const auto& track) { return isBegun(track.second); });
        // What fields in front have begun may be of the characteristic that the line before left out: a second value of
        // another one in the same part there is not.
        bool again = false;
        for (std::size_t i = 0; i < characteristics.size(); ++i) {
            const auto track = m_tracks.find(m_offset + static_cast<std::uint32_t>(i + 1));
            again = again || (!isEmpty(characteristics[i]) && track != m_tracks.end() && track->second.byLine &&
                              m_file.values[track->second.values.back()].row == m_row);
        }
        const std::uint32_t row = begun && !again ? m_row : m_row + 1;
        bool any = false;
        for (std::size_t i = 0; i < characteristics.size() && !m_problem; ++i) {
            if (!isEmpty(characteristics[i])) {
                addByLine(m_offset + static_cast<std::uint32_t>(i + 1), row, characteristics[i]);
                any = true;
            }
        }
        if (any) {
            for (auto& [number, track] : m_tracks) {
                track.row = row;
            }
        }
    }

    [[nodiscard]] bool isAttribute(std::uint32_t characteristic, const std::vector<std::string_view>& fields) const {
        auto kind = m_kinds.find(characteristic);
        if (kind == m_kinds.end()) {
            kind = m_kinds.find(0);
        }
        if (kind != m_kinds.end()) {
            return kind->second == "1" || kind->second == "5" || kind->second == "6";
        }
        const auto timeAt = timePlace(fields);
        return timeAt == 3 || timeAt == 4 || (timeAt == 0 && fields.size() > kVariableOrder.size());
    }

    void addByLine(std::uint32_t characteristic, std::uint32_t row, const std::vector<std::string_view>& fields) {
        Track& track = m_tracks[characteristic];
        if (isBegun(track)) {
            track.byLine = true;
            m_file.values[track.values.back()].row = row;
        } else {
            begin(characteristic, track, row, true);
        }
        const std::size_t at = track.values.back();
        const bool attribute = isAttribute(characteristic, fields);
        // Attribute characteristics are written with and without the unnamed third field: their time tells.
        const bool named = attribute && fields.size() != kAttributeOrder.size() && timePlace(fields) != 4;
        for (std::size_t i = 0; i < fields.size() && !m_problem; ++i) {
            const std::size_t place = named && i >= 2 ? i + 1 : i;
            const std::size_t known = attribute ? kAttributeOrder.size() : kVariableOrder.size();
            const int key = place >= known ? -static_cast<int>(i + 1)
                                           : (attribute ? kAttributeOrder[place] : kVariableOrder[place]);
            std::string text(trimmed(fields[i]));
            if (key == 6) {
                if (text.starts_with('#')) {
                    text = std::string(trimmed(std::string_view(text).substr(1)));
                } else if (!text.empty()) {
                    odd(m_line, "a batch without # in front");
                }
            }
            set(m_file.values[at], key, std::move(text));
        }
    }

    tl::expected<void, Problem> finish() {
        settle();
        if (m_preface) {
            return tl::unexpected(*m_preface);
        }
        if (m_file.entries.empty() && m_file.values.empty() && !m_announced) {
            return tl::unexpected(
                Problem{m_line, "line", "the file holds neither a K field nor values; expected a DFQ, DFD or DFX"});
        }
        const std::uint32_t needed = m_tracks.empty() ? 0 : m_tracks.rbegin()->first;
        const std::uint32_t found = std::max(m_described, needed);
        if (!m_announced && m_file.characteristics == 0) {
            odd(0, "K0100 is missing");
        } else if (m_announced && *m_announced != found) {
            odd(0, fmt::format("K0100 says {} characteristics, there are {}", *m_announced, found));
        }
        if (m_either && !m_monthFirst && !m_said) {
            return tl::unexpected(*m_either);
        }
        m_file.characteristics = std::max({m_file.characteristics, m_announced.value_or(0), found});
        std::ranges::stable_sort(m_file.values, {},
                                 [](const Value& value) { return std::pair(value.row, value.characteristic); });
        return {};
    }

    std::optional<std::uint32_t> m_announced{};
    std::uint32_t m_described{0};
    std::size_t m_begin{0};     ///< first entry of the newest of several files put one behind the other …
    bool m_unsettled{false};    ///< … of which it is not known yet whether it describes other characteristics
    std::uint32_t m_before{0};  ///< characteristics before it
    std::uint32_t m_count{0};   ///< its K0100
    std::uint32_t m_offset{0};  ///< added to its characteristics' numbers
    std::uint32_t m_row{0};
    std::map<std::uint32_t, Track> m_tracks{};
    std::map<std::uint32_t, std::string> m_kinds{};
    std::set<std::uint32_t> m_missing{};
    std::vector<Field> m_pending{};
    std::string m_address{};             ///< of a key line whose index had to be mended
    std::optional<Problem> m_preface{};  ///< words in front of everything, of which nobody knows yet what they are
    bool m_inFront{false};               ///< K lines of a value stand before its value line
    SlashDates m_slashes;
    bool m_said;                        ///< … by somebody who knows
    bool m_monthFirst{false};           ///< some date tells
    std::optional<Problem> m_either{};  ///< the first that does not
    bool m_dayFirst{false};             ///< failed at a date that only stands with its day first
};

}  // namespace

const std::string* Value::find(int key) const {
    const auto found = std::ranges::find(fields, key, &Field::key);
    return found == fields.end() ? nullptr : &found->text;
}

const std::string* File::find(int key, std::uint32_t index) const {
    const std::string* common = nullptr;
    const std::string* own = nullptr;
    for (const Entry& entry : entries) {
        if (entry.key != key) {
            continue;
        }
        if (entry.index.value_or(1) == index) {
            own = &entry.text;
        } else if (entry.index == 0U) {
            common = &entry.text;
        }
    }
    return own != nullptr ? own : common;
}

tl::expected<File, Problem> read(std::string_view bytes, std::optional<SlashDates> said) {
    File file;
    if (auto done = readValues(bytes, file, said); !done) {
        return tl::unexpected(done.error());
    }
    return file;
}

tl::expected<void, Problem> readValues(std::string_view bytes, File& file, std::optional<SlashDates> said) {
    const Encoding described = file.encoding;
    File before = file;
    Reader reader(file, said.value_or(SlashDates::MonthFirst), said.has_value());
    auto done = reader.run(bytes);
    if (!done && !said && reader.wantsDayFirst()) {
        file = std::move(before);
        done = Reader(file, SlashDates::DayFirst, true).run(bytes);
    }
    if (described != Encoding::Windows1252) {
        file.encoding = described;
    }
    return done;
}

}  // namespace kerf::dfq
