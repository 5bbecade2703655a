// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "ui/services/turning_service.h"
#include "ui/shell/page.h"

class QHBoxLayout;
class QLabel;
class QVBoxLayout;

namespace kerf::ui {

class ComparisonPanel;
class ForcePanel;
class MarginPanel;
class ProcessPanel;
class SurfacePanel;
class TurningControlPanel;

/// Diamond turning: force live, depth from the force, predicted surface with its spectrum, identified process, margins
/// and trim, comparison without and with the loop, archive, setup.
///
/// Shows what TurningService and Status say and passes on what is touched; decides nothing.
///
/// Object names, stable for tests:
///   turningPage
///   turningForceChart, turningForceNow, turningDepthChart, turningDepthNow
///   turningSurface: turningSurfaceRms, turningSurfacePv, turningUntreatedRms, turningSpectrum, turningBlind,
///     turningUseSpeed
///   turningControl: turningLoopReason, turningProgress, turningModeOff, turningModeAdvise, turningModeControl,
///     turningOpen, turningPaper, turningPi, turningTones, turningSetupText, turningSetup, turningStart
///   turningProcess: turningFound0…2, turningLaw0…2, turningExcitation, turningTrace, turningProcessNote
///   turningMargins: turningGainMargin, turningPhaseMargin, turningDelayMargin, turningModulusMargin,
///   turningMarginNote,
///     turningTrim, turningTrimBar
///   turningComparison: turningComparison00…33 (row, column), turningNoComparison, turningArchive
///   sheets: see TurningSetupForm, TurningArchive
class TurningPage : public Page {
    Q_OBJECT
 public:
    explicit TurningPage(const PageContext& context, QWidget* parent = nullptr);
    ~TurningPage() override;

 protected:
    void refresh() override;
    void showEvent(QShowEvent* event) override;

 private:
    void build();
    void onServiceChanged();
    void onStatus(const Status& status);
    void openSetup(const TurningSetup& setup);
    void setController(TurningController controller);

    TurningService* m_service;
    std::unique_ptr<Subscription> m_subscription;
    ForcePanel* m_force{nullptr};
    SurfacePanel* m_surface{nullptr};
    TurningControlPanel* m_control{nullptr};
    ProcessPanel* m_process{nullptr};
    MarginPanel* m_margins{nullptr};
    ComparisonPanel* m_comparison{nullptr};
    QLabel* m_missing{nullptr};
    QVBoxLayout* m_rows{nullptr};
    QHBoxLayout* m_top{nullptr};
    QHBoxLayout* m_bottom{nullptr};
    QVBoxLayout* m_charts{nullptr};
    std::uint64_t m_shownRevision{0};
    bool m_behind{true};
};

/// Overview's card: the predicted surface.
[[nodiscard]] KeyFigure turningFigure(const Services& services, const Status& status);

/// Its row in the navigation and its card on Overview.
[[nodiscard]] PageEntry turningPageEntry();

}  // namespace kerf::ui
