// SPDX-License-Identifier: GPL-3.0-or-later
#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <chrono>
#include <clocale>
#include <mutex>
#include <thread>

#include "engine/machine/linuxcnc/fitted.h"
#include "engine/machine/linuxcnc/ini_file.h"
#include "engine/machine/linuxcnc/machine_claim.h"
#include "engine/machine/linuxcnc/programs.h"
#include "engine/machine/linuxcnc/rsh_link.h"
#include "engine/machine/linuxcnc/rsh_password.h"

using namespace kerf;
using namespace kerf::linuxcnc;

namespace {

/// A linuxcncrsh that acknowledges what it likes: one line, one answer, in a thread of its own.
class FakeRsh {
 public:
    FakeRsh() {
        m_listen = ::socket(AF_INET, SOCK_STREAM, 0);
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        (void)::bind(m_listen, reinterpret_cast<sockaddr*>(&address), size);
        (void)::listen(m_listen, 4);
        (void)::getsockname(m_listen, reinterpret_cast<sockaddr*>(&address), &size);
        m_port = ntohs(address.sin_port);
        m_thread = std::thread([this] { run(); });
    }
    FakeRsh(const FakeRsh&) = delete;
    FakeRsh& operator=(const FakeRsh&) = delete;
    ~FakeRsh() {
        m_stop = true;
        ::shutdown(m_listen, SHUT_RDWR);
        m_thread.join();
        ::close(m_listen);
    }
    [[nodiscard]] std::uint16_t port() const { return m_port; }
    void beSilentAt(const std::string& start) {
        const std::lock_guard lock(m_lock);
        m_silent = start;
    }
    [[nodiscard]] bool heard(const std::string& start) {
        const std::lock_guard lock(m_lock);
        return std::ranges::any_of(m_lines, [&](const std::string& line) { return line.starts_with(start); });
    }

 private:
    void run() {
        while (!m_stop) {
            const int peer = ::accept(m_listen, nullptr, nullptr);
            if (peer < 0) {
                continue;
            }
            std::string text;
            char block[256];
            for (ssize_t got = 0; !m_stop && (got = ::recv(peer, block, sizeof block, 0)) > 0;) {
                text.append(block, static_cast<std::size_t>(got));
                for (std::size_t end = text.find("\r\n"); end != std::string::npos; end = text.find("\r\n")) {
                    answer(peer, text.substr(0, end));
                    text.erase(0, end + 2);
                }
            }
            ::close(peer);
        }
    }
    void answer(int peer, const std::string& line) {
        const std::lock_guard lock(m_lock);
        m_lines.push_back(line);
        if (m_silent.empty() || !line.starts_with(m_silent)) {
            const std::string reply = line + " ACK\r\n";
            (void)::send(peer, reply.data(), reply.size(), MSG_NOSIGNAL);
        }
    }

    int m_listen{-1};
    std::uint16_t m_port{0};
    std::atomic<bool> m_stop{false};
    std::mutex m_lock;
    std::string m_silent;
    std::vector<std::string> m_lines;
    std::thread m_thread;
};

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
        QVERIFY(capabilitiesOf(fitted).workOffset.fitted);
        for (const MachineUnits units : {MachineUnits::Inch, MachineUnits::Unknown}) {
            fitted.units = units;
            const Capabilities c = capabilitiesOf(fitted);
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
    void abortOvertakesACommandThatGetsNoAnswer() {
        FakeRsh control;
        control.beSilentAt("set mode mdi");
        RshLink link({"127.0.0.1", control.port(), {}});
        QTRY_VERIFY(link.connected());
        QVERIFY(link.tryAsk(startRequest(7)));
        QTRY_VERIFY(control.heard("set mode mdi"));
        QVERIFY(link.tryAsk(startRequest(8)));  // waits behind the first
        const auto asked = std::chrono::steady_clock::now();
        QVERIFY(link.tryAsk({9, AbortProgram{}}));
        QTRY_VERIFY(control.heard("set abort"));
        QVERIFY(std::chrono::steady_clock::now() - asked < std::chrono::seconds(1));  // not the two of a lost answer
        std::map<std::uint32_t, RequestState> states;
        RequestReply reply;
        QTRY_VERIFY((link.tryReply(reply) ? void(states[reply.number] = reply.state) : void(), states.size() == 3));
        QCOMPARE(states[7], RequestState::Refused);
        QCOMPARE(states[8], RequestState::Refused);
        QCOMPARE(states[9], RequestState::Done);
    }
};
QTEST_GUILESS_MAIN(TestMachineClaim)
#include "tst_machine_claim.moc"
