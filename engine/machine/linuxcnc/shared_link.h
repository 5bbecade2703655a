// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <thread>

#include "engine/machine/linuxcnc/link_memory.h"

namespace kerf::linuxcnc {

/// The memory shared with the bridge, whenever there is one: looked for on a thread of its own, found again by itself
/// after LinuxCNC has been restarted (every bridge makes a new memory).
class SharedLink {
 public:
    /// Has looked once when it returns: a bridge that is there is found.
    SharedLink();
    SharedLink(const SharedLink&) = delete;
    SharedLink& operator=(const SharedLink&) = delete;
    ~SharedLink();

    /// Cycle: the newest memory found, null before the first. Stays mapped until the next call has returned another.
    [[nodiscard]] LinkMemory* take() noexcept {
        LinkMemory* memory = m_found.load();
        m_inUse.store(memory);
        while (memory != m_found.load()) {  // replaced between the two: the old one may be gone
            memory = m_found.load();
            m_inUse.store(memory);
        }
        return memory;
    }

 private:
    void run();
    void look();

    std::atomic<LinkMemory*> m_found{nullptr};
    std::atomic<LinkMemory*> m_inUse{nullptr};
    LinkMemory* m_retired{nullptr};  ///< replaced, unmapped once the cycle has let go of it
    std::uint64_t m_inode{0};
    std::atomic<bool> m_stop{false};
    std::thread m_thread;
};

}  // namespace kerf::linuxcnc
