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
