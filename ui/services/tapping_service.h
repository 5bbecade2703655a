// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/process/tapping/tapping_types.h"
#include "ui/services/lot_service.h"
#include "ui/services/recipe_history.h"

/// The tuning of a tapping cycle outside the engine's cycle: trials, the tuner's proposal, what the operator decides,
/// what has been tuned before. The page sees values.
namespace kerf {

/// One thread that can be chosen.
struct TapThreadView {
    std::string name{};  ///< "M8", "M8x1"
    double pitch_mm{0.0};
    double allowedPp_um{0.0};         ///< engaged peak-to-peak of E_r, 6H
    double allowedPpWornTap_um{0.0};  ///< with a tap at its upper limit
    bool coarse{true};
};

/// What is tapped, and with what. Tunings are kept per choice.
struct TapChoice {
    std::string thread{"M8"};
    double speed_rpm{3000.0};
    double depth_rev{22.0};
    std::uint8_t gear{1};
    std::string partType{"1"};
    std::string tap{"1"};
};

/// Gains and feed-forward in the machine's own units, and the size of the learned trim.
struct TapSettingsView {
    double spindleKp_perS{0.0};
    double zKp_perS{0.0};
    double zVelocityFf{0.0};
    double zAccelFf{0.0};
    double trimPeak_um{0.0};
};

struct TapTrialView {
    std::uint32_t number{0};
    TapFigures figures{};
    TapSettingsView settings{};
    bool accepted{false};
    bool counted{true};
};

/// E_r of one tap; samples before `reversal` go in, the rest come out.
struct TapCurve {
    std::vector<float> spindle_rev{};
    std::vector<float> error_um{};
    std::size_t reversal{0};
};

/// One tuning at one speed, for the choice between sync error and hole time.
struct TapSpeedPoint {
    TapChoice choice{};
    double hole_s{0.0};
    double firstPp_um{0.0};    ///< engaged peak-to-peak of its first tap
    double engagedPp_um{0.0};  ///< of its last
    bool current{false};       ///< the choice that is loaded
};

/// Before and after of the tuning whose gains are in force.
struct TuningProof {
    TapSettingsView before{};
    TapSettingsView after{};
    TapFigures first{};
    TapFigures last{};
    std::uint32_t taps{0};
    std::string author{};
    bool rolledBack{false};  ///< a person went back to `before`
    /// SAEC, 0…1; negative when it grew.
    [[nodiscard]] double reduction() const { return first.saec_mm > 0.0 ? 1.0 - last.saec_mm / first.saec_mm : 0.0; }
};

/// Where the gains in force come from.
enum class GainsSource : std::uint8_t {
    Machine,      ///< the machine's own: nothing is stored for this choice
    Stored,       ///< a stored tuning of this choice, trim included
    StoredGains,  ///< a stored tuning of the same speed range: gains and feed-forward, not its trim
    Tuned,        ///< tuned since the choice was loaded
};

enum class TuningState : std::uint8_t { None, AirTap, Trial, Proposed, Done, Failed };

struct TappingServiceView {
    std::uint64_t revision{0};  ///< rises with each change
    TuningState state{TuningState::None};
    Sentence reason{};      ///< of the proposal, or why the tuning ended
    Sentence help{};        ///< what would help a tuning outside the tolerance; else empty
    bool finished{false};   ///< Proposed: the tuner expects nothing of a further tap
    bool mayTapMore{true};  ///< Proposed: the taps of a tuning are not used up
    bool automatic{false};  ///< proposals are tapped and accepted at once
    bool loaded{false};     ///< a job has been loaded, and is `choice`
    TapChoice choice{};
    TapThreadView thread{};
    double engage_rev{3.0};  ///< until the tap touches
    std::vector<TapTrialView> trials{};
    TapCurve first{};    ///< of this tuning, or of the stored one
    TapCurve current{};  ///< the last tap, trial or production
    TapSettingsView inForce{};
    GainsSource source{GainsSource::Machine};
    TapSettingsView next{};       ///< proposed
    double expectedSaec_mm{0.0};  ///< of the proposed tap; 0: not predicted
    double lowestZKp_perS{0.0};   ///< safe set
    double highestZKp_perS{0.0};
    double criticalZKp_perS{0.0};            ///< estimated; 0: not yet
    std::optional<TuningProof> proof{};      ///< of the gains in force
    std::vector<TapSpeedPoint> speeds{};     ///< tunings of this thread, tap and gear, by speed
    std::vector<float> productionSaec_mm{};  ///< the last production taps of this job, oldest first
    std::string leftOut{};    ///< "Lee: other bar" when a stored tuning of this job is left out; else empty
    Sentence storeProblem{};  ///< why the last tuning is not on the disk
};

class TappingService {
 public:
    TappingService() = default;
    TappingService(const TappingService&) = delete;
    TappingService& operator=(const TappingService&) = delete;
    virtual ~TappingService() = default;

    [[nodiscard]] virtual const TappingServiceView& view() const = 0;
    [[nodiscard]] virtual const std::vector<TapThreadView>& threads() const = 0;
    /// Load this job with the gains stored for it, else with the machine's own. Its first tap is made in the air.
    /// Refused during a tuning or a tap, for an unknown thread and for values out of range.
    [[nodiscard]] virtual Result<void> load(const TapChoice& choice, const std::string& author) = 0;
    /// Tune the loaded job, the air tap first. Refused while a tuning is under way.
    [[nodiscard]] virtual Result<void> begin(const std::string& author, bool automatic) = 0;
    /// Leave the stored tuning that the loaded job began from out, for a reason: the job is loaded again with the next
    /// one, or the machine's own gains. Or take in again what was left out of it.
    [[nodiscard]] virtual Result<void> leaveOut(bool out, const std::string& author, const std::string& reason) = 0;
    /// The revisions of this thread's recipe: the tunings that were accepted. Null: there is no store behind the
    /// service.
    [[nodiscard]] virtual RecipeHistory* recipes() { return nullptr; }
    /// The lots of this thread. Null: there is no store behind the service.
    [[nodiscard]] virtual LotService* lots() { return nullptr; }
    virtual void setAutomatic(bool automatic, const std::string& author) = 0;
    virtual void oneMore(const std::string& author) = 0;   ///< make the proposed tap
    virtual void accept(const std::string& author) = 0;    ///< keep the best so far
    virtual void rollBack(const std::string& author) = 0;  ///< return to the gains before the tuning
    virtual void abort() = 0;                              ///< end the running tap in sync
    virtual void recover() = 0;                            ///< turn a tap that stands in the hole out in sync
    /// Look for news of the engine; `view().revision` rises when there are any. On a timer of the GUI thread.
    virtual void poll() = 0;
};

}  // namespace kerf
