// SPDX-License-Identifier: GPL-3.0-or-later
// The Quality page and the judging of a lot of a million parts.
#include <benchmark/benchmark.h>

#include <QApplication>
#include <QDir>
#include <QFile>
#include <cstdio>
#include <memory>

#include "app/service/quality/stored_quality_service.h"
#include "tests/db/db_test_support.h"
#include "tests/support/page_bench.h"
#include "ui/pages/quality/quality_page.h"

namespace {

using namespace kerf;

constexpr int kParts = 1'000'000;

std::string lotPath() {
    const QString folder = qEnvironmentVariable("KERF_BENCH_DIR", QDir::tempPath());
    return (folder + QStringLiteral("/kerf-lot-1000000-v1.db")).toStdString();
}

void generate(const std::string& path) {
    std::fprintf(stderr, "generating %s, once ...\n", path.c_str());
    const QString partial = QString::fromStdString(path) + QStringLiteral(".partial");
    QFile::remove(partial);
    {
        (void)db::prepareDatabase(partial.toStdString());
        test::Shop shop(partial.toStdString());
        const QSqlDatabase& database = shop.database();
        db::execute(database, QStringLiteral("PRAGMA synchronous = OFF"));
        db::Transaction transaction(database);
        const QString counter =
            QStringLiteral("WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < %1) ");
        db::execute(database, counter.arg(kParts) +
                                  QStringLiteral("INSERT INTO schedules SELECT i, %1, i, -2.44, 0.5, 0.27, 0.1165, 0, "
                                                 "0.01, 1, 40, 310, 400, '', '', i, '', NULL FROM n")
                                      .arg(shop.lot));
        db::execute(database, counter.arg(kParts) +
                                  QStringLiteral("INSERT INTO parts (id, process, lot_id, number, serial, complete, "
                                                 "machine_begin_ns, machine_end_ns, ended_utc_ms, schedule_id) SELECT "
                                                 "i, 'boring', %1, i, NULL, 1, i * "
                                                 "60000000000, i * 60000000000 + 41000000000, i * 60000, i FROM n")
                                      .arg(shop.lot));
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

struct BigLot {
    BigLot() {
        if (!QFile::exists(QString::fromStdString(lotPath()))) {
            generate(lotPath());
        }
        auto opened = db::DatabaseReader::open(lotPath());
        if (!opened) {
            std::fprintf(stderr, "%s\n", opened.error().english().c_str());
            std::exit(1);
        }
        reader = std::move(*opened);
    }
    std::unique_ptr<db::DatabaseReader> reader;
};

BigLot& bigLot() {
    static BigLot lot;
    return lot;
}

/// What the worker does until the newest parts are judged and charted.
void readAndJudgeTheNewestParts(benchmark::State& state) {
    BigLot& lot = bigLot();
    for (auto unused : state) {
        const auto read = readQualityLot(*lot.reader, 1);
        if (!read || read->quality.parts.size() != kNewestParts) {
            state.SkipWithError("the lot was not read");
            break;
        }
    }
}
BENCHMARK(readAndJudgeTheNewestParts)->Unit(benchmark::kMillisecond);

class NoWriter final : public StoreWriter {
 public:
    void submit(StoreCommand, Done) override {}
    [[nodiscard]] const Sentence& problem() const override { return m_none; }
    [[nodiscard]] std::unique_ptr<Subscription> onProblemChanged(std::function<void()>) override { return {}; }
    [[nodiscard]] std::unique_ptr<Subscription> onPartStored(std::function<void(const StoredPart&)>) override {
        return {};
    }

 private:
    Sentence m_none{};
};

/// From nothing to a page on the screen that is ready for touches; `read`: how many answers of the worker are drawn too
/// (1: the first look, with which the charts stand; 2: all newest parts).
void openThePage(benchmark::State& state) {
    BigLot& lot = bigLot();
    NoWriter writer;
    for (auto unused : state) {
        StoredQualityService::Links links{writer, *lot.reader, *lot.reader, *lot.reader, lotPath(), {}, {}};
        links.background = [answers = state.range(0)](const auto& work, const auto& done) mutable {
            if (answers-- > 0) {
                done(work());
            }
        };
        StoredQualityService service(std::move(links));
        test::PageBench bench;
        bench.services.qualityService = &service;
        bench.services.lots = lot.reader.get();
        bench.show<ui::QualityPage>();
        QApplication::processEvents();
        benchmark::DoNotOptimize(bench.window.grab());
    }
}
BENCHMARK(openThePage)->ArgName("read")->Arg(0)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond);

}  // namespace

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QApplication application(argc, argv);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
