// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/milling/live_panel.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include "ui/link/force_text.h"
#include "ui/pages/milling/milling_texts.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {

constexpr int kChartPeriod_ms = 30;
constexpr double kWindow_s = 60.0;
constexpr double kWidestForce_N = 8888.0;
constexpr double kWidestFeed_mmPerS = 88.0;

}  // namespace

MillingLivePanel::MillingLivePanel(Look& look, QWidget* parent)
    : Card(look, parent),
      m_look(look),
      m_grid(new QGridLayout),
      m_force(new LivePlot(look, kWindow_s, this)),
      m_feed(new LivePlot(look, kWindow_s, this)),
      m_forceNow(new NumberDisplay(look, "N", kForceDecimals, TextSize::Page, this)),
      m_feedNow(new NumberDisplay(look, "mm/s", kFeedRateDecimals, TextSize::Page, this)),
      m_raw(new QPushButton(this)),
      m_signal(makeLabel(TextRole::Dim, this, true)),
      m_rawCurve(m_force->addCurve({Token::Past, Chart::Kind::Line, Chart::Marker::Disc, Stroke::Thin})),
      m_average(m_force->addCurve({Token::Measured, Chart::Kind::Line, Chart::Marker::Disc, Stroke::Normal})),
      m_wanted(m_feed->addCurve({Token::Wanted, Chart::Kind::Dashed, Chart::Marker::Disc, Stroke::Normal})),
      m_made(m_feed->addCurve({Token::Measured, Chart::Kind::Line, Chart::Marker::Disc, Stroke::Normal})) {
    setObjectName(QStringLiteral("millingLive"));
    m_force->setObjectName(QStringLiteral("millingForceChart"));
    m_feed->setObjectName(QStringLiteral("millingFeedChart"));
    m_forceNow->setObjectName(QStringLiteral("millingForce"));
    m_feedNow->setObjectName(QStringLiteral("millingFeed"));
    m_raw->setObjectName(QStringLiteral("millingRawForce"));
    m_signal->setObjectName(QStringLiteral("millingForceSignal"));
    m_raw->setCheckable(true);
    m_raw->setFocusPolicy(Qt::TabFocus);
    m_forceNow->setWidest(kWidestForce_N);
    m_feedNow->setWidest(kWidestFeed_mmPerS);
    for (LivePlot* plot : {m_force, m_feed}) {
        plot->setLowTitles(true);
        plot->setYIncludes({0.0});
    }
    auto* forceSide = new QVBoxLayout;
    forceSide->addWidget(m_forceNow);
    forceSide->addStretch(1);
    forceSide->addWidget(m_raw);
    auto* feedSide = new QVBoxLayout;
    feedSide->addWidget(m_feedNow);
    feedSide->addStretch(1);
    m_grid->addWidget(m_force, 0, 0);
    m_grid->addLayout(forceSide, 0, 1);
    m_grid->addWidget(m_feed, 1, 0);
    m_grid->addLayout(feedSide, 1, 1);
    m_grid->setColumnStretch(0, 1);
    m_grid->setRowStretch(0, 3);
    m_grid->setRowStretch(1, 2);
    body()->addLayout(m_grid, 1);
    body()->addWidget(m_signal);
    m_signal->hide();
    connect(m_raw, &QPushButton::toggled, this, [this](bool on) {
        if (!on) {
            m_force->setPoints(m_rawCurve, {});
        }
    });
    connect(&look, &Look::changed, this, [this] { retranslate(); });
    retranslate();
}

void MillingLivePanel::retranslate() {
    const UnitSystem& units = m_look.units();
    setTitle(tr("Force per revolution, %1, and feed, %2", "units").arg(units.of("N").symbol, units.of("mm/s").symbol));
    m_grid->setHorizontalSpacing(m_look.space(Space::Medium));
    m_grid->setVerticalSpacing(m_look.space(Space::Medium));
    m_force->setXAxis(tr("time"), "s");
    m_force->setYAxis(tr("force"), "N");
    m_feed->setXAxis(tr("time"), "s");
    m_feed->setYAxis(tr("feed"), "mm/s");
    m_force->setCurveLabel(m_average, tr("average"));
    m_feed->setCurveLabel(m_wanted, tr("wanted"));
    m_force->setEmptyText(tr("The cutting force appears here with the next cut."));
    m_feed->setEmptyText(tr("The feed appears here with the next cut."));
    m_force->setAccessibleName(tr("Cutting force averaged per revolution, over time"));
    m_feed->setAccessibleName(tr("Feed made and wanted, over time"));
    m_forceNow->setLabel(tr("force"));
    m_feedNow->setLabel(tr("feed"));
    m_raw->setText(tr("Raw force"));
    showLimits(m_reference_N, m_overload_N);
    m_feed->setLimits({{m_setup.plannedFeed_mmPerS, tr("planned"), Token::Past, true, true}});
}

void MillingLivePanel::showLimits(double reference_N, double overload_N) {
    m_reference_N = reference_N;
    m_overload_N = overload_N;
    std::vector<Chart::Limit> limits;
    if (reference_N > 0.0) {
        limits.push_back({reference_N, tr("reference"), Token::Wanted, true, false});
    }
    if (overload_N > 0.0) {
        limits.push_back({overload_N, tr("limit"), Token::Limit, false, true});
    }
    m_force->setLimits(std::move(limits));
}

void MillingLivePanel::setSetup(const MillingSetup& setup) {
    m_setup = setup;
    retranslate();
}

void MillingLivePanel::setStatus(const Status& status) {
    const MillingStatus& milling = status.milling;
    if (milling.setup != 0 && (milling.reference_N != m_reference_N || milling.overload_N != m_overload_N)) {
        showLimits(milling.reference_N, milling.overload_N);
    }
    showSignal(milling);
    if (milling.cutting) {
        m_forceNow->setReading(milling.force_N, status.machineTime_ns);
        m_feedNow->setReading(status.actualFeed_mmPerS, status.machineTime_ns);
        if (!m_sinceChart.isValid() || m_sinceChart.elapsed() >= kChartPeriod_ms) {
            m_sinceChart.start();
            const double now_s = static_cast<double>(status.machineTime_ns) * 1e-9;
            m_force->advance(now_s);
            m_feed->advance(now_s);
        }
    } else {
        m_forceNow->setNothing();
        m_feedNow->setNothing();
        if (m_lastSample_s > m_shownTo_s) {  // the cut that has ended stays, whole
            m_shownTo_s = m_lastSample_s;
            m_force->advance(m_lastSample_s);
            m_feed->advance(m_lastSample_s);
        }
    }
    m_feedNow->setLimited(milling.cutting && status.feedScaleLimited);
}

void MillingLivePanel::showSignal(const MillingStatus& milling) {
    QString text = forceSignalText({milling.signal, milling.zero, milling.zero_N, milling.zeroDoubt_N}, m_look.units(),
                                   kForceDecimals);
    if (!text.isEmpty() && milling.decisions_Hz > 0.0) {
        text += QStringLiteral(", ") + tr("loop %1 Hz").arg(milling.decisions_Hz, 0, 'f', 1);
    }
    if (!text.isEmpty() && !milling.teethSeen) {
        text += QStringLiteral(", ") + tr("breakage not seen");
    }
    m_signal->setText(text);
    m_signal->setVisible(!text.isEmpty());
}

void MillingLivePanel::addSamples(std::span<const Sample> samples, bool blind) {
    for (const Sample& sample : samples) {
        const double time_s = static_cast<double>(sample.machineTime_ns) * 1e-9;
        m_lastSample_s = sample.cutting ? time_s : m_lastSample_s;
        if (!blind) {
            m_force->append(m_average, time_s, static_cast<double>(sample.force_N));
            if (m_raw->isChecked()) {  // both in one curve: a column is drawn from its lowest to its highest value
                m_force->append(m_rawCurve, time_s, static_cast<double>(sample.forceLow_N));
                m_force->append(m_rawCurve, time_s, static_cast<double>(sample.forceHigh_N));
            }
        }
        m_feed->append(m_made, time_s, static_cast<double>(sample.feed_mmPerS));
        m_feed->append(m_wanted, time_s, static_cast<double>(sample.wantedFeed_mmPerS));
    }
}

}  // namespace kerf::ui
