// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "engine/boring/boring_loop.h"
#include "engine/loop/engine.h"
#include "engine/machine/linuxcnc/assumed_drive.h"
#include "engine/machine/linuxcnc/linuxcnc_machine.h"
#include "engine/milling/milling_loop.h"
#include "engine/tapping/tapping_loop.h"
#include "engine/tapping/tuning_session.h"
#include "tests/support/linuxcnc_control.h"

using namespace kerf;

/// The loops on LinuxCNC's own simulator: motion, spindle, G-code and HAL are the real thing.
class TestLinuxCncLoops : public QObject {
    Q_OBJECT

    template <class Action>
    bool send(const Action& action) {
        Command command;
        command.action = action;
        const auto number = m_engine->send(command);
        return number && QTest::qWaitFor([&] {
                   const auto& recent = m_engine->status().recentCommands;
                   return std::ranges::any_of(recent, [&](const CommandResult& r) { return r.number == *number && r.done; });
               });
    }

 private slots:
    void initTestCase() {
        if (const QString why = test::LinuxCncControl::whyNot(); !why.isEmpty()) {
            QSKIP(qPrintable(why));
        }
        QVERIFY2(m_control.start(), m_control.log());
    }
    void init() {
        m_machine = std::make_unique<linuxcnc::LinuxCncMachine>(linuxcnc::LinuxCncMachine::Params{});
        QVERIFY(m_machine->connect().has_value());
        QVERIFY(m_machine->reached());
        std::vector<std::unique_ptr<ProcessLoop>> loops;
        loops.push_back(std::make_unique<BoringLoop>());
        loops.push_back(std::make_unique<MillingLoop>());
        loops.push_back(std::make_unique<TappingLoop>(*m_exchange));
        m_engine = std::make_unique<Engine>(*m_machine, std::move(loops));
        m_engine->start();
        QTRY_VERIFY(m_engine->status().link == LinkState::Up && m_machine->commandsReady());
    }
    void cleanup() {
        m_engine.reset();
        m_machine.reset();
    }

    void tuningTakesMostOfTheContourError() {
        QVERIFY(send(SetLoopMode{ProcessId::Tapping, LoopMode::Control}));
        QTRY_VERIFY(m_engine->status().tapping.drive.zKp_perS > 0.0);
        const ServoGains before = m_engine->status().tapping.drive;
        tapping::TunerSetup setup;
        setup.trim = false;
        setup.assumed = linuxcnc::assumedDrive(linuxcnc::kAssumedBandwidth_perS);
        setup.initial.spindleKp_perS = before.spindleKp_perS;
        setup.initial.zKp_perS = before.zKp_perS;
        TappingJob job;
        job.revision = 1;
        job.abortError_um = 2000.0;
        TuningSession session(*m_engine, *m_exchange, setup, job, true);
        QVERIFY(QTest::qWaitFor(
            [&] {
                session.poll();
                return session.state() == TuningSession::State::Done || session.state() == TuningSession::State::Failed;
            },
            60'000));
        for (const TuningSession::Trial& trial : session.trials()) {
            qInfo("gain %.1f 1/s, feed-forward %.3f, %.3f: SAEC %.2f mm, peak %.1f um, p-p %.1f um, %u samples, %u missing",
                  trial.settings.zKp_perS, trial.settings.zVelocityFf, trial.settings.zAccelFf, trial.figures.saec_mm,
                  trial.figures.peak_um, trial.figures.engagedPp_um, trial.figures.samples, trial.figures.missing);
        }
        QVERIFY2(session.state() == TuningSession::State::Done, session.reason().english().c_str());
        QVERIFY(session.trials().size() >= 2);
        const double first_mm = session.trials().front().figures.saec_mm;
        const double last_mm = session.trials().back().figures.saec_mm;
        qInfo("contour error less by %.1f %%", 100.0 * (1.0 - last_mm / first_mm));
        QVERIFY(last_mm <= 0.2 * first_mm);
    }

 private:
    test::LinuxCncControl m_control;
    std::unique_ptr<TapExchange> m_exchange{std::make_unique<TapExchange>()};
    std::unique_ptr<linuxcnc::LinuxCncMachine> m_machine;
    std::unique_ptr<Engine> m_engine;
};
QTEST_GUILESS_MAIN(TestLinuxCncLoops)
#include "tst_linuxcnc_loops.moc"
