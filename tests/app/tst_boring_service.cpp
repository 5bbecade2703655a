// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <QCoreApplication>
#include <QTest>
#include <cmath>
#include <limits>

#include "app/service/boring/boring_service.h"
#include "db/writer_thread.h"
#include "engine/process/boring/boring_alarms.h"
#include "engine/process/boring/plant.h"
#include "tests/db/db_test_support.h"
#include "tests/support/fake_engine.h"

using namespace kerf;

namespace {

constexpr db::WriterThread::Options kQuick{.queueCapacity = 64, .ringPoll_ms = 1, .retry_ms = 2};
constexpr double kSigma_mm = 0.005;

std::string text(const Sentence& sentence) {
    return sentence.english();
}

std::string text(const Predictions& predictions) {
    std::string out;
    for (const auto& one : predictions) {
        out += one ? fmt::format("({:.17g} {:.17g})", one->diameter_mm, one->half95_mm) : "(-)";
    }
    return out;
}

std::string text(const BoringSchedule& s) {
    return fmt::format("{} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}", s.revision, s.lnC, s.alpha, s.beta,
                       s.targetDeflection_mm, s.constantFeed_mmPerRev, s.minFeed_mmPerRev, s.maxFeed_mmPerRev);
}

/// All that the page can see but the view's own revision, to the last digit.
std::string text(const BoringServiceView& v) {
    std::string out = fmt::format("{} {} {} {} {} {}\n", v.partType, v.lot, v.lotSize, v.targetDiameter_mm,
                                  v.lowerTolerance_mm, v.upperTolerance_mm);
    for (const auto& part : v.parts) {
        out += fmt::format("part {} {} cut {} complete {} perturbed {} {} schedule {} predicted {} trace {}", part.id,
                           part.number, part.cut, part.complete, part.perturbed, text(part.perturbedReason),
                           text(part.schedule), text(part.predicted), part.feed.count);
        for (std::size_t i = 0; i < part.feed.count; ++i) {
            out += fmt::format(" {}:{}", part.feed.overhang_mm[i], part.feed.feed_mmPerRev[i]);
        }
        for (const auto& m : part.measurements) {
            out += fmt::format("\n  {} {} {:.17g} {} {}", m.id, m.depth, m.diameter_mm, m.voided, m.corrected);
        }
        out += '\n';
    }
    for (const auto& e : v.estimates) {
        out += fmt::format("estimate {} {:.17g} {:.17g} {:.17g} {:.17g}\n", e.part, e.value[0], e.value[1], e.value[2],
                           e.half95[0]);
    }
    out += fmt::format("next {} {} {} limited {} accepted {} awaiting {} {} {} {}\n", text(v.nextSchedule),
                       text(v.nextPrediction), text(v.nextReason), v.nextLimited, v.scheduleAccepted,
                       v.awaiting.value_or(0), v.awaitingDepth, v.estimator, text(v.storeProblem));
    return out;
}

/// Runs the event loop until it has happened; the test's own time limit ends a wait for ever.
template <class Condition>
void waitUntil(const Condition& happened) {
    while (!happened()) {
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
}

/// A service on a real database, with a machine that bores by the true law and an operator who measures.
class Bench {
 public:
    explicit Bench(LoopMode mode = LoopMode::Control, boring::EstimatorKind kind = boring::EstimatorKind::Kalman)
        : loopMode(mode) {
        startWriter();
        BoringLotRequest request{"VB-1", "simulator", "Sleeve 50", {}, "12", 30, kind, "Lee"};
        std::optional<Result<LotId>> opened;
        openBoringLot(*m_writer, request, [&](const Result<LotId>& result) { opened = result; });
        waitUntil([&] { return opened.has_value(); });
        m_lot = opened->value();
        openService();
    }
    ~Bench() { close(); }

    void restart() {
        close();
        engine = std::make_unique<test::FakeEngine>();
        startWriter();
        openService();
    }
    void close() {
        service.reset();
        m_reader.reset();
        if (m_writer) {
            m_writer->stop();
            m_writer.reset();
        }
    }
    /// The machine bores one part with the schedule it has been given; `cut` changes the record on its way.
    void bore(const std::function<void(PartRecord&)>& cut = {}) {
        PartRecord record;
        record.partSequence = ++m_sequence;
        record.begin_ns = m_sequence * 60'000'000'000LL;
        record.end_ns = record.begin_ns + 40'000'000'000LL;
        record.schedule = loaded();
        record.order = engine->fake.orders[static_cast<std::size_t>(ProcessId::Boring)];
        record.feed.count = kFeedTracePoints;
        for (std::size_t i = 0; i < kFeedTracePoints; ++i) {
            const double overhang_mm = 40.0 + 270.0 * static_cast<double>(i) / (kFeedTracePoints - 1);
            record.feed.overhang_mm[i] = static_cast<float>(overhang_mm);
            record.feed.feed_mmPerRev[i] = static_cast<float>(record.schedule.feed_mmPerRev(overhang_mm));
        }
        if (cut) {
            cut(record);
        }
        m_records.push_back(record);
        const std::size_t before = service->view().parts.size();
        QVERIFY(m_ring.tryPush(record));
        waitUntil([&] { return service->view().parts.size() > before; });
    }
    [[nodiscard]] BoringSchedule loaded() const {
        for (auto command = engine->commands.rbegin(); command != engine->commands.rend(); ++command) {
            if (const auto* load = std::get_if<LoadBoringSchedule>(&command->action)) {
                return load->schedule;
            }
        }
        return {};
    }
    /// What the gauge shows at a depth of the lot's n-th part (from 1): the same bore reads the same.
    [[nodiscard]] double gauged_mm(std::uint32_t part, std::uint8_t depth) const {
        const PartRecord& record = m_records[part - 1];
        const double overhang_mm = depth == 0 ? 40.0 : 310.0;
        const double feed_mmPerRev = boring::cutFeed_mmPerRev({part, record.schedule, record.feed}, overhang_mm);
        Random noise = Random(5).stream(part).stream(depth);
        const double d_mm =
            boring::deflection_mm(truth.at(part), feed_mmPerRev, overhang_mm) + kSigma_mm * noise.gauss();
        return boring::diameterFromDeflection_mm(d_mm, 50.0, boring::kTableTargetDeflection_mm, boring::kTablePhi_deg);
    }
    [[nodiscard]] BoreEntry entry(std::uint32_t part, std::uint8_t depth) const {
        BoreEntry out;
        out.part = idOf(part);
        out.depth = depth;
        out.diameter_mm = gauged_mm(part, depth);
        out.author = "Kim";
        return out;
    }
    [[nodiscard]] PartId idOf(std::uint32_t number) const {
        for (const auto& part : service->view().parts) {
            if (part.number == number) {
                return part.id;
            }
        }
        return 0;
    }
    /// Waits for the answer to one call.
    template <class Call>
    Result<void> wait(const Call& call) {
        std::optional<Result<void>> result;
        call([&](const Result<void>& answer) { result = answer; });
        waitUntil([&] { return result.has_value(); });
        return *result;
    }
    Result<void> enter(const BoreEntry& e) {
        return wait([&](const BoringService::Done& done) { service->enter(e, done); });
    }
    void boreAndMeasure() {
        bore();
        const auto part = static_cast<std::uint32_t>(m_records.size());
        for (const std::uint8_t depth : {std::uint8_t{0}, std::uint8_t{1}}) {
            const auto done = enter(entry(part, depth));
            QVERIFY2(done.has_value(), done ? "" : done.error().english().c_str());
        }
    }
    [[nodiscard]] std::int64_t count(const char* sql) const {
        const db::Connection reader(m_scratch.path(), db::Access::Read);
        return db::integerOf(reader.database(), QString::fromUtf8(sql));
    }
    [[nodiscard]] MeasurementId measurement(std::uint32_t part, std::uint8_t depth) const {
        for (const auto& p : service->view().parts) {
            for (const auto& m : p.measurements) {
                if (p.number == part && m.depth == depth && !m.voided) {
                    return m.id;
                }
            }
        }
        return 0;
    }
    [[nodiscard]] const test::ScratchDatabase& scratch() const { return m_scratch; }

    LoopMode loopMode;
    boring::TruthPlan truth{boring::TruthPlan::table()};
    std::unique_ptr<test::FakeEngine> engine{std::make_unique<test::FakeEngine>()};
    std::unique_ptr<StoredBoringService> service{};

 private:
    void startWriter() {
        m_writer = std::make_unique<db::WriterThread>(m_scratch.path(), &m_ring, kQuick);
        QVERIFY(m_writer->start().has_value());
    }
    void openService() {
        auto reader = db::DatabaseReader::open(m_scratch.path());
        QVERIFY(reader.has_value());
        m_reader = std::move(*reader);
        auto opened =
            StoredBoringService::open({*m_writer, *engine, {}, [this] { return loopMode; }}, *m_reader, m_lot);
        QVERIFY2(opened.has_value(), opened ? "" : opened.error().english().c_str());
        service = std::move(*opened);
    }

    test::ScratchDatabase m_scratch;
    SpscRing<PartRecord> m_ring{64};
    std::unique_ptr<db::WriterThread> m_writer{};
    std::unique_ptr<db::DatabaseReader> m_reader{};
    std::vector<PartRecord> m_records{};
    LotId m_lot{0};
    std::uint32_t m_sequence{0};
};

}  // namespace

/// The service: stored first, then accepted, then sent; the same after a restart.
class TestBoringService : public QObject {
    Q_OBJECT
 private slots:
    void wholeLotWithTypoCorrectionChangeAndRestart() {
        Bench bench;
        bench.truth = {{{1, boring::TruthPlan::paper().at(1)}, {7, boring::TruthPlan::paper().at(11)}}, 0.0};
        QCOMPARE(bench.loaded().constantFeed_mmPerRev, 0.5);
        for (int part = 1; part <= 4; ++part) {
            bench.boreAndMeasure();
        }
        // A slip of a decade in what is missing to the target: asked, and nothing stored.
        bench.bore();
        BoreEntry typo = bench.entry(5, 0);
        typo.diameter_mm = 50.0 - 10.0 * (50.0 - typo.diameter_mm) - 1.0;
        const auto rows = bench.count("SELECT count(*) FROM measurements");
        QCOMPARE(bench.service->check(typo).verdict, EntryVerdict::Ask);
        QVERIFY(!bench.enter(typo));
        QCOMPARE(bench.count("SELECT count(*) FROM measurements"), rows);
        QVERIFY(bench.enter(bench.entry(5, 0)));

        // In the middle of part 5 the power goes.
        const std::string before = text(bench.service->view());
        bench.restart();
        QCOMPARE(QString::fromStdString(text(bench.service->view())), QString::fromStdString(before));
        QVERIFY(bench.service->restartFinding().empty());
        QCOMPARE(bench.loaded().revision, bench.service->view().nextSchedule.revision);
        QCOMPARE(bench.service->view().awaitingDepth, std::uint8_t{1});
        QVERIFY(bench.enter(bench.entry(5, 1)));

        // A wrong value that was believed: corrected later, everything after it computed again.
        bench.bore();
        BoreEntry wrong = bench.entry(6, 0);
        wrong.diameter_mm -= 0.04;
        QVERIFY(bench.enter(wrong));
        QVERIFY(bench.enter(bench.entry(6, 1)));
        const auto id = bench.measurement(6, 0);
        const auto corrected = bench.wait([&](const BoringService::Done& done) {
            bench.service->correct(id, bench.gauged_mm(6, 0), "Kim", "misread the dial", done);
        });
        QVERIFY(corrected);
        QVERIFY(!bench.service->view().parts[5].perturbed);
        QVERIFY(bench.measurement(6, 0) != id);

        for (int part = 7; part <= 12; ++part) {
            bench.boreAndMeasure();
        }
        const auto& view = bench.service->view();
        QVERIFY(view.parts[6].perturbed && !view.parts[6].perturbedReason.empty());
        QCOMPARE(view.parts.size(), std::size_t{12});
        for (std::size_t i = 9; i < 12; ++i) {  // in tolerance again
            for (const auto& m : view.parts[i].measurements) {
                QVERIFY(m.diameter_mm > view.lowerTolerance_mm - 0.01 && m.diameter_mm < view.upperTolerance_mm + 0.01);
            }
        }
        QVERIFY(!view.awaiting);
        const std::string end = text(view);
        bench.restart();
        QCOMPARE(QString::fromStdString(text(bench.service->view())), QString::fromStdString(end));
        QVERIFY(bench.service->restartFinding().empty());
    }
    void restartEqualsBeforeForThePapersEstimatorToo() {
        Bench bench(LoopMode::Control, boring::EstimatorKind::Perturbation);
        for (int part = 1; part <= 5; ++part) {
            bench.boreAndMeasure();
        }
        QVERIFY(bench.wait([&](const auto& done) {
            bench.service->voidMeasurement(bench.measurement(3, 1), "Kim", "chip in the bore", done);
        }));
        const std::string before = text(bench.service->view());
        bench.restart();
        QCOMPARE(QString::fromStdString(text(bench.service->view())), QString::fromStdString(before));
        QVERIFY(bench.service->restartFinding().empty());
    }
    void scheduleFollowsEachAcceptedMeasurementInControl() {
        Bench bench;
        bench.bore();
        QVERIFY(bench.enter(bench.entry(1, 0)));
        const auto first = bench.loaded();
        QCOMPARE(first.constantFeed_mmPerRev, 0.0);
        QVERIFY(bench.enter(bench.entry(1, 1)));
        QVERIFY(bench.loaded().revision > first.revision);
        QVERIFY(bench.service->view().scheduleAccepted);
        QVERIFY(bench.service->view().nextPrediction[0].has_value());
    }
    void adviseWaitsForTheOperatorAndControlDoesNot() {
        Bench bench(LoopMode::Advise);
        const auto firstRevision = bench.loaded().revision;
        QVERIFY(firstRevision > 0);  // the first part's constant feed needs no decision
        bench.boreAndMeasure();
        QVERIFY(!bench.service->view().scheduleAccepted);
        QCOMPARE(bench.loaded().revision, firstRevision);
        bench.restart();
        QVERIFY(!bench.service->view().scheduleAccepted);
        QCOMPARE(bench.loaded().revision, firstRevision);
        QVERIFY(bench.wait([&](const auto& done) { bench.service->acceptSchedule("Kim", done); }));
        QVERIFY(bench.service->view().scheduleAccepted);
        QCOMPARE(bench.loaded().revision, bench.service->view().nextSchedule.revision);
        bench.boreAndMeasure();
        QVERIFY(!bench.service->view().scheduleAccepted);
        bench.loopMode = LoopMode::Control;
        bench.service->poll();
        QTRY_VERIFY(bench.service->view().scheduleAccepted);
        QCOMPARE(bench.loaded().revision, bench.service->view().nextSchedule.revision);
    }
    void fullCommandRingIsTriedAgain() {
        Bench bench;
        bench.bore();
        bench.engine->ringFull = true;
        QVERIFY(bench.enter(bench.entry(1, 0)));
        QVERIFY(bench.loaded().revision < bench.service->view().nextSchedule.revision);
        bench.engine->ringFull = false;
        bench.service->poll();
        QCOMPARE(bench.loaded().revision, bench.service->view().nextSchedule.revision);
    }
    void failedStoreChangesNothingAndSaysWhy() {
        Bench bench;
        bench.boreAndMeasure();
        bench.bore();
        const std::string before = text(bench.service->view());
        const auto broken = [&](const char* sql) {
            const db::Connection file(bench.scratch().path(), db::Access::Write);
            QVERIFY(test::tryExecute(file.database(), sql));
        };
        broken("CREATE TRIGGER broken BEFORE INSERT ON audit BEGIN SELECT RAISE(ABORT, 'broken'); END");
        const auto refused = bench.enter(bench.entry(2, 0));
        QVERIFY(!refused);
        QVERIFY(!refused.error().empty());
        QVERIFY(!bench.service->view().storeProblem.empty());
        BoringServiceView after = bench.service->view();
        after.storeProblem = {};
        QCOMPARE(QString::fromStdString(text(after)), QString::fromStdString(before));
        QCOMPARE(bench.count("SELECT count(*) FROM measurements"), std::int64_t{2});
        broken("DROP TRIGGER broken");
        QVERIFY(bench.enter(bench.entry(2, 0)));
        QVERIFY(bench.service->view().storeProblem.empty());
    }
    void lateMeasurementUsesTheFeedItsOwnPartWasCutWith() {
        Bench bench;
        bench.boreAndMeasure();
        const auto slow = [](PartRecord& record) {  // the operator turned the feed knob down
            for (float& feed : record.feed.feed_mmPerRev) {
                feed *= 0.6F;
            }
        };
        bench.bore(slow);
        bench.boreAndMeasure();
        bench.boreAndMeasure();
        QCOMPARE(bench.service->view().awaiting, std::optional(bench.idOf(2)));
        QVERIFY(bench.enter(bench.entry(2, 0)));
        QVERIFY(bench.enter(bench.entry(2, 1)));
        // Cut 40 % slower than planned, measured late: no surprise to an estimate that knows the real feed.
        for (const auto& part : bench.service->view().parts) {
            QVERIFY(!part.perturbed);
        }
        QVERIFY(!bench.service->view().awaiting);
    }
    void impossibleEntriesAreRefused() {
        Bench bench;
        bench.bore();
        BoreEntry entry = bench.entry(1, 0);
        const auto refused = [&](const BoreEntry& e) {
            return bench.service->check(e).verdict == EntryVerdict::Refuse && !bench.service->check(e).reason.empty() &&
                   !bench.enter(e);
        };
        for (const double diameter_mm : {0.0, -50.0, 500.0, std::numeric_limits<double>::quiet_NaN()}) {
            BoreEntry bad = entry;
            bad.diameter_mm = diameter_mm;
            bad.confirmed = true;
            QVERIFY2(refused(bad), qPrintable(QString::number(diameter_mm)));
        }
        BoreEntry elsewhere = entry;
        elsewhere.part = 999;
        QVERIFY(refused(elsewhere));
        elsewhere = entry;
        elsewhere.depth = 7;
        QVERIFY(refused(elsewhere));
        BoreEntry nobody = entry;
        nobody.author.clear();
        QVERIFY(!bench.enter(nobody));
        QVERIFY(bench.enter(entry));
        QVERIFY(refused(entry));  // measured already
        QCOMPARE(bench.count("SELECT count(*) FROM measurements"), std::int64_t{1});
    }
    void abortedPartWantsNoMeasurement() {
        Bench bench;
        bench.bore([](PartRecord& record) { record.complete = false; });
        QVERIFY(!bench.service->view().awaiting);
        QVERIFY(!bench.enter(bench.entry(1, 0)));
    }
    void confirmedImplausibleValueIsTaken() {
        Bench bench;
        bench.boreAndMeasure();
        bench.bore();
        BoreEntry entry = bench.entry(2, 0);
        entry.diameter_mm = 49.3;
        QCOMPARE(bench.service->check(entry).verdict, EntryVerdict::Ask);
        entry.confirmed = true;
        QVERIFY(bench.enter(entry));
        QCOMPARE(bench.count("SELECT count(*) FROM measurements WHERE confirmed"), std::int64_t{1});
    }
    void correctionsAppendWithAuthorAndReason() {
        Bench bench;
        bench.boreAndMeasure();
        const auto id = bench.measurement(1, 0);
        const auto correct = [&](MeasurementId which, const char* author, const char* reason) {
            return bench.wait([&](const auto& done) { bench.service->correct(which, 49.95, author, reason, done); });
        };
        QVERIFY(!correct(id, "Kim", ""));
        QVERIFY(!correct(id, "", "misread"));
        QVERIFY(!correct(999, "Kim", "misread"));
        QVERIFY(correct(id, "Kim", "misread"));
        QVERIFY(!correct(id, "Kim", "misread"));  // replaced meanwhile
        QCOMPARE(bench.count("SELECT count(*) FROM measurements"), std::int64_t{3});
        QCOMPARE(bench.count(qPrintable(QStringLiteral("SELECT count(*) FROM measurements WHERE replaces_id = %1 AND "
                                                       "author = 'Kim' AND reason = 'misread'")
                                            .arg(id))),
                 std::int64_t{1});
    }
    void theQuestionOfAFirstEntryProtectsACorrectionToo() {
        Bench bench;
        bench.boreAndMeasure();
        bench.boreAndMeasure();
        const auto id = bench.measurement(2, 0);
        const double before = bench.service->view().nextSchedule.lnC;
        const double sound_mm = bench.service->view().parts[1].measurements[0].diameter_mm - 0.002;
        BoreCorrection wrong{id, 5.0011, "Kim", "misread", true, false};
        QVERIFY(bench.service->checkCorrection(id, wrong.diameter_mm).verdict != EntryVerdict::Accept);
        QCOMPARE(bench.service->checkCorrection(id, sound_mm).verdict, EntryVerdict::Accept);
        const auto correct = [&](const BoreCorrection& one) {
            return bench.wait([&](const auto& done) { bench.service->correctValue(one, done); });
        };
        QVERIFY(!correct(wrong));
        QVERIFY(!bench.wait([&](const auto& done) { bench.service->correct(id, 49.3, "Kim", "misread", done); }));
        QCOMPARE(bench.service->view().nextSchedule.lnC, before);
        QVERIFY(correct({id, 49.3, "Kim", "measured again", false, true}));  // an answer was given
        QCOMPARE(bench.count("SELECT count(*) FROM measurements WHERE confirmed"), std::int64_t{1});
        BoreCorrection right{bench.measurement(2, 0), sound_mm, "Kim", "gauge", true, true};
        right.id = bench.count("SELECT max(id) FROM measurements");
        QVERIFY(correct(right));
        QCOMPARE(bench.count("SELECT count(*) FROM measurements WHERE replaces_id IS NOT NULL AND source = 'gauge'"),
                 std::int64_t{1});
    }
    void undoTakesBackTheNewestStepByStep() {
        Bench bench;
        bench.boreAndMeasure();
        const auto undo = [&] { return bench.wait([&](const auto& done) { bench.service->undoLast("Kim", done); }); };
        QVERIFY(undo());
        QCOMPARE(bench.service->view().awaitingDepth, std::uint8_t{1});
        QVERIFY(undo());
        QCOMPARE(bench.service->view().awaitingDepth, std::uint8_t{0});
        QVERIFY(bench.service->view().estimates.empty());
        QCOMPARE(bench.loaded().constantFeed_mmPerRev, 0.5);  // back to the beginning
        QVERIFY(!undo());
        const std::string before = text(bench.service->view());
        bench.restart();
        QCOMPARE(QString::fromStdString(text(bench.service->view())), QString::fromStdString(before));
    }
    void entriesInABurstAreTakenOneAfterTheOther() {
        Bench bench;
        bench.bore();
        bench.bore();
        int answered = 0;
        for (const std::uint32_t part : {1U, 2U}) {
            for (const std::uint8_t depth : {std::uint8_t{0}, std::uint8_t{1}}) {
                bench.service->enter(bench.entry(part, depth), [&](const Result<void>& done) {
                    QVERIFY(done);
                    ++answered;
                });
            }
        }
        QTRY_COMPARE(answered, 4);
        const std::string before = text(bench.service->view());
        bench.restart();
        QCOMPARE(QString::fromStdString(text(bench.service->view())), QString::fromStdString(before));
        QVERIFY(bench.service->restartFinding().empty());
    }
    void differentStoredStateRaisesAnAlarmAndTheReplayedOneIsUsed() {
        Bench bench;
        bench.boreAndMeasure();
        const std::string before = text(bench.service->view());
        bench.close();
        {
            const db::Connection file(bench.scratch().path(), db::Access::Write);
            QVERIFY(test::tryExecute(file.database(), "DROP TRIGGER estimator_states_no_update"));
            QVERIFY(test::tryExecute(file.database(), "UPDATE estimator_states SET state = '{\"numbers\":[1]}'"));
        }
        bench.restart();
        QVERIFY(!bench.service->restartFinding().empty());
        QCOMPARE(QString::fromStdString(text(bench.service->view())), QString::fromStdString(before));
        QTRY_COMPARE(bench.count("SELECT count(*) FROM alarms WHERE code = 110"), std::int64_t{1});
    }
    void subscriptionEndsWithItsHandle() {
        Bench bench;
        int calls = 0;
        auto handle = bench.service->onChanged([&] { ++calls; });
        bench.bore();
        QVERIFY(calls > 0);
        const int heard = calls;
        handle.reset();
        bench.bore();
        QCOMPARE(calls, heard);
    }
    void recipeSurvivesItsJsonAndRefusesNonsense() {
        BoringRecipe recipe;
        recipe.sigma_mm = 0.0071;
        recipe.depths.push_back({"middle", 175.0});
        const auto back = recipeFromJson(recipeJson(recipe));
        QVERIFY(back);
        QCOMPARE(recipeJson(*back), recipeJson(recipe));
        QVERIFY(!recipeFromJson("{"));
        QVERIFY(!recipeFromJson(R"({"boring.sigma_mm":-1})"));
        QVERIFY(!recipeFromJson(R"({"boring.sigma_mm":"thin"})"));
        QVERIFY(!recipeFromJson(R"({"boring.depths":[]})"));
        QVERIFY(!recipeFromJson(R"({"boring.depths":[{"name":"deep","overhang_mm":900}]})"));
        QVERIFY(!recipeFromJson(R"({"boring.lower_tolerance_mm":51})"));
        QVERIFY(recipeFromJson("{}"));
    }
};
QTEST_GUILESS_MAIN(TestBoringService)
#include "tst_boring_service.moc"
