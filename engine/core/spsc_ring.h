// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace kerf {

/// Bounded ring for one producer and one consumer thread; allocates only when made.
///
/// A full ring refuses and counts: what that means is the caller's rule (charts drop, commands are refused, part
/// records wait). Two indices that only rise, published with release and read with acquire, so that the thread
/// sanitizer can follow the hand-over; each side keeps a copy of the other's index and looks again only when it must.
template <class T>
class SpscRing {
    static_assert(std::is_trivially_copyable_v<T>, "the cycle copies T; it must not allocate");

 public:
    /// Holds at least `capacity` values (rounded up to a power of two).
    explicit SpscRing(std::size_t capacity) : m_slots(std::bit_ceil(capacity)), m_mask(m_slots.size() - 1) {}

    /// Producer. False, and counted, when full.
    [[nodiscard]] bool tryPush(const T& value) noexcept {
        const std::size_t write = m_write.load(std::memory_order_relaxed);
        if (write - m_readSeen == m_slots.size()) {
            m_readSeen = m_read.load(std::memory_order_acquire);
            if (write - m_readSeen == m_slots.size()) {
                m_refused.fetch_add(1, std::memory_order_relaxed);
                return false;
            }
        }
        m_slots[write & m_mask] = value;
        m_write.store(write + 1, std::memory_order_release);
        return true;
    }
    /// Consumer. False when empty.
    [[nodiscard]] bool tryPop(T& value) noexcept {
        const std::size_t read = m_read.load(std::memory_order_relaxed);
        if (read == m_writeSeen) {
            m_writeSeen = m_write.load(std::memory_order_acquire);
            if (read == m_writeSeen) {
                return false;
            }
        }
        value = m_slots[read & m_mask];
        m_read.store(read + 1, std::memory_order_release);
        return true;
    }
    /// How many pushes were refused since the ring was made. Any thread.
    [[nodiscard]] std::uint64_t refused() const noexcept { return m_refused.load(std::memory_order_relaxed); }
    /// Any thread; may be old when it arrives.
    [[nodiscard]] std::size_t approximateSize() const noexcept {
        const std::size_t read = m_read.load(std::memory_order_acquire);
        return m_write.load(std::memory_order_acquire) - read;
    }
    [[nodiscard]] std::size_t capacity() const noexcept { return m_slots.size(); }

 private:
    static constexpr std::size_t kCacheLine = 64;

    std::vector<T> m_slots;
    std::size_t m_mask;
    alignas(kCacheLine) std::atomic<std::size_t> m_write{0};
    std::size_t m_readSeen{0};  // producer's copy
    std::atomic<std::uint64_t> m_refused{0};
    alignas(kCacheLine) std::atomic<std::size_t> m_read{0};
    std::size_t m_writeSeen{0};  // consumer's copy
};

}  // namespace kerf
