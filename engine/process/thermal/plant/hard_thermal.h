// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

/// Simulated machines that bite, and what a season does to one.
namespace kerf::thermal {

inline constexpr std::size_t kPlantNodes = 18;

/// What differs on a day from the days a model was trained on.
enum class Season : std::uint8_t {
    None,
    Coolant,    ///< on and off: table, saddle and quill at coolant temperature for 10-40 min at a time
    Door,       ///< open: the draught doubles to quadruples what head, saddle and table give to the room
    Sun,        ///< on one side: 30-120 W into the left of the column, a third of it into the bed, for 1-3 h
    Moved,      ///< another hall: 4-10 K colder, twice the swing, and bed and column stand otherwise
    Nonlinear,  ///< three times the thinning of the grease, and a drift that bends by 1-3 % per K
};
inline constexpr std::array<std::string_view, 6> kSeasonKeys{"none", "coolant", "door", "sun", "moved", "nonlinear"};
[[nodiscard]] std::optional<Season> seasonOf(std::string_view key) noexcept;

/// Factors and additions over the reference machine; the defaults change no digit.
///
///   per machine seed N > 0 (N = 0: the reference machine)
///     drift coefficients  × exp(.4·normal) each
///     loss to the room    × exp(.3·normal) each
///     bearing heat        × .7 to 1.4 (uniform), thinning × 1 to 2 (uniform), bend uniform −.01…+.01 per K
///     day spread σ        uniform .05-.35, drawn per day for each drift coefficient and half of it for all of them
///   per season and day seed: see Season, uniform in the ranges given
struct HardThermal {
    std::array<double, kPlantNodes> drift{};   ///< × µm/K
    std::array<double, kPlantNodes> toRoom{};  ///< × W/K
    double bearing{1.0};
    double thinning{1.0};
    double bend_perK{0.0};      ///< drift of a node × (1 + bend · rise)
    double room_K{0.0};         ///< added to the mean of the room
    double swing{1.0};          ///< × swing of the room
    double coolant_WPerK{0.0};  ///< into table, saddle and quill while on
    double coolant_K{0.0};      ///< coolant minus room
    double coolantHalf_s{0.0};  ///< on for so long, off for so long
    double sun_W{0.0};
    double sunFrom_s{0.0};
    double sunTo_s{0.0};

    HardThermal() {
        drift.fill(1.0);
        toRoom.fill(1.0);
    }
};
[[nodiscard]] HardThermal hardThermal(std::uint64_t machineSeed, Season season, std::uint64_t daySeed) noexcept;

}  // namespace kerf::thermal
