// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "engine/port/machine_port.h"

namespace kerf::milling {

/// Judges the raw force sample by sample, so that a reaction comes within one revolution and not after it.
///
///   blind      no trusted, changing sample for half a revolution (by angle or, if samples stay away, by time)
///   collapsed  the highest sample of two teeth running is below 30 % of a tooth just before them that was well in the
///              work and as high as a revolution earlier: what a breaking tool does. Between them may lie the tooth
///              that broke on its way through the work. Steps of the blank and the way out of it take longer than a
///              revolution, so there the tooth before has fallen already
///   chipped    over nearly one tooth's pitch, wherever in the revolution it begins, the highest sample is below half
///   of
///              what it was at the same angles a revolution earlier, while the pitch before and the one after it are as
///              they were: one edge of several is gone. Steps and the way out fall and stay down, so they are none
///
/// A force that falls with the feed has neither collapsed nor chipped: a tooth is expected in proportion to the feed
/// really made, the lowest of its own and the highest of those it is compared with: the one before, or, for a chip, the
/// pitches on either side. A feed that is not known is taken for an even one.
///
/// All functions run in the cycle: no allocation, lock, throw or I/O.
class ForceWatch {
 public:
    struct Params {
        int flutes{4};
        double patience_rev{0.5};
        double collapseShare{0.3};
        double steadyShare{0.7};   ///< of the same edge's highest sample a revolution before; run-out does not matter
        double chippedShare{0.5};  ///< of the same angles' highest sample a revolution before
        double inWork_N{200.0};    ///< a tooth's highest sample from which a collapse can be told
        double stuckAbove_N{1.0};  ///< below, the same number again and again is air
    };
    ForceWatch() noexcept = default;
    explicit ForceWatch(const Params& params) noexcept : m_params(params) {}

    /// What the axis makes now; empty: not known. The samples that are added next were taken since the call before.
    void setFeed(std::optional<double> feed_mmPerS) noexcept {
        m_feedBefore_mmPerS = m_feed_mmPerS;
        m_feed_mmPerS = feed_mmPerS;
    }
    void add(const FastSample& sample) noexcept;
    /// Forget the teeth (pause, feed hold): nothing has collapsed until the tool has cut again.
    void disarm() noexcept;

    /// `revolution_s`: duration of a revolution as last known.
    [[nodiscard]] bool blind(std::int64_t now_ns, double revolution_s) const noexcept;
    [[nodiscard]] bool collapsed() const noexcept { return m_collapsed; }
    [[nodiscard]] bool chipped() const noexcept { return m_chipped; }
    /// Mean force of the last whole revolution, known anew after every tooth and so earlier than from mark to mark; 0
    /// until a revolution has been seen without a gap.
    [[nodiscard]] double revolutionMean_N() const noexcept;
    /// Worst thing seen lately, for the alarm's text.
    [[nodiscard]] Quality quality() const noexcept { return m_quality; }

 private:
    /// Feeds while a tooth or a sector of the angle passed; empty: not known.
    struct Feed {
        std::optional<double> lowest_mmPerS{};
        std::optional<double> highest_mmPerS{};
        void take(std::optional<double> feed_mmPerS) noexcept;
    };
    /// Share of the force `then` that the feed `now` makes at the least, 0 … 1.
    [[nodiscard]] static double feedShare(const Feed& now, const Feed& then) noexcept;
    void nextTooth(std::int64_t tooth) noexcept;
    /// Highest sample of the tooth `ago` teeth before the last whole one; 0: not known.
    [[nodiscard]] double peak_N(int ago) const noexcept;
    [[nodiscard]] const Feed& feed(int ago) const noexcept;
    [[nodiscard]] bool collapsesNow() const noexcept;
    void nextSector(std::int64_t sector) noexcept;
    /// Highest sample of these sectors of the spindle's angle; empty: none of them holds one.
    [[nodiscard]] std::optional<double> sectorPeak_N(std::int64_t first, std::int64_t last) const noexcept;
    [[nodiscard]] Feed sectorFeed(std::int64_t first, std::int64_t last) const noexcept;
    [[nodiscard]] bool chipsNow() const noexcept;

    Params m_params{};
    bool m_any{false};
    double m_angle_rev{0.0};
    double m_trustedAngle_rev{0.0};  ///< of the last trusted sample that was not the same number again
    std::int64_t m_trusted_ns{0};
    double m_lastForce_N{0.0};
    std::int64_t m_tooth{0};
    double m_peakNow_N{0.0};  ///< of the tooth in the work
    static constexpr int kMaxFlutes = 16;
    static constexpr std::size_t kTeethKept = 32;  ///< more than a revolution and the teeth that collapse
    std::array<double, kTeethKept> m_peak_N{};     ///< highest sample of the last whole teeth, a ring; 0: not known
    std::array<Feed, kTeethKept> m_toothFeed{};    ///< … and the feed while they cut
    std::optional<double> m_feed_mmPerS{};
    std::optional<double> m_feedBefore_mmPerS{};
    Feed m_feedNow{};                           ///< of the tooth in the work
    std::array<double, kMaxFlutes> m_mean_N{};  ///< mean force of the last teeth, a ring
    int m_teeth{0};                             ///< whole teeth since the last gap
    double m_sumNow_N{0.0};
    int m_countNow{0};
    bool m_collapsed{false};
    static constexpr int kSectorsPerTooth = 4;
    static constexpr std::size_t kSectorsKept = 256;  ///< more than a revolution and three teeth
    static constexpr double kNoSample_N = -1e300;
    std::array<double, kSectorsKept> m_sector_N{};  ///< highest sample by sector of the angle, a ring
    std::array<Feed, kSectorsKept> m_sectorFeed{};
    std::int64_t m_sector{0};
    std::int64_t m_sectorsFrom{0};  ///< the first one since the last gap
    bool m_sectorsKnown{false};
    bool m_chipped{false};
    Quality m_quality{Quality::Missing};
};

}  // namespace kerf::milling
