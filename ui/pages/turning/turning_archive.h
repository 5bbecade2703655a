// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>

#include "ui/dialogs/sheet.h"
#include "ui/pages/turning/spectrum_chart.h"
#include "ui/services/turning_service.h"
#include "ui/shell/page.h"

class QGridLayout;
class QLineEdit;
class QTableWidget;

namespace kerf::ui {

/// Sheet with the last parts, newest first; the touched one with its spectrum, its force along the face and its words.
/// What the first part after a start begins from stands above; the touched part can be left out of it with a reason, or
/// taken in again.
///
/// Object names: turningArchiveSheet, turningArchiveTable, turningArchiveText, turningArchiveSpectrum,
/// turningArchiveForce, turningArchiveReason, turningArchiveLeaveOut, turningArchiveMessage, turningArchiveClose.
class TurningArchive : public FaceWidget {
    Q_OBJECT
 public:
    static TurningArchive* open(const PageContext& context, TurningService& service);

 protected:
    void refresh() override;

 private:
    TurningArchive(const PageContext& context, TurningService& service, Sheet* sheet);
    void fill();
    void showPart(int row);
    void leaveOut();
    void sendLeaveOut(const QString& reason);
    void answered(const QString& reason, const Result<void>& done);
    void showMemory();
    /// The touched one; null: no part yet.
    [[nodiscard]] const TurningPartView* touched() const;
    [[nodiscard]] QString textOf(const TurningPartView& part) const;

    PageContext m_page;
    TurningService& m_service;
    QPointer<Sheet> m_sheet;
    QTableWidget* m_table;
    QLabel* m_text;
    QLabel* m_spectrumTitle;
    QLabel* m_forceTitle;
    SpectrumChart* m_spectrum;
    Chart* m_force;
    Chart::BandId m_swing;
    Chart::CurveId m_mean;
    QGridLayout* m_charts;
    QLineEdit* m_reason;
    QPushButton* m_leaveOut;
    QLabel* m_message;
    QPushButton* m_close;
    int m_row{0};
};

}  // namespace kerf::ui
