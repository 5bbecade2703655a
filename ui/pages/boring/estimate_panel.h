// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>
#include <vector>

#include "ui/services/boring_service.h"
#include "ui/widgets/card.h"
#include "ui/widgets/face_widget.h"

namespace kerf::ui {

/// α̂, β̂ and Ĉ with their 95 % intervals over the parts of the lot: three strips over one axis of parts.
class EstimateStrips : public FaceWidget {
    Q_OBJECT
 public:
    explicit EstimateStrips(Look& look, QWidget* parent = nullptr);
    void setView(const BoringServiceView& view);
    /// The newest value as shown: 0 α̂, 1 β̂, 2 Ĉ (tests).
    [[nodiscard]] QString text(std::size_t strip) const;
    [[nodiscard]] QSize minimumSizeHint() const override;
    [[nodiscard]] QSize sizeHint() const override { return minimumSizeHint(); }

 protected:
    void paintEvent(QPaintEvent* event) override;

 private:
    struct Point {
        double part{0.0};
        double value{0.0};
        double low{0.0};
        double high{0.0};
    };
    void paintStrip(QPainter& painter, const QRectF& area, std::size_t strip) const;
    [[nodiscard]] int labelWidth() const;

    std::array<std::vector<Point>, 3> m_strips;
    std::vector<double> m_changes;
    double m_from{0.5};
    double m_to{12.5};
};

class EstimatePanel : public Card {
    Q_OBJECT
 public:
    explicit EstimatePanel(Look& look, QWidget* parent = nullptr);
    void setView(const BoringServiceView& view);

 private:
    void retranslate() override;

    Look& m_look;
    EstimateStrips* m_strips;
    std::string m_estimator;
};

}  // namespace kerf::ui
