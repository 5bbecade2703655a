// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "engine/core/force_signal.h"
#include "engine/core/reading.h"
#include "engine/core/sentence.h"

namespace kerf {

/// How the feed is chosen: see docs/milling.md.
enum class MillingLaw : std::uint8_t { Constant, Pi, Model, Preview };
inline constexpr std::size_t kMillingLawCount = 4;

/// Everything the milling loop needs for the next parts. Checked whole; a part being cut keeps the one it began with,
/// but reference and law can be changed while cutting.
struct MillingSetup {
    std::uint32_t revision{0};  ///< rises with every new setup; 0: none loaded
    MillingLaw law{MillingLaw::Model};
    double reference_N{392.0};       ///< averaged normal force to hold, > 0
    double overload_N{650.0};        ///< averaged force that stops the feed, > reference
    double plannedFeed_mmPerS{1.5};  ///< what a person would program; constant law, and the most without a force
    double highestFeed_mmPerS{4.0};  ///< ≥ planned
    double lowestFeed_mmPerS{0.2};   ///< > 0, ≤ planned
    double entryFeed_mmPerS{1.0};    ///< in air, > 0
    double spindleSpeed_rpm{600.0};  ///< 60…12,000
    double from_mm{-5.0};            ///< path, begins in air
    double to_mm{110.0};
    double toolRadius_mm{5.0};
    std::uint8_t flutes{4};         ///< 1…16
    double exponent{0.85};          ///< m of the material
    double forceAngle_deg{45.0};    ///< θ
    double ky_NPerMm{1471.0};       ///< tool stiffness across the wall: turns force into wall deviation
    double kp_mmPerSPerN{0.01905};  ///< PI law
    double ki_mmPerSPerN{0.00381};
    double wearWarning{0.3};  ///< rise of ln(C b) since the tool was new that raises the warning, > 0
};
static_assert(std::is_trivially_copyable_v<MillingSetup>);

/// Blank profile for the preview law: steps that begin at `begin_mm` with `height_mm`; air before and after.
struct MillingBlank {
    static constexpr std::size_t kMaxSteps = 32;
    std::uint32_t revision{0};  ///< told back in the status
    std::uint16_t count{0};     ///< 0: no profile
    std::array<double, kMaxSteps> begin_mm{};
    std::array<double, kMaxSteps> height_mm{};
    double end_mm{0.0};
};
static_assert(std::is_trivially_copyable_v<MillingBlank>);

inline constexpr std::size_t kMillingKxFilters = 9;

/// What is learnt of the tool in the spindle: its wear over parts and its stiffness. All that a restart needs to go on.
struct MillingToolState {
    std::uint32_t parts{0};      ///< cut with this tool
    double firstStiffness{0.0};  ///< mean ln(C b) of its first part
    double lastStiffness{0.0};   ///< of its last one
    double sumRise{0.0};         ///< Σ y and Σ i·y over its parts i = 0, 1, …; y: rise of ln(C b) since the first
    double sumIndexRise{0.0};
    std::array<double, kMillingKxFilters> kxLogWeight{};  ///< of the stiffness filters, soft to stiff; highest is 0
    friend bool operator==(const MillingToolState&, const MillingToolState&) = default;
};
static_assert(std::is_trivially_copyable_v<MillingToolState>);

/// One cut as the log keeps it; part of PartRecord.
struct MillingCut {
    MillingLaw law{MillingLaw::Constant};
    bool advised{false};  ///< the loop only advised: the cut was made at the planned feed
    double reference_N{0.0};
    double plannedTime_s{0.0};     ///< the same path at the planned feed
    double cutTime_s{0.0};         ///< as cut
    double controlledTime_s{0.0};  ///< as cut under control; when advised: what control would have taken
    double peakForce_N{0.0};       ///< highest revolution average
    double peakAt_mm{0.0};         ///< where
    double meanForce_N{0.0};
    double overReference_s{0.0};  ///< time with more than 110 % of the reference
    double waviness_um{0.0};      ///< predicted from the force; 0 when too short
    double stiffnessMean{0.0};    ///< mean ln(C b) in the work
    double stiffnessHalf95{0.0};
    std::uint32_t stops{0};  ///< feed holds by the loop
};
static_assert(std::is_trivially_copyable_v<MillingCut>);

/// Live figures of the milling loop, part of Status.
struct MillingStatus {
    bool cutting{false};
    bool inAir{true};
    bool blind{false};                                        ///< no force that can be trusted
    bool stopped{false};                                      ///< the loop holds the feed until somebody releases it
    MillingLaw law{MillingLaw::Model};                        ///< wanted
    std::array<Sentence, kMillingLawCount> lawUnavailable{};  ///< empty: the law can be chosen
    std::uint32_t setup{0};                                   ///< revision in use
    std::uint32_t blank{0};                                   ///< revision of the blank profile in use
    Reading force_N{};                                        ///< averaged over the last revolution
    double forceLow_N{0.0};                                   ///< raw force within it
    double forceHigh_N{0.0};
    ForceSignal signal{};      ///< what the machine brings
    double decisions_Hz{0.0};  ///< how often the loop decides: whole revolutions, never faster than the signal
    bool teethSeen{false};     ///< the signal shows single teeth: breakage is watched
    ForceZeroState zero{ForceZeroState::Own};
    double zero_N{0.0};       ///< subtracted from the signal
    double zeroDoubt_N{0.0};  ///< how wrong it may be by now
    double reference_N{0.0};
    double overload_N{0.0};
    double wantedFeed_mmPerS{0.0};
    double position_mm{0.0};
    double progress{0.0};  ///< 0…1 along the path
    double revolution_s{0.0};
    bool stiffnessKnown{false};
    double stiffness{0.0};  ///< ln(C b)
    double stiffnessHalf95{0.0};
    double kx_NPerMm{0.0};
    double wallDeviation_um{0.0};  ///< of the last revolution
    double waviness_um{0.0};       ///< of this cut so far
    double gainMargin{0.0};        ///< factor by which the loop gain may grow before it rings; 0: unknown
    double wear{0.0};              ///< rise of mean ln(C b) since the tool was new
    double wearPerPart{0.0};       ///< trend
    std::uint32_t partsWithTool{0};
    double wearWarning{0.0};      ///< threshold of `wear`
    MillingToolState tool{};      ///< part records bring it along
    double savedTime_s{0.0};      ///< this cut: against the planned feed; advising: what control would save
    double overReference_s{0.0};  ///< this cut: time with more than 110 % of the reference
    double peakForce_N{0.0};      ///< this cut: highest averaged force, and where
    double peakAt_mm{0.0};
    double meanForce_N{0.0};  ///< this cut, or the last one; 0: nothing to teach from
    std::uint32_t stops{0};   ///< this cut: feed holds; advising: those that control would have made
    std::uint32_t partsCut{0};
};
static_assert(std::is_trivially_copyable_v<MillingStatus>);

}  // namespace kerf
