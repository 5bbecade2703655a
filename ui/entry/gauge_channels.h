// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstdint>
#include <map>
#include <optional>

namespace kerf::ui {

/// Which channel of a gauge multiplexer measures at which depth: learnt from the first frame of a channel, kept, and
/// changed by a person when it was guessed wrong.
class GaugeChannels {
 public:
    /// "1=0,2=1": channel and depth; anything else in it is left out.
    static GaugeChannels fromText(const QString& text);
    [[nodiscard]] QString text() const;

    [[nodiscard]] const std::map<int, std::uint8_t>& all() const noexcept { return m_depths; }
    [[nodiscard]] std::optional<std::uint8_t> depthOf(int channel) const;
    /// The depth of a channel that is new: the one of its number if that is free, else the first free one; empty when
    /// every depth has its channel.
    std::optional<std::uint8_t> learn(int channel, std::size_t depths);
    /// The channel that had this depth takes the other's.
    void set(int channel, std::uint8_t depth);
    void forget() { m_depths.clear(); }

 private:
    std::map<int, std::uint8_t> m_depths{};
};

}  // namespace kerf::ui
