// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/chart.h"
#include "ui/services/tapping_service.h"

namespace kerf::ui {

/// Sync error against hole time over the speeds tuned so far; a touch on a point picks it.
class SpeedChart : public Chart {
    Q_OBJECT
 public:
    explicit SpeedChart(Look& look, QWidget* parent = nullptr);

    void setView(const TappingServiceView& view);
    void retranslate();

 signals:
    void picked(const kerf::TapChoice& choice);

 protected:
    void drawForeground(QPainter* painter, const QRectF& rect) override;
    void mousePressEvent(QMouseEvent* event) override;

 private:
    [[nodiscard]] QPointF at(const TapSpeedPoint& point) const;

    std::vector<TapSpeedPoint> m_points;
    double m_allowed_um{0.0};
    CurveId m_tuned;
    CurveId m_current;
};

}  // namespace kerf::ui
