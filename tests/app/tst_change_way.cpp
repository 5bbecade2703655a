// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "app/service/boring/boring_lots.h"
#include "app/service/milling/milling_service.h"
#include "app/service/tapping/tapping_service.h"
#include "app/service/thermal/thermal_service.h"
#include "app/service/turning/turning_service.h"
#include "engine/process/tapping/drive_params.h"
#include "engine/process/tapping/trial_machine.h"
#include "tests/support/service_bench.h"

using namespace kerf;

namespace {

using Done = test::ServiceBench::Done;

/// All five services on one data file and one engine that a test answers for.
struct Shop : test::FiveServicesBench {
    Shop() {
        engine.caps.servoGains.fitted = true;
        engine.fake.cycle = 1;
        StoredBoringService::Links links{writer, engine, {}, [] { return LoopMode::Control; }};
        const BoringLotRequest first{
            "VB-1", "simulator", "Sleeve 50", BoringRecipe{}, "1", 30, boring::EstimatorKind::Kalman, "Kerf"};
        boring = std::make_unique<StoredBoringLots>(links, *reader, first);
        (void)wait([&](const Done& done) { boring->start(done); });
        milling = std::make_unique<StoredMillingService>(
            StoredMillingService::Links{writer, engine, [] { return std::string("Lee"); }, {}, {}}, *reader, *reader,
            *reader);
        turning = std::make_unique<StoredTurningService>(
            StoredTurningService::Links{writer, engine, *turningExchange, *reader, *reader, {}});
        StoredThermalService::Links heat{engine, writer, *thermalExchange};
        heat.dayFolder = scratch.path() + "-days";
        thermal = std::make_unique<StoredThermalService>(heat, *reader, *reader);
        StoredTappingService::Params taps;
        taps.store = [this](const tapping::StoredTuning& tuning, const tapping::TuningWords& words,
                            const StoredTappingService::Params::Kept& done) {
            writer.submit(KeepRecipe{ProcessId::Tapping, tuning.choice.thread, "{}", words.author, words.reason, {}},
                          [done](const Result<Receipt>& kept) {
                              done(kept ? Result<std::int64_t>(kept->id) : tl::unexpected(kept.error()));
                          });
        };
        tapping = std::make_unique<StoredTappingService>(engine, *tapExchange, std::move(taps));
        (void)tapping->load(TapChoice{}, "Lee");
        for (int i = 0; i < 3; ++i) {
            poll();
        }
    }
    ~Shop() {
        tapping.reset();
        thermal.reset();
        turning.reset();
        milling.reset();
        boring.reset();
    }
    /// As the bench's; `afterAsking` is done as soon as something was asked for.
    Result<void> wait(const std::function<void(const Done&)>& call) {
        return FiveServicesBench::wait([&](const Done& done) {
            call(done);
            if (afterAsking) {
                afterAsking();
            }
        });
    }
    void poll() {
        boring->poll();
        milling->poll();
        turning->poll();
        thermal->poll();
        tapping->poll();
    }
    /// A part of the lot is bored; its bore waits.
    void bore() {
        PartRecord record;
        record.partSequence = ++bored;
        record.begin_ns = bored * 60'000'000'000LL;
        record.end_ns = record.begin_ns + 40'000'000'000LL;
        record.schedule = boring->service().view().nextSchedule;
        record.order.lot = reader->activeLot(ProcessId::Boring)->value();
        const std::size_t before = boring->service().view().parts.size();
        QVERIFY(ring.tryPush(record));
        QVERIFY(QTest::qWaitFor([&] { return boring->service().view().parts.size() > before; }));
    }
    Result<void> measure(double deviation_mm) {
        const BoringServiceView& view = boring->service().view();
        BoreEntry entry;
        entry.part = view.awaiting.value_or(0);
        entry.depth = view.awaitingDepth;
        entry.diameter_mm = view.targetDiameter_mm + deviation_mm;
        entry.author = "Kim";
        entry.confirmed = true;
        return wait([&](const Done& done) { boring->service().enter(entry, done); });
    }

    std::unique_ptr<StoredBoringLots> boring;
    std::unique_ptr<StoredMillingService> milling;
    std::unique_ptr<StoredTurningService> turning;
    std::unique_ptr<StoredThermalService> thermal;
    std::unique_ptr<StoredTappingService> tapping;
    std::uint32_t bored{0};
    std::function<void()> afterAsking{};
};

/// What one process calls a change, and what it says of it.
struct OneOfFive {
    std::function<Result<void>(int nth)> change;  ///< another one each time
    std::function<Result<void>()> wrong;          ///< of values that cannot be
    std::function<bool(const Command&)> isLoad;   ///< the command that the change ends in
    std::function<Sentence()> problem;
    std::function<bool()> underWay;  ///< a start would be of something else than what was stored last
};

template <class Load>
bool is(const Command& command) {
    return std::holds_alternative<Load>(command.action);
}

OneOfFive processOf(Shop& shop, const QString& name) {
    if (name == QStringLiteral("boring")) {
        return {[&shop](int nth) {
                    shop.bore();
                    return shop.measure(0.02 + 0.004 * nth);
                },
                [&shop] { return shop.measure(-60.0); }, is<LoadBoringSchedule>,
                [&shop] { return shop.boring->service().view().storeProblem; },
                [&shop] { return shop.boring->underWay(); }};
    }
    if (name == QStringLiteral("milling")) {
        const auto save = [&shop](double reference_N) {
            MillingSetup setup = shop.milling->view().setup;
            setup.reference_N = reference_N;
            return shop.wait([&](const Done& done) { shop.milling->saveSetup(setup, "Lee", "drawing", done); });
        };
        return {[save](int nth) { return save(300.0 + nth); }, [save] { return save(-1.0); }, is<LoadMillingSetup>,
                [&shop] { return shop.milling->view().problem; }, [&shop] { return shop.milling->underWay(); }};
    }
    if (name == QStringLiteral("turning")) {
        const auto save = [&shop](double depth_um) {
            TurningSetup setup = shop.turning->view().setup;
            setup.depth_um = depth_um;
            return shop.wait([&](const Done& done) { shop.turning->loadSetup(setup, "Lee", "drawing", done); });
        };
        return {[save](int nth) { return save(4.0 + 0.1 * nth); }, [save] { return save(-1.0); }, is<LoadTurningSetup>,
                [&shop] { return shop.turning->view().storeProblem; }, [&shop] { return shop.turning->underWay(); }};
    }
    if (name == QStringLiteral("thermal")) {
        const auto save = [&shop](double allowed_um) {
            ThermalSetup setup = shop.thermal->view().setup;
            setup.allowed_um = allowed_um;
            return shop.wait([&](const Done& done) { shop.thermal->changeSetup(setup, "Lee", "drawing", done); });
        };
        return {[save](int nth) { return save(5.0 + 0.5 * nth); }, [save] { return save(-1.0); }, is<LoadThermalSetup>,
                [&shop] { return shop.thermal->view().storeProblem; }, [&shop] { return shop.thermal->underWay(); }};
    }
    const auto restore = [&shop](double speed_rpm) {
        tapping::StoredTuning tuning;
        tuning.choice = shop.tapping->view().choice;
        tuning.settings = tapping::settingsOf(tapping::middlingDrive());
        tuning.settings.zKp_perS += 0.1 * speed_rpm;
        return shop.wait([&](const Done& done) { shop.tapping->takeBack(tuning, 1, "Lee", "it was better", done); });
    };
    const auto wrong = [&shop] {
        TapChoice choice = shop.tapping->view().choice;
        choice.speed_rpm = -1.0;
        return shop.tapping->load(choice, "Lee");
    };
    return {[restore](int nth) { return restore(nth); }, wrong, is<LoadTapGains>,
            [&shop] { return shop.tapping->view().reason; },
            [&shop] { return shop.tapping->way().busy() || shop.tapping->way().underWay(); }};
}

/// The loops have what was sent last of each kind, as their status says it.
void showInStatus(test::FakeEngine& engine) {
    Status& status = engine.fake;
    for (const Command& command : engine.commands) {
        if (const auto* schedule = std::get_if<LoadBoringSchedule>(&command.action)) {
            status.boring.nextSchedule = schedule->schedule.revision;
        } else if (const auto* milled = std::get_if<LoadMillingSetup>(&command.action)) {
            status.milling.setup = milled->setup.revision;
            status.milling.law = milled->setup.law;
            status.milling.reference_N = milled->setup.reference_N;
        } else if (const auto* blank = std::get_if<LoadMillingBlank>(&command.action)) {
            status.milling.blank = blank->blank.revision;
        } else if (const auto* turned = std::get_if<LoadTurningSetup>(&command.action)) {
            status.turning.nextSetup = turned->setup.revision;
        } else if (const auto* heat = std::get_if<LoadThermalSetup>(&command.action)) {
            status.thermal.setup = heat->setup.revision;
        } else if (const auto* job = std::get_if<LoadTappingJob>(&command.action)) {
            status.tapping.job = job->job.revision;
        } else if (const auto* gains = std::get_if<LoadTapGains>(&command.action)) {
            status.tapping.nextGains = gains->gains.revision;
        }
    }
}

/// So many others are answered that an echo of before has gone by.
void answerOthers(test::FakeEngine& engine) {
    engine.answer = true;
    for (std::size_t i = 0; i < engine.fake.recentCommands.size(); ++i) {
        Command other;
        other.action = SetSimulationSpeed{1.0};
        (void)engine.send(other);
    }
}

}  // namespace

/// One way of a change in every process: may it be, kept, sent, taken, shown; whoever says no is heard.
class TestChangeWay : public QObject {
    Q_OBJECT
    static void five() {
        QTest::addColumn<QString>("name");
        for (const char* name : {"boring", "milling", "turning", "thermal", "tapping"}) {
            QTest::newRow(name) << QString::fromUtf8(name);
        }
    }
    static std::size_t loads(const Shop& shop, const OneOfFive& process) {
        return static_cast<std::size_t>(std::ranges::count_if(shop.engine.commands, process.isLoad));
    }

 private slots:
    void aChangeIsKeptThenTaken_data() { five(); }
    void aChangeIsKeptThenTaken() {
        QFETCH(QString, name);
        Shop shop;
        const OneOfFive process = processOf(shop, name);
        const std::size_t before = loads(shop, process);
        QVERIFY(process.change(1));
        QCOMPARE(loads(shop, process), before + 1);
        for (int i = 0; i < 30; ++i) {
            shop.poll();
        }
        QCOMPARE(loads(shop, process), before + 1);  // it was taken: nobody asks twice
        QVERIFY2(process.problem().empty(), process.problem().english().c_str());
    }
    void whatCannotBeReachesNeitherDiskNorEngine_data() { five(); }
    void whatCannotBeReachesNeitherDiskNorEngine() {
        QFETCH(QString, name);
        Shop shop;
        const OneOfFive process = processOf(shop, name);
        const std::size_t before = loads(shop, process);
        const auto revisions = shop.reader->recipes(1)->size();
        const auto refused = process.wrong();
        QVERIFY(!refused && !refused.error().empty());
        shop.poll();
        QCOMPARE(loads(shop, process), before);
        QCOMPARE(shop.reader->recipes(1)->size(), revisions);
    }
    void whatTheDiskRefusesTheEngineNeverHears_data() { five(); }
    void whatTheDiskRefusesTheEngineNeverHears() {
        QFETCH(QString, name);
        Shop shop;
        const OneOfFive process = processOf(shop, name);
        if (name == QStringLiteral("boring")) {
            shop.bore();
        }
        const std::size_t before = loads(shop, process);
        {
            const db::Connection other(shop.scratch.path(), db::Access::Write);
            for (const char* table : {"recipe_revisions", "measurements"}) {
                const QString sql = QStringLiteral(
                    "CREATE TRIGGER no_more_%1 BEFORE INSERT ON %1 BEGIN SELECT RAISE(ABORT, 'no'); END");
                QVERIFY(test::tryExecute(other.database(), sql.arg(QLatin1String(table)).toUtf8()));
            }
        }
        const auto refused = name == QStringLiteral("boring") ? shop.measure(0.02) : process.change(1);
        QVERIFY(!refused);
        shop.poll();
        QCOMPARE(loads(shop, process), before);
        QVERIFY(!process.problem().empty());
    }
    void whatTheEngineRefusesIsToldAndTriedAgain_data() { five(); }
    void whatTheEngineRefusesIsToldAndTriedAgain() {
        QFETCH(QString, name);
        Shop shop;
        const OneOfFive process = processOf(shop, name);
        shop.engine.refuseWith = Sentence("A part is being cut.");
        const std::size_t before = loads(shop, process);
        QVERIFY(process.change(1));
        shop.poll();
        QCOMPARE(process.problem().english(), std::string("A part is being cut."));
        const std::size_t once = loads(shop, process);
        QCOMPARE(once, before + 1);
        shop.poll();
        QCOMPARE(loads(shop, process), once);  // nothing has moved on: no use in asking
        shop.engine.refuseWith = {};
        ++shop.engine.fake.partSequence;
        shop.poll();
        QCOMPARE(loads(shop, process), once + 1);
        shop.poll();
        shop.poll();
        QCOMPARE(loads(shop, process), once + 1);
        if (name != QStringLiteral("tapping")) {  // its reason stands until the next thing is said
            QVERIFY2(process.problem().empty(), process.problem().english().c_str());
        }
    }
    void aLostEchoIsAskedForAgainALateOneOfOthersIsNone_data() { five(); }
    void aLostEchoIsAskedForAgainALateOneOfOthersIsNone() {
        QFETCH(QString, name);
        Shop shop;
        const OneOfFive process = processOf(shop, name);
        const std::size_t before = loads(shop, process);
        shop.engine.answer = false;
        QVERIFY(process.change(1));
        QCOMPARE(loads(shop, process), before + 1);
        // An answer to an order of before comes late, and is a no.
        CommandResult late = CommandResult::refused(Sentence("not this one"));
        late.number = 1;
        shop.engine.fake.recentCommands[0] = late;
        shop.poll();
        QCOMPARE(loads(shop, process), before + 1);
        QVERIFY(process.problem().english() != "not this one");
        // So many others are answered that this one's echo has gone by.
        answerOthers(shop.engine);
        shop.poll();
        QCOMPARE(loads(shop, process), before + 2);
        shop.poll();
        shop.poll();
        QCOMPARE(loads(shop, process), before + 2);
    }
    /// The answer is lost; the status shows that it was done. What is chosen afterwards must stand.
    void whatTheStatusShowsIsNotSentAgain_data() { five(); }
    void whatTheStatusShowsIsNotSentAgain() {
        QFETCH(QString, name);
        Shop shop;
        const OneOfFive process = processOf(shop, name);
        for (const bool seenBefore : {true, false}) {  // by a tick before the answer has gone by, or in the same one
            shop.engine.answer = false;
            const std::size_t before = loads(shop, process);
            QVERIFY(process.change(seenBefore ? 1 : 2));
            QCOMPARE(loads(shop, process), before + 1);
            showInStatus(shop.engine);
            if (seenBefore) {
                shop.poll();
            }
            // Another lot is named, law and reference are changed at the machine, an air tap is made.
            WorkOrder newer{77, 0, 0};
            shop.engine.fake.milling.law = MillingLaw::Constant;
            shop.engine.fake.milling.reference_N += 25.0;
            if (seenBefore) {
                for (WorkOrder& order : shop.engine.fake.orders) {
                    order = newer;
                }
            }
            answerOthers(shop.engine);
            shop.engine.fake.link = LinkState::Down;
            shop.poll();
            shop.engine.fake.link = LinkState::Up;
            for (int i = 0; i < 30; ++i) {
                shop.poll();
            }
            QCOMPARE(loads(shop, process), before + 1);
            QVERIFY2(process.problem().empty(), process.problem().english().c_str());
        }
    }
    /// From when it was asked for until the engine has it. A no ends the rest as well: what is loaded may be cut.
    void aStartRestsUntilTheNewestIsTaken_data() { five(); }
    void aStartRestsUntilTheNewestIsTaken() {
        QFETCH(QString, name);
        Shop shop;
        const OneOfFive process = processOf(shop, name);
        showInStatus(shop.engine);
        shop.poll();
        QVERIFY(!process.underWay());
        int looked = 0;
        shop.afterAsking = [&] {  // on its way to the disk
            ++looked;
            QVERIFY(process.underWay());
        };
        shop.engine.answer = false;
        QVERIFY(process.change(1));
        QCOMPARE(looked, 1);
        QVERIFY(process.underWay());  // on its way to the engine
        shop.poll();
        QVERIFY(process.underWay());
        showInStatus(shop.engine);
        shop.poll();
        shop.poll();
        QVERIFY(!process.underWay());
        shop.engine.answer = true;
        shop.engine.refuseWith = Sentence("A part is being cut.");
        QVERIFY(process.change(2));
        shop.poll();
        QVERIFY(!process.problem().empty());
        QVERIFY(!process.underWay());
    }
    /// Refused because a part had just begun, and done since: by another way, or by somebody else.
    void whatWasRefusedAndIsShownSinceIsNotSentAgain_data() { five(); }
    void whatWasRefusedAndIsShownSinceIsNotSentAgain() {
        QFETCH(QString, name);
        Shop shop;
        const OneOfFive process = processOf(shop, name);
        const std::size_t before = loads(shop, process);
        shop.engine.refuseWith = Sentence("A part is being cut.");
        QVERIFY(process.change(1));
        shop.poll();
        QCOMPARE(process.problem().english(), std::string("A part is being cut."));
        showInStatus(shop.engine);
        for (const Command& command : shop.engine.commands) {  // whose work it is, with it
            if (const auto* schedule = std::get_if<LoadBoringSchedule>(&command.action)) {
                shop.engine.fake.orders[static_cast<std::size_t>(ProcessId::Boring)] = *schedule->order;
            }
        }
        shop.engine.refuseWith = {};
        ++shop.engine.fake.partSequence;
        for (int i = 0; i < 30; ++i) {
            shop.poll();
        }
        QCOMPARE(loads(shop, process), before + 1);
    }
    /// A setup comes a moment after a part has begun. Law and reference are chosen while that is cut: the setup, taken
    /// after the part, brings neither back, and what was chosen is kept.
    void aSetupRefusedAtTheBeginOfAPartUndoesNothingChosenSince_data() {
        QTest::addColumn<bool>("law");
        QTest::addColumn<bool>("reference");
        QTest::newRow("law") << true << false;
        QTest::newRow("reference") << false << true;
        QTest::newRow("both") << true << true;
        QTest::newRow("neither") << false << false;
    }
    void aSetupRefusedAtTheBeginOfAPartUndoesNothingChosenSince() {
        QFETCH(bool, law);
        QFETCH(bool, reference);
        Shop shop;
        showInStatus(shop.engine);  // a setup is in force
        shop.poll();
        MillingSetup setup = shop.milling->view().setup;
        setup.law = MillingLaw::Model;
        setup.reference_N = 300.0;
        setup.ky_NPerMm += 50.0;
        shop.engine.refuseWith = Sentence("A part is being cut.");
        QVERIFY(shop.wait([&](const Done& done) { shop.milling->saveSetup(setup, "Lee", "drawing", done); }));
        shop.poll();
        MillingStatus& milling = shop.engine.fake.milling;
        const auto revisions = [&shop] {
            const auto all = shop.reader->allRecipes(ProcessId::Milling);
            return all ? all->size() : 0;
        };
        const auto stored = revisions();
        milling.law = law ? MillingLaw::Constant : milling.law;
        milling.reference_N = reference ? 425.0 : milling.reference_N;
        shop.poll();
        shop.engine.refuseWith = {};
        ++shop.engine.fake.partSequence;
        shop.poll();
        const auto again =
            std::ranges::find_if(shop.engine.commands.rbegin(), shop.engine.commands.rend(), is<LoadMillingSetup>);
        const MillingSetup& sent = std::get<LoadMillingSetup>(again->action).setup;
        QCOMPARE(sent.law, law ? MillingLaw::Constant : MillingLaw::Model);
        QCOMPARE(sent.reference_N, reference ? 425.0 : 300.0);
        QCOMPARE(sent.ky_NPerMm, setup.ky_NPerMm);
        showInStatus(shop.engine);
        shop.poll();
        QTRY_COMPARE(revisions(), stored + (law || reference ? 1 : 0));
        QCOMPARE(shop.milling->view().setup.law, sent.law);
        QCOMPARE(shop.milling->view().setup.reference_N, sent.reference_N);
    }
    void anOrderNamedFirstDoesNotReplaceTheOneOfALaterLoad() {
        Shop shop;
        const auto names = [&shop] { return std::ranges::count_if(shop.engine.commands, is<NameOrder>); };
        shop.engine.answer = false;
        BoringLotOrder next;
        next.partType = shop.boring->partTypes()->front().id;
        next.name = "2";
        next.author = "Lee";
        QVERIFY(shop.wait([&](const Done& done) { shop.boring->open(next, done); }));
        const auto named = names();
        const WorkOrder inForce = shop.engine.fake.orders[static_cast<std::size_t>(ProcessId::Boring)];
        QVERIFY(inForce.schedule > 0);  // of the schedule that went after it
        answerOthers(shop.engine);
        for (int i = 0; i < 5; ++i) {
            shop.poll();
        }
        QCOMPARE(names(), named);
        QVERIFY(shop.engine.fake.orders[static_cast<std::size_t>(ProcessId::Boring)] == inForce);
    }
    void whatIsSentAgainNamesTheNewestOrder() {
        test::FakeEngine engine;
        ChangeWay way(engine, [] {});
        engine.answer = false;
        const auto never = [](const Status&) { return false; };
        way.owe(LoadTappingJob{{}, WorkOrder{1, 1, 0}}, never);
        way.owe(NameOrder{ProcessId::Tapping, {2, 1, 0}}, never);
        way.owe(NameOrder{ProcessId::Milling, {3, 1, 0}}, never);
        answerOthers(engine);
        way.poll();
        way.poll();
        QVERIFY(way.settled());
        QVERIFY((engine.fake.orders[static_cast<std::size_t>(ProcessId::Tapping)] == WorkOrder{2, 1, 0}));
        const auto again = std::ranges::find_if(engine.commands.rbegin(), engine.commands.rend(), is<LoadTappingJob>);
        QCOMPARE(std::get<LoadTappingJob>(again->action).order->lot, std::int64_t{2});
    }
    /// A zero that was measured after the start is not replaced by the one that was kept.
    void aZeroThatWasTakenSinceStays() {
        test::FakeEngine engine;
        ChangeWay way(engine, [] {});
        engine.answer = false;
        const auto known = [](const Status& status) { return status.thermal.gapZeroKnown; };
        way.owe(LoadGapZero{{1.0, 2.0, 3.0}}, known);
        engine.fake.thermal.gapZeroKnown = true;
        engine.fake.thermal.gapZero_um = {7.0, 7.0, 7.0};
        answerOthers(engine);
        way.poll();
        QVERIFY(way.settled());
        QCOMPARE(std::ranges::count_if(engine.commands, is<LoadGapZero>), 1);
    }
};

QTEST_GUILESS_MAIN(TestChangeWay)
#include "tst_change_way.moc"
