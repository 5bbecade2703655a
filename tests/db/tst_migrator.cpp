// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QFile>
#include <QTest>
#include <map>

#include "db_test_support.h"
#include "tests/support/golden.h"

using namespace kerf;
using kerf::test::number;

namespace {
QByteArray bytesOf(const std::string& path) {
    QFile file(QString::fromStdString(path));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}
void write(const std::string& path, const QByteArray& bytes) {
    QFile file(QString::fromStdString(path));
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(bytes), bytes.size());
}
/// A step after the newest one, for tests only.
db::Migration nextStep(const std::string& text) {
    const int version = static_cast<int>(db::builtInMigrations().size()) + 1;
    return db::parseMigration(version, "test step", text);
}
std::vector<db::Migration> withStep(const std::string& text) {
    std::vector<db::Migration> steps = db::builtInMigrations();
    steps.push_back(nextStep(text));
    return steps;
}
/// The words of everything in it, by name.
QStringList schemaOf(const std::string& path) {
    const db::Connection connection(path, db::Access::Read);
    db::Statement all(connection.database(), "SELECT type, name, sql FROM sqlite_master ORDER BY type, name");
    all.run();
    QStringList words;
    while (all.next()) {
        words << QString::fromStdString(all.text(0) + ' ' + all.text(1) + ": " + all.text(2));
    }
    return words;
}
QStringList backupsBeside(const std::string& path) {
    return QDir(QFileInfo(QString::fromStdString(path)).absoluteDir().filePath("backups"))
        .entryList({"*.db"}, QDir::Files);
}
}  // namespace

/// Opening a data file: what is brought up to date, what is refused, and that nothing is lost on the way.
class TestMigrator : public QObject {
    Q_OBJECT
 private slots:
    void migrationsAreNumberedWithoutGap() {
        const auto steps = db::builtInMigrations();
        QVERIFY(!steps.empty());
        for (std::size_t i = 0; i < steps.size(); ++i) {
            QCOMPARE(steps[i].version, static_cast<int>(i) + 1);
            QVERIFY(!steps[i].statements.empty());
        }
    }
    void statementsAreNotSplitAtSemicolons() {
        const auto step =
            db::parseMigration(1, "x",
                               "-- head\n-- statement: one; really\nINSERT INTO t VALUES ('a;b'); -- c;\n\n"
                               "-- statement: two\nCREATE TRIGGER g BEGIN\n SELECT 1;\nEND;\n");
        QCOMPARE(step.statements.size(), std::size_t{2});
        QCOMPARE(step.statements[0].purpose, std::string("one; really"));
        QVERIFY(step.statements[0].sql.find("'a;b'") != std::string::npos);
        QVERIFY(step.statements[1].sql.ends_with("END;"));
    }
    void twoStatementsInOneBlockAreRefused() {
        test::ScratchDatabase scratch;
        const auto report =
            db::migrateFile(scratch.path(), withStep("-- statement: two at once\nCREATE TABLE a (x);\nCREATE "
                                                     "TABLE b (x);\n"));
        QVERIFY(!report);
    }
    void freshFileGetsNewestVersion() {
        QTemporaryDir folder;
        const std::string path = folder.filePath("new/folder/kerf.db").toStdString();
        const auto report = db::prepareDatabase(path);
        QVERIFY(report);
        QCOMPARE(report->fromVersion, 0);
        QCOMPARE(report->toVersion, static_cast<int>(db::builtInMigrations().size()));
        QVERIFY(report->backupPath.empty());
        QVERIFY(db::checkDatabase(path));
        const db::Connection connection(path, db::Access::Write);
        QCOMPARE(number(connection.database(), "PRAGMA application_id"), std::int64_t{db::kApplicationId});
        QCOMPARE(number(connection.database(), "PRAGMA synchronous"), std::int64_t{2});
        QCOMPARE(number(connection.database(), "PRAGMA foreign_keys"), std::int64_t{1});
        db::Statement journal(connection.database(), "PRAGMA journal_mode");
        QVERIFY(journal.run().next());
        QCOMPARE(journal.text(0), std::string("wal"));
    }
    void secondOpeningChangesNothing() {
        test::ScratchDatabase scratch;
        const auto report = db::prepareDatabase(scratch.path());
        QVERIFY(report);
        QCOMPARE(report->fromVersion, report->toVersion);
        QVERIFY(backupsBeside(scratch.path()).isEmpty());
    }
    void everyFrozenFileComesUpToDate_data() {
        QTest::addColumn<QString>("file");
        const QDir folder(QString::fromStdString(test::fixture("db")));
        const QStringList files = folder.entryList({"v*.db"}, QDir::Files, QDir::Name);
        // One frozen file per released version, the newest one included.
        QCOMPARE(files.size(), static_cast<qsizetype>(db::builtInMigrations().size()));
        for (const QString& file : files) {
            QTest::newRow(qPrintable(file)) << folder.filePath(file);
        }
    }
    void everyFrozenFileComesUpToDate() {
        QFETCH(QString, file);
        QTemporaryDir folder;
        const QString copy = folder.filePath("kerf.db");
        QVERIFY(QFile::copy(file, copy));
        QFile::setPermissions(copy, QFile::ReadOwner | QFile::WriteOwner);
        const auto report = db::prepareDatabase(copy.toStdString());
        QVERIFY2(report, report ? "" : report.error().english().c_str());
        QCOMPARE(report->toVersion, static_cast<int>(db::builtInMigrations().size()));
        QVERIFY(db::checkDatabase(copy.toStdString()));
        // The lot that every frozen file holds: 3 parts, one corrected and one voided measurement, an intact audit log.
        auto reader = db::DatabaseReader::open(copy.toStdString());
        QVERIFY(reader);
        const auto lots = (*reader)->lots(std::nullopt, 10, ProcessId::Boring);
        QVERIFY(lots);
        QCOMPARE(lots->size(), std::size_t{1});
        QCOMPARE(lots->front().openedBy, std::string("Lee"));  // before version 7 in the log alone
        QVERIFY(lots->front().closedBy.empty() && lots->front().tool.empty());
        const auto history = (*reader)->history(lots->front().id);
        QVERIFY(history && *history);
        const LotHistory& lot = **history;
        QCOMPARE(lot.parts.size(), std::size_t{3});
        QCOMPARE(lot.measurements.size(), std::size_t{7});
        for (const PartDetail& part : lot.parts) {
            QVERIFY(!part.part.recipe);  // which revision they were cut with was not kept, and is not guessed
        }
        const auto milled = (*reader)->lots(std::nullopt, 10, ProcessId::Milling);
        if (file.endsWith("v7.db") || file.endsWith("v8.db")) {
            QCOMPARE(milled->size(), std::size_t{1});
            PartQuery query;
            query.process = ProcessId::Milling;
            const auto parts = *(*reader)->parts(query);
            QCOMPARE(parts.size(), std::size_t{2});
            QCOMPARE(parts[1].lot, std::optional(milled->front().id));
            QVERIFY(!parts[0].lot);
            QCOMPARE(parts[0].partTypeName, std::string("Rail"));
        } else {
            QVERIFY(milled->empty());
        }
        const auto effective = effectiveMeasurements(lot.measurements);
        QCOMPARE(effective.size(), std::size_t{4});
        QCOMPARE(*effective[1].diameter_mm, 50.0125);
        QVERIFY(lot.lastState);
        QCOMPARE(lot.lastState->cause, lot.measurements.back().id);
        QVERIFY(lot.parts[0].schedule);
        QCOMPARE(lot.parts[0].feed.count, std::uint16_t{kFeedTracePoints});
        const auto verdict = (*reader)->verifyAudit();
        QVERIFY(verdict);
        QVERIFY2(verdict->finding.empty(), verdict->finding.english().c_str());
        // From wherever it came: the same tables, indexes and triggers, to the letter, as in a new file.
        const test::ScratchDatabase fresh;
        QCOMPARE(schemaOf(copy.toStdString()), schemaOf(fresh.path()));
        // And the next row has the next number.
        const db::Connection connection(copy.toStdString(), db::Access::Write);
        for (const auto& [table, key] : std::map<QByteArray, QByteArray>{{"measurements", "id"}, {"outbox", "seq"}}) {
            const auto highest = [&, number = "SELECT max(" + key + ") FROM " + table] {
                return kerf::test::number(connection.database(), number.constData());
            };
            const std::int64_t before = highest();
            QVERIFY(before >= 7);
            QVERIFY(test::tryExecute(
                connection.database(),
                table == "outbox" ? "INSERT INTO outbox (table_name, row_key) VALUES ('lots', 1)"
                                  : "INSERT INTO measurements (part_id, kind, station, position_mm, diameter_mm, "
                                    "source, confirmed, author, reason, accepted_utc_ms) VALUES (1, 'entry', 9, 1, 50, "
                                    "'keypad', 0, 'Kim', '', 1)"));
            QCOMPARE(highest(), before + 1);
        }
    }
    void stepKeepsDataAndLeavesABackup() {
        test::ScratchDatabase scratch;
        PartId part = 0;
        {
            test::Shop shop(scratch.path());
            part = shop.addPart(1);
        }
        const auto report = db::migrateFile(
            scratch.path(), withStep("-- statement: one more column\nALTER TABLE parts ADD COLUMN note TEXT"));
        QVERIFY(report);
        QCOMPARE(report->toVersion, report->fromVersion + 1);
        QVERIFY(QFile::exists(QString::fromStdString(report->backupPath)));
        QVERIFY(db::checkDatabase(report->backupPath));
        const db::Connection backup(report->backupPath, db::Access::Read);
        QCOMPARE(number(backup.database(), "PRAGMA user_version"), std::int64_t{report->fromVersion});
        QCOMPARE(number(backup.database(), "SELECT id FROM parts"), part);
        const db::Connection now(scratch.path(), db::Access::Read);
        QCOMPARE(number(now.database(), "SELECT count(*) FROM parts WHERE note IS NULL"), std::int64_t{1});
        QCOMPARE(number(now.database(), "SELECT max(version) FROM schema_steps"), std::int64_t{report->toVersion});
    }
    void failedStepRollsBackWholeAndKeepsBackup() {
        test::ScratchDatabase scratch;
        {
            test::Shop shop(scratch.path());
            QVERIFY(shop.addPart(1) > 0);
        }
        const int before = *db::fileVersion(scratch.path(), 99);
        const auto report =
            db::migrateFile(scratch.path(), withStep("-- statement: works\nCREATE TABLE half_done (x INTEGER)\n"
                                                     "-- statement: does not\nINSERT INTO no_such_table "
                                                     "VALUES (1)"));
        QVERIFY(!report);
        QVERIFY(report.error().english().find("step " + std::to_string(before)) != std::string::npos);
        QCOMPARE(*db::fileVersion(scratch.path(), 99), before);
        const db::Connection now(scratch.path(), db::Access::Read);
        QCOMPARE(number(now.database(), "SELECT count(*) FROM sqlite_master WHERE name = 'half_done'"),
                 std::int64_t{0});
        QCOMPARE(number(now.database(), "SELECT count(*) FROM parts"), std::int64_t{1});
        QCOMPARE(backupsBeside(scratch.path()).size(), qsizetype{1});
    }
    void stepThatBreaksAReferenceRollsBack() {
        test::ScratchDatabase scratch;
        {
            test::Shop shop(scratch.path());
            QVERIFY(shop.addPart(1) > 0);
        }
        QVERIFY(!db::migrateFile(scratch.path(), withStep("-- statement: orphans the lots\nDELETE FROM machines")));
        const db::Connection now(scratch.path(), db::Access::Read);
        QCOMPARE(number(now.database(), "SELECT count(*) FROM machines"), std::int64_t{1});
    }
    void earlierStepsStayWhenALaterOneFails() {
        test::ScratchDatabase scratch;
        auto steps = withStep("-- statement: fine\nCREATE TABLE extra (x INTEGER)");
        steps.push_back(db::parseMigration(steps.back().version + 1, "bad", "-- statement: bad\nNO SUCH SQL"));
        QVERIFY(!db::migrateFile(scratch.path(), steps));
        QCOMPARE(*db::fileVersion(scratch.path(), 99), steps.back().version - 1);
    }
    void newerFileIsRefusedAndUntouched() {
        test::ScratchDatabase scratch;
        QVERIFY(db::migrateFile(scratch.path(), withStep("-- statement: future\nCREATE TABLE future (x INTEGER)")));
        const QByteArray before = bytesOf(scratch.path());
        const auto report = db::prepareDatabase(scratch.path());
        QVERIFY(!report);
        QVERIFY(report.error().english().find("newer Kerf") != std::string::npos);
        QCOMPARE(bytesOf(scratch.path()), before);
    }
    void whatIsNoDatabaseIsRefusedAndUntouched_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("text") << QByteArray("part,overhang_mm\n1,40\n");
        QTest::newRow("long text") << QByteArray(5000, 'x');
        QTest::newRow("header only") << QByteArray("SQLite format 3\0", 16);
        QTest::newRow("header and nonsense") << QByteArray("SQLite format 3\0", 16) + QByteArray(5000, '\x7f');
    }
    void whatIsNoDatabaseIsRefusedAndUntouched() {
        QFETCH(QByteArray, bytes);
        QTemporaryDir folder;
        const std::string path = folder.filePath("kerf.db").toStdString();
        write(path, bytes);
        const auto report = db::prepareDatabase(path);
        QVERIFY(!report);
        QVERIFY(!report.error().english().empty());
        QCOMPARE(bytesOf(path), bytes);
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 1);
    }
    void databaseOfAnotherProgramIsRefused() {
        QTemporaryDir folder;
        const std::string path = folder.filePath("other.db").toStdString();
        {
            const db::Connection connection(path, db::Access::Write);
            db::execute(connection.database(), "CREATE TABLE music (title TEXT)");
        }
        const QByteArray before = bytesOf(path);
        const auto report = db::prepareDatabase(path);
        QVERIFY(!report);
        QVERIFY(report.error().english().find("another program") != std::string::npos);
        QCOMPARE(bytesOf(path), before);
    }
    void truncatedFileIsRefusedAndUntouched() {
        test::ScratchDatabase scratch;
        const QByteArray whole = bytesOf(scratch.path());
        write(scratch.path(), whole.left(whole.size() / 2));
        const auto report = db::prepareDatabase(scratch.path());
        QVERIFY(!report || !db::checkDatabase(scratch.path()));
        QCOMPARE(bytesOf(scratch.path()).size(), whole.size() / 2);
    }
    void backupIsCompleteAndNeverOverwrites() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());  // in use while it is copied
        const PartId part = shop.addPart(1);
        const std::string copy = scratch.file("copy.db");
        QVERIFY(db::backupDatabase(scratch.path(), copy));
        QVERIFY(db::checkDatabase(copy));
        const db::Connection made(copy, db::Access::Read);
        QCOMPARE(number(made.database(), "SELECT max(id) FROM parts"), part);
        QVERIFY(!db::backupDatabase(scratch.path(), copy));
        QVERIFY(!db::backupDatabase(scratch.file("missing.db"), scratch.file("copy2.db")));
        QVERIFY(!QFile::exists(QString::fromStdString(scratch.file("copy2.db"))));
    }
};

QTEST_GUILESS_MAIN(TestMigrator)
#include "tst_migrator.moc"
