// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "engine/core/result.h"
#include "engine/process/milling/milling_types.h"

/// What the milling room keeps, as text: JSON in the store, CSV for a blank profile from elsewhere. Numbers come back
/// to the last digit; bad text gives one sentence and no value.
namespace kerf {

/// A blank profile and the file it came from.
struct NamedBlank {
    MillingBlank blank{};
    std::string source{};
};
/// A room record of before blanks stood in the recipe.
[[nodiscard]] Result<NamedBlank> millingBlankFromJson(const std::string& text);

/// What a part type is milled by.
struct MillingRecipe {
    MillingSetup setup{};
    NamedBlank blank{};
};
[[nodiscard]] std::string millingRecipeJson(const MillingRecipe& recipe);
/// Keys of the setup that are absent keep their default; its revision stays 1. A revision of before blanks stood in the
/// recipe says none: `otherwise` holds.
[[nodiscard]] Result<MillingRecipe> millingRecipeFromJson(const std::string& text, const NamedBlank& otherwise);
[[nodiscard]] bool millingRecipeSaysBlank(const std::string& text);

/// What is kept after each cut: the tool as learnt, and of the cut what its stored figures do not say.
struct MillingToolRecord {
    MillingToolState tool{};
    bool learnt{false};  ///< false: a new tool, nothing learnt yet
    /// The tool's name for ever: the last part that was stored before it (by its number in records of before version
    /// 7).
    std::int64_t since{0};
    std::int64_t after{0};              ///< the last part cut with the tool before, as it is stored
    std::int64_t lastPart{0};           ///< newest part that `tool` knows, as it is stored
    bool byNumber{false};               ///< of before version 7: `after` and `lastPart` are numbers of parts of no lot
    MillingLaw law{MillingLaw::Model};  ///< of that part
    bool advised{false};
    // what it cut, and what kind it is; empty and 0 in records of older consoles
    std::string partType{};
    double toolRadius_mm{0.0};
    std::uint8_t flutes{0};
};
[[nodiscard]] std::string millingToolJson(const MillingToolRecord& record);
[[nodiscard]] Result<MillingToolRecord> millingToolFromJson(const std::string& text);

/// x_mm,height_mm: each row begins a step; the last row's position ends the blank (as `kerf milling` reads it). Empty
/// lines and lines that begin with # are skipped. The sentence names line and column.
[[nodiscard]] Result<MillingBlank> millingBlankFromCsv(std::string_view text);

}  // namespace kerf
