// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "app/live/live_page.h"
#include "engine/machine/linuxcnc/linuxcnc_machine.h"
#include "engine/machine/linuxcnc/machine_claim.h"
#include "tests/support/console_bench.h"
#include "tests/support/lateness.h"
#include "tests/support/linuxcnc_control.h"

using namespace kerf;

namespace {

/// kerf-console as a process with a data folder of its own.
class ConsoleProcess {
 public:
    ConsoleProcess() = default;
    ConsoleProcess(const ConsoleProcess&) = delete;
    ConsoleProcess& operator=(const ConsoleProcess&) = delete;
    ~ConsoleProcess() { kill(); }

    bool start() {
        m_process.setStandardOutputFile(QProcess::nullDevice());
        m_process.setStandardErrorFile(m_folder.filePath(QStringLiteral("stderr")), QIODevice::Append);
        m_process.start(QString::fromLocal8Bit(qgetenv("KERF_BIN")) + QStringLiteral("/kerf-console"),
                        {QStringLiteral("--machine"), QStringLiteral("linuxcnc"), QStringLiteral("--data"),
                         m_folder.path(), QStringLiteral("--prepared-parts"), QStringLiteral("0")});
        return m_process.waitForStarted() && QTest::qWaitFor([this] { return seesTheMachine(); }, 60'000);
    }
    /// As kill -9 does.
    void kill() {
        if (m_process.state() != QProcess::NotRunning) {
            m_process.kill();
            m_process.waitForFinished();
        }
    }
    /// As a person ends it, or the computer is shut down.
    bool close() {
        m_process.terminate();
        return m_process.waitForFinished(20'000) && m_process.exitStatus() == QProcess::NormalExit &&
               m_process.exitCode() == 0;
    }
    [[nodiscard]] std::uint32_t id() const { return static_cast<std::uint32_t>(m_process.processId()); }
    [[nodiscard]] bool running() const { return m_process.state() == QProcess::Running; }
    [[nodiscard]] bool seesTheMachine() { return running() && live().value(QStringLiteral("link")).toBool(); }
    /// Loops that this console may run on the machine.
    [[nodiscard]] qsizetype loops() { return live().value(QStringLiteral("loops")).toArray().size(); }
    [[nodiscard]] QByteArray said() const {
        QFile file(m_folder.filePath(QStringLiteral("stderr")));
        return file.open(QIODevice::ReadOnly) ? file.readAll().right(1500) : QByteArray();
    }

 private:
    [[nodiscard]] QJsonObject live() {
        const auto now = live::PageReader(live::livePagePath(m_folder.path().toStdString())).read();
        return now && now->age_ms < 2000 ? QJsonDocument::fromJson(QByteArray::fromStdString(now->text)).object()
                                         : QJsonObject();
    }

    QTemporaryDir m_folder;
    QProcess m_process;
};

}  // namespace

/// Consoles with data folders of their own at one LinuxCNC: one commands, the others read and say so, and only a person
/// changes that.
class TestConsoleTwo : public QObject {
    Q_OBJECT

    [[nodiscard]] std::uint32_t owner() {
        linuxcnc::LinkMemory* memory = m_link->take();
        return memory == nullptr ? 0 : linuxcnc::processOf(memory->owner.load());
    }
    [[nodiscard]] linuxcnc::FromControl control() {
        linuxcnc::FromControl seen;
        linuxcnc::LinkMemory* memory = m_link->take();
        if (memory != nullptr) {
            (void)memory->fromControl.latest(seen);
        }
        return seen;
    }
    /// It stays so for half a second.
    [[nodiscard]] bool ownerStays(std::uint32_t process) {
        return !QTest::qWaitFor([&] { return owner() != process; }, 500);
    }
    [[nodiscard]] static bool shown(test::ConsoleBench& bench, const QString& words) {
        const auto labels = bench.console().window()->findChildren<QWidget*>();
        return std::ranges::any_of(labels, [&](const QWidget* widget) {
            const auto* label = qobject_cast<const QLabel*>(widget);
            const auto* button = qobject_cast<const QAbstractButton*>(widget);
            return (label != nullptr && label->text().contains(words)) ||
                   (button != nullptr && (button->text() + button->toolTip()).contains(words));
        });
    }

    test::LinuxCncControl m_linuxcnc;
    std::unique_ptr<linuxcnc::SharedLink> m_link{};

 private slots:
    void initTestCase() {
        if (const QString why = test::LinuxCncControl::whyNot(); !why.isEmpty()) {
            QSKIP(qPrintable(why));
        }
        QVERIFY2(m_linuxcnc.start(), m_linuxcnc.log());
        m_link = std::make_unique<linuxcnc::SharedLink>();
    }
    void cleanupTestCase() { m_link.reset(); }

    void oneCommandsTheOtherReadsAndOnlyAPersonChangesThat() {
        ConsoleProcess first;
        QVERIFY2(first.start(), first.said());
        QTRY_COMPARE(owner(), first.id());
        QTRY_VERIFY(first.loops() >= 3);
        QTRY_VERIFY(!control().consoleLost);

        ConsoleProcess second;
        QVERIFY2(second.start(), second.said());
        QVERIFY(ownerStays(first.id()));
        QCOMPARE(second.loops(), qsizetype{0});
        test::ConsoleBench third;  // the same program, its screen before us
        console::Options options;
        options.machine = "linuxcnc";
        options.preparedParts = 0;
        third.start(options);
        QTRY_VERIFY2_WITH_TIMEOUT(third.up(), qPrintable(third.failure()), 20'000);
        QTRY_VERIFY_WITH_TIMEOUT(third.status().link == LinkState::Up, 20'000);
        third.console().window()->showPage("overview");
        QTRY_VERIFY_WITH_TIMEOUT(shown(third, QStringLiteral("process %1) commands").arg(first.id())), 10'000);
        QVERIFY(ownerStays(first.id()));

        const std::int64_t killed_ns = test::monotonic_ns();
        first.kill();
        QTRY_VERIFY_WITH_TIMEOUT(control().consoleLost, 2000);
        qInfo("first console killed: the control has noticed after %.0f ms at most",
              static_cast<double>(test::monotonic_ns() - killed_ns) * 1e-6);
        linuxcnc::LinkMemory* memory = m_link->take();
        QVERIFY(!linuxcnc::alive(memory->owner.load()));
        QVERIFY(ownerStays(memory->owner.load() >> 32U));  // the second does not step in by itself
        // Whoever reads says that nobody commands any more.
        QTRY_VERIFY_WITH_TIMEOUT(shown(third, QStringLiteral("Nobody commands this machine")), 10'000);
        QVERIFY(!shown(third, QStringLiteral("process %1) commands").arg(first.id())));
        third.stop();
        QCOMPARE(second.loops(), qsizetype{0});

        QVERIFY(second.close());
        QVERIFY2(second.start(), second.said());  // a person starts it anew
        QTRY_COMPARE(owner(), second.id());
        QTRY_VERIFY(second.loops() >= 3);
        QTRY_VERIFY(!control().consoleLost);

        QVERIFY2(first.start(), first.said());
        QVERIFY(ownerStays(second.id()));
        QCOMPARE(first.loops(), qsizetype{0});
        memory->owner.store(0);  // kerf machine take-over
        QTRY_COMPARE(second.loops(), qsizetype{0});
        QVERIFY(ownerStays(0));  // neither takes it by itself
        QVERIFY(first.close());
        QVERIFY2(first.start(), first.said());
        QTRY_COMPARE(owner(), first.id());
        QTRY_VERIFY(first.loops() >= 3);
        QCOMPARE(second.loops(), qsizetype{0});
        QVERIFY(second.close());
        QVERIFY(ownerStays(first.id()));
        QVERIFY(first.close());
        QCOMPARE(owner(), 0U);  // given back, free for whoever is started next
    }
};
KERF_GUI_TEST_IN_TIME(TestConsoleTwo)
#include "tst_console_two.moc"
