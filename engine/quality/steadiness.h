// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "engine/quality/charts.h"

/// Whether a finished series as a whole speaks against a capability: charts that run from part to part alarm by chance
/// every few hundred parts, so that over a long lot "no signal at all" would never hold.
///
///   largest error      |e| ≤ z(1 − a/(2n))                     one part far off
///   EWMA of e          |z_t| ≤ z(1 − a/(2n))·√(λ/(2 − λ))      a level that has moved and stays
///   mean square successive difference (von Neumann)
///                      η = Σ(e_{t+1} − e_t)²/Σ(e_t − ē)²,  (2 − η)/√(4(n − 2)/(n² − 1)) ≤ z(1 − a)   drift, levels
///
/// a is a third of `kUnsteadyByChance`, so that at most about one steady series in a hundred is called unsteady,
/// whatever its length. Source: von Neumann, Annals of Mathematical Statistics 12 (1941) 367; Bonferroni's inequality.
namespace kerf::quality {

inline constexpr double kUnsteadyByChance = 0.01;

/// What one of the tests may take of it, for one of `points` errors. @pre points > 0
[[nodiscard]] double chanceOfOnePoint(std::size_t points) noexcept;

/// `errors` standardised by a law, or by centre and σ of the process: e ~ N(0, 1) when nothing happens.
[[nodiscard]] bool isSteady(std::span<const double> errors);
/// Raw values of which nobody has given centre and σ: centre and s of the series for the largest error, the mean moving
/// range for the EWMA. Values all alike are steady.
[[nodiscard]] bool isSteadySeries(std::span<const double> values);

}  // namespace kerf::quality
