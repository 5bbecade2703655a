// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "ui/dialogs/sheet.h"
#include "ui/services/tapping_service.h"
#include "ui/widgets/keypad.h"
#include "ui/widgets/value_field.h"

class QLineEdit;

namespace kerf::ui {

/// Choice of what is tapped: thread from the table, speed, depth, gear, part type, tap. Lives on its sheet. Says what
/// the loaded job began from (jobMemory), which can be left out with a reason or taken in again (jobReason,
/// jobLeaveOut).
class JobForm : public FaceWidget {
    Q_OBJECT
 public:
    /// `author`: who leaves a stored tuning out, or takes it in again.
    static JobForm* open(SheetHost& host, Look& look, TappingService& service, std::function<std::string()> author);

 protected:
    void refresh() override;

 private:
    JobForm(Sheet& sheet, Look& look, TappingService& service, std::function<std::string()> author);
    void leaveOut();
    void showMemory();
    void showThreads();
    void apply();

    Sheet& m_sheet;
    TappingService& m_service;
    TapChoice m_choice;
    bool m_coarse{true};
    QPushButton* m_coarseButton;
    QPushButton* m_fineButton;
    QGridLayout* m_threads;
    std::vector<QPushButton*> m_threadButtons;
    QLabel* m_thread;
    QGridLayout* m_fieldGrid{nullptr};
    std::vector<ValueField*> m_fields;  ///< speed, depth, gear, part type, tap
    Keypad* m_keypad;
    QLabel* m_message;
    QPushButton* m_cancel;
    QPushButton* m_apply;
    std::function<std::string()> m_author;
    QLabel* m_memory;
    QLineEdit* m_reason;
    QPushButton* m_leaveOut;
};

}  // namespace kerf::ui
