// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <type_traits>

namespace kerf {

/// The newest value of one writer for one reader; neither ever waits, older values are overwritten.
///
/// Three slots: one being written, one being read, one in between that both exchange in a single atomic operation.
template <class T>
class LatestValue {
    static_assert(std::is_trivially_copyable_v<T>, "the cycle copies T; it must not allocate");

 public:
    /// Writer only, in the cycle: fill the returned slot, then publish().
    [[nodiscard]] T& writeSlot() noexcept { return m_slots[m_write]; }
    void publish() noexcept {
        const std::uint8_t previous =
            m_middle.exchange(static_cast<std::uint8_t>(m_write | kFresh), std::memory_order_acq_rel);
        m_write = previous & kIndex;
    }
    void publish(const T& value) noexcept {
        writeSlot() = value;
        publish();
    }
    /// Reader only: true if something newer than the last call has arrived; value() then shows it.
    [[nodiscard]] bool refresh() noexcept {
        if ((m_middle.load(std::memory_order_relaxed) & kFresh) == 0) {
            return false;
        }
        const std::uint8_t previous = m_middle.exchange(m_read, std::memory_order_acq_rel);
        m_read = previous & kIndex;
        return true;
    }
    /// Reader only: the value last taken by refresh(); value-initialised before the first.
    [[nodiscard]] const T& value() const noexcept { return m_slots[m_read]; }

 private:
    static constexpr std::uint8_t kIndex = 3;
    static constexpr std::uint8_t kFresh = 4;
    std::array<T, 3> m_slots{};
    alignas(64) std::atomic<std::uint8_t> m_middle{1};
    alignas(64) std::uint8_t m_write{0};
    alignas(64) std::uint8_t m_read{2};
};

}  // namespace kerf
