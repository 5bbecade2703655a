// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/random.h"
#include "engine/process/boring/model.h"

/// The spindle as it really is, for the simulator: eq. 2 with constants that change, drift, and differ from the
/// estimate.
namespace kerf::boring {

/// The truth from one part on.
struct TruthChange {
    std::uint32_t fromPart{1};
    LawConstants law{};
};

/// The law part by part: a list of changes and a drift of C that never stops.
struct TruthPlan {
    std::vector<TruthChange> changes{{1, {}}};  ///< rising fromPart; the first one starts at part 1
    double drift_percentPerPart{0.0};           ///< C grows by this from part to part

    /// The built-in machine, unchanged.
    [[nodiscard]] static TruthPlan table();
    /// The paper's lot: changes at parts 11 and 21.
    [[nodiscard]] static TruthPlan paper();
    [[nodiscard]] LawConstants at(std::uint32_t part) const noexcept;
    /// First parts with a new law.
    [[nodiscard]] std::vector<std::uint32_t> changeParts() const;
};

/// A lot with two changes at random parts 5…15 and 16…26. After each: α in [.3, .8), β in [.1, .5), and a level that
/// moves the deflection at (.114 mm/rev, 175 mm) to between e^−.8 and e^.8 times the target; drawn again while the best
/// feed at 40 or 310 mm lies outside .01 to 1 mm/rev.
[[nodiscard]] TruthPlan randomChanges(Random& random, double targetDeflection_mm);

/// A machine that bites: what a shop floor adds to the law. Seed 0 is the reference machine: table 1, nothing added.
///
///   law        level (ln d at .17 mm/rev and √(40·310) mm) ln d0 + N(0, .3), α uniform .35-.8, β uniform .1-.5
///   change     unannounced, at a part uniform 8-22: level N(0, .25), α N(0, .08), β N(0, .06) further
///   gauge      σ is the assumed one times 2^uniform(-1, 1)
///   wear       ln d grows by uniform 0-.01 per part; and along each bore by uniform 0-.03 up to its end
///   hardness   ln d wanders from part to part: AR(1), coefficient uniform .3-.9, standard deviation uniform 0-.03
///   warmth     parts are gauged warm: uniform 0-15 K above 20 °C, 3 K about it from part to part
/// Drawn again while the best feed at 40 or 310 mm lies outside .01 to 1 mm/rev.
struct HardMachine {
    std::uint64_t seed{0};
    TruthPlan truth{TruthPlan::table()};
    double sigmaFactor{1.0};
    double wearAlongBore{0.0};  ///< of ln d, at the end of the bore
    double hardnessMemory{0.0}, hardnessSpread{0.0};
    double warm_K{0.0}, warmSpread_K{0.0};
};
[[nodiscard]] HardMachine hardMachine(std::uint64_t seed, double targetDeflection_mm);

/// Measured deflection: truth plus gauge noise. May come out negative when the noise is large.
[[nodiscard]] inline double measured_mm(double true_mm, double sigma_mm, double z) noexcept {
    return true_mm + sigma_mm * z;
}

}  // namespace kerf::boring
