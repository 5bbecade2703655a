// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fstream>
#include <string>
#include <vector>

#include "app/sensors/sensor_file.h"
#include "engine/machine/sensors/sensor_memory.h"

namespace kerf::sensors {

/// Writes what comes in to a day file: t_min, rpm where a channel brings it, a column per temperature; a reading that
/// is not good is an empty field. `kerf thermal train` and predict take it, and `--machine replay` plays it. The first
/// five rows are the baseline (t_min < 0). Every row is handed to the system at once.
class DayRecorder {
 public:
    static constexpr int kBaselineRows = 5;

    /// `file` outlives the recorder.
    DayRecorder(const std::string& path, const SensorFile& file, double period_s = 60.0);
    /// False: the file cannot be written (any more).
    [[nodiscard]] bool good() const { return m_out.good(); }
    /// A row when one is due. `time_s` since the start, rising; `frame` null: nothing has come in.
    void look(double time_s, const SensorFrame* frame);
    [[nodiscard]] int rows() const noexcept { return m_rows; }

 private:
    std::ofstream m_out;
    std::vector<std::size_t> m_temperatures;
    std::vector<std::size_t> m_speed;
    double m_period_s;
    int m_rows{0};
};

}  // namespace kerf::sensors
