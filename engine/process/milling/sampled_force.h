// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace kerf::milling {

/// How the force of one revolution is spread over the revolution: teeth in and out of the cut, one of them standing
/// further out (run-out). The shape's mean over a revolution is exactly 1, so averaging gives back F_y.
///
///   F(φ) = F_y (1 + A_z Σ_{k=1}^{2} cos(2π k z φ)/k² + A_r cos(2π φ))      φ in revolutions from a flute, z flutes
///
/// With a missing flute the pitch of the first one is empty and the second one's force is doubled.
///
/// Not in the paper, which measures the average only; the amplitudes are ours (a four-flute end mill whose teeth leave
/// the cut one after the other). Sign and unit as F_y.
struct ForceShape {
    int flutes{4};
    double toothRipple{0.35};  ///< A_z, 0…0.6
    double runOut{0.15};       ///< A_r, 0…0.2
    bool missing{false};       ///< one flute is gone: nothing over its pitch, twice as much over the next one's
    double markAt_rev{0.0};    ///< where the spindle's mark lies against the flutes, 0…1
};

[[nodiscard]] double sampledForce_N(const ForceShape& shape, double meanForce_N, double angle_rev) noexcept;

}  // namespace kerf::milling
