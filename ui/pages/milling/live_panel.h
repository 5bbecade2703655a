// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <span>

#include "engine/api/status.h"
#include "ui/charts/live_plot.h"
#include "ui/services/milling_service.h"
#include "ui/widgets/card.h"
#include "ui/widgets/number_display.h"

class QGridLayout;
class QLabel;
class QPushButton;

namespace kerf::ui {

/// Averaged force with its reference and limit over the feed made and wanted, both running with the machine's time.
/// The raw force stands behind the average on demand.
class MillingLivePanel : public Card {
    Q_OBJECT
 public:
    explicit MillingLivePanel(Look& look, QWidget* parent = nullptr);

    void setSetup(const MillingSetup& setup);
    void setStatus(const Status& status);
    /// Samples that came while milling; `blind`: their force is not to be trusted.
    void addSamples(std::span<const Sample> samples, bool blind);

    [[nodiscard]] LivePlot* forceChart() const { return m_force; }
    [[nodiscard]] LivePlot* feedChart() const { return m_feed; }

 private:
    void retranslate() override;
    void showSignal(const MillingStatus& milling);
    void showLimits(double reference_N, double overload_N);

    Look& m_look;
    QGridLayout* m_grid;
    LivePlot* m_force;
    LivePlot* m_feed;
    NumberDisplay* m_forceNow;
    NumberDisplay* m_feedNow;
    QPushButton* m_raw;
    QLabel* m_signal;
    Chart::CurveId m_rawCurve;
    Chart::CurveId m_average;
    Chart::CurveId m_wanted;
    Chart::CurveId m_made;
    MillingSetup m_setup{};
    double m_reference_N{0.0};
    double m_overload_N{0.0};
    QElapsedTimer m_sinceChart;
    double m_lastSample_s{0.0};  ///< of a cut
    double m_shownTo_s{0.0};     ///< while nothing is cut
};

}  // namespace kerf::ui
