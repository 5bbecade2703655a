// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/preferences.h"

#include <charconv>
#include <optional>

namespace kerf::console {
namespace {

constexpr const char* kLanguage = "ui.language";
constexpr const char* kLength = "ui.length_unit";
constexpr const char* kTemperature = "ui.temperature_unit";
constexpr const char* kTheme = "ui.theme";
constexpr const char* kScale = "ui.scale";
constexpr const char* kOperators = "operators";

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
    return stored;
}

QStringList storedOperators(SettingsReader& settings) {
    const auto text = read(settings, kOperators);
    return text ? QString::fromStdString(*text).split(QLatin1Char('\n'), Qt::SkipEmptyParts) : QStringList{};
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
}

void saveOperators(const QStringList& operators, const SaveSetting& save) {
    save(kOperators, operators.join(QLatin1Char('\n')).toStdString());
}

}  // namespace kerf::console
