// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "engine/core/force_signal.h"
#include "engine/core/reading.h"

/// What the turning page sets and sees. Plain values that the rings can carry.
namespace kerf {

inline constexpr std::size_t kTurningTones = 8;
inline constexpr std::size_t kTurningFilters = 6;  ///< of the broadband prediction

/// Which law trims the tool. All of them act on the depth error d0 − û only.
enum class TurningController : std::uint8_t {
    Open,   ///< no trim; the disturbance is watched
    Paper,  ///< the paper's PI with its own gain
    Pi,     ///< the same law, tuned
    Tones,  ///< the default: cancels the tones of the disturbance
};
inline constexpr std::size_t kTurningControllers = 4;

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
    std::array<double, kTurningTones> knownTones_Hz{};  ///< of this machine, 9 to 400
    std::uint8_t knownToneCount{0};
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
    double share{0.0};       ///< of a new deviation that the tone's amplitude takes over per sample (Kalman gain)
};

/// Cutting process as plain numbers: F(k) = a1 F(k−1) + b0 u(k) + b1 u(k−1); b0 and b1 in N/µm.
struct TurningProcess {
    double a1{0.8725};
    double b0{0.7470};
    double b1{-0.7164};
};

/// a1, b0, b1 with the half width of their 95 % intervals.
struct TurningIdentification {
    bool available{false};  ///< needs a sensor of the tool's motion
    bool sure{false};       ///< excited, and the intervals are narrow: good enough to tune the law by
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
    double forceZero_N{0.0};  ///< taken out of the cut
    ForceSignal signal{};     ///< what the machine brings
    ForceZeroState zero{ForceZeroState::Own};
    double zeroDoubt_N{0.0};       ///< how wrong the zero may be by now
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
    double toneShare{0.0};  ///< how far the law trusts its tones, 0 … 1
    /// Weights of the broadband predictions of the default law: of the motion as it is, and of what the tones leave.
    std::array<double, kTurningFilters> plainWeights{};
    std::array<double, kTurningFilters> underToneWeights{};
    TurningIdentification identification{};
    TurningController controller{TurningController::Tones};
    TurningProcess lawProcess{};  ///< what the law is tuned to
    std::uint32_t retuned{0};     ///< times the law was tuned anew since the engine began
    double gainRatio{1.0};        ///< mean force over its value at the start of this cut
    std::uint32_t partsCut{0};
};
static_assert(std::is_trivially_copyable_v<TurningStatus>);

/// A finished part's figures for the archive.
struct TurningRecord {
    bool valid{false};
    TurningSetup setup{};
    TurningController controller{TurningController::Tones};
    bool controlled{false};        ///< the loop was in control from the touch to the end
    double surfaceRms_um{0.0};     ///< from .4 s after the touch to the end
    double surfacePv_um{0.0};      ///< of the last whole revolution
    double untreatedRms_um{0.0};   ///< what the RMS would have been without the trim
    double steadyRms_um{0.0};      ///< second half of the face, about its level; 0: not reached
    double steadyPv_um{0.0};       ///< highest minus lowest of the second half
    double steadyForce_N{0.0};     ///< mean force of the second half
    double openSteadyRms_um{0.0};  ///< the same second half without the trim
    double openSteadyPv_um{0.0};
    double forceTarget_N{0.0};
    double forceZero_N{0.0};  ///< taken in the air before the touch
    double touchOff_mm{0.0};
    double trimPeak_um{0.0};
    bool leftLoop{false};  ///< the loop let go before the end
    std::array<TurningTone, kTurningTones> tones{};
    std::uint8_t toneCount{0};
    TurningIdentification identification{};
    TurningProcess lawProcess{};
    std::uint32_t retuned{0};  ///< times within this part
};
static_assert(std::is_trivially_copyable_v<TurningRecord>);

}  // namespace kerf
