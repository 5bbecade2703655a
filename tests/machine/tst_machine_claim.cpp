// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QNetworkInterface>
#include <QProcess>
#include <QTcpServer>
#include <QTemporaryDir>
#include <QTest>
#include <clocale>

#include "engine/machine/linuxcnc/fitted.h"
#include "engine/machine/linuxcnc/ini_file.h"
#include "engine/machine/linuxcnc/machine_claim.h"
#include "engine/machine/linuxcnc/port_exposure.h"
#include "engine/machine/linuxcnc/programs.h"
#include "engine/machine/linuxcnc/rsh_password.h"

using namespace kerf;
using namespace kerf::linuxcnc;

namespace {

PortRequest startRequest(std::uint32_t number) {
    StartProgram start;
    start.process = ProcessId::Boring;
    start.programmedFeed_mmPerRev = 0.1;
    start.spindleSpeed_rpm = 400.0;
    start.from_mm = 40.0;
    start.to_mm = 80.0;
    return {number, start};
}

}  // namespace

/// Who commands a LinuxCNC, in which units, and what becomes of a command: without a LinuxCNC.
class TestMachineClaim : public QObject {
    Q_OBJECT
 private slots:
    void aLivingProgramKeepsTheMachineADeadOneDoesNot() {
        QProcess other;
        other.start(QStringLiteral("sleep"), {QStringLiteral("600")});
        QVERIFY(other.waitForStarted());
        QFile stat(QStringLiteral("/proc/%1/stat").arg(other.processId()));
        QVERIFY(stat.open(QIODevice::ReadOnly));
        const QByteArray text = stat.readAll();
        const auto start = text.mid(text.lastIndexOf(')') + 2).split(' ').at(19).toULongLong();
        const std::uint64_t theirs = (static_cast<std::uint64_t>(other.processId()) << 32U) | (start & 0xFFFFFFFF);
        QVERIFY(alive(theirs));
        QVERIFY(!alive(theirs + 1));  // the same number, given out again
        Claim owner{theirs};
        QVERIFY(!claim(owner));
        QVERIFY(!claimIfFree(owner, ownClaim()));
        QCOMPARE(owner.load(), theirs);
        giveUp(owner);  // not ours: left alone
        QCOMPARE(owner.load(), theirs);
        other.kill();
        QVERIFY(other.waitForFinished());
        QVERIFY(claim(owner));  // seen to have died, and a person has started this program
        QCOMPARE(owner.load(), ownClaim());
        QVERIFY(claim(owner));
        giveUp(owner);
        QCOMPARE(owner.load(), std::uint64_t{0});
        QVERIFY(claimIfFree(owner, ownClaim()));
    }
    void unitsAreReadAndInchesRefused() {
        QCOMPARE(unitsOf("[DISPLAY]\nLINEAR_UNITS = inch\n[TRAJ]\n# LINEAR_UNITS = inch\nLINEAR_UNITS = mm # ours\n"),
                 MachineUnits::Millimetre);
        QCOMPARE(unitsOf("[TRAJ]\r\nLINEAR_UNITS=inch\r\n"), MachineUnits::Inch);
        QCOMPARE(unitsOf("[TRAJ]\nLINEAR_UNITS = furlong\n"), MachineUnits::Unknown);
        QCOMPARE(unitsOf(""), MachineUnits::Unknown);
        Fitted fitted;
        fitted.externalOffsets = true;
        fitted.units = MachineUnits::Millimetre;
        QVERIFY(capabilitiesOf(fitted, {}).workOffset.fitted);
        for (const MachineUnits units : {MachineUnits::Inch, MachineUnits::Unknown}) {
            fitted.units = units;
            const Capabilities c = capabilitiesOf(fitted, {});
            QVERIFY(!c.workOffset.fitted && !c.cycleStart.fitted && !c.feedScale.fitted);
            QVERIFY(!c.process[static_cast<std::size_t>(ProcessId::Boring)].fitted);
            QVERIFY(!c.cycleStart.why.empty());
        }
    }
    void linesHaveAPointInEveryLocale() {
        for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"}) {
            if (std::setlocale(LC_ALL, name) != nullptr) break;
        }
        const auto line = programLine(std::get<StartProgram>(startRequest(1).action));
        QVERIFY(line);
        QCOMPARE(*line, std::string("set mdi o<kerf_bore> call [40.000000] [40.000000] [400.000000] [0.000000]"));
        QCOMPARE(originShiftLine({1.0, -2.0, 3.5}),
                 std::string("set mdi o<kerf_shift> call [1.000000] [-2.000000] [3.500000]"));
        QVERIFY(line->find(',') == std::string::npos);
        std::setlocale(LC_ALL, "C");
    }
    void passwordsComeFromAFileOfOnesOwn() {
        QVERIFY(readRshPassword(""));
        QCOMPARE(readRshPassword("")->enable, std::string("EMCTOO"));
        QTemporaryDir folder;
        const QString name = folder.filePath(QStringLiteral("rsh"));
        QFile file(name);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("hello-word\nenable-word\n");
        file.close();
        QVERIFY(QFile::setPermissions(name, QFile::ReadOwner | QFile::WriteOwner));
        const auto read = readRshPassword(name.toStdString());
        QVERIFY(read);
        QCOMPARE(read->connect, std::string("hello-word"));
        QCOMPARE(read->enable, std::string("enable-word"));
        QVERIFY(QFile::setPermissions(name, QFile::ReadOwner | QFile::WriteOwner | QFile::ReadOther));
        QVERIFY(!readRshPassword(name.toStdString()));
        QVERIFY(!readRshPassword("/no/such/file"));
    }
    void aPortThatOthersReachIsSeen() {
        QTcpServer server;
        QVERIFY(server.listen(QHostAddress::LocalHost));
        QCOMPARE(openAddress(server.serverPort()), std::string());  // this computer alone
        server.close();
        QVERIFY(server.listen(QHostAddress::AnyIPv4));
        QStringList others;
        for (const QNetworkInterface& each : QNetworkInterface::allInterfaces()) {
            const auto flags = each.flags();
            for (const QNetworkAddressEntry& entry : each.addressEntries()) {
                if (flags.testFlag(QNetworkInterface::IsUp) && !flags.testFlag(QNetworkInterface::IsLoopBack) &&
                    entry.ip().protocol() == QAbstractSocket::IPv4Protocol) {
                    others << entry.ip().toString();
                }
            }
        }
        const std::string found = openAddress(server.serverPort());
        QCOMPARE(others.contains(QString::fromStdString(found)),
                 !others.isEmpty());  // a computer without a network has none
    }
};
QTEST_GUILESS_MAIN(TestMachineClaim)
#include "tst_machine_claim.moc"
