// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "app/service/tapping/stored_tuning.h"
#include "engine/core/result.h"

/// A tuning as the database keeps it: versioned JSON, numbers under keys that end in their unit. Gains keep all their
/// digits, the trim a tenth of a nanometre, curves a hundredth of a µm. A text of another version, or with a field
/// missing or out of range, is refused with a sentence.
namespace kerf::formats {

[[nodiscard]] std::string tuningToJson(const tapping::StoredTuning& tuning);
[[nodiscard]] Result<tapping::StoredTuning> tuningFromJson(std::string_view text);

}  // namespace kerf::formats
