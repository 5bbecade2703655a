// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/quality/verdict.h"

#include <array>
#include <cmath>
#include <string_view>

namespace kerf::quality {
namespace {

constexpr std::array<const char*, 4> kKeys{"good", "not_judged", "rework", "scrap"};

}  // namespace

const char* verdictKey(Verdict verdict) noexcept {
    return kKeys[static_cast<std::size_t>(verdict)];
}

std::optional<Verdict> verdictOf(const char* key) noexcept {
    for (std::size_t i = 0; i < kKeys.size(); ++i) {
        if (std::string_view(key) == kKeys[i]) {
            return static_cast<Verdict>(i);
        }
    }
    return std::nullopt;
}

Verdict judge(std::optional<double> value, const Tolerance& tolerance) noexcept {
    if (!value || !std::isfinite(*value) || !tolerance.given()) {
        return Verdict::NotJudged;
    }
    if (tolerance.lower && *value < *tolerance.lower) {
        return tolerance.rework == ReworkSide::Below ? Verdict::Rework : Verdict::Scrap;
    }
    if (tolerance.upper && *value > *tolerance.upper) {
        return tolerance.rework == ReworkSide::Above ? Verdict::Rework : Verdict::Scrap;
    }
    return Verdict::Good;
}

}  // namespace kerf::quality
