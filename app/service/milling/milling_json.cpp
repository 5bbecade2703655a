// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/milling/milling_json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "app/files/table.h"
#include "app/service/setup_keys.h"
#include "engine/process/milling/milling_setup.h"

namespace kerf {
namespace {

using nlohmann::ordered_json;

constexpr std::array<const char*, kMillingLawCount> kLawKeys{"constant", "pi", "model", "preview"};
constexpr const char* kPosition = "x_mm";
constexpr const char* kHeight = "height_mm";
constexpr const char* kBlank = "blank";  // in a recipe
constexpr double kUnlikelyKx = -6.0;     // ln of a weight

MillingLaw lawOf(const std::string& key) {
    for (std::size_t i = 0; i < kMillingLawCount; ++i) {
        if (key == kLawKeys[i]) {
            return static_cast<MillingLaw>(i);
        }
    }
    return MillingLaw::Model;
}

const char* keyOf(MillingLaw law) {
    return kLawKeys[static_cast<std::size_t>(law)];
}

tl::unexpected<Sentence> unreadable() {
    return fail(KERF_TEXT("What was stored for milling cannot be read."));
}

ordered_json blankDocument(const NamedBlank& named) {
    ordered_json json;
    json["begin_mm"] = ordered_json::array();
    json["height_mm"] = ordered_json::array();
    for (std::size_t i = 0; i < named.blank.count; ++i) {
        json["begin_mm"].push_back(named.blank.begin_mm[i]);
        json["height_mm"].push_back(named.blank.height_mm[i]);
    }
    json["end_mm"] = named.blank.end_mm;
    if (named.blank.count > 0) {
        json["source"] = named.source;
    }
    return json;
}

/// Throws what the JSON library throws.
Result<NamedBlank> blankOf(const nlohmann::json& json) {
    NamedBlank named;
    const auto begin_mm = json.at("begin_mm").get<std::vector<double>>();
    const auto height_mm = json.at("height_mm").get<std::vector<double>>();
    if (begin_mm.size() != height_mm.size() || begin_mm.size() > MillingBlank::kMaxSteps) {
        return unreadable();
    }
    named.blank.count = static_cast<std::uint16_t>(begin_mm.size());
    std::ranges::copy(begin_mm, named.blank.begin_mm.begin());
    std::ranges::copy(height_mm, named.blank.height_mm.begin());
    named.blank.end_mm = json.at("end_mm").get<double>();
    named.source = json.value("source", std::string());
    if (const auto why = milling::whyUnusable(named.blank)) {
        return tl::unexpected(*why);
    }
    return named;
}

struct CsvRow {
    std::uint32_t line{0};
    double position_mm{0.0};
    double height_mm{0.0};
};

Result<std::vector<CsvRow>> rowsOf(std::string_view text) {
    if (files::decodeText(text).utf8.find_first_not_of(" \t\r\n") == std::string::npos) {
        return std::vector<CsvRow>();
    }
    try {
        const files::Table table = files::Table::parse(text, {});
        const auto position = table.find(kPosition);
        const auto height = table.find(kHeight);
        if (!position || !height) {
            return fail(KERF_TEXT("Line %1: the first line must name the columns x_mm,height_mm."),
                        SentenceArg(table.headerLine(), 0));
        }
        for (const auto& [name, column] : {std::pair(kPosition, *position), {kHeight, *height}}) {
            for (std::size_t row = 0; row < table.rows(); ++row) {
                if (table.kind(row, column) != files::CellKind::Number) {
                    return fail(KERF_TEXT("Line %1, column %2: “%3” is not a number."),
                                SentenceArg(table.lineOf(row), 0), SentenceArg(std::string_view(name)),
                                SentenceArg(table.cellText(row, column)));
                }
            }
        }
        std::vector<CsvRow> rows;
        const auto& position_mm = table.column(kPosition);
        const auto& height_mm = table.column(kHeight);
        for (std::size_t row = 0; row < table.rows(); ++row) {
            rows.push_back({table.lineOf(row), position_mm[row], height_mm[row]});
        }
        return rows;
    } catch (const files::WrongWidth& wrong) {
        return fail(KERF_TEXT("Line %1: %2 columns, expected are 2: x_mm,height_mm."), SentenceArg(wrong.line(), 0),
                    SentenceArg(static_cast<double>(wrong.fields()), 0));
    } catch (const files::HeaderMissing& missing) {
        return fail(KERF_TEXT("Line %1: the first line must name the columns x_mm,height_mm."),
                    SentenceArg(missing.line(), 0));
    } catch (const files::BadInput&) {
        return fail(KERF_TEXT("The table is in doubt: save it with ; between its columns, or with decimal points."));
    }
}

}  // namespace

std::string millingRecipeJson(const MillingRecipe& recipe) {
    ordered_json json;
    for (const MillingField& field : milling::setupFields()) {
        json[field.spec.key] = field.get(recipe.setup);
    }
    json["milling.law"] = keyOf(recipe.setup.law);
    json[kBlank] = blankDocument(recipe.blank);
    return json.dump();
}

Result<MillingRecipe> millingRecipeFromJson(const std::string& text, const NamedBlank& otherwise) {
    MillingRecipe recipe{{}, otherwise};
    MillingSetup& setup = recipe.setup;
    setup.revision = 1;
    try {
        const auto json = nlohmann::json::parse(text);
        for (const MillingField& field : milling::setupFields()) {
            field.set(setup, numberOr(json, field.spec.key, field.spec.fallback, "milling setup"));
        }
        setup.law = lawOf(json.value("milling.law", std::string(keyOf(MillingLaw::Model))));
        if (const auto said = json.find(kBlank); said != json.end()) {
            const auto blank = blankOf(*said);
            if (!blank) {
                return tl::unexpected(blank.error());
            }
            recipe.blank = *blank;
        }
    } catch (const nlohmann::json::exception&) {
        return unreadable();
    }
    if (const auto why = milling::whyUnusable(setup)) {
        return tl::unexpected(*why);
    }
    return recipe;
}

bool millingRecipeSaysBlank(const std::string& text) {
    const auto json = nlohmann::json::parse(text, nullptr, false);
    return json.is_object() && json.contains(kBlank);
}

Result<NamedBlank> millingBlankFromJson(const std::string& text) {
    try {
        return blankOf(nlohmann::json::parse(text));
    } catch (const nlohmann::json::exception&) {
        return unreadable();
    }
}

std::string millingToolJson(const MillingToolRecord& record) {
    const MillingToolState& tool = record.tool;
    ordered_json json;
    json["learnt"] = record.learnt;
    json["since_part"] = record.since;
    json["after_part_id"] = record.after;
    json["last_part_id"] = record.lastPart;
    json["law"] = keyOf(record.law);
    json["advised"] = record.advised;
    json["parts"] = tool.parts;
    json["first_stiffness"] = tool.firstStiffness;
    json["last_stiffness"] = tool.lastStiffness;
    json["sum_rise"] = tool.sumRise;
    json["sum_index_rise"] = tool.sumIndexRise;
    json["kx_log_weight"] = tool.kxLogWeight;
    json["part_type"] = record.partType;
    json["tool_radius_mm"] = record.toolRadius_mm;
    json["flutes"] = record.flutes;
    return json.dump();
}

Result<MillingToolRecord> millingToolFromJson(const std::string& text) {
    MillingToolRecord record;
    try {
        const auto json = nlohmann::json::parse(text);
        record.learnt = json.at("learnt").get<bool>();
        record.since = json.at("since_part").get<std::int64_t>();
        record.byNumber = !json.contains("last_part_id");
        record.after = record.byNumber ? record.since : json.at("after_part_id").get<std::int64_t>();
        record.lastPart = json.at(record.byNumber ? "last_part" : "last_part_id").get<std::int64_t>();
        record.law = lawOf(json.at("law").get<std::string>());
        record.advised = json.at("advised").get<bool>();
        record.tool.parts = json.at("parts").get<std::uint32_t>();
        record.tool.firstStiffness = json.at("first_stiffness").get<double>();
        record.tool.lastStiffness = json.at("last_stiffness").get<double>();
        record.tool.sumRise = json.at("sum_rise").get<double>();
        record.tool.sumIndexRise = json.at("sum_index_rise").get<double>();
        // Versions before had no filters for stiff tools: those come last and are not ruled out.
        const auto weights = json.at("kx_log_weight").get<std::vector<double>>();
        if (weights.empty() || weights.size() > kMillingKxFilters) {
            return unreadable();
        }
        record.tool.kxLogWeight.fill(kUnlikelyKx);
        std::ranges::copy(weights, record.tool.kxLogWeight.begin());
        record.partType = json.value("part_type", std::string());
        record.toolRadius_mm = json.value("tool_radius_mm", 0.0);
        record.flutes = json.value("flutes", std::uint8_t{0});
    } catch (const nlohmann::json::exception&) {
        return unreadable();
    }
    return record;
}

Result<MillingBlank> millingBlankFromCsv(std::string_view text) {
    constexpr double kMaxHeight_mm = 50.0;
    const Result<std::vector<CsvRow>> rows = rowsOf(text);
    if (!rows) {
        return tl::unexpected(rows.error());
    }
    if (rows->size() < 2 || rows->size() > MillingBlank::kMaxSteps + 1) {
        return fail(KERF_TEXT("%1 rows; a blank profile needs from 2 to %2, the last one ends the blank."),
                    SentenceArg(static_cast<double>(rows->size()), 0),
                    SentenceArg(static_cast<double>(MillingBlank::kMaxSteps + 1), 0));
    }
    MillingBlank blank;
    blank.count = static_cast<std::uint16_t>(rows->size() - 1);
    for (std::size_t i = 0; i < rows->size(); ++i) {
        const CsvRow& row = (*rows)[i];
        if (i > 0 && !(row.position_mm > (*rows)[i - 1].position_mm)) {
            return fail(KERF_TEXT("Line %1, column x_mm: %2 mm must lie beyond the step before, %3 mm."),
                        SentenceArg(row.line, 0), SentenceArg(row.position_mm, 3),
                        SentenceArg((*rows)[i - 1].position_mm, 3));
        }
        if (!(row.height_mm >= 0.0 && row.height_mm <= kMaxHeight_mm)) {
            return fail(KERF_TEXT("Line %1, column height_mm: %2 mm must be from 0 to %3 mm."),
                        SentenceArg(row.line, 0), SentenceArg(row.height_mm, 3), SentenceArg(kMaxHeight_mm, 0));
        }
        if (i < blank.count) {
            blank.begin_mm[i] = row.position_mm;
            blank.height_mm[i] = row.height_mm;
        }
    }
    blank.end_mm = rows->back().position_mm;
    if (const auto why = milling::whyUnusable(blank)) {
        return tl::unexpected(*why);
    }
    return blank;
}

}  // namespace kerf
