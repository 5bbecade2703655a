// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/turning/turning_records.h"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/service/setup_keys.h"
#include "engine/process/turning/turning_setup.h"

namespace kerf {
namespace {

using nlohmann::json;

constexpr std::array<const char*, kTurningControllers> kControllers{"open", "paper", "pi", "tones"};
constexpr const char* kLaw = "turning.law";  // in a recipe
constexpr double kTenth_nm = 1e-4;           // what a stored spectrum line or force needs: four decimals

double rounded(float value) {
    return std::round(static_cast<double>(value) / kTenth_nm) * kTenth_nm;
}

json linesJson(const std::vector<float>& lines) {
    json out = json::array();
    for (const float line : lines) {
        out.push_back(rounded(line));
    }
    return out;
}

std::optional<TurningController> controllerOf(const std::string& key) {
    for (std::size_t i = 0; i < kControllers.size(); ++i) {
        if (key == kControllers[i]) {
            return static_cast<TurningController>(i);
        }
    }
    return std::nullopt;
}

json setupDocument(const TurningSetup& setup) {
    json out{{"revision", setup.revision}, {"turning.tones_hz", json::array()}};
    for (std::size_t i = 0; i < turning::kSetupFields; ++i) {
        out[turning::setupSpecs()[i].key] = turning::valueOf(setup, static_cast<turning::SetupField>(i));
    }
    for (std::size_t j = 0; j < setup.knownToneCount; ++j) {
        out["turning.tones_hz"].push_back(setup.knownTones_Hz[j]);
    }
    return out;
}

TurningSetup setupOf(const json& in) {
    TurningSetup setup;
    setup.revision = in.value("revision", std::uint32_t{1});
    for (std::size_t i = 0; i < turning::kSetupFields; ++i) {
        const ParamSpec& spec = turning::setupSpecs()[i];
        turning::setValue(setup, static_cast<turning::SetupField>(i),
                          numberOr(in, spec.key, spec.fallback, "turning setup"));
    }
    setup.knownToneCount = 0;
    setup.knownTones_Hz = {};
    for (const json& tone : in.value("turning.tones_hz", json::array())) {
        if (setup.knownToneCount < kTurningTones) {
            setup.knownTones_Hz[setup.knownToneCount++] = tone.get<double>();
        }
    }
    return setup;
}

/// One row per number of a record: key and place.
struct Number {
    const char* key;
    double TurningRecord::*value;
};
constexpr std::array kNumbers{
    Number{"surface_rms_um", &TurningRecord::surfaceRms_um},
    Number{"surface_pv_um", &TurningRecord::surfacePv_um},
    Number{"untreated_rms_um", &TurningRecord::untreatedRms_um},
    Number{"steady_rms_um", &TurningRecord::steadyRms_um},
    Number{"steady_pv_um", &TurningRecord::steadyPv_um},
    Number{"steady_force_N", &TurningRecord::steadyForce_N},
    Number{"open_steady_rms_um", &TurningRecord::openSteadyRms_um},
    Number{"open_steady_pv_um", &TurningRecord::openSteadyPv_um},
    Number{"force_target_N", &TurningRecord::forceTarget_N},
    Number{"force_zero_N", &TurningRecord::forceZero_N},
    Number{"touch_off_mm", &TurningRecord::touchOff_mm},
    Number{"trim_peak_um", &TurningRecord::trimPeak_um},
};

json identificationJson(const TurningRecord& record) {
    const TurningIdentification& found = record.identification;
    return {
        {"available", found.available},   {"sure", found.sure},
        {"value", found.value},           {"half95", found.half95},
        {"trace", found.trace},           {"excitation", found.excitation},
        {"residual_N", found.residual_N}, {"law", {record.lawProcess.a1, record.lawProcess.b0, record.lawProcess.b1}},
        {"retuned", record.retuned}};
}

void readIdentification(const json& in, TurningRecord& record) {
    TurningIdentification& found = record.identification;
    found.available = in.at("available").get<bool>();
    found.sure = in.at("sure").get<bool>();
    found.value = in.at("value").get<std::array<double, 3>>();
    found.half95 = in.at("half95").get<std::array<double, 3>>();
    found.trace = in.at("trace").get<double>();
    found.excitation = in.at("excitation").get<double>();
    found.residual_N = in.at("residual_N").get<double>();
    const auto law = in.at("law").get<std::array<double, 3>>();
    record.lawProcess = {law[0], law[1], law[2]};
    record.retuned = in.at("retuned").get<std::uint32_t>();
}

template <class Read>
auto parsed(const std::string& text, const Read& read) -> std::optional<decltype(read(json{}))> {
    try {
        return read(json::parse(text));
    } catch (const json::exception&) {
        return std::nullopt;  // a file of another version: what it cannot give does not exist
    }
}

}  // namespace

std::string turningRecipeJson(const TurningRecipe& recipe) {
    json out = setupDocument(recipe.setup);
    out[kLaw] = turningControllerKey(recipe.controller);
    return out.dump();
}

std::optional<TurningRecipe> turningRecipeFrom(const std::string& text, TurningController otherwise) {
    const auto read = [otherwise](const json& in) {
        const auto said = in.find(kLaw);
        return std::pair(setupOf(in),
                         said == in.end() ? std::optional(otherwise) : controllerOf(said->get<std::string>()));
    };
    const auto recipe = parsed(text, read);
    const bool usable = recipe && recipe->second && recipe->first.revision > 0 && !turning::whyUnusable(recipe->first);
    return usable ? std::optional(TurningRecipe{recipe->first, *recipe->second}) : std::nullopt;
}

bool turningRecipeSaysLaw(const std::string& text) {
    return parsed(text, [](const json& in) { return in.contains(kLaw); }).value_or(false);
}

const char* turningControllerKey(TurningController controller) noexcept {
    return kControllers[static_cast<std::size_t>(controller)];
}

std::optional<TurningController> turningControllerFrom(const std::string& text) {
    const auto key = parsed(text, [](const json& in) { return in.at("controller").get<std::string>(); });
    return key ? controllerOf(*key) : std::nullopt;
}

std::string turningPartJson(const TurningPartView& part) {
    const TurningRecord& record = part.record;
    json out{{"part", part.id},
             {"number", part.number},
             {"complete", part.complete},
             {"force_mean_N", part.forceMean_N},
             {"force_peak_N", part.forcePeak_N},
             {"controller", turningControllerKey(record.controller)},
             {"controlled", record.controlled},
             {"left_loop", record.leftLoop},
             {"setup", setupDocument(record.setup)},
             {"identification", identificationJson(record)},
             {"tones", json::array()},
             {"spectrum",
              {{"step_hz", part.spectrum.step_Hz},
               {"treated_um", linesJson(part.spectrum.treated_um)},
               {"untreated_um", linesJson(part.spectrum.untreated_um)}}},
             {"force", json::array()}};
    for (const Number& number : kNumbers) {
        out[number.key] = record.*number.value;
    }
    for (std::size_t j = 0; j < record.toneCount; ++j) {
        const TurningTone& tone = record.tones[j];
        out["tones"].push_back({{"frequency_hz", tone.frequency_Hz},
                                {"amplitude_um", tone.amplitude_um},
                                {"visibility", tone.visibility},
                                {"blind", tone.blind},
                                {"share", tone.share}});
    }
    for (const TurningForcePiece& piece : part.force) {
        out["force"].push_back({piece.progress, piece.low_N, piece.mean_N, piece.high_N});
    }
    return out.dump();
}

std::optional<TurningPartView> turningPartFrom(const std::string& text) {
    const auto read = [](const json& in) {
        TurningPartView part;
        part.id = in.at("part").get<std::int64_t>();
        part.number = in.at("number").get<std::uint32_t>();
        part.complete = in.at("complete").get<bool>();
        part.forceMean_N = in.at("force_mean_N").get<double>();
        part.forcePeak_N = in.at("force_peak_N").get<double>();
        TurningRecord& record = part.record;
        record.valid = true;
        record.controller = controllerOf(in.at("controller").get<std::string>()).value_or(TurningController::Tones);
        record.controlled = in.at("controlled").get<bool>();
        record.leftLoop = in.at("left_loop").get<bool>();
        record.setup = setupOf(in.at("setup"));
        readIdentification(in.at("identification"), record);
        for (const Number& number : kNumbers) {
            record.*number.value = in.at(number.key).get<double>();
        }
        for (const json& tone : in.at("tones")) {
            if (record.toneCount < kTurningTones) {
                record.tones[record.toneCount++] = {
                    tone.at("frequency_hz").get<double>(), tone.at("amplitude_um").get<double>(),
                    tone.at("visibility").get<double>(), tone.at("blind").get<bool>(), tone.at("share").get<double>()};
            }
        }
        const json& spectrum = in.at("spectrum");
        part.spectrum.step_Hz = spectrum.at("step_hz").get<double>();
        part.spectrum.treated_um = spectrum.at("treated_um").get<std::vector<float>>();
        part.spectrum.untreated_um = spectrum.at("untreated_um").get<std::vector<float>>();
        for (const json& piece : in.at("force")) {
            part.force.push_back({piece.at(0).get<double>(), piece.at(1).get<double>(), piece.at(2).get<double>(),
                                  piece.at(3).get<double>()});
        }
        return part;
    };
    return parsed(text, read);
}

}  // namespace kerf
