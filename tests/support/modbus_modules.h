// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStandardPaths>
#include <QString>
#include <QTemporaryDir>
#include <QTest>
#include <vector>

namespace kerf::test {

/// Modbus modules that others have written (python3-pymodbus), behind lines that can be made bad; tests/support/
/// modbus_server.py. Ended with the object.
class ModbusModules {
 public:
    ModbusModules() = default;
    ModbusModules(const ModbusModules&) = delete;
    ModbusModules& operator=(const ModbusModules&) = delete;
    ~ModbusModules() {
        m_server.closeWriteChannel();
        if (!m_server.waitForFinished(3000)) {
            m_server.kill();
            m_server.waitForFinished();
        }
        for (auto& pair : m_pairs) {
            pair->terminate();
            pair->waitForFinished(3000);
        }
    }
    /// Why they cannot run here; empty when they can.
    [[nodiscard]] static QString whyNot(bool serial = false) {
        QProcess look;
        look.start(QString::fromLatin1(kPython),
                   {QStringLiteral("-c"), QStringLiteral("import pymodbus.server, serial")});
        if (!look.waitForStarted() || !look.waitForFinished() || look.exitCode() != 0) {
            return QStringLiteral(
                "pymodbus is not installed here (packages python3-pymodbus, python3-serial and "
                "python3-serial-asyncio)");
        }
        if (serial && QStandardPaths::findExecutable(QStringLiteral("socat")).isEmpty()) {
            return QStringLiteral("socat is not installed here (package socat)");
        }
        return {};
    }
    [[nodiscard]] bool start() {
        m_server.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        m_server.start(QString::fromLatin1(kPython),
                       {QStringLiteral(KERF_SOURCE_DIR "/tests/support/modbus_server.py")});
        return m_server.waitForStarted();
    }
    /// One module with one unit; returns its port, `id` is what the other calls name it by.
    int addTcp(int& id, int registers = 64, int unit = 1) {
        const QJsonObject answer = order({{"do", "tcp"}, {"units", units(unit, registers)}});
        id = answer["id"].toInt(-1);
        return answer["port"].toInt();
    }
    /// A pair of serial devices by socat: modules on one end, the name of the other end is returned.
    QString addRtu(int& id, const std::vector<int>& unitNumbers, int registers = 64) {
        const QString theirs = m_folder.filePath(QStringLiteral("line%1-modules").arg(m_pairs.size()));
        const QString ours = m_folder.filePath(QStringLiteral("line%1-kerf").arg(m_pairs.size()));
        if (!makePair(theirs, ours)) {
            return {};
        }
        QJsonObject all;
        for (const int unit : unitNumbers) {
            all[QString::number(unit)] = units(unit, registers)[QString::number(unit)];
        }
        id = order({{"do", "rtu"}, {"device", theirs}, {"units", all}})["id"].toInt(-1);
        return ours;
    }
    bool makePair(const QString& one, const QString& other) {
        auto pair = std::make_unique<QProcess>();
        pair->start(QStringLiteral("socat"),
                    {QStringLiteral("pty,raw,echo=0,link=") + one, QStringLiteral("pty,raw,echo=0,link=") + other});
        m_pairs.push_back(std::move(pair));
        return QTest::qWaitFor([&] { return QFile::exists(one) && QFile::exists(other); }, 10'000);
    }
    /// Ends the newest pair: as an adapter that is pulled out.
    void dropPair() {
        m_pairs.back()->terminate();
        m_pairs.back()->waitForFinished(3000);
        m_pairs.pop_back();
    }
    bool set(int id, const char* kind, int address, const std::vector<int>& values, int unit = 1) {
        QJsonArray list;
        for (const int value : values) {
            list.append(value & 0xFFFF);
        }
        return order({{"do", "set"},
                      {"id", id},
                      {"unit", unit},
                      {"kind", kind},
                      {"address", address},
                      {"values", list}})["ok"]
            .toBool();
    }
    bool line(int id, const char* mode, double delay_s = 0.5) {
        return order({{"do", "line"}, {"id", id}, {"mode", mode}, {"delay_s", delay_s}})["ok"].toBool();
    }
    [[nodiscard]] QString file(const char* name) const { return m_folder.filePath(QString::fromLatin1(name)); }

 private:
    static constexpr const char* kPython = "/usr/bin/python3";  // Debian's own: it has Debian's packages

    static QJsonObject units(int unit, int registers) {
        return {{QString::number(unit),
                 QJsonObject{{"input", registers}, {"holding", registers}, {"discrete", registers}, {"coil", 8}}}};
    }
    QJsonObject order(const QJsonObject& what) {
        m_server.write(QJsonDocument(what).toJson(QJsonDocument::Compact) + '\n');
        while (!m_server.canReadLine()) {
            if (!m_server.waitForReadyRead(10'000)) {
                return {};
            }
        }
        const QJsonObject answer = QJsonDocument::fromJson(m_server.readLine()).object();
        if (answer.contains("fault")) {
            qWarning("modules: %s", qPrintable(answer["fault"].toString()));
        }
        return answer;
    }

    QProcess m_server;
    QTemporaryDir m_folder;
    std::vector<std::unique_ptr<QProcess>> m_pairs;
};

}  // namespace kerf::test
