// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/rooms/room.h"
#include "engine/cycle/program_follower.h"
#include "engine/machine/simulated/simulated_process.h"

/// A sixth process, as docs/architecture.md says how to add one: a brush runs along an edge, and the feed falls where
/// the burr is thick, so that the force stays below its limit. What Kerf has of every process serves it without naming
/// it.
namespace kerf::test {

inline constexpr ProcessId kDeburring{5};
inline constexpr double kForceLimit_N = 20.0;
inline constexpr double kEdge_mm = 100.0;
inline constexpr double kFeed_mmPerS = 10.0;
inline constexpr double kFeed_mmPerRev = 0.5;

extern const ProcessDescriptor kDeburringProcess;

/// The brush: force_N = 1.5 N/(mm/s) · feed, three times as much on the burr between 30 and 60 mm.
class SimulatedDeburring final : public SimulatedProcess {
 public:
    [[nodiscard]] ProcessId id() const noexcept override { return kDeburring; }
    void fit(Capabilities&) const override {}
    [[nodiscard]] Result<void> begin(const StartProgram& program, std::uint32_t partSequence) noexcept override;
    void abort() noexcept override { m_running = false; }
    bool advance(const SimulationStep& step, MachineInputs& inputs) noexcept override;

 private:
    double m_at_mm{0.0};
    double m_programmed_mmPerS{0.0};
    bool m_running{false};
};

/// feedScale = limit / force where the force is above it; without a force the wish is the planned feed.
class DeburringLoop final : public ProcessLoop {
 public:
    [[nodiscard]] ProcessId id() const noexcept override { return kDeburring; }
    [[nodiscard]] std::span<const AlarmSpec> alarms() const noexcept override { return {}; }
    [[nodiscard]] CommandResult handle(const Command& command) noexcept override;
    void setMode(LoopMode mode) noexcept override { m_mode = mode; }
    [[nodiscard]] LoopVerdict step(const MachineInputs& inputs, const Capabilities& capabilities, LoopOutputs& outputs,
                                   EventSink& events) noexcept override;
    void report(Status&) const noexcept override {}
    void sample(Sample& sample) const noexcept override;

 private:
    ProgramFollower m_program{kDeburring};
    LoopMode m_mode{LoopMode::Off};
    PartRecord m_part{};
    double m_scale{1.0};
    double m_force_N{0.0};
    double m_sum_N{0.0};
    std::uint32_t m_samples{0};
    bool m_startWanted{false};
};

/// Deburring on the console. Its page shows what the loop does and starts a part.
class DeburringRoom final : public console::Room {
 public:
    [[nodiscard]] ProcessId process() const noexcept override { return kDeburring; }
    [[nodiscard]] ui::PageEntry page() const override;
    [[nodiscard]] bool fits(const std::string& machineKind) const override { return machineKind == "simulator"; }
    [[nodiscard]] std::unique_ptr<SimulatedProcess> makePlant(const console::Options&) override {
        return std::make_unique<SimulatedDeburring>();
    }
    [[nodiscard]] std::unique_ptr<ProcessLoop> makeLoop() override { return std::make_unique<DeburringLoop>(); }
};

}  // namespace kerf::test
