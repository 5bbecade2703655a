// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "engine/api/status.h"
#include "ui/charts/live_plot.h"
#include "ui/widgets/card.h"

class QLabel;

namespace kerf::ui {

/// Force live against its target (every 5 kHz sample between lowest and highest, and the mean), and the depth that the
/// force shows against the programmed one.
class ForcePanel : public QWidget {
    Q_OBJECT
 public:
    explicit ForcePanel(Look& look, QWidget* parent = nullptr);

    void addSamples(std::span<const Sample> samples);
    void setStatus(const Status& status);
    void retranslate();

 private:
    Look& m_look;
    Card* m_forceCard;
    Card* m_depthCard;
    LivePlot* m_force;
    LivePlot* m_depth;
    QLabel* m_forceNow;
    QLabel* m_depthNow;
    QLabel* m_signal;
    Chart::CurveId m_swing;
    Chart::CurveId m_mean;
    Chart::CurveId m_estimate;
    double m_target_N{0.0};
    double m_depth_um{0.0};
    double m_lastChart_s{-1.0};
    double m_lastSample_s{0.0};
    double m_lastText_s{-1.0};
    bool m_limitsShown{false};
};

}  // namespace kerf::ui
