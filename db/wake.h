// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <semaphore.h>

#include <cerrno>
#include <ctime>

namespace kerf::db {

/// One thread sleeps, another wakes it without ever waiting itself. A POSIX semaphore, so that a wake-up is never lost.
class Wake {
 public:
    Wake() { sem_init(&m_semaphore, 0, 0); }
    Wake(const Wake&) = delete;
    Wake& operator=(const Wake&) = delete;
    ~Wake() { sem_destroy(&m_semaphore); }

    void wake() noexcept { sem_post(&m_semaphore); }
    /// Until woken, or at most this long.
    void sleep(int atMost_ms) noexcept {
        timespec until{};
        clock_gettime(CLOCK_MONOTONIC, &until);
        const long nanoseconds = until.tv_nsec + static_cast<long>(atMost_ms % 1000) * 1'000'000L;
        until.tv_sec += atMost_ms / 1000 + nanoseconds / 1'000'000'000L;
        until.tv_nsec = nanoseconds % 1'000'000'000L;
        while (sem_clockwait(&m_semaphore, CLOCK_MONOTONIC, &until) != 0 && errno == EINTR) {
        }
    }

 private:
    sem_t m_semaphore{};
};

}  // namespace kerf::db
