// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/preferences.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

namespace kerf::console {
namespace {

constexpr const char* kLanguage = "ui.language";
constexpr const char* kLength = "ui.length_unit";
constexpr const char* kTemperature = "ui.temperature_unit";
constexpr const char* kTheme = "ui.theme";
constexpr const char* kScale = "ui.scale";
constexpr std::array<const char*, ui::Preferences::kRoles> kWordings{"ui.wording_operator", "ui.wording_setter",
                                                                     "ui.wording_engineer"};
constexpr const char* kAutoSignOff = "session.auto_sign_off_min";
constexpr int kLongestSignOff_min = 24 * 60;

std::string languageKey(ui::Language language) {
    return language == ui::Language::Korean ? "ko" : "en";
}
std::string lengthKey(ui::LengthUnit unit) {
    return unit == ui::LengthUnit::Inch ? "inch" : "mm";
}
std::string temperatureKey(ui::TemperatureUnit unit) {
    return unit == ui::TemperatureUnit::Fahrenheit ? "degF" : "degC";
}
std::string themeKey(ui::Brightness brightness) {
    return brightness == ui::Brightness::Dark ? "dark" : "light";
}

std::string wordingKey(ui::Wording wording) {
    return wording == ui::Wording::Symbols ? "symbols" : "shop";
}

std::optional<std::string> read(SettingsReader& settings, const char* key) {
    const auto found = settings.setting(key);
    return found ? *found : std::nullopt;
}

}  // namespace

ui::Preferences storedPreferences(SettingsReader& settings) {
    ui::Preferences stored;
    stored.language = read(settings, kLanguage) == "ko" ? ui::Language::Korean : ui::Language::English;
    stored.length = read(settings, kLength) == "inch" ? ui::LengthUnit::Inch : ui::LengthUnit::Millimetre;
    stored.temperature =
        read(settings, kTemperature) == "degF" ? ui::TemperatureUnit::Fahrenheit : ui::TemperatureUnit::Celsius;
    stored.brightness = read(settings, kTheme) == "dark" ? ui::Brightness::Dark : ui::Brightness::Light;
    if (const auto text = read(settings, kScale)) {
        double scale = 1.0;
        const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), scale);
        if (error == std::errc{} && scale >= ui::Metrics::kMinScale && scale <= ui::Metrics::kMaxScale) {
            stored.scale = scale;
        }
    }
    for (std::size_t role = 0; role < kWordings.size(); ++role) {
        const auto text = read(settings, kWordings[role]);
        if (text == "symbols" || text == "shop") {
            stored.wordings[role] = text == "symbols" ? ui::Wording::Symbols : ui::Wording::Shop;
        }
    }
    return stored;
}

ui::SignOnSettings storedSignOn(SettingsReader& settings, AccountReader& accounts) {
    ui::SignOnSettings stored;
    const auto rows = accounts.accounts();
    for (const AccountRow& row : rows ? *rows : std::vector<AccountRow>{}) {
        ui::OperatorAccount account;
        account.name = QString::fromStdString(row.name);
        account.role = ui::roleOf(QString::fromStdString(row.roleKey));
        account.pin = QString::fromStdString(row.seal);
        account.wrongTries = row.wrongTries;
        account.lastWrong_ms = row.lastWrongUtc_ms;
        stored.accounts.push_back(account);
    }
    if (const auto text = read(settings, kAutoSignOff)) {
        bool number = false;
        const int minutes = QString::fromStdString(*text).toInt(&number);
        if (number && minutes >= 0 && minutes <= kLongestSignOff_min) {
            stored.autoSignOff_min = minutes;
        }
    }
    return stored;
}

void savePreferences(const ui::Preferences& before, const ui::Preferences& now, const SaveSetting& save) {
    const auto keep = [&save](const char* key, const std::string& old, const std::string& value) {
        if (old != value) {
            save(key, value);
        }
    };
    keep(kLanguage, languageKey(before.language), languageKey(now.language));
    keep(kLength, lengthKey(before.length), lengthKey(now.length));
    keep(kTemperature, temperatureKey(before.temperature), temperatureKey(now.temperature));
    keep(kTheme, themeKey(before.brightness), themeKey(now.brightness));
    keep(kScale, std::to_string(before.scale), std::to_string(now.scale));
    for (std::size_t role = 0; role < kWordings.size(); ++role) {
        keep(kWordings[role], wordingKey(before.wordings[role]), wordingKey(now.wordings[role]));
    }
}

void saveSignOn(const ui::SignOnSettings& before, const ui::SignOnSettings& now, const SaveSetting& save,
                const SaveAccountRow& saveAccount, const RemoveAccountRow& removeAccount) {
    for (const ui::OperatorAccount& account : now.accounts) {
        const auto old = std::ranges::find(before.accounts, account.name, &ui::OperatorAccount::name);
        if (old == before.accounts.end() || old->role != account.role || old->pin != account.pin) {
            saveAccount({account.name.toStdString(), ui::roleKey(account.role), account.pin.toStdString(), {}, {}});
        }
    }
    for (const ui::OperatorAccount& account : before.accounts) {
        if (std::ranges::find(now.accounts, account.name, &ui::OperatorAccount::name) == now.accounts.end()) {
            removeAccount(account.name.toStdString());
        }
    }
    if (before.autoSignOff_min != now.autoSignOff_min) {
        save(kAutoSignOff, std::to_string(now.autoSignOff_min));
    }
}

}  // namespace kerf::console
