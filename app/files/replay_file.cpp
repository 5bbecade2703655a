// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/replay_file.h"

#include <fmt/format.h>

#include <cmath>

#include "app/files/thermal_files.h"

namespace kerf::headless {

RecordedDay readRecordedDay(const std::string& path) {
    const thermal::ThermalHistory day = readThermalHistory(path, HistoryUse::Prediction);
    if (day.sensors.size() > kMaxTemperatures) {
        throw BadInput(fmt::format("{}, line 1: {} temperature columns; expected {} at the most.", path,
                                   day.sensors.size(), kMaxTemperatures));
    }
    std::vector<ReplayRow> rows(day.time_min.size());
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const auto at = static_cast<Eigen::Index>(k);
        ReplayRow& row = rows[k];
        row.time_min = day.time_min[k];
        if (!day.speed_rpm.empty()) {
            row.speed_rpm = day.speed_rpm[k];
        }
        for (std::size_t s = 0; s < day.sensors.size(); ++s) {
            const auto column = static_cast<Eigen::Index>(s);
            row.temp_degC[s] = static_cast<float>(day.temp_degC(at, column));
            row.present |= std::uint64_t{day.present(at, column) ? 1U : 0U} << s;
        }
        row.measured = day.drift_um.cols() == 3 && day.drift_um.row(at).array().isFinite().all();
        for (std::size_t axis = 0; axis < kAxisCount && row.measured; ++axis) {
            row.drift_um[axis] = day.drift_um(at, static_cast<Eigen::Index>(axis));
        }
    }
    RecordedDay out;
    out.sensors = day.sensors;
    out.machine = std::make_unique<ReplayMachine>(std::move(rows), static_cast<std::uint16_t>(day.sensors.size()));
    return out;
}

}  // namespace kerf::headless
