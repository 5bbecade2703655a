// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/api/tapping_types.h"
#include "engine/core/result.h"

/// The tuning of a tapping cycle outside the engine's cycle: trials, the tuner's proposal, what the operator decides.
/// The page sees values.
namespace kerf {

/// One thread that can be chosen.
struct TapThreadView {
    std::string name{};  ///< "M8", "M8x1"
    double pitch_mm{0.0};
    double allowedPp_um{0.0};         ///< engaged peak-to-peak of E_r, 6H
    double allowedPpWornTap_um{0.0};  ///< with a tap at its upper limit
};

struct TapTrialView {
    std::uint32_t number{0};
    TapFigures figures{};
    double zKp_perS{0.0};
    double zVelocityFf{0.0};
    double trimPeak_um{0.0};
    bool accepted{false};
    bool counted{true};
};

/// E_r of one tap; samples before `reversal` go in, the rest come out.
struct TapCurve {
    std::vector<float> spindle_rev{};
    std::vector<float> error_um{};
    std::size_t reversal{0};
};

/// Result of one tuning at one speed, for the choice between sync error and hole time.
struct TapSpeedPoint {
    double speed_rpm{0.0};
    double hole_s{0.0};
    double engagedPp_um{0.0};
};

enum class TuningState : std::uint8_t { None, AirTap, Trial, Proposed, Done, Failed };

struct TappingDeskView {
    std::uint64_t revision{0};  ///< rises with each change
    TuningState state{TuningState::None};
    Sentence reason{};  ///< of the proposal, or why the tuning ended
    TapThreadView thread{};
    double speed_rpm{0.0};
    double depth_rev{0.0};
    std::vector<TapTrialView> trials{};
    TapCurve first{};
    TapCurve current{};
    double nextZKp_perS{0.0};
    double nextVelocityFf{0.0};
    double expectedSaec_mm{0.0};  ///< of the proposed tap; 0: not predicted
    double lowestZKp_perS{0.0};   ///< safe set
    double highestZKp_perS{0.0};
    double criticalZKp_perS{0.0};
    std::vector<TapSpeedPoint> speeds{};  ///< tunings done since start
};

class TappingDesk {
 public:
    TappingDesk() = default;
    TappingDesk(const TappingDesk&) = delete;
    TappingDesk& operator=(const TappingDesk&) = delete;
    virtual ~TappingDesk() = default;

    [[nodiscard]] virtual const TappingDeskView& view() const = 0;
    [[nodiscard]] virtual const std::vector<TapThreadView>& threads() const = 0;
    /// Begin with the air tap. Refused while a tuning is under way or for an unknown thread.
    [[nodiscard]] virtual Result<void> begin(const std::string& thread, double speed_rpm, double depth_rev) = 0;
    virtual void oneMore() = 0;   ///< make the proposed tap
    virtual void accept() = 0;    ///< keep the best so far
    virtual void rollBack() = 0;  ///< return to the gains before the tuning
    virtual void abort() = 0;     ///< end the running tap in sync
    virtual void recover() = 0;   ///< turn a tap that stands in the hole out in sync
    /// Look for news of the engine; `view().revision` rises when there are any. On a timer of the GUI thread.
    virtual void poll() = 0;
};

}  // namespace kerf
