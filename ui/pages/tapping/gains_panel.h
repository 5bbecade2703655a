// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "engine/api/status.h"
#include "ui/services/tapping_service.h"
#include "ui/shell/mode_buttons.h"
#include "ui/widgets/card.h"
#include "ui/widgets/face_widget.h"

class QGridLayout;
class QPushButton;

namespace kerf::ui {

/// The position gain between its safe limits: now a disc, proposed a diamond, the estimated stability limit a line.
class SafeBar : public FaceWidget {
    Q_OBJECT
 public:
    explicit SafeBar(Look& look, QWidget* parent = nullptr);
    void setView(const TappingServiceView& view);
    [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
    void paintEvent(QPaintEvent* event) override;

 private:
    TappingServiceView m_view{};
};

/// Gains before, now and proposed in the machine's own units, the safe set with its margin, the proposal's reason, and
/// the switch off / advise / control.
class GainsPanel : public Card {
    Q_OBJECT
 public:
    explicit GainsPanel(Look& look, QWidget* parent = nullptr);

    void setView(const TappingServiceView& view);
    void setStatus(const Status& status);
    /// Who is signed on may not be trusted with the mode; outlives this.
    void setSession(OperatorSession& session);

 signals:
    void modeRequested(kerf::LoopMode mode);

 private:
    static constexpr std::size_t kRows = 5;
    static constexpr std::size_t kColumns = 3;
    void retranslate() override;
    void showView();
    void showLoop();

    Look& m_look;
    QLabel* m_state;
    QGridLayout* m_grid;
    std::array<QLabel*, kColumns> m_heads{};
    std::array<QLabel*, kRows> m_names{};
    std::array<std::array<QLabel*, kColumns>, kRows> m_cells{};
    SafeBar* m_bar;
    QLabel* m_safe;
    QLabel* m_reason;
    QLabel* m_drift;
    QLabel* m_loopReason;
    ModeButtons* m_modes;
    TappingServiceView m_view{};
    LoopStatus m_loop{};
    TappingStatus m_tapping{};
};

}  // namespace kerf::ui
