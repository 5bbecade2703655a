// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/process/milling/feed_controller.h"
#include "engine/process/milling/plant.h"
#include "engine/process/milling/waviness.h"

namespace kerf::milling {

/// One cut, revolution by revolution, at constant spindle speed: the plant, a law and what stands between them.
struct CutCase {
    PlantParams plant{};
    BlankProfile blank{};
    FeedController::Params controller{};
    LawKind law{LawKind::Model};
    std::optional<BlankProfile> believedBlank{};  ///< what the preview law is told
    double spindle_rpm{600.0};
    double pulse_mm{0.0254};
    bool wholePulses{false};   ///< the axis moves whole pulses per revolution, the rest is carried
    double forceNoise_N{0.0};  ///< standard deviation of one averaged force
    bool lag{false};           ///< each revolution's measurement, force and feed, reaches the law one revolution late
    int forceLate_rev{0};      ///< revolutions by which the force alone arrives late, 0…2
    double axisLag_s{0.0};     ///< time constant with which the axis reaches the feed commanded, ≥ 0
    double drift_NPerS{0.0};   ///< of the force sensor's zero
    double fromAir_mm{0.0};    ///< the tool starts this far before the blank, in air
    std::uint64_t seed{1};
    WallScan scan{};  ///< length_mm is taken from the blank
};

/// One revolution of a simulated cut.
struct CutRow {
    int revolution{0};
    double x_mm{0.0};      ///< tool tip at the end of the revolution
    double depth_mm{0.0};  ///< engaged depth met in it
    double feedCommand_mmPerS{0.0};
    double cutFeed_mmPerRev{0.0};  ///< l
    double force_N{0.0};           ///< F_y
    double forceMeasured_N{0.0};   ///< what the sensor said
    double deflectionY_mm{0.0};
};

struct CutSummary {
    std::optional<Waviness> waviness{};
    double time_s{0.0};
    double peakForce_N{0.0};        ///< highest F_y anywhere in the cut
    double feedUnrest_mmPerS{0.0};  ///< mean |second difference| of the commanded feed over revolutions in the scan
    bool finished{false};           ///< false: the feed stalled before the end of the blank
};

struct CutResult {
    std::vector<CutRow> rows{};
    CutSummary summary{};
};

/// Pure: same case, same digits. Allocates; not for the cycle.
[[nodiscard]] CutResult simulateCut(const CutCase& cut);

}  // namespace kerf::milling
