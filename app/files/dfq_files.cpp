// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/dfq_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <optional>
#include <set>

#include "app/files/table.h"

namespace kerf::headless {
namespace {

namespace fs = std::filesystem;

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

std::string suffixOf(const fs::path& path) {
    return lower(path.extension().string());
}

/// The file beside `path` with the same name and another suffix, in letters of any size.
std::optional<fs::path> partner(const fs::path& path, const std::string& suffix) {
    std::error_code error;
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
        const fs::path& other = at->path();
        if (suffixOf(other) == suffix && lower(other.stem().string()) == lower(path.stem().string())) {
            return path.has_parent_path() ? other : other.filename();
        }
    }
    return std::nullopt;
}

[[noreturn]] void refuse(const std::string& path, const dfq::Problem& problem) {
    throw BadInput(fmt::format("{}, line {}, field {}: {}.", path, problem.line, problem.field, problem.text));
}

}  // namespace

std::vector<std::pair<std::string, dfq::File>> readDfqFiles(const std::vector<std::string>& paths,
                                                            std::optional<dfq::SlashDates> dates) {
    std::vector<std::pair<std::string, dfq::File>> files;
    std::set<std::string> taken;
    // One description and one set of values named together belong together, whatever their names.
    const bool pair = paths.size() == 2 && ((suffixOf(paths[0]) == ".dfd" && suffixOf(paths[1]) == ".dfx") ||
                                            (suffixOf(paths[0]) == ".dfx" && suffixOf(paths[1]) == ".dfd"));
    for (const std::string& path : paths) {
        const std::string suffix = suffixOf(path);
        std::string description = path;
        std::optional<fs::path> values;
        std::optional<std::string> lonely;
        if (pair) {
            description = suffix == ".dfd" ? path : paths[&path == &paths[0] ? 1 : 0];
            values = suffix == ".dfx" ? path : paths[&path == &paths[0] ? 1 : 0];
        } else if (suffix == ".dfx") {
            if (const auto found = partner(path, ".dfd")) {
                description = found->string();
                values = path;
            } else {
                lonely = "there is no DFD beside it: the characteristics are not described";
            }
        } else if (suffix == ".dfd") {
            values = partner(path, ".dfx");
            if (!values) {
                lonely = "there is no DFX beside it: a description without values";
            }
        }
        if (!taken.insert(lower(description)).second) {
            continue;  // the other half of a pair that has been read
        }
        auto file = dfq::read(readFile(description), dates);
        if (!file) {
            refuse(description, file.error());
        }
        if (values) {
            if (const auto added = dfq::readValues(readFile(values->string()), *file, dates); !added) {
                refuse(values->string(), added.error());
            }
        }
        if (lonely) {
            file->oddities.push_back({0, *lonely});
        }
        files.emplace_back(description, std::move(*file));
    }
    return files;
}

void writeDfqFile(const std::string& path, const dfq::File& file) {
    files::writeFile(path, dfq::write(file));
}

}  // namespace kerf::headless
