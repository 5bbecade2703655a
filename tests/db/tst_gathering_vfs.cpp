// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <sqlite3.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QFile>
#include <QTest>
#include <cerrno>
#include <set>
#include <vector>

#include "db_test_support.h"

using namespace kerf;
using kerf::test::number;

namespace {

/// SQLite's own way to the disk, through which each write of this program goes: counted, and where asked cut short,
/// after which nothing is written any more, as when the program was killed there.
struct Disk {
    std::vector<std::size_t> writes{};  ///< bytes of each
    int dieAt{-1};                      ///< this write is the last one
    double part{0.0};                   ///< of which so much is written
    bool dead{false};
    bool full{false};
};
Disk disk;

ssize_t writeAt(int file, const void* bytes, std::size_t count, off_t at) {
    if (disk.full) {
        errno = ENOSPC;
        return -1;
    }
    if (!disk.dead && static_cast<int>(disk.writes.size()) == disk.dieAt) {
        disk.dead = true;
        (void)!::pwrite(file, bytes, static_cast<std::size_t>(disk.part * static_cast<double>(count)), at);
    }
    if (disk.dead) {
        errno = EIO;
        return -1;
    }
    disk.writes.push_back(count);
    return ::pwrite(file, bytes, count, at);
}

int cutTo(int file, off_t size) {
    errno = EIO;
    return disk.dead ? -1 : ::ftruncate(file, size);
}

template <class Function>
void take(const char* name, Function function) {
    sqlite3_vfs* vfs = sqlite3_vfs_find(nullptr);
    if (vfs->xGetSystemCall(vfs, name) != nullptr) {
        vfs->xSetSystemCall(vfs, name, reinterpret_cast<sqlite3_syscall_ptr>(function));
    }
}

constexpr int kBody_bytes = 3000;

/// Rows of about a page each: number `from` to `from` + `count` - 1. With ten pages of memory, some go into the log
/// before the transaction ends.
void addRows(const QSqlDatabase& database, std::int64_t from, std::int64_t count) {
    for (std::int64_t id = from; id < from + count; ++id) {
        db::Statement(database, "INSERT INTO t VALUES (?, ?)").bind(id).bind(std::string(kBody_bytes, 'x')).run();
    }
    db::Statement(database, "UPDATE t SET body = substr(body, 2) || 'y' WHERE id % 7 = ?").bind(from % 7).run();
}

void prepareTable(const QSqlDatabase& database, const char* synchronous) {
    db::execute(database, QStringLiteral("PRAGMA cache_size = 10"));
    db::execute(database, QStringLiteral("PRAGMA wal_autocheckpoint = 100"));
    db::execute(database, QStringLiteral("PRAGMA synchronous = ") + QLatin1String(synchronous));
    db::execute(database, QStringLiteral("CREATE TABLE IF NOT EXISTS t (id INTEGER PRIMARY KEY, body TEXT)"));
}

/// Commits of one to 40 rows, some rolled back, one within a savepoint; the numbers of committed transactions go to
/// `done`.
void story(const QSqlDatabase& database, std::vector<std::int64_t>& done) {
    for (std::int64_t turn = 1; turn <= 12; ++turn) {
        db::Transaction transaction(database);
        addRows(database, turn * 1000, turn % 4 == 0 ? 40 : turn);
        db::execute(database, QStringLiteral("SAVEPOINT s"));
        addRows(database, turn * 1000 + 500, 15);
        if (turn % 3 == 0) {
            db::execute(database, QStringLiteral("ROLLBACK TO s"));
        }
        db::execute(database, QStringLiteral("RELEASE s"));
        if (turn % 5 != 0) {
            transaction.commit();
            done.push_back(turn);
        }
    }
}

std::set<std::int64_t> turnsIn(const QSqlDatabase& database) {
    std::set<std::int64_t> turns;
    db::Statement find(database, "SELECT id / 1000, count(*) FROM t GROUP BY 1");
    find.run();
    while (find.next()) {
        const std::int64_t turn = find.integer(0);
        const std::int64_t rows = (turn % 4 == 0 ? 40 : turn) + (turn % 3 == 0 ? 0 : 15);
        turns.insert(find.integer(1) == rows ? turn : -turn);  // half a transaction
    }
    return turns;
}

}  // namespace

/// The log's frames go there in one write, and a program that dies leaves what it could have left without that.
class TestGatheringVfs : public QObject {
    Q_OBJECT
 private slots:
    void initTestCase() {
        take("pwrite", &writeAt);
        take("pwrite64", &writeAt);
        take("ftruncate", &cutTo);
    }
    void init() { disk = {}; }
    void cleanup() { disk = {}; }

    void anAcceptanceIsOneWrite() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        const PartId part = shop.addPart(1);
        const AcceptMeasurement command{test::measured(part, 0, 50.0), {test::stateOf(0.5)}, std::nullopt};
        (void)shop.must(command);
        disk.writes.clear();
        (void)shop.must(command);
        QCOMPARE(disk.writes.size(), std::size_t{1});
        QCOMPARE(disk.writes[0] % (24 + 4096), std::size_t{0});
        QVERIFY(disk.writes[0] > 5 * (24 + 4096));
    }
    void whatIsCommittedIsSeenByOthers_data() {
        QTest::addColumn<QString>("synchronous");
        QTest::newRow("FULL") << "FULL";
        QTest::newRow("NORMAL") << "NORMAL";
        QTest::newRow("OFF") << "OFF";
    }
    void whatIsCommittedIsSeenByOthers() {
        QFETCH(QString, synchronous);
        test::ScratchDatabase scratch;
        const db::Connection one(scratch.path(), db::Access::Write);
        const db::Connection two(scratch.path(), db::Access::Write);
        const db::Connection reader(scratch.path(), db::Access::Read);
        for (const db::Connection* each : {&one, &two}) {
            prepareTable(each->database(), synchronous.toUtf8().constData());
        }
        std::int64_t rows = 0;
        for (int turn = 0; turn < 30; ++turn) {
            const db::Connection& writer = turn % 2 == 0 ? one : two;
            const db::Connection& other = turn % 2 == 0 ? two : one;
            {  // its frames are in the log, where the other one then writes
                db::Transaction taken(other.database());
                addRows(other.database(), 1'000'000, 20);
                QCOMPARE(number(other.database(), "SELECT count(*) FROM t"), rows + 20);
            }
            db::Transaction transaction(writer.database());
            addRows(writer.database(), 1000 * turn, 1 + turn);
            transaction.commit();
            rows += 1 + turn;
            QCOMPARE(number(reader.database(), "SELECT count(*) FROM t"), rows);
            QCOMPARE(number(other.database(), "SELECT count(body) FROM t"), rows);
        }
        db::Statement check(reader.database(), "PRAGMA integrity_check");
        QVERIFY(check.run().next());
        QCOMPARE(check.text(0), std::string("ok"));
    }
    void whatWasRolledBackIsNotWrittenOverAnothersCommit() {
        test::ScratchDatabase scratch;
        const db::Connection one(scratch.path(), db::Access::Write);
        const db::Connection two(scratch.path(), db::Access::Write);
        prepareTable(one.database(), "FULL");
        addRows(one.database(), 1, 60);
        db::execute(one.database(), QStringLiteral("PRAGMA wal_checkpoint(TRUNCATE)"));
        {  // reads the data file alone, so that nothing but the end of it takes its frames into the log
            const db::Transaction taken(one.database());
            db::execute(one.database(), QStringLiteral("UPDATE t SET body = upper(body)"));
        }
        {
            db::Transaction transaction(two.database());
            addRows(two.database(), 100, 80);  // as far into the log as the other one was
            transaction.commit();
        }
        addRows(one.database(), 200, 3);
        const db::Connection reader(scratch.path(), db::Access::Read);
        QCOMPARE(number(reader.database(), "SELECT count(*) FROM t"), std::int64_t{143});
        QCOMPARE(number(reader.database(), "SELECT count(*) FROM t WHERE body GLOB '*X*'"), std::int64_t{0});
        db::Statement check(reader.database(), "PRAGMA integrity_check");
        QVERIFY(check.run().next());
        QCOMPARE(check.text(0), std::string("ok"));
    }
    void deathAtAnyWriteLeavesWholeTransactions_data() { whatIsCommittedIsSeenByOthers_data(); }
    void deathAtAnyWriteLeavesWholeTransactions() {
        QFETCH(QString, synchronous);
        int deaths = 0;
        for (int dieAt = 0;; dieAt += 1 + dieAt / 8) {
            test::ScratchDatabase scratch;
            std::vector<std::int64_t> done;
            const QString copy = QString::fromStdString(scratch.file("copy.db"));
            {
                const db::Connection connection(scratch.path(), db::Access::Write);
                prepareTable(connection.database(), synchronous.toUtf8().constData());
                disk = {};
                disk.dieAt = dieAt;
                disk.part = 0.25 * (dieAt % 4);
                try {
                    story(connection.database(), done);
                } catch (const db::SqlFailure&) {
                    QVERIFY(disk.dead);
                }
                // What is in the files now is what a killed program leaves.
                QVERIFY(QFile::copy(QString::fromStdString(scratch.path()), copy));
                QVERIFY(QFile::copy(QString::fromStdString(scratch.path() + "-wal"), copy + "-wal"));
                disk.dead = false;
                disk.dieAt = -1;
            }
            if (done.size() == 10) {
                break;  // it died no more
            }
            ++deaths;
            const db::Connection left(copy.toStdString(), db::Access::Write);
            db::Statement check(left.database(), "PRAGMA integrity_check");
            QVERIFY(check.run().next());
            QCOMPARE(check.text(0), std::string("ok"));
            std::set<std::int64_t> found = turnsIn(left.database());
            for (const std::int64_t turn : done) {
                QVERIFY2(found.erase(turn) == 1, qPrintable(QString::number(dieAt)));
            }
            QVERIFY(found.size() <= 1);  // committed, and not yet acknowledged
            QVERIFY(found.empty() || *found.begin() > (done.empty() ? 0 : done.back()));
        }
        QVERIFY(deaths > 10);
    }
    void aFullDiskRefusesTheCommit_data() { whatIsCommittedIsSeenByOthers_data(); }
    void aFullDiskRefusesTheCommit() {
        QFETCH(QString, synchronous);
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        db::execute(shop.database(), QStringLiteral("PRAGMA synchronous = ") + synchronous);
        const PartId part = shop.addPart(1);
        const AcceptMeasurement command{test::measured(part, 0, 50.0), {test::stateOf(0.5)}, std::nullopt};
        (void)shop.must(command);
        disk.full = true;
        const auto refused = shop.tried(command);
        QVERIFY(!refused);
        QCOMPARE(refused.error().english(), db::sentenceForCode(SQLITE_FULL).english());
        disk.full = false;
        QCOMPARE(number(shop.database(), "SELECT count(*) FROM measurements"), std::int64_t{1});
        QCOMPARE(shop.must(command).id, MeasurementId{2});
        QVERIFY(db::checkDatabase(scratch.path()));
    }
    void aNameWithEveryCharacterIsOpened() {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("a ?b=c&d#e%20f 한글//k.db"));
        QVERIFY(QDir().mkpath(QFileInfo(path).absolutePath()));
        const db::Connection connection(path.toStdString(), db::Access::Write);
        db::execute(connection.database(), QStringLiteral("CREATE TABLE t (x)"));
        QVERIFY(QFile::exists(path));
        QVERIFY(QFile::exists(path + QStringLiteral("-wal")));
    }
};

QTEST_GUILESS_MAIN(TestGatheringVfs)
#include "tst_gathering_vfs.moc"
