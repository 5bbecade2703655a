// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/process/tapping/trial_machine.h"

namespace kerf::headless {

/// What the tables of taps are made with: noise and scatter of a shop, and how many taps a tuner has.
inline constexpr tapping::TrialScatter kShopFloor{2.0, 4096.0, 1.0, 0.2, 0.1};
inline constexpr int kMaxTaps = 8;

/// Initial, paper, gain and default tuner for each scenario: SAEC, peak, engaged p-p, taps; as a Markdown table.
void printTappingTable();

}  // namespace kerf::headless
