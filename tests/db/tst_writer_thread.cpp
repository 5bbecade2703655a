// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QSignalSpy>
#include <QSqlQuery>
#include <QTest>
#include <thread>

#include "db/data_file.h"
#include "db/writer_thread.h"
#include "db_test_support.h"

using namespace kerf;
using db::WriterThread;

namespace {
constexpr WriterThread::Options kQuick{.queueCapacity = 64, .ringPoll_ms = 1, .retry_ms = 2};

/// A writer on a scratch file with a lot open for boring.
struct Bench {
    explicit Bench(std::size_t ringSize = 64, WriterThread::Options options = kQuick)
        : ring(ringSize), writer(scratch.path(), &ring, options) {
        {
            test::Shop shop(scratch.path());
            lot = shop.lot;
            part = shop.addPart(1);
            (void)shop.must(SetActiveLot{ProcessId::Boring, lot, "Lee"});
        }
        if (const auto started = writer.start(); !started) {
            qFatal("%s", started.error().english().c_str());
        }
    }
    [[nodiscard]] std::int64_t count(const char* table) const {
        const db::Connection reader(scratch.path(), db::Access::Read);
        return db::integerOf(reader.database(), QStringLiteral("SELECT count(*) FROM %1").arg(QLatin1String(table)));
    }
    /// Blocks this thread, without its event loop, until so many of the engine's parts are on disk.
    void blockUntilStored(std::uint64_t parts) const {
        for (std::uint64_t now = writer.partsStored().load(); now < parts; now = writer.partsStored().load()) {
            writer.partsStored().wait(now);
        }
    }
    test::ScratchDatabase scratch;
    SpscRing<PartRecord> ring;
    WriterThread writer;
    LotId lot{0};
    PartId part{0};
};

AcceptMeasurement entry(PartId part, double diameter_mm) {
    return {test::measured(part, 0, diameter_mm), {test::stateOf(0.5)}, std::nullopt};
}
}  // namespace

/// The one writer: never waits for the caller, never loses a part, says what went wrong.
class TestWriterThread : public QObject {
    Q_OBJECT
 private slots:
    void answerComesOnTheCallersThreadAfterTheCommit() {
        Bench bench;
        std::optional<MeasurementId> id;
        const QThread* answeredOn = nullptr;
        bench.writer.submit(entry(bench.part, 50.01), [&](const Result<Receipt>& receipt) {
            QVERIFY(receipt);
            id = receipt->id;
            answeredOn = QThread::currentThread();
            QCOMPARE(bench.count("measurements"), std::int64_t{1});  // another connection sees it
        });
        QVERIFY(!id);  // submit() only hands over
        QTRY_VERIFY(id);
        QCOMPARE(answeredOn, QThread::currentThread());
    }
    void answersKeepTheOrderOfSubmission() {
        Bench bench;
        std::vector<int> order;
        for (int i = 0; i < 20; ++i) {
            bench.writer.submit(ChangeSetting{"k", std::to_string(i), "Lee", ""}, [&order, i](const auto& done) {
                QVERIFY(done);
                order.push_back(i);
            });
        }
        QTRY_COMPARE(order.size(), std::size_t{20});
        QVERIFY(std::is_sorted(order.begin(), order.end()));
    }
    void refusalComesBackAsASentence() {
        Bench bench;
        std::optional<Sentence> reason;
        bench.writer.submit(entry(bench.part + 999, 50.0), [&](const Result<Receipt>& done) {
            QVERIFY(!done);
            reason = done.error();
        });
        QTRY_VERIFY(reason);
        QVERIFY(reason->english().find("not stored") != std::string::npos);
        QVERIFY(bench.writer.problem().empty());  // a wrong entry is no fault of the store
    }
    void enginesPartsAreStoredAndAnnounced() {
        Bench bench;
        std::vector<StoredPart> seen;
        const auto subscription = bench.writer.onPartStored([&](const StoredPart& part) { seen.push_back(part); });
        for (std::uint32_t i = 1; i <= 5; ++i) {
            PartRecord part = test::boringPart(i, i);
            part.order.lot = bench.lot;
            QVERIFY(bench.ring.tryPush(part));
        }
        QTRY_COMPARE(seen.size(), std::size_t{5});
        QCOMPARE(seen[4].record.partSequence, 5U);
        QCOMPARE(seen[4].lot, std::optional(bench.lot));
        QCOMPARE(seen[4].number, 6U);  // one part was there before
        auto reader = db::DatabaseReader::open(bench.scratch.path());
        QCOMPARE((*(*reader)->part(seen[4].id))->schedule->schedule.revision, 5U);
    }
    void subscriptionEndsWithItsHandle() {
        Bench bench;
        int calls = 0;
        auto subscription = bench.writer.onPartStored([&](const StoredPart&) { ++calls; });
        int others = 0;
        const auto other = bench.writer.onPartStored([&](const StoredPart&) {
            ++others;
            subscription.reset();
        });
        QVERIFY(bench.ring.tryPush(test::boringPart(1)));
        QTRY_COMPARE(others, 1);
        QVERIFY(bench.ring.tryPush(test::boringPart(2)));
        QTRY_COMPARE(others, 2);
        QCOMPARE(calls, 1);
    }
    void writerGoesOnWhileTheCallersThreadStandsStill() {
        Bench bench;
        int announced = 0;
        const auto subscription = bench.writer.onPartStored([&](const StoredPart&) { ++announced; });
        constexpr int kParts = 200;
        std::thread engine([&] {
            for (std::uint32_t i = 1; i <= kParts; ++i) {
                while (!bench.ring.tryPush(test::boringPart(i))) {
                    std::this_thread::yield();  // the engine would start no new part
                }
            }
        });
        engine.join();
        bench.blockUntilStored(kParts);  // no event loop has run up to here
        QCOMPARE(announced, 0);
        QCOMPARE(bench.count("parts"), std::int64_t{kParts + 1});
        QTRY_COMPARE(announced, kParts);
    }
    void readersSeeWholeTransactionsWhileTheWriterWrites() {
        Bench bench;
        auto reader = db::DatabaseReader::open(bench.scratch.path());
        QVERIFY(reader);
        constexpr int kEntries = 60;
        int answered = 0;
        for (int i = 0; i < kEntries; ++i) {
            bench.writer.submit(entry(bench.part, 50.0 + 0.001 * i), [&](const Result<Receipt>& done) {
                QVERIFY(done);
                ++answered;
            });
        }
        while (answered < kEntries) {
            const auto history = (*reader)->history(bench.lot);
            QVERIFY(history && *history);
            // Each measurement comes with its state, never one without the other.
            QCOMPARE((*history)->states.size(), (*history)->measurements.size());
            const auto verdict = (*reader)->verifyAudit();
            QVERIFY(verdict);
            QVERIFY2(verdict->finding.empty(), verdict->finding.english().c_str());
            QCoreApplication::processEvents();
        }
    }
    void fullQueueIsRefusedWithASentence() {
        Bench bench(64, {.queueCapacity = 4, .ringPoll_ms = 1, .retry_ms = 2});
        int stored = 0;
        int refused = 0;
        constexpr int kMany = 500;
        for (int i = 0; i < kMany; ++i) {
            bench.writer.submit(ChangeSetting{"k", std::to_string(i), "Lee", ""}, [&](const Result<Receipt>& done) {
                done ? ++stored : ++refused;
                if (!done) {
                    QVERIFY(done.error().english().find("Too many") != std::string::npos);
                }
            });
        }
        QTRY_COMPARE(stored + refused, kMany);
        QVERIFY(refused > 0);
        QVERIFY(stored >= 4);
    }
    void stopStoresWhatIsLeft() {
        Bench bench;
        int answered = 0;
        for (std::uint32_t i = 1; i <= 50; ++i) {
            QVERIFY(bench.ring.tryPush(test::boringPart(i)));
        }
        for (int i = 0; i < 10; ++i) {
            bench.writer.submit(entry(bench.part, 50.0),
                                [&](const Result<Receipt>& done) { answered += done ? 1 : 0; });
        }
        QCOMPARE(bench.writer.stop(), std::size_t{0});
        QCOMPARE(answered, 10);
        QCOMPARE(bench.count("parts"), std::int64_t{51});
        std::optional<bool> late;
        bench.writer.submit(entry(bench.part, 50.0), [&](const Result<Receipt>& done) { late = done.has_value(); });
        QTRY_VERIFY(late);
        QVERIFY(!*late);
    }
    void fullDiskLosesNothingAndRecovers() {
        Bench bench(16);
        QSignalSpy unused(&bench.writer, &QObject::destroyed);
        int problems = 0;
        const auto watching = bench.writer.onProblemChanged([&] { ++problems; });
        bench.writer.limitPages(1);  // SQLite takes the present size instead: not one page more
        // Fill what is left in the last pages, until the store says so.
        std::optional<Sentence> entryRefused;
        int accepted = 0;
        for (int i = 0; i < 2000 && !entryRefused; ++i) {
            bool answered = false;
            bench.writer.submit(entry(bench.part, 50.0), [&](const Result<Receipt>& done) {
                answered = true;
                done ? void(++accepted) : void(entryRefused = done.error());
            });
            QTRY_VERIFY(answered);
        }
        QVERIFY(entryRefused);
        QVERIFY(entryRefused->english().find("disk is full") != std::string::npos);
        QCOMPARE(bench.count("measurements"), std::int64_t{accepted});

        std::uint32_t pushed = 0;
        while (bench.ring.tryPush(test::boringPart(pushed + 1))) {
            ++pushed;
            if (!bench.writer.problem().empty()) {
                continue;  // nothing is taken out any more: fill the ring
            }
            QTest::qWait(0);
        }
        QTRY_VERIFY(!bench.writer.problem().empty());
        QVERIFY(bench.writer.problem().english().find("disk is full") != std::string::npos);
        QVERIFY(bench.ring.refused() > 0);  // this is how the engine notices
        const auto storedBefore = bench.writer.partsStored().load();
        QVERIFY(storedBefore < pushed);

        bench.writer.limitPages(0);  // space is made
        bench.blockUntilStored(pushed);
        QTRY_VERIFY(bench.writer.problem().empty());
        QCOMPARE(problems, 2);
        QCOMPARE(bench.count("parts"), static_cast<std::int64_t>(pushed) + 1);
        QVERIFY(db::checkDatabase(bench.scratch.path()));
        bool again = false;
        bench.writer.submit(entry(bench.part, 50.0), [&](const Result<Receipt>& done) { again = done.has_value(); });
        QTRY_VERIFY(again);
    }
    void anEntryRefusedByAFullDiskStopsNewPartsUntilThereIsRoom() {
        std::atomic<bool> refused{false};
        WriterThread::Options options = kQuick;
        options.partsRefused = &refused;
        Bench bench(16, options);
        bench.writer.limitPages(1);
        bool full = false;
        for (int i = 0; i < 2000 && !full; ++i) {
            bool answered = false;
            bench.writer.submit(entry(bench.part, 50.0), [&](const Result<Receipt>& done) {
                answered = true;
                full = !done;
            });
            QTRY_VERIFY(answered);
        }
        QVERIFY(full);
        QTRY_VERIFY(refused.load() && !bench.writer.problem().empty());
        QTest::qWait(10 * options.retry_ms);  // tried again several times, with nothing else to be stored
        QVERIFY(refused.load() && !bench.writer.problem().empty());
        bench.writer.limitPages(0);
        QTRY_VERIFY(!refused.load() && bench.writer.problem().empty());  // by itself
        QVERIFY(db::checkDatabase(bench.scratch.path()));
    }
    void lockedFileIsReportedAndTriedAgain() {
        Bench bench;
        std::optional<Sentence> refused;
        {
            const db::Connection other(bench.scratch.path(), db::Access::Write);
            const db::Transaction busy(other.database());  // another program holds the write lock
            QVERIFY(bench.ring.tryPush(test::boringPart(1)));
            bench.writer.submit(entry(bench.part, 50.0), [&](const Result<Receipt>& done) {
                QVERIFY(!done);
                refused = done.error();
            });
            QTRY_VERIFY_WITH_TIMEOUT(refused, 20000);
            QVERIFY(refused->english().find("another program") != std::string::npos);
        }
        bench.blockUntilStored(1);
        QCOMPARE(bench.count("measurements"), std::int64_t{0});
    }
    void partsGoToTheLotTheyWereBegunFor() {
        Bench bench;
        LotId other = 0;
        bench.writer.submit(EnsureLot{1, 1, 1, "13", 30, "kalman", "Lee"}, [&](const auto& done) { other = done->id; });
        QTRY_VERIFY(other != 0);
        int mine = 0;
        for (std::uint32_t i = 1; i <= 50; ++i) {  // the active lot changes while parts are on their way
            PartRecord part = test::boringPart(i);
            part.order.lot = i % 3 == 0 ? other : bench.lot;
            mine += i % 3 == 0 ? 1 : 0;
            bench.writer.submit(SetActiveLot{ProcessId::Boring, i % 2 == 0 ? other : bench.lot, "Lee"}, {});
            while (!bench.ring.tryPush(part)) {
                std::this_thread::yield();
            }
        }
        bench.blockUntilStored(50);
        const db::Connection reader(bench.scratch.path(), db::Access::Read);
        db::Statement count(reader.database(), "SELECT count(*) FROM parts WHERE lot_id = ?");
        QVERIFY(count.bind(other).run().next());
        QCOMPARE(count.integer(0), static_cast<std::int64_t>(mine));
        QCOMPARE(bench.count("parts"), std::int64_t{51});
    }
    void partsThatWaitAreFoundAgainAtTheNextStart() {
        Bench bench(64);
        bench.writer.limitPages(1);
        bool full = false;
        for (int i = 0; i < 2000 && !full; ++i) {
            bool answered = false;
            bench.writer.submit(entry(bench.part, 50.0), [&](const Result<Receipt>& done) {
                answered = true;
                full = !done;
            });
            QTRY_VERIFY(answered);
        }
        QVERIFY(full);
        const std::int64_t before = bench.count("parts");
        constexpr std::uint32_t kMade = 40;
        for (std::uint32_t i = 1; i <= kMade; ++i) {
            QVERIFY(bench.ring.tryPush(test::boringPart(i)));
        }
        bench.writer.submit(RaiseAlarm{7, 1, Sentence("Link lost")}, {});
        QTRY_VERIFY(bench.writer.partsWaiting() > 0);
        QCOMPARE(bench.writer.stop(), std::size_t{0});  // nothing of it is lost
        const std::int64_t stored = bench.count("parts") - before;
        QVERIFY(stored < kMade);
        const auto file = db::DataFile::open(bench.scratch.path());
        QVERIFY(file);
        QCOMPARE((*file)->finding().partsFound, static_cast<std::size_t>(kMade - stored));
        QVERIFY((*file)->finding().missing.empty());
        QCOMPARE(bench.count("parts"), before + kMade);
        QCOMPARE(bench.count("alarms"), std::int64_t{1});
        QCOMPARE(bench.count("feed_traces"), before + kMade);
        QVERIFY(db::checkDatabase(bench.scratch.path()));
    }
    void alarmsAreKeptWhileTheStoreIsBusy() {
        Bench bench(64, {.queueCapacity = 4, .ringPoll_ms = 1, .retry_ms = 2});
        for (int i = 0; i < 400; ++i) {
            bench.writer.submit(RaiseAlarm{static_cast<AlarmCode>(100 + i), 2, Sentence("Bore outside")}, {});
        }
        QCOMPARE(bench.writer.stop(), std::size_t{0});
        QCOMPARE(bench.count("alarms"), std::int64_t{400});
    }
    void alarmsOfALockedFileComeWithTheirOwnTime() {
        Bench bench;
        std::int64_t raised_ms = 0;
        {
            const db::Connection other(bench.scratch.path(), db::Access::Write);
            const db::Transaction busy(other.database());
            raised_ms = db::utcNow_ms();
            bench.writer.submit(RaiseAlarm{7, 1, Sentence("Link lost")}, {});
            QTRY_VERIFY_WITH_TIMEOUT(!bench.writer.problem().empty(), 20000);
        }
        QTRY_COMPARE_WITH_TIMEOUT(bench.count("alarms"), std::int64_t{1}, 20000);
        const auto reader = db::DatabaseReader::open(bench.scratch.path());
        QVERIFY((*reader)->alarms(std::nullopt, 1)->front().raisedUtc_ms - raised_ms < 1000);
    }
    void deletedFileIsSaidAtOnceAndTakesNothing() {
        std::atomic<bool> refused{false};
        WriterThread::Options options = kQuick;
        options.partsRefused = &refused;
        Bench bench(64, options);
        const QString path = QString::fromStdString(bench.scratch.path());
        QVERIFY(QFile::rename(path, path + QStringLiteral(".away")));
        QTRY_VERIFY(!bench.writer.problem().empty());
        QVERIFY(bench.writer.problem().english().find("deleted") != std::string::npos);
        QVERIFY(refused.load());
        std::optional<bool> accepted;
        bench.writer.submit(entry(bench.part, 50.0), [&](const Result<Receipt>& done) { accepted = done.has_value(); });
        QVERIFY(bench.ring.tryPush(test::boringPart(1)));
        QTRY_VERIFY(accepted);
        QVERIFY(!*accepted);
        QCOMPARE(bench.writer.partsStored().load(), std::uint64_t{0});
        QVERIFY(QFile::rename(path + QStringLiteral(".away"), path));  // put back
        bench.blockUntilStored(1);
        QTRY_VERIFY(bench.writer.problem().empty());
        QVERIFY(!refused.load());
    }
    void aDeletedLogIsSaidAtOnceAndWhatWasAcceptedGoesIntoTheFile() {
        Bench bench;
        const QString path = QString::fromStdString(bench.scratch.path());
        std::optional<bool> accepted;
        bench.writer.submit(entry(bench.part, 50.0), [&](const Result<Receipt>& done) { accepted = done.has_value(); });
        QTRY_VERIFY(accepted.value_or(false));
        QVERIFY(QFile::remove(path + QStringLiteral("-wal")));
        QTRY_VERIFY(!bench.writer.problem().empty());
        QVERIFY(bench.writer.problem().english().find("(-wal)") != std::string::npos);
        accepted.reset();
        bench.writer.submit(entry(bench.part, 50.1), [&](const Result<Receipt>& done) { accepted = done.has_value(); });
        QTRY_VERIFY(accepted);
        QVERIFY(!*accepted);
        const QString copy = path + QStringLiteral(".copy");  // what is left when Kerf is killed now
        QVERIFY(QFile::copy(path, copy));
        const db::Connection left(copy.toStdString(), db::Access::Read);
        QSqlQuery count(QStringLiteral("SELECT count(*) FROM measurements"), left.database());
        QVERIFY(count.next());
        QCOMPARE(count.value(0).toInt(), 1);
    }
    void secondWriterIsRefused() {
        Bench bench;
        WriterThread second(bench.scratch.path(), nullptr);
        const auto started = second.start();
        QVERIFY(!started);
        QVERIFY(started.error().english().find("Another Kerf") != std::string::npos);
    }
    void missingFolderIsReportedAtStart() {
        WriterThread writer("/no/such/folder/kerf.db", nullptr);
        QVERIFY(!writer.start());
    }
};

QTEST_GUILESS_MAIN(TestWriterThread)
#include "tst_writer_thread.moc"
