// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QTest>

#include "db/data_file.h"
#include "db/restore.h"
#include "tests/db/db_test_support.h"

using namespace kerf;

namespace {

std::size_t partsIn(const std::string& path) {
    const auto reader = db::DatabaseReader::open(path);
    return reader ? (*reader)->parts({}).value_or(std::vector<PartRow>{}).size() : 0;
}

/// A data file with one part, its backup, and one more part since.
struct Story {
    Story() {
        {
            test::Shop shop(scratch.path());
            (void)shop.addPart(1);
            backup = scratch.path() + "-backup.db";
            if (!db::backupDatabase(scratch.path(), backup)) qFatal("no backup");
            (void)shop.addPart(2);
        }
        request = {backup, "Park", "the wrong lot was closed"};
    }
    test::ScratchDatabase scratch;
    std::string backup;
    db::RestoreRequest request;
};

}  // namespace

/// A backup in the place of the data: whole or not at all, nothing deleted, and it is written down.
class TestRestore : public QObject {
    Q_OBJECT
 private slots:
    void theBackupTakesThePlaceAtTheNextStart() {
        Story story;
        QVERIFY(db::layReady(story.scratch.path(), story.request).has_value());
        QCOMPARE(partsIn(story.scratch.path()), std::size_t{2});  // not before
        std::string aside;
        {
            const auto file = db::DataFile::open(story.scratch.path());
            QVERIFY(file.has_value());
            aside = (*file)->finding().setAside;
            QVERIFY((*file)->finding().missing.empty());  // it is no loss: somebody wanted it
        }
        QCOMPARE(partsIn(story.scratch.path()), std::size_t{1});
        QCOMPARE(partsIn(aside), std::size_t{2});
        const auto reader = db::DatabaseReader::open(story.scratch.path());
        const auto newest = (*reader)->audit({}, 1);
        QCOMPARE(newest->front().action, std::string("backup restored"));
        QCOMPARE(newest->front().author, std::string("Park"));
        QCOMPARE(newest->front().reason, story.request.reason);
        QCOMPARE(newest->front().oldValue, aside);
        QVERIFY((*reader)->verifyAudit()->finding.empty());
        const auto again = db::DataFile::open(story.scratch.path());
        QVERIFY(again.has_value() && (*again)->finding().setAside.empty());  // once
    }
    void whatIsCutShortGoesOn() {
        Story story;
        QVERIFY(db::layReady(story.scratch.path(), story.request).has_value());
        const QString data = QString::fromStdString(story.scratch.path());
        QFile words(data + QStringLiteral(".restore.json"));
        QVERIFY(words.open(QIODevice::ReadOnly));
        const QString text = QString::fromUtf8(words.readAll());
        const QString aside = text.section(QStringLiteral("\"set_aside\":\""), 1).section(u'"', 0, 0);
        QVERIFY(QFile::rename(data, aside));  // the computer stopped after this one
        const auto file = db::DataFile::open(story.scratch.path());
        QVERIFY(file.has_value());
        QCOMPARE(partsIn(story.scratch.path()), std::size_t{1});
        QCOMPARE(partsIn((*file)->finding().setAside), std::size_t{2});
    }
    void whatIsNoBackupIsRefusedAndNothingLiesReady_data() {
        QTest::addColumn<QString>("how");
        for (const char* how : {"missing", "a text", "damaged", "another log"})
            QTest::newRow(how) << how;
    }
    void whatIsNoBackupIsRefusedAndNothingLiesReady() {
        QFETCH(QString, how);
        Story story;
        const QString name = QString::fromStdString(story.backup);
        if (how == QLatin1String("missing")) {
            QVERIFY(QFile::remove(name));
        } else if (how == QLatin1String("a text")) {
            QFile file(name);
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write("part,diameter\n1,50.001\n");
        } else if (how == QLatin1String("damaged")) {
            QFile file(name);
            QVERIFY(file.open(QIODevice::ReadWrite));
            for (qint64 page = 2; page * 4096 < file.size(); ++page) {
                file.seek(page * 4096);
                file.write(QByteArray(64, '\x7f'));
            }
        } else {
            const db::Connection connection(story.backup, db::Access::Write);
            db::execute(connection.database(), QStringLiteral("DROP TRIGGER audit_no_update"));
            db::execute(connection.database(), QStringLiteral("UPDATE audit SET author = 'Kim' WHERE id = 1"));
        }
        const auto refused = db::layReady(story.scratch.path(), story.request);
        QVERIFY(!refused.has_value());
        QVERIFY(!refused.error().empty());
        QVERIFY(!QFile::exists(QString::fromStdString(story.scratch.path()) + QStringLiteral(".restore")));
        const auto file = db::DataFile::open(story.scratch.path());
        QVERIFY(file.has_value() && (*file)->finding().setAside.empty());
        QCOMPARE(partsIn(story.scratch.path()), std::size_t{2});
    }
};
QTEST_GUILESS_MAIN(TestRestore)
#include "tst_restore.moc"
