// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "engine/core/reading.h"

/// What the turning page sets and sees. Plain values that the rings can carry.
namespace kerf {

inline constexpr std::size_t kTurningTones = 8;

/// The next part's cut. A part being cut keeps the setup it began with.
struct TurningSetup {
    std::uint32_t revision{0};        ///< 0: none loaded
    double depth_um{6.0};             ///< d0, (0, 50]
    double spindleSpeed_rpm{1032.0};  ///< 17.2 rev/s, [150, 30000]
    double feed_umPerRev{5.8};        ///< (0, 1000]
    double toolRadius_um{800.0};      ///< > depth
    double faceFrom_mm{0.0};          ///< along the face, from the outside
    double faceTo_mm{1.0};            ///< > faceFrom
    double trimAuthority_um{2.0};     ///< largest trim of the tool, [0, 2]: the machine's limit stands beside it
    std::array<double, kTurningTones> knownTones_Hz{17.0, 52.0, 86.0, 113.0, 120.0};  ///< of this machine, 9 to 400
    std::uint8_t knownToneCount{5};
};
static_assert(std::is_trivially_copyable_v<TurningSetup>);

/// Where the tool stands.
enum class TurningStage : std::uint8_t {
    Idle,   ///< no turning program
    Air,    ///< out of the cut: the sensor's zero is taken here
    Entry,  ///< touched; the first revolution and the build-up of the depth
    Cutting,
    Out,  ///< left the loop in this part: sensor, tool or trim (see the reason)
};

/// One tone of the disturbance as the loop sees it.
struct TurningTone {
    double frequency_Hz{0.0};
    double amplitude_um{0.0};
    double visibility{0.0};  ///< |1 − exp(−jωd)|, 0 blind to 2
    bool blind{false};       ///< the force cannot see it at this speed
};

/// a1, b0, b1 with the half width of their 95 % intervals.
struct TurningIdentification {
    bool available{false};  ///< needs a sensor of the tool's motion
    std::array<double, 3> value{};
    std::array<double, 3> half95{};
    double trace{0.0};
    double excitation{0.0};  ///< chip's variation as force over the noise
    double residual_N{0.0};
};

struct TurningStatus {
    TurningStage stage{TurningStage::Idle};
    std::uint32_t activeSetup{0};
    std::uint32_t nextSetup{0};
    double progress{0.0};       ///< 0…1 along the face
    Reading force_N{};          ///< zero taken off
    double forceMean_N{0.0};    ///< over the last ~.1 s
    double forceTarget_N{0.0};  ///< P's gain at rest times d0
    double forcePeak_N{0.0};
    double forceZero_N{0.0};       ///< taken out of the cut
    double depth_um{0.0};          ///< d0
    double depthEstimate_um{0.0};  ///< û, mean of ~.1 s
    double trim_um{0.0};           ///< wanted
    double appliedTrim_um{0.0};
    bool acting{false};
    double surfaceRms_um{0.0};    ///< predicted, about its level
    double surfacePv_um{0.0};     ///< of the last whole revolution
    double untreatedRms_um{0.0};  ///< what it would be without the loop
    double overlap{0.0};
    Reading touchOff_mm{};  ///< where the tool touched
    std::array<TurningTone, kTurningTones> tones{};
    std::uint8_t toneCount{0};
    TurningIdentification identification{};
    double gainRatio{1.0};  ///< mean force over its value at the start of this cut
    std::uint32_t partsCut{0};
};
static_assert(std::is_trivially_copyable_v<TurningStatus>);

/// A finished part's figures for the archive.
struct TurningRecord {
    bool valid{false};
    TurningSetup setup{};
    double surfaceRms_um{0.0};
    double surfacePv_um{0.0};
    double untreatedRms_um{0.0};
    double forceTarget_N{0.0};
    double touchOff_mm{0.0};
    double trimPeak_um{0.0};
    bool leftLoop{false};  ///< the loop let go before the end
};
static_assert(std::is_trivially_copyable_v<TurningRecord>);

}  // namespace kerf
