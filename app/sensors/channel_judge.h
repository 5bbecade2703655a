// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "app/sensors/sensor_file.h"
#include "engine/machine/sensors/sensor_memory.h"

/// From the registers of a channel to a value that can be believed, or the cause why not. No Qt, no clock.
namespace kerf::sensors {

/// What a temperature or a speed can be at all; docs/sensors.md. Finer judgement is the loop's (sensor health).
inline constexpr double kLowestTemp_degC = -273.15;
inline constexpr double kHighestTemp_degC = 1820.0;  ///< of the hottest thermocouple, type B
inline constexpr double kHighestSpeed_rpm = 200'000.0;
inline constexpr double kLargestJump_K = 60.0;  ///< between two readings, more than any iron does
inline constexpr int kAgreeing = 3;             ///< readings that must agree after a jump
inline constexpr int kAfterNonsense = 5;        ///< and after registers that held no number at all
inline constexpr double kSmallestFloat = 1e-3;  ///< float32 other than 0 below this: swapped words

/// The register's own value (before scale and offset) and the cause why it is none.
struct RawValue {
    double raw{0.0};
    Cause cause{Cause::None};
};
/// @pre registers.size() == registersOf(channel.type)
[[nodiscard]] RawValue rawValue(const Channel& channel, std::span<const std::uint16_t> registers) noexcept;

/// Follows one channel: takes each answer, keeps the last good value.
class ChannelJudge {
 public:
    explicit ChannelJudge(const Channel& channel) : m_channel(&channel) {}

    /// `status`: its status register; empty when it has none.
    void take(std::span<const std::uint16_t> registers, std::optional<std::uint16_t> status,
              std::int64_t now_ns) noexcept;
    /// A value that needs no registers (HAL).
    void takeValue(double raw, std::int64_t now_ns) noexcept;
    /// An answer that is none: the last value is not believed any more.
    void refuse(Cause cause, std::int64_t now_ns) noexcept;
    /// Without an answer for `stale_ns` what was good becomes stale.
    void age(std::int64_t now_ns, std::int64_t stale_ns) noexcept;

    [[nodiscard]] const ChannelValue& value() const noexcept { return m_value; }

 private:
    [[nodiscard]] bool jumps(double value) noexcept;

    const Channel* m_channel;
    ChannelValue m_value{};
    double m_last{0.0};  ///< last number that was one, believed or not
    bool m_lastKnown{false};
    int m_doubts{0};                ///< agreeing readings that are still missing; 0: nothing is doubted
    std::int64_t m_answered_ns{0};  ///< when there was an answer of any kind; 0: nobody has looked yet
};

}  // namespace kerf::sensors
