// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/quality/characteristics.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/service/boring/boring_recipe.h"
#include "engine/api/part_results.h"

namespace kerf {
namespace {

constexpr double kWholeTolerance_percent = 100.0;
constexpr int kBoreDecimals = 3;

const char* reworkKey(quality::ReworkSide side) {
    return side == quality::ReworkSide::Below ? "below" : side == quality::ReworkSide::Above ? "above" : "none";
}

std::vector<Characteristic> boresOf(const std::string& recipeJson) {
    const Result<BoringRecipe> recipe = recipeFromJson(recipeJson);
    if (!recipe) {
        return {};
    }
    std::vector<Characteristic> bores;
    for (std::size_t i = 0; i < recipe->depths.size(); ++i) {
        bores.push_back({"bore_" + std::to_string(i),
                         recipe->depths[i].name,
                         "mm",
                         kBoreDecimals,
                         recipe->targetDiameter_mm,
                         {recipe->lowerTolerance_mm, recipe->upperTolerance_mm, quality::ReworkSide::Below}});
    }
    return bores;
}

std::optional<double> boreOf(const std::vector<MeasurementRow>& effective, std::size_t station) {
    const auto found = std::ranges::find(effective, station, &MeasurementRow::station);
    return found == effective.end() ? std::nullopt : found->diameter_mm;
}

std::optional<double> figureOf(const PartRow& part, const std::string& key) {
    const auto found = std::ranges::find(part.figures, key, &PartFigure::key);
    return found == part.figures.end() ? std::nullopt : std::optional(found->value);
}

}  // namespace

std::vector<FigureLimit> standardLimits(ProcessId process) {
    if (process == ProcessId::Tapping) {
        return {{"tolerance_used_percent", {std::nullopt, kWholeTolerance_percent, quality::ReworkSide::None}}};
    }
    return {};
}

std::string limitsJson(const std::vector<FigureLimit>& limits) {
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
    for (const FigureLimit& limit : limits) {
        nlohmann::ordered_json row;
        if (limit.tolerance.lower) {
            row["lower"] = *limit.tolerance.lower;
        }
        if (limit.tolerance.upper) {
            row["upper"] = *limit.tolerance.upper;
        }
        row["rework"] = reworkKey(limit.tolerance.rework);
        json[limit.key] = std::move(row);
    }
    return json.dump();
}

Result<std::vector<FigureLimit>> limitsFromJson(ProcessId process, const std::string& text) {
    std::vector<FigureLimit> limits;
    try {
        const auto json = nlohmann::ordered_json::parse(text);
        for (const auto& [key, row] : json.items()) {
            FigureLimit limit{key, {}};
            if (row.contains("lower")) {
                limit.tolerance.lower = row.at("lower").get<double>();
            }
            if (row.contains("upper")) {
                limit.tolerance.upper = row.at("upper").get<double>();
            }
            const std::string rework = row.value("rework", "none");
            limit.tolerance.rework = rework == "below"   ? quality::ReworkSide::Below
                                     : rework == "above" ? quality::ReworkSide::Above
                                                         : quality::ReworkSide::None;
            if (findPartResult(process, key) == nullptr) {
                return fail(KERF_TEXT("%1 is no figure of this process."), SentenceArg(std::string_view(key)));
            }
            if (limit.tolerance.lower && limit.tolerance.upper && !(*limit.tolerance.lower < *limit.tolerance.upper)) {
                return fail(KERF_TEXT("The lower limit of %1 must be below the upper one."),
                            SentenceArg(std::string_view(key)));
            }
            limits.push_back(std::move(limit));
        }
    } catch (const nlohmann::json::exception&) {
        return fail(KERF_TEXT("The limits of the figures cannot be read; they need numbers under their keys."));
    }
    return limits;
}

std::optional<std::vector<FigureLimit>> limitsOfRecipe(ProcessId process, const std::string& parametersJson) {
    if (parametersJson.find(kFigureLimits) == std::string::npos) {
        return std::nullopt;  // a tuning with its curves is long
    }
    const auto json = nlohmann::ordered_json::parse(parametersJson, nullptr, false);
    if (!json.is_object() || !json.contains(kFigureLimits)) {
        return std::nullopt;
    }
    return limitsFromJson(process, json.at(kFigureLimits).dump()).value_or(std::vector<FigureLimit>{});
}

const RecipeLimits::Revision* RecipeLimits::under(const PartRow& part) const {
    const auto after = std::ranges::upper_bound(revisions, part.endedUtc_ms, {}, &Revision::from_ms);
    const Revision* const then = after == revisions.begin() ? nullptr : &*(after - 1);
    const auto own = part.recipe ? ofRecipe.find(*part.recipe) : ofRecipe.end();
    // A thread nobody has tuned is cut with the tuning of another one: its limits are its own all the same.
    const bool another = own != ofRecipe.end() && then != nullptr && then->partType != own->second.partType;
    return own != ofRecipe.end() && !another ? &own->second : then;
}

const std::vector<FigureLimit>& RecipeLimits::of(const PartRow& part) const {
    const Revision* revision = under(part);
    return revision != nullptr ? revision->limits : before;
}

std::uint32_t RecipeLimits::revisionOf(const PartRow& part) const {
    const Revision* revision = under(part);
    return revision != nullptr ? revision->revision : 0;
}

std::vector<Characteristic> withLimits(std::vector<Characteristic> characteristics,
                                       const std::vector<FigureLimit>& limits) {
    for (Characteristic& one : characteristics) {
        const auto found = std::ranges::find(limits, one.key, &FigureLimit::key);
        one.tolerance = found == limits.end() ? quality::Tolerance{} : found->tolerance;
    }
    return characteristics;
}

std::vector<Characteristic> characteristicsOf(ProcessId process, const std::string& recipeJson,
                                              const std::vector<FigureLimit>& limits) {
    if (process == ProcessId::Boring) {
        return boresOf(recipeJson);
    }
    std::vector<Characteristic> figures;
    for (const FigureLimit& limit : limits) {
        if (const PartResultSpec* spec = findPartResult(process, limit.key); spec != nullptr) {
            figures.push_back({limit.key, spec->label, spec->unit, spec->decimals, std::nullopt, limit.tolerance});
        }
    }
    return figures;
}

PartJudgement judgePart(const PartRow& part, const std::vector<Characteristic>& characteristics) {
    PartJudgement judgement;
    const std::vector<MeasurementRow> effective = effectiveMeasurements(part.measurements);
    const bool any =
        std::ranges::any_of(characteristics, [](const Characteristic& one) { return one.tolerance.given(); });
    quality::Verdict worst = part.complete && any ? quality::Verdict::Good : quality::Verdict::NotJudged;
    for (std::size_t i = 0; i < characteristics.size(); ++i) {
        JudgedValue judged;
        judged.value =
            part.process == ProcessId::Boring ? boreOf(effective, i) : figureOf(part, characteristics[i].key);
        judged.tolerance = characteristics[i].tolerance;
        judged.verdict = quality::judge(judged.value, judged.tolerance);
        if (judged.tolerance.given()) {
            worst = quality::worse(worst, judged.verdict);
        }
        judgement.values.push_back(judged);
    }
    judgement.verdict = worst;
    return judgement;
}

}  // namespace kerf
