// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace kerf {

/// Values of one writer for any number of readers, newest overwriting oldest; nobody waits for anybody. Lives in shared
/// memory too.
template <class T, std::uint64_t Size>
class Broadcast {
 public:
    void push(const T& value) noexcept {
        const std::uint64_t at = m_written.load(std::memory_order_relaxed);
        m_values[at % Size] = value;
        m_written.store(at + 1, std::memory_order_release);
    }
    [[nodiscard]] std::uint64_t written() const noexcept { return m_written.load(std::memory_order_acquire); }
    /// The newest value; false when there is none, or the writer ran round the ring meanwhile.
    [[nodiscard]] bool latest(T& value) const noexcept {
        const std::uint64_t end = written();
        if (end == 0) {
            return false;
        }
        value = m_values[(end - 1) % Size];
        return written() - end < Size - 1;
    }
    /// The value at `next`, which is then raised; false when there is nothing new. Values overwritten unread are
    /// skipped.
    [[nodiscard]] bool read(std::uint64_t& next, T& value) const noexcept {
        const std::uint64_t end = written();
        if (next > end || end - next > Size / 2) {
            next = end > Size / 2 ? end - Size / 2 : 0;
        }
        if (next == end) {
            return false;
        }
        value = m_values[next % Size];
        ++next;
        return true;
    }

 private:
    std::atomic<std::uint64_t> m_written{0};
    std::array<T, Size> m_values{};
};

}  // namespace kerf
