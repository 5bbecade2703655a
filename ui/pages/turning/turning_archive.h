// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>

#include "ui/dialogs/sheet.h"
#include "ui/pages/turning/spectrum_chart.h"
#include "ui/services/turning_service.h"

class QGridLayout;
class QTableWidget;

namespace kerf::ui {

/// Sheet with the last parts, newest first; the touched one with its spectrum, its force along the face and its words.
///
/// Object names: turningArchiveSheet, turningArchiveTable, turningArchiveText, turningArchiveSpectrum,
/// turningArchiveForce, turningArchiveClose.
class TurningArchive : public FaceWidget {
    Q_OBJECT
 public:
    static TurningArchive* open(SheetHost& host, Look& look, const TurningService& service);

 protected:
    void refresh() override;

 private:
    TurningArchive(Look& look, const TurningService& service, Sheet* sheet);
    void fill();
    void showPart(int row);
    [[nodiscard]] QString textOf(const TurningPartView& part) const;

    const TurningService& m_service;
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
    QPushButton* m_close;
    int m_row{0};
};

}  // namespace kerf::ui
