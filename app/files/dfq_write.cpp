// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>

#include "app/files/dfq.h"
#include "app/files/dfq_line.h"

namespace kerf::dfq {

namespace {

constexpr std::string_view kLineEnd = "\r\n";
constexpr std::string_view kMark = "\xEF\xBB\xBF";

/// Can stand between two separators and be found there again.
bool fieldFitsALine(const Field& field) {
    const auto& text = field.text;
    if (text.find_first_of("\x0F\x14\r\n") != std::string::npos) {
        return false;
    }
    if (holdsPicture(text)) {
        return false;  // readers take it for a separator
    }
    if (field.key == 5 && (timeOf(text) || timeOf(text, SlashDates::DayFirst))) {
        return false;  // a time in the place of the events would make an attribute characteristic of it
    }
    return text.empty() || (text.front() != ' ' && text.front() != '\t' && text.back() != ' ' && text.back() != '\t');
}

/// Place of a key in a value line; empty: a K line of its own.
std::optional<std::size_t> placeOf(int key, bool attribute) {
    if (key < 0 && !(attribute && key == -3)) {
        return static_cast<std::size_t>(-key - 1);  // an unnamed place keeps its number
    }
    const auto place = [key](const auto& order) -> std::optional<std::size_t> {
        const auto found = std::ranges::find(order, key);
        return found == order.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - order.begin()));
    };
    return attribute ? place(kAttributeOrder) : place(kVariableOrder);
}

class Writer {
 public:
    explicit Writer(const File& file) : m_file(file) {
        for (const Entry& entry : file.entries) {
            if (entry.key == 2004) {
                m_kinds[entry.index.value_or(1)] = entry.text;
            }
        }
    }

    std::string run() {
        line("K0100 {}", m_file.characteristics);
        for (const Entry& entry : m_file.entries) {
            std::string address = entry.index ? fmt::format("/{}", *entry.index) : std::string{};
            if (!entry.subIndex.empty()) {
                address += "/" + entry.subIndex;
            }
            line("K{:04}{} {}", entry.key, address, oneLine(entry.text));
        }
        std::map<std::uint32_t, std::map<std::uint32_t, const Value*>> rows;
        std::vector<const Value*> doubles;
        for (const Value& value : m_file.values) {
            if (!rows[value.row].emplace(value.characteristic, &value).second) {
                doubles.push_back(&value);
            }
        }
        for (const auto& [number, row] : rows) {
            writeRow(row);
        }
        for (const Value* value : doubles) {
            writeByKeys(*value);
        }
        return std::move(m_text);
    }

 private:
    template <class... Args>
    void line(fmt::format_string<Args...> format, Args&&... args) {
        fmt::format_to(std::back_inserter(m_text), format, std::forward<Args>(args)...);
        m_text += kLineEnd;
    }

    static std::string oneLine(std::string text) {
        std::ranges::replace(text, '\r', ' ');
        std::ranges::replace(text, '\n', ' ');
        return text;
    }

    /// The order of the fields in a line is told by the kind of the characteristic.
    [[nodiscard]] bool isAttribute(const Value& value) const {
        auto kind = m_kinds.find(value.characteristic);
        if (kind == m_kinds.end()) {
            kind = m_kinds.find(0);
        }
        return kind != m_kinds.end() && !kind->second.empty()
                   ? kind->second == "1" || kind->second == "5" || kind->second == "6"
                   : value.find(20) != nullptr;
    }

    /// Can be read back from a place in a line.
    [[nodiscard]] bool fitsALine(const Value& value) const {
        const bool attribute = isAttribute(value);
        if (value.find(attribute ? 1 : 20) != nullptr) {
            return false;  // belongs to the other kind, and would open another value
        }
        return std::ranges::any_of(value.fields, [&](const Field& field) {
            return field.key > 0 && !field.text.empty() && placeOf(field.key, attribute) && fieldFitsALine(field);
        });
    }

    void writeRow(const std::map<std::uint32_t, const Value*>& row) {
        std::string text;
        std::uint32_t at = 1;
        for (const auto& [characteristic, value] : row) {
            if (fitsALine(*value)) {
                text.append(characteristic - at, '\x0F');
                at = characteristic;
                text += fieldsOf(*value);
            }
        }
        if (!text.empty()) {
            m_text += text;
            m_text += kLineEnd;
        }
        for (const auto& [characteristic, value] : row) {
            if (!fitsALine(*value)) {
                writeByKeys(*value);
                continue;
            }
            for (const Field& field : value->fields) {
                if (field.key > 0 && (!placeOf(field.key, isAttribute(*value)) || !fieldFitsALine(field))) {
                    line("K{:04}/{} {}", field.key, characteristic, oneLine(field.text));
                }
            }
        }
    }

    [[nodiscard]] std::string fieldsOf(const Value& value) const {
        const bool attribute = isAttribute(value);
        std::vector<std::string> places(attribute ? kAttributeOrder.size() : kVariableOrder.size());
        for (const Field& field : value.fields) {
            if (const auto place = placeOf(field.key, attribute); place && fieldFitsALine(field)) {
                places.resize(std::max(places.size(), *place + 1));
                places[*place] = field.key == 6 && !field.text.empty() ? "#" + field.text : field.text;
            }
        }
        std::string text;
        for (std::size_t i = 0; i < places.size(); ++i) {
            text += (i == 0 ? "" : "\x14") + places[i];
        }
        return text;
    }

    /// K lines for every field; K0001, though empty, opens a new value.
    void writeByKeys(const Value& value) {
        const std::string* first = value.find(1);
        line("K0001/{} {}", value.characteristic, first != nullptr ? oneLine(*first) : std::string{});
        for (const Field& field : value.fields) {
            if (field.key > 1) {
                line("K{:04}/{} {}", field.key, value.characteristic, oneLine(field.text));
            }
        }
    }

    const File& m_file;
    std::map<std::uint32_t, std::string> m_kinds{};  ///< K2004 by characteristic, 0: all
    std::string m_text{};
};

}  // namespace

std::string write(const File& file) {
    std::string text = Writer(file).run();
    bool lossless = true;
    if (file.encoding == Encoding::Windows1252) {
        std::string bytes = windows1252(text, lossless);
        if (lossless) {
            return bytes;
        }
    }
    return std::string(kMark) + text;
}

}  // namespace kerf::dfq
