// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "app/service/milling/milling_service.h"
#include "tests/support/service_bench.h"

using namespace kerf;

namespace {

/// The service on a real database, with rights by name: Kim is an operator, Lee a setter, Park an engineer.
struct Bench : test::ServiceBench {
    Bench() { open(); }
    void open() {
        service.reset();
        readAnew();
        StoredMillingService::Links links{writer, engine, [] { return std::string("Kerf"); }, {}, {}};
        links.rights = [](const std::string& author, Deed deed) -> std::optional<Sentence> {
            const Trust has = author == "Park" ? Trust::Engineer : author == "Lee" ? Trust::Setter : Trust::Operator;
            return has >= permissionOf(deed).least ? std::nullopt : std::optional(Sentence("not trusted with it"));
        };
        service = std::make_unique<StoredMillingService>(std::move(links), *reader, *reader, *reader);
    }
    [[nodiscard]] Result<void> save(const MillingSetup& setup, const char* author) {
        return wait([&](const auto& answer) { service->saveSetup(setup, author, "drawing", answer); });
    }
    [[nodiscard]] Result<void> choose(const std::string& name, const char* author) {
        return wait([&](const auto& answer) { service->choosePartType(name, author, answer); });
    }

    std::unique_ptr<StoredMillingService> service;
};

std::array<double, kMillingKxFilters> millingToolWeights(std::size_t likely) {
    std::array<double, kMillingKxFilters> weights{};
    weights.fill(-10.0);
    weights[likely] = 0.0;
    return weights;
}

}  // namespace

/// What the milling service keeps, and from whom it takes it.
class TestMillingService : public QObject {
    Q_OBJECT
 private slots:
    void limitsAreRaisedByAnEngineerAlone() {
        Bench bench;
        MillingSetup setup = bench.service->view().setup;
        setup.overload_N = 1500.0;
        QVERIFY(!bench.save(setup, "Kim"));
        QVERIFY(!bench.save(setup, "Lee"));
        QVERIFY(!bench.save(setup, ""));
        QCOMPARE(bench.service->view().setup.overload_N, 650.0);
        QVERIFY(bench.save(setup, "Park"));
        QCOMPARE(bench.service->view().setup.overload_N, 1500.0);
        setup.overload_N = 500.0;
        QVERIFY(!bench.save(setup, "Kim"));
        QVERIFY(bench.save(setup, "Lee"));  // a setter lowers it
        QVERIFY(!bench.choose("Bracket", "Kim"));
        QVERIFY(bench.wait([&](const auto& answer) { bench.service->newTool("Kim", answer); }));
    }
    void aNewToolBeginsFromTheOnesBefore() {
        Bench bench;
        test::Shop shop(bench.scratch.path());
        std::int64_t part = 0;
        // What a tool leaves behind, as the service writes it after a cut.
        const auto wornOut = [&](std::int64_t since, double stiffness, std::size_t likely, double radius_mm) {
            MillingToolRecord record;
            record.learnt = true;
            record.since = since;
            record.lastPart = since + 10;
            record.tool.parts = 10;
            record.tool.firstStiffness = stiffness;
            record.tool.kxLogWeight.fill(-10.0);
            record.tool.kxLogWeight[likely] = 0.0;
            record.partType = StoredMillingService::kFirstPartType;
            record.toolRadius_mm = radius_mm;
            record.flutes = 4;
            part = record.lastPart;
            (void)shop.must(AddRoomRecord{ProcessId::Milling, "tool", {}, millingToolJson(record), "Kerf", {}});
        };
        wornOut(0, 7.9, 1, 5.0);
        wornOut(10, 8.0, 1, 5.0);
        wornOut(20, 9.5, 5, 5.0);
        wornOut(30, 6.0, 4, 3.0);  // another cutter
        MillingToolRecord fresh;   // a new one goes in, and the console ends
        fresh.since = 40;
        fresh.lastPart = part;
        (void)shop.must(AddRoomRecord{ProcessId::Milling, "tool", {}, millingToolJson(fresh), "Kim", "new tool"});
        bench.open();
        const auto& memory = [&]() -> const MillingMemoryView& { return bench.service->view().memory; };
        QCOMPARE(memory().tools.size(), std::size_t{3});
        QCOMPARE(memory().tools.front().since, std::int64_t{20});  // newest first
        QVERIFY(memory().lnKx && memory().used && memory().lnKx->tools == 3);
        const double wide = memory().stiffness->half95;
        const auto restored = [&]() -> std::array<double, kMillingKxFilters> {
            for (auto command = bench.engine.commands.rbegin(); command != bench.engine.commands.rend(); ++command) {
                if (const auto* tool = std::get_if<RestoreMillingTool>(&command->action)) {
                    return tool->tool.kxLogWeight;
                }
            }
            return {};
        };
        QCOMPARE(restored(), milling::toolMemory(std::array<milling::PastTool, 3>{{{9.5, millingToolWeights(5), true},
                                                                                   {8.0, millingToolWeights(1), true},
                                                                                   {7.9, millingToolWeights(1), true}}})
                                 .kxLogWeight);
        // The odd one is left out, with a reason; all after it is computed again, over a restart too.
        QVERIFY(!bench.wait([&](const auto& answer) { bench.service->leaveOut(20, true, "Lee", "", answer); }));
        QVERIFY(
            !bench.wait([&](const auto& answer) { bench.service->leaveOut(20, true, "Kim", "other bar", answer); }));
        QVERIFY(bench.wait([&](const auto& answer) { bench.service->leaveOut(20, true, "Lee", "other bar", answer); }));
        for (int restart = 0; restart < 2; ++restart) {
            QVERIFY(memory().tools.front().leftOut);
            QCOMPARE(memory().tools.front().reason, std::string("other bar"));
            QCOMPARE(memory().lnKx->tools, 2U);
            QVERIFY(std::abs(memory().stiffness->mean - 7.95) < 1e-12 && memory().stiffness->half95 < wide);
            bench.service->poll();
            const auto weights = restored();
            QCOMPARE(std::ranges::max_element(weights) - weights.begin(), std::ptrdiff_t{1});
            bench.open();
        }
        QVERIFY(
            bench.wait([&](const auto& answer) { bench.service->leaveOut(20, false, "Lee", "was right", answer); }));
        QCOMPARE(memory().lnKx->tools, 3U);
        // Another part type: the tool's k_x counts, the material's ln(C b) does not.
        QVERIFY(bench.choose("Soft", "Park"));
        QVERIFY(memory().lnKx && !memory().stiffness);
    }
    /// Somebody says that a new tool is in, and a part begins before the engine hears of it.
    void aNewToolThatTheEngineRefusedIsToldAfterThePart() {
        Bench bench;
        const auto told = [&bench] {
            return std::ranges::count_if(bench.engine.commands, [](const Command& command) {
                return std::holds_alternative<NewMillingTool>(command.action);
            });
        };
        bench.engine.refuseWith = Sentence("A part is being cut.");
        QVERIFY(bench.wait([&](const auto& answer) { bench.service->newTool("Lee", answer); }));
        bench.service->poll();
        QCOMPARE(told(), std::ptrdiff_t{1});
        QCOMPARE(bench.service->view().problem.english(), std::string("A part is being cut."));
        bench.engine.refuseWith = {};
        ++bench.engine.fake.partSequence;
        for (int i = 0; i < 30; ++i) {
            bench.service->poll();
        }
        QCOMPARE(told(), std::ptrdiff_t{2});
        QVERIFY(bench.service->view().problem.empty());
    }
    void partTypesKeepTheirOwnLimitOverARestart() {
        Bench bench;
        MillingSetup setup = bench.service->view().setup;
        setup.overload_N = 400.0;
        setup.reference_N = 300.0;
        QVERIFY(bench.choose("Soft", "Park") && bench.save(setup, "Park"));
        QVERIFY(bench.choose("Like soft", "Park"));  // takes the setup it finds, and is never saved itself
        setup.overload_N = 1500.0;
        QVERIFY(bench.choose("Hard", "Park") && bench.save(setup, "Park"));
        for (int i = 0; i < 600; ++i) {  // more setups than were read once
            if (i == 300) {              // another one in between
                QVERIFY(bench.choose("Like soft", "Park"));
                QCOMPARE(bench.service->view().setup.overload_N, 400.0);
                QVERIFY(bench.choose("Hard", "Park"));
                QCOMPARE(bench.service->view().setup.overload_N, 1500.0);
            }
            setup.wearWarning = 0.3 + 0.001 * (i % 7);
            QVERIFY(bench.save(setup, "Park"));
        }
        bench.open();
        const auto verdict = bench.reader->verifyAudit();
        QVERIFY2(verdict && verdict->finding.empty(), verdict->finding.english().c_str());
        QCOMPARE(bench.service->view().partType, std::string("Hard"));
        QCOMPARE(bench.service->view().partTypes.size(), std::size_t{4});
        QCOMPARE(bench.service->view().setup.overload_N, 1500.0);
        for (const char* soft : {"Soft", "Like soft"}) {
            QVERIFY(bench.choose(soft, "Park"));
            QCOMPARE(bench.service->view().setup.overload_N, 400.0);
        }
    }
};
QTEST_GUILESS_MAIN(TestMillingService)
#include "tst_milling_service.moc"
