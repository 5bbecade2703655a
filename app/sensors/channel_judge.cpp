// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sensors/channel_judge.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace kerf::sensors {
namespace {

/// An integer at the end of its range is what a converter says when it has no more to say.
bool atTheEnd(RegisterType type, double raw) {
    switch (type) {
        case RegisterType::Int16:
            return raw == 32767.0 || raw == -32768.0;
        case RegisterType::Uint16:
            return raw == 65535.0;
        case RegisterType::Int32:
            return raw == 2147483647.0 || raw == -2147483648.0;
        case RegisterType::Uint32:
            return raw == 4294967295.0;
        case RegisterType::Float32:
            break;
    }
    return false;
}

bool canBe(Quantity quantity, double value) {
    switch (quantity) {
        case Quantity::Temperature:
            return value >= kLowestTemp_degC && value <= kHighestTemp_degC;
        case Quantity::Speed:
            return std::abs(value) <= kHighestSpeed_rpm;
        case Quantity::Force:
            break;
    }
    return true;
}

}  // namespace

RawValue rawValue(const Channel& channel, std::span<const std::uint16_t> registers) noexcept {
    RawValue out;
    const bool highFirst = channel.words == WordOrder::Big;
    const std::uint32_t bits =
        registers.size() < 2
            ? registers[0]
            : (static_cast<std::uint32_t>(registers[highFirst ? 0 : 1]) << 16U) | registers[highFirst ? 1 : 0];
    switch (channel.type) {
        case RegisterType::Int16:
            out.raw = static_cast<std::int16_t>(registers[0]);
            break;
        case RegisterType::Uint16:
            out.raw = registers[0];
            break;
        case RegisterType::Int32:
            out.raw = static_cast<std::int32_t>(bits);
            break;
        case RegisterType::Uint32:
            out.raw = bits;
            break;
        case RegisterType::Float32:
            out.raw = static_cast<double>(std::bit_cast<float>(bits));
            if (!std::isfinite(out.raw) || (out.raw != 0.0 && std::abs(out.raw) < kSmallestFloat)) {
                out.cause = Cause::NoNumber;
            }
            break;
    }
    if (std::ranges::find(channel.invalid, out.raw) != channel.invalid.end() || atTheEnd(channel.type, out.raw)) {
        out.cause = Cause::InvalidCode;
    }
    return out;
}

void ChannelJudge::take(std::span<const std::uint16_t> registers, std::optional<std::uint16_t> status,
                        std::int64_t now_ns) noexcept {
    const RawValue raw = rawValue(*m_channel, registers);
    if (raw.cause != Cause::None) {
        refuse(raw.cause, now_ns);
        return;
    }
    if (status && m_channel->status) {
        const auto& bad = m_channel->status->bad;
        const std::int64_t plain = *status;
        const std::int64_t withSign = static_cast<std::int16_t>(*status);
        if (std::ranges::any_of(bad, [&](std::int64_t value) { return value == plain || value == withSign; })) {
            refuse(Cause::BadStatus, now_ns);
            return;
        }
    }
    takeValue(raw.raw, now_ns);
}

bool ChannelJudge::jumps(double value) noexcept {
    if (m_channel->quantity != Quantity::Temperature) {
        return false;
    }
    const bool far = m_lastKnown && std::abs(value - m_last) > kLargestJump_K;
    m_last = value;
    m_lastKnown = true;
    if (far) {
        m_doubts = std::max(m_doubts, kAgreeing - 1);
        return true;
    }
    m_doubts = std::max(m_doubts - 1, 0);
    return m_doubts > 0;
}

void ChannelJudge::takeValue(double raw, std::int64_t now_ns) noexcept {
    const double value = m_channel->scale * raw + m_channel->offset;
    m_answered_ns = now_ns;
    if (!std::isfinite(value)) {
        refuse(Cause::NoNumber, now_ns);
    } else if (!canBe(m_channel->quantity, value)) {
        refuse(Cause::OutOfRange, now_ns);
    } else if (jumps(value)) {
        m_value.quality = Quality::Bad;
        m_value.cause = Cause::Jump;
    } else {
        m_value = {value, now_ns, Quality::Good, Cause::None, m_value.changes + 1};
    }
}

void ChannelJudge::refuse(Cause cause, std::int64_t now_ns) noexcept {
    m_answered_ns = now_ns;
    m_value.quality = cause == Cause::NotLinked ? Quality::Missing : Quality::Bad;
    m_value.cause = cause;
    if (m_lastKnown && (cause == Cause::NoNumber || cause == Cause::OutOfRange)) {
        m_doubts = kAfterNonsense;
    }
}

void ChannelJudge::age(std::int64_t now_ns, std::int64_t stale_ns) noexcept {
    if (m_answered_ns == 0) {
        m_answered_ns = now_ns;
    }
    if (now_ns - m_answered_ns > stale_ns) {
        m_value.quality = m_value.stamp_ns == 0 ? Quality::Missing : Quality::Stale;
        m_value.cause = Cause::NoAnswer;
    }
}

}  // namespace kerf::sensors
