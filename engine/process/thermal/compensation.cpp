// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/thermal/compensation.h"

#include <algorithm>
#include <cmath>

namespace kerf::thermal {

double roundHalfEven(double value) noexcept {
    return value - std::remainder(value, 1.0);
}

ShiftCommand nextShift(double drift_um, double applied_um, const ShiftLimits& limits) noexcept {
    ShiftCommand command;
    if (!std::isfinite(applied_um)) {
        return command;
    }
    command.total_um = applied_um;
    if (!std::isfinite(drift_um)) {
        return command;
    }
    const double quantum_um = limits.quantum_um;
    const double largest = std::floor(limits.maxShift_um / quantum_um);
    const double wanted = roundHalfEven(-drift_um / quantum_um);
    const double target = std::clamp(wanted, -largest, largest);
    command.sizeLimited = target != wanted;

    const double largestStep = std::floor(limits.maxStep_um / quantum_um);
    const double wantedStep = roundHalfEven((target * quantum_um - applied_um) / quantum_um);
    const double step = std::clamp(wantedStep, -largestStep, largestStep);
    command.rateLimited = step != wantedStep;
    command.step_um = step * quantum_um;
    command.total_um = applied_um + command.step_um;
    return command;
}

double holdShare(double outsideSpans) noexcept {
    return std::clamp(1.0 - outsideSpans, 0.0, 1.0);
}

namespace {
constexpr std::uint16_t kAliveBit = 1U << 15U;
constexpr unsigned kAxisShift = 13U;
constexpr std::uint16_t kDataMask = 0x1FFFU;
constexpr std::uint8_t kStartBit = 1U << 4U;
constexpr std::uint8_t kReservedAxis = 3;
}  // namespace

std::optional<std::uint16_t> encodeShiftWord(const ShiftWord& word) noexcept {
    if (word.axis >= kAxes || word.shift_um < kMinWordShift_um || word.shift_um > kMaxWordShift_um) {
        return std::nullopt;
    }
    const unsigned data = static_cast<std::uint16_t>(word.shift_um) & kDataMask;
    return static_cast<std::uint16_t>((word.alive ? kAliveBit : 0U) | (unsigned{word.axis} << kAxisShift) | data);
}

std::optional<ShiftWord> decodeShiftWord(std::uint16_t word) noexcept {
    const auto axis = static_cast<std::uint8_t>((word >> kAxisShift) & 3U);
    if (axis == kReservedAxis) {
        return std::nullopt;
    }
    int shift_um = word & kDataMask;
    if (shift_um > kMaxWordShift_um) {
        shift_um -= kDataMask + 1;
    }
    return ShiftWord{axis, static_cast<std::int16_t>(shift_um), (word & kAliveBit) != 0};
}

std::optional<std::uint8_t> encodeRequestWord(const RequestWord& word) noexcept {
    if (word.axis >= kAxes) {
        return std::nullopt;
    }
    return static_cast<std::uint8_t>((word.start ? kStartBit : 0U) | word.axis);
}

std::optional<RequestWord> decodeRequestWord(std::uint8_t word) noexcept {
    const auto axis = static_cast<std::uint8_t>(word & 3U);
    if (axis == kReservedAxis) {
        return std::nullopt;
    }
    return RequestWord{axis, (word & kStartBit) != 0};
}

}  // namespace kerf::thermal
