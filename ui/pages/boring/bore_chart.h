// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "engine/quality/verdict.h"
#include "ui/charts/chart.h"
#include "ui/services/boring_service.h"

namespace kerf::ui {

/// The bore of the last parts against its tolerance: one curve per depth, the prediction as a diamond with its 95 %
/// bar for parts that are not yet measured and for the next one, a triangle where the process changed.
///
/// The scale shows at most a tolerance width beyond either limit, so that one bad part does not flatten the others.
class BoreChart : public Chart {
    Q_OBJECT
 public:
    explicit BoreChart(Look& look, QWidget* parent = nullptr);

    void setView(const BoringServiceView& view);
    void retranslate();
    /// What the marks mean, for the card's header.
    [[nodiscard]] QString key() const;

 signals:
    /// A part was touched (0: beside all of them).
    void partTouched(std::uint32_t number);

 protected:
    void drawForeground(QPainter* painter, const QRectF& rect) override;
    void mousePressEvent(QMouseEvent* event) override;

 private:
    struct Bar {
        double part;
        double diameter_mm;
        double half95_mm;
    };
    /// A diameter beyond the scale: an arrow at the edge with its value.
    struct Beyond {
        double part;
        double diameter_mm;
    };
    /// A diameter out of tolerance, with the word for what can be done.
    struct Bad {
        double part;
        double diameter_mm;
        quality::Verdict verdict;
    };
    [[nodiscard]] QPointF at(double part, double diameter_mm) const;
    void rebuildCurves();

    BoringServiceView m_view;
    std::vector<CurveId> m_depthCurves;
    std::vector<Bar> m_bars;
    std::vector<Beyond> m_beyond;
    std::vector<Bad> m_bad;
    std::vector<double> m_changes;
};

}  // namespace kerf::ui
