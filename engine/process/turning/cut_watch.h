// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/process/turning/cutting_process.h"

namespace kerf::turning {

/// Sees an edge chip: the same chip suddenly takes more force.
///
///   expected  F̂ = P(û + e): force of the chip that the tones foresee, e the tracker's innovation of x_i
///   chipped   mean of F − F̂ over 3 samples above a fifth of the mean force and above 4 σ of what is usual, four
///             samples in a row, and not falling
///
/// What the tones or the trim do to the force is foreseen and does not count; a knock is at its highest at once and
/// falls, a chipped edge's force rises with the pole of P. A gain that is 1.4 times as high is seen within 15 samples,
/// 3 ms. Wear is slower than this and is no matter of the watch. update() runs in the cycle: no allocation, lock, throw
/// or I/O.
class CutWatch {
 public:
    explicit CutWatch(const ProcessParams& process) noexcept : m_process(process) {}

    /// Force in the cut (N), û and e (µm) of this sample; true when the edge has chipped.
    [[nodiscard]] bool update(double force_N, double chip_um, double innovation_um) noexcept;
    void reset(const ProcessParams& process) noexcept { *this = CutWatch(process); }
    /// Force over the expected one.
    [[nodiscard]] double ratio() const noexcept { return m_mean_N > 0.0 ? 1.0 + m_beyond_N / m_mean_N : 1.0; }

 private:
    CuttingProcess m_process;
    double m_beyond_N{0.0};  ///< mean of F − F̂ over 3 samples
    double m_usual_N2{0.0};
    double m_mean_N{0.0};
    double m_most_N{0.0};
    int m_samples{0};
    int m_above{0};
};

}  // namespace kerf::turning
