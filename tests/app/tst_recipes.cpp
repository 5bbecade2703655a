// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QTest>
#include <map>
#include <random>

#include "app/service/milling/milling_json.h"
#include "app/service/milling/milling_service.h"
#include "app/service/recipe_book.h"
#include "app/service/tapping/tapping_tuning_json.h"
#include "app/service/thermal/thermal_records.h"
#include "app/service/thermal/thermal_service.h"
#include "app/service/turning/turning_records.h"
#include "app/service/turning/turning_service.h"
#include "db/data_file.h"
#include "db/writer_thread.h"
#include "tests/db/db_test_support.h"
#include "tests/support/golden.h"
#include "tests/support/service_bench.h"

using namespace kerf;
using kerf::test::number;

namespace {

constexpr db::WriterThread::Options kQuick{.queueCapacity = 64, .ringPoll_ms = 1, .retry_ms = 2};

/// A copy of the frozen file of version 2, with what its rooms had kept: setups, limits, tunings, a tool, a law.
struct Frozen {
    Frozen() {
        if (!QFile::copy(QString::fromStdString(test::fixture("db/setups-v2.db")), QString::fromStdString(path()))) {
            qFatal("no frozen file");
        }
        QFile::setPermissions(QString::fromStdString(path()), QFile::ReadOwner | QFile::WriteOwner);
    }
    [[nodiscard]] std::string path() const { return folder.filePath(QStringLiteral("kerf.db")).toStdString(); }
    /// As a console does: brought up to date, earlier forms adopted.
    void open() const {
        const auto file = db::DataFile::open(path());
        if (!file) {
            qFatal("%s", file.error().english().c_str());
        }
    }
    [[nodiscard]] std::unique_ptr<db::DatabaseReader> reader() const {
        return std::move(*db::DatabaseReader::open(path()));
    }
    QTemporaryDir folder;
};

/// What is expected of a revision: part type, author, reason, and which record it was.
struct Brought {
    ProcessId process;
    const char* partType;
    std::uint32_t revision;
    const char* author;
    const char* reason;
    std::int64_t record;
};
const std::vector<Brought>& brought() {
    static const std::vector<Brought> kAll{
        {ProcessId::Milling, "Rail", 1, "Lee", "drawing B", 1},
        {ProcessId::Tapping, "M8", 1, "Park", "accepted", 2},
        {ProcessId::Turning, "Face", 1, "이수진", "새 소재", 3},
        {ProcessId::Thermal, "VB-1", 1, "Park", "tighter", 4},
        {ProcessId::Milling, "Bracket", 1, "Lee", "chosen", 5},
        {ProcessId::Milling, "Bracket", 2, "Kim", "soft wall", 6},
        {ProcessId::Milling, "Soft", 1, "Park", "chosen", 7},
        {ProcessId::Tapping, "M10x1", 1, "Lee", "accepted", 9},
        {ProcessId::Turning, "Face", 2, "Lee", "setup changed", 11},
        {ProcessId::Thermal, "VB-1", 2, "Park", "summer", 12},
        {ProcessId::Milling, "Rail", 2, "Lee", "more depth", 14},
        {ProcessId::Tapping, "M8", 2, "Park", "rolled back", 15},
    };
    return kAll;
}

/// What a service stands between, on a file, and the service that is asked most.
struct Bench : test::ServiceBench {
    using ServiceBench::ServiceBench;
    [[nodiscard]] std::unique_ptr<StoredMillingService> milling() {
        StoredMillingService::Links links{writer, engine, [] { return std::string("Kim"); }, {}, {}};
        return std::make_unique<StoredMillingService>(std::move(links), *reader, *reader, *reader);
    }
};

}  // namespace

/// Setups of every process are recipes: what was stored before is brought along, none vanishes, any can come back.
class TestRecipes : public QObject {
    Q_OBJECT
 private slots:
    void setupsOfVersion2AreRecipes() {
        const Frozen frozen;
        frozen.open();
        const auto reader = frozen.reader();
        const db::Connection now(frozen.path(), db::Access::Read);
        for (const ProcessId process :
             {ProcessId::Milling, ProcessId::Turning, ProcessId::Thermal, ProcessId::Tapping}) {
            test::ScratchDatabase unused;
            db::WriterThread writer(unused.path(), nullptr, kQuick);
            RecipeBook book(writer, *reader, process);
            const auto all = book.all();
            QVERIFY(all);
            std::vector<Brought> expected;
            std::ranges::copy_if(brought(), std::back_inserter(expected),
                                 [process](const Brought& one) { return one.process == process; });
            QCOMPARE(all->size(), expected.size());
            for (std::size_t i = 0; i < expected.size(); ++i) {  // in the order in which they were accepted
                const RecipeBook::Recipe& recipe = (*all)[i];
                QCOMPARE(recipe.partType, std::string(expected[i].partType));
                QCOMPARE(recipe.revision.revision, expected[i].revision);
                QCOMPARE(recipe.revision.author, std::string(expected[i].author));
                QCOMPARE(recipe.revision.reason, std::string(expected[i].reason));
                db::Statement record(now.database(), "SELECT body, created_utc_ms FROM room_records WHERE id = ?");
                QVERIFY(record.bind(expected[i].record).run().next());
                QCOMPARE(recipe.revision.parametersJson, record.text(0));  // to the last digit
                QCOMPARE(recipe.revision.createdUtc_ms, record.integer(1));
            }
        }
        QCOMPARE(number(now.database(), "SELECT count(*) FROM room_records"), std::int64_t{15});  // they stay
        const auto boring = reader->allRecipes(ProcessId::Boring);
        QVERIFY(boring);
        QCOMPARE(boring->size(), std::size_t{1});
        const auto verdict = reader->verifyAudit();
        QVERIFY(verdict);
        QVERIFY2(verdict->finding.empty(), verdict->finding.english().c_str());
        QVERIFY(db::checkDatabase(frozen.path()));
        // They go to the shop like any other revision.
        QCOMPARE(number(now.database(), "SELECT count(*) FROM outbox WHERE table_name = 'recipe_revisions'"),
                 number(now.database(), "SELECT count(*) FROM recipe_revisions"));
        QCOMPARE(number(now.database(), "SELECT count(*) FROM outbox WHERE table_name = 'part_types'"),
                 number(now.database(), "SELECT count(*) FROM part_types"));
        frozen.open();  // a second start brings nothing along
        QCOMPARE(number(now.database(), "SELECT count(*) FROM recipe_revisions"), std::int64_t{13});
    }
    void servicesGoOnWithThem() {
        const Frozen frozen;
        frozen.open();
        Bench bench(frozen.path());
        const auto milling = bench.milling();
        QCOMPARE(milling->view().partType, std::string("Rail"));
        QCOMPARE(milling->view().partTypes, (std::vector<std::string>{"Bracket", "Rail", "Soft"}));
        QCOMPARE(milling->view().setup.reference_N, 355.1);
        const auto exchange = std::make_unique<TurningExchange>();
        const StoredTurningService turning({bench.writer, bench.engine, *exchange, *bench.reader, *bench.reader, {}});
        QCOMPARE(turning.view().setup.depth_um, 5.25);
        QCOMPARE(turning.view().controller, TurningController::Tones);
        const auto thermalExchange = std::make_unique<ThermalExchange>();
        const StoredThermalService::Links links{bench.engine, bench.writer, *thermalExchange};
        const StoredThermalService thermal(links, *bench.reader, *bench.reader);
        QCOMPARE(thermal.view().setup.allowed_um, 5.0);
        RecipeBook taps(bench.writer, *bench.reader, ProcessId::Tapping);
        const auto tunings = taps.all();
        QVERIFY(tunings && tunings->size() == 3);
        for (const RecipeBook::Recipe& recipe : *tunings) {
            QVERIFY(formats::tuningFromJson(recipe.revision.parametersJson));
        }
    }
    void aRevisionOfBeforeThatWasChangedIsFound_data() {
        QTest::addColumn<QString>("sql");
        QTest::newRow("parameters") << "UPDATE recipe_revisions SET parameters = replace(parameters, '333.3', '433.3') "
                                       "WHERE parameters LIKE '%333.3%'";
        QTest::newRow("author") << "UPDATE recipe_revisions SET author = 'Kim' WHERE author = 'Park'";
        QTest::newRow("one gone")
            << "DELETE FROM recipe_revisions WHERE id = (SELECT max(id) - 3 FROM recipe_revisions)";
        QTest::newRow("the record as well")
            << "UPDATE room_records SET body = replace(body, '333.3', '433.3') WHERE id = 1";
        QTest::newRow("one told twice") << "INSERT INTO recipe_revisions (part_type_id, revision, parameters, author, "
                                           "reason, created_utc_ms) SELECT "
                                           "part_type_id, revision + 1, parameters, author, reason, created_utc_ms "
                                           "FROM recipe_revisions WHERE id = "
                                           "(SELECT max(id) FROM recipe_revisions)";
    }
    void aRevisionOfBeforeThatWasChangedIsFound() {
        QFETCH(QString, sql);
        const Frozen frozen;
        frozen.open();
        const db::Connection now(frozen.path(), db::Access::Write);
        for (const char* trigger :
             {"recipe_revisions_no_update", "recipe_revisions_no_delete", "room_records_no_update"}) {
            QVERIFY(test::tryExecute(now.database(), QStringLiteral("DROP TRIGGER %1").arg(trigger).toUtf8()));
        }
        QVERIFY(test::tryExecute(now.database(), sql.toUtf8()));
        QVERIFY(!frozen.reader()->verifyAudit()->finding.empty());
    }
    /// Property: however many setups of however many part types in whatever order, each stays reachable as it was.
    void everyOneOfSixHundredSetupsStaysReachable_data() {
        QTest::addColumn<unsigned>("seed");
        for (const unsigned seed : {1U, 2U, 3U}) {
            QTest::addRow("seed %u", seed) << seed;
        }
    }
    void everyOneOfSixHundredSetupsStaysReachable() {
        QFETCH(unsigned, seed);
        constexpr int kSetups = 600;
        constexpr std::array kProcesses{ProcessId::Milling, ProcessId::Turning, ProcessId::Thermal, ProcessId::Tapping};
        test::ScratchDatabase scratch;
        std::mt19937 draw(seed);
        std::map<std::pair<ProcessId, std::string>, std::vector<std::string>> given;
        {
            const db::Connection connection(scratch.path(), db::Access::Write);
            db::Store store(connection.database());
            for (int i = 0; i < kSetups; ++i) {
                const ProcessId process = kProcesses[draw() % kProcesses.size()];
                const std::string partType = "T" + std::to_string(draw() % 5);
                auto& known = given[{process, partType}];
                const bool back = !known.empty() && draw() % 10 == 0;
                const std::size_t of = back ? draw() % known.size() : 0;
                const std::string text = back ? known[of] : "{\"reference_n\":" + std::to_string(i) + ".1}";
                const auto restored = back ? std::optional(static_cast<std::uint32_t>(of + 1)) : std::nullopt;
                const auto receipt =
                    store.apply(KeepRecipe{process, partType, text, "Lee", std::to_string(i), restored});
                QVERIFY(receipt);
                known.push_back(text);
                QCOMPARE(static_cast<std::size_t>(receipt->second), known.size());
            }
        }
        db::WriterThread writer(scratch.path(), nullptr, kQuick);
        const auto reader = std::move(*db::DatabaseReader::open(scratch.path()));
        std::size_t found = 0;
        for (const auto& [of, texts] : given) {
            RecipeBook book(writer, *reader, of.first);
            const auto revisions = book.revisions(of.second);
            QVERIFY(revisions);
            QCOMPARE(revisions->size(), texts.size());
            for (std::size_t i = 0; i < texts.size(); ++i, ++found) {
                const auto one = book.revision(of.second, static_cast<std::uint32_t>(i + 1));
                QVERIFY(one);
                QCOMPARE(one->parametersJson, texts[i]);
                if (one->restoredFrom) {
                    QCOMPARE(texts[*one->restoredFrom - 1], texts[i]);
                }
            }
            const auto newest = book.newest();
            QVERIFY(std::ranges::any_of(*newest, [&](const RecipeBook::Recipe& recipe) {
                return recipe.partType == of.second && recipe.revision.revision == texts.size();
            }));
        }
        QCOMPARE(found, static_cast<std::size_t>(kSetups));
        const auto verdict = reader->verifyAudit();
        QVERIFY2(verdict && verdict->finding.empty(), verdict->finding.english().c_str());
    }
    void milledSetupsAreListedComparedAndRolledBack() {
        test::ScratchDatabase scratch;
        Bench bench(scratch.path());
        auto milling = bench.milling();
        RecipeHistory& history = *milling->recipes();
        QVERIFY(history.revisions()->empty());  // nothing was ever changed
        const MillingSetup first = milling->view().setup;
        MillingSetup setup = first;
        setup.reference_N = 300.0;
        QVERIFY(bench.wait([&](const auto& done) { milling->saveSetup(setup, "Lee", "soft", done); }));
        setup.reference_N = 280.0;
        QVERIFY(bench.wait([&](const auto& done) { milling->saveSetup(setup, "Park", "softer", done); }));
        QCOMPARE(history.partType(), std::string(StoredMillingService::kFirstPartType));
        auto known = history.revisions();
        QVERIFY(known);
        QCOMPARE(known->size(), std::size_t{3});  // and what it began with
        QCOMPARE(known->at(0).author, std::string("Park"));
        QCOMPARE(known->at(2).author, std::string("Kerf"));
        const auto changes = history.compare(1, 3);
        QVERIFY(changes);
        QCOMPARE(changes->size(), std::size_t{1});
        QCOMPARE(changes->front().key, std::string("milling.reference_n"));
        QCOMPARE(changes->front().before, std::string("392.0"));
        QCOMPARE(changes->front().after, std::string("280.0"));
        QVERIFY(!bench.wait([&](const auto& done) { history.restore(9, "Lee", "as before", done); }));
        QVERIFY(!bench.wait([&](const auto& done) { history.restore(1, "", "as before", done); }));
        QVERIFY(bench.wait([&](const auto& done) { history.restore(1, "Lee", "as before", done); }));
        QCOMPARE(milling->view().setup.reference_N, first.reference_N);
        known = history.revisions();
        QCOMPARE(known->front().revision, 4U);
        QCOMPARE(known->front().restoredFrom, std::optional(1U));
        QCOMPARE(known->front().reason, std::string("as before"));
        milling = bench.milling();
        QCOMPARE(milling->view().setup.reference_N, first.reference_N);  // over a restart
        QVERIFY(bench.reader->verifyAudit()->finding.empty());
    }
    void aRollBackIsCheckedAsIfItWereTyped() {
        test::ScratchDatabase scratch;
        Bench bench(scratch.path());
        const auto milling = bench.milling();
        MillingSetup setup = milling->view().setup;
        setup.overload_N = 500.0;  // lowered: rolling it back raises a limit, which wants a reason
        QVERIFY(bench.wait([&](const auto& done) { milling->saveSetup(setup, "Lee", "soft", done); }));
        QVERIFY(!bench.wait([&](const auto& done) { milling->recipes()->restore(1, "Lee", " ", done); }));
        QCOMPARE(milling->view().setup.overload_N, 500.0);
        bench.engine.fake.milling.cutting = true;
        QVERIFY(!bench.wait([&](const auto& done) { milling->recipes()->restore(1, "Lee", "hard", done); }));
        bench.engine.fake.milling.cutting = false;
        QVERIFY(bench.wait([&](const auto& done) { milling->recipes()->restore(1, "Lee", "hard", done); }));
        QCOMPARE(milling->view().setup.overload_N, 650.0);
    }
    void theBlankIsOfTheRecipe() {
        test::ScratchDatabase scratch;
        Bench bench(scratch.path());
        MillingBlank wall;
        wall.count = 2;
        wall.begin_mm[1] = 20.0;
        wall.height_mm[0] = 1.0;
        wall.height_mm[1] = 2.5;
        wall.end_mm = 60.0;
        auto service = bench.milling();
        // Setup and blank are changed at once: neither takes back the other.
        std::optional<Result<void>> first;
        MillingSetup setup = service->view().setup;
        setup.reference_N = 345.0;
        service->saveSetup(setup, "Lee", "drawing", [&first](const Result<void>& result) { first = result; });
        QVERIFY(bench.wait([&](const auto& done) { service->saveBlank(wall, "wall.csv", "Lee", done); }));
        QVERIFY(first && *first);
        QCOMPARE(service->view().setup.reference_N, 345.0);
        QCOMPARE(service->view().blankSource, std::string("wall.csv"));
        QCOMPARE(service->recipes()->revisions()->size(), std::size_t{3});  // what held before is the first
        QCOMPARE(service->recipes()->revisions()->front().reason, std::string("from wall.csv"));
        const auto changes = service->recipes()->compare(2, 3);
        QVERIFY(changes && std::ranges::any_of(*changes, [](const auto& one) { return one.key == "blank.source"; }));
        wall.height_mm[1] = 3.0;
        QVERIFY(bench.wait([&](const auto& done) { service->saveBlank(wall, "", "Lee", done); }));
        service = nullptr;
        service = bench.milling();
        QCOMPARE(service->view().blank.height_mm[1], 3.0);
        QVERIFY(bench.wait([&](const auto& done) { service->recipes()->restore(3, "Lee", "as it was", done); }));
        QCOMPARE(service->view().blank.height_mm[1], 2.5);
        QCOMPARE(service->view().blankSource, std::string("wall.csv"));
        QVERIFY(bench.wait([&](const auto& done) { service->recipes()->restore(1, "Lee", "no blank", done); }));
        QCOMPARE(service->view().blank.count, std::uint16_t{0});
        QVERIFY(bench.reader->verifyAudit()->finding.empty());
    }
    void theLawOfTurningIsOfTheRecipe() {
        test::ScratchDatabase scratch;
        Bench bench(scratch.path());
        const auto exchange = std::make_unique<TurningExchange>();
        const auto open = [&] {
            return std::make_unique<StoredTurningService>(
                StoredTurningService::Links{bench.writer, bench.engine, *exchange, *bench.reader, *bench.reader, {}});
        };
        auto service = open();
        const auto count = [&](const auto& is) { return std::ranges::count_if(bench.engine.commands, is); };
        const auto isSetup = [](const Command& one) { return std::holds_alternative<LoadTurningSetup>(one.action); };
        service->poll();
        const auto loaded = count(isSetup);
        QVERIFY(bench.wait([&](const auto& done) { service->setController(TurningController::Pi, "Lee", done); }));
        QCOMPARE(count(isSetup), loaded);  // the loop has the setup already
        QCOMPARE(service->recipes()->revisions()->front().reason, std::string("law chosen"));
        TurningSetup setup = service->view().setup;
        setup.depth_um = 4.5;
        std::optional<Result<void>> first;
        service->loadSetup(setup, "Lee", "drawing", [&first](const Result<void>& result) { first = result; });
        QVERIFY(bench.wait([&](const auto& done) { service->setController(TurningController::Open, "Lee", done); }));
        QVERIFY(first && *first);
        QCOMPARE(service->view().setup.depth_um, 4.5);
        QCOMPARE(service->view().controller, TurningController::Open);
        service = nullptr;
        service = open();
        QCOMPARE(service->view().setup.depth_um, 4.5);
        QCOMPARE(service->view().controller, TurningController::Open);
        QVERIFY(bench.wait([&](const auto& done) { service->recipes()->restore(2, "Lee", "as it was", done); }));
        QCOMPARE(service->view().controller, TurningController::Pi);
        QVERIFY(service->view().setup.depth_um != 4.5);
        const auto law = std::ranges::find_if(
            bench.engine.commands.rbegin(), bench.engine.commands.rend(),
            [](const Command& one) { return std::holds_alternative<SetTurningController>(one.action); });
        QCOMPARE(std::get<SetTurningController>(law->action).controller, TurningController::Pi);
        QVERIFY(bench.reader->verifyAudit()->finding.empty());
    }
    /// What stood beside the recipe is brought into it at the first start, once, in the log like any other revision.
    void blankAndLawOfBeforeAreBroughtIntoTheRecipe() {
        const Frozen frozen;
        frozen.open();
        {
            test::Shop shop(frozen.path());
            const char* blank = R"({"begin_mm":[0.0],"height_mm":[0.1],"end_mm":60.0,"source":"wall.csv"})";
            (void)shop.must(AddRoomRecord{ProcessId::Milling, "blank", "Rail", blank, "Lee", "from wall.csv"});
            (void)shop.must(AddRoomRecord{ProcessId::Milling, "blank", "Never set", blank, "Lee", "from wall.csv"});
            (void)shop.must(
                AddRoomRecord{ProcessId::Turning, "controller", {}, R"({"controller":"pi"})", "Lee", "law chosen"});
        }
        const auto exchange = std::make_unique<TurningExchange>();
        std::size_t milled = 0;
        std::size_t turned = 0;
        for (int start = 0; start < 3; ++start) {
            Bench bench(frozen.path());
            auto milling = bench.milling();
            StoredTurningService turning(
                StoredTurningService::Links{bench.writer, bench.engine, *exchange, *bench.reader, *bench.reader, {}});
            QCOMPARE(milling->view().partType, std::string("Rail"));
            QCOMPARE(milling->view().blank.height_mm[0], 0.1);
            QCOMPARE(milling->view().setup.reference_N, 355.1);
            QCOMPARE(turning.view().controller, TurningController::Pi);
            QCOMPARE(turning.view().setup.depth_um, 5.25);
            QTRY_VERIFY(!milling->view().busy);
            QTRY_VERIFY(bench.reader->allRecipes(ProcessId::Turning)->size() >= 3);
            if (start == 0) {
                milled = bench.reader->allRecipes(ProcessId::Milling)->size();
                turned = bench.reader->allRecipes(ProcessId::Turning)->size();
                QCOMPARE(turned, std::size_t{3});
                const auto revisions = *milling->recipes()->revisions();
                QCOMPARE(revisions.size(), std::size_t{3});
                QCOMPARE(revisions.front().author, std::string("Kerf"));
                QCOMPARE(revisions.front().reason, std::string("blank profile of before"));
                // A revision of before says no blank: the one that holds stays.
                QVERIFY(bench.wait([&](const auto& done) { milling->recipes()->restore(1, "Lee", "old", done); }));
                QCOMPARE(milling->view().setup.reference_N, 333.3);
                QCOMPARE(milling->view().blank.height_mm[0], 0.1);
                QVERIFY(bench.wait([&](const auto& done) { milling->recipes()->restore(3, "Lee", "new", done); }));
                milled += 2;
            }
            QCOMPARE(bench.reader->allRecipes(ProcessId::Milling)->size(), milled);
            QCOMPARE(bench.reader->allRecipes(ProcessId::Turning)->size(), turned);
            const auto verdict = bench.reader->verifyAudit();
            QVERIFY2(verdict && verdict->finding.empty(), verdict->finding.english().c_str());
        }
    }
    void limitsOfTheShiftAreStoredFirstAndRolledBack() {
        test::ScratchDatabase scratch;
        Bench bench(scratch.path());
        const auto exchange = std::make_unique<ThermalExchange>();
        StoredThermalService thermal({bench.engine, bench.writer, *exchange}, *bench.reader, *bench.reader);
        const auto loaded = [&] {
            std::optional<ThermalSetup> last;
            for (const Command& command : bench.engine.commands) {
                if (const auto* load = std::get_if<LoadThermalSetup>(&command.action)) {
                    last = load->setup;
                }
            }
            return last;
        };
        ThermalSetup setup = thermal.view().setup;
        const auto change = [&] {
            return bench.wait([&](const auto& done) { thermal.changeSetup(setup, "Park", "drawing", done); });
        };
        setup.allowed_um = 0.0;
        QVERIFY(!change());  // out of range: neither stored nor sent
        setup.allowed_um = 6.0;
        std::optional<Result<void>> told;
        thermal.changeSetup(setup, "Park", "drawing", [&told](const Result<void>& result) { told = result; });
        QVERIFY(!loaded() && !told);  // not before it is on the disk
        QTRY_VERIFY(told && *told);
        QCOMPARE(thermal.view().setup.allowed_um, 6.0);
        QVERIFY(loaded() && loaded()->allowed_um == 6.0);
        bench.engine.ringFull = true;  // the engine takes nothing: it is told later
        setup.allowed_um = 7.0;
        QVERIFY(change());
        QCOMPARE(thermal.view().setup.allowed_um, 7.0);
        QCOMPARE(loaded()->allowed_um, 6.0);
        bench.engine.ringFull = false;
        thermal.poll();
        QCOMPARE(loaded()->allowed_um, 7.0);
        QCOMPARE(thermal.recipes()->partType(), std::string("Simulator"));
        QVERIFY(bench.wait([&](const auto& done) { thermal.recipes()->restore(1, "Park", "as before", done); }));
        QCOMPARE(thermal.view().setup.allowed_um, ThermalSetup{}.allowed_um);
        QCOMPARE(loaded()->allowed_um, ThermalSetup{}.allowed_um);
        QCOMPARE(thermal.recipes()->revisions()->size(), std::size_t{4});
    }
};

QTEST_GUILESS_MAIN(TestRecipes)
#include "tst_recipes.moc"
