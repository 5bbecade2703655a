// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/quality/dfq_export.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <ctime>
#include <filesystem>
#include <utility>
#include <vector>

#include "app/files/dfq_files.h"
#include "app/files/table.h"
#include "app/service/quality/lot_dfq.h"

namespace kerf {
namespace {

std::string fit(std::string text) {
    constexpr std::string_view kForbidden = "/\\:*?\"<>|";
    std::ranges::replace_if(
        text,
        [&](char c) { return static_cast<unsigned char>(c) < 0x20 || kForbidden.find(c) != std::string_view::npos; },
        '_');
    return text;
}

std::tm localOf(std::int64_t utc_ms) {
    const std::time_t seconds = static_cast<std::time_t>(utc_ms / 1000);
    std::tm local{};
    localtime_r(&seconds, &local);
    return local;
}

/// Replaces every {name}; empty: a name that is none, or a bracket without its other one.
std::optional<std::string> filled(const std::string& pattern, const LotRow& lot, const PartRow& part) {
    const std::tm ended = localOf(part.endedUtc_ms);
    const std::array<std::pair<std::string_view, std::string>, 7> values{
        {{"type", lot.partTypeName.empty() ? std::string(processKey(part.process)) : lot.partTypeName},
         {"lot", lot.name},
         {"part", std::to_string(part.number)},
         {"serial", part.serial.empty() ? std::to_string(part.number) : part.serial},
         {"machine", lot.machineName},
         {"date", fmt::format("{:04}{:02}{:02}", ended.tm_year + 1900, ended.tm_mon + 1, ended.tm_mday)},
         {"time", fmt::format("{:02}{:02}{:02}", ended.tm_hour, ended.tm_min, ended.tm_sec)}}};
    std::string name;
    for (std::size_t at = 0; at < pattern.size();) {
        if (pattern[at] != '{') {
            name += pattern[at++];
            continue;
        }
        const auto end = pattern.find('}', at);
        const auto found = end == std::string::npos
                               ? values.end()
                               : std::ranges::find(values, std::string_view(pattern).substr(at + 1, end - at - 1),
                                                   &std::pair<std::string_view, std::string>::first);
        if (found == values.end()) {
            return std::nullopt;
        }
        name += fit(found->second);
        at = end + 1;
    }
    return name;
}

/// What tells a part from every other one of the plant: type, lot, machine, operation and the part itself.
std::vector<std::string> identityOf(const dfq::File& file) {
    constexpr int kPartIdentity = 14;
    std::vector<std::string> identity;
    for (const int key : {1001, 1053, 1082, 1086}) {
        const std::string* text = file.find(key, 1);
        identity.push_back(text != nullptr ? *text : std::string());
    }
    const std::string* part = file.values.empty() ? nullptr : file.values.front().find(kPartIdentity);
    identity.push_back(part != nullptr ? *part : std::string());
    return identity;
}

/// A file of another part keeps its name, also one that was there before Kerf: the next free number goes behind.
/// `own`: what this part was written to before.
std::string freeName(const std::string& folder, const std::string& name, const dfq::File& content,
                     const std::string& own) {
    const std::size_t dot = name.rfind('.');
    for (std::size_t number = 1;; ++number) {
        std::string file = folder + "/" + name.substr(0, dot) +
                           (number == 1 ? std::string() : fmt::format("_{}", number)) + name.substr(dot);
        std::error_code error;
        if (file == own || !std::filesystem::exists(file, error)) {
            return file;
        }
        try {
            const auto there = dfq::read(headless::readFile(file));
            if (there && identityOf(*there) == identityOf(content)) {
                return file;
            }
        } catch (const headless::BadInput&) {
            continue;  // whatever it is, it is not this part's
        }
    }
}

}  // namespace

std::optional<Sentence> whyNoPattern(const std::string& pattern) {
    if (!filled(pattern, {}, {}) || pattern.find_first_of("/\\") != std::string::npos) {
        return Sentence(
            KERF_TEXT("A file name may hold {type}, {lot}, {part}, {serial}, {machine}, {date} and {time}, and "
                      "no folder."));
    }
    if (pattern.find("{part}") == std::string::npos && pattern.find("{serial}") == std::string::npos) {
        return Sentence(KERF_TEXT("The file name must hold {part} or {serial}: each part has a file of its own."));
    }
    return std::nullopt;
}

Result<std::string> dfqFileName(const std::string& pattern, const LotRow& lot, const PartRow& part) {
    if (const auto why = whyNoPattern(pattern)) {
        return tl::unexpected(*why);
    }
    std::string name = *filled(pattern, lot, part);
    const auto dot = name.rfind('.');
    std::string suffix = dot == std::string::npos ? std::string() : name.substr(dot);
    std::ranges::transform(suffix, suffix.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return suffix == ".dfq" ? name : name + ".dfq";
}

Result<std::string> exportPart(const QualityLot& lot, const PartRow& part, const std::string& folder,
                               const std::string& pattern, const std::string& own) {
    const auto name = dfqFileName(pattern, lot.history.lot, part);
    if (!name) {
        return name;
    }
    const dfq::File content = lotDfq(lot.history, lot.quality, DfqContent::Standing, part.id);
    std::string file = freeName(folder, *name, content, own);
    try {
        headless::writeDfqFile(file, content);
    } catch (const headless::BadInput&) {
        return fail(KERF_TEXT("%1 cannot be written."), SentenceArg(std::string_view(file)));
    }
    return file;
}

}  // namespace kerf
