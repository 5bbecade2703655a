// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/tapping_drive_file.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/files/json_document.h"
#include "app/files/table.h"

namespace kerf::headless {
namespace {

using tapping::DriveKey;
using tapping::DriveParams;

/// Why a value cannot be put under a key; empty when it can.
std::optional<std::string> whyRefused(const DriveKey& key, double value) {
    const bool whole = key.member == &DriveParams::substeps || key.member == &DriveParams::slaved;
    if (!std::isfinite(value) || value < key.min || value > key.max || (whole && value != std::round(value))) {
        return fmt::format("{} is out of range for {}; expected {} to {}{}.", value, key.key, key.min, key.max,
                           whole ? ", a whole number" : "");
    }
    return std::nullopt;
}

}  // namespace

DriveParams readDriveFile(const std::string& path) {
    const nlohmann::json document = files::readJsonFile(path, "one object of drive constants");
    if (!document.is_object()) {
        throw BadInput(fmt::format("{}: expected one JSON object of drive constants.", path));
    }
    DriveParams drive;
    for (const auto& [name, value] : document.items()) {
        const DriveKey* key = tapping::findDriveKey(name);
        if (key == nullptr)
            throw BadInput(fmt::format("{}: key {} is unknown; see kerf tapping simulate --help.", path, name));
        if (!value.is_number()) throw BadInput(fmt::format("{}: key {} is no number.", path, name));
        if (const auto why = whyRefused(*key, value.get<double>())) throw BadInput(fmt::format("{}: {}", path, *why));
        drive.*(key->member) = value.get<double>();
    }
    return drive;
}

void applyDriveSettings(DriveParams& drive, const std::string& option, const std::vector<std::string>& settings) {
    for (const std::string& text : settings) {
        const auto equals = text.find('=');
        const DriveKey* key = tapping::findDriveKey(text.substr(0, equals));
        if (equals == std::string::npos || key == nullptr) {
            throw CLI::ValidationError(option, fmt::format("{} is not KEY=VALUE with a known key", text));
        }
        double value = 0.0;
        const char* end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data() + equals + 1, end, value);
        if (error != std::errc{} || stop != end) throw CLI::ValidationError(option, fmt::format("{}: no number", text));
        if (const auto why = whyRefused(*key, value)) throw CLI::ValidationError(option, *why);
        drive.*(key->member) = value;
    }
}

std::string driveKeyHelp() {
    const DriveParams reference;
    std::string text = "KEY (reference, range):\n";
    for (const DriveKey& key : tapping::driveKeys()) {
        text += fmt::format("  {:<10} {:<8g} {:g} … {:g}\n", key.key, reference.*(key.member), key.min, key.max);
    }
    return text;
}

}  // namespace kerf::headless
