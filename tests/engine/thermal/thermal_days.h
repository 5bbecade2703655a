// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/files/thermal_files.h"
#include "engine/process/thermal/history.h"
#include "engine/process/thermal/training.h"
#include "tests/support/golden.h"

namespace kerf::test {

/// The recorded days under tests/fixtures/thermal, each read once per test program.
inline const thermal::ThermalHistory& thermalDay(const std::string& name) {
    static std::map<std::string, thermal::ThermalHistory> days;
    const auto found = days.find(name);
    if (found != days.end()) {
        return found->second;
    }
    return days
        .emplace(name,
                 headless::readThermalHistory(fixture("thermal/" + name + ".csv"), headless::HistoryUse::Prediction))
        .first->second;
}

inline std::vector<thermal::ThermalHistory> trainingDays() {
    return {thermalDay("H0_train"), thermalDay("H1_train"), thermalDay("H2_train")};
}

/// Unseen days that begin cold.
inline const std::vector<std::string>& coldDays() {
    static const std::vector<std::string> names{"T0_same",  "T1_rand",   "T2_consthigh", "T3_constlow",
                                                "T4_stair", "T5_interm", "T6_ambient"};
    return names;
}
inline const char* const kWarmDay = "T7_warmstart";

/// The default model, trained once per test program.
inline const thermal::ThermalModel& defaultModel() {
    static const thermal::ThermalModel model = *thermal::trainHierarchical(trainingDays(), {});
    return model;
}

}  // namespace kerf::test
