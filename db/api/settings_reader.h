// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "db/api/rows.h"
#include "engine/core/result.h"

namespace kerf {

/// Settings as stored: text; numbers with '.' and 17 digits, in the unit their key ends in. Use it on one thread.
class SettingsReader {
 public:
    SettingsReader() = default;
    SettingsReader(const SettingsReader&) = delete;
    SettingsReader& operator=(const SettingsReader&) = delete;
    virtual ~SettingsReader() = default;

    [[nodiscard]] virtual Result<std::optional<std::string>> setting(const std::string& key) = 0;
    [[nodiscard]] virtual Result<std::vector<SettingRow>> settings() = 0;
};

}  // namespace kerf
