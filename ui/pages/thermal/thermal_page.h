// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <functional>
#include <optional>

#include "ui/charts/chart.h"
#include "ui/pages/thermal/machine_drawing.h"
#include "ui/pages/thermal/offset_panel.h"
#include "ui/pages/thermal/thermal_sheets.h"
#include "ui/shell/page.h"
#include "ui/widgets/sparkline.h"

namespace kerf::ui {

/// The thermal loop: offsets with their interval, prediction against measurement, temperatures on the machine; sheets
/// for warm-up, measurement, models, history, sensors, error map and limits.
///
/// Shows what ThermalService and Status say and passes on what is touched; decides nothing.
///
/// Object names, stable for tests:
///   thermalPage; thermalOffsets: thermalDriftX…Z, thermalShiftX…Z, thermalReady, thermalLoopReason,
///     thermalModeOff, thermalModeAdvise, thermalModeControl
///   thermalChart, thermalDrawing, thermalHealth, thermalTouched, thermalTrend
///   buttons: thermalWarmUp, thermalMeasure, thermalModel, thermalHistory, thermalSensors, thermalMap, thermalLimits
///   sheets: see ThermalSheets
class ThermalPage : public Page {
    Q_OBJECT
 public:
    explicit ThermalPage(const PageContext& context, QWidget* parent = nullptr);

 protected:
    void refresh() override;
    void showEvent(QShowEvent* event) override;

 private:
    void build();
    void onStatus(const Status& status);
    void showView();
    void showHealth();
    void showTouched();
    void warmUp();
    ActionButton* addButton(const char* name, std::function<void()> action);

    ThermalService* m_service;
    QLabel* m_missing{nullptr};
    OffsetPanel* m_offsets{nullptr};
    Card* m_chartCard{nullptr};
    Chart* m_chart{nullptr};
    std::array<Chart::CurveId, kAxisCount> m_predicted{};
    std::array<Chart::CurveId, kAxisCount> m_measured{};
    std::array<Chart::BandId, kAxisCount> m_band{};
    QLabel* m_key{nullptr};
    Card* m_drawingCard{nullptr};
    MachineDrawing* m_drawing{nullptr};
    QLabel* m_health{nullptr};
    QLabel* m_touchedText{nullptr};
    Sparkline* m_trend{nullptr};
    std::vector<ActionButton*> m_buttons;
    QVBoxLayout* m_rows{nullptr};
    QHBoxLayout* m_middle{nullptr};
    QHBoxLayout* m_buttonRow{nullptr};
    std::unique_ptr<ThermalSheets> m_sheets;
    Status m_status{};
    std::optional<std::size_t> m_touched;
    std::uint64_t m_shownRevision{0};
};

/// Its row in the navigation and its card on Overview.
[[nodiscard]] PageEntry thermalPageEntry();

}  // namespace kerf::ui
