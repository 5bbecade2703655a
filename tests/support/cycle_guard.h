// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace kerf::test {

/// Counts what the cycle must not do, on the calling thread, while it lives: allocate or free, lock a mutex, throw.
///
/// Allocation means every way of the C library, aligned ones too. Pages that are touched for the first time are counted
/// beside: a cycle that meets one waits for the kernel.
///
/// Works by interposing malloc and its kin, pthread_mutex_lock and __cxa_throw in the test program (cycle_guard.cpp);
/// under a sanitizer, which interposes them itself, it counts nothing and available() says so.
class CycleGuard {
 public:
    CycleGuard() noexcept;
    ~CycleGuard();
    CycleGuard(const CycleGuard&) = delete;
    CycleGuard& operator=(const CycleGuard&) = delete;

    [[nodiscard]] static bool available() noexcept;
    [[nodiscard]] std::uint64_t allocations() const noexcept;
    [[nodiscard]] std::uint64_t locks() const noexcept;
    [[nodiscard]] std::uint64_t throws() const noexcept;
    [[nodiscard]] std::uint64_t pageFaults() const noexcept;
};

}  // namespace kerf::test
