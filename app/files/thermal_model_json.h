// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "engine/core/result.h"
#include "engine/process/thermal/thermal_model.h"

/// Model files: versioned JSON with units, sensor names and the fingerprint of the training data. 17 digits: a model
/// read back predicts the same numbers. A file of another format, a newer version, other units, or with a field missing
/// or of the wrong size is refused with a sentence.
namespace kerf::formats {

[[nodiscard]] std::string thermalModelToJson(const thermal::ThermalModel& model);
[[nodiscard]] Result<thermal::ThermalModel> thermalModelFromJson(std::string_view text);

}  // namespace kerf::formats
