// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "engine/api/engine_api.h"
#include "engine/api/status.h"
#include "ui/services/turning_service.h"
#include "ui/shell/mode_buttons.h"
#include "ui/widgets/action_button.h"
#include "ui/widgets/card.h"

class QButtonGroup;
class QGridLayout;
class QLabel;
class QProgressBar;

namespace kerf::ui {

/// Mode of the loop, controller, start of the part, setup of the next one.
class TurningControlPanel : public Card {
    Q_OBJECT
 public:
    TurningControlPanel(Look& look, const EngineApi& engine, QWidget* parent = nullptr);

    void setView(const TurningServiceView& view);
    void setStatus(const Status& status);
    /// A change is on its way to the disk.
    void setBusy(bool busy);
    /// Who is signed on may not be trusted with mode and controller; outlives this.
    void setSession(OperatorSession& session);
    [[nodiscard]] ActionButton* startButton() const noexcept { return m_start; }

 signals:
    void modeRequested(kerf::LoopMode mode);
    void controllerRequested(kerf::TurningController controller);
    void startRequested();
    void setupRequested();

 private:
    void retranslate() override;
    void showLoop();
    [[nodiscard]] QString whyNotStart() const;

    Look& m_look;
    const EngineApi& m_engine;
    QLabel* m_reason;
    QProgressBar* m_progress;
    ModeButtons* m_modes;
    QButtonGroup* m_controllers;
    std::array<QPushButton*, kTurningControllers> m_controllerButtons{};
    QHBoxLayout* m_partRow;
    QGridLayout* m_controllerGrid;
    QLabel* m_controllerTitle;
    QLabel* m_setup;
    ActionButton* m_start;
    QPushButton* m_change;
    OperatorSession* m_session{nullptr};
    TurningServiceView m_view{};
    LoopStatus m_loop{};
    ProgramState m_program{ProgramState::Idle};
    ProcessId m_programProcess{ProcessId::Turning};
    TurningStage m_stage{TurningStage::Idle};
    QString m_obstacle{};  ///< why this machine takes no start
    bool m_busy{false};
};

}  // namespace kerf::ui
