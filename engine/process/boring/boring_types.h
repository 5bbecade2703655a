// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "engine/core/reading.h"

namespace kerf {

inline constexpr std::size_t kMaxBoreDepths = 8;     ///< depths at which a bore is measured
inline constexpr std::size_t kFeedTracePoints = 64;  ///< points of the really cut feed kept per part

/// Feed along the bore for one part: S(L) = (d0/C)^(1/α) / L^(β/α), clamped (process/boring, eq. 3).
///
/// Units: feed mm/rev, overhang mm. Law constants are dimensionless but lnC, ln of mm per (mm/rev)^α mm^β.
struct BoringSchedule {
    std::uint32_t revision{0};  ///< rises with every new schedule of a lot; 0: none
    double lnC{0.0};
    double alpha{1.0};  ///< already clipped by the law, > 0
    double beta{0.0};
    double targetDeflection_mm{0.0};    ///< d0, > 0
    double constantFeed_mmPerRev{0.0};  ///< > 0: the first part, cut at this feed throughout
    double minFeed_mmPerRev{0.01};
    double maxFeed_mmPerRev{1.0};
    double overhangFrom_mm{40.0};
    double overhangTo_mm{310.0};
    double spindleSpeed_rpm{400.0};

    [[nodiscard]] double unclampedFeed_mmPerRev(double overhang_mm) const noexcept {
        if (constantFeed_mmPerRev > 0.0) {
            return constantFeed_mmPerRev;
        }
        return unclampedFeed_mmPerRev(overhang_mm, std::log(targetDeflection_mm));
    }
    /// The same for who keeps the logarithm of d0, for every cycle of a bore.
    [[nodiscard]] double unclampedFeed_mmPerRev(double overhang_mm, double lnTarget) const noexcept {
        if (constantFeed_mmPerRev > 0.0) {
            return constantFeed_mmPerRev;
        }
        return std::exp((lnTarget - lnC - beta * std::log(overhang_mm)) / alpha);
    }
    [[nodiscard]] double clamped_mmPerRev(double feed_mmPerRev) const noexcept {
        return std::clamp(feed_mmPerRev, minFeed_mmPerRev, maxFeed_mmPerRev);
    }
    [[nodiscard]] double feed_mmPerRev(double overhang_mm) const noexcept {
        return clamped_mmPerRev(unclampedFeed_mmPerRev(overhang_mm));
    }
    /// The highest feed anywhere on the bore: what the part program is written with (feed is scaled down from it).
    [[nodiscard]] double highestFeed_mmPerRev() const noexcept {
        return std::max(feed_mmPerRev(overhangFrom_mm), feed_mmPerRev(overhangTo_mm));  // S(L) is monotonic
    }
    /// The lowest: what is left when nobody follows the schedule.
    [[nodiscard]] double lowestFeed_mmPerRev() const noexcept {
        return std::min(feed_mmPerRev(overhangFrom_mm), feed_mmPerRev(overhangTo_mm));
    }
};
static_assert(std::is_trivially_copyable_v<BoringSchedule>);

/// The really cut feed along one bore, as the loop recorded it.
struct FeedTrace {
    std::uint16_t count{0};
    std::array<float, kFeedTracePoints> overhang_mm{};
    std::array<float, kFeedTracePoints> feed_mmPerRev{};
};

/// Live figures of the boring loop, part of Status.
struct BoringStatus {
    bool cutting{false};
    Reading overhang_mm{};
    Reading feed_mmPerRev{};          ///< really cut
    double wantedFeed_mmPerRev{0.0};  ///< S(L) at this overhang, valid while cutting
    std::uint32_t activeSchedule{0};  ///< revision the part in the machine is cut with
    std::uint32_t nextSchedule{0};    ///< revision loaded for the next part
    std::uint32_t partsCut{0};        ///< parts finished since the engine started
    double progress{0.0};             ///< 0…1 along the bore
    double remaining_s{0.0};          ///< estimated time to the end of the bore, machine time
};

}  // namespace kerf
