// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace kerf::sensors {

/// Finds the thermocouple that somebody warms with a finger: the one that has risen kRise_K since the look began and at
/// least kAhead_K more than any other.
class FingerFinder {
 public:
    static constexpr double kRise_K = 1.0;
    static constexpr double kAhead_K = 0.7;

    void begin() { m_first_degC.clear(); }
    struct Found {
        std::size_t channel{0};
        double rise_K{0.0};
    };
    /// One reading per channel, empty where none is good. A channel that was not there at first joins later.
    std::optional<Found> look(const std::vector<std::optional<double>>& temps_degC) {
        m_first_degC.resize(temps_degC.size());
        std::optional<Found> best;
        double second_K = 0.0;
        for (std::size_t i = 0; i < temps_degC.size(); ++i) {
            if (!temps_degC[i]) {
                continue;
            }
            if (!m_first_degC[i]) {
                m_first_degC[i] = temps_degC[i];
            }
            const double rise_K = *temps_degC[i] - *m_first_degC[i];
            if (!best || rise_K > best->rise_K) {
                second_K = best ? best->rise_K : second_K;
                best = Found{i, rise_K};
            } else if (rise_K > second_K) {
                second_K = rise_K;
            }
        }
        const bool clear = best && best->rise_K >= kRise_K && best->rise_K - second_K >= kAhead_K;
        return clear ? best : std::nullopt;
    }

 private:
    std::vector<std::optional<double>> m_first_degC{};
};

}  // namespace kerf::sensors
