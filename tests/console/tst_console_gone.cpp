// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <QElapsedTimer>
#include <QFile>
#include <QSqlQuery>
#include <set>

#include "db/connection.h"
#include "db/migrator.h"
#include "engine/cycle/machine_alarms.h"
#include "tests/support/console_bench.h"

using namespace kerf;

/// Data file or log file taken away under the real console, while an automatic operator enters diameters as fast as it
/// can.
class TestConsoleGone : public QObject {
    Q_OBJECT
    enum Act { Renamed, Deleted, Replaced, LogDeleted };

    std::set<qint64> m_accepted{};

    [[nodiscard]] static console::Options options() {
        console::Options options;
        options.preparedParts = 0;
        options.simulationSpeed = 0.0;
        options.autoOperator = true;
        return options;
    }
    void start(test::ConsoleBench& bench) {
        bench.start(options());
        connect(&bench.console(), &console::ConsoleApplication::accepted, this,
                [this](const QString& line) { m_accepted.insert(line.section(QLatin1Char(' '), 1, 1).toLongLong()); });
    }
    /// What is in the file as it lies there: nothing of a log beside it, as after kill -9 and with the log gone.
    [[nodiscard]] static std::set<qint64> storedIn(const QString& file) {
        const QTemporaryDir folder;
        const QString copy = folder.filePath(QStringLiteral("kerf.db"));
        if (!QFile::copy(file, copy) || !db::checkDatabase(copy.toStdString())) {
            return {};
        }
        return idsIn(copy);
    }
    /// … with its log.
    [[nodiscard]] static std::set<qint64> idsIn(const QString& file) {
        std::set<qint64> ids;
        const db::Connection connection(file.toStdString(), db::Access::Read);
        QSqlQuery rows(QStringLiteral("SELECT id FROM measurements"), connection.database());
        while (rows.next()) {
            ids.insert(rows.value(0).toLongLong());
        }
        return ids;
    }
    [[nodiscard]] bool allAcceptedIn(const QString& file) const {
        const std::set<qint64> stored = storedIn(file);
        return std::ranges::includes(stored, m_accepted);
    }

 private slots:
    void nothingIsAcceptedIntoAFileThatIsGone_data() {
        QTest::addColumn<int>("act");
        QTest::newRow("renamed") << int(Renamed);
        QTest::newRow("deleted") << int(Deleted);
        QTest::newRow("replaced by a copy") << int(Replaced);
        QTest::newRow("log file deleted") << int(LogDeleted);
    }
    void nothingIsAcceptedIntoAFileThatIsGone() {
        QFETCH(int, act);
        m_accepted.clear();
        test::ConsoleBench bench;
        start(bench);
        QTRY_VERIFY2_WITH_TIMEOUT(bench.up(), qPrintable(bench.failure()), 30'000);
        QTRY_VERIFY_WITH_TIMEOUT(m_accepted.size() >= 5, 60'000);
        const QString file = QString::fromStdString(bench.console().databasePath());
        const QString log = file + QStringLiteral("-wal");
        const QString same = file + QStringLiteral(".same");  // another name of the same file, to look at it afterwards
        QCOMPARE(::link(qPrintable(file), qPrintable(same)), 0);
        switch (act) {
            case Renamed:
                QVERIFY(QFile::rename(file, file + QStringLiteral(".away")));
                break;
            case Deleted:
                QVERIFY(QFile::remove(file));
                break;
            case Replaced:
                QVERIFY(QFile::copy(file, file + QStringLiteral(".copy")) && QFile::remove(file) &&
                        QFile::rename(file + QStringLiteral(".copy"), file));
                break;
            default:
                QVERIFY(QFile::remove(log));
        }
        QElapsedTimer since;
        since.start();
        QTRY_VERIFY_WITH_TIMEOUT(!bench.service().storeProblem.empty(), 5000);
        qInfo("said after %lld ms", since.elapsed());
        QVERIFY(bench.service().storeProblem.english().find("while Kerf runs") != std::string::npos);
        const std::size_t accepted = m_accepted.size();
        bench.console().window()->showPage("boring");
        QTRY_VERIFY(std::ranges::any_of(bench.console().window()->findChildren<QLabel*>(), [](const QLabel* label) {
            return label->isVisible() && label->text().contains(QStringLiteral("while Kerf runs"));
        }));
        QTRY_VERIFY(bench.status().partsBlocked);  // no part of Kerf's begins
        QTRY_VERIFY_WITH_TIMEOUT(!bench.status().boring.cutting, 30'000);
        const std::uint64_t parts = bench.status().boring.partsCut;
        const std::uint64_t cycle = bench.status().cycle;
        QTRY_VERIFY_WITH_TIMEOUT(bench.status().cycle > cycle + 20'000, 30'000);  // the operator goes on trying
        QCOMPARE(bench.status().boring.partsCut, parts);
        QCOMPARE(m_accepted.size(), accepted);
        // What had been accepted before lies in the file, wherever that is now: whoever is killed here loses nothing.
        QTRY_VERIFY_WITH_TIMEOUT(allAcceptedIn(same), 10'000);
        bench.stop();
        QCOMPARE(m_accepted.size(), accepted);
        QVERIFY(allAcceptedIn(same));
        if (act == Deleted) {
            QVERIFY(!QFile::exists(file));  // and nothing has made an empty one in its place
            return;
        }
        if (act == Renamed) {
            QVERIFY(QFile::rename(file + QStringLiteral(".away"), file));
        }
        if (act == LogDeleted || act == Renamed) {
            start(bench);
            QTRY_VERIFY2_WITH_TIMEOUT(bench.up(), qPrintable(bench.failure()), 30'000);
            QTRY_VERIFY_WITH_TIMEOUT(m_accepted.size() > accepted, 60'000);
            QVERIFY(bench.service().storeProblem.empty());
            bench.stop();
            const std::set<qint64> stored = idsIn(file);
            QVERIFY(std::ranges::includes(stored, m_accepted));
        }
    }
};
QTEST_MAIN(TestConsoleGone)
#include "tst_console_gone.moc"
