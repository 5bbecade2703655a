// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "engine/process/milling/blank_profile.h"

namespace kerf::milling {

/// How the height of a drawn blank goes along its 100 mm, in steps of .5 mm, from 1 to 3 mm:
///
///   sine   period log-uniform 5-50 mm
///   saw    the same period; rises over a share of it uniform .1-.9, falls over the rest
///   walk   a step every .5 mm, normal with a standard deviation log-uniform .05-.3 mm, thrown back at 1 and 3 mm
///   steps  of log-uniform 3-30 mm length each, height uniform 1-3 mm
///   flat   height uniform 1-3 mm
/// Sine and saw lie between two heights at least 1 mm apart.
enum class BlankKind : std::uint8_t { Sine, Saw, Walk, Steps, Flat };

struct DrawnBlank {
    BlankKind kind{BlankKind::Flat};
    BlankProfile blank{};
};

/// Blank `index` of a seed: sine, saw, walk, steps, sine, walk, steps, saw, sine, walk, steps, flat, and again.
[[nodiscard]] DrawnBlank drawnBlank(std::uint64_t seed, std::uint64_t index);

}  // namespace kerf::milling
