// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sensors/json_keys.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "app/sensors/sensor_file.h"
#include "engine/core/sentence.h"
#include "engine/core/utf8.h"

namespace kerf::sensors {
namespace {

constexpr int kDeepest = 16;
constexpr std::size_t kMostKeys = 1000;   // of one object: each new one is compared with all before it
constexpr std::size_t kLongestName = 22;  // of a sentence's argument

std::string shown(const Json& value) {
    return brief(value.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace

std::string brief(const std::string& text) {
    std::string out = text.size() > 40 ? std::string(beginOf(text, 37)) + "..." : text;
    std::ranges::replace_if(
        out, [](unsigned char c) { return c < ' ' || c == 0x7F; }, '?');
    return out;
}

Json parseStrictly(const std::string& text) {
    std::vector<std::set<std::string>> open;
    std::string twice;
    bool deep = false;
    bool many = false;
    const auto watch = [&](int depth, Json::parse_event_t event, Json& parsed) {
        deep = deep || depth > kDeepest;
        if (event == Json::parse_event_t::object_start) {
            open.emplace_back();
        } else if (event == Json::parse_event_t::object_end) {
            open.pop_back();
        } else if (event == Json::parse_event_t::key && !open.empty() && twice.empty()) {
            if (auto key = parsed.get<std::string>(); !open.back().insert(key).second) {
                twice = std::move(key);
            }
            many = many || open.back().size() > kMostKeys;
        }
        return !deep && !many;
    };
    Json json;
    try {
        json = Json::parse(text, watch);
    } catch (const Json::parse_error& error) {
        const std::size_t end = std::min(text.size(), error.byte > 0 ? error.byte - 1 : 0);
        const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
        const std::size_t before = end > 0 ? text.rfind('\n', end - 1) : std::string::npos;
        const std::size_t column = end - (before == std::string::npos ? 0 : before + 1) + 1;
        throw SensorFileFault(
            {}, KERF_TEXT("line %1, column %2: this is no JSON from here on; expected a complete JSON object."),
            {std::to_string(line), std::to_string(column)});
    } catch (const Json::out_of_range&) {
        throw SensorFileFault({}, KERF_TEXT("the file: a number is too large to be stored; expected a sensor file."));
    }
    if (deep) {
        throw SensorFileFault({},
                              KERF_TEXT("the file: more than %1 brackets inside each other; expected a sensor file."),
                              {std::to_string(kDeepest)});
    }
    if (many) {
        throw SensorFileFault({}, KERF_TEXT("the file: more than %1 keys in one object; expected a sensor file."),
                              {std::to_string(kMostKeys)});
    }
    if (!twice.empty()) {
        throw SensorFileFault(brief(twice), KERF_TEXT("the key stands twice in one object; expected it once."));
    }
    return json;
}

JsonKeys::JsonKeys(const Json& object, std::string where) : m_object(object), m_where(std::move(where)) {
    if (!object.is_object()) {
        throw SensorFileFault(m_where,
                              m_where.empty() ? KERF_TEXT("the file: %1 is no object; expected {…} with keys.")
                                              : KERF_TEXT("%1 is no object; expected {…} with keys."),
                              {shown(object)});
    }
}

std::string JsonKeys::path(const std::string& key) const {
    return m_where.empty() ? brief(key) : m_where + '.' + brief(key);
}

void JsonKeys::only(std::initializer_list<const char*> known, const char* ofWhat) const {
    for (const auto& [key, value] : m_object.items()) {
        if (std::ranges::none_of(known, [&](const char* name) { return key == name; })) {
            throw SensorFileFault(path(key), KERF_TEXT("unknown key %2; expected one of %1."),
                                  {fmt::format("{}", fmt::join(known, ", ")), ofWhat});
        }
    }
}

const Json& JsonKeys::value(const std::string& key) const {
    const auto found = m_object.find(key);
    if (found == m_object.end()) {
        throw SensorFileFault(path(key), KERF_TEXT("missing; expected a value."));
    }
    return *found;
}

std::string JsonKeys::text(const std::string& key) const {
    const Json& found = value(key);
    if (!found.is_string() || found.get<std::string>().empty()) {
        throw SensorFileFault(path(key), KERF_TEXT("%1 is no text; expected a text that is not empty."),
                              {shown(found)});
    }
    return found.get<std::string>();
}

std::string JsonKeys::text(const std::string& key, const std::string& otherwise) const {
    if (!has(key)) {
        return otherwise;
    }
    const Json& found = value(key);
    if (!found.is_string()) {
        throw SensorFileFault(path(key), KERF_TEXT("%1 is no text; expected a text."), {shown(found)});
    }
    return found.get<std::string>();
}

std::string JsonKeys::name(const std::string& key) const {
    std::string found = text(key);
    const bool plain = std::ranges::none_of(found, [](char c) { return c == ',' || c == '"' || (c >= 0 && c < ' '); });
    if (found.size() > kLongestName || !plain) {
        throw SensorFileFault(path(key),
                              KERF_TEXT("'%1' is no name; expected 1 to %2 bytes without comma, quote or line end."),
                              {brief(found), std::to_string(kLongestName)});
    }
    return found;
}

int JsonKeys::integer(const std::string& key, int low, int high) const {
    const Json& found = value(key);
    const bool whole = found.is_number_integer();
    const bool fits = whole && (found.is_number_unsigned()
                                    ? found.get<std::uint64_t>() <= static_cast<std::uint64_t>(std::max(high, 0))
                                    : found.get<std::int64_t>() <= high);
    if (!fits || found.get<std::int64_t>() < low) {
        throw SensorFileFault(path(key), KERF_TEXT("%1 is out of range; expected a whole number from %2 to %3."),
                              {shown(found), std::to_string(low), std::to_string(high)});
    }
    return found.get<int>();
}

double JsonKeys::number(const std::string& key, double low, double high, double otherwise) const {
    if (!has(key)) {
        return otherwise;
    }
    const Json& found = value(key);
    const double number = found.is_number() ? found.get<double>() : std::nan("");
    if (!(number >= low && number <= high)) {
        throw SensorFileFault(path(key), KERF_TEXT("%1 is out of range; expected a number from %2 to %3."),
                              {shown(found), fmt::format("{:g}", low), fmt::format("{:g}", high)});
    }
    return number;
}

bool JsonKeys::flag(const std::string& key, bool otherwise) const {
    if (!has(key)) {
        return otherwise;
    }
    const Json& found = value(key);
    if (!found.is_boolean()) {
        throw SensorFileFault(path(key), KERF_TEXT("%1 is neither; expected true or false."), {shown(found)});
    }
    return found.get<bool>();
}

std::vector<double> JsonKeys::numbers(const std::string& key, double low, double high, bool whole) const {
    std::vector<double> out;
    for (std::size_t i = 0; const Json& one : list(key)) {
        const double number = one.is_number() ? one.get<double>() : std::nan("");
        if (!(number >= low && number <= high) || (whole && std::floor(number) != number)) {
            throw SensorFileFault(fmt::format("{}[{}]", path(key), i),
                                  whole ? KERF_TEXT("%1 is out of range; expected a whole number from %2 to %3.")
                                        : KERF_TEXT("%1 is out of range; expected a number from %2 to %3."),
                                  {shown(one), fmt::format("{:.10g}", low), fmt::format("{:.10g}", high)});
        }
        out.push_back(number);
        ++i;
    }
    return out;
}

const Json& JsonKeys::list(const std::string& key) const {
    const Json& found = value(key);
    if (!found.is_array()) {
        throw SensorFileFault(path(key), KERF_TEXT("%1 is no list; expected [ … ]."), {shown(found)});
    }
    return found;
}

void JsonKeys::refuseWord(const std::string& key, const std::string& word,
                          const std::vector<std::string>& words) const {
    throw SensorFileFault(path(key), KERF_TEXT("'%1' is not known; expected one of %2."),
                          {brief(word), fmt::format("{}", fmt::join(words, ", "))});
}

}  // namespace kerf::sensors
