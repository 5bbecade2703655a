// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/tapping/tapping_tuning_json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/process/tapping/tapping_types.h"

namespace kerf::formats {
namespace {

using Json = nlohmann::ordered_json;
using namespace tapping;

constexpr int kVersion = 1;
constexpr double kTrimDigits = 1e4;   ///< of a µm
constexpr double kCurveDigits = 1e2;  ///< of a µm or a revolution
constexpr double kHighestGain_perS = 5000.0;
constexpr double kHighestTrim_um = 5000.0;

template <class Values>
Json rounded(const Values& values, double scale, double digits) {
    Json out = Json::array();
    for (const auto value : values)
        out.push_back(std::round(static_cast<double>(value) * scale * digits) / digits);
    return out;
}

Json toJson(const TapSettings& settings) {
    return {{"spindle_kp_perS", settings.spindleKp_perS},
            {"z_kp_perS", settings.zKp_perS},
            {"z_velocity_ff", settings.zVelocityFf},
            {"z_accel_ff", settings.zAccelFf},
            {"z_trim_um", rounded(settings.zTrim_mm, 1000.0, kTrimDigits)}};
}
Json toJson(const TapSettingsView& settings) {
    return {{"spindle_kp_perS", settings.spindleKp_perS},
            {"z_kp_perS", settings.zKp_perS},
            {"z_velocity_ff", settings.zVelocityFf},
            {"z_accel_ff", settings.zAccelFf},
            {"trim_peak_um", settings.trimPeak_um}};
}
Json toJson(const TapFigures& figures) {
    return {{"saec_mm", figures.saec_mm}, {"peak_um", figures.peak_um},
            {"rms_um", figures.rms_um},   {"engaged_pp_um", figures.engagedPp_um},
            {"samples", figures.samples}, {"missing", figures.missing}};
}
Json toJson(const TapCurve& curve) {
    return {{"spindle_rev", rounded(curve.spindle_rev, 1.0, kCurveDigits)},
            {"error_um", rounded(curve.error_um, 1.0, kCurveDigits)},
            {"reversal", curve.reversal}};
}

/// Leaves the reader with the sentence; caught in tuningFromJson only.
struct Refused {
    Sentence reason;
};

const Json& field(const Json& parent, const char* key) {
    const auto found = parent.is_object() ? parent.find(key) : parent.end();
    if (found == parent.end())
        throw Refused{Sentence(KERF_TEXT("The stored tuning has no field %1."), SentenceArg(key))};
    return *found;
}
double number(const Json& parent, const char* key, double low, double high) {
    const Json& value = field(parent, key);
    if (!value.is_number() || !(value.get<double>() >= low && value.get<double>() <= high)) {
        throw Refused{Sentence(KERF_TEXT("Field %1 of the stored tuning is out of range."), SentenceArg(key))};
    }
    return value.get<double>();
}
template <class T>
std::vector<T> numbers(const Json& parent, const char* key, double scale, double largest) {
    std::vector<T> out;
    const Json& list = field(parent, key);
    const bool sound = list.is_array() && list.size() <= kMaxTapTicks && std::ranges::all_of(list, [&](const Json& v) {
                           return v.is_number() && std::abs(v.get<double>()) <= largest;
                       });
    if (!sound) throw Refused{Sentence(KERF_TEXT("Field %1 of the stored tuning is out of range."), SentenceArg(key))};
    for (const Json& value : list)
        out.push_back(static_cast<T>(value.get<double>() * scale));
    return out;
}
std::string text(const Json& parent, const char* key) {
    const Json& value = field(parent, key);
    if (!value.is_string()) {
        throw Refused{Sentence(KERF_TEXT("Field %1 of the stored tuning is out of range."), SentenceArg(key))};
    }
    return value.get<std::string>();
}

TapSettings settingsFrom(const Json& json) {
    return {number(json, "spindle_kp_perS", 1e-6, kHighestGain_perS),
            number(json, "z_kp_perS", 1e-6, kHighestGain_perS), number(json, "z_velocity_ff", -10.0, 10.0),
            number(json, "z_accel_ff", -100.0, 100.0), numbers<double>(json, "z_trim_um", 1e-3, kHighestTrim_um)};
}
TapSettingsView settingsViewFrom(const Json& json) {
    return {number(json, "spindle_kp_perS", 0.0, kHighestGain_perS), number(json, "z_kp_perS", 0.0, kHighestGain_perS),
            number(json, "z_velocity_ff", -10.0, 10.0), number(json, "z_accel_ff", -100.0, 100.0),
            number(json, "trim_peak_um", 0.0, kHighestTrim_um)};
}
TapFigures figuresFrom(const Json& json) {
    constexpr double kMost = 1e9;
    TapFigures figures;
    figures.saec_mm = number(json, "saec_mm", 0.0, kMost);
    figures.peak_um = number(json, "peak_um", 0.0, kMost);
    figures.rms_um = number(json, "rms_um", 0.0, kMost);
    figures.engagedPp_um = number(json, "engaged_pp_um", 0.0, kMost);
    figures.samples = static_cast<std::uint32_t>(number(json, "samples", 0.0, kMaxTapTicks));
    figures.missing = static_cast<std::uint32_t>(number(json, "missing", 0.0, kMaxTapTicks));
    return figures;
}
TapCurve curveFrom(const Json& json) {
    TapCurve curve;
    curve.spindle_rev = numbers<float>(json, "spindle_rev", 1.0, 1e6);
    curve.error_um = numbers<float>(json, "error_um", 1.0, 1e9);
    curve.reversal = static_cast<std::size_t>(number(json, "reversal", 0.0, kMaxTapTicks));
    if (curve.spindle_rev.size() != curve.error_um.size() || curve.reversal > curve.error_um.size()) {
        throw Refused{Sentence(KERF_TEXT("Field %1 of the stored tuning is out of range."), SentenceArg("error_um"))};
    }
    return curve;
}

StoredTuning read(const Json& json) {
    if (number(json, "version", 0.0, 1e6) != kVersion) {
        throw Refused{Sentence(KERF_TEXT("The stored tuning is of another version."))};
    }
    StoredTuning tuning;
    tuning.choice.thread = text(json, "thread");
    tuning.choice.speed_rpm = number(json, "speed_rpm", 1.0, 100'000.0);
    tuning.choice.depth_rev = number(json, "depth_rev", 0.1, 1000.0);
    tuning.choice.gear = static_cast<std::uint8_t>(number(json, "gear", 1.0, 9.0));
    tuning.choice.partType = text(json, "part_type");
    tuning.choice.tap = text(json, "tap");
    tuning.settings = settingsFrom(field(json, "settings"));
    tuning.own = settingsFrom(field(json, "own"));
    tuning.hole_s = number(json, "hole_s", 0.0, 1000.0);
    const Json& proof = field(json, "proof");
    tuning.proof.before = settingsViewFrom(field(proof, "before"));
    tuning.proof.after = settingsViewFrom(field(proof, "after"));
    tuning.proof.first = figuresFrom(field(proof, "first"));
    tuning.proof.last = figuresFrom(field(proof, "last"));
    tuning.proof.taps = static_cast<std::uint32_t>(number(proof, "taps", 0.0, 1e6));
    tuning.proof.author = text(proof, "author");
    const Json& back = field(proof, "rolled_back");
    tuning.proof.rolledBack = back.is_boolean() && back.get<bool>();
    tuning.first = curveFrom(field(json, "first"));
    tuning.last = curveFrom(field(json, "last"));
    if (const auto out = json.find("left_out"); out != json.end() && out->is_boolean()) {
        tuning.leftOut = out->get<bool>();
        tuning.leftOutReason = text(json, "left_out_reason");
        tuning.leftOutAuthor = text(json, "left_out_author");
    }
    return tuning;
}

}  // namespace

std::string tuningToJson(const StoredTuning& tuning) {
    Json json;
    json["version"] = kVersion;
    json["thread"] = tuning.choice.thread;
    json["speed_rpm"] = tuning.choice.speed_rpm;
    json["depth_rev"] = tuning.choice.depth_rev;
    json["gear"] = static_cast<int>(tuning.choice.gear);
    json["part_type"] = tuning.choice.partType;
    json["tap"] = tuning.choice.tap;
    json["settings"] = toJson(tuning.settings);
    json["own"] = toJson(tuning.own);
    json["hole_s"] = tuning.hole_s;
    json["proof"] = {{"before", toJson(tuning.proof.before)},
                     {"after", toJson(tuning.proof.after)},
                     {"first", toJson(tuning.proof.first)},
                     {"last", toJson(tuning.proof.last)},
                     {"taps", tuning.proof.taps},
                     {"author", tuning.proof.author},
                     {"rolled_back", tuning.proof.rolledBack}};
    json["first"] = toJson(tuning.first);
    json["last"] = toJson(tuning.last);
    if (tuning.leftOut) {
        json["left_out"] = *tuning.leftOut;
        json["left_out_reason"] = tuning.leftOutReason;
        json["left_out_author"] = tuning.leftOutAuthor;
    }
    return json.dump();
}

Result<StoredTuning> tuningFromJson(std::string_view text) {
    const Json json = Json::parse(text, nullptr, false);
    if (json.is_discarded()) return fail(KERF_TEXT("The stored tuning is not JSON."));
    try {
        return read(json);
    } catch (const Refused& refused) {
        return tl::unexpected(refused.reason);
    }
}

}  // namespace kerf::formats
