// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/files/dfq.h"
#include "app/service/quality/lot_quality.h"

namespace kerf {

/// What of a lot's measurements goes into the file.
enum class DfqContent : std::uint8_t {
    Standing,  ///< what holds; a corrected value carries the event and the old value, a voided one the attribute 255
    History,   ///< besides, every replaced value, as void
};

/// Events of the file's catalogue 1.
inline constexpr std::uint32_t kEventCorrected = 1;
inline constexpr std::uint32_t kEventVoided = 2;
inline constexpr std::uint32_t kEventProcessChanged = 3;

/// A lot as a Q-DAS file: one characteristic per depth or judged figure, one row per part. Times are local. Operators,
/// machine and events are catalogues. `only`: that part alone.
[[nodiscard]] dfq::File lotDfq(const LotHistory& history, const LotQuality& quality,
                               DfqContent content = DfqContent::Standing, std::optional<PartId> only = std::nullopt);

}  // namespace kerf
