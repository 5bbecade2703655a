// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "engine/core/latest_value.h"
#include "engine/machine/simulated/simulated_process.h"

namespace kerf {

/// The built-in machine: the plants of the processes behind the port that a real machine has.
///
/// Machine time is the time handed to read(); the plants advance by its difference to the last call. One part program
/// runs at a time. The control inside behaves like a real one: when it has heard nothing for 100 ms of machine time (no
/// write() since) the feed scale falls to the lower of the last one, the lossScale and the planned one of its program
/// (0: feed hold); feed hold, stops, offsets and trims stay. It keeps stops over a console's restart and knows by
/// itself when something stands in the work. While the link is down read() shows nothing new and write() reaches
/// nobody.
class SimulatedMachine final : public MachinePort {
 public:
    struct Params {
        const char* name{"Kerf simulator"};
        std::int64_t cycle_ns{1'000'000};
        double maxFeedScale{1.0};
        OutputLimits limits{};
        Sentence absentProcess{KERF_TEXT("Not fitted yet.")};  ///< why this machine has none of the others
        std::uint32_t partsSoFar{0};                           ///< the counter of a machine that has worked before
    };
    SimulatedMachine(const Params& params, std::vector<std::unique_ptr<SimulatedProcess>> processes);

    [[nodiscard]] Result<void> connect() override;
    void disconnect() noexcept override;
    [[nodiscard]] const Capabilities& capabilities() const noexcept override { return m_capabilities; }
    void read(std::int64_t now_ns, MachineInputs& inputs) noexcept override;
    void write(const MachineOutputs& outputs) noexcept override;

    /// The machine as it is, also while the link shows nothing or the feed's signal fails. Same thread as read().
    [[nodiscard]] const MachineInputs& truth() const noexcept { return m_truth; }
    /// Any one thread: faults in force from the next cycle on.
    void inject(const InjectedFaults& faults) noexcept { m_injected.publish(faults); }

 private:
    void advance(std::int64_t now_ns, MachineInputs& inputs) noexcept;
    void keepStops() noexcept;
    void answerRequest(MachineInputs& inputs) noexcept;
    [[nodiscard]] Result<void> carryOut(const PortRequest& request) noexcept;
    [[nodiscard]] SimulatedProcess* find(ProcessId id) const noexcept;

    std::vector<std::unique_ptr<SimulatedProcess>> m_processes;
    Capabilities m_capabilities{};
    LatestValue<InjectedFaults> m_injected{};
    MachineInputs m_truth{};
    Reading m_toldFeed_mmPerS{};  ///< as the feed's signal says it, whatever its fault
    MachineOutputs m_outputs{};
    StopSlots m_stops{};
    double m_plannedScale{1.0};  ///< declared with the program
    PortRequest m_request{};
    RequestReply m_reply{};
    std::int64_t m_last_ns{-1};
    std::int64_t m_lastWrite_ns{0};
    double m_spindleAngle_rev{0.0};
    std::array<double, kAxisCount> m_workOffset_um{};
    ProgramState m_program{ProgramState::Idle};
    ProcessId m_programProcess{ProcessId::Boring};
    std::uint32_t m_partSequence{0};
    bool m_connected{false};
};

}  // namespace kerf
