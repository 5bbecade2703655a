// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <array>
#include <optional>
#include <span>

#include "engine/api/status.h"
#include "ui/charts/chart.h"
#include "ui/services/milling_service.h"
#include "ui/widgets/card.h"

class QLabel;

namespace kerf::ui {

/// How far the finished wall stays too high along the path, as the force shows it: this cut over the one before.
class MillingWallPanel : public Card {
    Q_OBJECT
 public:
    explicit MillingWallPanel(Look& look, QWidget* parent = nullptr);

    void setView(const MillingServiceView& view);
    void setStatus(const Status& status);
    void addSamples(std::span<const Sample> samples, bool blind);

    [[nodiscard]] Chart* chart() const { return m_chart; }

 private:
    static constexpr std::size_t kBins = 160;
    using Bins = std::array<std::optional<float>, kBins>;  ///< deviation along the path; empty: not cut yet
    void retranslate() override;
    void showCurves();
    void fitHeight();
    void showNote();
    [[nodiscard]] std::vector<QPointF> pointsOf(const Bins& bins) const;

    Look& m_look;
    Chart* m_chart;
    QLabel* m_live;
    QLabel* m_note;
    Chart::CurveId m_before;
    Chart::CurveId m_now;
    MillingServiceView m_view{};
    double m_from_mm{0.0};
    double m_to_mm{0.0};
    double m_waviness_um{0.0};
    bool m_cutting{false};
    bool m_shownCutting{true};  ///< drawn last while cutting: the end of the cut is to be drawn once more
    Bins m_bins{};
    Bins m_past{};
    QElapsedTimer m_sinceChart;
};

}  // namespace kerf::ui
