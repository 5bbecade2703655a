// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "tests/support/console_bench.h"
#include "tests/support/linuxcnc_control.h"

using namespace kerf;

/// The real console on LinuxCNC's own simulator, offscreen: it starts before the control, finds it, and takes it over
/// again after its restart.
class TestConsoleLinuxCnc : public QObject {
    Q_OBJECT
 private slots:
    void initTestCase() {
        if (const QString why = test::LinuxCncControl::whyNot(); !why.isEmpty()) {
            QSKIP(qPrintable(why));
        }
    }
    void startsWithoutLinuxCncAndFindsItByItself() {
        console::Options options;
        options.machine = "linuxcnc";
        m_bench.start(options);
        QTRY_VERIFY2_WITH_TIMEOUT(m_bench.up(), qPrintable(m_bench.failure()), 20'000);
        QCOMPARE(m_bench.status().link, LinkState::Down);
        QVERIFY2(m_control.start(), m_control.log());
        QTRY_VERIFY_WITH_TIMEOUT(m_bench.status().link == LinkState::Up && m_bench.status().machineOn, 10'000);
    }
    void loopsTheMachineCannotHostSayWhy() {
        QVERIFY(m_bench.up());
        const auto reason = [this](ProcessId id) {
            return m_bench.status().loops[static_cast<std::size_t>(id)].reason.english();
        };
        QTRY_VERIFY(!m_bench.status().loops[static_cast<std::size_t>(ProcessId::Thermal)].fitted);
        QVERIFY2(reason(ProcessId::Thermal).find("temperatures") != std::string::npos,
                 reason(ProcessId::Thermal).c_str());
        QVERIFY2(reason(ProcessId::Turning).find("0.2 ms") != std::string::npos, reason(ProcessId::Turning).c_str());
    }
    void controlRestartedIsTakenOverAgain() {
        QVERIFY(m_bench.up());
        m_control.stop();
        QTRY_COMPARE_WITH_TIMEOUT(m_bench.status().link, LinkState::Down, 10'000);
        QVERIFY2(m_control.start(), m_control.log());
        QTRY_COMPARE_WITH_TIMEOUT(m_bench.status().link, LinkState::Up, 10'000);
    }
    void cleanupTestCase() { m_bench.stop(); }

 private:
    test::LinuxCncControl m_control;
    test::ConsoleBench m_bench;
};
QTEST_MAIN(TestConsoleLinuxCnc)
#include "tst_console_linuxcnc.moc"
