// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sensors/gauge_frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <regex>

#include "engine/core/sentence.h"

namespace kerf::sensors {
namespace {

constexpr std::size_t kLongestFrame = 64;  // std::regex recurses with the text

std::string withoutBlanks(const std::string& text) {
    std::string out;
    std::ranges::copy_if(text, std::back_inserter(out), [](char c) { return c != ' ' && c != '\t' && c != '\0'; });
    return out;
}

/// "+00012.345", "12,5", "-.5"; whatever the locale.
std::optional<double> decimal(std::string text) {
    std::ranges::replace(text, ',', '.');
    if (text.starts_with('+')) {
        text.erase(0, 1);
    }
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
    const bool whole = error == std::errc{} && end == text.data() + text.size() && std::isfinite(value);
    return whole ? std::optional(value) : std::nullopt;
}

std::optional<GaugeFrame> parseDigimatic(const Gauge& gauge, const std::string& line) {
    static const std::regex frame("([0-9]{2})A([+-][0-9]{1,7}\\.[0-9]{1,6})");
    std::smatch match;
    if (!std::regex_match(line, match, frame)) {
        return std::nullopt;
    }
    const auto value = decimal(match[2].str());
    return value ? std::optional(GaugeFrame{*value, gauge.inch, match[1].str()}) : std::nullopt;
}

std::optional<GaugeFrame> parsePlain(const Gauge& gauge, const std::string& line) {
    static const std::regex frame("([+-]?[0-9]{0,7}[.,][0-9]{1,6})(mm|MM|in|IN|inch|\")?");
    std::smatch match;
    const std::string text = withoutBlanks(line);
    if (!std::regex_match(text, match, frame)) {
        return std::nullopt;
    }
    const auto value = decimal(match[1].str());
    if (!value) {
        return std::nullopt;
    }
    const std::string unit = match[2].str();
    return GaugeFrame{*value, unit.empty() ? gauge.inch : unit != "mm" && unit != "MM", {}};
}

std::optional<GaugeFrame> parseByPattern(const Gauge& gauge, const std::string& line) {
    try {
        const std::regex frame(gauge.pattern);
        std::smatch match;
        if (!std::regex_match(line, match, frame) || match.size() < 2) {
            return std::nullopt;
        }
        const auto value = decimal(withoutBlanks(match[1].str()));
        return value ? std::optional(GaugeFrame{*value, gauge.inch, match.size() > 2 ? match[2].str() : std::string{}})
                     : std::nullopt;
    } catch (const std::regex_error&) {
        return std::nullopt;
    }
}

}  // namespace

std::optional<GaugeFrame> parseGaugeFrame(const Gauge& gauge, const std::string& line) {
    if (line.empty() || line.size() > kLongestFrame) {
        return std::nullopt;
    }
    switch (gauge.protocol) {
        case GaugeProtocol::Digimatic:
            return parseDigimatic(gauge, withoutBlanks(line));
        case GaugeProtocol::Mahr:
        case GaugeProtocol::Sylvac:
            return parsePlain(gauge, line);
        case GaugeProtocol::Pattern:
            break;
    }
    return parseByPattern(gauge, line);
}

std::optional<int> depthOf(const Gauge& gauge, const std::string& channel) {
    const auto known = std::ranges::find(gauge.depths, channel, &std::pair<std::string, int>::first);
    return known != gauge.depths.end() ? std::optional(known->second) : std::nullopt;
}

std::string wedgeFrame(const Gauge& gauge, const std::string& channel, double value, bool inch) {
    const bool numbered = !channel.empty() && channel.size() <= 2 &&
                          std::ranges::all_of(channel, [](char c) { return c >= '0' && c <= '9'; });
    const std::string sent = numbered && !depthOf(gauge, channel) ? channel + 'A' : std::string{};
    return fmt::format("{}{:+.5f}{}", sent, value, inch ? "in" : "mm");
}

const char* whyNotAPattern(const std::string& pattern) {
    try {
        const std::regex expression(pattern);
        return expression.mark_count() >= 1 ? nullptr
                                            : KERF_TEXT("'%1': it has no group; expected one around the value.");
    } catch (const std::regex_error&) {
        return KERF_TEXT("'%1': it is no regular expression; expected one as ^.*?([+-][0-9.]+).*$.");
    }
}

}  // namespace kerf::sensors
