// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/rehearsal/rehearsal.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <set>
#include <thread>
#include <utility>

#include "app/rehearsal/faults.h"
#include "app/rehearsal/rehearsal_console.h"
#include "app/rehearsal/rehearsal_machine.h"
#include "engine/core/units.h"

namespace kerf::rehearsal {
namespace {

constexpr const char* kPerson = "rehearsal";

std::int64_t ns(double seconds) {
    return static_cast<std::int64_t>(std::llround(seconds * kNanosecondPerSecond));
}

bool acts(LoopState state) {
    return state == LoopState::Controlling || state == LoopState::Limited || state == LoopState::Advising;
}

class Run {
 public:
    Run(const Scenario& scenario, const RealMachine* real, CycleWatch* watch)
        : m_scenario(scenario), m_watch(watch), m_real(real) {
        if (real == nullptr) {
            m_simulated = simulatedMachine(scenario);
            (void)m_simulated->connect();
            if (scenario.process == ProcessId::Thermal) {
                m_thermal = trainedModel(scenario);
            }
        }
        m_port = real != nullptr ? &real->commanded : m_simulated.get();
        m_modes.fill(LoopMode::Off);
        m_modes[static_cast<std::size_t>(scenario.process)] = scenario.mode;
        openConsole();
    }

    Summary run(double every_s, const std::function<void(const Row&)>& eachRow) {
        const std::int64_t cycle_ns = m_port->capabilities().cycle_ns;
        const std::int64_t every_ns = std::max(ns(every_s), cycle_ns);
        const std::int64_t end_ns = ns(m_scenario.duration_s);
        const auto begin = std::chrono::steady_clock::now();
        std::int64_t nextRow_ns = 0;
        for (std::int64_t now_ns = 0; now_ns <= end_ns; now_ns += cycle_ns) {
            m_row.t_s = static_cast<double>(now_ns) / kNanosecondPerSecond;
            m_period_s = static_cast<double>(cycle_ns) / kNanosecondPerSecond;
            if (m_simulated == nullptr) {  // a real machine has its own time
                std::this_thread::sleep_until(begin + std::chrono::nanoseconds(now_ns));
            }
            while (m_next < m_scenario.events.size() && ns(m_scenario.events[m_next].at_s) <= now_ns) {
                happen(m_scenario.events[m_next++], now_ns);
            }
            step(now_ns);
            look();
            judge();
            ++m_summary.cycles;
            if (eachRow && (now_ns >= nextRow_ns || now_ns + cycle_ns > end_ns)) {
                nextRow_ns += every_ns;
                eachRow(m_row);
            }
        }
        m_summary.programRuns =
            m_row.machine.program == ProgramState::Running || m_row.machine.program == ProgramState::Paused;
        return std::move(m_summary);
    }

 private:
    void openConsole() {
        m_console = std::make_unique<Console>(*m_port, m_scenario.setups, m_modes, m_keptStops,
                                              m_thermal ? &*m_thermal : nullptr);
        m_titles = m_console->alarmTitles();
    }

    void happen(const Event& event, std::int64_t now_ns) {
        if (event.deed) {
            person(event);
            return;
        }
        if (event.fault == kCycleStall) {
            m_stalledUntil_ns = now_ns + ns(event.seconds);
        } else if (event.fault == kConsoleRestart) {
            m_console.reset();
            m_alarms.clear();
            m_deadUntil_ns = now_ns + ns(event.seconds);
        } else if (m_simulated != nullptr) {
            findFault(event.fault)->apply(m_faults, event);
            m_simulated->inject(m_faults);
        }
    }

    void person(const Event& event) {
        CommandSeen seen;
        seen.at_s = m_row.t_s;
        seen.deed = deedKey(*event.deed);
        if (m_console == nullptr) {
            seen.reason = "No console is there.";
            m_summary.commands.push_back(seen);
            return;
        }
        if (*event.deed == Deed::SetMode) {
            m_modes[static_cast<std::size_t>(event.process)] = event.mode;
        }
        m_console->ask(event, kPerson, m_summary.commands.size());
        m_summary.commands.push_back(seen);
    }

    void step(std::int64_t now_ns) {
        if (m_console == nullptr && now_ns >= m_deadUntil_ns) {
            openConsole();
        }
        m_row.console = m_console != nullptr;
        const bool stalled = now_ns < m_stalledUntil_ns;
        m_silent = m_console == nullptr || stalled;
        if (!m_silent) {
            if (m_watch != nullptr) {
                m_watch->begins();
            }
            m_console->step(now_ns);
            if (m_watch != nullptr) {
                m_watch->ends();
            }
            m_console->takeAnswers(m_summary.commands);
        } else if (m_simulated != nullptr) {
            m_simulated->read(now_ns, m_unheard);  // the machine goes on
        }
    }

    void look() {
        m_row.machine = m_simulated != nullptr ? m_simulated->truth() : realTruth();
        const MachineInputs& in = m_row.machine;
        m_row.plannedFeed_mmPerS =
            in.programmedFeed_mmPerS.value * (in.plannedFeedScale.good() ? in.plannedFeedScale.value : 1.0);
        StopSlots stops = in.stops;
        if (m_console != nullptr) {
            m_keptStops = m_console->stops();  // as the console's data file has them
            for (std::size_t i = 0; i < kProcessPlaces; ++i) {
                stops[i] = joined(stops[i], m_keptStops[i]);
            }
            m_console->drainAlarms(m_alarms);
            m_console->countParts(m_summary.partsFinished, m_summary.partsAborted);
            for (const ProcessId id : allProcesses()) {
                m_row.states[static_cast<std::size_t>(id)] = m_console->state(id);
            }
        }
        m_row.stopLatched = anyStop(stops);
        m_row.stopReason.clear();
        for (const ProcessId id : allProcesses()) {
            const StopSlot& slot = stops[static_cast<std::size_t>(id)];
            if (slot.active() && m_row.stopReason.empty()) {
                const std::string reason = m_console != nullptr ? m_console->stopReason(id) : std::string();
                m_row.stopReason = reason.empty() ? m_titles[slot.cause] : reason;
            }
            noteStop(id, slot);
        }
        m_feedHeld = anyStopOf(stops, StopKind::FeedHold);
        m_row.alarms.assign(m_alarms.begin(), m_alarms.end());
    }

    /// What the console sees while it runs; else what anybody sees. Whose a program is and how it was planned stays as
    /// the console knew it last.
    MachineInputs realTruth() {
        m_real->seen.read(static_cast<std::int64_t>(std::llround(m_row.t_s * kNanosecondPerSecond)), m_seen);
        if (!m_silent) {
            return m_console->inputs();
        }
        MachineInputs now = m_row.machine;
        now.link = m_seen.link;
        now.machineOn = m_seen.machineOn;
        now.emergencyStop = m_seen.emergencyStop;
        now.feedHold = m_seen.feedHold;
        now.actualFeed_mmPerS = m_seen.actualFeed_mmPerS;
        now.programmedFeed_mmPerS = m_seen.programmedFeed_mmPerS;
        now.appliedFeedScale = m_seen.appliedFeedScale;
        now.workOffset_um = m_seen.workOffset_um;
        now.stops = m_seen.stops;
        if (now.programProcess != ProcessId::Tapping) {  // a reader cannot tell where a tap begins
            now.program = m_seen.program;
        }
        return now;
    }

    void noteStop(ProcessId id, const StopSlot& slot) {
        StopSlot& before = m_stopsBefore[static_cast<std::size_t>(id)];
        for (StopSeen& seen : m_summary.stops) {
            if (seen.process == id && !seen.released_s && seen.number <= slot.released) {
                seen.released_s = m_row.t_s;
            }
        }
        if (slot.active() && slot.number != before.number) {
            m_summary.stops.push_back({id, slot.number, slot.kind, slot.cause, m_row.stopReason, m_row.t_s, {}});
        }
        before = slot;
    }

    void judge() {
        if (m_row.console) {
            for (std::size_t i = 0; i < kProcessPlaces; ++i) {
                m_summary.states[i].try_emplace(m_row.states[i], m_row.t_s);
            }
        }
        for (const AlarmCode code : m_row.alarms) {
            m_summary.alarms.try_emplace(code, m_row.t_s);
            m_summary.titles.try_emplace(code, m_titles[code]);
        }
        const double feed_mmPerS = std::abs(m_row.machine.actualFeed_mmPerS.value);
        const double knob = std::max(m_row.machine.operatorOverride, 1.0);
        m_lower_s = knob < m_knob ? m_lower_s + m_period_s : 0.0;
        m_knob = m_lower_s > 0.0 && m_lower_s <= Summary::kSettle_s ? m_knob : knob;  // a drive needs time to fall
        m_stopped_s = m_feedHeld ? m_stopped_s + m_period_s : 0.0;
        if (m_stopped_s > Summary::kSettle_s) {
            m_summary.feedWhileStopped_mmPerS = std::max(m_summary.feedWhileStopped_mmPerS, feed_mmPerS);
            m_summary.wayWhileStopped_mm += feed_mmPerS * m_period_s;
        }
        const auto running = static_cast<std::size_t>(m_row.machine.programProcess);
        const bool unknown = m_silent || m_faults.linkDown || failsFor(m_row.machine.programProcess, m_faults) ||
                             (m_row.console && !acts(m_row.states[running]));
        const bool sameProgram = m_row.machine.partSequence == m_parts;  // a new one begins with a drive that settles
        m_parts = m_row.machine.partSequence;
        m_unknown_s = unknown && sameProgram ? m_unknown_s + m_period_s : 0.0;
        if (unknown) {
            // The operator's knob is a person's: what it adds is no feed of Kerf's.
            const double over_mmPerS = feed_mmPerS - m_row.plannedFeed_mmPerS * m_knob;
            m_summary.overPlannedAtOnce_mmPerS = std::max(m_summary.overPlannedAtOnce_mmPerS, over_mmPerS);
            if (m_unknown_s > Summary::kSettle_s) {
                m_summary.overPlannedWhileUnknown_mmPerS =
                    std::max(m_summary.overPlannedWhileUnknown_mmPerS, over_mmPerS);
            }
        }
        if (m_silent || m_faults.linkDown) {
            m_outputs.reset();
        } else {
            noteSteps(m_console->outputs());
        }
    }

    /// From what the machine had in force: the outputs before, or what it has reported since nothing reached it.
    void noteSteps(const MachineOutputs& now) {
        if (!m_outputs && m_row.t_s > 0.0) {
            m_outputs = MachineOutputs{};
            m_outputs->feedScale = m_row.machine.appliedFeedScale.value;
            m_outputs->toolTrim_um = m_row.machine.toolTrim_um.value;
            m_outputs->zTrim_um = m_row.machine.zTrim_um.value;
            for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
                m_outputs->workOffset_um[axis] = m_row.machine.workOffset_um[axis].value;
            }
        }
        if (m_outputs) {
            const auto most = [](double& figure, double a, double b) { figure = std::max(figure, std::abs(a - b)); };
            most(m_summary.stepFeedScale, now.feedScale, m_outputs->feedScale);
            most(m_summary.stepToolTrim_um, now.toolTrim_um, m_outputs->toolTrim_um);
            most(m_summary.stepZTrim_um, now.zTrim_um, m_outputs->zTrim_um);
            for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
                most(m_summary.stepOffset_um[axis], now.workOffset_um[axis], m_outputs->workOffset_um[axis]);
            }
        }
        m_outputs = now;
    }

    const Scenario& m_scenario;
    CycleWatch* m_watch;
    const RealMachine* m_real;
    std::unique_ptr<SimulatedMachine> m_simulated;
    std::optional<thermal::ThermalModel> m_thermal{};
    MachinePort* m_port{nullptr};
    std::unique_ptr<Console> m_console;
    InjectedFaults m_faults{};
    MachineInputs m_unheard{};
    MachineInputs m_seen{};
    std::array<LoopMode, kProcessPlaces> m_modes{};
    StopSlots m_keptStops{};
    StopSlots m_stopsBefore{};
    std::map<AlarmCode, std::string> m_titles{};
    std::set<AlarmCode> m_alarms{};
    std::optional<MachineOutputs> m_outputs{};
    std::size_t m_next{0};
    std::int64_t m_stalledUntil_ns{0};
    std::int64_t m_deadUntil_ns{0};
    double m_period_s{0.001};
    double m_stopped_s{0.0};
    double m_unknown_s{0.0};
    double m_knob{1.0};
    double m_lower_s{0.0};
    std::uint32_t m_parts{0};
    bool m_silent{false};
    bool m_feedHeld{false};
    Row m_row{};
    Summary m_summary{};
};

}  // namespace

Summary rehearse(const Scenario& scenario, const RealMachine* real, double every_s,
                 const std::function<void(const Row&)>& eachRow, CycleWatch* watch) {
    return Run(scenario, real, watch).run(every_s, eachRow);
}

}  // namespace kerf::rehearsal
