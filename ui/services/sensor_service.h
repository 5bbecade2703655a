// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/reading.h"
#include "engine/core/result.h"

/// Sensors and gauges of a machine for its setup: what is found, what it reads, where it sits. Plain values.
namespace kerf {

struct SensorChannelView {
    std::string name{};
    std::string module{};
    std::string place{};            ///< as the sensor file says it
    const char* unit{"degC"};       ///< stored unit
    std::optional<double> value{};  ///< empty: not good
    Quality quality{Quality::Missing};
    std::optional<double> age_s{};  ///< of the last good reading
    const char* why{""};            ///< KERF_TEXT: why it is not good
    bool placed{false};             ///< on the picture
    double x{0.0};                  ///< 0…1, left to right
    double y{0.0};                  ///< 0…1, top to bottom
};

struct SensorModuleView {
    std::string name{};
    std::string address{};  ///< as a person would say it: "tcp 192.168.0.11:502, 1"
    int channels{0};
    int good{0};
};

struct SensorGaugeView {
    std::string name{};
    std::string device{};
    bool connected{false};
    bool canAsk{false};
    bool saysDepth{false};  ///< the sensor file says which depth its readings are of
    std::string frame{};    ///< last one that came
    bool understood{true};  ///< it is a reading
};

/// "Which one rises?": a finger on a thermocouple shows its channel.
struct FingerView {
    bool looking{false};
    std::optional<std::size_t> channel{};  ///< found
    double rise_K{0.0};
};

struct SensorServiceView {
    std::uint64_t revision{0};
    bool reading{false};  ///< the reading process is alive
    int restarts{0};
    std::vector<SensorModuleView> modules{};
    std::vector<SensorChannelView> channels{};
    std::vector<SensorGaugeView> gauges{};
    FingerView finger{};
    std::string picture{};        ///< PNG of one's own machine; empty: none
    std::string pictureFolder{};  ///< where one is looked for
    Sentence problem{};
};

class SensorService {
 public:
    SensorService() = default;
    SensorService(const SensorService&) = delete;
    SensorService& operator=(const SensorService&) = delete;
    virtual ~SensorService() = default;

    [[nodiscard]] virtual const SensorServiceView& view() const = 0;
    virtual void lookForFinger(bool on) = 0;
    /// Asks a gauge for a reading. A test read is shown and goes no further; the other is entered like one that the
    /// gauge's own key has sent.
    virtual void askGauge(std::size_t gauge, bool test) = 0;
    /// Where channel sits on the picture; stored.
    [[nodiscard]] virtual Result<void> place(std::size_t channel, double x, double y, const std::string& author) = 0;
};

}  // namespace kerf
