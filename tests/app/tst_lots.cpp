// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "app/service/milling/milling_service.h"
#include "app/service/turning/turning_service.h"
#include "tests/support/service_bench.h"

using namespace kerf;

namespace {

/// Two services on one data file, with rights by name: Kim is an operator, Lee a setter.
struct Bench : test::ServiceBench {
    Bench() { open(); }
    void open() {
        milling.reset();
        turning.reset();
        readAnew();
        const Rights rights = [](const std::string& author, Deed deed) -> std::optional<Sentence> {
            const Trust has = author == "Lee" ? Trust::Engineer : Trust::Operator;
            return has >= permissionOf(deed).least ? std::nullopt : std::optional(Sentence("not trusted with it"));
        };
        StoredMillingService::Links links{writer, engine, [] { return std::string("Kerf"); }, {}, rights};
        milling = std::make_unique<StoredMillingService>(std::move(links), *reader, *reader, *reader);
        turning = std::make_unique<StoredTurningService>(
            StoredTurningService::Links{writer, engine, *turningExchange, *reader, *reader, rights});
        turning->poll();
    }
    [[nodiscard]] Result<void> openLot(LotService& lots, const std::string& name, const std::string& author) {
        return wait([&](const auto& answer) { lots.open({name, 20, "end mill 8", "caliper 3"}, author, answer); });
    }
    /// What the engine was told last of the process.
    [[nodiscard]] std::optional<WorkOrder> told(ProcessId process) const {
        for (auto command = engine.commands.rbegin(); command != engine.commands.rend(); ++command) {
            if (const auto* name = std::get_if<NameOrder>(&command->action)) {
                if (name->process == process) {
                    return name->order;
                }
            }
            const auto* setup = std::get_if<LoadMillingSetup>(&command->action);
            if (process == ProcessId::Milling && setup != nullptr && setup->order) {
                return setup->order;
            }
            const auto* cut = std::get_if<LoadTurningSetup>(&command->action);
            if (process == ProcessId::Turning && cut != nullptr && cut->order) {
                return cut->order;
            }
        }
        return std::nullopt;
    }
    /// The engine has taken the newest setup.
    void settle() {
        for (const Command& command : engine.commands) {
            if (const auto* setup = std::get_if<LoadMillingSetup>(&command.action)) {
                engine.fake.milling.setup = setup->setup.revision;
                engine.fake.milling.law = setup->setup.law;
                engine.fake.milling.reference_N = setup->setup.reference_N;
            }
            if (const auto* blank = std::get_if<LoadMillingBlank>(&command.action)) {
                engine.fake.milling.blank = blank->blank.revision;
            }
        }
        engine.fake.cycle = 1;
    }

    std::unique_ptr<StoredMillingService> milling;
    std::unique_ptr<StoredTurningService> turning;
};

}  // namespace

/// Lots of the processes that are not boring: one book for all of them.
class TestLots : public QObject {
    Q_OBJECT
 private slots:
    void aLotIsOpenedChosenLeftAndClosed() {
        Bench bench;
        bench.settle();
        LotService& lots = *bench.milling->lots();
        QVERIFY(!lots.current());
        QVERIFY(!bench.openLot(lots, "R7", "Kim"));  // an operator opens none
        QVERIFY(!bench.openLot(lots, "R7", ""));
        QVERIFY(!bench.openLot(lots, "", "Lee"));
        QVERIFY(bench.openLot(lots, "R7", "Lee"));
        const auto first = lots.current();
        QVERIFY(first);
        QCOMPARE(first->name, std::string("R7"));
        QCOMPARE(first->partType, std::string(StoredMillingService::kFirstPartType));
        QCOMPARE(first->recipeRevision, 1U);  // what the program brings along has become the first revision
        QCOMPARE(first->tool, std::string("end mill 8"));
        QCOMPARE(first->openedBy, std::string("Lee"));
        const auto order = bench.told(ProcessId::Milling);
        QVERIFY(order);
        QCOMPARE(order->lot, first->id);
        QCOMPARE(order->recipe, (*bench.reader->lots(std::nullopt, 1))[0].recipe);
        QVERIFY(!bench.openLot(lots, "R7", "Lee"));  // the name is taken
        QVERIFY(bench.openLot(lots, "R8", "Lee"));
        QCOMPARE(bench.told(ProcessId::Milling)->lot, lots.current()->id);
        QVERIFY(bench.wait([&](const auto& answer) { lots.choose(first->id, "Lee", answer); }));
        QCOMPARE(bench.told(ProcessId::Milling)->lot, first->id);
        QVERIFY(bench.wait([&](const auto& answer) { lots.leave("Lee", answer); }));
        QVERIFY(!lots.current());
        QCOMPARE(bench.told(ProcessId::Milling)->lot, std::int64_t{0});
        QCOMPARE(bench.told(ProcessId::Milling)->recipe, order->recipe);  // the recipe stays what it is
        QVERIFY(bench.wait([&](const auto& answer) { lots.choose(first->id, "Lee", answer); }));
        QVERIFY(!bench.wait([&](const auto& answer) { lots.close("Lee", " ", answer); }));  // for no reason
        QVERIFY(bench.wait([&](const auto& answer) { lots.close("Lee", "all cut", answer); }));
        QVERIFY(!lots.current());
        QVERIFY(!bench.wait([&](const auto& answer) { lots.choose(first->id, "Lee", answer); }));
        QVERIFY(bench.reader->verifyAudit()->finding.empty());
    }
    void aLotOutlivesTheConsoleAndWaitsForItsPartType() {
        Bench bench;
        bench.settle();
        QVERIFY(bench.openLot(*bench.milling->lots(), "R7", "Lee"));
        const WorkOrder order = *bench.told(ProcessId::Milling);
        bench.engine.commands.clear();
        bench.open();
        QCOMPARE(bench.told(ProcessId::Milling), std::optional(order));  // with the setup, before any part
        QVERIFY(bench.wait([&](const auto& answer) { bench.milling->choosePartType("Bracket", "Lee", answer); }));
        QVERIFY(!bench.milling->lots()->current());  // it is no lot of brackets
        const auto bracket = bench.told(ProcessId::Milling);
        QCOMPARE(bracket->lot, std::int64_t{0});
        QVERIFY(bracket->recipe != order.recipe);
        const auto refused =
            bench.wait([&](const auto& answer) { bench.milling->lots()->choose(order.lot, "Lee", answer); });
        QVERIFY(!refused);
        QVERIFY(refused.error().english().find("Rail") != std::string::npos);
        QVERIFY(bench.wait([&](const auto& answer) { bench.milling->choosePartType("Rail", "Lee", answer); }));
        QCOMPARE(bench.told(ProcessId::Milling), std::optional(order));
    }
    void anotherRevisionGoesWithTheSetupAndTheLotStays() {
        Bench bench;
        bench.settle();
        QVERIFY(bench.openLot(*bench.milling->lots(), "R7", "Lee"));
        const WorkOrder before = *bench.told(ProcessId::Milling);
        MillingSetup setup = bench.milling->view().setup;
        setup.reference_N = 300.0;
        QVERIFY(bench.wait([&](const auto& answer) { bench.milling->saveSetup(setup, "Lee", "softer", answer); }));
        const WorkOrder after = *bench.told(ProcessId::Milling);
        QCOMPARE(after.lot, before.lot);
        QVERIFY(after.recipe > before.recipe);
        // A reference taught at the machine is a revision too; nothing is loaded for it.
        bench.settle();
        bench.engine.fake.milling.reference_N = 310.0;
        bench.milling->poll();
        QTRY_VERIFY(bench.told(ProcessId::Milling)->recipe > after.recipe);
        QVERIFY(std::holds_alternative<NameOrder>(bench.engine.commands.back().action));
    }
    void aLotThatIsOpenedWhileAPartIsCutWaitsForTheSetup() {
        Bench bench;  // the engine has not taken the setup yet: a part is cut with an older one
        bench.engine.fake.milling.cutting = true;
        bench.engine.fake.milling.setup = 77;
        QVERIFY(bench.openLot(*bench.milling->lots(), "R7", "Lee"));
        QCOMPARE(bench.told(ProcessId::Milling)->lot, std::int64_t{0});  // it would go with what is not loaded
        bench.engine.fake.milling.cutting = false;
        bench.settle();
        bench.milling->poll();
        QCOMPARE(bench.told(ProcessId::Milling)->lot, bench.milling->lots()->current()->id);
    }
    void whatTheWriterRefusesTheEngineIsNotTold() {
        Bench bench;
        bench.settle();
        LotService& lots = *bench.milling->lots();
        {
            const db::Connection other(bench.scratch.path(), db::Access::Write);
            QVERIFY(test::tryExecute(
                other.database(),
                "CREATE TRIGGER none_more BEFORE INSERT ON lots BEGIN SELECT RAISE(ABORT, 'no'); END"));
        }
        QVERIFY(!bench.openLot(lots, "R7", "Lee"));
        QVERIFY(!lots.current());
        QCOMPARE(bench.told(ProcessId::Milling)->lot, std::int64_t{0});
    }
    void turningHasTheSameBook() {
        Bench bench;
        LotService& lots = *bench.turning->lots();
        QVERIFY(bench.openLot(lots, "F1", "Lee"));
        QCOMPARE(bench.told(ProcessId::Turning)->lot, lots.current()->id);
        QVERIFY(bench.told(ProcessId::Turning)->recipe > 0);
        QVERIFY(!bench.milling->lots()->current());
        QCOMPARE(bench.milling->lots()->lots()->size(), std::size_t{0});
        TurningSetup setup = bench.turning->view().setup;
        setup.depth_um = 4.5;
        const WorkOrder before = *bench.told(ProcessId::Turning);
        QVERIFY(bench.wait([&](const auto& answer) { bench.turning->loadSetup(setup, "Lee", "deeper", answer); }));
        QCOMPARE(bench.told(ProcessId::Turning)->lot, before.lot);
        QVERIFY(bench.told(ProcessId::Turning)->recipe > before.recipe);
    }
    void theToolKnowsItsPartsWhateverTheirNumbers() {
        SpscRing<PartRecord> ring(16);
        test::ScratchDatabase scratch;
        db::WriterThread writer(scratch.path(), &ring, {.queueCapacity = 64, .ringPoll_ms = 1, .retry_ms = 2});
        QVERIFY(writer.start());
        test::FakeEngine engine;
        auto reader = std::move(*db::DatabaseReader::open(scratch.path()));
        const auto make = [&] {
            return std::make_unique<StoredMillingService>(
                StoredMillingService::Links{writer, engine, [] { return std::string("Kerf"); }, {}, {}}, *reader,
                *reader, *reader);
        };
        auto service = make();
        engine.fake.milling.setup = service->view().setup.revision;
        const auto open = [&](const char* name) {
            std::optional<bool> ok;
            service->lots()->open({name, 5, {}, {}}, "Lee", [&ok](const Result<void>& r) { ok = r.has_value(); });
            return QTest::qWaitFor([&] { return ok.has_value(); }) && *ok;
        };
        std::uint32_t made = 0;
        const auto cut = [&](std::uint32_t parts) {
            PartRecord part;
            part.process = ProcessId::Milling;
            part.begin_ns = ++made * 1'000'000'000LL;
            part.end_ns = part.begin_ns + 500'000'000;
            part.order = {service->lots()->current() ? service->lots()->current()->id : 0, 0, 0};
            part.milling.stiffnessMean = 8.0;
            part.millingTool.parts = parts;
            const std::size_t before = service->view().cuts.size();
            return ring.tryPush(part) && QTest::qWaitFor([&] { return service->view().cuts.size() > before; });
        };
        QVERIFY(cut(1) && cut(2));
        QVERIFY(open("R7"));
        QVERIFY(cut(3));
        QCOMPARE(service->view().cuts.back().number, 1U);  // the first one of its lot
        QCOMPARE(service->view().cuts.back().lot, std::string("R7"));
        std::optional<bool> fresh;
        service->newTool("Kim", [&fresh](const Result<void>& r) { fresh = r.has_value(); });
        QTRY_VERIFY(fresh.has_value() && *fresh);
        QVERIFY(cut(1));
        QVERIFY(open("R8"));
        QVERIFY(cut(2));
        QCOMPARE(service->view().cuts.back().number, 1U);
        const auto withTool = [&] {
            std::vector<bool> with;
            for (const MillingCutView& one : service->view().cuts) {
                with.push_back(one.withThisTool);
            }
            return with;
        };
        const std::vector<bool> expected{false, false, false, true, true};
        QTRY_COMPARE(withTool(), expected);
        QTRY_VERIFY(!service->view().busy);
        service = make();  // a restart is the same
        QCOMPARE(withTool(), expected);
        QCOMPARE(service->view().cuts.back().lot, std::string("R8"));
        const auto* restored = [&]() -> const RestoreMillingTool* {
            service->poll();
            for (auto command = engine.commands.rbegin(); command != engine.commands.rend(); ++command) {
                if (const auto* tool = std::get_if<RestoreMillingTool>(&command->action)) {
                    return tool;
                }
            }
            return nullptr;
        }();
        QVERIFY(restored != nullptr);
        QCOMPARE(restored->tool.parts, 2U);  // none of its parts is counted twice
    }
};

QTEST_GUILESS_MAIN(TestLots)
#include "tst_lots.moc"
