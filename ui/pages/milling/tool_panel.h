// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/api/status.h"
#include "ui/charts/chart.h"
#include "ui/services/milling_service.h"
#include "ui/widgets/card.h"
#include "ui/widgets/number_display.h"

class QLabel;

namespace kerf::ui {

/// The tool: live cutting stiffness ln(C·b) with its interval, and its mean over the parts cut with this tool against
/// the threshold of wear.
class MillingToolPanel : public Card {
    Q_OBJECT
 public:
    explicit MillingToolPanel(Look& look, QWidget* parent = nullptr);

    void setView(const MillingServiceView& view);
    void setStatus(const Status& status);

    [[nodiscard]] Chart* chart() const { return m_chart; }

 private:
    void retranslate() override;
    void showTrend();
    void showWords();

    Look& m_look;
    Chart* m_chart;
    NumberDisplay* m_stiffness;
    QLabel* m_words;
    Chart::BandId m_band;
    Chart::CurveId m_mean;
    MillingServiceView m_view{};
    MillingStatus m_status{};
};

}  // namespace kerf::ui
