// SPDX-License-Identifier: GPL-3.0-or-later
#include <QProcess>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "engine/cycle/engine.h"
#include "engine/machine/linuxcnc/linuxcnc_machine.h"
#include "engine/process/milling/milling_alarms.h"
#include "engine/process/milling/milling_loop.h"
#include "tests/support/force_held.h"
#include "tests/support/lateness.h"
#include "tests/support/linuxcnc_control.h"

using namespace kerf;

namespace {

constexpr double kZero_N = 155.0;  // kerf-sim-force.hal

bool setSignal(const char* name, bool value) {
    QProcess halcmd;
    halcmd.start(QStringLiteral("halcmd"),
                 {QStringLiteral("sets"), QLatin1String(name), value ? QStringLiteral("1") : QStringLiteral("0")});
    return halcmd.waitForFinished() && halcmd.exitCode() == 0;
}

}  // namespace

/// A force sensor on a HAL pin of LinuxCNC: every servo period reaches the milling loop, which holds the force by the
/// feed of the real control. The dynamometer is made of HAL's own components, and its tool gives way to nothing: the
/// force follows the feed at once.
class TestLinuxCncForce : public QObject {
    Q_OBJECT
    template <class Action>
    bool send(const Action& action) {
        Command command;
        command.action = action;
        const auto number = m_engine->send(command);
        return number && QTest::qWaitFor([&] {
                   const auto recent = m_engine->status().recentCommands;
                   return std::ranges::any_of(recent,
                                              [&](const CommandResult& r) { return r.number == *number && r.done; });
               });
    }
    /// What the machine's alarms have said since the last call.
    [[nodiscard]] QString alarms() {
        QString said;
        AlarmEvent event;
        while (m_engine->nextAlarm(event)) {
            if (event.raised) {
                said += QStringLiteral(" %1: %2").arg(event.code).arg(QString::fromStdString(event.detail.english()));
            }
        }
        return said;
    }
    [[nodiscard]] MillingStatus milling() { return m_engine->status().milling; }

 private slots:
    void initTestCase() {
        if (const QString why = test::LinuxCncControl::whyNot(); !why.isEmpty()) {
            QSKIP(qPrintable(why));
        }
        QVERIFY2(m_control.start({QStringLiteral("--force")}), m_control.log());
    }
    void init() {
        m_machine = std::make_unique<linuxcnc::LinuxCncMachine>(linuxcnc::LinuxCncMachine::Params{});
        QVERIFY(m_machine->connect().has_value());
        std::vector<std::unique_ptr<ProcessLoop>> loops;
        loops.push_back(std::make_unique<MillingLoop>());
        m_engine = std::make_unique<Engine>(*m_machine, std::move(loops));
        m_engine->start();
        QTRY_VERIFY(m_engine->status().link == LinkState::Up && m_machine->commandsReady());
    }
    void cleanup() {
        m_engine.reset();
        m_machine.reset();
    }

    void theForceOfThePinIsHeldByTheFeed() {
        QTRY_VERIFY(m_engine->capabilities().forceSensor.fitted);
        QCOMPARE(m_engine->capabilities().force.rate_Hz, 1000.0);
        QCOMPARE(m_engine->capabilities().force.bandwidth_Hz, 300.0);
        QVERIFY(m_engine->capabilities().forceReset.fitted);
        MillingSetup setup;
        setup.revision = 1;
        setup.to_mm = 31.0;  // 1 and 2 mm
        QVERIFY(send(LoadMillingSetup{setup}));
        QVERIFY(send(SetLoopMode{ProcessId::Milling, LoopMode::Control}));
        QVERIFY(send(StartPart{ProcessId::Milling}));
        QTRY_VERIFY_WITH_TIMEOUT(milling().cutting, 10'000);
        QTRY_VERIFY(milling().zero == ForceZeroState::Known);
        QVERIFY2(std::abs(milling().zero_N - kZero_N) < 3.0, qPrintable(QString::number(milling().zero_N)));
        QVERIFY(milling().position_mm < 0.0);
        test::ForceHeld force(setup.reference_N);
        bool faultSet = false;
        bool blind = false;
        bool cleared = false;
        double blindFeed_mmPerS = 0.0;
        int held = 0;
        const auto done = [&] {
            const MillingStatus now = milling();
            const double x_mm = now.position_mm;
            const double feed_mmPerS = m_engine->status().actualFeed_mmPerS.value;
            const bool steady = (x_mm > 6.0 && x_mm < 11.5) || (x_mm > 25.5 && x_mm < 29.5);
            if (now.cutting && steady && !m_engine->status().held) {
                force.take(now.force_N, feed_mmPerS);
            }
            // A busy computer loses the link now and then: somebody looks, and the loop goes on.
            if (m_engine->status().held && m_engine->status().link == LinkState::Up) {
                Command release;
                release.action = ReleaseHold{};
                held += m_engine->send(release) ? 1 : 0;
            }
            if (x_mm > 20.0 && !faultSet) {  // the amplifier says that it is overloaded
                faultSet = setSignal("force-fault", true);
            }
            if (faultSet && !cleared && now.blind) {
                blind = true;
                blindFeed_mmPerS = std::max(blindFeed_mmPerS, now.wantedFeed_mmPerS);
            }
            if (faultSet && !cleared && x_mm > 22.0) {
                cleared = setSignal("force-fault", false);
            }
            return now.partsCut == 1;
        };
        const bool ended = QTest::qWaitFor(done, 90'000);
        QVERIFY2(
            ended,
            qPrintable(QStringLiteral("at %1 mm: %2 Force %3 N. Alarms:%4")
                           .arg(milling().position_mm)
                           .arg(QString::fromStdString(
                               m_engine->status().loops[static_cast<std::size_t>(ProcessId::Milling)].reason.english()))
                           .arg(milling().force_N.value)
                           .arg(alarms())));
        QVERIFY(force.revolutions() > 30);
        force.print("force of the pin");
        qInfo("link lost %d times", held);
        QVERIFY(force.within(0.5) < 0.05);
        QVERIFY(force.within(0.9) < 0.15);
        QVERIFY(force.feedRange() > 1.8);  // twice the depth, half the feed
        QVERIFY(blind && cleared);         // … and it went on by itself
        QVERIFY(blindFeed_mmPerS <= setup.plannedFeed_mmPerS + 1e-9);
    }

 private:
    test::LinuxCncControl m_control;
    std::unique_ptr<linuxcnc::LinuxCncMachine> m_machine;
    std::unique_ptr<Engine> m_engine;
};
KERF_TEST_IN_TIME(TestLinuxCncForce)
#include "tst_linuxcnc_force.moc"
