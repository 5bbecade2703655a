// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/rehearsal/scenario.h"
#include "engine/core/alarm.h"
#include "engine/core/sentence.h"
#include "engine/port/machine_port.h"

namespace kerf::rehearsal {

/// One instant: the machine as it is (not as a lost link shows it), and what the engine says.
struct Row {
    double t_s{0.0};
    MachineInputs machine{};
    bool stopLatched{false};
    std::string stopReason{};
    double plannedFeed_mmPerS{0.0};
    bool console{false};  ///< false: dead; there are no states then
    std::array<LoopState, kProcessPlaces> states{};
    std::vector<AlarmCode> alarms{};  ///< that stand, by code
};

struct StopSeen {
    ProcessId process{ProcessId::Boring};
    std::uint32_t number{0};
    StopKind kind{StopKind::None};
    AlarmCode cause{0};
    std::string reason{};
    double at_s{0.0};
    std::optional<double> released_s{};
};

struct CommandSeen {
    double at_s{0.0};
    std::string deed{};
    bool done{false};
    std::string reason{};
};

/// What a rehearsal comes to. Figures "while stopped" and "while unknown" count from kSettle_s after it began: a drive
/// needs time to stop. Those "at once" count from the first cycle.
struct Summary {
    static constexpr double kSettle_s = 0.5;
    std::uint64_t cycles{0};
    std::array<std::map<LoopState, double>, kProcessPlaces> states{};  ///< first time of each
    std::map<AlarmCode, double> alarms{};                              ///< first time of each
    std::map<AlarmCode, std::string> titles{};
    std::vector<StopSeen> stops{};
    std::vector<CommandSeen> commands{};
    std::uint32_t partsFinished{0};
    std::uint32_t partsAborted{0};
    bool programRuns{false};              ///< at the end
    double feedWhileStopped_mmPerS{0.0};  ///< largest feed while a stop holds the feed
    double wayWhileStopped_mm{0.0};
    double overPlannedWhileUnknown_mmPerS{0.0};  ///< largest feed above the planned one (times an override above 1)
                                                 ///< while anything is unknown
    double overPlannedAtOnce_mmPerS{0.0};
    double stepFeedScale{0.0};  ///< largest step of each output from one cycle of the engine to the next
    std::array<double, kAxisCount> stepOffset_um{};
    double stepToolTrim_um{0.0};
    double stepZTrim_um{0.0};
};

/// Told around each cycle of the console, on the thread that runs it.
class CycleWatch {
 public:
    CycleWatch() = default;
    CycleWatch(const CycleWatch&) = delete;
    CycleWatch& operator=(const CycleWatch&) = delete;
    virtual ~CycleWatch() = default;
    virtual void begins() noexcept = 0;
    virtual void ends() noexcept = 0;
};

/// A real machine, connected twice: as the rehearsed console commands it, and as somebody sees it who only reads, also
/// while the console is dead or stands still.
struct RealMachine {
    MachinePort& commanded;
    MachinePort& seen;
};

/// Runs the real cycle with its supervisor, loops and limiter against the machine. `real`: the machine of a scenario
/// for LinuxCNC, else null. `eachRow` is called every `every_s` (0: every cycle), and at the end;
/// `watch` around each cycle of the console.
[[nodiscard]] Summary rehearse(const Scenario& scenario, const RealMachine* real, double every_s,
                               const std::function<void(const Row&)>& eachRow, CycleWatch* watch = nullptr);

[[nodiscard]] nlohmann::ordered_json summaryJson(const Scenario& scenario, const Summary& summary);

}  // namespace kerf::rehearsal
