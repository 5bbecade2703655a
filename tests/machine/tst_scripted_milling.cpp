// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include "engine/core/random.h"
#include "engine/cycle/engine.h"
#include "engine/machine/linuxcnc/linuxcnc_machine.h"
#include "engine/machine/linuxcnc/programs.h"
#include "engine/process/milling/milling_alarms.h"
#include "engine/process/milling/milling_loop.h"
#include "engine/process/milling/moving_cut.h"
#include "engine/process/milling/sampled_force.h"
#include "tests/support/scripted_control.h"

using namespace kerf;
using namespace kerf::linuxcnc;

namespace {

constexpr std::int64_t kPeriod_ns = 1'000'000;
constexpr double kUnit_N = -200.0;  // newtons per unit of the pin
constexpr double kProgrammed_mmPerS = 4.0;

DescribedForce dynamometer() {
    DescribedForce described;
    described.bandwidth_Hz = 300.0;
    described.scale_NPerUnit = kUnit_N;
    described.range_N = 5000.0;
    described.drift_NPerS = 0.02;
    return described;
}

}  // namespace

/// The milling loop on a force pin of LinuxCNC: port, bridge's memory and loop are the real ones, the control and the
/// cut behind them are computed here, a servo period at a time. Nothing depends on how busy the computer is.
class TestScriptedMilling : public QObject {
    Q_OBJECT

    /// One servo period of the control: it moves as it was told, the tool cuts, the sensor answers.
    void servo() {
        const ToControl wish = m_bridge->wish();
        const bool runs = m_bridge->seen.programRunning;
        const double feed_mmPerS = runs && !wish.feedHold ? kProgrammed_mmPerS * wish.feedScale : 0.0;
        m_cut.step(feed_mmPerS * 1e-3, runs ? 0.01 : 0.0, 1.0);
        m_now_ns += kPeriod_ns;
        FromControl& seen = m_bridge->seen;
        seen.spindleAngle_rev += runs ? 0.01 : 0.0;
        seen.spindleSpeed_rps = runs ? 10.0 : 0.0;
        seen.position_mm[0] = m_cut.axis_mm();
        seen.currentVelocity_mmPerS = feed_mmPerS;
        seen.requestedVelocity_mmPerS = runs ? kProgrammed_mmPerS : 0.0;
        seen.appliedFeedScale = wish.feedScale;
        m_zero_N += 2e-5;  // .02 N/s
        const double force_N =
            milling::sampledForce_N({}, m_cut.force_N(), seen.spindleAngle_rev) + m_zero_N + 3.0 * m_noise.gauss();
        m_bridge->force = force_N / kUnit_N;
        m_bridge->now_ns = m_now_ns;
        m_bridge->beat();
    }
    void step() {
        m_engine->cycle().step(m_now_ns);
        m_engine->cycle().publish({});
    }
    bool run(const std::function<bool()>& condition, int most = 120'000) {
        for (int i = 0; i < most; ++i) {
            servo();
            step();
            if (condition()) {
                return true;
            }
        }
        return false;
    }
    template <class Action>
    CommandResult execute(const Action& action) {
        Command command;
        command.action = action;
        (void)m_engine->send(command);
        servo();
        step();
        return m_engine->status().lastCommand;
    }
    [[nodiscard]] MillingStatus milling() { return m_engine->status().milling; }
    /// Under control, and the control has begun the program that it was asked for.
    void begin() {
        MillingSetup setup;
        setup.revision = 1;
        setup.to_mm = 110.0;
        QVERIFY(execute(LoadMillingSetup{setup}).done);
        QVERIFY(execute(SetLoopMode{ProcessId::Milling, LoopMode::Control}).done);
        QVERIFY(execute(StartPart{ProcessId::Milling}).done);
        for (int i = 0; i < 20'000 && !m_rsh->hasHeard("set mdi"); ++i) {  // another thread hands it on
            servo();
            step();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        QVERIFY(m_rsh->hasHeard("set mdi"));
        const double heights_mm[] = {1.0, 2.0, 3.0, 2.0, 1.0};
        milling::PlantParams plant;
        plant.kx_NPerMm = m_kx_NPerMm;
        m_cut.begin(plant, milling::BlankProfile::ofSegments(heights_mm, 20.0)->inAir(true, true),
                    plant.cuttingCoefficient, setup.from_mm);
        const std::uint32_t request = m_engine->cycle().inputs().reply.number;
        m_bridge->seen.declared = declaration(ProcessId::Milling, request);
        m_bridge->seen.programRunning = m_bridge->seen.cutting = true;
        QVERIFY(run([this] { return milling().cutting; }, 100));
    }

    std::unique_ptr<test::ScriptedRsh> m_rsh{};
    std::unique_ptr<test::ScriptedBridge> m_bridge{};
    std::unique_ptr<LinuxCncMachine> m_machine{};
    std::unique_ptr<Engine> m_engine{};
    milling::MovingCut m_cut{};
    double m_kx_NPerMm{milling::PlantParams{}.kx_NPerMm};
    Random m_noise{3};
    double m_zero_N{0.0};
    std::int64_t m_now_ns{0};

 private slots:
    void init() {
        qputenv("KERF_LINUXCNC_PASSWORDS", QByteArray());
        m_rsh = std::make_unique<test::ScriptedRsh>();
        m_bridge = std::make_unique<test::ScriptedBridge>();
        QVERIFY(m_bridge->memory != nullptr);
        m_bridge->seen.fitted.simulator = false;
        m_bridge->seen.fitted.force = m_bridge->seen.fitted.forceLinked = true;
        m_bridge->ready();
        m_bridge->beat();
        LinuxCncMachine::Params params;
        params.rsh = {"127.0.0.1", m_rsh->port(), {}, test::ownMemory()};
        params.described.force = dynamometer();
        m_machine = std::make_unique<LinuxCncMachine>(params);
        QVERIFY(m_machine->connect().has_value());
        for (int i = 0; i < 20'000 && !m_machine->commandsReady(); ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        std::vector<std::unique_ptr<ProcessLoop>> loops;
        loops.push_back(std::make_unique<MillingLoop>());
        m_engine = std::make_unique<Engine>(*m_machine, std::move(loops));
        m_now_ns = 1'000'000'000;
        m_zero_N = 155.0;
        m_cut = {};
        m_kx_NPerMm = milling::PlantParams{}.kx_NPerMm;
        QVERIFY(run([this] { return m_engine->status().link == LinkState::Up; }, 100));
    }
    void cleanup() {
        m_engine.reset();
        m_machine.reset();
        m_bridge.reset();
        m_rsh.reset();
    }

    void theForceOfThePinIsHeld_data() {
        QTest::addColumn<int>("late");  // servo periods that pass without a cycle, every quarter of a second
        QTest::addColumn<double>("kx_NPerMm");
        QTest::newRow("in time") << 0 << 343.0;
        QTest::newRow("40 ms late four times a second") << 40 << 343.0;
        QTest::newRow("a stiff tool") << 0 << 5000.0;  // as the end mills of most shops
        QTest::newRow("a stiffer tool") << 0 << 20'000.0;
        QTest::newRow("a tool that does not give way") << 0 << 1e6;
        QTest::newRow("stiff and late") << 40 << 20'000.0;
    }
    void theForceOfThePinIsHeld() {
        QFETCH(int, late);
        QFETCH(double, kx_NPerMm);
        m_kx_NPerMm = kx_NPerMm;
        begin();
        QVERIFY(run([this] { return milling().zero == ForceZeroState::Known; }, 2000));
        QVERIFY(milling().position_mm < 0.0);  // in the air
        QVERIFY2(std::abs(milling().zero_N - 155.0) < 2.0, qPrintable(QString::number(milling().zero_N)));
        QCOMPARE(milling().signal.bandwidth_Hz, 300.0);
        double sum_N = 0.0;
        int count = 0;
        int spoiled = 0;
        int periods = 0;
        std::int64_t last_ns = 0;
        QVERIFY(run([&] {
            if (late > 0 && ++periods % 250 == 0) {
                for (int i = 0; i < late; ++i) {
                    servo();
                }
            }
            const MillingStatus& now = milling();
            const bool steady = (now.position_mm > 6.0 && now.position_mm < 19.0) ||
                                (now.position_mm > 26.0 && now.position_mm < 39.0) ||
                                (now.position_mm > 46.0 && now.position_mm < 59.0);
            if (steady && now.force_N.stamp_ns != last_ns) {
                last_ns = now.force_N.stamp_ns;
                spoiled += now.force_N.good() ? 0 : 1;
            }
            sum_N += steady ? m_cut.force_N() : 0.0;
            count += steady ? 1 : 0;
            return now.position_mm > 60.0;
        }));
        QCOMPARE(spoiled, 0);  // no period was lost: every revolution has its force
        QVERIFY2(std::abs(sum_N / count - 392.0) < 0.03 * 392.0, qPrintable(QString::number(sum_N / count)));
        qInfo("mean %.1f N, highest revolution %.1f N", sum_N / count, milling().peakForce_N);
    }
    void anAmplifierThatSaysSoMeansNoFasterThanPlanned() {
        begin();
        QVERIFY(run([this] { return milling().position_mm > 10.0; }));
        QVERIFY(!milling().blind);
        m_bridge->forceFault = true;
        double fastest_mmPerS = 0.0;
        int seen = 0;
        QVERIFY(run([&] {
            fastest_mmPerS = ++seen > 1000 ? std::max(fastest_mmPerS, m_bridge->seen.currentVelocity_mmPerS) : 0.0;
            return seen > 3000;
        }));
        QVERIFY(milling().blind);
        QVERIFY2(fastest_mmPerS <= 1.5 + 1e-9, qPrintable(QString::number(fastest_mmPerS)));
        AlarmEvent event;
        bool raised = false;
        while (m_engine->nextAlarm(event)) {
            raised = raised || (event.raised && event.code == milling_alarm::kForceUnknown);
        }
        QVERIFY(raised);
        m_bridge->forceFault = false;
        QVERIFY(run([this] { return !milling().blind && milling().force_N.good(); }, 1000));
    }
};
QTEST_GUILESS_MAIN(TestScriptedMilling)
#include "tst_scripted_milling.moc"
