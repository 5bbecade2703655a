// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/process/thermal/day_layer.h"
#include "engine/process/thermal/history.h"
#include "ui/services/thermal_service.h"

/// Bodies of the thermal room's records, JSON with units in the keys. A body that cannot be read gives nothing: it is
/// of another version or was damaged, and the service goes on without it.
namespace kerf::thermal_records {

inline constexpr const char* kModel = "model";
inline constexpr const char* kShifts = "shift";
inline constexpr const char* kGap = "gap";
inline constexpr const char* kSession = "session";
inline constexpr const char* kZero = "gap-zero";
inline constexpr const char* kLearnt = "learnt";
inline constexpr const char* kMemory = "memory";  ///< subject: the day that is left out or taken in again

[[nodiscard]] std::string shiftsToJson(const std::vector<ThermalShiftRow>& rows);
[[nodiscard]] std::vector<ThermalShiftRow> shiftsFromJson(const std::string& text);
[[nodiscard]] std::string gapToJson(const ThermalGapRow& row);
[[nodiscard]] std::optional<ThermalGapRow> gapFromJson(const std::string& text);
[[nodiscard]] std::string zeroToJson(const std::array<double, kAxisCount>& zero_um);
[[nodiscard]] std::optional<std::array<double, kAxisCount>> zeroFromJson(const std::string& text);
[[nodiscard]] std::string setupToJson(const ThermalSetup& setup);
[[nodiscard]] std::optional<ThermalSetup> setupFromJson(const std::string& text);
[[nodiscard]] std::int64_t utcNow_ms();
/// What a model learnt of a day, so that a restart goes on with it.
struct Learnt {
    std::int64_t utc_ms{0};
    std::uint64_t fingerprint{0};  ///< of the model's training days
    thermal::DayMeasurement measurement{};
};
[[nodiscard]] std::string learntToJson(const Learnt& learnt);
[[nodiscard]] std::optional<Learnt> learntFromJson(const std::string& text);
[[nodiscard]] std::string sessionToJson(const thermal::ThermalHistory& day);
[[nodiscard]] std::optional<thermal::ThermalHistory> sessionFromJson(const std::string& text);

}  // namespace kerf::thermal_records
