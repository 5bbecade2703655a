// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QPointer>
#include <functional>
#include <set>
#include <string>

#include "ui/services/thermal_service.h"
#include "ui/shell/page.h"

class QLineEdit;
class QTableWidget;

namespace kerf::ui {

/// The thermal page's sheets. One is open at a time and follows status and service.
///
/// Object names:
///   model: thermalCard (table), thermalTrainOpen, thermalRollBack
///   train: thermalDays (column 0 touched: chosen or not), thermalCompared, thermalTrainState, thermalTrainAuto,
///     thermalTrainCancel, thermalGoLive, thermalDayReason, thermalDayLeaveOut
///   measure: thermalSteps, thermalGapTable, thermalMeasureNow, thermalAdopt, thermalReference, thermalSession,
///   thermalByPart part: thermalPartX…Z, thermalPartState, thermalPartTake history: thermalShiftTable,
///   thermalGapHistory; sensors: thermalSensorTable; map: thermalErrorMapX…Z limits: thermalAllowed, thermalPeriod,
///   thermalMaxShift, thermalMaxStep, thermalWarmSpeed, thermalWarmMinutes,
///     thermalBetweenParts
///   thermalSheetClose
class ThermalSheets {
    Q_DECLARE_TR_FUNCTIONS(ThermalSheets)
 public:
    ThermalSheets(const PageContext& context, ThermalService& service) : m_context(context), m_service(service) {}

    void openModel();
    void openTrain();
    void openMeasure();
    void openPart();
    void openHistory();
    void openSensors();
    void openMap();
    void openLimits();
    void take(const Status& status) { m_status = status; }
    /// Something has changed: the open sheet follows.
    void refresh();

 private:
    [[nodiscard]] ActionButton* named(const char* name, const QString& text);
    Sheet* open(const QString& title, const QString& text);
    void follow(std::function<void()> update);
    void tell(const Result<void>& result);
    void withAuthor(Deed deed, std::function<Result<void>(const std::string&)> action);
    void showDays(QTableWidget* table);
    /// The day that was touched last; null: none.
    [[nodiscard]] const ThermalDayView* touchedDay() const;
    /// The touched day out of the training or in again, with a reason.
    void addLeaveOut(Sheet* sheet);
    void sendLeaveOut(const std::string& day, bool out, const QString& reason, QPointer<QLineEdit> field);

    PageContext m_context;
    ThermalService& m_service;
    QPointer<Sheet> m_sheet;
    std::function<void()> m_update;
    std::set<std::string> m_chosenDays;
    std::string m_touchedDay{};
    Status m_status{};
};

}  // namespace kerf::ui
