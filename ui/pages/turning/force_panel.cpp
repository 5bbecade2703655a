// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/turning/force_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <cmath>

#include "engine/core/units.h"
#include "ui/link/force_text.h"
#include "ui/pages/turning/turning_texts.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {

constexpr double kWindow_s = 20.0;
constexpr double kChartPeriod_s = 0.03;
constexpr double kTextPeriod_s = 0.2;

}  // namespace

ForcePanel::ForcePanel(Look& look, QWidget* parent)
    : QWidget(parent),
      m_look(look),
      m_forceCard(new Card(look, this)),
      m_depthCard(new Card(look, this)),
      m_force(new LivePlot(look, kWindow_s, m_forceCard)),
      m_depth(new LivePlot(look, kWindow_s, m_depthCard)),
      m_forceNow(makeLabel(TextRole::Body, m_forceCard)),
      m_depthNow(makeLabel(TextRole::Body, m_depthCard)),
      m_signal(makeLabel(TextRole::Dim, m_forceCard, true)),
      m_swing(m_force->addCurve({Token::Past, Chart::Kind::Line, Chart::Marker::Disc, Stroke::Normal})),
      m_mean(m_force->addCurve({Token::Measured, Chart::Kind::Line, Chart::Marker::Disc, Stroke::Bold})),
      m_estimate(m_depth->addCurve({Token::Predicted, Chart::Kind::Line, Chart::Marker::Disc, Stroke::Bold})) {
    m_force->setObjectName(QStringLiteral("turningForceChart"));
    m_depth->setObjectName(QStringLiteral("turningDepthChart"));
    m_forceNow->setObjectName(QStringLiteral("turningForceNow"));
    m_depthNow->setObjectName(QStringLiteral("turningDepthNow"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_forceCard, 3);
    row->addWidget(m_depthCard, 2);
    m_forceCard->header()->addWidget(m_forceNow);
    m_depthCard->header()->addWidget(m_depthNow);
    for (auto [card, plot] : {std::pair{m_forceCard, m_force}, {m_depthCard, m_depth}}) {
        plot->setLowTitles(true);
        card->body()->addWidget(plot, 1);
    }
    m_signal->setObjectName(QStringLiteral("turningForceSignal"));
    m_forceCard->body()->addWidget(m_signal);
    m_signal->hide();
    retranslate();
}

void ForcePanel::retranslate() {
    layout()->setSpacing(m_look.space(Space::Medium));
    m_forceCard->setTitle(tr("Force, %1: extremes and mean, last %2 s", "unit, seconds")
                              .arg(m_look.units().of("N").symbol)
                              .arg(kWindow_s, 0, 'f', 0));
    m_depthCard->setTitle(
        tr("Depth, %1, last %2 s", "unit, seconds").arg(m_look.units().of("um").symbol).arg(kWindow_s, 0, 'f', 0));
    m_force->setXAxis(QStringLiteral("s"), "");
    m_depth->setXAxis(QStringLiteral("s"), "");
    m_force->setYAxis(tr("force"), "N");
    m_depth->setYAxis(tr("depth"), "um");
    m_depth->setCurveLabel(m_estimate, tr("from the force"));
    m_force->setEmptyText(tr("The force appears here as soon as a part is cut."));
    m_depth->setEmptyText(tr("The depth that is really cut appears here with the first chip."));
    m_force->setAccessibleName(tr("Force live: lowest and highest of every 5 kHz sample, mean, target"));
    m_depth->setAccessibleName(tr("Depth from the force against the programmed depth"));
    m_lastText_s = -1.0;
    m_limitsShown = false;
}

void ForcePanel::addSamples(std::span<const Sample> samples) {
    for (const Sample& sample : samples) {
        if (sample.cutting && sample.forceHigh_N != sample.forceLow_N) {
            const double time_s = static_cast<double>(sample.machineTime_ns) / kNanosecondPerSecond;
            m_force->append(m_swing, time_s, static_cast<double>(sample.forceLow_N));
            m_force->append(m_swing, time_s, static_cast<double>(sample.forceHigh_N));
        }
    }
}

void ForcePanel::setStatus(const Status& status) {
    const TurningStatus& turning = status.turning;
    const double now_s = static_cast<double>(status.machineTime_ns) / kNanosecondPerSecond;
    const bool inCut = turning.stage == TurningStage::Entry || turning.stage == TurningStage::Cutting;
    if (inCut && std::abs(now_s - m_lastSample_s) >= kChartPeriod_s) {
        m_lastSample_s = now_s;
        m_force->append(m_mean, now_s, turning.forceMean_N);
        m_depth->append(m_estimate, now_s, turning.depthEstimate_um);
    }
    if (turning.depth_um > 0.0 &&
        (!m_limitsShown || turning.forceTarget_N != m_target_N || turning.depth_um != m_depth_um)) {
        m_target_N = turning.forceTarget_N;
        m_depth_um = turning.depth_um;
        m_limitsShown = true;
        m_force->setLimits({{m_target_N, tr("target"), Token::Wanted, true, false}});
        m_depth->setLimits({{m_depth_um, tr("programmed"), Token::Wanted, true, false}});
        m_depth->setYIncludes({0.8 * m_depth_um, 1.2 * m_depth_um});
        m_force->setYIncludes({0.0});
    }
    if (!isVisible()) {
        return;
    }
    // The cut that has ended stays, whole.
    const double to_s = inCut ? now_s : m_lastSample_s;
    if (std::abs(to_s - m_lastChart_s) >= kChartPeriod_s) {
        m_lastChart_s = to_s;
        m_force->advance(to_s);
        m_depth->advance(to_s);
    }
    if (m_lastText_s < 0.0 || std::abs(now_s - m_lastText_s) >= kTextPeriod_s) {
        m_lastText_s = now_s;
        const UnitSystem& units = m_look.units();
        m_forceNow->setText(inCut ? tr("mean %1").arg(units.withUnit(turning.forceMean_N, "N", kForceDecimals))
                                  : stageName(turning.stage));
        const QString signal = forceSignalText({turning.signal, turning.zero, turning.forceZero_N, turning.zeroDoubt_N},
                                               units, kForceDecimals);
        m_signal->setText(signal);
        m_signal->setVisible(!signal.isEmpty());
        m_depthNow->setText(inCut ? units.withUnit(turning.depthEstimate_um, "um", kDepthDecimals) : QString());
    }
}

}  // namespace kerf::ui
