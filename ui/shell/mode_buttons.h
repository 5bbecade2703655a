// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPushButton>
#include <array>

#include "engine/api/status.h"
#include "ui/shell/operator_session.h"
#include "ui/theme/look.h"

class QHBoxLayout;

namespace kerf::ui {

/// Off, advise, control of one loop, alike on every page. What is shown is what the engine says, not what was touched;
/// a touch asks for a mode. Whom the table does not let switch it, they are off for, and words() says why; with nobody
/// signed on they stay on, and the touch asks who is there.
class ModeButtons : public QWidget {
    Q_OBJECT
 public:
    ModeButtons(Look& look, ProcessId process, QWidget* parent = nullptr);
    /// Whom the table lets (Deed::SwitchLoop). Without it: everybody, as in a panel on its own.
    void setSession(OperatorSession& session);
    void setLoop(const LoopStatus& loop);
    /// The line beside the buttons: what the loop does and why, or who may switch it. @pre setLoop()
    [[nodiscard]] QString words() const;

 signals:
    void modeRequested(kerf::LoopMode mode);
    /// Somebody else is there, or nobody: words() may be others.
    void permissionChanged();

 protected:
    void changeEvent(QEvent* event) override;

 private:
    void retranslate();
    void apply();
    [[nodiscard]] QString whyNot() const;

    Look& m_look;
    OperatorSession* m_session{nullptr};
    QHBoxLayout* m_row;
    std::array<QPushButton*, 3> m_buttons{};
    LoopStatus m_loop{};
};

}  // namespace kerf::ui
