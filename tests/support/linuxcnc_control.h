// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <QFile>
#include <QProcess>
#include <QStandardPaths>
#include <QTcpSocket>
#include <QTemporaryDir>
#include <QTest>
#include <chrono>
#include <csignal>
#include <cstdint>

#include "engine/machine/linuxcnc/link_memory.h"

namespace kerf::test {

/// LinuxCNC's own simulator as scripts/linuxcnc-sim runs it: out of emergency stop, on, homed. Ended with the object.
class LinuxCncControl {
 public:
    LinuxCncControl() = default;
    LinuxCncControl(const LinuxCncControl&) = delete;
    LinuxCncControl& operator=(const LinuxCncControl&) = delete;
    ~LinuxCncControl() { stop(); }

    /// Why it cannot run here; empty when it can.
    [[nodiscard]] static QString whyNot() {
        if (!QFile::exists(bin() + QStringLiteral("/kerf-hal")) ||
            QStandardPaths::findExecutable(QStringLiteral("linuxcnc")).isEmpty()) {
            return QStringLiteral("LinuxCNC is not installed here (packages linuxcnc-uspace and linuxcnc-uspace-dev)");
        }
        QTcpSocket socket;
        socket.connectToHost(QStringLiteral("127.0.0.1"), 5007);
        if (socket.waitForConnected(200)) {
            return QStringLiteral("another LinuxCNC answers on port 5007: stop it first");
        }
        return {};
    }
    /// Returns when the machine is ready; false, with log() saying why, when it does not get there.
    [[nodiscard]] bool start(const QStringList& options = {}) {
        (void)shm_unlink(linuxcnc::kStopsName);  // a machine where nothing has happened yet
        goFirst();
        const QString ready = m_folder.filePath(QStringLiteral("ready"));
        QFile::remove(ready);
        m_process.setProgram(QStringLiteral(KERF_SOURCE_DIR "/scripts/linuxcnc-sim"));
        m_process.setArguments(QStringList{QStringLiteral("--ready"), ready} + options + QStringList{bin()});
        m_process.setStandardOutputFile(logFile());
        m_process.setStandardErrorFile(logFile(), QIODevice::Append);
        m_process.start();
        return QTest::qWaitFor([this, ready] { return QFile::exists(ready) || !running(); }, 60'000) && running();
    }
    void stop() {
        if (!running()) {
            return;
        }
        m_process.terminate();  // the script ends its own control
        if (!m_process.waitForFinished(20'000)) {
            m_process.kill();
            m_process.waitForFinished();
        }
    }
    [[nodiscard]] bool running() const { return m_process.state() != QProcess::NotRunning; }
    [[nodiscard]] QByteArray log() const {
        QFile file(logFile());
        (void)file.open(QIODevice::ReadOnly);
        return "LinuxCNC: " + file.readAll().right(1500);
    }
    /// The bridge killed as kill -9 does; when it was, 0 if there is none.
    [[nodiscard]] static std::int64_t killBridge() { return killAll({QStringLiteral("kerf-hal")}); }
    /// A bridge started anew beside the control that runs, as a person does it who has found it dead.
    [[nodiscard]] static bool startBridge() {
        QProcess find;
        find.start(QStringLiteral("pgrep"), {QStringLiteral("-n"), QStringLiteral("-x"), QStringLiteral("milltask")});
        find.waitForFinished();
        const QString folder = QFile::symLinkTarget(
            QStringLiteral("/proc/%1/cwd").arg(QString::fromLatin1(find.readAllStandardOutput()).trimmed()));
        QProcess halcmd;
        QStringList words{QStringLiteral("env"),
                          QStringLiteral("INI_FILE_NAME=%1/kerf-sim.ini").arg(folder),
                          QStringLiteral("LINUXCNCVERSION=2.9"),
                          QStringLiteral("halcmd"),
                          QStringLiteral("loadusr"),
                          QStringLiteral("-Wn"),
                          QStringLiteral("kerf-hal"),
                          folder + QStringLiteral("/kerf-hal")};
        if (::geteuid() == 0) {
            words = QStringList{QStringLiteral("setpriv"), QStringLiteral("--reuid=nobody"),
                                QStringLiteral("--regid=nogroup"), QStringLiteral("--clear-groups")} +
                    words;
        }
        halcmd.setStandardOutputFile(QProcess::nullDevice());  // which the bridge keeps
        halcmd.setStandardErrorFile(QProcess::nullDevice());
        halcmd.start(words.takeFirst(), words);
        return halcmd.waitForFinished(20'000) && halcmd.exitCode() == 0;
    }
    /// The bridge stands still, as one that gets no processor, or goes on.
    [[nodiscard]] static bool stopBridge(bool still) {
        return killAll({QStringLiteral("kerf-hal")}, still ? SIGSTOP : SIGCONT) != 0;
    }
    /// LinuxCNC's real-time part and its task killed as kill -9 does; stop() clears up after them.
    [[nodiscard]] static std::int64_t killControl() {
        return killAll({QStringLiteral("rtapi_app"), QStringLiteral("milltask"), QStringLiteral("linuxcncsvr")});
    }

    /// This thread and those it makes do not wait for other work of this computer, where that is allowed; the control
    /// itself (scripts/linuxcnc-sim) goes before them.
    static void goFirst() {
        const sched_param param{.sched_priority = 5};
        if (sched_setscheduler(0, SCHED_RR, &param) != 0) {
            (void)setpriority(PRIO_PROCESS, 0, -10);
        }
    }

 private:
    /// The newest of each: one that a broken run has left behind is not ours. When the first was killed; 0 if one is
    /// not there.
    [[nodiscard]] static std::int64_t killAll(const QStringList& names, int signal = SIGKILL) {
        QList<int> processes;
        for (const QString& name : names) {
            QProcess find;
            find.start(QStringLiteral("pgrep"), {QStringLiteral("-n"), QStringLiteral("-x"), name});
            find.waitForFinished();
            processes.append(find.readAllStandardOutput().trimmed().toInt());
            if (processes.back() <= 1) {
                return 0;
            }
        }
        const std::int64_t now_ns = std::chrono::steady_clock::now().time_since_epoch().count();
        for (const int process : processes) {
            if (::kill(process, signal) != 0) {
                return 0;
            }
        }
        return now_ns;
    }
    [[nodiscard]] static QString bin() { return QString::fromLocal8Bit(qgetenv("KERF_BIN")); }
    [[nodiscard]] QString logFile() const { return m_folder.filePath(QStringLiteral("linuxcnc.log")); }

    QTemporaryDir m_folder;
    QProcess m_process;
};

/// One line to linuxcncrsh, beside the console: what an operator does at the control.
class AtTheControl {
 public:
    AtTheControl() {
        m_socket.connectToHost(QStringLiteral("127.0.0.1"), 5007);
        m_socket.waitForConnected(2000);
        for (const char* line : {"hello EMC operator 1", "set echo off", "set verbose on"}) {
            ask(line);
        }
    }
    /// A command; the answer as the control gives it.
    QByteArray say(const char* line) {
        ask("set enable EMCTOO");
        return ask(line);
    }
    QByteArray ask(const char* line) {
        m_socket.write(QByteArray(line) + "\r\n");
        m_socket.flush();
        return m_socket.waitForReadyRead(2000) ? m_socket.readAll() : QByteArray();
    }

 private:
    QTcpSocket m_socket;
};

[[nodiscard]] inline std::int64_t monotonic_ns() {
    return std::chrono::steady_clock::now().time_since_epoch().count();
}

}  // namespace kerf::test
