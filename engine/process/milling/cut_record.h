// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "engine/process/milling/milling_types.h"
#include "engine/process/milling/stiffness_estimator.h"

namespace kerf::milling {

/// What one revolution adds to the record of its cut.
struct CutRevolution {
    double position_mm{0.0};
    double force_N{0.0};
    double revolution_s{0.1};
    double feed_mmPerS{0.0};            ///< really made
    double controlledFeed_mmPerS{0.0};  ///< what the law keeps in the long run at this depth, inside the range
    StiffnessEstimate stiffness{};
};

/// Sums up a cut while it is made: time against the planned feed, peak and where, predicted waviness, mean stiffness.
///
/// Waviness as docs/milling.md, but live: running mean of the wall deviation over the sensor's spot (by distance),
/// highest minus lowest, from `from_mm` after the first contact to `exit_mm` (the tool's radius) before the last. All
/// functions run in the cycle.
class CutRecord {
 public:
    struct Params {
        double planned_mmPerS{1.5};
        double reference_N{392.0};
        double ky_NPerMm{1471.0};
        double airForce_N{20.0};
        double spot_mm{2.0};
        double from_mm{10.0};
        double exit_mm{5.0};
    };
    CutRecord() noexcept = default;
    CutRecord(const Params& params, MillingLaw law, bool advised) noexcept;

    void add(const CutRevolution& revolution) noexcept;
    void countStop() noexcept { ++m_cut.stops; }
    [[nodiscard]] const MillingCut& cut() const noexcept { return m_cut; }
    /// Advising: what control would save; controlling: what it has saved. Negative: the plan is faster.
    [[nodiscard]] double saved_s() const noexcept { return m_cut.plannedTime_s - m_cut.controlledTime_s; }

 private:
    void addWall(double position_mm, double deviation_um) noexcept;

    static constexpr std::size_t kWindow = 256;  ///< revolutions kept; with more of them in the distance the oldest go
    Params m_params{};
    MillingCut m_cut{};
    double m_contact_mm{0.0};
    bool m_contact{false};
    double m_forceTime_Ns{0.0};
    double m_workTime_s{0.0};
    double m_stiffnessSum{0.0};
    double m_halfSum{0.0};
    double m_stiffnessWeight{0.0};
    std::array<double, kWindow> m_at_mm{};
    std::array<double, kWindow> m_deviation_um{};
    std::size_t m_first{0};
    std::size_t m_count{0};
    double m_low_um{1e300};
    double m_high_um{-1e300};
};

/// Wear over parts: mean ln(C b) of each part against the first ones cut with the tool, and its trend per part.
/// Parts with the same blank assumed. All functions run in the cycle.
class WearTrend {
 public:
    void reset() noexcept { *this = WearTrend(); }
    void addPart(double meanStiffness) noexcept;
    [[nodiscard]] std::uint32_t parts() const noexcept { return m_parts; }
    [[nodiscard]] double rise() const noexcept { return m_parts > 0 ? m_last - m_first : 0.0; }
    /// Slope of the least-squares line; 0 before the third part.
    [[nodiscard]] double perPart() const noexcept;

    /// To and from what is stored; the k_x weights are not the trend's.
    void save(MillingToolState& tool) const noexcept;
    void restore(const MillingToolState& tool) noexcept;

 private:
    std::uint32_t m_parts{0};
    double m_first{0.0};
    double m_last{0.0};
    double m_sumY{0.0}, m_sumXy{0.0};  // sums of x follow from the number of parts
};

}  // namespace kerf::milling
