// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "engine/api/engine_api.h"
#include "engine/api/status.h"
#include "ui/services/tapping_service.h"
#include "ui/widgets/action_button.h"
#include "ui/widgets/card.h"

class QGridLayout;

namespace kerf::ui {

class OperatorSession;

/// What an operator can do now, each button with the reason when it is off.
class TapActions : public Card {
    Q_OBJECT
 public:
    TapActions(Look& look, const EngineApi& engine, QWidget* parent = nullptr);

    void setView(const TappingServiceView& view);
    void setStatus(const Status& status);
    /// Who is signed on may be trusted with some of it only; outlives this.
    void setSession(OperatorSession& session);
    [[nodiscard]] ActionButton* tapButton() const noexcept { return m_tap; }

 signals:
    void jobRequested();
    void tuneRequested();
    void tapRequested();
    void oneMoreRequested();
    void acceptRequested();
    void rollBackRequested();
    void automaticRequested(bool automatic);
    void abortRequested();
    void recoveryRequested();

 private:
    ActionButton* add(const char* name, int row, int column, int columns, ActionButton::WhyNot whyNot);
    void retranslate() override;
    void reconsider();
    /// A tap moves or stands in the hole.
    [[nodiscard]] QString whyTapping() const;
    [[nodiscard]] QString whyNoMove() const;
    [[nodiscard]] QString whyNoTune() const;
    [[nodiscard]] QString whyNoTap() const;
    [[nodiscard]] QString whyNoOneMore() const;
    [[nodiscard]] QString whyNoRollBack() const;
    [[nodiscard]] QString whyNoAbort() const;
    [[nodiscard]] bool tuning() const;
    [[nodiscard]] bool inHole() const { return m_status.tapping.phase == TapPhase::InHole; }

    Look& m_look;
    const EngineApi& m_engine;  ///< asked each time: a real machine tells what it can do once it is reached
    QGridLayout* m_grid;
    ActionButton* m_job;
    ActionButton* m_tune;
    ActionButton* m_tap;
    ActionButton* m_oneMore;
    ActionButton* m_accept;
    ActionButton* m_rollBack;
    QPushButton* m_automatic;
    ActionButton* m_abort;
    ActionButton* m_recover;
    TappingServiceView m_view{};
    Status m_status{};
};

}  // namespace kerf::ui
