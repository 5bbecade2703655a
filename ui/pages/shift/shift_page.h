// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableWidget>
#include <QTimer>

#include "ui/services/shift_service.h"
#include "ui/shell/page.h"
#include "ui/widgets/action_button.h"
#include "ui/widgets/card.h"

namespace kerf::ui {

/// What the shift has made, where it stood still and why, what was changed by whom, its alarms and notes; from here it
/// is handed over with a name, and printed on one page.
///
/// Object names: shiftPeriod, shiftParts, shiftSaving, shiftStops, shiftNotes, shiftChanges, shiftAlarms; buttons:
/// shiftEarlier, shiftNow, shiftNote, shiftHandOver, shiftPdf; in its sheets: stopReason_KEY, shiftText, shiftSave.
class ShiftPage : public Page {
    Q_OBJECT
 public:
    explicit ShiftPage(const PageContext& context, QWidget* parent = nullptr);

 protected:
    void refresh() override;
    void showEvent(QShowEvent* event) override;

 private:
    QTableWidget* makeTable(const char* name, int columns);
    void build();
    void read();
    void arrived(const Result<ShiftView>& view);
    void show();
    void nameStop(int row);
    void write(bool handover);
    void print();
    void told(const Result<void>& result, const QString& done);

    ShiftService* m_service;
    QLabel* m_missing{nullptr};
    QLabel* m_period{nullptr};
    QPushButton* m_earlier{nullptr};
    QPushButton* m_now{nullptr};
    QPushButton* m_pdf{nullptr};
    Card* m_partsCard{nullptr};
    Card* m_stopsCard{nullptr};
    Card* m_notesCard{nullptr};
    Card* m_changesCard{nullptr};
    Card* m_alarmsCard{nullptr};
    QTableWidget* m_parts{nullptr};
    QLabel* m_saving{nullptr};
    QTableWidget* m_stops{nullptr};
    QTableWidget* m_notes{nullptr};
    QTableWidget* m_changes{nullptr};
    QTableWidget* m_alarms{nullptr};
    QPushButton* m_note{nullptr};
    ActionButton* m_handOver{nullptr};
    QTimer m_timer;
    ShiftView m_view{};
    int m_back{0};
    bool m_reading{false};
};

}  // namespace kerf::ui
