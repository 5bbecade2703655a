// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>

#include "app/rehearsal/faults.h"
#include "app/rehearsal/rehearsal_console.h"
#include "app/rehearsal/rehearsal_machine.h"
#include "engine/core/random.h"

using namespace kerf;
using namespace kerf::rehearsal;

namespace {

constexpr double kCycle_s = 0.001;
constexpr double kFalling = 0.35;  ///< s that limiter, bridge and drive may take to come down to the planned feed
constexpr double kNothing_mmPerS = 0.02;
constexpr std::array kFaults{"force_missing",
                             "force_stale",
                             "force_stuck",
                             "force_ok",
                             "force_ok",
                             "force_ok",
                             "tool_broken",
                             "tool_broken",
                             "tool_broken",
                             "tool_changed",
                             "link_down",
                             "link_up",
                             "link_up",
                             "link_up",
                             "emergency_stop",
                             "emergency_stop",
                             "emergency_stop_reset",
                             "emergency_stop_reset",
                             "emergency_stop_reset",
                             "machine_off",
                             "machine_on",
                             "machine_on",
                             "operator_hold",
                             "operator_resume",
                             "operator_resume",
                             "servo_signal_lost",
                             "servo_signal_ok",
                             "servo_signal_ok",
                             "feed_missing",
                             "feed_ok",
                             "feed_ok",
                             "spindle_speed_missing",
                             "spindle_speed_ok",
                             "spindle_speed_ok"};

/// One random life of console and machine: everything but a person's release may happen, in any order.
class Story {
 public:
    Story(ProcessId process, std::uint64_t seed) : m_random(seed) {
        m_scenario =
            readScenario(std::string(R"({"process":")") + processKey(process) + R"(","duration_s":1})", "property", "");
        m_scenario.seed = seed;
        m_scenario.setups.milling.plannedFeed_mmPerS = 0.8;
        m_scenario.setups.milling.entryFeed_mmPerS = 0.8;
        m_scenario.setups.milling.from_mm = -0.5;  // soon in the work
        m_modes.fill(LoopMode::Control);
        m_machine = simulatedMachine(m_scenario);
        (void)m_machine->connect();
        open();
    }
    /// Empty: all held.
    QString run(int events) {
        for (int i = 0; i < events && m_complaint.isEmpty(); ++i) {
            happen();
            const int cycles = 20 + static_cast<int>(m_random.uniform(0.0, 900.0));
            for (int k = 0; k < cycles && m_complaint.isEmpty(); ++k) {
                cycle();
            }
        }
        return m_complaint;
    }
    [[nodiscard]] bool everStopped() const { return m_everStopped; }

 private:
    void open() { m_console = std::make_unique<Console>(*m_machine, m_scenario.setups, m_modes, m_kept); }

    void happen() {
        const double dice = m_random.uniform();
        Event event;
        event.process = dice < 0.1 ? allProcesses()[m_random.nextU64() % allProcesses().size()] : m_scenario.process;
        m_silentCycles = 0;
        if (dice < 0.35) {
            event.deed = Deed::Start;
        } else if (dice < 0.42) {
            event.deed = Deed::HoldAll;
        } else if (dice < 0.58) {
            event.deed = Deed::ReleaseHold;
        } else if (dice < 0.66) {
            event.deed = Deed::SetMode;
            event.mode = static_cast<LoopMode>(m_random.nextU64() % 3);
            m_modes[static_cast<std::size_t>(event.process)] = event.mode;
        } else if (dice < 0.70) {
            m_silentCycles = 1 + static_cast<int>(m_random.uniform(0.0, 400.0));  // a stall
        } else if (dice < 0.74) {
            m_console.reset();
            m_deadCycles = 1 + static_cast<int>(m_random.uniform(0.0, 400.0));
            m_kept = m_random.uniform() < 0.5 ? StopSlots{} : m_kept;  // a data file that is new, or an old one
        } else {
            const char* name = kFaults[m_random.nextU64() % kFaults.size()];
            m_log += QString::fromLatin1(name) + u' ';
            findFault(name)->apply(m_faults, event);
            m_machine->inject(m_faults);
            return;
        }
        m_log += event.deed ? QString::fromLatin1(deedKey(*event.deed)) + u' ' : QStringLiteral("stall/restart ");
        if (event.deed && m_console) {
            m_console->ask(event, "nobody", 0);
        }
    }

    void cycle() {
        m_now_ns += 1'000'000 / (m_scenario.machine == MachineKind::DiamondLathe ? 5 : 1);
        bool silent = true;
        if (m_console == nullptr && --m_deadCycles <= 0) {
            open();
        }
        if (m_console != nullptr && --m_silentCycles <= 0) {
            m_console->step(m_now_ns);
            std::vector<CommandSeen> answers(1);
            m_console->takeAnswers(answers);
            std::set<AlarmCode> alarms;
            m_console->drainAlarms(alarms);
            std::uint32_t parts = 0;
            m_console->countParts(parts, parts);
            silent = false;
        } else {
            m_machine->read(m_now_ns, m_unheard);
        }
        judge(silent);
    }

    void judge(bool silent) {
        const MachineInputs& in = m_machine->truth();
        StopSlots now = in.stops;
        if (m_console != nullptr && !silent) {
            m_kept = m_console->stops();
        }
        const bool stoppedBefore = anyStop(m_before);
        for (std::size_t i = 0; i < kProcessPlaces; ++i) {
            now[i] = joined(now[i], m_console != nullptr && !silent ? m_kept[i] : m_before[i]);
            const bool turnedOut = m_before[i].kind == StopKind::InWork;
            if (m_before[i].active() && (!now[i].active() || now[i].kind < m_before[i].kind) && !turnedOut) {
                complain(QStringLiteral("a stop of %1 went without a release")
                             .arg(QLatin1String(processKey(static_cast<ProcessId>(i)))));
            }
            m_everStopped = m_everStopped || now[i].active();
        }
        m_before = now;
        const double feed_mmPerS = std::abs(in.actualFeed_mmPerS.value);
        const double period_s = m_scenario.machine == MachineKind::DiamondLathe ? kCycle_s / 5.0 : kCycle_s;
        m_stopped_s = anyStopOf(now, StopKind::FeedHold) ? m_stopped_s + period_s : 0.0;
        if (m_stopped_s > kFalling && std::isfinite(feed_mmPerS) && feed_mmPerS > kNothing_mmPerS &&
            m_faults.actualFeed == SignalFault::None) {
            complain(QStringLiteral("%1 mm/s while a stop holds the feed").arg(feed_mmPerS));
        }
        const bool unknown = silent || m_faults.linkDown || failsFor(in.programProcess, m_faults);
        const bool sameProgram = in.partSequence == m_parts;  // a new one begins with a drive that settles
        m_unknown_s = unknown && sameProgram ? m_unknown_s + period_s : 0.0;
        const double planned_mmPerS = in.programmedFeed_mmPerS.value * in.plannedFeedScale.value;
        if (m_unknown_s > kFalling && m_faults.actualFeed == SignalFault::None && in.program == ProgramState::Running &&
            feed_mmPerS > planned_mmPerS * 1.01 + kNothing_mmPerS) {
            complain(
                QStringLiteral("%1 mm/s, planned are %2, and not all is known").arg(feed_mmPerS).arg(planned_mmPerS));
        }
        if (stoppedBefore && in.partSequence != m_parts) {
            complain(QStringLiteral("a part began while a stop stood"));
        }
        m_parts = in.partSequence;
    }

    void complain(const QString& what) {
        m_complaint =
            QStringLiteral("%1 at %2 s after: %3").arg(what).arg(static_cast<double>(m_now_ns) * 1e-9).arg(m_log);
    }

    Random m_random;
    Scenario m_scenario{};
    std::unique_ptr<SimulatedMachine> m_machine;
    std::unique_ptr<Console> m_console;
    std::array<LoopMode, kProcessPlaces> m_modes{};
    InjectedFaults m_faults{};
    MachineInputs m_unheard{};
    StopSlots m_kept{};
    StopSlots m_before{};
    std::int64_t m_now_ns{0};
    std::uint32_t m_parts{0};
    int m_silentCycles{0};
    int m_deadCycles{0};
    double m_stopped_s{0.0};
    double m_unknown_s{0.0};
    bool m_everStopped{false};
    QString m_log{};
    QString m_complaint{};
};

}  // namespace

/// No sequence of commands, modes, faults, link states and restarts but a release lowers a stop, lets the feed go while
/// one holds it, begins a part while one stands, or makes the feed faster than planned while anything is unknown.
class TestStopProperty : public QObject {
    Q_OBJECT
 private slots:
    void noSequenceLowersAStop_data() {
        QTest::addColumn<int>("process");
        for (const ProcessId process : allProcesses()) {
            QTest::addRow("%s", processKey(process)) << static_cast<int>(process);
        }
    }
    void noSequenceLowersAStop() {
        QFETCH(int, process);
        const auto id = static_cast<ProcessId>(process);
        const int stories =
            qEnvironmentVariableIntValue("KERF_STORIES") > 0 ? qEnvironmentVariableIntValue("KERF_STORIES") : 6;
        int stopped = 0;
        for (int seed = 1; seed <= stories; ++seed) {
            Story story(id, static_cast<std::uint64_t>(seed));
            const QString complaint = story.run(160);
            QVERIFY2(complaint.isEmpty(), qPrintable(QStringLiteral("seed %1: %2").arg(seed).arg(complaint)));
            stopped += story.everStopped() ? 1 : 0;
        }
        // The property must have had something to hold: these three can stop in what happens here.
        if (id == ProcessId::Milling || id == ProcessId::Turning || id == ProcessId::Tapping) {
            QVERIFY2(stopped > 0, "no story came to a stop");
        }
    }
};
QTEST_APPLESS_MAIN(TestStopProperty)
#include "tst_stop_property.moc"
