// SPDX-License-Identifier: GPL-3.0-or-later
#include <sched.h>
#include <sys/mount.h>
#include <unistd.h>

#include <QApplication>
#include <QFile>
#include <QSqlQuery>
#include <QStorageInfo>

#include "db/connection.h"
#include "db/migrator.h"
#include "tests/support/console_bench.h"

using namespace kerf;

namespace {

bool put(const char* path, const QByteArray& text) {
    QFile file{QLatin1String(path)};
    return file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
}

/// Mounts of this process alone, which go with it; false where the computer does not allow them. Before any thread.
bool ownMounts() {
    const uid_t user = ::getuid();
    const gid_t group = ::getgid();
    if (user != 0) {
        const QByteArray ids = " 1\n";
        if (::unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0 ||
            !put("/proc/self/uid_map", "0 " + QByteArray::number(user) + ids) || !put("/proc/self/setgroups", "deny") ||
            !put("/proc/self/gid_map", "0 " + QByteArray::number(group) + ids)) {
            return false;
        }
    } else if (::unshare(CLONE_NEWNS) != 0) {
        return false;
    }
    return ::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0;
}

bool theyAreOurs = false;

}  // namespace

/// The real console on a disk of its own that is really full: what waits is told when the window closes, and found
/// again.
class TestConsoleFullDisk : public QObject {
    Q_OBJECT
    static constexpr qint64 kDisk_bytes = 32 << 20;

    test::ConsoleBench m_bench{};

    [[nodiscard]] QString ballast() const { return m_bench.folder() + QStringLiteral("/ballast"); }
    [[nodiscard]] QString data() const { return m_bench.folder() + QStringLiteral("/kerf.db"); }
    void start(bool autoOperator) {
        console::Options options;
        options.preparedParts = 0;
        options.simulationSpeed = 0.0;
        options.autoOperator = autoOperator;
        m_bench.start(options);
    }
    /// To the last byte.
    [[nodiscard]] bool fill() const {
        QFile file(ballast());
        if (!file.open(QIODevice::WriteOnly | QIODevice::Append | QIODevice::Unbuffered)) {
            return false;
        }
        const QByteArray block(4096, 'x');
        while (file.write(block) == block.size()) {
        }
        return QStorageInfo(m_bench.folder()).bytesAvailable() == 0;
    }
    /// The log is put into the file, so that the next write needs room.
    [[nodiscard]] bool emptyLog() const {
        const db::Connection connection(data().toStdString(), db::Access::Write);
        QSqlQuery checkpoint(connection.database());
        return checkpoint.exec(QStringLiteral("PRAGMA wal_checkpoint(TRUNCATE)")) && checkpoint.next() &&
               checkpoint.value(0).toInt() == 0;
    }
    [[nodiscard]] int storedParts() const {
        const db::Connection connection(data().toStdString(), db::Access::Read);
        QSqlQuery rows(QStringLiteral("SELECT count(*) FROM parts"), connection.database());
        return rows.next() ? rows.value(0).toInt() : -1;
    }
    [[nodiscard]] bool says(const QString& words) {
        return std::ranges::any_of(m_bench.console().window()->findChildren<QLabel*>(), [&](const QLabel* label) {
            return label->isVisible() && label->text().contains(words);
        });
    }
    /// What the screen showed last may have ended in the same turn: asked again once the machine stands still.
    [[nodiscard]] bool pausesWhileCutting() {
        m_bench.pause();
        m_bench.console().window()->client().tick();
        if (m_bench.status().program == ProgramState::Running) {
            return true;
        }
        m_bench.goOn();
        return false;
    }
    [[nodiscard]] bool closes() {
        m_bench.console().window()->close();
        return !m_bench.console().window()->isVisible();
    }

 private slots:
    void initTestCase() {
        const QByteArray size = "size=" + QByteArray::number(kDisk_bytes);
        if (!theyAreOurs || ::mount("tmpfs", qPrintable(m_bench.folder()), "tmpfs", 0, size.constData()) != 0) {
            QSKIP("this computer does not let a test mount a disk of its own");
        }
    }
    void cleanupTestCase() {
        m_bench.stop();
        (void)::umount2(qPrintable(m_bench.folder()), MNT_DETACH);
    }
    void partsThatWaitAreAskedForAtTheEndAndFoundAgain() {
        start(true);
        QTRY_VERIFY2_WITH_TIMEOUT(m_bench.up(), qPrintable(m_bench.failure()), 30'000);
        QTRY_VERIFY_WITH_TIMEOUT(storedParts() >= 3, 60'000);
        QTRY_VERIFY_WITH_TIMEOUT(pausesWhileCutting(), 30'000);
        QVERIFY(emptyLog());
        QVERIFY(fill());
        const int before = storedParts();
        m_bench.goOn();
        QTRY_VERIFY_WITH_TIMEOUT(m_bench.status().partsBlocked, 30'000);  // no part of Kerf's begins
        QTRY_VERIFY_WITH_TIMEOUT(m_bench.status().program != ProgramState::Running, 30'000);
        const auto made = static_cast<int>(m_bench.status().boring.partsCut);
        QVERIFY(made > before);
        QTRY_VERIFY(!m_bench.service().storeProblem.empty());

        QVERIFY(!closes());
        QTRY_VERIFY(says(QStringLiteral("The store does not take %1 finished parts").arg(made - before)));
        QVERIFY(m_bench.press("sheetSafe"));  // stay
        QVERIFY(m_bench.console().window()->isVisible());
        QVERIFY(!closes());
        QVERIFY(m_bench.press("sheetProceed"));
        QTRY_VERIFY(!m_bench.console().window()->isVisible());
        m_bench.stop();
        QCOMPARE(storedParts(), before);

        start(false);  // as full as before: whatever it says, nothing of them goes
        QTRY_VERIFY_WITH_TIMEOUT(m_bench.up() || !m_bench.failure().isEmpty(), 30'000);
        qInfo("started on the full disk: %s", m_bench.up() ? "it runs" : qPrintable(m_bench.failure()));
        m_bench.stop();

        QVERIFY(QFile::remove(ballast()));
        start(false);
        QTRY_VERIFY2_WITH_TIMEOUT(m_bench.up(), qPrintable(m_bench.failure()), 30'000);
        QTRY_VERIFY(says(QStringLiteral("finished parts had waited beside the data file; they are stored now")));
        QTRY_COMPARE_WITH_TIMEOUT(storedParts(), made, 30'000);
        QVERIFY(!m_bench.status().partsBlocked);
        QVERIFY(closes());  // nothing waits: nothing is asked
        m_bench.stop();
        QVERIFY(db::checkDatabase(data().toStdString()));
    }
};

int main(int argc, char** argv) {
    theyAreOurs = ownMounts();
    QApplication app(argc, argv);
    TestConsoleFullDisk test;
    return QTest::qExec(&test, argc, argv);
}
#include "tst_console_full_disk.moc"
