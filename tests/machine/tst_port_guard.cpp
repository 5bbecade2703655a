// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <QTest>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <thread>
#include <vector>

#include "engine/cycle/engine.h"
#include "engine/cycle/real_time.h"
#include "engine/machine/described_machine.h"
#include "engine/machine/linuxcnc/feed_keeper.h"
#include "engine/machine/linuxcnc/linuxcnc_machine.h"
#include "engine/machine/linuxcnc/programs.h"
#include "engine/machine/replay/replay_machine.h"
#include "engine/machine/sensors/sensor_port.h"
#include "engine/process/boring/boring_loop.h"
#include "engine/process/milling/milling_loop.h"
#include "engine/process/tapping/tapping_loop.h"
#include "tests/support/boring_bench.h"
#include "tests/support/cycle_guard.h"
#include "tests/support/scripted_control.h"
#include "tests/support/sensor_process.h"
#include "tests/support/tapping_bench.h"
#include "tests/support/thermal_bench.h"

using namespace kerf;
using namespace kerf::linuxcnc;

namespace {

constexpr std::int64_t kPeriod_ns = 1'000'000;

/// Waits for what another thread does; nothing is measured by it.
bool until(const std::function<bool()>& condition) {
    for (int i = 0; i < 20'000; ++i) {
        if (condition()) {
            return true;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
}

/// An engine of which every cycle is looked at.
class Watched {
 public:
    Watched(MachinePort& port, std::vector<std::unique_ptr<ProcessLoop>> loops)
        : m_engine(std::make_unique<Engine>(port, std::move(loops))) {}

    void step(std::int64_t now_ns) {
        const test::CycleGuard guard;
        m_engine->cycle().step(now_ns);
        m_engine->cycle().publish({});
        sins += guard.allocations() + guard.locks() + guard.throws();
        pageFaults += guard.pageFaults();
        ++cycles;
    }
    [[nodiscard]] Engine& engine() { return *m_engine; }
    [[nodiscard]] Status status() { return m_engine->status(); }
    template <class Action>
    void send(const Action& action) {
        Command command;
        command.action = action;
        (void)m_engine->send(command);
    }
    void drain() {
        AlarmEvent event;
        while (m_engine->nextAlarm(event)) {
            ++alarms;
        }
        PartRecord part;
        while (m_engine->partRecords().tryPop(part)) {
        }
    }

    std::uint64_t sins{0};
    std::uint64_t pageFaults{0};
    std::uint64_t cycles{0};
    std::uint64_t alarms{0};

 private:
    std::unique_ptr<Engine> m_engine;
};

#define VERIFY_PURE(watched)                \
    do {                                    \
        QVERIFY((watched).cycles > 1000);   \
        QCOMPARE((watched).sins, 0U);       \
        QCOMPARE((watched).pageFaults, 0U); \
    } while (false)

/// LinuxCNC behind the scripted bridge: axes and spindle move as they were told, the bridge lets go as the real one.
class ScriptedMotion {
 public:
    ScriptedMotion() { renew(); }
    /// Another bridge, as after a restart of kerf-hal: the machine under it goes on.
    void renew() {
        const FromControl before = bridge != nullptr ? bridge->seen : FromControl{};
        const double force = bridge != nullptr ? bridge->force : 0.0;
        bridge.reset();
        bridge = std::make_unique<test::ScriptedBridge>();
        if (before.beat != 0) {
            bridge->seen = before;
            bridge->seen.beat = 0;
            bridge->force = force;
            m_keeper = FeedKeeper(m_keeper.epoch() + 1000);
        }
        bridge->seen.fitted.servoGains = bridge->seen.fitted.servoRecord = true;
        bridge->seen.driveBandwidth_perS = 400.0;
        bridge->seen.spindleSpeed_rps = 0.0;
        bridge->ready();
    }
    void begin(ProcessId process, std::uint32_t request, double feed_mmPerS, double length_mm) {
        m_process = process;
        m_programmed_mmPerS = feed_mmPerS;
        m_length_mm = length_mm;
        m_done_mm = 0.0;
        FromControl& seen = bridge->seen;
        seen.finished = false;
        seen.declared = declaration(process, request);
        seen.programRunning = seen.cutting = true;
    }
    void end(bool finished) {
        FromControl& seen = bridge->seen;
        seen.finished = finished;
        seen.programRunning = seen.cutting = seen.programPaused = false;
        seen.declared = 0;
        m_programmed_mmPerS = 0.0;
        bridge->seen.position_mm = {};
    }
    /// One servo period; the bridge may be late.
    void step(bool beats = true) {
        now_ns += kPeriod_ns;
        FromControl& seen = bridge->seen;
        m_late_ns += kPeriod_ns;
        const double scale = m_late_ns > FeedKeeper::kAliveWidth_ns ? m_pins.lossScale : m_pins.scale;
        const double feed_mmPerS = seen.programRunning && !m_pins.hold ? m_programmed_mmPerS * scale : 0.0;
        m_done_mm += feed_mmPerS * 1e-3;
        seen.spindleSpeed_rps = seen.programRunning ? 10.0 : 0.0;
        seen.spindleAngle_rev += 1e-3 * seen.spindleSpeed_rps;
        if (seen.programRunning) {
            seen.position_mm[m_process == ProcessId::Milling ? 0 : 2] =
                m_process == ProcessId::Milling ? m_done_mm : -m_done_mm;
        }
        seen.currentVelocity_mmPerS = feed_mmPerS;
        seen.requestedVelocity_mmPerS = m_programmed_mmPerS;
        if (beats) {
            const bool told = bridge->memory->toControl.refresh();
            const ToControl& wish = bridge->memory->toControl.value();
            FeedKeeper::Round round;
            round.passed_ns = m_late_ns;
            round.running = seen.programRunning;
            round.stopHolds = anyStopOf(wish.stops, StopKind::FeedHold);
            m_pins = m_keeper.next(round, told ? &wish : nullptr, m_pins);
            m_late_ns = 0;
            seen.appliedFeedScale = m_pins.scale;
            seen.plannedScale = m_keeper.plannedScale();
            seen.feedEpoch = m_keeper.epoch();
            seen.stops = wish.stops;
            if (wish.gainsRevision != 0) {
                seen.gains = wish.gains;
            }
            bridge->now_ns = now_ns;
            bridge->beat();
        }
        if (seen.programRunning && m_done_mm >= m_length_mm) {
            end(true);
        }
    }

    std::unique_ptr<test::ScriptedBridge> bridge{};
    std::int64_t now_ns{1'000'000'000};

 private:
    FeedKeeper m_keeper{5};
    FeedKeeper::Pins m_pins{};
    std::int64_t m_late_ns{0};
    ProcessId m_process{ProcessId::Boring};
    double m_programmed_mmPerS{0.0};
    double m_length_mm{0.0};
    double m_done_mm{0.0};
};

}  // namespace

/// Every machine behind the port, with the loops that it hosts, through a part with faults: no cycle allocates, locks,
/// throws or meets a page for the first time. The simulated machines are looked at by tst_rehearsals_guard.
class TestPortGuard : public QObject {
    Q_OBJECT

    /// @param force on its pin; without a bandwidth a simulated one
    bool connected(std::unique_ptr<ProcessLoop> loop, const DescribedForce& force = {}) {
        m_rsh = std::make_unique<test::ScriptedRsh>();
        m_motion = std::make_unique<ScriptedMotion>();
        Fitted& fitted = m_motion->bridge->seen.fitted;
        fitted.simulator = !force.bandwidth_Hz;
        fitted.force = fitted.forceLinked = force.bandwidth_Hz.has_value();
        m_motion->bridge->beat();
        LinuxCncMachine::Params params;
        params.rsh = {"127.0.0.1", m_rsh->port(), {}, test::ownMemory()};
        params.described.force = force;
        m_machine = std::make_unique<LinuxCncMachine>(params);
        if (!m_machine->connect()) {
            return false;
        }
        std::vector<std::unique_ptr<ProcessLoop>> loops;
        loops.push_back(std::move(loop));
        m_watched = std::make_unique<Watched>(*m_machine, std::move(loops));
        return servosUntilThreads(
            [this] { return m_watched->status().link == LinkState::Up && m_machine->commandsReady(); });
    }
    void servo(bool bridge = true) {
        m_motion->step(bridge);
        m_watched->step(m_motion->now_ns);
    }
    void servos(int count, bool bridge = true) {
        for (int i = 0; i < count; ++i) {
            servo(bridge);
        }
    }
    bool servosUntil(const std::function<bool()>& condition, int most = 60'000) {
        for (int i = 0; i < most; ++i) {
            if (condition()) {
                return true;
            }
            servo();
        }
        return false;
    }
    /// The machine goes on while another thread works.
    bool servosUntilThreads(const std::function<bool()>& condition) {
        return until([&] { return servo(), condition(); });
    }
    /// Asked, refused by the control, asked again, begun.
    bool startRefusedThenStart(ProcessId process, double feed_mmPerS, double length_mm) {
        m_rsh->script("set mdi", {"SET NAK", false, {}});
        m_watched->send(StartPart{process});
        if (!servosUntilThreads([this] {
                const RequestReply& reply = m_watched->engine().cycle().inputs().reply;
                return reply.state == RequestState::Refused;
            })) {
            return false;
        }
        servos(50);
        m_rsh->forget();
        const std::size_t before = starts();
        m_watched->send(StartPart{process});
        if (!servosUntilThreads([&] { return starts() > before; })) {
            return false;
        }
        m_motion->begin(process, m_watched->engine().cycle().inputs().reply.number, feed_mmPerS, length_mm);
        return servosUntil([this] { return m_watched->status().program == ProgramState::Running; }, 200);
    }
    [[nodiscard]] std::size_t starts() const {
        const auto heard = m_rsh->heard();
        return static_cast<std::size_t>(
            std::ranges::count_if(heard, [](const std::string& line) { return line.starts_with("set mdi o<"); }));
    }
    /// The bridge late by 60 and by 150 ms, a release, another bridge, and whatever a loop says to it.
    bool loseAndFindTheLink() {
        servos(60, false);
        servos(100);
        servos(150, false);
        servos(20);
        const bool held = m_watched->status().held;
        m_watched->send(ReleaseHold{});
        servos(100);
        m_motion->renew();
        const bool found = servosUntilThreads([this] {
            return m_machine->commands() && m_watched->status().link == LinkState::Up &&
                   m_motion->bridge->memory->owner.load() != 0;
        });
        servos(20);
        m_watched->send(ReleaseHold{});
        servos(100);
        m_watched->drain();
        return held && found;
    }

    std::unique_ptr<test::ScriptedRsh> m_rsh{};
    std::unique_ptr<ScriptedMotion> m_motion{};
    std::unique_ptr<LinuxCncMachine> m_machine{};
    std::unique_ptr<Watched> m_watched{};
    std::unique_ptr<TapExchange> m_taps{};

 private slots:
    void initTestCase() {
        if (!test::CycleGuard::available()) {
            QSKIP("a sanitizer owns malloc in this build");
        }
        qputenv("KERF_LINUXCNC_PASSWORDS", QByteArray());
        prefault();
    }
    void cleanup() {
        m_watched.reset();
        m_machine.reset();
        m_motion.reset();
        m_rsh.reset();
    }

    void linuxCncThroughABore() {
        QVERIFY(connected(std::make_unique<BoringLoop>()));
        m_watched->send(LoadBoringSchedule{test::shortSchedule()});
        m_watched->send(SetLoopMode{ProcessId::Boring, LoopMode::Control});
        servos(3);
        QVERIFY(startRefusedThenStart(ProcessId::Boring, 3.0, 20.0));
        servos(300);
        QVERIFY(loseAndFindTheLink());
        m_motion->bridge->seen.programPaused = true;
        servos(50);
        m_motion->bridge->seen.programPaused = false;
        QVERIFY(servosUntil([this] { return m_watched->status().boring.partsCut == 1; }));
        VERIFY_PURE(*m_watched);
    }
    void linuxCncThroughASimulatedCutThatAnEmergencyStopEnds() {
        QVERIFY(connected(std::make_unique<MillingLoop>()));
        MillingSetup milling;
        milling.revision = 1;
        milling.to_mm = 46.0;
        m_watched->send(LoadMillingSetup{milling});
        m_watched->send(SetLoopMode{ProcessId::Milling, LoopMode::Control});
        servos(3);
        QVERIFY(startRefusedThenStart(ProcessId::Milling, 4.0, 46.0));
        servos(2000);
        QVERIFY(loseAndFindTheLink());
        servos(2000);
        m_motion->bridge->seen.emergencyStop = true;
        m_motion->bridge->seen.machineOn = false;
        m_motion->end(false);
        servos(100);
        m_motion->bridge->seen.emergencyStop = false;
        m_motion->bridge->seen.machineOn = true;
        servos(10);
        m_watched->send(ReleaseHold{});
        servos(100);
        m_watched->engine().holdAll();
        servos(100);
        m_watched->drain();
        QVERIFY(m_watched->alarms > 0);
        VERIFY_PURE(*m_watched);
    }
    void linuxCncThroughTaps() {
        m_taps = std::make_unique<TapExchange>();
        QVERIFY(connected(std::make_unique<TappingLoop>(*m_taps)));
        m_motion->bridge->seen.gains = {48.0, 0.0, 0.0};
        m_watched->send(SetLoopMode{ProcessId::Tapping, LoopMode::Control});
        m_watched->send(LoadTappingJob{test::job()});
        m_watched->send(test::initialGains());
        servos(200);
        QVERIFY2(startRefusedThenStart(ProcessId::Tapping, 15.0, 15.0),
                 m_watched->status().tapping.problem.english().c_str());
        QVERIFY(servosUntil([this] { return m_watched->status().program != ProgramState::Running; }));
        servos(500);
        QVERIFY2(startRefusedThenStart(ProcessId::Tapping, 15.0, 15.0),
                 m_watched->status().tapping.problem.english().c_str());
        servos(60, false);
        servos(20);
        m_watched->send(AbortTap{});
        servos(20);
        m_motion->renew();
        QVERIFY(servosUntilThreads([this] { return m_machine->commands(); }));
        servos(50);
        m_motion->end(false);
        servos(500);
        m_watched->drain();
        QVERIFY(m_watched->alarms > 0);
        VERIFY_PURE(*m_watched);
    }
    void aForcePinThroughItsFaults() {
        DescribedForce piezo;
        piezo.bandwidth_Hz = 300.0;
        piezo.range_N = 5000.0;
        QVERIFY(connected(std::make_unique<MillingLoop>(), piezo));
        MillingSetup milling;
        milling.revision = 1;
        milling.to_mm = 46.0;
        m_watched->send(LoadMillingSetup{milling});
        m_watched->send(SetLoopMode{ProcessId::Milling, LoopMode::Control});
        servos(3);
        QVERIFY(startRefusedThenStart(ProcessId::Milling, 4.0, 46.0));
        Random noise(3);
        const auto cut = [&](int periods, double force_N) {
            for (int i = 0; i < periods; ++i) {
                m_motion->bridge->force = force_N + 3.0 * noise.gauss();
                servo();
            }
        };
        cut(1500, 155.0);
        cut(1500, 400.0);
        m_motion->bridge->forceFault = true;
        cut(300, 400.0);
        m_motion->bridge->forceFault = false;
        cut(300, 400.0);
        cut(300, 6000.0);  // at the end of its range
        m_motion->bridge->force = std::numeric_limits<double>::quiet_NaN();
        servos(300);
        for (int i = 0; i < 90; ++i) {
            m_motion->step();  // the cycle is late, the servo thread is not
        }
        cut(300, 400.0);
        cut(500, 160.0);  // no force in the cut: the tool is broken
        m_watched->drain();
        QVERIFY(m_watched->alarms > 0);
        VERIFY_PURE(*m_watched);
    }
    void aDescribedMachine() {
        test::BoringBench bench;
        MachineDescription description;
        description.axes[2] = AxisTravel{-10.0, 50.0};
        description.highestSpeed_rpm = 5000.0;
        DescribedMachine described(*bench.machine, description);
        QVERIFY(described.connect().has_value());
        std::vector<std::unique_ptr<ProcessLoop>> loops;
        loops.push_back(std::make_unique<BoringLoop>());
        Watched watched(described, std::move(loops));
        std::int64_t now_ns = 0;
        const auto run = [&](int count) {
            for (int i = 0; i < count; ++i) {
                watched.step(now_ns += kPeriod_ns);
            }
        };
        run(5);
        watched.send(SetLoopMode{ProcessId::Boring, LoopMode::Control});
        BoringSchedule tooLong = test::shortSchedule(1);
        tooLong.overhangTo_mm = 400.0;
        watched.send(LoadBoringSchedule{tooLong});
        run(2);
        watched.send(StartPart{ProcessId::Boring});  // refused here, the machine never hears of it
        run(200);
        QCOMPARE(watched.status().boring.partsCut, 0U);
        watched.send(LoadBoringSchedule{test::shortSchedule(2)});
        run(2);
        watched.send(StartPart{ProcessId::Boring});
        run(300);
        InjectedFaults faults;
        faults.linkDown = true;
        bench.machine->inject(faults);
        run(200);
        bench.machine->inject({});
        run(10);
        watched.send(ReleaseHold{});
        run(30'000);
        watched.drain();
        QCOMPARE(watched.status().boring.partsCut, 1U);
        VERIFY_PURE(watched);
    }
    void aRecordedDayWithSensorsBesideIt() {
        constexpr std::uint16_t kChannels = 3;
        std::vector<ReplayRow> rows(3);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            rows[i].time_min = 0.05 * static_cast<double>(i);
            rows[i].speed_rpm = 1000.0;
            rows[i].present = 7;
            rows[i].temp_degC = {20.0F, 21.0F, 22.0F};
        }
        const std::string name = QString::asprintf("/kerf-test-sensors-%d", getpid()).toStdString();
        auto process = std::make_unique<test::SensorProcess>(name);
        ReplayMachine replay(rows, kChannels);
        SensorPort port(replay, {name, {0, 1, 2}, 3});
        QVERIFY(port.connect().has_value());
        auto exchange = std::make_unique<ThermalExchange>();
        std::vector<std::unique_ptr<ProcessLoop>> loops;
        loops.push_back(std::make_unique<ThermalLoop>(*exchange));
        Watched watched(port, std::move(loops));
        exchange->offer(std::move(*LiveModel::make(test::machineModel(), test::channelNames(), 1)));
        std::int64_t now_ns = 0;
        const auto run = [&](int count, std::int64_t cycle_ns = 10'000'000) {
            for (int i = 0; i < count; ++i) {
                watched.step(now_ns += cycle_ns);
            }
        };
        run(10);
        watched.send(SetLoopMode{ProcessId::Thermal, LoopMode::Control});
        run(100);
        process->write({20.00, 20.01, 20.02, 20.03}, Quality::Good);
        run(100);
        QVERIFY(watched.engine().cycle().inputs().temperatures != nullptr);
        process->write({20.00, 20.01, 20.02, 20.03}, Quality::Stale);
        run(100);
        QVERIFY(watched.engine().cycle().inputs().temperatures == nullptr);
        process.reset();  // it has died, another one is started
        run(100);
        process = std::make_unique<test::SensorProcess>(name);
        QVERIFY(until([&] {
            process->write({23.00, 23.01, 23.02, 23.03}, Quality::Good);
            run(1);
            return watched.engine().cycle().inputs().temperatures != nullptr &&
                   watched.engine().cycle().inputs().temperatures->temp_degC[0].value == 23.0;
        }));
        watched.send(StartPart{ProcessId::Thermal});  // a recorded day begins nothing
        run(2000, 100'000'000);
        QVERIFY(replay.ended());
        watched.drain();
        VERIFY_PURE(watched);
    }
};
QTEST_GUILESS_MAIN(TestPortGuard)
#include "tst_port_guard.moc"
