// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sensors/modbus_line.h"

#include <QModbusReply>
#include <QModbusRtuSerialClient>
#include <QModbusTcpClient>
#include <QSerialPort>
#include <QVariant>
#include <algorithm>

#include "app/sensors/monotonic.h"

namespace kerf::sensors {
namespace {

QModbusDataUnit::RegisterType kindOf(int function) {
    switch (function) {
        case 1:
            return QModbusDataUnit::Coils;
        case 2:
            return QModbusDataUnit::DiscreteInputs;
        case 3:
            return QModbusDataUnit::HoldingRegisters;
        default:
            return QModbusDataUnit::InputRegisters;
    }
}

QSerialPort::Parity parityOf(Parity parity) {
    switch (parity) {
        case Parity::Even:
            return QSerialPort::EvenParity;
        case Parity::Odd:
            return QSerialPort::OddParity;
        case Parity::None:
            break;
    }
    return QSerialPort::NoParity;
}

bool saysNoSuchRegister(const QModbusPdu& pdu) {
    switch (QModbusExceptionResponse(pdu).exceptionCode()) {
        case QModbusPdu::IllegalFunction:
        case QModbusPdu::IllegalDataAddress:
        case QModbusPdu::IllegalDataValue:
            return true;
        default:
            return false;
    }
}

}  // namespace

ModbusLine::ModbusLine(const SensorFile& file, const std::vector<std::size_t>& modules,
                       std::vector<ChannelJudge>& judges, QObject* parent)
    : QObject(parent), m_file(file), m_judges(judges) {
    for (const std::size_t module : modules) {
        Unit unit;
        unit.module = module;
        plan(unit, false);
        m_units.push_back(std::move(unit));
    }
    m_next.setSingleShot(true);
    m_next.setTimerType(Qt::PreciseTimer);
    m_patience.setSingleShot(true);
    connect(&m_next, &QTimer::timeout, this, &ModbusLine::next);
    connect(&m_patience, &QTimer::timeout, this, [this] {
        dropClient();
        m_next.start(kReconnect_ms);
    });
}

ModbusLine::~ModbusLine() {
    dropClient();
}

void ModbusLine::plan(Unit& unit, bool apart) const {
    unit.plan = planFor(m_file, unit.module, apart);
    unit.apart = apart;
    unit.answers.assign(unit.plan.blocks.size(), {});
    unit.refused.assign(unit.plan.blocks.size(), false);
}

void ModbusLine::start() {
    m_next.start(0);
}

void ModbusLine::makeClient() {
    const Module& first = m_file.modules[m_units.front().module];
    if (first.transport == Transport::Tcp) {
        m_client = std::make_unique<QModbusTcpClient>();
        m_client->setConnectionParameter(QModbusDevice::NetworkAddressParameter, QString::fromStdString(first.host));
        m_client->setConnectionParameter(QModbusDevice::NetworkPortParameter, first.port);
    } else {
        m_client = std::make_unique<QModbusRtuSerialClient>();
        m_client->setConnectionParameter(QModbusDevice::SerialPortNameParameter, QString::fromStdString(first.device));
        m_client->setConnectionParameter(QModbusDevice::SerialBaudRateParameter, first.baud);
        m_client->setConnectionParameter(QModbusDevice::SerialParityParameter, parityOf(first.parity));
        m_client->setConnectionParameter(QModbusDevice::SerialDataBitsParameter, QSerialPort::Data8);
        m_client->setConnectionParameter(QModbusDevice::SerialStopBitsParameter, first.stopBits);
    }
    m_client->setNumberOfRetries(0);
    connect(m_client.get(), &QModbusDevice::stateChanged, this, &ModbusLine::stateChanged);
}

/// From inside a signal of the client too: it goes when the event loop comes round.
void ModbusLine::dropClient() {
    m_patience.stop();
    if (m_reply) {
        m_reply->disconnect(this);
        m_reply.release()->deleteLater();
    }
    if (m_client) {
        m_client->disconnect(this);
        m_client.release()->deleteLater();
    }
    m_inRound = false;
    m_silent = 0;
}

void ModbusLine::connectNow() {
    if (!m_client) {
        makeClient();
    }
    m_patience.start(kConnect_ms);
    if (!m_client->connectDevice()) {
        dropClient();
        m_next.start(kReconnect_ms);
    }
}

void ModbusLine::stateChanged(QModbusDevice::State state) {
    if (state == QModbusDevice::ConnectedState) {
        m_patience.stop();
        ++m_counts.connected;
        for (Unit& unit : m_units) {  // perhaps another module than before
            if (unit.apart) {
                plan(unit, false);
            }
        }
        m_next.start(0);
    } else if (state == QModbusDevice::UnconnectedState) {
        dropClient();
        m_next.start(kReconnect_ms);
    }
}

void ModbusLine::next() {
    if (!m_client || m_client->state() == QModbusDevice::UnconnectedState) {
        connectNow();
        return;
    }
    if (m_client->state() != QModbusDevice::ConnectedState || m_inRound) {
        return;
    }
    const std::int64_t now_ns = monotonic_ns();
    const auto readyAt = [](const Unit& unit) { return std::max(unit.due_ns, unit.quietUntil_ns); };
    const auto unit = std::ranges::min_element(m_units, {}, readyAt);
    if (const std::int64_t wait_ns = readyAt(*unit) - now_ns; wait_ns > 0) {
        m_next.start(static_cast<int>(wait_ns / kMillisecond_ns) + 1);
        return;
    }
    // Missed rounds are not made up for.
    const std::int64_t period_ns = m_file.modules[unit->module].period_ms * kMillisecond_ns;
    unit->due_ns = std::max(unit->due_ns + period_ns, now_ns + period_ns / 2);
    m_unit = static_cast<std::size_t>(unit - m_units.begin());
    m_block = 0;
    m_inRound = true;
    std::fill(unit->refused.begin(), unit->refused.end(), false);
    if (unit->plan.blocks.empty()) {
        endRound();
    } else {
        ask();
    }
}

void ModbusLine::ask() {
    const Unit& unit = m_units[m_unit];
    const Module& module = m_file.modules[unit.module];
    const Block& block = unit.plan.blocks[m_block];
    m_client->setTimeout(module.timeout_ms);
    // A client whose adapter was pulled out waits for ever for its question to be written.
    m_patience.start(module.timeout_ms + kUnwritten_ms);
    const QModbusDataUnit question(kindOf(block.function), block.address, static_cast<quint16>(block.count));
    ++m_counts.asked;
    m_reply.reset(m_client->sendReadRequest(question, module.unit));
    if (!m_reply) {  // the connection has just gone
        dropClient();
        m_next.start(kReconnect_ms);
        return;
    }
    QModbusReply* reply = m_reply.get();
    connect(reply, &QModbusReply::finished, this, [this, reply] {
        if (reply == m_reply.get()) {
            m_reply.release()->deleteLater();
            answered(*reply);
        }
    });
}

void ModbusLine::answered(QModbusReply& reply) {
    m_patience.stop();
    Unit& unit = m_units[m_unit];
    const Block& block = unit.plan.blocks[m_block];
    // Bits come in whole bytes, registers exactly as asked for.
    const auto come = reply.error() == QModbusDevice::NoError ? static_cast<int>(reply.result().valueCount()) : 0;
    const bool whole = block.function <= 2 ? come >= block.count : come == block.count;
    const bool excuse = reply.error() == QModbusDevice::ProtocolError;
    const bool refused = excuse && saysNoSuchRegister(reply.rawResult());
    if (excuse && !refused) {  // busy, or a gateway whose module does not answer: this round brings nothing
        m_silent = 0;
        endRound();
        return;
    }
    if (!whole && !refused) {
        ++m_counts.timedOut;
        silent();
        return;
    }
    ++m_counts.answered;
    m_silent = 0;
    if (refused && !unit.apart && unit.plan.channels.size() > 1) {
        plan(unit, true);  // what it has of them is still worth reading
        unit.due_ns = 0;
        endRound();
        return;
    }
    unit.refused[m_block] = refused;
    const QList<quint16> values = whole ? reply.result().values() : QList<quint16>(block.count);
    unit.answers[m_block].assign(values.begin(), values.end());
    if (++m_block < unit.plan.blocks.size()) {
        ask();
    } else {
        finishRound();
        endRound();
    }
}

void ModbusLine::finishRound() {
    const Unit& unit = m_units[m_unit];
    const std::int64_t now_ns = monotonic_ns();
    for (const PlannedChannel& planned : unit.plan.channels) {
        ChannelJudge& judge = m_judges[planned.channel];
        const bool refused =
            unit.refused[planned.value.block] || (planned.hasStatus && unit.refused[planned.status.block]);
        if (refused) {
            judge.refuse(Cause::Refused, now_ns);
            continue;
        }
        const Channel& channel = m_file.channels[planned.channel];
        const std::span<const std::uint16_t> registers(unit.answers[planned.value.block].data() + planned.value.offset,
                                                       static_cast<std::size_t>(registersOf(channel.type)));
        std::optional<std::uint16_t> status;
        if (planned.hasStatus) {
            status = unit.answers[planned.status.block][planned.status.offset];
        }
        judge.take(registers, status, now_ns);
    }
}

void ModbusLine::endRound() {
    m_inRound = false;
    m_next.start(0);
}

void ModbusLine::silent() {
    Unit& unit = m_units[m_unit];
    const bool rtu = m_file.modules[unit.module].transport == Transport::Rtu;
    if (rtu) {
        unit.quietUntil_ns = monotonic_ns() + kLateAnswer_ms * kMillisecond_ns;
    }
    // One of several units that is off does not end the line for the others, but noise left in it must go.
    if (++m_silent >= kSilentRounds) {
        dropClient();
        m_next.start(rtu ? 0 : kReconnect_ms);
        return;
    }
    endRound();
}

}  // namespace kerf::sensors
