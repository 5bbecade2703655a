// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/core/lag_share.h"
#include "engine/core/spsc_ring.h"
#include "engine/machine/simulated/simulated_process.h"

namespace kerf {

/// The true boring process from one part on: d = C S^α L^β (process/boring, eq. 2).
struct BoringTruth {
    std::uint32_t fromPart{1};  ///< 1-based count of the parts bored
    double alpha{0.5025};
    double beta{0.2676};
    double c_mm{0.0871};
};

/// The law in force for the part with this count; the last one that has begun. @pre truths not empty
[[nodiscard]] const BoringTruth& truthOf(const std::vector<BoringTruth>& truths, std::uint32_t bored) noexcept;
/// Eq. 2. Units mm/rev, mm; result mm.
[[nodiscard]] double trueDeflection_mm(const BoringTruth& truth, double feed_mmPerRev, double overhang_mm) noexcept;

/// What a bore really looks like: deflection at equally spaced overhangs. Leaves the cycle for the simulated gauge.
struct BoredHole {
    static constexpr std::size_t kStations = 64;
    std::uint32_t partSequence{0};
    std::uint16_t count{0};
    std::array<float, kStations> overhang_mm{};
    std::array<float, kStations> deflection_mm{};
    /// Linear between stations; the nearest one outside them. @pre count > 0
    [[nodiscard]] double deflectionAt_mm(double wantedOverhang_mm) const noexcept;
};

/// Boring spindle of the simulated machine: extends from one overhang to the other at the programmed feed times the
/// feed factor, with the drive's lag, and bends by the true law at the feed it really has.
class SimulatedBoring final : public SimulatedProcess {
 public:
    struct Params {
        std::vector<BoringTruth> truths{BoringTruth{}};  ///< ascending fromPart, first 1
        std::uint32_t boredSoFar{0};                     ///< parts bored before this start
        double driveLag_s{0.02};
    };
    explicit SimulatedBoring(const Params& params);

    [[nodiscard]] ProcessId id() const noexcept override { return ProcessId::Boring; }
    void fit(Capabilities& capabilities) const override;
    [[nodiscard]] Result<void> begin(const StartProgram& program, std::uint32_t partSequence) noexcept override;
    void abort() noexcept override { m_running = false; }
    bool advance(const SimulationStep& step, MachineInputs& inputs) noexcept override;

    /// GUI thread: the finished holes, oldest first.
    [[nodiscard]] SpscRing<BoredHole>& holes() noexcept { return m_holes; }

 private:
    void recordStation() noexcept;

    Params m_params;
    std::uint32_t m_bored{0};
    SpscRing<BoredHole> m_holes{256};
    BoredHole m_hole{};
    BoringTruth m_truth{};
    StartProgram m_program{};
    double m_overhang_mm{0.0};
    double m_feed_mmPerS{0.0};
    LagShare m_driveLag{};
    bool m_running{false};
    Reading m_lastOverhang_mm{};
    Reading m_lastSpeed_rpm{};
};

}  // namespace kerf
