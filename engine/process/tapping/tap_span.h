// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

/// Where in a record the tap is.
namespace kerf::tapping {

struct TapSpan {
    std::size_t begin{0};      ///< the sample at which Z began to follow the spindle
    std::size_t end{0};        ///< one behind the last that belongs to the tap
    bool counterReset{false};  ///< the spindle's counter was set anew at `begin`, as G33 does at its index
};

/// A control records from before: the spindle turns, Z stands, then the spindle's counter is set to zero at its index
/// (once, by any amount) and Z follows; afterwards the spindle may go on while Z stands again.
///
///   z = P·(s − s0) + lags of both axes    least squares over the samples in which Z moves
///
/// Rapids to the hole and away from it are left out first: the hole's bottom is where Z and spindle turn round
/// together, and the tap lies between the height at which Z stood before it (16 samples below 1 % of the speed of the
/// way in) and the way back to that height. A motion that keeps the way in's slope within 20 % is no rapid and stays:
/// it is the tap's, however badly it follows.
///
/// s0, the spindle's position at synchronisation, is where the tap begins; a counter set anew after that moves the
/// begin there. A record that begins at synchronisation, with less than .2 rev before it, is the whole span, and so is
/// one in which no thread is found: whatever is wrong with it is for checkRecord() to say.
/// @pre the spans are of one length
[[nodiscard]] TapSpan findTap(std::span<const double> spindle_rev, std::span<const double> z_mm);

}  // namespace kerf::tapping
