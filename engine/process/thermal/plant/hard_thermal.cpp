// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/thermal/plant/hard_thermal.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "engine/core/random.h"
#include "engine/process/thermal/plant/thermal_plant.h"

namespace kerf::thermal {
namespace {

using N = PlantNode;

void multiply(std::array<double, kPlantNodes>& values, std::initializer_list<N> nodes, double factor) {
    for (const N node : nodes) {
        values[static_cast<std::size_t>(node)] *= factor;
    }
}

void addSeason(HardThermal& out, Season season, Random random) {
    switch (season) {
        case Season::None:
            break;
        case Season::Coolant:
            out.coolant_WPerK = random.uniform(20.0, 60.0);
            out.coolant_K = random.uniform(-5.0, 2.0);
            out.coolantHalf_s = 60.0 * random.uniform(10.0, 40.0);
            break;
        case Season::Door:
            multiply(out.toRoom, {N::HeadLeft, N::HeadRight, N::Saddle, N::Table, N::Quill}, random.uniform(2.0, 4.0));
            break;
        case Season::Sun:
            out.sun_W = random.uniform(30.0, 120.0);
            out.sunFrom_s = 60.0 * random.uniform(10.0, 60.0);
            out.sunTo_s = out.sunFrom_s + 3600.0 * random.uniform(1.0, 3.0);
            break;
        case Season::Moved:
            out.room_K = -random.uniform(4.0, 10.0);
            out.swing = 2.0;
            for (const N node :
                 {N::Bed, N::ColumnUpper, N::ColumnLower, N::ColumnBack, N::ColumnLeft, N::ColumnRight}) {
                multiply(out.drift, {node}, random.uniform(0.2, 2.0));
            }
            break;
        case Season::Nonlinear:
            out.thinning *= 3.0;
            out.bend_perK += random.uniform(0.01, 0.03);
            break;
    }
}

}  // namespace

std::optional<Season> seasonOf(std::string_view key) noexcept {
    const auto* const found = std::ranges::find(kSeasonKeys, key);
    if (found == kSeasonKeys.end()) {
        return std::nullopt;
    }
    return static_cast<Season>(found - kSeasonKeys.begin());
}

HardThermal hardThermal(std::uint64_t machineSeed, Season season, std::uint64_t daySeed) noexcept {
    HardThermal out;
    if (machineSeed > 0) {
        Random machine = Random(machineSeed).stream(11);
        for (double& value : out.drift) {
            value *= std::exp(0.4 * machine.gauss());
        }
        for (double& value : out.toRoom) {
            value *= std::exp(0.3 * machine.gauss());
        }
        out.bearing = machine.uniform(0.7, 1.4);
        out.thinning = machine.uniform(1.0, 2.0);
        out.bend_perK = machine.uniform(-0.01, 0.01);
        const double spread = machine.uniform(0.05, 0.35);
        Random day = Random(machineSeed).stream(1000 + daySeed);
        const double common = 1.0 + 0.5 * spread * day.gauss();
        for (double& value : out.drift) {
            value *= common * (1.0 + spread * day.gauss());
        }
    }
    addSeason(out, season, Random(daySeed).stream(12));
    return out;
}

}  // namespace kerf::thermal
