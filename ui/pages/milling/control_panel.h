// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <array>
#include <optional>

#include "engine/api/status.h"
#include "ui/services/milling_service.h"
#include "ui/shell/mode_buttons.h"
#include "ui/widgets/action_button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/lamp.h"
#include "ui/widgets/number_display.h"

class QGridLayout;

namespace kerf::ui {

/// What the loop does and what it may be told: state, law, reference, start and release, mode. Emits what was touched.
class MillingControlPanel : public Card {
    Q_OBJECT
 public:
    explicit MillingControlPanel(Look& look, QWidget* parent = nullptr);

    void setView(const MillingServiceView& view);
    void setStatus(const Status& status, const Capabilities& capabilities);
    /// Who is signed on may not be trusted with law, reference and mode; outlives this.
    void setSession(OperatorSession& session);
    [[nodiscard]] ActionButton* startButton() const noexcept { return m_start; }

 signals:
    void lawRequested(kerf::MillingLaw law);
    void teachRequested();
    void startRequested();
    void releaseRequested();
    void modeRequested(kerf::LoopMode mode);

 private:
    void retranslate() override;
    void showLoop();
    void showNumbers();
    [[nodiscard]] QString whyNotLaw(MillingLaw law) const;
    [[nodiscard]] QString whyNotStart() const;
    [[nodiscard]] QString whyNotTeach() const;

    Look& m_look;
    Lamp* m_lamp;
    QLabel* m_reason;
    QGridLayout* m_numbers;
    NumberDisplay* m_reference;
    NumberDisplay* m_margin;
    NumberDisplay* m_peak;
    NumberDisplay* m_saved;
    QLabel* m_advice;
    QLabel* m_lawLabel;
    QGridLayout* m_laws;
    std::array<ActionButton*, kMillingLawCount> m_lawButtons{};
    ActionButton* m_teach;
    ActionButton* m_start;
    ActionButton* m_release;
    QGridLayout* m_actions;
    ModeButtons* m_modes;
    MillingServiceView m_view{};
    Status m_status{};
    Capability m_cycleStart{};
    std::optional<bool> m_advising{};  ///< as the label says
    QElapsedTimer m_sinceShown;
};

}  // namespace kerf::ui
