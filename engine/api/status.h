// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include "engine/api/command.h"
#include "engine/api/process_types.h"
#include "engine/core/alarm.h"
#include "engine/core/histogram.h"
#include "engine/core/process.h"
#include "engine/port/machine_port.h"

namespace kerf {

/// One loop, as the screen shows it.
struct LoopStatus {
    bool fitted{false};  ///< false: this build or this machine has no such loop; reason says why
    LoopMode mode{LoopMode::Off};
    LoopState state{LoopState::Off};
    Sentence reason{};
};

/// Timing of the cycle since start (diagnostics page).
struct CycleStats {
    std::uint64_t cycles{0};
    std::uint64_t overruns{0};        ///< cycles whose deadline had passed before they began or ended
    std::uint64_t droppedSamples{0};  ///< chart samples refused by a full ring
    bool realTimeScheduling{false};   ///< SCHED_FIFO granted
    double achievedSpeed{1.0};        ///< machine time per wall time
    TimeHistogram cost{};             ///< time spent in one cycle
    TimeHistogram lateness{};         ///< wake-up after the deadline
};

/// The whole engine at one instant; the newest one wins (LatestValue).
struct Status : ProcessStatuses {
    std::int64_t machineTime_ns{0};
    std::uint64_t cycle{0};
    LinkState link{LinkState::Down};
    bool machineOn{false};
    bool emergencyStop{false};
    bool feedHold{false};
    bool held{false};          ///< hold-all is in force, or the machine stopped or was lost since a person last looked
    bool partsBlocked{false};  ///< the part-record ring was full: no new part until it is drained
    double operatorOverride{1.0};
    double simulationSpeed{1.0};  ///< wanted; 0 = as fast as it can
    double feedScale{1.0};        ///< after limits
    bool feedScaleLimited{false};
    Reading actualFeed_mmPerS{};
    Reading spindleSpeed_rpm{};
    std::array<Reading, kAxisCount> position_mm{};
    std::array<double, kAxisCount> workOffset_um{};
    ProgramState program{ProgramState::Idle};
    ProcessId programProcess{ProcessId::Boring};
    std::uint32_t partSequence{0};
    CommandResult lastCommand{};
    std::array<CommandResult, 8> recentCommands{};   ///< newest first; lastCommand is the first of them
    std::array<StopStatus, kProcessPlaces> stops{};  ///< of each process; released by number (ReleaseStop)
    std::array<LoopStatus, kProcessPlaces> loops{};
    std::array<WorkOrder, kProcessPlaces> orders{};  ///< whose work the next part of each process is
    CycleStats stats{};
};
static_assert(std::is_trivially_copyable_v<Status>);

/// One chart point set, decimated by the engine to about 100 per second of wall time.
struct Sample {
    std::int64_t machineTime_ns{0};
    std::int64_t wallTime_ns{0};
    float feed_mmPerS{0.0F};
    float feed_mmPerRev{0.0F};
    float wantedFeed_mmPerRev{0.0F};
    float overhang_mm{0.0F};
    float force_N{0.0F};
    float depthError_um{0.0F};  ///< turning: tool motion about its level, as the force shows it
    float trim_um{0.0F};        ///< turning: applied
    float forceLow_N{0.0F};     ///< raw force since the last sample
    float forceHigh_N{0.0F};
    float wantedFeed_mmPerS{0.0F};
    float path_mm{0.0F};
    float wallDeviation_um{0.0F};
    bool cutting{false};
};
static_assert(std::is_trivially_copyable_v<Sample>);

/// A finished (or aborted) part, on its way from the cycle to the database.
struct PartRecord : ProcessRecords {
    ProcessId process{ProcessId::Boring};
    std::uint32_t partSequence{0};
    bool complete{true};       ///< false: aborted
    std::int64_t begin_ns{0};  ///< machine time
    std::int64_t end_ns{0};
    WorkOrder order{};        ///< whose work it is: what was in force when it began
    double forceMean_N{0.0};  ///< of processes that measure force
    double forcePeak_N{0.0};
};
static_assert(std::is_trivially_copyable_v<PartRecord>);

}  // namespace kerf
