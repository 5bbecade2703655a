// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableWidget>

#include "ui/services/boring_service.h"
#include "ui/theme/look.h"

namespace kerf::ui {

/// The parts of the lot with a diameter per depth, newest first: touch a value to correct it, an empty place to enter
/// it. Object name boringMeasurementList.
class MeasurementList : public QTableWidget {
    Q_OBJECT
 public:
    MeasurementList(Look& look, const BoringService& service, QWidget* parent = nullptr);
    void refreshView();

 signals:
    void measurementTouched(qint64 part, int depth, qint64 measurement);
    void openPlaceTouched(qint64 part, int depth);

 private:
    Look& m_look;
    const BoringService& m_service;
};

}  // namespace kerf::ui
