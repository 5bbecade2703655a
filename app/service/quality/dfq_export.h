// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/service/quality/stored_quality_service.h"

/// Q-DAS files that appear by themselves as parts finish.
namespace kerf {

inline constexpr const char* kDfqFolder = "quality.dfq_folder";    ///< setting; empty: no files
inline constexpr const char* kDfqPattern = "quality.dfq_pattern";  ///< setting
inline constexpr const char* kDfqPatternStandard = "{type}_{lot}_{part}.dfq";

/// Name of a part's file: {type}, {lot}, {part}, {serial}, {machine}, {date} (yyyyMMdd), {time} (HHmmss, local, when
/// the part ended). What cannot stand in a name becomes _. A pattern that names no part would overwrite: refused.
[[nodiscard]] Result<std::string> dfqFileName(const std::string& pattern, const LotRow& lot, const PartRow& part);
/// Why a pattern cannot be used; empty when it can.
[[nodiscard]] std::optional<Sentence> whyNoPattern(const std::string& pattern);

/// Writes the file of one part of the lot under a name of its own, then renames it: nobody sees half a file. A file of
/// another part is never overwritten, whatever the pattern leaves out: name_2, name_3 … follow. `own`: where this part
/// was written before. Gives where it is now.
[[nodiscard]] Result<std::string> exportPart(const QualityLot& lot, const PartRow& part, const std::string& folder,
                                             const std::string& pattern, const std::string& own = {});

}  // namespace kerf
