// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "engine/process/milling/blank_profile.h"
#include "engine/process/milling/cut_simulation.h"
#include "engine/process/milling/plant.h"
#include "engine/process/milling/sampled_force.h"

namespace kerf::milling {

/// A milling machine that bites, with a blank: what a shop floor adds to the paper's. Seed 0 is the reference machine:
/// B0 and the published blank, nothing added.
///
///   material   m uniform .7-.95, θ uniform 30-60°, F_y at 1 mm and .153 mm/rev log-uniform 13-35 kgf
///   tool       k_x log-uniform 20-150 kgf/mm, k_y log-uniform 80-300 kgf/mm; run-out .0-.2; one flute of four is
///   missing
///              with probability .2
///   axis       reaches its feed with a time constant log-uniform .05-.3 s with probability .5, else at once
///   force      noise of a revolution's mean log-uniform .1-5 kgf; everything measured arrives one revolution late with
///              probability .3; zero drifts by uniform −1 to 1 N/s; the dynamometer passes 100 Hz
///   chatter    with probability .2 above an engaged depth of uniform 2-3 mm, at log-uniform 300-900 Hz; the console's
///              simulator only
///   blank      100 mm: the published stairs, a ramp 1 → 3 or 3 → 1 mm, a comb 1-3-1-3 with a step every millimetre, or
///              5 to 10 steps of uniform 1-3 mm; each as likely as the others
/// Drawn again while the feed that holds 40 kgf at 1 or 3 mm lies outside .03 to .35 mm/rev.
struct HardMachine {
    std::uint64_t seed{0};
    PlantParams plant{};
    ForceShape shape{};
    double axisLag_s{0.0};
    double forceNoise_N{0.0};  ///< standard deviation of one averaged force
    bool late{false};
    double drift_NPerS{0.0};
    double corner_Hz{0.0};        ///< of the dynamometer, first order; 0: passes all
    double chattersFrom_mm{0.0};  ///< engaged depth; 0: never
    double chatter_Hz{637.0};
    BlankProfile blank{};
};
[[nodiscard]] HardMachine hardMachine(std::uint64_t seed);
/// Machine, sensor and blank of the cut; its law stays.
void putOn(const HardMachine& machine, CutCase& cut);
/// The cut does not end, or in its second half the force swings: standard deviation above half the reference.
[[nodiscard]] bool unstable(const CutResult& cut, double reference_N);

}  // namespace kerf::milling
