// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "engine/process/turning/turning_types.h"

namespace kerf::turning {

/// One sample of the face as it is cut.
struct SurfaceSample {
    double error_um{0.0};      ///< depth error left after the trim
    double untreated_um{0.0};  ///< what it would be without
    double force_N{0.0};
    double progress{0.0};  ///< along the face, 0 to 1
    /// Away from the touch and the exit, which the archive's figures leave out.
    bool counts{false};
};

/// Figures of the cut face: running ones for the screen, and the part's.
///
/// Running RMS over .2 s (first-order mean of the squares); width over each revolution; RMS, width and mean force of
/// the steady part, .5 to .97 of the face, where the published figures are taken. In the cycle: no allocation.
class SurfaceRecord {
 public:
    /// A cut begins; the width of the last whole revolution stays until there is another.
    void clear(std::uint32_t revolutionSamples) noexcept;
    void take(const SurfaceSample& sample) noexcept;
    /// Running figures into the status.
    void show(TurningStatus& status) const noexcept;
    /// The part's figures; untouched where nothing was cut.
    void fill(TurningRecord& record) const noexcept;

 private:
    struct Extent {
        double high{0.0};
        double low{0.0};
        std::uint64_t count{0};
        void take(double value) noexcept {
            high = count == 0 || value > high ? value : high;
            low = count == 0 || value < low ? value : low;
            ++count;
        }
        [[nodiscard]] double width() const noexcept { return high - low; }
    };
    struct Sums {
        double error_um2{0.0};
        double untreated_um2{0.0};
        std::uint64_t count{0};
    };

    std::uint32_t m_revolutionSamples{1};
    double m_running_um2{0.0};
    double m_runningUntreated_um2{0.0};
    Extent m_revolution{};
    double m_revolutionWidth_um{0.0};  ///< of the last whole one
    Sums m_whole{};
    Sums m_steady{};
    double m_steadyForce_N{0.0};
    Extent m_steadyExtent{};
    Extent m_steadyUntreated{};
};

}  // namespace kerf::turning
