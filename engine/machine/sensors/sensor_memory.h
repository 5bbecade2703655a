// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <type_traits>

#include "engine/core/broadcast.h"
#include "engine/core/reading.h"

/// What the reading process (kerf-sensors) hands over: every channel of the sensor file with value, quality and the
/// time it was measured, ten times a second, and the readings of gauges as they come. POSIX shared memory with one
/// writer; neither side ever waits for the other. Times are those of CLOCK_MONOTONIC.
namespace kerf::sensors {

inline constexpr std::size_t kMaxChannels = 96;
inline constexpr std::int64_t kPublishEvery_ns = 100'000'000;

/// Why a channel has no good value.
enum class Cause : std::uint8_t {
    None,
    NotYetRead,
    NoAnswer,     ///< module or control does not answer
    Refused,      ///< the module has no such register: another map than the file's
    InvalidCode,  ///< the register holds a value that the file calls invalid, or the end of its type
    BadStatus,    ///< its status register says so
    NoNumber,     ///< not a number, or so close to 0 that the words must be swapped
    OutOfRange,   ///< no temperature or speed that there can be
    Jump,         ///< far away from the reading before, until three agree
    NotLinked,    ///< HAL: the pin has no signal
    Fault,        ///< HAL: kerf.temperature-fault-N is set
};

struct ChannelValue {
    double value{0.0};         ///< of the last good reading; of none: 0
    std::int64_t stamp_ns{0};  ///< when that was measured; 0: never
    Quality quality{Quality::Missing};
    Cause cause{Cause::NotYetRead};
    std::uint32_t changes{0};  ///< good readings so far
};

struct SensorFrame {
    std::uint64_t beat{0};
    std::int64_t written_ns{0};
    std::uint32_t count{0};
    std::array<ChannelValue, kMaxChannels> channel{};
};
static_assert(std::is_trivially_copyable_v<SensorFrame>);

/// One reading of a gauge on a serial line.
struct GaugeEvent {
    std::uint32_t gauge{0};  ///< index in the sensor file
    std::int64_t stamp_ns{0};
    double value{0.0};
    bool understood{false};  ///< false: the frame is an error or not a reading
    bool inch{false};
    std::array<char, 8> channel{};
    std::array<char, 40> frame{};  ///< as it came
};
static_assert(std::is_trivially_copyable_v<GaugeEvent>);

struct SensorMemory {
    static constexpr std::uint32_t kMagic = 0x4B525331;  // "KRS1"
    std::atomic<std::uint32_t> magic{0};                 ///< set last by the writer
    std::uint64_t fingerprint{0};                        ///< of the sensor file
    Broadcast<SensorFrame, 8> frames{};
    Broadcast<GaugeEvent, 64> gauges{};
    std::array<std::atomic<bool>, 16> gaugeConnected{};
};

}  // namespace kerf::sensors
