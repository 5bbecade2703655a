// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/thermal/thermal_places.h"

#include <array>

#include "engine/process/thermal/plant/thermal_plant.h"

namespace kerf {
namespace {

struct Place {
    const char* name;
    double x;
    double y;
};
/// In the order of thermal::PlantNode.
constexpr std::array<Place, thermal::kPlantNodes> kPlaces{{
    {KERF_TEXT("front bearing"), 0.25, 0.53},
    {KERF_TEXT("rear bearing"), 0.25, 0.25},
    {KERF_TEXT("shaft"), 0.25, 0.40},
    {KERF_TEXT("quill"), 0.25, 0.39},
    {KERF_TEXT("spindle motor"), 0.25, 0.09},
    {KERF_TEXT("head, left"), 0.43, 0.27},
    {KERF_TEXT("head, right"), 0.43, 0.43},
    {KERF_TEXT("column, top"), 0.74, 0.14},
    {KERF_TEXT("column, foot"), 0.74, 0.70},
    {KERF_TEXT("column, back"), 0.86, 0.42},
    {KERF_TEXT("column, left"), 0.73, 0.36},
    {KERF_TEXT("column, right"), 0.73, 0.50},
    {KERF_TEXT("bed"), 0.62, 0.93},
    {KERF_TEXT("saddle"), 0.30, 0.82},
    {KERF_TEXT("table"), 0.22, 0.73},
    {KERF_TEXT("Z screw"), 0.585, 0.30},
    {KERF_TEXT("Y screw"), 0.52, 0.86},
    {KERF_TEXT("X screw"), 0.42, 0.775},
}};
constexpr Place kRoom{KERF_TEXT("room"), 0.06, 0.06};
constexpr double kApart_x = 0.045;
constexpr double kApart_y = 0.052;
constexpr int kPerRow = 3;

}  // namespace

std::vector<ThermalSensorView> thermalSensors(std::size_t count, bool builtIn) {
    std::vector<ThermalSensorView> sensors(count);
    std::array<int, thermal::kPlantNodes + 1> taken{};
    for (std::size_t k = 0; k < count; ++k) {
        ThermalSensorView& sensor = sensors[k];
        sensor.name = std::string("T") + static_cast<char>('0' + k / 10) + static_cast<char>('0' + k % 10);
        if (!builtIn) {
            continue;
        }
        const auto node = thermal::ThermalPlant::nodeOf(k);
        const std::size_t index = node ? static_cast<std::size_t>(*node) : thermal::kPlantNodes;
        const Place& place = node ? kPlaces[index] : kRoom;
        const int nth = taken[index]++;
        sensor.place = place.name;
        sensor.x = place.x + kApart_x * (nth % kPerRow - 1);
        sensor.y = place.y + kApart_y * (static_cast<double>(nth / kPerRow) - 0.5);
    }
    return sensors;
}

}  // namespace kerf
