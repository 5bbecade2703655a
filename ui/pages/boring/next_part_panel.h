// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "engine/api/status.h"
#include "ui/services/boring_service.h"
#include "ui/shell/mode_buttons.h"
#include "ui/widgets/action_button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/lamp.h"
#include "ui/widgets/number_display.h"

class QGridLayout;
class QHBoxLayout;
class QLabel;

namespace kerf::ui {

/// What the next part will be cut with, what bore is expected from it, and why it changed; accept and the switch
/// off / advise / control.
class NextPartPanel : public Card {
    Q_OBJECT
 public:
    explicit NextPartPanel(Look& look, QWidget* parent = nullptr);

    void setView(const BoringServiceView& view);
    void setLoop(const LoopStatus& loop);
    /// An answer of the service is awaited: no second accept meanwhile.
    void setBusy(bool busy);
    /// A full or closed lot then offers the next one.
    void setLotsThere(bool there);
    /// Who is signed on may not be trusted with the mode; outlives this.
    void setSession(OperatorSession& session);

 signals:
    void acceptRequested();
    void modeRequested(kerf::LoopMode mode);
    void lotsRequested();
    void changeRequested();

 private:
    void retranslate() override;
    void showNext();
    void showLoop();
    [[nodiscard]] QString whyNotAccept() const;

    Look& m_look;
    QGridLayout* m_diameters;
    std::vector<NumberDisplay*> m_numbers;
    QLabel* m_feedLabel;
    QLabel* m_feed;
    QLabel* m_why;
    QLabel* m_rests;
    QPushButton* m_change;
    Lamp* m_limited;
    ActionButton* m_accept;
    QPushButton* m_nextLot;
    QLabel* m_loopReason;
    ModeButtons* m_modes;
    BoringServiceView m_view{};
    LoopStatus m_loop{};
    bool m_lotsThere{false};
    bool m_busy{false};
};

}  // namespace kerf::ui
