// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "engine/process/turning/turning_exchange.h"
#include "ui/services/turning_service.h"

/// What the first part after a start begins from, computed from the stored parts: the process of the newest whole part
/// with the same cut (depth, speed, feed, tool radius) whose identification was sure. None when the sure ones of the
/// last five differ by more than a factor 1.5 in gain: too odd a past is no guide, the assumed process holds. Tones are
/// not handed over: begun with the names of the last part the law errs more in its first half second. A part
/// that was left out with a reason is as if it had not been cut.
namespace kerf {

struct TurningPast {
    TurningRecall recall{};  ///< no process known: nothing to begin from
    TurningMemoryView view{};
};
/// `parts` oldest first.
[[nodiscard]] TurningPast turningPast(std::span<const TurningPartView> parts, const TurningSetup& setup);

/// The same cut, whatever its tones, face and limits.
[[nodiscard]] bool sameCut(const TurningSetup& a, const TurningSetup& b) noexcept;

}  // namespace kerf
