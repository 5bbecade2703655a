// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QTest>
#include <nlohmann/json.hpp>

#include "tests/db/db_test_support.h"
#include "tests/support/golden.h"
#include "tests/support/kerf_program.h"

using kerf::test::csvRows;
using kerf::test::KerfRun;
using kerf::test::runKerf;
using nlohmann::json;

namespace {
/// A data folder with the frozen lot: 3 parts, 7 accepted rows, one corrected, one voided.
class DataFolder {
 public:
    DataFolder() {
        const QString frozen = QString::fromStdString(kerf::test::fixture("db/v1.db"));
        QVERIFY(QFile::copy(frozen, file()));
        QFile::setPermissions(file(), QFile::ReadOwner | QFile::WriteOwner);
        QVERIFY(kerf::db::prepareDatabase(file().toStdString()));
    }
    [[nodiscard]] QString path() const { return m_folder.path(); }
    [[nodiscard]] QString file() const { return m_folder.filePath(QStringLiteral("kerf.db")); }
    [[nodiscard]] KerfRun run(QStringList arguments) const {
        return runKerf(QStringList{QStringLiteral("data")} + arguments + QStringList{QStringLiteral("--data"), path()});
    }
    /// Runs SQL past the program.
    void tamper(const char* sql) const {
        const kerf::db::Connection connection(file().toStdString(), kerf::db::Access::Write);
        QVERIFY(kerf::test::tryExecute(connection.database(), sql));
    }

 private:
    QTemporaryDir m_folder;
};
}  // namespace

/// `kerf data …`: what others script against.
class TestDataCommands : public QObject {
    Q_OBJECT
 private slots:
    void exportPartsGivesWhatHolds() {
        const DataFolder data;
        const KerfRun run = data.run({"export", "parts"});
        QCOMPARE(run.exitCode, 0);
        const auto rows = csvRows(run.out);
        QCOMPARE(rows.size(), 6);  // header, 2 + 2 stations, the part whose only measurement was voided
        QCOMPARE(rows[0].join(u','),
                 QStringLiteral("part_id,process,part_type,lot,number,serial,complete,ended_utc,cutting_time_s,station,"
                                "position_mm,diameter_mm,source,author,accepted_utc,corrected,lower_mm,upper_mm,"
                                "verdict,part_verdict,source_name,decision,decision_by,lot_id,recipe_revision"));
        QCOMPARE(rows[1][8].toDouble(), 41.0);
        QCOMPARE(rows[2][9], QStringLiteral("1"));
        QCOMPARE(rows[2][11].toDouble(), 50.0125);
        QCOMPARE(rows[2][15], QStringLiteral("1"));
        QCOMPARE(rows[5][4], QStringLiteral("3"));
        QCOMPARE(rows[5][11], QString());
        for (const auto& row : rows) {
            QCOMPARE(row.size(), 25);
        }
        // 50.0125 lies in 49.985 … 50.015, the recipe's limits
        QCOMPARE(rows[2][16].toDouble(), 49.985);
        QCOMPARE(rows[2][17].toDouble(), 50.015);
        QCOMPARE(rows[2][18], QStringLiteral("good"));
        QCOMPARE(rows[5][19], QStringLiteral("not_judged"));
        QCOMPARE(rows[5][23], QStringLiteral("1"));
        QCOMPARE(rows[5][24], QString());  // made before version 7: nobody guesses
    }
    void exportLotsGivesEveryLotOfEveryProcess() {
        const DataFolder data;
        const auto rows = csvRows(data.run({"export", "lots"}).out);
        QCOMPARE(rows.size(), 2);
        QCOMPARE(rows[0].join(u','),
                 QStringLiteral("lot_id,process,part_type,lot,machine,recipe_revision,size,estimator,tool,gauge,"
                                "opened_utc,opened_by,closed_utc,closed_by"));
        QCOMPARE(rows[1].size(), 14);
        QCOMPARE(rows[1][1], QStringLiteral("boring"));
        QCOMPARE(rows[1][3], QStringLiteral("12"));
        QCOMPARE(rows[1][11], QStringLiteral("Lee"));
        QCOMPARE(rows[1][12], QString());
        QCOMPARE(csvRows(data.run({"export", "lots", "--process", "milling"}).out).size(), 1);
    }
    void exportMeasurementsGivesEveryAcceptedRow() {
        const DataFolder data;
        const auto rows = csvRows(data.run({"export", "measurements"}).out);
        QCOMPARE(rows.size(), 8);
        int voided = 0;
        for (const auto& row : rows) {
            QCOMPARE(row.size(), 16);
            voided += row[5] == QStringLiteral("void") ? 1 : 0;
        }
        QCOMPARE(voided, 1);
    }
    void exportFeedComparesScheduleAndCut() {
        const DataFolder data;
        const auto rows = csvRows(data.run({"export", "feed"}).out);
        QCOMPARE(rows.size(), 1 + 3 * static_cast<int>(kerf::kFeedTracePoints));
        QCOMPARE(rows[1][4].toDouble(), 40.0);
        QVERIFY(rows[1][5].toDouble() > 0.0);
        QCOMPARE(rows[1][6].toDouble(), 0.25);
    }
    void exportsComeAsASpreadsheetWantsThem() {
        const DataFolder data;
        const KerfRun german = data.run({"export", "parts", "--separator", ";", "--decimal", ",", "--local-time"});
        QCOMPARE(german.exitCode, 0);
        const QStringList header = german.out.split(u'\n')[0].split(u';');
        QVERIFY(header.contains(QStringLiteral("ended_local")) && header.contains(QStringLiteral("accepted_local")));
        QVERIFY2(german.out.contains(QStringLiteral(";50,0125;")), qPrintable(german.out));
        QCOMPARE(data.run({"export", "parts", "--decimal", ","}).exitCode, 2);
    }
    void boresCanBeReplayedInAnyDialect() {
        const DataFolder data;
        const KerfRun plain = data.run({"export", "bores"});
        QCOMPARE(plain.exitCode, 0);
        QCOMPARE(csvRows(plain.out)[0].mid(0, 4).join(u','),
                 QStringLiteral("part,overhang_mm,feed_mm_per_rev,diameter_mm"));
        QCOMPARE(csvRows(plain.out).size(), 5);
        const QStringList replay{
            "boring", "replay", "bores.csv", "--target-diameter-mm", "50.2", "--accept-implausible"};
        kerf::test::scratchFile("bores.csv", plain.out);
        const KerfRun first = runKerf(replay);
        QVERIFY2(first.exitCode == 0, qPrintable(first.err));
        kerf::test::scratchFile("bores.csv",
                                data.run({"export", "bores", "--separator", ";", "--decimal", ",", "--excel"}).out);
        QCOMPARE(runKerf(replay).out, first.out);
        // what has no feed says so
        kerf::test::scratchFile("bores.csv", data.run({"export", "parts"}).out);
        QVERIFY(runKerf(replay).err.contains(QStringLiteral("feed_mm_per_rev")));
    }
    void aMediumThatCannotBeWrittenIsRead_data() {
        QTest::addColumn<bool>("log");
        QTest::newRow("alone") << false;
        QTest::newRow("with a write-ahead log beside it") << true;
    }
    void aMediumThatCannotBeWrittenIsRead() {
        QFETCH(bool, log);
        const DataFolder data;
        QTemporaryDir stick;
        QVERIFY(QFile::copy(data.file(), stick.filePath(QStringLiteral("kerf.db"))));
        if (log) {  // a connection that stays open keeps its log
            const kerf::db::Connection writer(stick.filePath(QStringLiteral("kerf.db")).toStdString(),
                                              kerf::db::Access::Write);
            QVERIFY(kerf::test::tryExecute(writer.database(), "UPDATE parts SET serial = serial"));
            QVERIFY(QFile::copy(stick.filePath(QStringLiteral("kerf.db-wal")), stick.filePath(QStringLiteral("kept"))));
        }
        if (log) {
            QVERIFY(
                QFile::rename(stick.filePath(QStringLiteral("kept")), stick.filePath(QStringLiteral("kerf.db-wal"))));
        }
        const QString mounted = QStringLiteral("mount --bind \"$1\" \"$1\" && mount -o remount,ro,bind \"$1\"");
        if (QProcess::execute("unshare", {"-m", "sh", "-c", mounted, "sh", stick.path()}) != 0) {
            QSKIP("no right to mount read-only here");
        }
        for (const char* command : {"check", "verify", "export"}) {
            QProcess shell;
            shell.start("unshare",
                        {"-m", "sh", "-c", mounted + QStringLiteral(" && \"$KERF_BIN/kerf\" data $2 --data \"$1\" $3"),
                         "sh", stick.path(), command, command[0] == 'e' ? "parts" : ""});
            QVERIFY(shell.waitForFinished(60000));
            QVERIFY2(shell.exitCode() == 0, shell.readAllStandardError().constData());
        }
    }
    void exportCanBeNarrowed() {
        const DataFolder data;
        QCOMPARE(csvRows(data.run({"export", "parts", "--process", "milling"}).out).size(), 1);
        QCOMPARE(csvRows(data.run({"export", "parts", "--search", "sleeve"}).out).size(), 6);
        QCOMPARE(csvRows(data.run({"export", "parts", "--search", "zebra"}).out).size(), 1);
    }
    void exportAuditAndVerifyAgree() {
        const DataFolder data;
        const auto rows = csvRows(data.run({"export", "audit"}).out);
        const KerfRun verify = data.run({"verify"});
        QCOMPARE(verify.exitCode, 0);
        const json report = json::parse(verify.out.toStdString());
        QVERIFY(report["intact"].get<bool>());
        QCOMPARE(report["entries"].get<int>(), static_cast<int>(rows.size()) - 1);
        QCOMPARE(report["measurements"].get<int>(), 7);
        QCOMPARE(QString::fromStdString(report["head_hash"].get<std::string>()), rows.back().back());
    }
    void verifyFindsAChangedMeasurement() {
        const DataFolder data;
        data.tamper("DROP TRIGGER measurements_no_update");
        data.tamper("UPDATE measurements SET diameter_mm = 50.002 WHERE id = 3");
        const KerfRun run = data.run({"verify"});
        QCOMPARE(run.exitCode, 3);
        QVERIFY(!json::parse(run.out.toStdString())["intact"].get<bool>());
        QVERIFY(run.err.contains(QStringLiteral("Measurement 3")));
    }
    void checkReportsVersionAndParts() {
        const DataFolder data;
        const KerfRun run = data.run({"check"});
        QCOMPARE(run.exitCode, 0);
        QCOMPARE(json::parse(run.out.toStdString())["parts"].get<int>(), 3);
    }
    void backupCanBeReadAndNeverOverwrites() {
        const DataFolder data;
        QTemporaryDir stick;
        const QString copy = stick.filePath(QStringLiteral("kerf.db"));
        QCOMPARE(data.run({"backup", copy}).exitCode, 0);
        const auto read = runKerf({"data", "export", "parts", "--data", stick.path()});
        QCOMPARE(read.out, data.run({"export", "parts"}).out);
        const KerfRun again = data.run({"backup", copy});
        QCOMPARE(again.exitCode, 3);
        QVERIFY(again.err.contains(QStringLiteral("never overwrites")));
        const KerfRun nowhere = data.run({"backup", QStringLiteral("/no/such/folder/x.db")});
        QCOMPARE(nowhere.exitCode, 3);
        QVERIFY2(nowhere.err.trimmed().count(u'\n') == 0 && nowhere.err.contains("folder"), qPrintable(nowhere.err));
    }
    void aBackupTakesThePlaceOfTheData() {
        const DataFolder data;
        QTemporaryDir stick;
        const QString copy = stick.filePath(QStringLiteral("kerf.db"));
        QCOMPARE(data.run({"backup", copy}).exitCode, 0);
        const QString before = data.run({"export", "parts"}).out;
        QCOMPARE(data.run({"restore", copy, "--author", "Park"}).exitCode, 2);  // no reason
        const KerfRun none = data.run({"restore", "/no/such.db", "--author", "Park", "--reason", "a trial"});
        QCOMPARE(none.exitCode, 3);
        const KerfRun done = data.run({"restore", copy, "--author", "Park", "--reason", "a trial"});
        QCOMPARE(done.exitCode, 0);
        QVERIFY(
            QFile::exists(QString::fromStdString(json::parse(done.out.toStdString())["set_aside"].get<std::string>())));
        QCOMPARE(data.run({"export", "parts"}).out, before);
        QVERIFY(data.run({"export", "audit"}).out.contains(QStringLiteral("backup restored")));
        QCOMPARE(data.run({"verify"}).exitCode, 0);
    }
    void badInputIsOneSentenceAndNothingOnStdout_data() {
        QTest::addColumn<QByteArray>("content");
        QTest::newRow("nothing there") << QByteArray();
        QTest::newRow("no database") << QByteArray("hello, this is a text");
        QTest::newRow("nonsense") << QByteArray("SQLite format 3\0", 16) + QByteArray(4000, 'x');
    }
    void badInputIsOneSentenceAndNothingOnStdout() {
        QFETCH(QByteArray, content);
        QTemporaryDir folder;
        if (!content.isEmpty()) {
            QFile file(folder.filePath(QStringLiteral("kerf.db")));
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(content);
        }
        for (const QStringList& command : {QStringList{"export", "parts"}, QStringList{"verify"}, QStringList{"check"},
                                           QStringList{"backup", "x.db"}}) {
            const KerfRun run = runKerf(QStringList{"data"} + command + QStringList{"--data", folder.path()});
            QCOMPARE(run.exitCode, 3);
            QCOMPARE(run.out, QString());
            QVERIFY(run.err.contains(QStringLiteral("kerf.db")));
        }
        QVERIFY(content.isEmpty() == QDir(folder.path()).isEmpty());  // a reader makes no file
    }
    void wrongUsageIsTwo() {
        QCOMPARE(runKerf({"data"}).exitCode, 2);
        QCOMPARE(runKerf({"data", "export", "spoons"}).exitCode, 2);
        QCOMPARE(runKerf({"data", "--help"}).exitCode, 0);
        QCOMPARE(runKerf({"data", "export", "--help"}).exitCode, 0);
    }
    void readsWhileTheConsoleWrites() {
        const DataFolder data;
        const kerf::db::Connection writer(data.file().toStdString(), kerf::db::Access::Write);
        const kerf::db::Transaction writing(writer.database());
        QVERIFY(kerf::test::tryExecute(writer.database(), "INSERT INTO settings VALUES ('a', 'b', 'c', 1)"));
        QCOMPARE(data.run({"export", "parts"}).exitCode, 0);
        QCOMPARE(data.run({"verify"}).exitCode, 0);
    }
};

QTEST_GUILESS_MAIN(TestDataCommands)
#include "tst_data_commands.moc"
