// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace CLI {
class App;
}

namespace kerf::headless {

/// `kerf turning robust`: hard lathes, the default law against both PI laws.
void addTurningRobust(CLI::App& turning);

}  // namespace kerf::headless
