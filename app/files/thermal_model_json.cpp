// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/thermal_model_json.h"

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/files/json_document.h"

namespace kerf::formats {
namespace {

using Json = nlohmann::ordered_json;
using namespace thermal;

constexpr const char* kFormat = "kerf-thermal-model";

/// Leaves the reader with the sentence; caught in thermalModelFromJson only.
struct Refused {
    Sentence reason;
};
[[noreturn]] void refuse(const char* text, std::string_view field) {
    throw Refused{Sentence(text, SentenceArg(field))};
}

const Json& field(const Json& parent, const char* key) {
    const auto found = parent.find(key);
    if (!parent.is_object() || found == parent.end()) {
        refuse(KERF_TEXT("The model file has no field %1."), key);
    }
    return *found;
}

double number(const Json& value, const char* key) {
    if (!value.is_number() || !std::isfinite(value.get<double>())) {
        refuse(KERF_TEXT("Field %1 of the model file is not a finite number."), key);
    }
    return value.get<double>();
}
int wholeNumber(const Json& value, const char* key, int low, int high) {
    if (!value.is_number_integer() || value.get<long long>() < low || value.get<long long>() > high) {
        refuse(KERF_TEXT("Field %1 of the model file is not a whole number in range."), key);
    }
    return value.get<int>();
}
std::string text(const Json& value, const char* key) {
    if (!value.is_string()) {
        refuse(KERF_TEXT("Field %1 of the model file is not a text."), key);
    }
    return value.get<std::string>();
}
const Json& list(const Json& value, const char* key, std::size_t size) {
    if (!value.is_array() || value.size() != size) {
        refuse(KERF_TEXT("Field %1 of the model file has the wrong length."), key);
    }
    return value;
}

Json toJson(const Range& range) {
    return Json::array({range.low, range.high});
}
Range rangeFrom(const Json& value, const char* key) {
    const Json& pair = list(value, key, 2);
    const Range range{number(pair[0], key), number(pair[1], key)};
    if (range.high < range.low) {
        refuse(KERF_TEXT("Field %1 of the model file is not a range from low to high."), key);
    }
    return range;
}

Json toJson(const PerAxis& values) {
    return Json::array({values[0], values[1], values[2]});
}
PerAxis perAxisFrom(const Json& value, const char* key) {
    const Json& three = list(value, key, kAxes);
    return {number(three[0], key), number(three[1], key), number(three[2], key)};
}

Json toJson(const Eigen::MatrixXd& matrix) {
    Json rows = Json::array();
    for (Eigen::Index r = 0; r < matrix.rows(); ++r) {
        Json row = Json::array();
        for (Eigen::Index c = 0; c < matrix.cols(); ++c) {
            row.push_back(matrix(r, c));
        }
        rows.push_back(std::move(row));
    }
    return rows;
}
Eigen::MatrixXd matrixFrom(const Json& value, const char* key, std::size_t rows, std::size_t cols) {
    Eigen::MatrixXd matrix(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(cols));
    const Json& all = list(value, key, rows);
    for (std::size_t r = 0; r < rows; ++r) {
        const Json& row = list(all[r], key, cols);
        for (std::size_t c = 0; c < cols; ++c) {
            matrix(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c)) = number(row[c], key);
        }
    }
    return matrix;
}

Json toJson(const NormalEquations& equations) {
    Json half = Json::array();
    for (const PerAxis& set : equations.half_um) {
        half.push_back(toJson(set));
    }
    return {{"rows", equations.rows},
            {"ridge", toJson(equations.ridge)},
            {"gram", toJson(equations.gram)},
            {"moment_um", toJson(equations.moment)},
            {"half_um_by_lost_set", std::move(half)}};
}
NormalEquations equationsFrom(const Json& value, std::size_t sensors, bool withSpeed) {
    const std::size_t terms = sensors * kTermsPerSensor + (withSpeed ? kSpeedTerms : 0);
    NormalEquations out;
    out.sensors = static_cast<int>(sensors);
    out.rows = number(field(value, "rows"), "rows");
    out.ridge = perAxisFrom(field(value, "ridge"), "ridge");
    if (out.rows < 1.0 || out.ridge[0] < 0.0 || out.ridge[1] < 0.0 || out.ridge[2] < 0.0) {
        refuse(KERF_TEXT("Field %1 of the model file is out of range."), out.rows < 1.0 ? "rows" : "ridge");
    }
    out.gram = matrixFrom(field(value, "gram"), "gram", terms, terms);
    out.moment = matrixFrom(field(value, "moment_um"), "moment_um", terms, kAxes);
    constexpr const char* kHalf = "half_um_by_lost_set";
    for (const Json& set : list(field(value, kHalf), kHalf, lostSetCount(sensors))) {
        out.half_um.push_back(perAxisFrom(set, kHalf));
    }
    return out;
}

/// Name, value and range of a between-day law's numbers.
struct LawField {
    const char* key;
    double DayLaw::*value;
    double low;
    double high;
    bool newer{false};  ///< may be absent: as DayLaw begins
};
constexpr std::array<LawField, 11> kLawFields{{{"gain", &DayLaw::gain, 0.0, 1e3},
                                               {"slope_um", &DayLaw::slope_um, 0.0, 1e6},
                                               {"lever_um", &DayLaw::lever_um, 0.0, 1e6, true},
                                               {"trust", &DayLaw::trust, 0.0, 1.0, true},
                                               {"usual", &DayLaw::usual, 0.0, 1e9, true},
                                               {"doubt", &DayLaw::doubt, 0.0, 1.0, true},
                                               {"offset_um", &DayLaw::offset_um, 0.0, 1e6},
                                               {"wander_um", &DayLaw::wander_um, 0.0, 1e6},
                                               {"wander_min", &DayLaw::wander_min, 1e-3, 1e6},
                                               {"noise_um", &DayLaw::noise_um, 1e-3, 1e4},
                                               {"widening", &DayLaw::widening, 0.1, 1e3}}};

Json toJson(const DayLayer& layer) {
    Json laws = Json::array();
    for (const DayLaw& law : layer.axis) {
        Json one;
        for (const LawField& f : kLawFields) {
            one[f.key] = law.*f.value;
        }
        laws.push_back(std::move(one));
    }
    return {{"laws", std::move(laws)}, {"term_scale_K", layer.termScale_K}, {"whiten", layer.whiten}};
}
DayLayer daysFrom(const Json& value, std::size_t sensors) {
    DayLayer layer;
    const Json& laws = list(field(value, "laws"), "laws", kAxes);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        for (const LawField& f : kLawFields) {
            if (f.newer && !laws[axis].contains(f.key)) {
                continue;
            }
            const double read = number(field(laws[axis], f.key), f.key);
            if (read < f.low || read > f.high) {
                refuse(KERF_TEXT("Field %1 of the model file is out of range."), f.key);
            }
            layer.axis[axis].*f.value = read;
        }
    }
    for (const Json& scale : list(field(value, "term_scale_K"), "term_scale_K", sensors * kTermsPerSensor)) {
        layer.termScale_K.push_back(number(scale, "term_scale_K"));
        if (layer.termScale_K.back() < 0.0) {
            refuse(KERF_TEXT("Field %1 of the model file is out of range."), "term_scale_K");
        }
    }
    const std::size_t terms = layer.termScale_K.size();
    if (value.contains("whiten") && !value.at("whiten").empty()) {
        for (const Json& one : list(value.at("whiten"), "whiten", terms * terms)) {
            layer.whiten.push_back(number(one, "whiten"));
        }
    }
    return layer;
}

constexpr std::array<const char*, 3> kInputKinds{"term", "now", "before"};

Json toJson(const GmdhModel& network, const std::vector<GmdhInput>& inputs) {
    Json terms = Json::array();
    for (std::size_t k = 0; k < inputs.size(); ++k) {
        terms.push_back({{"sensor", inputs[k].sensor},
                         {"kind", kInputKinds[static_cast<std::size_t>(inputs[k].kind)]},
                         {"term", inputs[k].term},
                         {"mean", network.inputMean[k]},
                         {"scale", network.inputScale[k]}});
    }
    Json layers = Json::array();
    for (const auto& layer : network.layers) {
        Json neurons = Json::array();
        for (const GmdhNeuron& neuron : layer) {
            Json one{{"i", neuron.i}, {"j", neuron.j}, {"coef", neuron.coef}};
            if (neuron.high < std::numeric_limits<double>::max()) {
                one["clamp"] = Json::array({neuron.low, neuron.high});
            }
            one["criterion"] = neuron.c;
            neurons.push_back(std::move(one));
        }
        layers.push_back(std::move(neurons));
    }
    return {{"inputs", std::move(terms)},
            {"mean_um", network.outputMean},
            {"scale_um", network.outputScale},
            {"layers", std::move(layers)}};
}

GmdhModel networkFrom(const Json& value, std::size_t sensors, std::vector<GmdhInput>& inputs) {
    GmdhModel network;
    const Json& terms = field(value, "inputs");
    if (!terms.is_array() || terms.empty() || terms.size() > 2 * static_cast<std::size_t>(kMaxGmdhWidth)) {
        refuse(KERF_TEXT("Field %1 of the model file has the wrong length."), "inputs");
    }
    for (const Json& term : terms) {
        GmdhInput input;
        input.sensor = wholeNumber(field(term, "sensor"), "sensor", 0, static_cast<int>(sensors) - 1);
        input.term = wholeNumber(field(term, "term"), "term", 0, kTermsPerSensor - 1);
        const std::string kind = text(field(term, "kind"), "kind");
        const auto found = std::ranges::find(kInputKinds, kind);
        if (found == kInputKinds.end()) {
            refuse(KERF_TEXT("Field %1 of the model file has an unknown value."), "kind");
        }
        input.kind = static_cast<InputKind>(found - kInputKinds.begin());
        inputs.push_back(input);
        network.inputMean.push_back(number(field(term, "mean"), "mean"));
        network.inputScale.push_back(number(field(term, "scale"), "scale"));
        if (network.inputScale.back() <= 0.0) {
            refuse(KERF_TEXT("Field %1 of the model file is out of range."), "scale");
        }
    }
    network.inputCount = static_cast<int>(inputs.size());
    network.outputMean = number(field(value, "mean_um"), "mean_um");
    network.outputScale = number(field(value, "scale_um"), "scale_um");
    std::size_t below = inputs.size();
    const Json& layers = field(value, "layers");
    if (!layers.is_array() || layers.empty()) {
        refuse(KERF_TEXT("Field %1 of the model file has the wrong length."), "layers");
    }
    for (const Json& layer : layers) {
        if (!layer.is_array() || layer.empty() || layer.size() > static_cast<std::size_t>(kMaxGmdhWidth)) {
            refuse(KERF_TEXT("Field %1 of the model file has the wrong length."), "layers");
        }
        std::vector<GmdhNeuron> neurons;
        for (const Json& one : layer) {
            GmdhNeuron neuron;
            neuron.i = wholeNumber(field(one, "i"), "i", 0, static_cast<int>(below) - 1);
            neuron.j = wholeNumber(field(one, "j"), "j", 0, static_cast<int>(below) - 1);
            const Json& coef = list(field(one, "coef"), "coef", neuron.coef.size());
            for (std::size_t k = 0; k < neuron.coef.size(); ++k) {
                neuron.coef[k] = number(coef[k], "coef");
            }
            if (one.contains("clamp")) {
                const Range clamp = rangeFrom(one["clamp"], "clamp");
                neuron.low = clamp.low;
                neuron.high = clamp.high;
            }
            neuron.c = number(field(one, "criterion"), "criterion");
            neurons.push_back(neuron);
        }
        below = neurons.size();
        network.layers.push_back(std::move(neurons));
    }
    if (network.layers.back().size() != 1) {
        refuse(KERF_TEXT("Field %1 of the model file has the wrong length."), "layers");
    }
    return network;
}

std::string hexOf(std::uint64_t value) {
    std::string out(16, '0');
    for (auto digit = out.rbegin(); digit != out.rend(); ++digit, value >>= 4U) {
        *digit = "0123456789abcdef"[value & 0xFU];
    }
    return out;
}

ThermalModel read(const Json& file) {
    if (!file.is_object() || !file.contains("format") || file["format"] != kFormat) {
        throw Refused{Sentence(KERF_TEXT("This is not a thermal model file."))};
    }
    const int version = wholeNumber(field(file, "version"), "version", 1, 1'000'000);
    if (version > kModelVersion) {
        throw Refused{Sentence(
            KERF_TEXT("The model file has version %1; this program reads up to version %2. Use a newer program."),
            SentenceArg(version, 0), SentenceArg(kModelVersion, 0))};
    }
    const Json& units = field(file, "units");
    for (const auto& [quantity, unit] : {std::pair("temperature", "degC"), std::pair("drift", "um"),
                                         std::pair("time", "min"), std::pair("speed", "rpm")}) {
        if (field(units, quantity) != unit) {
            throw Refused{Sentence(KERF_TEXT("The model file has another unit of %1; expected %2."),
                                   SentenceArg(quantity), SentenceArg(unit))};
        }
    }
    ThermalModel model;
    const std::string kind = text(field(file, "kind"), "kind");
    bool known = false;
    for (const ModelKind candidate :
         {ModelKind::GmdhPaper, ModelKind::Gmdh, ModelKind::Regression, ModelKind::Hierarchical}) {
        if (kind == modelKindKey(candidate)) {
            model.kind = candidate;
            known = true;
        }
    }
    if (!known) {
        refuse(KERF_TEXT("Field %1 of the model file has an unknown value."), "kind");
    }
    const Json& trained = field(file, "trained_on");
    const std::string fingerprint = text(field(trained, "fingerprint"), "fingerprint");
    const auto parsed =
        std::from_chars(fingerprint.data(), fingerprint.data() + fingerprint.size(), model.fingerprint, 16);
    if (parsed.ec != std::errc{} || parsed.ptr != fingerprint.data() + fingerprint.size()) {
        refuse(KERF_TEXT("Field %1 of the model file has an unknown value."), "fingerprint");
    }
    for (const Json& day : field(trained, "days")) {
        model.trainedOn.push_back(text(day, "days"));
    }
    model.trainingRows = wholeNumber(field(trained, "rows"), "rows", 1, 100'000'000);
    model.period_min = number(field(trained, "period_min"), "period_min");

    const Json& judged = field(file, "judged");
    model.judgement.heldOut = field(judged, "held_out").is_boolean() && judged["held_out"].get<bool>();
    model.judgement.rms_um = perAxisFrom(field(judged, "rms_um"), "rms_um");
    model.judgement.worst_um = perAxisFrom(field(judged, "worst_um"), "worst_um");

    const Json& features = field(file, "features");
    const Json& leak = list(field(features, "leak_min"), "leak_min", model.features.leak_min.size());
    for (std::size_t k = 0; k < model.features.leak_min.size(); ++k) {
        model.features.leak_min[k] = number(leak[k], "leak_min");
    }
    model.features.speedLeak_min = perAxisFrom(field(features, "speed_leak_min"), "speed_leak_min");
    model.features.speedExponent = number(field(features, "speed_exponent"), "speed_exponent");
    if (std::ranges::any_of(model.features.leak_min, [](double tau) { return tau <= 0.0; }) ||
        std::ranges::any_of(model.features.speedLeak_min, [](double tau) { return tau <= 0.0; }) ||
        model.period_min <= 0.0) {
        refuse(KERF_TEXT("Field %1 of the model file is out of range."), "features");
    }

    const Json& sensors = field(file, "sensors");
    const bool regressed = model.kind == ModelKind::Regression || model.kind == ModelKind::Hierarchical;
    const std::size_t most = regressed ? kMaxRegressionSensors : kMaxModelSensors;
    if (!sensors.is_array() || sensors.empty() || sensors.size() > most) {
        refuse(KERF_TEXT("Field %1 of the model file has the wrong length."), "sensors");
    }
    for (const Json& one : sensors) {
        ModelSensor sensor;
        sensor.name = text(field(one, "name"), "name");
        sensor.noise_K = number(field(one, "noise_K"), "noise_K");
        sensor.longestRepeat = wholeNumber(field(one, "longest_repeat"), "longest_repeat", 0, 1'000'000);
        sensor.restPattern_K = number(field(one, "rest_pattern_K"), "rest_pattern_K");
        const Json& ranges = list(field(one, "term_range_K"), "term_range_K", sensor.range.size());
        for (std::size_t term = 0; term < sensor.range.size(); ++term) {
            sensor.range[term] = rangeFrom(ranges[term], "term_range_K");
        }
        model.sensors.push_back(std::move(sensor));
    }
    const std::size_t count = model.sensors.size();
    model.riseMoment_K2 = matrixFrom(field(file, "rise_moment_K2"), "rise_moment_K2", count, count);
    const Json& drift = list(field(file, "drift_range_um"), "drift_range_um", kAxes);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        model.drift_um[axis] = rangeFrom(drift[axis], "drift_range_um");
    }
    if (file.contains("axes")) {
        const std::string axes = text(file["axes"], "axes");
        if (axes.empty() || axes.find_first_not_of("xyz") != std::string::npos) {
            refuse(KERF_TEXT("Field %1 of the model file has an unknown value."), "axes");
        }
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
            model.axes[axis] = axes.find("xyz"[axis]) != std::string::npos;
        }
    }
    if (regressed) {
        const Json& regression = field(file, "regression");
        RegressionPart part;
        part.temperatures = equationsFrom(field(regression, "temperatures"), count, false);
        if (regression.contains("with_speed")) {
            part.withSpeed = equationsFrom(regression["with_speed"], count, true);
        }
        model.regression = std::move(part);
        if (model.kind == ModelKind::Hierarchical) {
            model.days = daysFrom(field(file, "between_days"), count);
        }
    } else {
        const Json& networks = list(field(file, "networks"), "networks", kAxes);
        GmdhPart part;
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
            part.network[axis] = networkFrom(networks[axis], count, part.inputs[axis]);
        }
        part.half_um = perAxisFrom(field(file, "half_um"), "half_um");
        model.gmdh = std::move(part);
    }
    return model;
}

}  // namespace

std::string thermalModelToJson(const ThermalModel& model) {
    Json file;
    file["format"] = kFormat;
    file["version"] = kModelVersion;
    file["kind"] = modelKindKey(model.kind);
    file["units"] = {{"temperature", "degC"}, {"drift", "um"}, {"time", "min"}, {"speed", "rpm"}};
    file["trained_on"] = {{"fingerprint", hexOf(model.fingerprint)},
                          {"days", model.trainedOn},
                          {"rows", model.trainingRows},
                          {"period_min", model.period_min}};
    file["judged"] = {{"held_out", model.judgement.heldOut},
                      {"rms_um", toJson(model.judgement.rms_um)},
                      {"worst_um", toJson(model.judgement.worst_um)}};
    file["formula"] = formulaLines(model);
    file["features"] = {{"leak_min", model.features.leak_min},
                        {"speed_leak_min", model.features.speedLeak_min},
                        {"speed_exponent", model.features.speedExponent}};
    Json sensors = Json::array();
    for (const ModelSensor& sensor : model.sensors) {
        Json ranges = Json::array();
        for (const Range& range : sensor.range) {
            ranges.push_back(toJson(range));
        }
        sensors.push_back({{"name", sensor.name},
                           {"noise_K", sensor.noise_K},
                           {"longest_repeat", sensor.longestRepeat},
                           {"rest_pattern_K", sensor.restPattern_K},
                           {"term_range_K", std::move(ranges)}});
    }
    file["sensors"] = std::move(sensors);
    file["rise_moment_K2"] = toJson(model.riseMoment_K2);
    std::string axes;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        axes += model.axes[axis] ? std::string(1, "xyz"[axis]) : "";
    }
    file["axes"] = axes;
    Json drift = Json::array();
    for (const Range& range : model.drift_um) {
        drift.push_back(toJson(range));
    }
    file["drift_range_um"] = std::move(drift);
    if (model.regression) {
        Json regression{{"temperatures", toJson(model.regression->temperatures)}};
        if (model.regression->withSpeed) {
            regression["with_speed"] = toJson(*model.regression->withSpeed);
        }
        file["regression"] = std::move(regression);
    }
    if (model.days) {
        file["between_days"] = toJson(*model.days);
    }
    if (model.gmdh) {
        Json networks = Json::array();
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
            networks.push_back(toJson(model.gmdh->network[axis], model.gmdh->inputs[axis]));
        }
        file["networks"] = std::move(networks);
        file["half_um"] = toJson(model.gmdh->half_um);
    }
    // A name of unknown encoding in a day of an older program never ends in an exception.
    return file.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<ThermalModel> thermalModelFromJson(std::string_view text) {
    const auto file = files::parseJson(std::string(text));
    if (!file) {
        return tl::unexpected(file.error());
    }
    try {
        return read(Json(*file));
    } catch (const Refused& refused) {
        return tl::unexpected(refused.reason);
    } catch (const Json::exception&) {
        return fail(KERF_TEXT("The model file is damaged."));
    }
}

}  // namespace kerf::formats
