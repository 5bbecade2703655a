// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "engine/machine/linuxcnc/link_memory.h"
#include "engine/machine/memory_link.h"

namespace kerf::linuxcnc {

/// The memory shared with the bridge, whenever there is one.
class SharedLink : public MemoryLink<LinkMemory> {
 public:
    explicit SharedLink(const std::string& name = kLinkName) : MemoryLink<LinkMemory>(name) {}
};

}  // namespace kerf::linuxcnc
