// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace kerf::headless {

/// Markdown on stdout: mean improvement over open loop in the second half of 2 s, over `seeds` seeds.
void printTurningTable(int seeds);

}  // namespace kerf::headless
