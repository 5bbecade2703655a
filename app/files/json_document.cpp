// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/json_document.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

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

}  // namespace

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
