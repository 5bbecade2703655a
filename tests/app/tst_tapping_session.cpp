// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "app/service/tapping/tapping_service.h"
#include "app/service/tapping/tapping_tuning_json.h"
#include "engine/process/tapping/tapping_alarms.h"
#include "tests/support/golden.h"
#include "tests/support/tapping_bench.h"

using namespace kerf;
using kerf::test::job;
using kerf::test::setup;
using kerf::test::TappingBench;

namespace {

SimulatedTapping::Params shopFloor() {
    SimulatedTapping::Params params;
    params.noise_um = 2.0;
    params.loadSpread = 0.2;
    params.frictionSpread = 0.1;
    return params;
}

constexpr std::int64_t kFirstRevision = 40;  ///< numbers that the store gives

/// Service and machine, polled now and then as the console does.
struct ServiceBench : TappingBench {
    explicit ServiceBench(const SimulatedTapping::Params& machineParams = {},
                          std::vector<tapping::StoredTuning> known = {},
                          const std::function<void(StoredTappingService&)>& atOnce = {})
        : TappingBench(machineParams) {
        StoredTappingService::Params params;
        params.known = std::move(known);
        params.store = [this](const tapping::StoredTuning& tuning, const tapping::TuningWords&,
                              const StoredTappingService::Params::Kept& done) {
            stored.push_back(tuning);
            if (done) done(kFirstRevision + static_cast<std::int64_t>(stored.size()));
        };
        service = std::make_unique<StoredTappingService>(*engine, *exchange, std::move(params));
        if (atOnce) atOnce(*service);
        service->poll();
        engine->runCycles(3);
    }
    template <class Condition>
    bool pollUntil(Condition condition, int most = 2000) {
        for (int i = 0; i < most; ++i) {
            engine->runCycles(50);
            service->poll();
            if (condition(service->view())) return true;
        }
        return false;
    }
    bool reaches(TuningState state) {
        return pollUntil([state](const TappingServiceView& view) { return view.state == state; });
    }
    bool tune(bool automatic = true) {
        return service->begin("Kim", automatic).has_value() && reaches(TuningState::Done);
    }
    std::unique_ptr<StoredTappingService> service;
    std::vector<tapping::StoredTuning> stored;
};

}  // namespace

/// Tuning outside the cycle: session and service on the simulated machine.
class TestTappingSession : public QObject {
    Q_OBJECT
 private slots:
    void sessionTunesWithinTolerance() {
        SimulatedTapping::Params params;
        params.noise_um = 2.0;
        params.loadSpread = 0.2;
        params.frictionSpread = 0.1;
        TappingBench bench(params);
        TuningSession session(*bench.engine, *bench.exchange, setup(params.drive), job(), true);
        for (int i = 0; i < 30'000 && session.state() != TuningSession::State::Done; ++i) {
            bench.engine->runCycles(1);
            session.poll();
            QVERIFY2(session.state() != TuningSession::State::Failed, session.reason().english().c_str());
        }
        QCOMPARE(session.state(), TuningSession::State::Done);
        QVERIFY(session.trials().size() <= 6);
        QVERIFY(session.trials().back().figures.saec_mm < 0.03 * session.trials().front().figures.saec_mm);
        bench.engine->runCycles(5);
        // Production with what was learned: the gains read back, the trim acts.
        QVERIFY(bench.runTap());
        QCOMPARE(bench.tapping().kind, TapKind::Production);
        QVERIFY(bench.tapping().last.engagedPp_um < 28.0);
        QCOMPARE(bench.tapping().productionTaps, 1U);
        KERF_CLOSE(bench.gains().zKp_perS, session.kept().zKp_perS, 1e-9);
        QVERIFY(bench.raised.empty());
    }

    void proposalWaitsForTheOperator() {
        TappingBench bench;
        TuningSession session(*bench.engine, *bench.exchange, setup({}), job(), false);
        const auto run = [&](TuningSession::State wanted) {
            for (int i = 0; i < 10'000 && session.state() != wanted; ++i) {
                bench.engine->runCycles(1);
                session.poll();
            }
            return session.state() == wanted;
        };
        QVERIFY(run(TuningSession::State::Proposed));
        const std::uint32_t taps = bench.tapping().taps;
        bench.engine->runCycles(2000);
        session.poll();
        QCOMPARE(bench.tapping().taps, taps);
        QVERIFY(!session.proposal().reason.empty());
        session.confirm();
        QVERIFY(run(TuningSession::State::Trial));
        QVERIFY(run(TuningSession::State::Proposed));
        session.rollBack();
        QCOMPARE(session.state(), TuningSession::State::Done);
        QVERIFY(bench.runTap());
        KERF_CLOSE(bench.gains().zKp_perS, 48.0, 1e-9);
    }

    void aTapThatDoesNotBeginEndsTheSession() {
        TappingBench bench;
        TuningSession session(*bench.engine, *bench.exchange, setup({}), job(), true);
        bench.engine->holdAll();
        for (int i = 0; i < 3000 && session.state() == TuningSession::State::Air; ++i) {
            bench.engine->runCycles(1);
            session.poll();
        }
        QCOMPARE(session.state(), TuningSession::State::Failed);
        QVERIFY(!session.reason().empty());
    }
    void tapsThatDoNotCountAreRepeatedThreeTimesAtMost() {
        TappingBench bench;
        TuningSession session(*bench.engine, *bench.exchange, setup({}), job(), true);
        std::uint64_t cycle = 0;
        InjectedFaults faults;
        faults.spindleAngle = SignalFault::Unplugged;
        for (int i = 0; i < 60'000 && session.state() != TuningSession::State::Failed; ++i, ++cycle) {
            bench.machine->inject(cycle % 50 < 5 ? faults : InjectedFaults{});  // 10 % of the samples
            bench.engine->runCycles(1);
            session.poll();
        }
        QCOMPARE(session.state(), TuningSession::State::Failed);
        QVERIFY(session.trials().empty());  // nothing was learned from them
        QCOMPARE(bench.tapping().taps, 3U);
    }

    void serviceLoadsTheMachinesOwnGainsAndShowsTheSafeSet() {
        ServiceBench bench;
        QCOMPARE(bench.service->view().thread.name, std::string("M8"));
        QCOMPARE(bench.service->view().source, GainsSource::Machine);
        KERF_CLOSE(bench.service->view().inForce.zKp_perS, 48.0, 1e-9);
        QVERIFY(bench.service->begin("Kim", false).has_value());
        QVERIFY(!bench.service->begin("Kim", false).has_value());  // one at a time
        QVERIFY(!bench.service->load({}, "Kim").has_value());
        QVERIFY(bench.pollUntil([&](const TappingServiceView& view) {
            if (view.state == TuningState::Proposed && !view.finished) {
                if (view.next.zKp_perS > view.highestZKp_perS || view.next.zKp_perS < view.lowestZKp_perS) return true;
                bench.service->oneMore("Kim");
            }
            return view.finished || view.state == TuningState::Failed;
        }));
        const TappingServiceView& view = bench.service->view();
        QCOMPARE(view.state, TuningState::Proposed);
        QVERIFY(view.finished);
        QVERIFY(bench.stored.empty());  // nobody has accepted
        bench.service->accept("Kim");
        QCOMPARE(view.state, TuningState::Done);
        QVERIFY(view.trials.size() >= 2);
        QCOMPARE(view.first.error_um.size(), 1180U);
        QVERIFY(view.first.reversal > 500 && view.first.reversal < 600);
        QVERIFY(view.trials.back().figures.engagedPp_um < view.thread.allowedPpWornTap_um);
        QVERIFY(view.criticalZKp_perS >= 2.0 * view.highestZKp_perS);
        QCOMPARE(view.speeds.size(), 1U);
        KERF_CLOSE(view.speeds.front().hole_s, 1.08, 1e-9);
        QCOMPARE(bench.stored.size(), 1U);
        QCOMPARE(bench.stored.front().proof.author, std::string("Kim"));
        QVERIFY(bench.stored.front().proof.reduction() > 0.95);
        KERF_CLOSE(bench.stored.front().own.zKp_perS, 48.0, 1e-9);
        QVERIFY(bench.stored.front().first.error_um.size() <= 241);
    }
    void automaticTunesToTheEndAndProductionIsShown() {
        ServiceBench bench(shopFloor());
        QVERIFY(bench.tune());
        QCOMPARE(bench.stored.size(), 1U);
        bench.engine->runCycles(5);
        for (int i = 0; i < 3; ++i) {
            QVERIFY(bench.runTap());
            bench.service->poll();
        }
        QCOMPARE(bench.service->view().productionSaec_mm.size(), 3U);
        QVERIFY(bench.tapping().last.engagedPp_um < 28.0);
        QCOMPARE(bench.tapping().kind, TapKind::Production);
    }
    void storedTuningComesBackOnlyForItsChoice_data() {
        QTest::addColumn<QString>("thread");
        QTest::addColumn<double>("speed_rpm");
        QTest::addColumn<double>("depth_rev");
        QTest::addColumn<int>("gear");
        QTest::addColumn<QString>("part");
        QTest::addColumn<QString>("tap");
        QTest::addColumn<int>("source");
        QTest::newRow("same") << "M8" << 3000.0 << 22.0 << 1 << "1"
                              << "1" << int(GainsSource::Stored);
        QTest::newRow("speed range") << "M8" << 3250.0 << 22.0 << 1 << "1"
                                     << "1" << int(GainsSource::StoredGains);
        QTest::newRow("other depth") << "M8" << 3000.0 << 16.0 << 1 << "1"
                                     << "1" << int(GainsSource::StoredGains);
        QTest::newRow("other speed") << "M8" << 4000.0 << 22.0 << 1 << "1"
                                     << "1" << int(GainsSource::Machine);
        QTest::newRow("other thread") << "M10" << 3000.0 << 22.0 << 1 << "1"
                                      << "1" << int(GainsSource::Machine);
        QTest::newRow("other gear") << "M8" << 3000.0 << 22.0 << 2 << "1"
                                    << "1" << int(GainsSource::Machine);
        QTest::newRow("other part") << "M8" << 3000.0 << 22.0 << 1 << "2"
                                    << "1" << int(GainsSource::Machine);
        QTest::newRow("other tap") << "M8" << 3000.0 << 22.0 << 1 << "1"
                                   << "2" << int(GainsSource::Machine);
    }
    void storedTuningComesBackOnlyForItsChoice() {
        QFETCH(QString, thread);
        QFETCH(double, speed_rpm);
        QFETCH(double, depth_rev);
        QFETCH(int, gear);
        QFETCH(QString, part);
        QFETCH(QString, tap);
        QFETCH(int, source);
        static const std::vector<tapping::StoredTuning> known = [] {
            ServiceBench bench;
            return bench.tune() ? bench.stored : std::vector<tapping::StoredTuning>{};
        }();
        QCOMPARE(known.size(), 1U);
        ServiceBench bench({}, known);  // a restart
        QCOMPARE(bench.service->view().source, GainsSource::Stored);
        const TapChoice choice{thread.toStdString(), speed_rpm,        depth_rev, static_cast<std::uint8_t>(gear),
                               part.toStdString(),   tap.toStdString()};
        QVERIFY(bench.service->load(choice, "Kim").has_value());
        QCOMPARE(static_cast<int>(bench.service->view().source), source);
        bench.engine->runCycles(3);
        QVERIFY(bench.runTap());
        QCOMPARE(bench.tapping().kind, TapKind::Air);
        QVERIFY(bench.runTap());
        QCOMPARE(bench.tapping().kind, TapKind::Production);
        if (source == int(GainsSource::Stored)) {
            QVERIFY2(bench.tapping().last.engagedPp_um < 10.0,
                     qPrintable(QString::number(bench.tapping().last.engagedPp_um)));
        } else if (source == int(GainsSource::StoredGains)) {  // without the trim: far better than 520 µm and more
            KERF_CLOSE(bench.gains().zKp_perS, known.front().settings.zKp_perS, 1e-9);
            QVERIFY2(bench.tapping().last.engagedPp_um < 130.0,
                     qPrintable(QString::number(bench.tapping().last.engagedPp_um)));
        } else {
            KERF_CLOSE(bench.gains().zKp_perS, 48.0, 1e-9);
        }
    }
    void aTuningIsLeftOutAndTakenInAgainWithAReason() {
        ServiceBench first;
        QVERIFY(first.tune());
        std::vector<tapping::StoredTuning> known = first.stored;
        {
            ServiceBench bench({}, known);
            QCOMPARE(bench.service->view().source, GainsSource::Stored);
            QVERIFY(!bench.service->leaveOut(true, "Lee", "").has_value());
            QVERIFY(!bench.service->leaveOut(true, "", "other oil").has_value());
            QVERIFY(!bench.service->leaveOut(false, "Lee", "nothing is out").has_value());
            QVERIFY(bench.service->leaveOut(true, "Lee", "other oil").has_value());
            QCOMPARE(bench.service->view().source, GainsSource::Machine);
            QCOMPARE(bench.service->view().leftOut, std::string("Lee: other oil"));
            KERF_CLOSE(bench.service->view().inForce.zKp_perS, 48.0, 1e-9);
            QCOMPARE(bench.stored.size(), 1U);
            const auto read = formats::tuningFromJson(formats::tuningToJson(bench.stored.back()));
            QVERIFY(read && read->leftOut == true && read->leftOutReason == "other oil" &&
                    read->leftOutAuthor == "Lee");
            known.push_back(*read);
        }
        ServiceBench again({}, known);  // a restart
        QCOMPARE(again.service->view().source, GainsSource::Machine);
        QVERIFY(again.service->leaveOut(false, "Lee", "it was the oil").has_value());
        QCOMPARE(again.service->view().source, GainsSource::Stored);
        QVERIFY(again.service->view().leftOut.empty());
        known.push_back(first.stored.back());  // the same, accepted anew behind the word against it: stands
        QCOMPARE(tapping::standing(known).size(), 1U);
    }
    void rollBackAfterAcceptingIsKeptToo() {
        ServiceBench bench;
        QVERIFY(bench.tune());
        bench.service->rollBack("Lee");
        QCOMPARE(bench.stored.size(), 2U);
        QVERIFY(bench.stored.back().proof.rolledBack);
        bench.engine->runCycles(3);
        QVERIFY(bench.runTap());
        KERF_CLOSE(bench.gains().zKp_perS, 48.0, 1e-9);
        ServiceBench again({}, bench.stored);
        KERF_CLOSE(again.service->view().inForce.zKp_perS, 48.0, 1e-9);
    }
    void abortDuringATrialBringsBackGainsAndTrim() {
        ServiceBench bench;
        QVERIFY(bench.tune());
        const std::size_t kept = bench.stored.size();
        QVERIFY(bench.service->begin("Kim", false).has_value());
        QVERIFY(bench.reaches(TuningState::Proposed));
        bench.service->oneMore("Kim");
        QVERIFY(bench.runUntil([](const TappingStatus& s) { return s.spindle_rev > 10.0; }));
        bench.service->abort();
        QVERIFY(bench.reaches(TuningState::Failed));
        bench.engine->runCycles(10);
        QVERIFY(bench.runTap());
        QCOMPARE(bench.tapping().kind, TapKind::Production);
        QVERIFY2(bench.tapping().last.engagedPp_um < 10.0,
                 qPrintable(QString::number(bench.tapping().last.engagedPp_um)));
        QCOMPARE(bench.stored.size(), kept);
    }
    void emergencyStopInATrialIsRecoveredFromTheService() {
        ServiceBench bench;
        QVERIFY(bench.service->begin("Kim", true).has_value());
        QVERIFY(bench.pollUntil([](const TappingServiceView& view) { return view.state == TuningState::Trial; }));
        QVERIFY(bench.runUntil([](const TappingStatus& s) { return s.spindle_rev > 12.0; }));
        InjectedFaults faults;
        faults.emergencyStop = true;
        bench.machine->inject(faults);
        QVERIFY(bench.reaches(TuningState::Failed));
        QVERIFY(!bench.service->load({}, "Kim").has_value());
        bench.machine->inject({});
        bench.engine->runCycles(5);
        // a person has looked: an emergency stop holds all loops until then
        Command looked;
        looked.action = ReleaseHold{};
        (void)bench.engine->send(looked);
        bench.engine->runCycles(5);
        bench.service->recover();
        QVERIFY(bench.runToIdle());
        QVERIFY(std::abs(bench.tapping().z_mm) < 0.1);
        QVERIFY(bench.service->load({}, "Kim").has_value());
        QVERIFY(bench.tune());
    }
    void badChoicesAreRefusedWithTheirRange() {
        ServiceBench bench;
        const std::uint64_t revision = bench.service->view().revision;
        QVERIFY(!bench.service->load({"M7x3", 3000.0, 22.0}, "Kim").has_value());
        QVERIFY(!bench.service->load({"M8", 5.0, 22.0}, "Kim").has_value());
        QVERIFY(!bench.service->load({"M8", std::nan(""), 22.0}, "Kim").has_value());
        QVERIFY(!bench.service->load({"M8", 3000.0, 0.5}, "Kim").has_value());
        QVERIFY(!bench.service->load({"M8", 3000.0, 22.0, 0}, "Kim").has_value());
        QVERIFY(!bench.service->load({"M8", 10.0, 100.0}, "Kim").has_value());  // ten minutes cannot be recorded
        QCOMPARE(bench.service->view().revision, revision);
    }
    /// Whatever is touched in the moment before the first job is handed over: it is handed over all the same.
    void aTouchBeforeTheFirstJobDoesNotKeepItOut_data() {
        QTest::addColumn<int>("touch");
        QTest::newRow("automatic") << 0;
        QTest::newRow("tune") << 1;
        QTest::newRow("roll back") << 2;
        QTest::newRow("the disk says no") << 3;
        QTest::newRow("its recipe was revised") << 4;
    }
    void aTouchBeforeTheFirstJobDoesNotKeepItOut() {
        QFETCH(int, touch);
        ServiceBench bench({}, {}, [touch](StoredTappingService& service) {
            if (touch == 0) service.setAutomatic(true, "Kim");
            if (touch == 1) QVERIFY(!service.begin("Kim", false).has_value());
            if (touch == 2) service.rollBack("Kim");
            if (touch == 3) service.setStoreProblem(Sentence("the disk is full"));
            if (touch == 4) service.recipeRevised(7);
        });
        QVERIFY(bench.service->view().loaded);
        QCOMPARE(bench.service->view().automatic, touch == 0);
        QCOMPARE(bench.tapping().job, 1U);
        QVERIFY(bench.tune());
    }
    void anotherSpeedIsAnotherPoint() {
        ServiceBench bench;
        QVERIFY(bench.tune());
        TapChoice faster = bench.service->view().choice;
        faster.speed_rpm = 4500.0;
        QVERIFY(bench.service->load(faster, "Kim").has_value());
        QVERIFY(bench.tune());
        const auto& speeds = bench.service->view().speeds;
        QCOMPARE(speeds.size(), 2U);
        QVERIFY(speeds[0].hole_s < speeds[1].hole_s);
        QVERIFY(speeds[0].current && !speeds[1].current);
        QVERIFY(bench.service->load(speeds[1].choice, "Kim").has_value());
        QCOMPARE(bench.service->view().source, GainsSource::Stored);
    }
    void aThinnedCurveKeepsItsReversal() {
        TapCurve curve;
        for (int i = 0; i < 1000; ++i) {
            curve.spindle_rev.push_back(static_cast<float>(i < 500 ? i : 999 - i));
            curve.error_um.push_back(static_cast<float>(i));
        }
        curve.reversal = 500;
        const TapCurve thin = tapping::thinned(curve, 240);
        QVERIFY(thin.error_um.size() <= 241);
        QVERIFY(std::abs(thin.error_um[thin.reversal] - 500.0F) < 6.0F);
        QCOMPARE(thin.error_um.back(), 999.0F);
    }
};

QTEST_GUILESS_MAIN(TestTappingSession)
#include "tst_tapping_session.moc"
