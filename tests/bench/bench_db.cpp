// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QSqlQuery>
#include <cstdio>
#include <memory>

#include "db/writer_thread.h"
#include "tests/db/db_test_support.h"

/// What storing costs and what a long history costs. The history of 1,000,000 parts is generated once into
/// $KERF_BENCH_DIR (default: the system's temporary folder) and used again by later runs.
namespace {

using namespace kerf;

constexpr int kParts = 1'000'000;
constexpr int kPartsPerLot = 50;

std::string historyPath() {
    const QString folder = qEnvironmentVariable("KERF_BENCH_DIR", QDir::tempPath());
    return (folder + QStringLiteral("/kerf-history-1000000-v8.db")).toStdString();
}

void generate(const std::string& path) {
    std::fprintf(stderr, "generating %s, once ...\n", path.c_str());
    const QString partial = QString::fromStdString(path) + QStringLiteral(".partial");
    QFile::remove(partial);
    {
        (void)db::prepareDatabase(partial.toStdString());
        const db::Connection connection(partial.toStdString(), db::Access::Write);
        const QSqlDatabase& database = connection.database();
        db::execute(database, QStringLiteral("PRAGMA synchronous = OFF"));
        db::Transaction transaction(database);
        db::execute(database, "INSERT INTO machines VALUES (1, 'VB-1', 'simulator', 0)");
        const QString counter =
            QStringLiteral("WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < %1) ");
        db::execute(database,
                    counter.arg(20) + "INSERT INTO part_types SELECT i, 'boring', 'Sleeve ' || (40 + i), 0 FROM n");
        db::execute(database,
                    counter.arg(20) + "INSERT INTO recipe_revisions SELECT i, i, 1, '{}', NULL, 'Lee', '', 0 FROM n");
        db::execute(database,
                    counter.arg(kParts / kPartsPerLot) +
                        "INSERT INTO lots (id, machine_id, part_type_id, recipe_revision_id, name, size, estimator, "
                        "opened_utc_ms, "
                        "closed_utc_ms) SELECT i, 1, 1 + i % 20, 1 + i % 20, 'L' || i, 50, 'kalman', i, NULL FROM n");
        db::execute(database,
                    counter.arg(kParts) +
                        "INSERT INTO schedules SELECT i, 1 + (i - 1) / 50, 1 + (i - 1) % 50, -2.44, 0.5, 0.27, 0.1165, "
                        "0, 0.01, 1, 40, 310, 400, '', '', i, '', NULL FROM n");
        db::execute(
            database,
            counter.arg(kParts) +
                "INSERT INTO parts (id, process, lot_id, number, serial, complete, machine_begin_ns, machine_end_ns, "
                "ended_utc_ms, schedule_id) SELECT i, 'boring', 1 + (i - 1) / 50, 1 + (i - 1) % 50, CASE WHEN i % 3 = "
                "0 "
                "THEN 'SN' || i END, 1, i * 60000000000, i * 60000000000 + 41000000000, i * 60000, i FROM n");
        db::execute(database, counter.arg(kParts) + "INSERT INTO feed_traces SELECT i, zeroblob(512) FROM n");
        db::execute(
            database,
            counter.arg(2 * kParts) +
                "INSERT INTO measurements SELECT i, 1 + (i - 1) / 2, 'entry', NULL, (i - 1) % 2, CASE i % 2 WHEN "
                "1 THEN 40.0 ELSE 310.0 END, 50.0 + (i % 37) * 0.0005, 'keypad', 0, 'Kim', '', i * 30000 FROM n");
        transaction.commit();
        db::execute(database, QStringLiteral("PRAGMA wal_checkpoint(TRUNCATE)"));
    }
    QFile::rename(partial, QString::fromStdString(path));
}

db::DatabaseReader& history() {
    static const std::unique_ptr<db::DatabaseReader> reader = [] {
        if (!QFile::exists(QString::fromStdString(historyPath()))) {
            generate(historyPath());
        }
        auto opened = db::DatabaseReader::open(historyPath());
        if (!opened) {
            std::fprintf(stderr, "%s\n", opened.error().english().c_str());
            std::exit(1);
        }
        return std::move(*opened);
    }();
    return *reader;
}

/// So many commits go before the clock runs: the log has been round once and its file grows no more, which costs the
/// disk more than the commit does.
constexpr int kUntilTheLogGrowsNoMore = 1000;

/// One accepted measurement: measurement, estimator state, schedule and audit entry, on the disk when it returns.
void acceptMeasurement(benchmark::State& state) {
    test::ScratchDatabase scratch;
    test::Shop shop(scratch.path());
    const PartId part = shop.addPart(1);
    std::uint32_t revision = 1;
    const auto acceptOne = [&] {
        ScheduleRow next;
        next.lot = shop.lot;
        next.schedule = test::boringPart(1, ++revision).schedule;
        benchmark::DoNotOptimize(
            shop.must(AcceptMeasurement{test::measured(part, 0, 50.0), {test::stateOf(0.5)}, next}));
    };
    db::execute(shop.database(), QStringLiteral("PRAGMA synchronous = OFF"));
    for (int i = 0; i < kUntilTheLogGrowsNoMore; ++i) {
        acceptOne();
    }
    db::execute(shop.database(), QStringLiteral("PRAGMA synchronous = FULL"));
    for (auto unused : state) {
        acceptOne();
    }
}
BENCHMARK(acceptMeasurement)->Unit(benchmark::kMicrosecond)->UseRealTime();

/// What it is held against: the same bytes (the rows of one acceptance as text) in one row of a bare table, one
/// prepared statement, WAL and synchronous=FULL as there, SQLite and its way to the disk as they come.
void bareCommit(benchmark::State& state) {
    constexpr int kBytes = 600;  // 53 + 62 + 63 + 268 + 4 · 32: measurement, state, schedule, audit entry, outbox
    test::ScratchDatabase scratch;
    const QString name = QStringLiteral("bare");
    {
        QSqlDatabase database = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), name);
        database.setDatabaseName(QString::fromStdString(scratch.path() + ".bare"));
        if (!database.open()) {
            state.SkipWithError("no bare data file");
            return;
        }
        db::execute(database, QStringLiteral("PRAGMA journal_mode = WAL"));
        db::execute(database, QStringLiteral("PRAGMA synchronous = FULL"));
        db::execute(database, QStringLiteral("CREATE TABLE bare (id INTEGER PRIMARY KEY, body BLOB)"));
        QSqlQuery begin(database), insert(database), commit(database);
        begin.prepare(QStringLiteral("BEGIN IMMEDIATE"));
        insert.prepare(QStringLiteral("INSERT INTO bare (body) VALUES (?)"));
        commit.prepare(QStringLiteral("COMMIT"));
        const QByteArray body(kBytes, 'x');
        bool taken = true;
        const auto commitOne = [&] {
            insert.bindValue(0, body);
            taken = begin.exec() && insert.exec() && commit.exec() && taken;
        };
        db::execute(database, QStringLiteral("PRAGMA synchronous = OFF"));
        for (int i = 0; i < kUntilTheLogGrowsNoMore; ++i) {
            commitOne();
        }
        db::execute(database, QStringLiteral("PRAGMA synchronous = FULL"));
        for (auto unused : state) {
            commitOne();
        }
        if (!taken) {
            state.SkipWithError("the bare table does not take a row");
        }
    }
    QSqlDatabase::removeDatabase(name);
}
BENCHMARK(bareCommit)->Unit(benchmark::kMicrosecond)->UseRealTime();

/// The same without the wait for the disk: what of it is work.
void acceptMeasurementWithoutSync(benchmark::State& state) {
    test::ScratchDatabase scratch;
    test::Shop shop(scratch.path());
    db::execute(shop.database(), QStringLiteral("PRAGMA synchronous = OFF"));
    const PartId part = shop.addPart(1);
    for (auto unused : state) {
        benchmark::DoNotOptimize(
            shop.must(AcceptMeasurement{test::measured(part, 0, 50.0), {test::stateOf(0.5)}, std::nullopt}));
    }
}
BENCHMARK(acceptMeasurementWithoutSync)->Unit(benchmark::kMicrosecond)->UseRealTime();

/// What the caller's thread pays for it: handing the command over.
void submitFromTheCallersThread(benchmark::State& state) {
    test::ScratchDatabase scratch;
    PartId part = 0;
    {
        test::Shop shop(scratch.path());
        part = shop.addPart(1);
    }
    db::WriterThread writer(scratch.path(), nullptr);
    if (!writer.start()) {
        state.SkipWithError("the writer did not start");
        return;
    }
    for (auto unused : state) {
        bool done = false;
        writer.submit(AcceptMeasurement{test::measured(part, 0, 50.0), {test::stateOf(0.5)}, std::nullopt},
                      [&done](const Result<Receipt>&) { done = true; });
        state.PauseTiming();
        while (!done) {
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        }
        state.ResumeTiming();
    }
}
BENCHMARK(submitFromTheCallersThread)->Unit(benchmark::kMicrosecond)->Iterations(200);

/// From nothing to the first table page of 100 parts with their measurements, and how many there are.
void openHistory(benchmark::State& state) {
    (void)history();
    for (auto unused : state) {
        const auto reader = db::DatabaseReader::open(historyPath());
        benchmark::DoNotOptimize((*reader)->parts({}));
        benchmark::DoNotOptimize((*reader)->count({}, UINT32_MAX));
    }
}
BENCHMARK(openHistory)->Unit(benchmark::kMillisecond);

void page(benchmark::State& state, const PartQuery& query) {
    for (auto unused : state) {
        const auto rows = history().parts(query);
        if (!rows || rows->size() != 100) {
            state.SkipWithError("no full page");
            return;
        }
    }
}
BENCHMARK_CAPTURE(page, newest, PartQuery{})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(page, oldest, PartQuery{.before = 101})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(page, serialPrefixCommon, PartQuery{.text = "SN1"})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(page, serialPrefixRare, PartQuery{.text = "SN123"})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(page, partType, PartQuery{.text = "eve 45"})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(page, lotNamePiece, PartQuery{.text = "L1999"})->Unit(benchmark::kMillisecond);

void searchWithoutMatch(benchmark::State& state) {
    for (auto unused : state) {
        benchmark::DoNotOptimize(history().parts({.text = "zebra"}));
    }
}
BENCHMARK(searchWithoutMatch)->Unit(benchmark::kMillisecond);

void wholeLot(benchmark::State& state) {
    for (auto unused : state) {
        benchmark::DoNotOptimize(history().history(12345));
    }
}
BENCHMARK(wholeLot)->Unit(benchmark::kMillisecond);

}  // namespace

int main(int argc, char** argv) {
    const QCoreApplication application(argc, argv);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
        return 1;
    }
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
