// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace kerf::headless {

/// Initial, paper, gain and default tuner for each scenario: SAEC, peak, engaged p-p, taps; as a Markdown table.
void printTappingTable();

}  // namespace kerf::headless
