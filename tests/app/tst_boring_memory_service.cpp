// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>
#include <QTest>
#include <cmath>

#include "app/service/boring/boring_lots.h"
#include "app/service/boring/shop_memory.h"
#include "db/writer_thread.h"
#include "engine/process/boring/plant.h"
#include "tests/db/db_test_support.h"
#include "tests/support/fake_engine.h"

using namespace kerf;

namespace {

constexpr db::WriterThread::Options kQuick{.queueCapacity = 64, .ringPoll_ms = 1, .retry_ms = 2};
constexpr double kSigma_mm = 0.005;

template <class Condition>
void waitUntil(const Condition& happened) {
    while (!happened()) {
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
}

/// The lots of one machine on a real database; the machine bores by the true law, an operator measures.
class Bench {
 public:
    explicit Bench(const BoringRecipe& recipe = {}) {
        m_writer = std::make_unique<db::WriterThread>(m_scratch.path(), &m_ring, kQuick);
        if (!m_writer->start() || !readAnew()) {
            qFatal("no database");
        }
        StoredBoringService::Links links{*m_writer, engine, {}, [] { return LoopMode::Control; }};
        links.records = m_reader.get();
        BoringLotRequest first{"VB-1", "simulator", "Sleeve 50", recipe, "1", 30, boring::EstimatorKind::Kalman, "Lee"};
        lots = std::make_unique<StoredBoringLots>(links, *m_reader, first);
        must([&](const auto& done) { lots->start(done); });
    }
    ~Bench() {
        lots.reset();
        m_reader.reset();
        m_writer->stop();
    }
    [[nodiscard]] CurrentBoringService& service() { return lots->service(); }
    [[nodiscard]] const BoringServiceView& view() { return service().view(); }
    void must(const std::function<void(BoringLots::Done)>& call) {
        const auto result = wait(call);
        QVERIFY2(result.has_value(), result ? "" : result.error().english().c_str());
    }
    Result<void> wait(const std::function<void(BoringLots::Done)>& call) {
        std::optional<Result<void>> result;
        call([&](const Result<void>& answer) { result = answer; });
        waitUntil([&] { return result.has_value(); });
        return *result;
    }
    void boreAndMeasure() {
        PartRecord record;
        record.partSequence = ++m_sequence;
        record.begin_ns = m_sequence * 60'000'000'000LL;
        record.end_ns = record.begin_ns + 40'000'000'000LL;
        record.schedule = loaded();
        record.order = engine.fake.orders[static_cast<std::size_t>(ProcessId::Boring)];
        const std::size_t before = view().parts.size();
        QVERIFY(m_ring.tryPush(record));
        waitUntil([&] { return view().parts.size() > before; });
        while (view().awaiting) {
            const auto depth = view().awaitingDepth;
            const double overhang_mm = view().depths[depth].overhang_mm;
            const double feed_mmPerRev = record.schedule.feed_mmPerRev(overhang_mm);
            const double d_mm = boring::deflection_mm(law, feed_mmPerRev, overhang_mm) + kSigma_mm * noise.gauss();
            BoreEntry entry;
            entry.part = *view().awaiting;
            entry.depth = depth;
            entry.diameter_mm =
                boring::diameterFromDeflection_mm(d_mm, 50.0, boring::kTableTargetDeflection_mm, boring::kTablePhi_deg);
            entry.author = "Kim";
            entry.confirmed = true;
            must([&](const auto& done) { service().enter(entry, done); });
        }
        service().poll();
    }
    [[nodiscard]] BoringSchedule loaded() const {
        for (auto command = engine.commands.rbegin(); command != engine.commands.rend(); ++command) {
            if (const auto* load = std::get_if<LoadBoringSchedule>(&command->action)) {
                return load->schedule;
            }
        }
        return {};
    }
    void openLot(const char* name, const char* grade = "") {
        BoringLotOrder order;
        order.partType = lots->partTypes()->front().id;
        order.name = name;
        order.author = "Kim";
        order.insertGrade = grade;
        must([&](const auto& done) { lots->open(order, done); });
    }
    void lot(const char* name, int parts, const char* grade = "") {
        openLot(name, grade);
        for (int part = 0; part < parts; ++part) {
            boreAndMeasure();
        }
    }
    [[nodiscard]] db::DatabaseReader& reader() { return *m_reader; }
    [[nodiscard]] LotId lotId(const std::string& name) {
        const auto all = lots->lots();
        for (const BoringLotView& lot : *all) {
            if (lot.name == name) {
                return lot.id;
            }
        }
        return 0;
    }

    test::FakeEngine engine{};
    boring::LawConstants law{boring::TruthPlan::table().at(1)};
    Random noise{7};
    std::unique_ptr<StoredBoringLots> lots{};

 private:
    bool readAnew() {
        auto reader = db::DatabaseReader::open(m_scratch.path());
        if (reader) {
            m_reader = std::move(*reader);
        }
        return m_reader != nullptr;
    }
    test::ScratchDatabase m_scratch;
    SpscRing<PartRecord> m_ring{64};
    std::unique_ptr<db::WriterThread> m_writer{};
    std::unique_ptr<db::DatabaseReader> m_reader{};
    std::uint32_t m_sequence{0};
};

/// Lots of another machine, as the shop would give them: what a bench like this one has stored.
std::vector<BoringMemoryLot> lotsOfAnother() {
    Bench other;
    for (int part = 0; part < 5; ++part) {
        other.boreAndMeasure();
    }
    other.lot("2", 5);
    other.lot("3", 5);
    other.openLot("4");
    const auto history = other.reader().history(other.lotId("4"));
    std::vector<BoringMemoryLot> lots = readBoringMemory(other.reader(), other.reader(), (*history)->lot)->past;
    for (BoringMemoryLot& lot : lots) {
        lot.store = "5f0c";
    }
    return shopLotsFromJson(shopLotsJson(lots));
}

BoringRecipe drawing() {
    BoringRecipe recipe;
    recipe.shopMemory = 1.0;
    return recipe;
}

}  // namespace

class TestBoringMemoryService : public QObject {
    Q_OBJECT
 private slots:
    void nextLotShowsExpectedDiametersBeforeItsFirstCut() {
        Bench bench;
        QVERIFY(bench.view().nextRestsOn.empty());
        QVERIFY(!bench.view().nextPrediction[0]);
        for (int part = 0; part < 4; ++part) {
            bench.boreAndMeasure();
        }
        bench.openLot("2");
        const BoringServiceView& view = bench.view();
        QCOMPARE(view.parts.size(), std::size_t{0});
        QVERIFY(bench.loaded().constantFeed_mmPerRev == 0.0);  // from memory, not the recipe's first feed
        QVERIFY(view.nextPrediction[0] && view.nextPrediction[1]);
        // One lot is little: the feed aims where 49.985 and 50.015 mm are equally far in ln d, a thousandth above 50.
        const double d0_mm = BoringRecipe{}.targetDeflection_mm;
        const double aim_mm = 50.0 + d0_mm - std::sqrt((d0_mm - 0.015) * (d0_mm + 0.015));
        QVERIFY(std::abs(view.nextPrediction[0]->diameter_mm - aim_mm) < 1e-6);
        QVERIFY(view.nextPrediction[0]->half95_mm > 0.01);
        QVERIFY(QString::fromStdString(view.nextRestsOn.english()).startsWith("Expected from 1 earlier lots"));
        bench.boreAndMeasure();
        for (const BoreMeasurementView& m : view.parts[0].measurements) {
            QVERIFY(std::abs(m.diameter_mm - 50.0) < 0.03);
        }
    }
    void memoryOffBeginsAsEver() {
        BoringRecipe recipe;
        recipe.memory = 0.0;
        Bench bench(recipe);
        for (int part = 0; part < 3; ++part) {
            bench.boreAndMeasure();
        }
        bench.openLot("2");
        QCOMPARE(bench.loaded().constantFeed_mmPerRev, 0.5);
        QVERIFY(bench.view().nextRestsOn.empty());
    }
    void anAnnouncedChangeWidensAndCanBeTakenBack() {
        Bench bench;
        QVERIFY(!bench.wait([&](auto done) { bench.service().announceChange(BoringChange::Insert, "Kim", done); }));
        for (int part = 0; part < 4; ++part) {
            bench.boreAndMeasure();
        }
        const double before_mm = bench.view().nextPrediction[0]->half95_mm;
        QVERIFY(!bench.wait([&](auto done) { bench.service().announceChange(BoringChange::Insert, "", done); }));
        bench.must([&](auto done) { bench.service().announceChange(BoringChange::Insert, "Kim", done); });
        QCOMPARE(bench.view().announced, std::optional(BoringChange::Insert));
        QVERIFY(bench.view().nextPrediction[0]->half95_mm > 1.5 * before_mm);
        const BoringSchedule widened = bench.view().nextSchedule;
        bench.must([&](auto done) { bench.service().withdrawChange("Kim", done); });
        QVERIFY(!bench.view().announced);
        QVERIFY(std::abs(bench.view().nextPrediction[0]->half95_mm - before_mm) < 1e-12);
        bench.must([&](auto done) { bench.service().announceChange(BoringChange::Insert, "Kim", done); });
        QVERIFY(sameLaw(widened, bench.view().nextSchedule));
        bench.law.lnC += 0.1;
        bench.boreAndMeasure();
        QVERIFY(!bench.view().announced);
        // As a restart finds it.
        const LotId lot = bench.lotId("1");
        const auto history = bench.reader().history(lot);
        const auto basis = readBoringMemory(bench.reader(), bench.reader(), (*history)->lot);
        QCOMPARE(basis->announced.size(), std::size_t{1});
        QCOMPARE(basis->announced[0].part, 5U);
    }
    void leavingALotOutComputesAnewAndIsReversible() {
        Bench bench;
        for (int part = 0; part < 4; ++part) {
            bench.boreAndMeasure();
        }
        bench.law.lnC += 0.3;
        bench.lot("2", 4);
        bench.openLot("3");
        const auto both = bench.view().nextSchedule;
        auto memory = *bench.lots->memory();
        QCOMPARE(memory.size(), std::size_t{2});
        QVERIFY(memory[0].share > 0.1 && memory[1].share > 0.1);
        QVERIFY(!bench.wait([&](auto done) { bench.lots->leaveOut({memory[0].lot, {}}, true, "Kim", "", done); }));
        bench.must([&](auto done) { bench.lots->leaveOut({memory[0].lot, {}}, true, "Kim", "wrong drawing", done); });
        memory = *bench.lots->memory();
        QVERIFY(memory[0].leftOut && memory[0].share == 0.0);
        QCOMPARE(memory[0].reason, std::string("wrong drawing"));
        QVERIFY(!sameLaw(both, bench.view().nextSchedule));
        bench.must([&](auto done) {
            bench.lots->leaveOut({memory[0].lot, {}}, false, "Kim", "right after all", done);
        });
        QVERIFY(sameLaw(both, bench.view().nextSchedule));
    }
    void aCorrectionInAnEarlierLotChangesWhatALaterOneBegan() {
        Bench bench;
        for (int part = 0; part < 4; ++part) {
            bench.boreAndMeasure();
        }
        bench.lot("2", 3);
        bench.lot("3", 3);
        const BoringSchedule believed = bench.view().nextSchedule;
        const LotId third = bench.lotId("3");
        bench.must([&](auto done) { bench.lots->choose(bench.lotId("1"), "Kim", done); });
        const MeasurementId id = bench.view().parts[1].measurements[0].id;
        const double old_mm = bench.view().parts[1].measurements[0].diameter_mm;
        bench.must([&](auto done) { bench.service().correct(id, old_mm - 0.03, "Kim", "misread", done); });
        bench.must([&](auto done) { bench.lots->choose(third, "Kim", done); });
        QVERIFY(!sameLaw(believed, bench.view().nextSchedule));
        const MeasurementId now = [&] {
            bench.must([&](auto done) { bench.lots->choose(bench.lotId("1"), "Kim", done); });
            for (const auto& m : bench.view().parts[1].measurements) {
                if (!m.voided && m.depth == 0) {
                    return m.id;
                }
            }
            return MeasurementId{0};
        }();
        bench.must([&](auto done) { bench.service().correct(now, old_mm, "Kim", "right at first", done); });
        bench.must([&](auto done) { bench.lots->choose(third, "Kim", done); });
        QVERIFY(sameLaw(believed, bench.view().nextSchedule));
    }
    void aFirstPartThatTeachesAsksForTheMiddleOnce() {
        BoringRecipe recipe;
        recipe.firstPartTeaches = 1.0;
        Bench bench(recipe);
        QCOMPARE(bench.view().depths.size(), std::size_t{3});
        QVERIFY(boring::teaches(bench.loaded()));
        QCOMPARE(bench.loaded().feed_mmPerRev(175.0), 0.5);
        QCOMPARE(bench.loaded().feed_mmPerRev(310.0), 0.1);
        bench.law.alpha = 0.4;
        bench.boreAndMeasure();
        QCOMPARE(bench.view().parts[0].measurements.size(), std::size_t{3});
        bench.boreAndMeasure();
        QCOMPARE(bench.view().parts[1].measurements.size(), std::size_t{2});
        for (const BoreMeasurementView& m : bench.view().parts[1].measurements) {
            QVERIFY(std::abs(m.diameter_mm - 50.0) < 0.03);
        }
        QVERIFY(boring::teaches(bench.view().parts[0].schedule));
    }
    void anotherGradeIsAnotherBranch() {
        Bench bench;
        bench.lot("2", 3, "K10");
        bench.openLot("3", "K20");
        const auto basis = [&] {
            const auto history = bench.reader().history(bench.lotId("3"));
            return *readBoringMemory(bench.reader(), bench.reader(), (*history)->lot);
        }();
        QCOMPARE(basis.context.names[2], std::string("K20"));
        QCOMPARE(basis.past.size(), std::size_t{1});
        QCOMPARE(basis.past[0].context.names[2], std::string("K10"));
    }
    void aLotDrawsOnTheShopWhenTheRecipeSaysSoAndKeepsIt() {
        const auto others = lotsOfAnother();
        QCOMPARE(others.size(), std::size_t{3});
        Bench bench(drawing());
        int asked = 0;
        bench.lots->drawOnShop([&](const std::string& partType, const StoredBoringLots::ShopLotsTold& told) {
            ++asked;
            QCOMPARE(partType, std::string("Sleeve 50"));
            told(others);
        });
        bench.openLot("2");
        waitUntil([&] { return bench.view().nextPrediction[0].has_value(); });
        QCOMPARE(asked, 1);
        QVERIFY(bench.lots->shopAnswer().empty());
        QVERIFY(QString::fromStdString(bench.view().nextRestsOn.english())
                    .startsWith("Expected from 0 earlier lots and 3 of other machines"));
        auto memory = *bench.lots->memory();
        QCOMPARE(memory.size(), std::size_t{3});
        QCOMPARE(memory[0].machine, std::string("VB-1"));
        QVERIFY(memory[0].share > 0.0 && memory[0].share < 1.0);
        const auto all = bench.view().nextSchedule;
        // Without the shop, as after a restart: the same.
        bench.lots->drawOnShop({});
        bench.must([&](auto done) { bench.lots->choose(bench.lotId("1"), "Kim", done); });
        bench.must([&](auto done) { bench.lots->choose(bench.lotId("2"), "Kim", done); });
        QVERIFY(sameLaw(all, bench.view().nextSchedule));
        // One can be left out.
        const BoringMemoryKey key{memory[0].lot, memory[0].console};
        bench.must([&](auto done) { bench.lots->leaveOut(key, true, "Kim", "another insert", done); });
        memory = *bench.lots->memory();
        QVERIFY(memory[0].leftOut && memory[0].share == 0.0 && memory[1].share > 0.0);
        QVERIFY(!sameLaw(all, bench.view().nextSchedule));
        bench.must([&](auto done) { bench.lots->leaveOut(key, false, "Kim", "it was not", done); });
        QVERIFY(sameLaw(all, bench.view().nextSchedule));
        // The first bore is right although this machine has never bored anything.
        bench.boreAndMeasure();
        for (const BoreMeasurementView& m : bench.view().parts[0].measurements) {
            QVERIFY(std::abs(m.diameter_mm - 50.0) < 0.03);
        }
        // An own lot counts more than another machine's.
        for (int part = 0; part < 4; ++part) {
            bench.boreAndMeasure();
        }
        bench.lots->drawOnShop([&](const std::string&, const StoredBoringLots::ShopLotsTold& told) { told(others); });
        bench.openLot("3");
        waitUntil([&] { return bench.lots->memory()->size() == 4; });
        memory = *bench.lots->memory();
        QVERIFY(memory[0].machine.empty());
        QVERIFY(memory[0].share > memory[1].share + memory[2].share + memory[3].share);
    }
    void aShopThatIsNotToldOfOrOutOfReachChangesNothing() {
        Bench bench;  // the recipe does not say so
        bench.lots->drawOnShop([](const std::string&, const StoredBoringLots::ShopLotsTold&) { QFAIL("not told to"); });
        bench.openLot("2");
        QVERIFY(bench.lots->shopAnswer().empty());
        Bench told(drawing());
        const Sentence why(KERF_TEXT("The shop is out of reach: this lot begins without other machines' lots."));
        told.lots->drawOnShop(
            [&](const std::string&, const StoredBoringLots::ShopLotsTold& answer) { answer(tl::unexpected(why)); });
        told.openLot("2");
        QCOMPARE(told.lots->shopAnswer().english(), why.english());
        QVERIFY(!told.view().nextPrediction[0]);
        QCOMPARE(told.loaded().constantFeed_mmPerRev, 0.5);
    }
    void anAnswerAfterTheFirstPartChangesNothing() {
        const auto others = lotsOfAnother();
        Bench bench(drawing());
        StoredBoringLots::ShopLotsTold late;
        bench.lots->drawOnShop([&](const std::string&, const StoredBoringLots::ShopLotsTold& told) { late = told; });
        bench.openLot("2");
        QVERIFY(!bench.lots->shopAnswer().empty());  // it is being asked
        bench.boreAndMeasure();
        const auto before = bench.view().nextSchedule;
        late(others);
        QVERIFY(bench.lots->memory()->empty());
        QVERIFY(sameLaw(before, bench.view().nextSchedule));
        QVERIFY(QString::fromStdString(bench.lots->shopAnswer().english()).contains("after the first part had begun"));
        // And when another lot is current by then, nothing at all.
        bench.openLot("3");
        const auto tooLate = late;
        bench.openLot("4");
        const Sentence asked = bench.lots->shopAnswer();
        tooLate(others);
        QVERIFY(bench.lots->memory()->size() == 1);
        QCOMPARE(bench.lots->shopAnswer().english(), asked.english());
    }
};
QTEST_GUILESS_MAIN(TestBoringMemoryService)
#include "tst_boring_memory_service.moc"
