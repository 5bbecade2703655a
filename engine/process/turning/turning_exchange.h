// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "engine/core/latest_value.h"
#include "engine/process/turning/turning_types.h"

namespace kerf {

/// Surface as the force shows it, 1250 values per second (means of four samples of 5 kHz), with and without the trim.
struct TurningSurface {
    static constexpr std::size_t kPoints = 2048;  ///< 1.6 s
    static constexpr std::size_t kDecimation = 4;
    static constexpr double kRate_Hz = 5000.0 / kDecimation;

    std::uint32_t partSequence{0};
    std::uint32_t number{0};  ///< in this part, from 1
    std::uint32_t count{0};   ///< values filled: the last one of a part may be short
    bool trimmed{false};      ///< the law acted from the first to the last value
    double spindle_rps{0.0};
    std::array<float, kPoints> treated_um{};    ///< x_i about its level
    std::array<float, kPoints> untreated_um{};  ///< what it would be without the trim
};

/// Force along the face of one part, decimated: lowest, mean and highest of every piece.
struct TurningForceTrace {
    static constexpr std::size_t kPieces = 200;

    std::uint32_t partSequence{0};
    std::array<std::uint32_t, kPieces> samples{};  ///< 0: not cut
    std::array<float, kPieces> low_N{};
    std::array<float, kPieces> mean_N{};
    std::array<float, kPieces> high_N{};
};

/// What stored parts of the same cut have left for the next part to begin from: service → loop.
struct TurningRecall {
    bool processKnown{false};  ///< take the law's process from here, once; false: it stays as it is
    TurningProcess process{};
    bool assumed{false};  ///< not known, and what the loop goes by does not count any more: the assumed process
};

/// What passes between the loop (engine thread) and the service (one other thread) beside status and part records.
/// Large, so it is made once, on the heap, before the engine starts.
struct TurningExchange {
    LatestValue<TurningSurface> surfaces{};   ///< written every 1.6 s of cutting
    LatestValue<TurningForceTrace> traces{};  ///< written at the end of a part
    LatestValue<TurningRecall> recall{};      ///< read when a part begins; written by the service
};

}  // namespace kerf
