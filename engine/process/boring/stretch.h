// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/process/boring/kalman_estimator.h"

/// A lot cut into stretches: the parts between one change and the next, each as evidence about its own θ.
///
///   bores     d = exp(xᵀθ + w·k) + σ·z    k parts since the stretch began; w wear per part, a nuisance N(0, s²) whose
///   s
///                                         follows how much the tool seemed to move (the estimator's own weights)
///   evidence  ln p(bores|θ) = −½·θᵀΛθ + hᵀθ + constant, about the most probable θ; Λ as flat as the bores are
///
/// Where a change was not announced, the estimator's test, run from the wide prior, cuts. Pure functions of bores and
/// announcements: what the lot itself began from plays no part, so a lot counts the same whatever came before it.
namespace kerf::boring {

/// What begins a stretch.
enum class StretchKind : std::uint8_t {
    Insert,       ///< new insert or tool; the begin of a lot counts as one
    Reground,     ///< the tool was reground or set anew
    Material,     ///< other batch of material, the same tool
    Unexplained,  ///< the estimator's test found it
};
inline constexpr std::size_t kStretchKinds = 4;

struct AnnouncedChange {
    std::uint32_t part{0};  ///< the first part that is cut after it, ≥ 1
    StretchKind kind{StretchKind::Insert};
    friend bool operator==(const AnnouncedChange&, const AnnouncedChange&) = default;
};

/// θ = (ln C, α, β) as in model.h.
struct Stretch {
    StretchKind kind{StretchKind::Insert};
    std::uint32_t fromPart{0}, toPart{0};  ///< measured parts
    std::uint32_t bores{0};
    Eigen::Matrix3d information{Eigen::Matrix3d::Zero()};  ///< Λ
    Eigen::Vector3d vector{Eigen::Vector3d::Zero()};       ///< h
    double lnFeed{0.0}, lnOverhang{0.0};                   ///< means over the bores
};

/// @pre visits in the order of their parts; announcements in any order
[[nodiscard]] std::vector<Stretch> stretchesOf(std::span<const PartVisit> visits,
                                               std::span<const AnnouncedChange> announced, const KalmanParams& params);

}  // namespace kerf::boring
