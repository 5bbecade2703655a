// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "engine/api/status.h"
#include "ui/shell/mode_buttons.h"
#include "ui/widgets/card.h"
#include "ui/widgets/lamp.h"
#include "ui/widgets/number_display.h"

class QLabel;

namespace kerf::ui {

/// Three big offsets with interval, the shift the control has, readiness, and off / advise / control.
class OffsetPanel : public Card {
    Q_OBJECT
 public:
    explicit OffsetPanel(Look& look, QWidget* parent = nullptr);

    void setStatus(const ThermalStatus& status, const LoopStatus& loop);
    /// Who is signed on may not be trusted with the mode; outlives this.
    void setSession(OperatorSession& session);

 signals:
    void modeRequested(kerf::LoopMode mode);

 private:
    void retranslate() override;
    void show(const ThermalStatus& status, const LoopStatus& loop);

    Look& m_look;
    std::array<NumberDisplay*, kAxisCount> m_drift{};
    std::array<QLabel*, kAxisCount> m_shift{};
    std::array<Lamp*, kAxisCount> m_limit{};
    QLabel* m_ready;
    QLabel* m_reason;
    ModeButtons* m_modes;
    QHBoxLayout* m_numbers;
    ThermalStatus m_status{};
    LoopStatus m_loop{};
};

}  // namespace kerf::ui
