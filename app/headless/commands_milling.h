// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace CLI {
class App;
}

namespace kerf::headless {

void addMillingRobust(CLI::App& milling);
void addMillingNoise(CLI::App& milling);

}  // namespace kerf::headless
