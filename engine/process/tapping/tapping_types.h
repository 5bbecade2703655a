// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "engine/core/sentence.h"
#include "engine/port/machine_port.h"

namespace kerf {

inline constexpr std::size_t kMaxTapTicks = 16'384;  ///< longest record: 16 s at 1 kHz

/// One tapped hole as programmed, with what the loop watches. Sent whole; a new job starts with an air tap.
struct TappingJob {
    std::uint32_t revision{0};  ///< 0: none
    double pitch_mm{1.25};
    double depth_rev{22.0};
    double speed_rpm{3000.0};
    double engage_rev{3.0};       ///< revolutions until the tap touches
    double abortError_um{800.0};  ///< |E_r| that ends a tap: retract in sync, gains rolled back
    double allowedPp_um{92.0};    ///< of the thread's tolerance, shown beside the result
    std::uint8_t gear{1};         ///< spindle gear, 1…9: another gear is another spindle
};

/// Servo gains and feed-forward for the next taps. zFeedForward: [0] share of the commanded Z speed, [1] share of the
/// commanded Z acceleration; the rest is 0. `trimRevision` names the trim table that goes with them; 0: none.
struct TapGains {
    std::uint32_t revision{0};  ///< 0: leave the machine's own
    ServoGains gains{};
    std::uint32_t trimRevision{0};
};

enum class TapKind : std::uint8_t { Air, Trial, Production };

enum class TapPhase : std::uint8_t {
    Idle,
    SettingGains,  ///< gains are on their way; nothing turns until they read back
    Starting,
    Tapping,
    Retracting,  ///< in sync, after an abort or out of a recovery
    InHole,      ///< stopped inside the hole: waits for a person
};

enum class TapOutcome : std::uint8_t {
    None,
    Counted,
    NotCounted,  ///< more than 5 % of the samples missing, or the loop was stopped during the tap
    Aborted,
};

/// Figures of one tap (docs/tapping.md).
struct TapFigures {
    double saec_mm{0.0};
    double peak_um{0.0};
    double rms_um{0.0};
    double engagedPp_um{0.0};
    std::uint32_t samples{0};
    std::uint32_t missing{0};
};

/// What a production tap leaves in its part record.
struct TapPart {
    TappingJob job{};
    TapFigures figures{};
    bool withinTolerance{false};  ///< counted, and engaged peak-to-peak inside job.allowedPp_um
};

/// Live figures of the tapping loop, part of Status.
struct TappingStatus {
    TapPhase phase{TapPhase::Idle};
    TapKind kind{TapKind::Air};  ///< of the running tap, else of the last one
    TapOutcome outcome{TapOutcome::None};
    std::uint32_t taps{0};      ///< ended since the engine started; a new record is there when it rises
    std::uint32_t partsCut{0};  ///< holes tapped since the engine started: air taps and aborted ones do not count
    std::uint32_t job{0};
    bool airTapPassed{false};        ///< of this job
    std::uint32_t nextGains{0};      ///< revisions
    std::uint32_t acceptedGains{0};  ///< what an abort returns to
    double spindle_rev{0.0};         ///< since the tap began
    double z_mm{0.0};                ///< into the hole positive
    double error_um{0.0};            ///< E_r now
    TapFigures last{};
    ServoGains drive{};              ///< gains the drive reports; zKp_perS 0: none
    double stoppedSpindle_rev{0.0};  ///< where the tap stands in the hole, valid in phase InHole
    double stoppedZ_mm{0.0};
    std::uint32_t productionTaps{0};  ///< counted ones with the accepted gains
    double driftShare{0.0};           ///< accumulated rise of SAEC over its first taps; alarm at .5
    bool wantsTuning{false};
    Sentence problem{};  ///< why the last start came to no tap; empty when it did
};
static_assert(std::is_trivially_copyable_v<TappingStatus>);

}  // namespace kerf
