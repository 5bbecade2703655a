// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/tapping/thread_table.h"

#include <array>

namespace kerf::tapping {

std::span<const ThreadPreset> threadPresets() {
    static constexpr std::array threads{
        ThreadPreset{"M3", 3.0, 0.5, true, 80.0, 100.0},
        ThreadPreset{"M4", 4.0, 0.7, true, 95.0, 118.0},
        ThreadPreset{"M5", 5.0, 0.8, true, 100.0, 125.0},
        ThreadPreset{"M6", 6.0, 1.0, true, 118.0, 150.0},
        ThreadPreset{"M8", 8.0, 1.25, true, 125.0, 160.0},
        ThreadPreset{"M10", 10.0, 1.5, true, 140.0, 180.0},
        ThreadPreset{"M12", 12.0, 1.75, true, 160.0, 200.0},
        ThreadPreset{"M14", 14.0, 2.0, true, 170.0, 212.0},
        ThreadPreset{"M16", 16.0, 2.0, true, 170.0, 212.0},
        ThreadPreset{"M18", 18.0, 2.5, true, 180.0, 224.0},
        ThreadPreset{"M20", 20.0, 2.5, true, 180.0, 224.0},
        ThreadPreset{"M3x0.35", 3.0, 0.35, false, 71.0, 90.0},
        ThreadPreset{"M4x0.5", 4.0, 0.5, false, 80.0, 100.0},
        ThreadPreset{"M5x0.5", 5.0, 0.5, false, 80.0, 100.0},
        ThreadPreset{"M6x0.75", 6.0, 0.75, false, 106.0, 132.0},
        ThreadPreset{"M8x0.75", 8.0, 0.75, false, 106.0, 132.0},
        ThreadPreset{"M8x1", 8.0, 1.0, false, 118.0, 150.0},
        ThreadPreset{"M10x1", 10.0, 1.0, false, 118.0, 150.0},
        ThreadPreset{"M10x1.25", 10.0, 1.25, false, 125.0, 160.0},
        ThreadPreset{"M12x1.25", 12.0, 1.25, false, 140.0, 180.0},
        ThreadPreset{"M12x1.5", 12.0, 1.5, false, 150.0, 190.0},
        ThreadPreset{"M14x1.5", 14.0, 1.5, false, 150.0, 190.0},
        ThreadPreset{"M16x1.5", 16.0, 1.5, false, 150.0, 190.0},
        ThreadPreset{"M18x1.5", 18.0, 1.5, false, 150.0, 190.0},
        ThreadPreset{"M18x2", 18.0, 2.0, false, 170.0, 212.0},
        ThreadPreset{"M20x1.5", 20.0, 1.5, false, 150.0, 190.0},
        ThreadPreset{"M20x2", 20.0, 2.0, false, 170.0, 212.0},
        ThreadPreset{"#4-40", 2.8448, 25.4 / 40.0, true, 50.8, 82.8},
        ThreadPreset{"#6-32", 3.5052, 25.4 / 32.0, true, 50.8, 93.1},
        ThreadPreset{"#8-32", 4.1656, 25.4 / 32.0, true, 50.8, 96.3},
        ThreadPreset{"#10-24", 4.826, 25.4 / 24.0, true, 76.2, 109.6},
        ThreadPreset{"1/4-20", 6.35, 25.4 / 20.0, true, 76.2, 123.2},
        ThreadPreset{"5/16-18", 7.9375, 25.4 / 18.0, true, 76.2, 133.4},
        ThreadPreset{"3/8-16", 9.525, 25.4 / 16.0, true, 76.2, 144.1},
        ThreadPreset{"7/16-14", 11.1125, 25.4 / 14.0, true, 76.2, 155.6},
        ThreadPreset{"1/2-13", 12.7, 25.4 / 13.0, true, 76.2, 163.9},
        ThreadPreset{"9/16-12", 14.2875, 25.4 / 12.0, true, 127.0, 172.5},
        ThreadPreset{"5/8-11", 15.875, 25.4 / 11.0, true, 127.0, 181.6},
        ThreadPreset{"3/4-10", 19.05, 25.4 / 10.0, true, 127.0, 194.6},
        ThreadPreset{"#4-48", 2.8448, 25.4 / 48.0, false, 50.8, 78.0},
        ThreadPreset{"#6-40", 3.5052, 25.4 / 40.0, false, 50.8, 86.3},
        ThreadPreset{"#8-36", 4.1656, 25.4 / 36.0, false, 50.8, 92.6},
        ThreadPreset{"#10-32", 4.826, 25.4 / 32.0, false, 76.2, 99.2},
        ThreadPreset{"1/4-28", 6.35, 25.4 / 28.0, false, 76.2, 109.7},
        ThreadPreset{"5/16-24", 7.9375, 25.4 / 24.0, false, 76.2, 120.8},
        ThreadPreset{"3/8-24", 9.525, 25.4 / 24.0, false, 76.2, 125.6},
        ThreadPreset{"7/16-20", 11.1125, 25.4 / 20.0, false, 76.2, 137.6},
        ThreadPreset{"1/2-20", 12.7, 25.4 / 20.0, false, 76.2, 141.6},
        ThreadPreset{"9/16-18", 14.2875, 25.4 / 18.0, false, 127.0, 150.1},
        ThreadPreset{"5/8-18", 15.875, 25.4 / 18.0, false, 127.0, 153.6},
        ThreadPreset{"3/4-16", 19.05, 25.4 / 16.0, false, 127.0, 165.9},
    };
    return threads;
}

const ThreadPreset* findThread(std::string_view name) {
    for (const ThreadPreset& thread : threadPresets()) {
        if (name == thread.name) return &thread;
    }
    return nullptr;
}

}  // namespace kerf::tapping
