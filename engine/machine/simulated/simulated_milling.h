// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <vector>

#include "engine/core/lag_share.h"
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
        bool piezo{false};  ///< nobody resets the amplifier before a cut: the machine says that the zero is to be taken
        double zero_N{0.0};             ///< of a piezo, when the machine is made
        double statedDrift_NPerS{0.0};  ///< … and its drift, as its maker says
        bool resetLine{false};          ///< the amplifier can be brought to zero
        double wearPerPart{0.0};        ///< rise of ln C with every part of the tool
        double driveLag_s{0.02};
        double revolutionNoise_N{0.0};  ///< standard deviation of a revolution's mean, drawn anew at every mark
        bool late{false};               ///< force and feed are told one revolution late, as if they were of now
        double drift_NPerS{0.0};  ///< of the sensor's zero, from 0 at the begin of each program unless it is a piezo
        double corner_Hz{0.0};    ///< of the dynamometer, first order; 0: passes all
        double chattersFrom_mm{0.0};  ///< engaged depth above which the cut chatters; 0: never
        double chatter_Hz{637.0};
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
    [[nodiscard]] double zero_N() const noexcept { return m_zero_N; }
    [[nodiscard]] double tip_mm() const noexcept { return m_cut.tip_mm(); }

 private:
    void cut(const SimulationStep& step, double speed_rpm) noexcept;
    void sampleForce(const SimulationStep& step, double speed_rpm, double forceBefore_N,
                     MachineInputs& inputs) noexcept;
    void chatter(double dt_s) noexcept;
    [[nodiscard]] double swing_N(double time_s) const noexcept;
    /// What the sensors tell of: now, or one revolution ago.
    struct Told {
        double force_N{0.0};
        double feed_mmPerS{0.0};
    };
    [[nodiscard]] Told tell(const Told& now, double dt_s, double speed_rpm) noexcept;

    Params m_params;
    Random m_noise;
    double m_zero_N{0.0};  ///< of the sensor
    StartProgram m_program{};
    milling::MovingCut m_cut{};
    double m_feed_mmPerS{0.0};
    LagShare m_driveLag{};
    double m_samplesOwed{0.0};
    double m_revolution{0.0};
    double m_offset_N{0.0};   ///< of this revolution's mean
    double m_passed_N{0.0};   ///< by the dynamometer
    double m_chatter_N{0.0};  ///< amplitude
    double m_time_s{0.0};     ///< of this program
    double m_toldForce_N{0.0};
    static constexpr std::size_t kLate = 2048;  ///< steps: a revolution at 60 rpm and 1 ms
    std::array<Told, kLate> m_past{};           ///< a ring
    std::size_t m_pastCount{0};
    std::uint32_t m_partsBegun{0};
    std::atomic<std::uint32_t> m_partsWithTool{0};
    bool m_running{false};
    Reading m_lastSample_N{};
    Reading m_lastSpeed_rpm{};
};

}  // namespace kerf
