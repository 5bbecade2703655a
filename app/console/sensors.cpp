// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/sensors.h"

#include <spdlog/spdlog.h>

#include <QDateTime>
#include <cstdio>

#include "app/sensors/gauge_frames.h"
#include "app/sensors/monotonic.h"

namespace kerf::console {
namespace {

constexpr std::int64_t kFirstRow_ns = 2'000'000'000;  ///< every module has been asked by then
constexpr std::size_t kColumns = 8;                   ///< of a drawing on which nobody has placed them yet

SensorPort::Params portParams(const sensors::SensorFile& file, const sensors::SensorSession& session) {
    SensorPort::Params params;
    params.memoryName = session.memoryName();
    for (const std::size_t channel : sensors::channelsOf(file, sensors::Quantity::Temperature)) {
        params.temperatures.push_back(static_cast<std::uint16_t>(channel));
    }
    for (const std::size_t channel : sensors::channelsOf(file, sensors::Quantity::Speed)) {
        params.speed = static_cast<std::uint16_t>(channel);
    }
    return params;
}

}  // namespace

Result<std::unique_ptr<ConsoleSensors>> ConsoleSensors::open(const std::string& path, MachinePort& machine) {
    sensors::SensorFile file;
    try {
        file = sensors::readSensorFile(path);
    } catch (const sensors::SensorFileFault& fault) {
        spdlog::error("{}", fault.what());
        std::fprintf(stderr, "kerf-console: %s\n", fault.what());
        return fail(KERF_TEXT("The sensor file is refused; `kerf sensors check` says where and why."));
    }
    for (const std::string& warning : file.warnings) {
        spdlog::warn("{}: {}", path, warning);
    }
    auto session = std::make_unique<sensors::SensorSession>(path);
    if (auto started = session->start(); !started) {
        return tl::unexpected(started.error());
    }
    return std::unique_ptr<ConsoleSensors>(new ConsoleSensors(std::move(file), std::move(session), machine));
}

ConsoleSensors::ConsoleSensors(sensors::SensorFile file, std::unique_ptr<sensors::SensorSession> session,
                               MachinePort& machine)
    : m_file(std::move(file)),
      m_session(std::move(session)),
      m_port(std::make_unique<SensorPort>(machine, portParams(m_file, *m_session))) {}

std::optional<ConsoleSensors::GaugeFrame> ConsoleSensors::nextGaugeFrame() {
    sensors::GaugeEvent event;
    while (m_session->nextGauge(event)) {
        if (event.gauge >= m_file.gauges.size()) {
            continue;
        }
        const sensors::Gauge& gauge = m_file.gauges[event.gauge];
        if (!event.understood) {
            spdlog::warn("gauge {}: '{}' is no reading", gauge.name, event.frame.data());
            return GaugeFrame{event.gauge, {}, event.frame.data(), {}};
        }
        return GaugeFrame{event.gauge, sensors::wedgeFrame(gauge, event.channel.data(), event.value, event.inch),
                          event.frame.data(), sensors::depthOf(gauge, event.channel.data())};
    }
    return std::nullopt;
}

void ConsoleSensors::record(const std::string& folder) {
    const QString name = QDateTime::currentDateTime().toString(QStringLiteral("/yyyy-MM-dd_HHmmss.'csv'"));
    m_recorder = std::make_unique<sensors::DayRecorder>(folder + name.toStdString(), m_file);
    m_recordSince_ns = sensors::monotonic_ns() + kFirstRow_ns;
    if (!m_recorder->good()) {
        spdlog::error("{}{}: cannot be written; the day is not recorded", folder, name.toStdString());
        m_recorder.reset();
    }
}

void ConsoleSensors::poll() {
    m_session->keep();
    const std::int64_t since_ns = sensors::monotonic_ns() - m_recordSince_ns;
    if (m_recorder && since_ns >= 0) {
        sensors::SensorFrame frame;
        m_recorder->look(static_cast<double>(since_ns) * 1e-9, m_session->latest(frame) ? &frame : nullptr);
    }
}

std::vector<ThermalSensorView> unplacedSensors(const std::vector<std::string>& names) {
    std::vector<ThermalSensorView> views(names.size());
    for (std::size_t k = 0; k < views.size(); ++k) {
        views[k].name = names[k];
        views[k].x = (static_cast<double>(k % kColumns) + 0.5) / static_cast<double>(kColumns);
        views[k].y = (static_cast<double>(k / kColumns) + 0.5) / static_cast<double>(kColumns);
    }
    return views;
}

std::vector<ThermalSensorView> ConsoleSensors::thermalSensors() const {
    const auto channels = sensors::channelsOf(m_file, sensors::Quantity::Temperature);
    std::vector<std::string> names;
    for (const std::size_t channel : channels) {
        names.push_back(m_file.channels[channel].name);
    }
    std::vector<ThermalSensorView> views = unplacedSensors(names);
    for (std::size_t k = 0; k < views.size(); ++k) {
        views[k].placeText = m_file.channels[channels[k]].place;
    }
    return views;
}

}  // namespace kerf::console
