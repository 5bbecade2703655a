// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <memory>
#include <thread>
#include <vector>

#include "engine/cycle/engine.h"
#include "engine/machine/linuxcnc/assumed_drive.h"
#include "engine/machine/linuxcnc/linuxcnc_machine.h"
#include "engine/process/boring/boring_loop.h"
#include "engine/process/boring/gcode_export.h"
#include "engine/process/milling/milling_loop.h"
#include "engine/process/tapping/tapping_loop.h"
#include "engine/process/tapping/tuning_session.h"
#include "tests/support/force_held.h"
#include "tests/support/lateness.h"
#include "tests/support/linuxcnc_control.h"

using namespace kerf;

/// The loops on LinuxCNC's own simulator: motion, spindle, G-code and HAL are the real thing.
class TestLinuxCncLoops : public QObject {
    Q_OBJECT

    [[nodiscard]] static BoringSchedule bore() {
        BoringSchedule schedule;
        schedule.revision = 1;
        schedule.lnC = std::log(0.0871);
        schedule.alpha = 0.5025;
        schedule.beta = 0.2676;
        schedule.targetDeflection_mm = 0.1165;
        schedule.overhangTo_mm = 60.0;
        schedule.spindleSpeed_rpm = 1500.0;
        return schedule;
    }
    template <class Action>
    bool send(const Action& action) {
        Command command;
        command.action = action;
        const auto number = m_engine->send(command);
        return number && QTest::qWaitFor([&] {
                   const auto& recent = m_engine->status().recentCommands;
                   return std::ranges::any_of(recent,
                                              [&](const CommandResult& r) { return r.number == *number && r.done; });
               });
    }

 private slots:
    void initTestCase() {
        if (const QString why = test::LinuxCncControl::whyNot(); !why.isEmpty()) {
            QSKIP(qPrintable(why));
        }
        QTemporaryDir folder;
        QFile subroutine(folder.filePath(QStringLiteral("kerf_schedule.ngc")));
        QVERIFY(subroutine.open(QIODevice::WriteOnly));
        const auto lines = boring::boringSubroutine(bore(), {});
        QVERIFY(lines.has_value());
        for (const std::string& line : *lines) {
            subroutine.write(line.c_str());
            subroutine.write("\n");
        }
        subroutine.close();
        QVERIFY2(m_control.start({QStringLiteral("--with"), subroutine.fileName()}), m_control.log());
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

    void exportedSubroutineCutsTheScheduleWithoutKerf() {
        m_engine->stop();
        const BoringSchedule schedule = bore();
        test::AtTheControl control;
        control.say("set mode mdi");
        control.say("set mdi o<kerf_schedule> call");
        // Feed per revolution from LinuxCNC's own velocity and spindle speed, past the acceleration at both ends.
        constexpr double kEnd_mm = 1.0;
        MachineInputs inputs;
        std::vector<double> deviations;
        double deepest_mm = 0.0;
        const double depth_mm = schedule.overhangTo_mm - schedule.overhangFrom_mm;
        const auto cut = [&] {
            m_machine->read(test::monotonic_ns(), inputs);
            const double z_mm = -inputs.position_mm[2].value;
            if (inputs.link == LinkState::Up && z_mm > kEnd_mm && z_mm < depth_mm - kEnd_mm && z_mm > deepest_mm) {
                const double feed_mmPerRev = 60.0 * inputs.actualFeed_mmPerS.value / inputs.spindleSpeed_rpm.value;
                deviations.push_back(feed_mmPerRev / schedule.feed_mmPerRev(schedule.overhangFrom_mm + z_mm) - 1.0);
            }
            deepest_mm = std::max(deepest_mm, z_mm);
            return deepest_mm > depth_mm - kEnd_mm && z_mm < 0.001;
        };
        const std::int64_t begin_ns = test::monotonic_ns();
        while (!cut() && test::monotonic_ns() - begin_ns < 30'000'000'000) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        QVERIFY2(deviations.size() > 100, control.ask("get error"));
        std::ranges::sort(deviations, {}, [](double d) { return std::abs(d); });
        qInfo("feed of the exported subroutine: %zu points, median %.2f %%, largest %.2f %%", deviations.size(),
              100.0 * std::abs(deviations[deviations.size() / 2]), 100.0 * std::abs(deviations.back()));
        QVERIFY(std::abs(deviations.back()) < 0.02);
    }
    void forceIsHeldWhileTheBlankSteps() {
        QVERIFY(m_engine->capabilities().forceSensor.fitted);
        MillingSetup setup;
        setup.revision = 1;
        setup.to_mm = 26.0;  // two of the five stairs: 1 and 2 mm
        QVERIFY(send(LoadMillingSetup{setup}));
        QVERIFY(send(SetLoopMode{ProcessId::Milling, LoopMode::Control}));
        QVERIFY(send(StartPart{ProcessId::Milling}));
        QTRY_VERIFY_WITH_TIMEOUT(m_engine->status().milling.cutting, 10'000);
        test::ForceHeld held(setup.reference_N);
        const auto done = [&] {
            const Status& status = m_engine->status();
            const MillingStatus& milling = status.milling;
            const bool inWork = milling.cutting && milling.position_mm > 5.0 && milling.position_mm < 24.0;
            if (inWork) {
                held.take(milling.force_N, status.actualFeed_mmPerS.value);
            }
            return milling.partsCut == 1;
        };
        QVERIFY(QTest::qWaitFor(done, 60'000));
        QVERIFY(held.revolutions() > 50);
        held.print("force");
        QVERIFY(held.within(0.5) < 0.05);
        QVERIFY(held.within(0.9) < 0.15);
        QVERIFY(held.feedRange() > 1.3);  // it is the feed that holds it
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
            qInfo(
                "gain %.1f 1/s, feed-forward %.3f, %.3f: SAEC %.2f mm, peak %.1f um, p-p %.1f um, %u samples, %u "
                "missing",
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
KERF_TEST_IN_TIME(TestLinuxCncLoops)
#include "tst_linuxcnc_loops.moc"
