// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace CLI {
class App;
}

namespace kerf::headless {

/// `kerf tapping robust`: hard machines, tuned against as programmed.
void addTappingRobust(CLI::App& tapping);

}  // namespace kerf::headless
