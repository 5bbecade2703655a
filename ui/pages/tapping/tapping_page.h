// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <optional>
#include <tuple>

#include "ui/pages/tapping/contour_chart.h"
#include "ui/pages/tapping/gains_panel.h"
#include "ui/pages/tapping/speed_chart.h"
#include "ui/pages/tapping/tap_actions.h"
#include "ui/pages/tapping/trial_bars.h"
#include "ui/services/tapping_service.h"
#include "ui/shell/page.h"

namespace kerf::ui {

/// The tapping loop: contour error of first and last tap against the thread's tolerance, figures per trial, gains with
/// their safe set, the next proposal with its reason, error against time per hole.
///
/// Shows what TappingService and Status say and passes on what is touched; decides nothing.
///
/// Object names, stable for tests:
///   tappingPage, tappingNote, tappingLive
///   tappingContourChart, tappingSaecBars, tappingPpBars, tappingSpeedChart
///   tappingGains: tappingState, tappingGain<row><column> (spindle Kp, Z Kp, speed FF, accel. FF, trim; before, now,
///     next), tappingSafeBar, tappingSafe, tappingReason, tappingDrift, tappingLoopReason, tappingModeOff,
///     tappingModeAdvise, tappingModeControl
///   tappingActions: tappingJob, tappingTune, tappingTap, tappingOneMore, tappingAccept, tappingRollBack,
///     tappingAutomatic, tappingAbort, tappingRecover
///   sheet of tappingJob: jobCoarse, jobFine, thread_<name>, jobSpeedEdit, jobDepthEdit, jobGearEdit, jobPartEdit,
///     jobTapEdit, jobMessage, jobCancel, jobApply
///   sheet of tappingRecover: recoveryWhere, recoveryWhat, recoveryState, recoveryTurn, recoveryGone, recoveryClose
class TappingPage : public Page {
    Q_OBJECT
 public:
    explicit TappingPage(const PageContext& context, QWidget* parent = nullptr);

 protected:
    void refresh() override;
    void showEvent(QShowEvent* event) override;

 private:
    void build();
    void connectActions();
    void showView();
    void onStatus(const Status& status);
    void showNote(const Status& status);
    void tell(const Result<void>& result);
    void sayGone();

    TappingService* m_service;
    QLabel* m_missing{nullptr};
    Card* m_contourCard{nullptr};
    ContourChart* m_contour{nullptr};
    QLabel* m_key{nullptr};
    QLabel* m_live{nullptr};
    QLabel* m_note{nullptr};
    Card* m_barCard{nullptr};
    QLabel* m_saecTitle{nullptr};
    QLabel* m_ppTitle{nullptr};
    TrialBars* m_saec{nullptr};
    TrialBars* m_pp{nullptr};
    Card* m_speedCard{nullptr};
    SpeedChart* m_speeds{nullptr};
    GainsPanel* m_gains{nullptr};
    TapActions* m_actions{nullptr};
    QVBoxLayout* m_rows{nullptr};
    QHBoxLayout* m_top{nullptr};
    QHBoxLayout* m_bottom{nullptr};
    QHBoxLayout* m_bars{nullptr};
    /// What changes a button or a sentence at once; the rest follows five times a second.
    using Situation = std::tuple<TapPhase, bool, LoopMode, bool, QString, bool, ProgramState, std::uint32_t,
                                 std::uint32_t, bool, const char*>;
    [[nodiscard]] static Situation situation(const Status& status);

    std::optional<std::uint64_t> m_shown{};
    std::optional<Situation> m_situation{};
    QElapsedTimer m_sinceText;
};

/// Its row in the navigation and its card on Overview.
[[nodiscard]] PageEntry tappingPageEntry();

}  // namespace kerf::ui
