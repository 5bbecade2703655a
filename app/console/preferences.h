// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "db/api/account_reader.h"
#include "db/api/settings_reader.h"
#include "db/api/store_writer.h"
#include "ui/shell/operator_session.h"
#include "ui/theme/look.h"

/// What an operator chooses about the face, and who is known: rows of the settings and the accounts.
namespace kerf::console {

/// As stored; the defaults where nothing is.
[[nodiscard]] ui::Preferences storedPreferences(SettingsReader& settings);
[[nodiscard]] ui::SignOnSettings storedSignOn(SettingsReader& settings, AccountReader& accounts);

using SaveSetting = std::function<void(const std::string& key, const std::string& value)>;
/// Calls `save` for whatever differs between the two.
void savePreferences(const ui::Preferences& before, const ui::Preferences& now, const SaveSetting& save);
using SaveAccountRow = std::function<void(SaveAccount account)>;
using RemoveAccountRow = std::function<void(const std::string& name)>;
void saveSignOn(const ui::SignOnSettings& before, const ui::SignOnSettings& now, const SaveSetting& save,
                const SaveAccountRow& saveAccount, const RemoveAccountRow& removeAccount);

}  // namespace kerf::console
