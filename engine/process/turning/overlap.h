// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/core/result.h"

namespace kerf::turning {

/// Share µ of the chip that the previous revolution has already taken away.
///
///   µ = (A − d0·f)/A,  A = R²·h − R·(R − d0)·sin h,  h = acos((R − d0)/R)
///
/// R tool nose radius, d0 depth of cut, f infeed per revolution (feed / spindle speed), all in µm. A is the area of
/// the nose segment in the material; d0·f the area of one revolution's chip.
/// Source: Jeong & Kim, eqs. 1-2. Their table prints .98, which these equations give only for f = 2.61 µm/rev.
/// Errors: R > 0, 0 < d0 ≤ R, 0 ≤ f, and d0·f ≤ A (a wider infeed leaves no overlap); else a sentence.
[[nodiscard]] Result<double> overlapFactor(double toolRadius_um, double depth_um, double infeed_umPerRev);

}  // namespace kerf::turning
