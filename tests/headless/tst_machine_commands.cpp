// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <nlohmann/json.hpp>

#include "tests/support/kerf_program.h"

using kerf::test::KerfRun;
using kerf::test::runKerf;

/// Commands about a real machine, where there is none, and the part program for one without a live link.
class TestMachineCommands : public QObject {
    Q_OBJECT
 private slots:
    void statusWithoutAMachineTellsWhatIsMissing() {
        const KerfRun run = runKerf({QStringLiteral("machine"), QStringLiteral("status")});
        if (run.exitCode == 0) {
            QSKIP("a LinuxCNC runs on this computer");
        }
        QCOMPARE(run.exitCode, 3);
        const auto json = nlohmann::json::parse(run.out.toStdString());
        QCOMPARE(json["signals"]["link"].get<std::string>(), std::string("down"));
        QVERIFY(!json["capabilities"]["work_offset"]["why"].get<std::string>().empty());
        QVERIFY(run.err.contains("not reached"));
    }
    void exportedScheduleIsASubroutine() {
        const KerfRun run =
            runKerf({QStringLiteral("boring"), QStringLiteral("export-gcode"), QStringLiteral("--ln-c"),
                     QStringLiteral("-2.44"), QStringLiteral("--alpha"), QStringLiteral("0.5"),
                     QStringLiteral("--beta"), QStringLiteral("0.27"), QStringLiteral("--target-deflection"),
                     QStringLiteral("0.1165"), QStringLiteral("--name"), QStringLiteral("bore7")});
        QCOMPARE(run.exitCode, 0);
        QVERIFY(run.out.startsWith("o<bore7> sub\n"));
        QVERIFY(run.out.contains("o<bore7> endsub\n"));
    }
    void unusableScheduleIsRefused() {
        const KerfRun run = runKerf(
            {QStringLiteral("boring"), QStringLiteral("export-gcode"), QStringLiteral("--alpha"), QStringLiteral("0")});
        QCOMPARE(run.exitCode, 3);
        QVERIFY(run.out.isEmpty());
        QVERIFY(!run.err.isEmpty());
    }
};
QTEST_APPLESS_MAIN(TestMachineCommands)
#include "tst_machine_commands.moc"
