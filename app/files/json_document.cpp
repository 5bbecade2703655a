// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/json_document.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "app/files/table.h"

namespace kerf::files {
namespace {

using nlohmann::json;

/// Deepest bracket of the text, brackets in strings aside. The text need not be JSON.
int depthOf(const std::string& text) {
    int depth = 0;
    int deepest = 0;
    bool inString = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (inString) {
            i += c == '\\' ? 1 : 0;
            inString = c != '"';
        } else if (c == '"') {
            inString = true;
        } else if (c == '{' || c == '[') {
            deepest = std::max(deepest, ++depth);
        } else if (c == '}' || c == ']') {
            --depth;
        }
    }
    return deepest;
}

/// The first number that is too large; NaN: none. Depth is bounded by now.
double tooLarge(const json& value) {
    if (value.is_number_float()) {
        const double number = value.get<double>();
        return std::abs(number) <= kLargestJsonNumber ? std::nan("") : number;
    }
    for (const json& each : value.is_structured() ? value : json::array()) {
        if (const double found = tooLarge(each); !std::isnan(found)) {
            return found;
        }
    }
    return std::nan("");
}

/// The keys of each object that is open.
class KeyWatch final : public json::json_sax_t {
 public:
    std::optional<std::string> twice{};

    bool null() override { return true; }
    bool boolean(bool /*value*/) override { return true; }
    bool number_integer(number_integer_t /*value*/) override { return true; }
    bool number_unsigned(number_unsigned_t /*value*/) override { return true; }
    bool number_float(number_float_t /*value*/, const string_t& /*text*/) override { return true; }
    bool string(string_t& /*value*/) override { return true; }
    bool binary(binary_t& /*value*/) override { return true; }
    bool start_object(std::size_t /*count*/) override {
        m_open.emplace_back();
        return true;
    }
    bool key(string_t& key) override {
        if (!m_open.back().insert(key).second) {
            twice = key;
        }
        return !twice;
    }
    bool end_object() override {
        m_open.pop_back();
        return true;
    }
    bool start_array(std::size_t /*count*/) override { return true; }
    bool end_array() override { return true; }
    bool parse_error(std::size_t /*at*/, const std::string& /*token*/, const json::exception& /*error*/) override {
        return false;
    }

 private:
    std::vector<std::set<std::string>> m_open{};
};

}  // namespace

std::optional<std::string> doubledKey(const std::string& text) {
    KeyWatch watch;
    (void)json::sax_parse(text, &watch);
    return watch.twice;
}

Result<json> parseJson(const std::string& text) {
    if (depthOf(text) > kDeepestJson) {
        return fail(KERF_TEXT("The JSON is nested deeper than %1 levels."), SentenceArg(kDeepestJson, 0));
    }
    try {
        json document = json::parse(text);
        if (const double number = tooLarge(document); !std::isnan(number)) {
            return fail(KERF_TEXT("The JSON holds %1; numbers are expected within ±1e60."),
                        SentenceArg(fmt::format("{:g}", number)));
        }
        if (const auto twice = doubledKey(text)) {
            return fail(KERF_TEXT("The key %1 stands twice in one object; it is expected once."), SentenceArg(*twice));
        }
        return document;
    } catch (const json::parse_error& error) {
        return fail(KERF_TEXT("This is not JSON: no valid JSON at byte %1."),
                    SentenceArg(static_cast<double>(error.byte), 0));
    } catch (const json::out_of_range&) {
        return fail(KERF_TEXT("The JSON holds a number too large to be stored; numbers are expected within ±1e60."));
    }
}

json readJsonFile(const std::string& path, std::string_view expected) {
    auto document = parseJson(headless::readFile(path));
    if (!document) {
        throw headless::BadInput(fmt::format("{}: {} Expected {}.", path, document.error().english(), expected));
    }
    return std::move(*document);
}

}  // namespace kerf::files
