// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/sensor_service.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/sensors/cause_text.h"
#include "app/sensors/monotonic.h"

namespace kerf::console {
namespace {

using nlohmann::json;

constexpr std::int64_t kTestRead_ns = 3'000'000'000;  ///< a gauge that has not answered by then does not
constexpr std::size_t kMostReadings = 64;
constexpr const char* kPlaces = "sensor-places";

std::string addressOf(const sensors::Module& module) {
    switch (module.transport) {
        case sensors::Transport::Rtu:
            return fmt::format("rtu {}, {}", module.device, module.unit);
        case sensors::Transport::Hal:
            return "HAL";
        case sensors::Transport::Tcp:
            break;
    }
    return fmt::format("tcp {}:{}, {}", module.host, module.port, module.unit);
}

}  // namespace

StoredSensorService::StoredSensorService(ConsoleSensors& sensors, StoreWriter& writer, RoomRecordReader& reader,
                                         std::string folder, Rights rights)
    : m_sensors(sensors), m_writer(writer), m_rights(std::move(rights)) {
    m_view.pictureFolder = std::move(folder);
    for (const sensors::Module& module : sensors.file().modules) {
        m_view.modules.push_back({module.name, addressOf(module), 0, 0});
    }
    for (const sensors::Channel& channel : sensors.file().channels) {
        SensorChannelView view;
        view.name = channel.name;
        view.module = sensors.file().modules[channel.module].name;
        view.place = channel.place;
        view.unit = channel.quantity == sensors::Quantity::Speed ? "rpm" : "degC";
        m_view.channels.push_back(std::move(view));
        ++m_view.modules[channel.module].channels;
    }
    for (const sensors::Gauge& gauge : sensors.file().gauges) {
        m_view.gauges.push_back({gauge.name, gauge.device, false, !gauge.ask.empty(), !gauge.depths.empty()});
    }
    m_testUntil_ns.resize(m_view.gauges.size());
    const auto rows = reader.roomRecords(ProcessId::Thermal, kPlaces, {}, 1);
    const json places = rows && !rows->empty() ? json::parse(rows->front().bodyJson, nullptr, false) : json::object();
    for (SensorChannelView& channel : m_view.channels) {
        const auto at = places.is_object() ? places.find(channel.name) : places.end();
        if (places.is_object() && at != places.end() && at->is_array() && at->size() == 2 && (*at)[0].is_number() &&
            (*at)[1].is_number()) {
            channel.placed = true;
            channel.x = std::clamp((*at)[0].get<double>(), 0.0, 1.0);
            channel.y = std::clamp((*at)[1].get<double>(), 0.0, 1.0);
        }
    }
    findPicture();
}

void StoredSensorService::findPicture() {
    std::error_code unreadable;
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(m_view.pictureFolder, unreadable)) {
        if (entry.path().extension() == ".png") {
            files.push_back(entry.path().string());
        }
    }
    std::ranges::sort(files);
    m_view.picture = files.empty() ? std::string{} : files.front();
}

void StoredSensorService::lookForFinger(bool on) {
    m_view.finger = {};
    m_view.finger.looking = on;
    m_finder.begin();
    ++m_view.revision;
}

void StoredSensorService::askGauge(std::size_t gauge, bool test) {
    if (gauge < m_testUntil_ns.size()) {
        hearGauges();  // what came before is no answer to this
        m_testUntil_ns[gauge] = test ? sensors::monotonic_ns() + kTestRead_ns : 0;
        m_sensors.session().askGauge(gauge);
    }
}

Result<void> StoredSensorService::place(std::size_t channel, double x, double y, const std::string& author) {
    if (auto may = permitted(m_rights, author, Deed::SensorPlace); !may) {
        return may;
    }
    if (channel >= m_view.channels.size() || !(x >= 0.0 && x <= 1.0 && y >= 0.0 && y <= 1.0)) {
        return fail(KERF_TEXT("That is not on the picture."));
    }
    SensorChannelView& placed = m_view.channels[channel];
    placed.placed = true;
    placed.x = x;
    placed.y = y;
    json places = json::object();
    for (const SensorChannelView& one : m_view.channels) {
        if (one.placed) {
            places[one.name] = {one.x, one.y};
        }
    }
    m_writer.submit(AddRoomRecord{ProcessId::Thermal, kPlaces, {}, places.dump(), author, "placed"},
                    [this, alive = std::weak_ptr<bool>(m_alive)](const Result<Receipt>& result) {
                        if (!alive.expired()) {
                            m_view.problem = result ? Sentence{} : result.error();
                            ++m_view.revision;
                        }
                    });
    ++m_view.revision;
    return {};
}

void StoredSensorService::hearGauges() {
    while (auto heard = m_sensors.nextGaugeFrame()) {
        SensorGaugeView& gauge = m_view.gauges[heard->gauge];
        gauge.frame = heard->sent;
        gauge.understood = !heard->frame.empty();
        ++m_view.revision;
        std::int64_t& testUntil_ns = m_testUntil_ns[heard->gauge];
        const bool test = sensors::monotonic_ns() < std::exchange(testUntil_ns, 0);
        if (gauge.understood && !test) {
            m_readings.push_back(std::move(*heard));
        }
    }
    while (m_readings.size() > kMostReadings) {  // no page takes diameters here
        m_readings.pop_front();
    }
}

std::optional<ConsoleSensors::GaugeFrame> StoredSensorService::nextReading() {
    hearGauges();
    if (m_readings.empty()) {
        return std::nullopt;
    }
    const ConsoleSensors::GaugeFrame next = std::move(m_readings.front());
    m_readings.pop_front();
    return next;
}

void StoredSensorService::poll() {
    hearGauges();
    m_view.restarts = m_sensors.session().restarts();
    m_view.reading = m_sensors.session().latest(m_frame);
    takeFrame();
    for (std::size_t i = 0; i < m_view.gauges.size(); ++i) {
        m_view.gauges[i].connected = m_sensors.session().gaugeConnected(i);
    }
    ++m_view.revision;
}

void StoredSensorService::takeFrame() {
    const std::int64_t now_ns = sensors::monotonic_ns();
    for (SensorModuleView& module : m_view.modules) {
        module.good = 0;
    }
    std::vector<std::optional<double>> temps_degC(m_view.channels.size());
    for (std::size_t i = 0; i < m_view.channels.size(); ++i) {
        SensorChannelView& channel = m_view.channels[i];
        const sensors::ChannelValue value = i < m_frame.count ? m_frame.channel[i] : sensors::ChannelValue{};
        channel.quality = m_view.reading || value.stamp_ns == 0 ? value.quality : Quality::Stale;
        channel.value = channel.quality == Quality::Good ? std::optional(value.value) : std::nullopt;
        channel.age_s =
            value.stamp_ns == 0 ? std::nullopt : std::optional(static_cast<double>(now_ns - value.stamp_ns) * 1e-9);
        channel.why = channel.quality == Quality::Good ? ""
                      : m_view.reading                 ? sensors::causeText(value.cause)
                                       : KERF_TEXT("The reading process does not run; it is started again.");
        if (channel.value) {
            ++m_view.modules[m_sensors.file().channels[i].module].good;
            const bool temperature = m_sensors.file().channels[i].quantity == sensors::Quantity::Temperature;
            temps_degC[i] = temperature ? channel.value : std::nullopt;
        }
    }
    if (m_view.finger.looking && !m_view.finger.channel) {
        if (const auto found = m_finder.look(temps_degC)) {
            m_view.finger.channel = found->channel;
            m_view.finger.rise_K = found->rise_K;
        }
    }
}

}  // namespace kerf::console
