// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/boring/feed_panel.h"

#include <QLabel>
#include <algorithm>

#include "ui/pages/boring/boring_texts.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {

constexpr int kLinePeriod_ms = 100;  // of the line behind the live point, which moves with every tick
constexpr int kTextPeriod_ms = 200;
constexpr int kCurvePoints = 48;

std::vector<QPointF> curveOf(const BoringSchedule& schedule) {
    std::vector<QPointF> points;
    points.reserve(kCurvePoints);
    for (int i = 0; i < kCurvePoints; ++i) {
        const double overhang_mm =
            schedule.overhangFrom_mm + (schedule.overhangTo_mm - schedule.overhangFrom_mm) * i / (kCurvePoints - 1.0);
        points.emplace_back(overhang_mm, schedule.feed_mmPerRev(overhang_mm));
    }
    return points;
}

}  // namespace

FeedPanel::FeedPanel(Look& look, QWidget* parent)
    : Card(look, parent),
      m_look(look),
      m_chart(new Chart(look, this)),
      m_live(makeLabel(TextRole::Body, this)),
      m_schedule(m_chart->addCurve({Token::Wanted, Chart::Kind::Dashed, Chart::Marker::Disc, Stroke::Normal})),
      m_previous(m_chart->addCurve({Token::Past, Chart::Kind::Line, Chart::Marker::Disc, Stroke::Normal})),
      m_cut(m_chart->addCurve({Token::Measured, Chart::Kind::Line, Chart::Marker::Disc, Stroke::Normal})),
      m_point(m_chart->addCurve({Token::Measured, Chart::Kind::Points, Chart::Marker::Disc, Stroke::Bold})) {
    setObjectName(QStringLiteral("boringFeedPanel"));
    m_chart->setObjectName(QStringLiteral("boringFeedChart"));
    m_live->setObjectName(QStringLiteral("boringLiveFeed"));
    m_chart->setLowTitles(true);
    header()->addWidget(m_live);
    body()->addWidget(m_chart, 1);
    connect(&look, &Look::changed, this, [this] { retranslate(); });
    retranslate();
}

void FeedPanel::retranslate() {
    setTitle(tr("Feed along the bore, %1", "unit").arg(m_look.units().of("mm/rev").symbol));
    m_chart->setXAxis(tr("overhang"), "mm");
    m_chart->setYAxis(tr("feed"), "mm/rev");
    m_chart->setCurveLabel(m_schedule, tr("schedule"));
    m_chart->setCurveLabel(m_previous, tr("last part"));
    m_chart->setEmptyText(tr("The feed schedule appears here as soon as a lot is running."));
    m_chart->setAccessibleName(tr("Feed along the bore: schedule, last part, live cut"));
}

void FeedPanel::setView(const BoringServiceView& view) {
    m_next = view.nextSchedule;
    m_known.clear();
    m_lastFeed = {};
    for (const BorePartView& part : view.parts) {
        m_known.push_back(part.schedule);
        if (part.cut && part.feed.count > 0) {
            m_lastFeed = part.feed;
        }
    }
    m_known.push_back(view.nextSchedule);
    m_shownRevision = 0;
    showSchedule();
    std::vector<QPointF> points;
    for (std::size_t i = 0; i < m_lastFeed.count; ++i) {
        points.emplace_back(static_cast<double>(m_lastFeed.overhang_mm[i]),
                            static_cast<double>(m_lastFeed.feed_mmPerRev[i]));
    }
    m_chart->setPoints(m_previous, points);
}

// While a part is cut its own schedule stays on the screen, whatever comes next.
void FeedPanel::showSchedule() {
    if (m_next.revision == 0) {
        m_chart->setPoints(m_schedule, {});
        return;
    }
    m_from_mm = std::min(m_next.overhangFrom_mm, m_next.overhangTo_mm);
    m_to_mm = std::max(m_next.overhangFrom_mm, m_next.overhangTo_mm);
    m_chart->setXRange(m_from_mm, m_to_mm);
    m_chart->setYIncludes({0.0});
    m_chart->setPoints(m_schedule, curveOf(m_next));
}

void FeedPanel::setStatus(const Status& status) {
    const BoringStatus& boring = status.boring;
    const std::uint32_t wanted = boring.cutting ? boring.activeSchedule : m_next.revision;
    if (wanted != m_shownRevision) {
        const auto found = std::find_if(m_known.rbegin(), m_known.rend(),
                                        [wanted](const BoringSchedule& s) { return s.revision == wanted; });
        if (found != m_known.rend()) {
            m_chart->setPoints(m_schedule, curveOf(*found));
        }
        m_shownRevision = wanted;
    }
    showLive(boring);
    if (!m_sinceText.isValid() || m_sinceText.elapsed() >= kTextPeriod_ms) {
        m_sinceText.start();
        QString text;
        if (boring.cutting && boring.feed_mmPerRev.good()) {
            text = tr("live %1").arg(m_look.units().withUnit(boring.feed_mmPerRev.value, "mm/rev", kFeedDecimals));
        } else if (!boring.cutting) {
            text = tr("not cutting");
        } else {
            text = tr("feed not known");
        }
        m_live->setText(text);
    }
}

void FeedPanel::addSamples(std::span<const Sample> samples) {
    const double length_mm = m_to_mm - m_from_mm;
    if (length_mm <= 0.0) {
        return;
    }
    for (const Sample& sample : samples) {
        if (!sample.cutting) {
            continue;
        }
        const double place = (static_cast<double>(sample.overhang_mm) - m_from_mm) / length_mm;
        if (place < 0.0 || place > 1.0) {
            continue;
        }
        // The spindle only feeds out: going back is a new part, and what the one before it left is taken away.
        if (sample.overhang_mm < m_lastOverhang_mm - static_cast<float>(length_mm / kBins)) {
            m_bins.fill(0.0F);
        }
        m_lastOverhang_mm = sample.overhang_mm;
        m_bins[std::min(kBins - 1, static_cast<std::size_t>(place * kBins))] = sample.feed_mmPerRev;
    }
}

void FeedPanel::showLive(const BoringStatus& boring) {
    if (!isVisible()) {
        return;
    }
    const bool lineIsDue = !m_sinceLine.isValid() || m_sinceLine.elapsed() >= kLinePeriod_ms || !boring.cutting;
    std::vector<QPointF> cut;
    std::vector<QPointF> point;
    if (boring.cutting) {
        for (std::size_t i = 0; lineIsDue && i < kBins; ++i) {
            if (m_bins[i] > 0.0F) {
                cut.emplace_back(m_from_mm + (m_to_mm - m_from_mm) * (static_cast<double>(i) + 0.5) / kBins,
                                 static_cast<double>(m_bins[i]));
            }
        }
        if (boring.overhang_mm.good() && boring.feed_mmPerRev.good()) {
            point.emplace_back(boring.overhang_mm.value, boring.feed_mmPerRev.value);
        }
    } else if (m_chart->drawn(m_point).isEmpty() && m_chart->drawn(m_cut).isEmpty()) {
        return;
    }
    if (lineIsDue) {
        m_sinceLine.start();
        m_chart->setPoints(m_cut, cut);
    }
    m_chart->setPoints(m_point, point);
}

}  // namespace kerf::ui
