// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Quantiles and tail probabilities that charts, intervals and tests need. All dimensionless; the library behind them
/// is Boost.Math, which stays inside the .cpp.
namespace kerf::quality {

/// z with Φ(z) = p. @pre 0 < p < 1
[[nodiscard]] double normalQuantile(double p);
/// x with P(χ²ₙ ≤ x) = p. @pre 0 < p < 1, degrees > 0
[[nodiscard]] double chiSquareQuantile(double degrees, double p);
/// P(χ²ₙ > x). @pre degrees > 0; x ≤ 0 gives 1
[[nodiscard]] double chiSquareUpperTail(double degrees, double x);
/// P(F > f). @pre both degrees > 0; f ≤ 0 gives 1
[[nodiscard]] double fUpperTail(double numeratorDegrees, double denominatorDegrees, double f);

}  // namespace kerf::quality
