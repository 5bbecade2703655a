// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/thermal/plant/thermal_plant.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kerf::thermal {
namespace {

constexpr double kStep_s = 5.0;
constexpr double kGapNoise_um = 0.5;
constexpr double kGreaseThinning_perK = 0.02;
constexpr double kFrontBearing_W = 14.0;  // at 1000 rpm and 20 degC
constexpr double kRearBearing_W = 9.0;
constexpr double kMotor_W = 25.0;
constexpr double kFan_WPerK = 18.0;
constexpr double kSwingPeriod_s = 8.0 * 3600.0;
constexpr double kWanderMemory_s = 3600.0;
constexpr double kWander_K = 0.4;

struct Link {
    PlantNode a;
    PlantNode b;
    double conductance_WPerK;
};
using N = PlantNode;

constexpr std::array<double, kPlantNodes> kCapacity_JPerK{2500,  2000,  20000, 12000, 15000, 40000, 40000, 60000, 60000,
                                                          80000, 50000, 50000, 250e3, 60000, 60000, 8000,  8000,  8000};
constexpr std::array<double, kPlantNodes> kToRoom_WPerK{3,  3,  1,  6,  12, 12, 12,  10,  10,
                                                        15, 10, 10, 40, 10, 15, 1.5, 1.5, 1.5};

constexpr std::array kLinks{
    Link{N::FrontBearing, N::Shaft, 25},
    Link{N::RearBearing, N::Shaft, 20},
    Link{N::FrontBearing, N::Quill, 60},
    Link{N::RearBearing, N::Quill, 50},
    Link{N::Quill, N::HeadLeft, 40},
    Link{N::Quill, N::HeadRight, 40},
    Link{N::Motor, N::HeadLeft, 10},
    Link{N::Motor, N::HeadRight, 10},
    Link{N::Motor, N::Shaft, 2},
    Link{N::HeadLeft, N::HeadRight, 30},
    Link{N::HeadLeft, N::ColumnUpper, 25},
    Link{N::HeadRight, N::ColumnUpper, 25},
    Link{N::ColumnUpper, N::ColumnLower, 30},
    Link{N::ColumnUpper, N::ColumnBack, 20},
    Link{N::ColumnUpper, N::ColumnLeft, 20},
    Link{N::ColumnUpper, N::ColumnRight, 20},
    Link{N::ColumnBack, N::ColumnLeft, 20},
    Link{N::ColumnBack, N::ColumnRight, 20},
    Link{N::ColumnLower, N::Bed, 25},
    Link{N::ColumnBack, N::Bed, 20},
    Link{N::ColumnLeft, N::Bed, 10},
    Link{N::ColumnRight, N::Bed, 10},
    Link{N::Bed, N::Saddle, 15},
    Link{N::Saddle, N::Table, 15},
    Link{N::HeadLeft, N::ScrewZ, 4},
    Link{N::ScrewZ, N::ColumnUpper, 4},
    Link{N::ScrewY, N::Bed, 4},
    Link{N::ScrewY, N::Saddle, 4},
    Link{N::ScrewX, N::Saddle, 4},
    Link{N::ScrewX, N::Table, 4},
};

/// µm per K of each node, per axis.
struct Share {
    PlantNode node;
    double x_umPerK;
    double y_umPerK;
    double z_umPerK;
};
constexpr std::array kShares{
    Share{N::Shaft, 0.0, 0.0, -1.3},       Share{N::Quill, 0.25, -0.9, -0.5},     Share{N::HeadLeft, 1.6, -1.4, -0.3},
    Share{N::HeadRight, -1.0, -1.4, -0.3}, Share{N::ColumnUpper, 0.0, -2.2, 0.9}, Share{N::ColumnLower, 0.0, 0.3, 0.8},
    Share{N::ColumnBack, 0.0, 2.0, 0.2},   Share{N::ColumnLeft, 0.5, 0.2, 0.2},   Share{N::ColumnRight, -0.5, 0.2, 0.2},
    Share{N::Bed, 0.0, 0.3, -0.3},         Share{N::Saddle, 0.0, 0.3, -0.4},      Share{N::Table, 0.2, 0.2, -0.5},
    Share{N::ScrewZ, 0.0, 0.0, -0.3},      Share{N::ScrewY, 0.0, 0.4, 0.0},       Share{N::ScrewX, 0.3, 0.0, 0.0},
};

/// How many of the 64 thermocouples each node carries; the shaft has none. The last three hang in the room.
constexpr std::array<std::uint8_t, kPlantNodes> kCouplesPerNode{5, 4, 0, 5, 5, 7, 7, 4, 3, 4, 3, 3, 3, 2, 2, 2, 1, 1};
constexpr std::size_t kRoom = kPlantNodes;
constexpr std::size_t kRoomCouples = 3;

}  // namespace

ThermalPlant::ThermalPlant(std::uint64_t machineSeed, std::uint64_t daySeed) noexcept
    : ThermalPlant(machineSeed, daySeed, HardThermal{}) {}

ThermalPlant::ThermalPlant(std::uint64_t machineSeed, std::uint64_t daySeed, const HardThermal& hard) noexcept
    : m_hard(hard) {
    Random random(machineSeed);
    std::size_t couple = 0;
    for (std::size_t node = 0; node < kPlantNodes; ++node) {
        for (std::uint8_t k = 0; k < kCouplesPerNode[node]; ++k) {
            m_couples[couple++].node = node;
        }
    }
    for (std::size_t k = 0; k < kRoomCouples; ++k) {
        m_couples[couple++].node = kRoom;
    }
    for (Thermocouple& one : m_couples) {
        one.noise_K = random.uniform(0.05, 0.10);
        one.offset_K = random.uniform(-0.5, 0.5);
        // Neighbours on one casting do not read the same.
        one.contact = random.uniform(0.9, 1.0);
        one.lag_s = random.uniform(5.0, 30.0);
    }
    for (int bad = 0; bad < 2; ++bad) {
        Thermocouple& one = m_couples[static_cast<std::size_t>(random.uniform(0.0, 60.0))];
        one.contact = 0.5;
        one.lag_s = 600.0;
    }
    restart(daySeed);
}

void ThermalPlant::restart(std::uint64_t daySeed) noexcept {
    m_random = Random(daySeed);
    m_time_s = 0.0;
    m_roomMean_degC = m_random.uniform(20.0, 24.0);
    m_roomSwing_K = m_random.uniform(0.5, 2.0);
    m_roomPhase = m_random.uniform(0.0, 2.0 * std::numbers::pi);
    m_roomMean_degC += m_hard.room_K;
    m_roomSwing_K *= m_hard.swing;
    m_wander_K = 0.0;
    moveRoom(0.0);
    m_temp_degC.fill(m_room_degC);
    for (Thermocouple& one : m_couples) {
        one.value_degC = m_room_degC;
    }
    setReference();
}

void ThermalPlant::stepBy(double dt_s) noexcept {
    if (dt_s == m_step_s) {
        return;
    }
    m_step_s = dt_s;
    m_kept = std::exp(-dt_s / kWanderMemory_s);
    m_stirred = std::sqrt(std::max(0.0, 1.0 - m_kept * m_kept));
    for (Thermocouple& one : m_couples) {
        one.share = -std::expm1(-dt_s / one.lag_s);
    }
}

void ThermalPlant::moveRoom(double dt_s) noexcept {
    m_time_s += dt_s;
    stepBy(dt_s);
    m_wander_K = m_kept * m_wander_K + kWander_K * m_stirred * m_random.gauss();
    const double angle = 2.0 * std::numbers::pi * m_time_s / kSwingPeriod_s + m_roomPhase;
    m_room_degC = m_roomMean_degC + m_roomSwing_K * std::sin(angle) + m_wander_K;
}

void ThermalPlant::step(double speed_rpm, double dt_s) noexcept {
    moveRoom(dt_s);
    std::array<double, kPlantNodes> heat_W{};
    for (std::size_t i = 0; i < kPlantNodes; ++i) {
        heat_W[i] = kToRoom_WPerK[i] * m_hard.toRoom[i] * (m_room_degC - m_temp_degC[i]);
    }
    for (const Link& link : kLinks) {
        const auto a = static_cast<std::size_t>(link.a);
        const auto b = static_cast<std::size_t>(link.b);
        const double flow_W = link.conductance_WPerK * (m_temp_degC[b] - m_temp_degC[a]);
        heat_W[a] += flow_W;
        heat_W[b] -= flow_W;
    }
    const double krpm = std::abs(speed_rpm) / 1000.0;
    const double friction = krpm * std::sqrt(krpm);
    const auto bearing = [&](PlantNode node, double watt) {
        const auto i = static_cast<std::size_t>(node);
        heat_W[i] += watt * m_hard.bearing * friction *
                     std::exp(-kGreaseThinning_perK * m_hard.thinning * (m_temp_degC[i] - 20.0));
    };
    bearing(N::FrontBearing, kFrontBearing_W);
    bearing(N::RearBearing, kRearBearing_W);
    heat_W[static_cast<std::size_t>(N::Motor)] += kMotor_W * krpm;
    if (krpm > 0.0) {
        const auto right = static_cast<std::size_t>(N::HeadRight);
        heat_W[right] += kFan_WPerK * (m_room_degC - m_temp_degC[right]);
    }
    addSeason(heat_W);
    for (std::size_t i = 0; i < kPlantNodes; ++i) {
        m_temp_degC[i] += heat_W[i] * dt_s / kCapacity_JPerK[i];
    }
    for (Thermocouple& one : m_couples) {
        const double node_degC = one.node == kRoom ? m_room_degC : m_temp_degC[one.node];
        const double target_degC = one.contact * node_degC + (1.0 - one.contact) * m_room_degC;
        one.value_degC += one.share * (target_degC - one.value_degC);
    }
}

void ThermalPlant::addSeason(std::array<double, kPlantNodes>& heat_W) const noexcept {
    if (m_hard.coolant_WPerK > 0.0 && std::fmod(m_time_s, 2.0 * m_hard.coolantHalf_s) < m_hard.coolantHalf_s) {
        for (const N node : {N::Table, N::Saddle, N::Quill}) {
            const auto i = static_cast<std::size_t>(node);
            heat_W[i] += m_hard.coolant_WPerK * (m_room_degC + m_hard.coolant_K - m_temp_degC[i]);
        }
    }
    if (m_hard.sun_W > 0.0 && m_time_s >= m_hard.sunFrom_s && m_time_s < m_hard.sunTo_s) {
        heat_W[static_cast<std::size_t>(N::ColumnLeft)] += m_hard.sun_W;
        heat_W[static_cast<std::size_t>(N::Bed)] += m_hard.sun_W / 3.0;
    }
}

void ThermalPlant::advance(double speed_rpm, double dt_s) noexcept {
    while (dt_s > 0.0) {
        const double part_s = std::min(dt_s, kStep_s);
        step(speed_rpm, part_s);
        dt_s -= part_s;
    }
}

std::optional<PlantNode> ThermalPlant::nodeOf(std::size_t couple) noexcept {
    for (std::size_t node = 0; node < kPlantNodes; ++node) {
        if (couple < kCouplesPerNode[node]) {
            return static_cast<PlantNode>(node);
        }
        couple -= kCouplesPerNode[node];
    }
    return std::nullopt;
}

ThermalPlant::State ThermalPlant::state() const noexcept {
    State state{m_temp_degC, m_reference_degC, {}, m_time_s, m_wander_K};
    for (std::size_t k = 0; k < kMaxTemperatures; ++k) {
        state.couple_degC[k] = m_couples[k].value_degC;
    }
    return state;
}

void ThermalPlant::resume(const State& state) noexcept {
    m_temp_degC = state.temp_degC;
    m_reference_degC = state.reference_degC;
    for (std::size_t k = 0; k < kMaxTemperatures; ++k) {
        m_couples[k].value_degC = state.couple_degC[k];
    }
    m_time_s = state.time_s;
    m_wander_K = state.wander_K;
    moveRoom(0.0);
}

void ThermalPlant::setReference() noexcept {
    m_reference_degC = m_temp_degC;
}

std::array<double, kAxisCount> ThermalPlant::drift_um() const noexcept {
    std::array<double, kAxisCount> drift{};
    for (const Share& share : kShares) {
        const auto i = static_cast<std::size_t>(share.node);
        const double rise_K = m_temp_degC[i] - m_reference_degC[i];
        const double felt_K = rise_K * m_hard.drift[i] * (1.0 + m_hard.bend_perK * rise_K);
        drift[0] += share.x_umPerK * felt_K;
        drift[1] += share.y_umPerK * felt_K;
        drift[2] += share.z_umPerK * felt_K;
    }
    return drift;
}

std::array<double, kMaxTemperatures> ThermalPlant::readThermocouples() noexcept {
    std::array<double, kMaxTemperatures> out{};
    for (std::size_t k = 0; k < kMaxTemperatures; ++k) {
        out[k] = m_couples[k].value_degC + m_couples[k].offset_K + m_couples[k].noise_K * m_random.gauss();
    }
    return out;
}

std::array<double, kAxisCount> ThermalPlant::measureDrift() noexcept {
    std::array<double, kAxisCount> out = drift_um();
    for (double& value : out) {
        value += kGapNoise_um * m_random.gauss();
    }
    return out;
}

}  // namespace kerf::thermal
