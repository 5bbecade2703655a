// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sensors/modbus_scan.h"

#include <QEventLoop>
#include <QModbusReply>
#include <QModbusTcpClient>
#include <QTimer>
#include <QVariant>
#include <memory>

namespace kerf::sensors {
namespace {

constexpr int kBlock = 8;
constexpr int kLookAt = 64;
constexpr int kConnect_ms = 3000;

enum class Answer : std::uint8_t { Values, Refusal, Silence };

class Scanner {
 public:
    explicit Scanner(const ScanOptions& options) {
        m_client.setConnectionParameter(QModbusDevice::NetworkAddressParameter, QString::fromStdString(options.host));
        m_client.setConnectionParameter(QModbusDevice::NetworkPortParameter, options.port);
        m_client.setTimeout(options.timeout_ms);
        m_client.setNumberOfRetries(0);
    }
    bool connectNow() {
        if (m_client.state() == QModbusDevice::ConnectedState) {
            return true;
        }
        QEventLoop loop;
        QTimer::singleShot(kConnect_ms, &loop, &QEventLoop::quit);
        QObject::connect(&m_client, &QModbusDevice::stateChanged, &loop, [&loop](QModbusDevice::State state) {
            if (state == QModbusDevice::ConnectedState || state == QModbusDevice::UnconnectedState) {
                loop.quit();
            }
        });
        if (!m_client.connectDevice()) {
            return false;
        }
        loop.exec();
        return m_client.state() == QModbusDevice::ConnectedState;
    }
    Answer read(int unit, int function, int address, int count, std::vector<std::uint16_t>& registers) {
        const QModbusDataUnit question(
            function == 3 ? QModbusDataUnit::HoldingRegisters : QModbusDataUnit::InputRegisters, address,
            static_cast<quint16>(count));
        const auto reply = finished(connectNow() ? m_client.sendReadRequest(question, unit) : nullptr);
        if (!reply || (reply->error() != QModbusDevice::NoError && reply->error() != QModbusDevice::ProtocolError)) {
            return Answer::Silence;
        }
        if (reply->error() == QModbusDevice::ProtocolError) {
            const auto code = QModbusExceptionResponse(reply->rawResult()).exceptionCode();
            const bool nobody =
                code == QModbusPdu::GatewayPathUnavailable || code == QModbusPdu::GatewayTargetDeviceFailedToRespond;
            return nobody ? Answer::Silence : Answer::Refusal;
        }
        const QList<quint16> values = reply->result().values();
        registers.assign(values.begin(), values.end());
        return Answer::Values;
    }
    /// Basic device identification: vendor, product, revision.
    std::string identity(int unit) {
        const QModbusRequest question(QModbusRequest::EncapsulatedInterfaceTransport, QByteArray::fromHex("0e0100"));
        const auto reply = finished(connectNow() ? m_client.sendRawRequest(question, unit) : nullptr);
        // Qt calls every answer to a raw question invalid, and hands it over.
        const bool answered = reply && (reply->error() == QModbusDevice::NoError ||
                                        reply->error() == QModbusDevice::InvalidResponseError);
        const QModbusResponse answer = answered ? reply->rawResult() : QModbusResponse();
        if (!answer.isValid() || answer.functionCode() != QModbusRequest::EncapsulatedInterfaceTransport ||
            !answer.data().startsWith('\x0E')) {
            return {};
        }
        const QByteArray data = answer.data();
        std::string text;
        for (qsizetype at = 6;
             at + 2 <= data.size();) {  // MEI type, code, level, more, next, count; then id, length, text
            const qsizetype length = static_cast<quint8>(data[at + 1]);
            const QByteArray part = data.mid(at + 2, length);
            if (!text.empty()) {
                text += ' ';
            }
            for (const char c : part) {  // ASCII by the standard; what is not would be no JSON
                text += c >= ' ' && c <= '~' ? c : '?';
            }
            at += 2 + length;
        }
        return text;
    }

 private:
    static std::unique_ptr<QModbusReply> finished(QModbusReply* reply) {
        std::unique_ptr<QModbusReply> owned(reply);
        if (reply != nullptr && !reply->isFinished()) {
            QEventLoop loop;
            QObject::connect(reply, &QModbusReply::finished, &loop, &QEventLoop::quit);
            loop.exec();
        }
        return owned;
    }

    QModbusTcpClient m_client;
};

}  // namespace

Result<std::vector<ScannedUnit>> scanModbus(const ScanOptions& options) {
    Scanner scanner(options);
    if (!scanner.connectNow()) {
        return fail(kNoConnection);
    }
    std::vector<ScannedUnit> found;
    for (int unit = options.firstUnit; unit <= options.lastUnit; ++unit) {
        ScannedUnit seen;
        seen.unit = unit;
        std::vector<std::uint16_t> registers;
        bool silent = false;
        for (const int function : {4, 3}) {
            for (int address = 0; address < kLookAt && !silent; address += kBlock) {
                const Answer answer = scanner.read(unit, function, address, kBlock, registers);
                silent = answer == Answer::Silence;
                if (answer == Answer::Values) {
                    seen.blocks.push_back({function, address, registers});
                    continue;
                }
                // A module with fewer registers than a block refuses the whole of it: one by one then.
                for (int one = address; answer == Answer::Refusal && one < address + kBlock; ++one) {
                    if (scanner.read(unit, function, one, 1, registers) != Answer::Values) {
                        break;
                    }
                    seen.blocks.push_back({function, one, registers});
                }
                break;
            }
        }
        if (silent && seen.blocks.empty()) {
            continue;
        }
        seen.identity = scanner.identity(unit);
        found.push_back(std::move(seen));
    }
    return found;
}

}  // namespace kerf::sensors
