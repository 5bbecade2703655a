// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/process/tapping/z_servo_model.h"
#include "ui/services/tapping_service.h"

namespace kerf::tapping {

/// Settings that somebody accepted for one choice, with the proof why. The newest one for a choice counts; going back
/// is one more of them.
struct StoredTuning {
    TapChoice choice{};
    TapSettings settings{};  ///< accepted: in force for this choice
    TapSettings own{};       ///< the machine's gains before anything was tuned
    TuningProof proof{};
    double hole_s{0.0};
    TapCurve first{};  ///< E_r before and after, thinned for the chart
    TapCurve last{};
    /// A record that copies the tuning it is about and leaves it out of what jobs begin from (true) or takes it in
    /// again.
    std::optional<bool> leftOut{};
    std::string leftOutReason{}, leftOutAuthor{};
    std::int64_t recipe{0};  ///< the revision it is stored as; 0: not yet
};

/// Who keeps a tuning and why; `restoredFrom`: the revision of its thread's recipe that comes back.
struct TuningWords {
    std::string author{};
    std::string reason{};
    std::optional<std::uint32_t> restoredFrom{};
};

/// Tunings that jobs may begin from, oldest first: not those that were left out.
[[nodiscard]] std::vector<const StoredTuning*> standing(const std::vector<StoredTuning>& known);
/// The newest record that leaves out a tuning which would serve this choice; null: none.
[[nodiscard]] const StoredTuning* leftOutFor(const std::vector<StoredTuning>& known, const TapChoice& choice);

/// Gains carry over within this share of the speed; the trim only to the same speed and depth.
inline constexpr double kSpeedRange = 0.1;

/// How a stored tuning serves a choice. A trim is a function of time: it needs speed and depth to be the same.
[[nodiscard]] GainsSource serves(const StoredTuning& tuning, const TapChoice& choice);

/// Every so many samples of a curve that at most `most` are left; its end stays.
[[nodiscard]] TapCurve thinned(const TapCurve& curve, std::size_t most);

}  // namespace kerf::tapping
