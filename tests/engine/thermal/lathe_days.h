// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "engine/core/random.h"
#include "engine/process/thermal/history.h"

namespace kerf::test {

/// Days of an imagined lathe, to judge laws by: six correlated thermocouples on five lumps of heat, a shaft that no
/// thermocouple sees, one displacement that depends on all of them by coefficients drawn anew each day, a wander with
/// memory, and from day 14 on another machine. No machine's figures.
enum class LatheKind : std::uint8_t {
    Mild,       ///< coefficients differ by 20 % from day to day
    Spread,     ///< by 70 %, and on day 5 all have the other sign
    Hidden,     ///< most comes from the shaft, and not linearly
    Coarse,     ///< thermocouples read in steps of .2 K
    WarmStart,  ///< days begin warm, cooling
};
inline constexpr int kLatheDays = 18;
inline constexpr int kLatheChanged = 14;  ///< first day of the changed machine

class Lathe {
 public:
    Lathe(LatheKind kind, std::uint64_t seed) : m_kind(kind), m_random(seed * 977 + static_cast<std::uint64_t>(kind)) {
        for (std::size_t i = 0; i < kLumps; ++i) {
            m_lag_min[i] = std::exp(m_random.uniform(std::log(6.0), std::log(90.0)));
            m_heat_K[i] = m_random.uniform(i == kShaft ? 5.0 : 1.0, i == kShaft ? 14.0 : 8.0);
            m_room[i] = m_random.uniform(0.5, 1.0);
            m_law[i] = m_random.gauss() * (i == kShaft && kind == LatheKind::Hidden ? 3.0 : 1.5);
            m_changed[i] = m_law[i] * m_random.uniform(-0.2, 1.6) + 0.8 * m_random.gauss();
        }
        for (auto& sensor : m_mix) {
            double sum = 0.0;
            for (std::size_t i = 0; i < kShaft; ++i) {
                sensor[i] = std::pow(m_random.uniform(), 3.0);
                sum += sensor[i];
            }
            for (double& share : sensor) {
                share /= sum;
            }
        }
        m_spread = kind == LatheKind::Spread ? 0.7 : kind == LatheKind::Mild ? 0.2 : 0.4;
        m_wander_um = m_random.uniform(0.8, 2.5);
        m_wander_min = m_random.uniform(10.0, 60.0);
        m_changedOffset_um = 4.0 * m_random.gauss();
        const double target_um = m_random.uniform(10.0, 28.0);
        const std::uint64_t daySeed = m_random.nextU64();
        m_random = Random(daySeed);
        double squares = 0.0;
        for (int d = 0; d < kLatheChanged; ++d) {
            squares += day(d).drift_um.col(0).squaredNorm() / kMinutes / kLatheChanged;
        }
        m_scale = target_um / std::sqrt(squares);
        m_random = Random(daySeed);
    }
    [[nodiscard]] std::vector<thermal::ThermalHistory> days() {
        std::vector<thermal::ThermalHistory> out;
        for (int d = 0; d < kLatheDays; ++d) {
            out.push_back(day(d));
        }
        return out;
    }

 private:
    static constexpr std::size_t kLumps = 6;
    static constexpr std::size_t kShaft = 5;
    static constexpr int kMinutes = 200;
    static constexpr int kBaseline = 5;

    thermal::ThermalHistory day(int number) {
        thermal::ThermalHistory h;
        h.label = "day " + std::to_string(number);
        h.axes = {true, false, false};
        for (std::size_t s = 0; s < m_mix.size(); ++s) {
            h.sensors.push_back("T" + std::to_string(s));
        }
        const int rows = kMinutes + kBaseline;
        h.temp_degC.resize(rows, static_cast<Eigen::Index>(m_mix.size()));
        h.present = thermal::PresentMask::Constant(rows, h.temp_degC.cols(), true);
        h.drift_um = Eigen::MatrixXd::Zero(rows, 3);
        const bool changed = number >= kLatheChanged;
        const double common = 1.0 + 0.5 * m_spread * m_random.gauss();
        std::array<double, kLumps> law{};
        for (std::size_t i = 0; i < kLumps; ++i) {
            law[i] = (changed ? m_changed[i] : m_law[i]) * common * (1.0 + m_spread * m_random.gauss());
            law[i] *= m_kind == LatheKind::Spread && number == 5 ? -1.0 : 1.0;
        }
        const double offset_um = (changed ? m_changedOffset_um : 0.0) + 0.8 * m_random.gauss();
        const double room_degC = m_random.uniform(17.0, 26.0);
        const double swing_K = m_random.uniform(-3.0, 3.0);
        const double period_min = m_random.uniform(200.0, 600.0);
        const double load = m_random.uniform(0.3, 1.2);
        std::array<double, kLumps> temp{};
        std::array<double, kLumps> start{};
        for (double& t : temp) {
            t = room_degC + m_random.uniform(0.0, m_kind == LatheKind::WarmStart ? 6.0 : 0.7);
        }
        double speed = 0.0;
        int next = 0;
        double wander_um = 0.0;
        double wanderStart_um = 0.0;
        for (int t = -kBaseline; t < kMinutes; ++t) {
            if (t >= next) {
                speed = m_random.uniform() < 0.2 ? 0.0 : load * m_random.uniform(0.3, 1.2);
                next = t + 10 + static_cast<int>(m_random.uniform(0.0, 50.0));
            }
            const double used = t < 0 ? 0.0 : speed;
            const double swing = swing_K * std::sin(2.0 * std::numbers::pi * t / period_min);
            for (std::size_t i = 0; i < kLumps; ++i) {
                const double heat_K = m_heat_K[i] * used * (m_kind == LatheKind::Hidden ? 1.0 + 0.6 * used : 1.0);
                temp[i] -= std::expm1(-1.0 / m_lag_min[i]) * (room_degC + m_room[i] * swing + heat_K - temp[i]);
            }
            const double keep = std::exp(-1.0 / m_wander_min);
            wander_um = keep * wander_um + m_wander_um * std::sqrt(1.0 - keep * keep) * m_random.gauss();
            if (t == -1) {
                start = temp;
                wanderStart_um = wander_um;
            }
            double drift_um = 0.0;
            for (std::size_t i = 0; i < kLumps && t >= 0; ++i) {
                const double rise_K = temp[i] - start[i];
                const bool bent = m_kind == LatheKind::Hidden && i == kShaft;
                drift_um += m_scale * law[i] * rise_K * (bent ? 1.0 + 0.05 * rise_K : 1.0);
            }
            drift_um += t >= 0 ? wander_um - wanderStart_um - offset_um * std::expm1(-t / 30.0) : 0.0;
            const Eigen::Index row = t + kBaseline;
            h.drift_um(row, 0) = drift_um + 0.3 * m_random.gauss();
            for (std::size_t s = 0; s < m_mix.size(); ++s) {
                double read = 0.06 * m_random.gauss();
                for (std::size_t i = 0; i < kShaft; ++i) {
                    read += m_mix[s][i] * temp[i];
                }
                h.temp_degC(row, static_cast<Eigen::Index>(s)) =
                    m_kind == LatheKind::Coarse ? std::round(read * 5.0) / 5.0 : read;
            }
            h.time_min.push_back(t);
        }
        return h;
    }

    LatheKind m_kind;
    Random m_random;
    std::array<double, kLumps> m_lag_min{};
    std::array<double, kLumps> m_heat_K{};
    std::array<double, kLumps> m_room{};
    std::array<double, kLumps> m_law{};
    std::array<double, kLumps> m_changed{};
    std::array<std::array<double, kLumps>, 6> m_mix{};
    double m_spread{0.4};
    double m_wander_um{1.0};
    double m_wander_min{30.0};
    double m_changedOffset_um{0.0};
    double m_scale{1.0};
};

}  // namespace kerf::test
