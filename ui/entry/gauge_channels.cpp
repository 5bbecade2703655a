// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/entry/gauge_channels.h"

#include <QStringList>
#include <algorithm>

namespace kerf::ui {
namespace {
constexpr int kMostChannels = 99;
constexpr int kMostDepths = 16;
}  // namespace

GaugeChannels GaugeChannels::fromText(const QString& text) {
    GaugeChannels out;
    for (const QString& one : text.split(u',', Qt::SkipEmptyParts)) {
        const QStringList parts = one.split(u'=');
        bool channelOk = false;
        bool depthOk = false;
        const int channel = parts.value(0).toInt(&channelOk);
        const int depth = parts.value(1).toInt(&depthOk);
        if (channelOk && depthOk && channel >= 0 && channel <= kMostChannels && depth >= 0 && depth < kMostDepths) {
            out.m_depths[channel] = static_cast<std::uint8_t>(depth);
        }
    }
    return out;
}

QString GaugeChannels::text() const {
    QStringList parts;
    for (const auto& [channel, depth] : m_depths) {
        parts << QStringLiteral("%1=%2").arg(channel).arg(depth);
    }
    return parts.join(u',');
}

std::optional<std::uint8_t> GaugeChannels::depthOf(int channel) const {
    const auto found = m_depths.find(channel);
    return found == m_depths.end() ? std::nullopt : std::optional(found->second);
}

std::optional<std::uint8_t> GaugeChannels::learn(int channel, std::size_t depths) {
    const auto free = [this](std::size_t depth) {
        return std::ranges::none_of(m_depths, [depth](const auto& one) { return one.second == depth; });
    };
    std::size_t depth = channel >= 1 ? static_cast<std::size_t>(channel) - 1U : depths;
    if (depth >= depths || !free(depth)) {
        for (depth = 0; depth < depths && !free(depth);) {
            ++depth;
        }
    }
    if (depth >= depths) {
        return std::nullopt;
    }
    m_depths[channel] = static_cast<std::uint8_t>(depth);
    return static_cast<std::uint8_t>(depth);
}

void GaugeChannels::set(int channel, std::uint8_t depth) {
    const auto before = depthOf(channel);
    for (auto& [other, its] : m_depths) {
        if (other != channel && its == depth && before) {
            its = *before;
        }
    }
    m_depths[channel] = depth;
}

}  // namespace kerf::ui
