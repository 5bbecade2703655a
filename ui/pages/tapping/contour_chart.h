// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/chart.h"
#include "ui/services/tapping_service.h"

namespace kerf::ui {

/// Contour error over the spindle's way, in and then out, first tap against the last one, with the thread's tolerance
/// as a band while the tap is in the work. The band lies around the middle of the last tap: a constant offset only
/// shifts the thread. A touch changes between the whole course and the band alone.
class ContourChart : public Chart {
    Q_OBJECT
 public:
    explicit ContourChart(Look& look, QWidget* parent = nullptr);

    void setView(const TappingServiceView& view);
    void retranslate();
    /// What a touch does, for the card's header; empty without curves.
    [[nodiscard]] QString key() const;
    [[nodiscard]] bool zoomed() const { return m_zoomed; }

 signals:
    void touched();

 protected:
    void drawForeground(QPainter* painter, const QRectF& rect) override;
    void mousePressEvent(QMouseEvent* event) override;

 private:
    void name(QPainter& painter, const std::vector<QPointF>& points, double at, Token token, const QString& text) const;
    void show();

    CurveId m_first;
    CurveId m_current;
    BandId m_band;
    std::vector<QPointF> m_firstPoints;
    std::vector<QPointF> m_currentPoints;
    double m_depth_rev{0.0};
    double m_engage_rev{0.0};
    double m_allowed_um{0.0};
    double m_worn_um{0.0};
    bool m_zoomed{false};
};

}  // namespace kerf::ui
