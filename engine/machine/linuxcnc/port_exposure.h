// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace kerf::linuxcnc {

/// An address of this computer, other than its own loop, on which this TCP port takes connections: linuxcncrsh listens
/// everywhere, and whoever reaches it may move the machine. Empty: none. Blocks for some tenths of a second.
[[nodiscard]] std::string openAddress(std::uint16_t port);

}  // namespace kerf::linuxcnc
