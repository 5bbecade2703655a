// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <readerwriterqueue/readerwriterqueue.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace kerf {

/// Bounded ring for one producer and one consumer thread; allocates only when made.
///
/// A full ring refuses and counts: what that means is the caller's rule (charts drop, commands are refused, part
/// records latch an alarm). The ring itself is moodycamel's ReaderWriterQueue.
template <class T>
class SpscRing {
    static_assert(std::is_trivially_copyable_v<T>, "the cycle copies T; it must not allocate");

 public:
    explicit SpscRing(std::size_t capacity) : m_queue(capacity) {}

    /// Producer. False, and counted, when full.
    [[nodiscard]] bool tryPush(const T& value) noexcept {
        if (m_queue.try_enqueue(value)) {
            return true;
        }
        m_refused.fetch_add(1, std::memory_order_relaxed);
        return false;
    }
    /// Consumer. False when empty.
    [[nodiscard]] bool tryPop(T& value) noexcept { return m_queue.try_dequeue(value); }
    /// How many pushes were refused since the ring was made.
    [[nodiscard]] std::uint64_t refused() const noexcept { return m_refused.load(std::memory_order_relaxed); }
    [[nodiscard]] std::size_t approximateSize() const noexcept { return m_queue.size_approx(); }

 private:
    moodycamel::ReaderWriterQueue<T> m_queue;
    std::atomic<std::uint64_t> m_refused{0};
};

}  // namespace kerf
