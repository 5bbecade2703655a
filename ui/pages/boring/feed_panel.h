// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <array>
#include <span>

#include "engine/api/status.h"
#include "ui/charts/chart.h"
#include "ui/services/boring_service.h"
#include "ui/widgets/card.h"

class QLabel;

namespace kerf::ui {

/// Feed along the bore: the schedule of the part in the machine (or of the next one) dashed, what the last part was
/// really cut with, and the live cut with its moving point.
class FeedPanel : public Card {
    Q_OBJECT
 public:
    explicit FeedPanel(Look& look, QWidget* parent = nullptr);

    void setView(const BoringServiceView& view);
    void setStatus(const Status& status);
    void addSamples(std::span<const Sample> samples);

    [[nodiscard]] Chart* chart() const { return m_chart; }

 private:
    static constexpr std::size_t kBins = 96;
    void retranslate() override;
    void showSchedule();
    void showLive(const BoringStatus& boring);

    Look& m_look;
    Chart* m_chart;
    QLabel* m_live;
    Chart::CurveId m_schedule;
    Chart::CurveId m_previous;
    Chart::CurveId m_cut;
    Chart::CurveId m_point;
    BoringSchedule m_next{};
    std::vector<BoringSchedule> m_known;
    FeedTrace m_lastFeed{};
    std::uint32_t m_shownRevision{0};
    double m_from_mm{0.0};
    double m_to_mm{1.0};
    std::array<float, kBins> m_bins{};  ///< live feed over the bore; 0: not cut yet
    float m_lastOverhang_mm{0.0F};
    QElapsedTimer m_sinceLine;
    QElapsedTimer m_sinceText;
};

}  // namespace kerf::ui
