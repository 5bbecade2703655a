// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace kerf::linuxcnc {

/// The value of a key in a section of a LinuxCNC ini file, as the control reads it: the first one counts, a remark
/// after
/// '#' or ';' is cut off. Empty: it is not there.
[[nodiscard]] inline std::optional<std::string> iniValue(std::string_view text, std::string_view section,
                                                         std::string_view key) {
    const auto trimmed = [](std::string_view s) {
        while (!s.empty() && std::isspace(static_cast<unsigned char>(s.front())) != 0)
            s.remove_prefix(1);
        while (!s.empty() && std::isspace(static_cast<unsigned char>(s.back())) != 0)
            s.remove_suffix(1);
        return s;
    };
    bool inside = false;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = trimmed(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        if (line.empty() || line.front() == '#' || line.front() == ';') continue;
        if (line.front() == '[') {
            inside = line.substr(1, std::min(line.find(']'), line.size()) - 1) == section;
            continue;
        }
        const std::size_t equals = line.find('=');
        if (inside && equals != std::string_view::npos && trimmed(line.substr(0, equals)) == key) {
            std::string_view value = trimmed(line.substr(equals + 1));
            return std::string(trimmed(value.substr(0, std::min(value.find_first_of("#;"), value.size()))));
        }
    }
    return std::nullopt;
}

/// What one unit of the machine is, from [TRAJ]LINEAR_UNITS.
enum class MachineUnits : unsigned char { Unknown, Millimetre, Inch };
[[nodiscard]] inline MachineUnits unitsOf(std::string_view ini) {
    const auto value = iniValue(ini, "TRAJ", "LINEAR_UNITS");
    if (value == "mm" || value == "metric" || value == "1" || value == "1.0") return MachineUnits::Millimetre;
    return value == "inch" || value == "in" || value == "imperial" ? MachineUnits::Inch : MachineUnits::Unknown;
}

/// Period of the servo thread from [EMCMOT]SERVO_PERIOD (ns); 1 ms where it is not said or no period of a servo thread.
[[nodiscard]] inline double servoPeriodOf_s(std::string_view ini) {
    constexpr double kUsual_s = 0.001;
    const auto value = iniValue(ini, "EMCMOT", "SERVO_PERIOD");
    std::int64_t period_ns = 0;
    if (!value || std::from_chars(value->data(), value->data() + value->size(), period_ns).ec != std::errc{}) {
        return kUsual_s;
    }
    return period_ns >= 20'000 && period_ns <= 20'000'000 ? static_cast<double>(period_ns) * 1e-9 : kUsual_s;
}

}  // namespace kerf::linuxcnc
