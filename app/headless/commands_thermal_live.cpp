// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <vector>

#include "app/files/thermal_files.h"
#include "app/headless/sensor_reading.h"
#include "app/headless/thermal_commands.h"
#include "engine/process/thermal/thermal_estimator.h"

namespace kerf::headless {
namespace {

using namespace thermal;

constexpr int kMostBaseline = 5;
constexpr double kFirstAnswer_s = 5.0;  ///< a module that has not answered by then is not waited for
constexpr double kEvery_s = 1.0;

/// Channel of each of the model's sensors; a sensor without one is taken as open.
std::vector<std::optional<std::size_t>> channelsFor(const ThermalModel& model, const sensors::SensorFile& file,
                                                    const std::string& path) {
    std::vector<std::optional<std::size_t>> channels;
    std::vector<std::string> missing;
    for (const ModelSensor& sensor : model.sensors) {
        const auto found = std::ranges::find_if(file.channels, [&](const sensors::Channel& channel) {
            return channel.name == sensor.name && channel.quantity == sensors::Quantity::Temperature;
        });
        const bool there = found != file.channels.end();
        channels.push_back(there ? std::optional(static_cast<std::size_t>(found - file.channels.begin()))
                                 : std::nullopt);
        if (!there) {
            missing.push_back(sensor.name);
        }
    }
    if (missing.size() > static_cast<std::size_t>(ThermalEstimator::kMaxLost)) {
        throw BadInput(fmt::format("{}: channels {} of the model are missing; expected all but two at most.", path,
                                   fmt::join(missing, ",")));
    }
    if (!missing.empty()) {
        fmt::print(stderr, "kerf: {}: no channel {}; taken as open thermocouples.\n", path, fmt::join(missing, ","));
    }
    return channels;
}

class LiveReadings {
 public:
    LiveReadings(const ThermalModel& model, const std::string& path)
        : m_file(sensorFile(path)),
          m_channels(channelsFor(model, m_file, path)),
          m_session(sensorSession(path)),
          m_readings(m_channels.size()) {
        if (const auto speeds = sensors::channelsOf(m_file, sensors::Quantity::Speed); !speeds.empty()) {
            m_speed = speeds.front();
        }
    }
    /// Every channel has been asked once, or is not waited for any more.
    void waitForAll() {
        const std::int64_t start_ns = steady_ns();
        const auto asked = [this] {
            return m_alive && std::ranges::none_of(m_channels, [this](const auto& channel) {
                       return channel && m_frame.channel[*channel].cause == sensors::Cause::NotYetRead;
                   });
        };
        do {
            look();
        } while (!asked() && static_cast<double>(steady_ns() - start_ns) * 1e-9 < kFirstAnswer_s);
    }
    void lookUntil(std::int64_t time_ns) {
        do {
            look();
        } while (steady_ns() < time_ns);
        for (std::size_t i = 0; i < m_channels.size(); ++i) {
            m_readings[i] = reading(m_channels[i]);
        }
    }
    [[nodiscard]] const std::vector<Reading>& readings() const { return m_readings; }
    [[nodiscard]] std::optional<double> speed_rpm() const {
        const Reading speed = reading(m_speed);
        return speed.good() ? std::optional(speed.value) : std::nullopt;
    }
    [[nodiscard]] bool any() const {
        return std::ranges::any_of(m_readings, [](const Reading& reading) { return reading.good(); });
    }

 private:
    void look() {
        pause_ms(20);
        m_session->keep();
        m_alive = m_session->latest(m_frame);
    }
    [[nodiscard]] Reading reading(std::optional<std::size_t> channel) const {
        if (!channel || !m_alive || *channel >= m_frame.count) {
            return {};
        }
        const sensors::ChannelValue& value = m_frame.channel[*channel];
        return {value.value, value.stamp_ns, value.quality};
    }

    sensors::SensorFile m_file;
    std::vector<std::optional<std::size_t>> m_channels;
    std::unique_ptr<sensors::SensorSession> m_session;
    std::vector<Reading> m_readings;
    std::optional<std::size_t> m_speed{};
    sensors::SensorFrame m_frame{};
    bool m_alive{false};
};

}  // namespace

void predictLive(const std::string& modelPath, const std::string& sensorPath, double seconds) {
    const ThermalModel model = readThermalModel(modelPath);
    LiveReadings live(model, sensorPath);
    live.waitForAll();
    const std::int64_t start_ns = steady_ns();
    const auto at = [start_ns](double time_s) { return start_ns + static_cast<std::int64_t>(time_s * 1e9); };
    // The temperatures everything is counted from: at most five readings, at most half of the time.
    const int baseline = std::clamp(static_cast<int>(seconds / 2.0 / kEvery_s), 1, kMostBaseline);
    ThermalEstimator estimator(model);
    bool read = false;
    for (int k = 0; k < baseline; ++k) {
        live.lookUntil(at(k * kEvery_s));
        read = read || live.any();
        estimator.baseline((k - baseline) * kEvery_s / 60.0, live.readings());
    }
    if (!read) {
        throw BadInput(fmt::format("{}: no sensor of the model reads; `kerf sensors watch` says why.", sensorPath));
    }
    fmt::print("t_min,x_um,y_um,z_um,x_half_um,y_half_um,z_half_um\n");
    std::fflush(stdout);
    // What is between two of the model's periods is looked at with a copy: the sensors' health counts readings one
    // period apart, as in training.
    double kept_min = -model.period_min;
    PerAxis held_um{};
    PerAxis half_um{};
    bool told = false;
    for (double time_s = 0.0; baseline * kEvery_s + time_s <= seconds + 1e-9; time_s += kEvery_s) {
        live.lookUntil(at(baseline * kEvery_s + time_s));
        const double time_min = time_s / 60.0;
        ThermalEstimator now = estimator;
        const ThermalPrediction p = now.update(time_min, live.speed_rpm(), live.readings());
        if (time_min - kept_min >= model.period_min - 1e-9) {
            estimator = now;
            kept_min = time_min;
        }
        if (p.usable) {
            held_um = p.drift_um;
            half_um = p.half_um;
        } else if (!told) {
            fmt::print(stderr, "kerf: more than two sensors lost from minute {:.3g}: the last prediction is held.\n",
                       time_min);
        }
        told = !p.usable;
        fmt::print("{:.17g}", time_min);
        for (const PerAxis* three : {&held_um, &half_um}) {
            for (std::size_t axis = 0; axis < kAxes; ++axis) {
                fmt::print("{}", model.axes[axis] ? fmt::format(",{:.17g}", (*three)[axis]) : ",");
            }
        }
        fmt::print("\n");
        std::fflush(stdout);
    }
}

}  // namespace kerf::headless
