// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "engine/process/tapping/z_servo_model.h"

namespace kerf::tapping {

/// Contour error of a tap, mm per tick; gaps are bridged by straight lines.
[[nodiscard]] std::vector<double> contourError(const TapSignals& tap, double pitch_mm);

/// Standard deviation of the samples' white noise, from second differences of the error (median, so jerks do not
/// count).
[[nodiscard]] double errorNoise_mm(std::span<const double> error_mm);

[[nodiscard]] double sumAbs_mm(std::span<const double> error_mm);

/// Feed-forward that explains an error: least squares of E against the model's response to ff_z and fa_z.
struct FeedForward {
    double velocity{0.0};
    double accel{0.0};
};
[[nodiscard]] FeedForward feedForwardFor(const DriveParams& model, const TapSettings& settings,
                                         std::span<const double> spindle_rev, std::span<const double> error_mm);

/// Addition to the Z command that would have removed an error.
///
///   Δz_c = Σ c_j B_j(t), cubic B-splines every 6 ticks; c = argmin Σ_k (E_k − Σ c_j g_j(k))² + λ Σ (Δ²c)² + μ Σ c²
/// with g_j the model's response to B_j. λ grows with the noise: what one record cannot tell is not learned.
/// Zero-phase by construction (the whole record is known). Deviation from plain iterative learning control: the
/// inverse of the model is regularised instead of low-pass filtered.
struct TrimUpdate {
    std::vector<double> trim_mm{};       ///< per tick
    std::vector<double> explained_mm{};  ///< model response to it
};
[[nodiscard]] TrimUpdate trimFor(const DriveParams& model, std::span<const double> error_mm, double noise_mm);

}  // namespace kerf::tapping
