// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/thermal/thermal_records.h"

#include <chrono>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "app/service/setup_keys.h"

namespace kerf::thermal_records {
namespace {

using nlohmann::json;
using PerAxis = std::array<double, kAxisCount>;

/// Runs `read` on the parsed text; anything missing or of another type gives nothing.
template <class Read>
auto reading(const std::string& text, Read read) -> decltype(read(json{})) {
    const json body = json::parse(text, nullptr, false);
    if (body.is_discarded()) {
        return {};
    }
    try {
        return read(body);
    } catch (const json::exception&) {
        return {};
    }
}

}  // namespace

std::string shiftsToJson(const std::vector<ThermalShiftRow>& rows) {
    json list = json::array();
    for (const ThermalShiftRow& row : rows) {
        list.push_back(
            {{"utc_ms", row.utc_ms}, {"t_min", row.minutes}, {"shift_um", row.shift_um}, {"drift_um", row.drift_um}});
    }
    return json{{"shifts", list}}.dump();
}

std::vector<ThermalShiftRow> shiftsFromJson(const std::string& text) {
    return reading(text, [](const json& body) {
        std::vector<ThermalShiftRow> rows;
        for (const json& one : body.at("shifts")) {
            rows.push_back({one.at("utc_ms").get<std::int64_t>(), one.at("t_min").get<double>(),
                            one.at("shift_um").get<PerAxis>(), one.at("drift_um").get<PerAxis>()});
        }
        return rows;
    });
}

std::string gapToJson(const ThermalGapRow& row) {
    return json{{"utc_ms", row.utc_ms},
                {"measured_um", row.measured_um},
                {"predicted_um", row.predicted_um},
                {"half_um", row.half_um},
                {"prediction_known", row.predictionKnown},
                {"by_part", row.byPart},
                {"known", row.known},
                {"left_um", row.left_um},
                {"left_known", row.leftKnown},
                {"allowed_um", row.allowed_um}}
        .dump();
}

std::optional<ThermalGapRow> gapFromJson(const std::string& text) {
    return reading(text, [](const json& body) {
        ThermalGapRow row{body.at("utc_ms").get<std::int64_t>(), body.at("measured_um").get<PerAxis>(),
                          body.at("predicted_um").get<PerAxis>(), body.at("half_um").get<PerAxis>(),
                          body.at("prediction_known").get<bool>()};
        row.byPart = body.value("by_part", false);
        row.known = body.value("known", row.known);
        row.left_um = body.value("left_um", row.left_um);
        row.leftKnown = body.value("left_known", false);
        row.allowed_um = body.value("allowed_um", 0.0);
        return std::optional(row);
    });
}

std::string zeroToJson(const PerAxis& zero_um) {
    return json{{"zero_um", zero_um}}.dump();
}

std::optional<PerAxis> zeroFromJson(const std::string& text) {
    return reading(text, [](const json& body) { return std::optional(body.at("zero_um").get<PerAxis>()); });
}

std::string setupToJson(const ThermalSetup& setup) {
    return json{{"revision", setup.revision},
                {"period_min", setup.period_min},
                {"allowed_um", setup.allowed_um},
                {"max_shift_um", setup.maxShift_um},
                {"max_step_um_per_min", setup.maxStep_umPerMin},
                {"warm_up_speed_rpm", setup.warmUpSpeed_rpm},
                {"warm_up_min", setup.warmUp_min},
                {"between_parts", setup.betweenParts}}
        .dump();
}

std::optional<ThermalSetup> setupFromJson(const std::string& text) {
    return reading(text, [](const json& body) {
        const auto number = [&](const char* key, double fallback) {
            return numberOr(body, key, fallback, "thermal setup");
        };
        ThermalSetup setup;
        setup.revision = body.value("revision", std::uint32_t{1});
        setup.period_min = number("period_min", setup.period_min);
        setup.allowed_um = number("allowed_um", setup.allowed_um);
        setup.maxShift_um = number("max_shift_um", setup.maxShift_um);
        setup.maxStep_umPerMin = number("max_step_um_per_min", setup.maxStep_umPerMin);
        setup.warmUpSpeed_rpm = number("warm_up_speed_rpm", setup.warmUpSpeed_rpm);
        setup.warmUp_min = number("warm_up_min", setup.warmUp_min);
        setup.betweenParts = body.value("between_parts", false);
        return std::optional(setup);
    });
}

std::string learntToJson(const Learnt& learnt) {
    const thermal::DayMeasurement& m = learnt.measurement;
    return json{{"utc_ms", learnt.utc_ms},
                {"fingerprint", std::to_string(learnt.fingerprint)},
                {"t_min", m.at.time_min},
                {"reference", m.at.reference},
                {"mean_um", m.at.mean_um},
                {"spread", m.at.spread},
                {"term", m.at.term},
                {"drift_um", m.drift_um},
                {"known", m.known},
                {"noise_um", m.noise_um},
                {"doubted_um", m.at.doubted_um}}
        .dump();
}

std::optional<Learnt> learntFromJson(const std::string& text) {
    return reading(text, [](const json& body) {
        Learnt out;
        out.utc_ms = body.at("utc_ms").get<std::int64_t>();
        out.fingerprint = std::strtoull(body.at("fingerprint").get<std::string>().c_str(), nullptr, 10);
        thermal::DayMeasurement& m = out.measurement;
        m.at.time_min = body.at("t_min").get<double>();
        m.at.reference = body.at("reference").get<std::uint32_t>();
        m.at.mean_um = body.at("mean_um").get<PerAxis>();
        m.at.spread = body.at("spread").get<PerAxis>();
        m.at.term = body.at("term").get<std::array<double, thermal::kMaxLayerTerms>>();
        m.drift_um = body.at("drift_um").get<PerAxis>();
        m.known = body.at("known").get<std::array<bool, kAxisCount>>();
        m.noise_um = body.value("noise_um", 0.0);
        m.at.doubted_um = body.value("doubted_um", PerAxis{});
        return std::optional(out);
    });
}

std::string sessionToJson(const thermal::ThermalHistory& day) {
    json temps = json::array();
    json drifts = json::array();
    for (Eigen::Index row = 0; row < day.rows(); ++row) {
        json one = json::array();
        for (const double temp_degC : day.temp_degC.row(row)) {
            one.push_back(temp_degC);
        }
        temps.push_back(std::move(one));
        drifts.push_back({day.drift_um(row, 0), day.drift_um(row, 1), day.drift_um(row, 2)});
    }
    return json{{"label", day.label},         {"sensors", day.sensors}, {"t_min", day.time_min},
                {"speed_rpm", day.speed_rpm}, {"temp_degC", temps},     {"drift_um", drifts}}
        .dump();
}

std::optional<thermal::ThermalHistory> sessionFromJson(const std::string& text) {
    return reading(text, [](const json& body) -> std::optional<thermal::ThermalHistory> {
        thermal::ThermalHistory day;
        day.label = body.at("label").get<std::string>();
        day.sensors = body.at("sensors").get<std::vector<std::string>>();
        day.time_min = body.at("t_min").get<std::vector<double>>();
        day.speed_rpm = body.at("speed_rpm").get<std::vector<double>>();
        const auto temps = body.at("temp_degC").get<std::vector<std::vector<double>>>();
        const auto drifts = body.at("drift_um").get<std::vector<PerAxis>>();
        const std::size_t rows = day.time_min.size();
        const std::size_t sensors = day.sensors.size();
        if (temps.size() != rows || drifts.size() != rows || day.speed_rpm.size() != rows) {
            return std::nullopt;
        }
        day.temp_degC.resize(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(sensors));
        day.present = thermal::PresentMask::Constant(day.temp_degC.rows(), day.temp_degC.cols(), true);
        day.drift_um.resize(static_cast<Eigen::Index>(rows), 3);
        for (std::size_t row = 0; row < rows; ++row) {
            if (temps[row].size() != sensors) {
                return std::nullopt;
            }
            for (std::size_t k = 0; k < sensors; ++k) {
                day.temp_degC(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(k)) = temps[row][k];
            }
            day.drift_um.row(static_cast<Eigen::Index>(row)) =
                Eigen::RowVector3d(drifts[row][0], drifts[row][1], drifts[row][2]);
        }
        return day;
    });
}

std::int64_t utcNow_ms() {
    using namespace std::chrono;
    return duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count();
}

}  // namespace kerf::thermal_records
