// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "engine/api/status.h"
#include "ui/services/tapping_service.h"
#include "ui/widgets/card.h"
#include "ui/widgets/face_widget.h"

class QButtonGroup;
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

 signals:
    void modeRequested(kerf::LoopMode mode);

 protected:
    void changeEvent(QEvent* event) override;

 private:
    static constexpr std::size_t kRows = 5;
    static constexpr std::size_t kColumns = 3;
    void retranslate();
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
    QButtonGroup* m_modes;
    QHBoxLayout* m_modeRow;
    std::array<QPushButton*, 3> m_modeButtons{};
    TappingServiceView m_view{};
    LoopStatus m_loop{};
    TappingStatus m_tapping{};
};

}  // namespace kerf::ui
