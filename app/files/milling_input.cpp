// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/milling_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "app/files/json_document.h"
#include "app/files/output.h"

namespace kerf::headless {
namespace {

struct PlantKey {
    const char* name;
    double* value;
    double low;
    double high;
};

auto keysOf(milling::CutCase& cut) {
    auto& plant = cut.plant;
    auto& range = cut.controller.range;
    return std::array{
        PlantKey{"m", &plant.exponent, 0.3, 1.0},
        PlantKey{"theta_deg", &plant.forceAngle_deg, 5.0, 85.0},
        PlantKey{"kx_n_per_mm", &plant.kx_NPerMm, 10.0, 1e6},
        PlantKey{"ky_n_per_mm", &plant.ky_NPerMm, 10.0, 1e6},
        PlantKey{"c_n_per_mm_1_plus_m", &plant.cuttingCoefficient, 1.0, 1e6},
        PlantKey{"tool_radius_mm", &plant.toolRadius_mm, 0.1, 100.0},
        PlantKey{"spindle_rpm", &cut.spindle_rpm, 60.0, 12000.0},
        PlantKey{"pulse_mm", &cut.pulse_mm, 1e-6, 1.0},
        PlantKey{"feed_max_mm_s", &range.max_mmPerS, 0.01, 1000.0},
        PlantKey{"feed_floor_mm_s", &range.min_mmPerS, 0.0, 1000.0},
        PlantKey{"entry_feed_mm_s", &cut.controller.entryFeed_mmPerS, 0.001, 1000.0},
        PlantKey{"scan_grid_mm", &cut.scan.grid_mm, 0.01, 10.0},
        PlantKey{"scan_spot_mm", &cut.scan.spot_mm, 0.01, 50.0},
        PlantKey{"scan_from_mm", &cut.scan.from_mm, 0.0, 1e5},
        PlantKey{"scan_before_exit_mm", &cut.scan.beforeExit_mm, 0.0, 1e5},
    };
}

}  // namespace

void readMillingPlant(const std::string& path, milling::CutCase& cut) {
    const nlohmann::json document = files::readJsonFile(path, "an object with plant constants");
    if (!document.is_object()) {
        throw BadInput(
            fmt::format("{}: not a JSON object; expected plant constants as kerf milling plant prints them.", path));
    }
    const auto keys = keysOf(cut);
    for (const auto& [name, value] : document.items()) {
        const auto key = std::ranges::find_if(keys, [&](const PlantKey& k) { return name == k.name; });
        if (key == keys.end()) {
            throw BadInput(
                fmt::format("{}: unknown key {}; expected the keys that kerf milling plant prints.", path, name));
        }
        if (!value.is_number() || !(value.get<double>() >= key->low && value.get<double>() <= key->high)) {
            throw BadInput(fmt::format("{}, key {}: {} is not usable; expected a number from {} to {}.", path, name,
                                       value.dump(), key->low, key->high));
        }
        *key->value = value.get<double>();
    }
    cut.controller.toolRadius_mm = cut.plant.toolRadius_mm;
    cut.controller.stiffness.assume.exponent = cut.plant.exponent;
    cut.controller.stiffness.assume.forceAngle_deg = cut.plant.forceAngle_deg;
}

void printMillingPlant(const milling::CutCase& cut) {
    milling::CutCase copy = cut;
    nlohmann::ordered_json json;
    for (const PlantKey& key : keysOf(copy)) {
        json[key.name] = *key.value;
    }
    printJson(json);
}

milling::BlankProfile readBlank(const std::string& path, const ReadOptions& read, std::vector<std::string>* notes) {
    const Table table = Table::read(path, read);
    const auto& x_mm = table.column("x_mm");
    const auto& height_mm = table.column("height_mm");
    if (table.rows() < 2) {
        throw BadInput(
            fmt::format("{}: {} rows; expected at least 2, the last one ends the blank.", path, table.rows()));
    }
    if (notes != nullptr) {
        *notes = table.notes();
    }
    const std::size_t steps = table.rows() - 1;
    return checked(path, milling::BlankProfile::ofSteps(std::span(x_mm).first(steps), std::span(height_mm).first(steps),
                                                        x_mm.back()));
}

}  // namespace kerf::headless
