// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/machine/linuxcnc/shared_link.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>

namespace kerf::linuxcnc {
namespace {

constexpr auto kLook = std::chrono::milliseconds(50);

void unmap(LinkMemory* memory) {
    if (memory != nullptr) {
        munmap(memory, sizeof(LinkMemory));
    }
}

bool isWhole(const LinkMemory* memory) {
    return memory->magic.load(std::memory_order_acquire) == LinkMemory::kMagic;
}

}  // namespace

SharedLink::SharedLink() {
    look();
    m_thread = std::thread([this] { run(); });
}

SharedLink::~SharedLink() {
    m_stop = true;
    m_thread.join();
    unmap(m_retired);
    unmap(m_found);
}

void SharedLink::run() {
    while (!m_stop) {
        std::this_thread::sleep_for(kLook);
        look();
    }
}

void SharedLink::look() {
    if (m_retired != nullptr) {
        if (m_inUse.load(std::memory_order_acquire) == m_retired) {
            return;  // the cycle has not looked since
        }
        unmap(m_retired);
        m_retired = nullptr;
    }
    const int file = shm_open(kLinkName, O_RDWR, 0);
    if (file < 0) {
        return;
    }
    struct stat size {};
    if (fstat(file, &size) == 0 && size.st_ino != m_inode && size.st_size >= static_cast<off_t>(sizeof(LinkMemory))) {
        void* block = mmap(nullptr, sizeof(LinkMemory), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
        if (block != MAP_FAILED) {
            auto* memory = static_cast<LinkMemory*>(block);
            if (isWhole(memory)) {
                m_inode = size.st_ino;
                m_retired = m_found.exchange(memory, std::memory_order_acq_rel);
            } else {
                unmap(memory);  // the bridge is not ready yet, or another layout
            }
        }
    }
    close(file);
}

}  // namespace kerf::linuxcnc
