// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sensors/gauge_line.h"

#include <QFile>
#include <algorithm>

#include "app/sensors/gauge_frames.h"
#include "app/sensors/monotonic.h"

namespace kerf::sensors {
namespace {

constexpr qsizetype kLongestLine = 256;

template <std::size_t Size>
void copyText(std::array<char, Size>& to, const std::string& from) {
    to.fill('\0');
    std::copy_n(from.begin(), std::min(from.size(), Size - 1), to.begin());
}

}  // namespace

GaugeLine::GaugeLine(const Gauge& gauge, std::uint32_t index, std::function<void(const GaugeEvent&)> take,
                     QObject* parent)
    : QObject(parent), m_gauge(gauge), m_index(index), m_take(std::move(take)) {
    m_port.setPortName(QString::fromStdString(gauge.device));
    m_port.setBaudRate(gauge.baud);
    m_port.setParity(gauge.parity == Parity::Even  ? QSerialPort::EvenParity
                     : gauge.parity == Parity::Odd ? QSerialPort::OddParity
                                                   : QSerialPort::NoParity);
    connect(&m_port, &QSerialPort::readyRead, this, &GaugeLine::read);
    connect(&m_port, &QSerialPort::errorOccurred, this, [this](QSerialPort::SerialPortError error) {
        if (error == QSerialPort::ResourceError && m_port.isOpen()) {  // pulled out
            m_port.close();
        }
    });
    m_again.setInterval(kLookAgain_ms);
    connect(&m_again, &QTimer::timeout, this, &GaugeLine::look);
    m_again.start();
}

void GaugeLine::look() {
    if (m_port.isOpen()) {
        if (!QFile::exists(QString::fromStdString(m_gauge.device))) {
            m_port.close();
        }
        return;
    }
    m_text.clear();
    m_noise = false;
    (void)m_port.open(QIODevice::ReadWrite);
}

bool GaugeLine::ask() {
    return m_port.isOpen() && !m_gauge.ask.empty() && m_port.write((m_gauge.ask + '\r').c_str()) > 0;
}

void GaugeLine::read() {
    m_text += m_port.readAll();
    const auto isEnd = [](char c) { return c == '\r' || c == '\n'; };
    for (auto end = std::ranges::find_if(m_text, isEnd); end != m_text.end();
         end = std::ranges::find_if(m_text, isEnd)) {
        const qsizetype length = end - m_text.begin();
        if (!m_noise) {
            take(m_text.left(length));
        }
        m_noise = false;
        m_text.remove(0, length + 1);
    }
    if (m_text.size() > kLongestLine) {  // a line without an end is noise, and so is what ends it
        m_text.clear();
        m_noise = true;
    }
}

void GaugeLine::take(const QByteArray& line) {
    if (line.trimmed().isEmpty()) {
        return;  // between CR and LF
    }
    GaugeEvent event;
    event.gauge = m_index;
    event.stamp_ns = monotonic_ns();
    const std::string text = line.trimmed().toStdString();
    copyText(event.frame, text);
    if (const auto frame = parseGaugeFrame(m_gauge, text)) {
        event.understood = true;
        event.value = frame->value;
        event.inch = frame->inch;
        copyText(event.channel, frame->channel);
    }
    m_take(event);
}

}  // namespace kerf::sensors
