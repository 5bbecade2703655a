// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "engine/core/param_spec.h"
#include "engine/process/turning/turning_types.h"

namespace kerf::turning {

/// The numbers of a turning setup in the order of the setup sheet: unit, range, default, source.
enum class SetupField : std::uint8_t {
    Depth,
    SpindleSpeed,
    Feed,
    ToolRadius,
    FaceFrom,
    FaceTo,
    TrimAuthority,
};
inline constexpr std::size_t kSetupFields = 7;
[[nodiscard]] std::span<const ParamSpec> setupSpecs() noexcept;  ///< kSetupFields of them
[[nodiscard]] const ParamSpec& toneSpec() noexcept;
[[nodiscard]] double valueOf(const TurningSetup& setup, SetupField field) noexcept;
void setValue(TurningSetup& setup, SetupField field, double value) noexcept;

/// Empty if this setup can be cut; else the sentence for the operator. May run in the cycle.
[[nodiscard]] std::optional<Sentence> whyUnusable(const TurningSetup& setup) noexcept;

}  // namespace kerf::turning
