// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/dialogs/sheet.h"
#include "ui/link/engine_client.h"
#include "ui/services/tapping_service.h"
#include "ui/widgets/action_button.h"

namespace kerf::ui {

/// A tap that stands in a hole, step by step: where it stands, what will happen, what must be ready; then it turns,
/// and the sheet says how far it is; then what to do next. Deletes itself with its sheet.
class RecoverySheet : public FaceWidget {
    Q_OBJECT
 public:
    /// Opens its sheet on `host`.
    /// `gone`: somebody says that the tap has been taken out by hand.
    static RecoverySheet* open(SheetHost& host, Look& look, TappingService& service, EngineClient& client,
                               std::function<void()> gone);

 protected:
    void refresh() override;

 private:
    enum class Step { Ready, Turning, Out };
    RecoverySheet(Sheet& sheet, Look& look, TappingService& service, EngineClient& client, std::function<void()> gone);
    void onStatus(const Status& status);
    void show();
    [[nodiscard]] QString whyNotTurn() const;

    Sheet& m_sheet;
    TappingService& m_service;
    EngineClient& m_client;
    QLabel* m_where;
    QLabel* m_what;
    QLabel* m_state;
    QPushButton* m_close;
    QPushButton* m_gone;
    ActionButton* m_turn;
    Step m_step{Step::Ready};
    bool m_asked{false};
};

}  // namespace kerf::ui
