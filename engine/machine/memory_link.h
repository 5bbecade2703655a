// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace kerf {

/// The memory that another process shares under a name, whenever there is one: looked for on a thread of its own, found
/// again by itself after that process has been restarted (every start makes a new memory).
///
/// `Memory` has `kMagic` and `magic`, which its writer sets last.
template <class Memory>
class MemoryLink {
 public:
    /// Has looked once when it returns: what is there is found.
    explicit MemoryLink(std::string name) : m_name(std::move(name)) {
        look();
        m_thread = std::thread([this] { run(); });
    }
    MemoryLink(const MemoryLink&) = delete;
    MemoryLink& operator=(const MemoryLink&) = delete;
    ~MemoryLink() {
        {
            const std::lock_guard lock(m_mutex);
            m_stop = true;
        }
        m_wake.notify_all();
        m_thread.join();
        unmap(m_retired);
        unmap(m_found);
    }

    /// Cycle, one thread: the newest memory found, null before the first. Stays mapped until the next call has returned
    /// another.
    [[nodiscard]] Memory* take() noexcept {
        Memory* memory = m_found.load();
        m_inUse.store(memory);
        while (memory != m_found.load()) {  // replaced between the two: the old one may be gone
            memory = m_found.load();
            m_inUse.store(memory);
        }
        return memory;
    }

 private:
    static constexpr auto kLook = std::chrono::milliseconds(50);

    void run() {
        std::unique_lock lock(m_mutex);
        while (!m_wake.wait_for(lock, kLook, [this] { return m_stop; })) {
            look();
        }
    }
    static void unmap(Memory* memory) {
        if (memory != nullptr) {
            munmap(memory, sizeof(Memory));
        }
    }
    void look() {
        if (m_retired != nullptr) {
            if (m_inUse.load(std::memory_order_acquire) == m_retired) {
                return;  // the cycle has not looked since
            }
            unmap(m_retired);
            m_retired = nullptr;
        }
        const int file = shm_open(m_name.c_str(), O_RDWR, 0);
        if (file < 0) {
            return;
        }
        struct stat size {};
        if (fstat(file, &size) == 0 && size.st_ino != m_inode && size.st_size >= static_cast<off_t>(sizeof(Memory))) {
            // Touched here, on this thread: the cycle must not meet a page for the first time.
            void* block = mmap(nullptr, sizeof(Memory), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_POPULATE, file, 0);
            if (block != MAP_FAILED) {
                auto* memory = static_cast<Memory*>(block);
                if (memory->magic.load(std::memory_order_acquire) == Memory::kMagic) {
                    m_inode = size.st_ino;
                    m_retired = m_found.exchange(memory, std::memory_order_acq_rel);
                } else {
                    unmap(memory);  // its writer is not ready yet, or another layout
                }
            }
        }
        close(file);
    }

    std::string m_name;
    std::atomic<Memory*> m_found{nullptr};
    std::atomic<Memory*> m_inUse{nullptr};
    Memory* m_retired{nullptr};  ///< replaced, unmapped once the cycle has let go of it
    std::uint64_t m_inode{0};
    bool m_stop{false};
    std::mutex m_mutex;
    std::condition_variable m_wake;
    std::thread m_thread;
};

}  // namespace kerf
