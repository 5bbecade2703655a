// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace kerf::linuxcnc {

struct ToControl;

/// Which feed the bridge gives the control, round by round: the console's while it is heard, and never a faster one
/// when it is not, when the bridge itself has been late, or when it has been started anew beside a running program.
///
/// HAL watches the bridge in turn (kerf.hal): kAliveWidth_ns after its last round `lossScale` counts in the place of
/// `scale`, and the feed is held where `holdIfGone` is set. So lossScale always stands there: the lowest of the scale,
/// of what the console has said for its own loss and of the planned scale of the program; 0 (held) for a program that
/// somebody has scaled and nobody has declared.
///
/// After every loss the epoch rises, and a wish counts only when it follows on what the bridge has shown since: a wish
/// from the time before, however old, would be taken for a new one otherwise. Holds and stops count at any age.
class FeedKeeper {
 public:
    static constexpr std::int64_t kAliveWidth_ns = 50'000'000;  ///< kerf-alive.width
    static constexpr std::int64_t kOwnStall_ns = 5'000'000;     ///< of a late round, what is the console's silence

    /// What stands on the pins. A bridge that is started anew finds there what the one before has left.
    struct Pins {
        double scale{1.0};      ///< kerf.feed-scale, ≥ 0
        double lossScale{1.0};  ///< kerf.loss-scale, 0…1
        bool hold{false};       ///< kerf.feed-hold
        bool holdIfGone{false};
        friend bool operator==(const Pins&, const Pins&) = default;
    };
    struct Round {
        std::int64_t passed_ns{0};  ///< since the round before
        double timeout_s{0.06};     ///< kerf.timeout
        bool running{false};        ///< the control runs a program
        bool holdOnLoss{false};     ///< kerf.hold-on-loss
        bool stopHolds{false};      ///< a stop that holds the feed stands
        bool mayScale{true};        ///< the control counts in units that are ours: 10 µm would become 254
    };

    explicit FeedKeeper(std::uint32_t firstEpoch) noexcept : m_epoch(firstEpoch) {}

    /// One round. @param wish the console's newest one if there is a new one, else null
    [[nodiscard]] Pins next(const Round& round, const ToControl* wish, const Pins& standing) noexcept;

    /// This round's wish counts: what else it says may be done too.
    [[nodiscard]] bool obeyed() const noexcept { return m_obeyed; }
    /// The console has been silent for longer than it may.
    [[nodiscard]] bool lost() const noexcept { return m_lost; }
    [[nodiscard]] std::uint32_t epoch() const noexcept { return m_epoch; }
    /// Of the running program, as a console has declared it; 0: nobody has.
    [[nodiscard]] double plannedScale() const noexcept { return m_planned; }

 private:
    void hear(const ToControl* wish) noexcept;
    [[nodiscard]] Pins told(const Round& round, const Pins& standing) const noexcept;
    [[nodiscard]] Pins leftAlone(const Round& round, const Pins& standing) noexcept;

    std::uint32_t m_epoch;
    std::uint64_t m_beat{0};
    double m_silent_s{1e9};
    bool m_obeyed{false};
    bool m_lost{true};
    bool m_waits{true};  ///< no wish of this epoch has come yet
    bool m_ever{false};  ///< a console has been obeyed, or a program has ended: what stood there before is over
    bool m_ran{false};
    bool m_ended{false};  ///< a program has, since the last wish that counts
    double m_scale{1.0};
    double m_loss{1.0};
    double m_planned{0.0};
    bool m_hold{false};
};

}  // namespace kerf::linuxcnc
