// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

/// Whether a characteristic lies in its tolerance, and what can be done when it does not.
namespace kerf::quality {

/// Which way a part that is out of tolerance can still be made good by cutting again.
enum class ReworkSide : std::uint8_t {
    None,   ///< never: a surface, a thread, a force
    Below,  ///< a bore that is too small can be bored again
    Above,  ///< a shaft or wall that is too thick can be cut again
};

/// Limits belong to the tolerance: a value on a limit is good. Unit of the characteristic.
struct Tolerance {
    std::optional<double> lower{};
    std::optional<double> upper{};
    ReworkSide rework{ReworkSide::None};

    [[nodiscard]] bool given() const noexcept { return lower.has_value() || upper.has_value(); }
    friend bool operator==(const Tolerance&, const Tolerance&) = default;
};

/// In the order of severity: the verdict on a part is the worst of its characteristics'.
enum class Verdict : std::uint8_t {
    Good,
    NotJudged,  ///< no tolerance, or not measured (yet): never taken for good
    Rework,     ///< out of tolerance on the side that can be cut again
    Scrap,
};

/// "good", "not_judged", "rework", "scrap": files, commands and the database.
[[nodiscard]] const char* verdictKey(Verdict verdict) noexcept;
[[nodiscard]] std::optional<Verdict> verdictOf(const char* key) noexcept;

/// No value, no finite value or no tolerance is NotJudged.
[[nodiscard]] Verdict judge(std::optional<double> value, const Tolerance& tolerance) noexcept;

/// Scrap beats rework beats not judged beats good.
[[nodiscard]] constexpr Verdict worse(Verdict one, Verdict other) noexcept {
    return one < other ? other : one;
}

}  // namespace kerf::quality
