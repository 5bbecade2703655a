// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "engine/core/random.h"
#include "engine/machine/simulated/simulated_process.h"
#include "engine/process/milling/moving_cut.h"
#include "engine/process/milling/sampled_force.h"

namespace kerf {

/// Milling machine of the simulator: the paper's plant between revolutions as well, with a force sensor at 5 kHz.
///
/// The axis feed follows the program with a lag; milling::MovingCut makes force and deflection of it.
class SimulatedMilling final : public SimulatedProcess {
 public:
    struct Params {
        milling::PlantParams plant{};
        std::vector<milling::BlankProfile> blanks{};  ///< cut in turn, each with air before and after; never empty
        milling::ForceShape shape{};
        double sampleRate_Hz{5000.0};
        double sampleNoise_N{5.0};     ///< standard deviation of one sample
        double sensorRange_N{5000.0};  ///< beyond: saturated
        double wearPerPart{0.0};       ///< rise of ln C with every part of the tool
        double driveLag_s{0.02};
        std::uint64_t seed{1};
    };
    explicit SimulatedMilling(const Params& params);

    [[nodiscard]] ProcessId id() const noexcept override { return ProcessId::Milling; }
    void fit(Capabilities& capabilities) const override;
    [[nodiscard]] Result<void> begin(const StartProgram& program, std::uint32_t partSequence) noexcept override;
    void abort() noexcept override { m_running = false; }
    bool advance(const SimulationStep& step, MachineInputs& inputs) noexcept override;

    /// Any one thread: a tool with which `parts` have been cut is in the spindle from the next part on.
    void setTool(std::uint32_t parts) noexcept { m_partsWithTool.store(parts, std::memory_order_relaxed); }

    /// True normal force, for tests: what the sensor would average without noise and ripple.
    [[nodiscard]] double trueForce_N() const noexcept { return m_cut.force_N(); }
    [[nodiscard]] double tip_mm() const noexcept { return m_cut.tip_mm(); }

 private:
    void cut(const SimulationStep& step, double speed_rpm) noexcept;
    void sampleForce(const SimulationStep& step, double speed_rpm, double forceBefore_N,
                     MachineInputs& inputs) noexcept;

    Params m_params;
    Random m_noise;
    StartProgram m_program{};
    milling::MovingCut m_cut{};
    double m_feed_mmPerS{0.0};
    double m_samplesOwed{0.0};
    std::uint32_t m_partsBegun{0};
    std::atomic<std::uint32_t> m_partsWithTool{0};
    bool m_running{false};
    Reading m_lastSample_N{};
    Reading m_lastSpeed_rpm{};
    Reading m_lastFeed_mmPerS{};
};

}  // namespace kerf
