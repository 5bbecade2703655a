// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/tapping/gains_panel.h"

#include <QGridLayout>
#include <QPainter>
#include <QPushButton>
#include <algorithm>
#include <cmath>

#include "ui/link/texts.h"
#include "ui/link/vocabulary.h"
#include "ui/pages/tapping/tapping_texts.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {

constexpr double kOneDecade_dB = 20.0;
constexpr double kPercent = 100.0;
constexpr double kAirRatio = 1.3;    ///< beyond the marks of the safe bar
constexpr double kDriftAlarm = 0.5;  ///< TappingStatus::driftShare that asks for a new tune

double margin_dB(const TappingServiceView& view) {
    return kOneDecade_dB * std::log10(view.criticalZKp_perS / std::max(view.inForce.zKp_perS, 1e-9));
}

}  // namespace

SafeBar::SafeBar(Look& look, QWidget* parent) : FaceWidget(look, parent) {
    setObjectName(QStringLiteral("tappingSafeBar"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void SafeBar::setView(const TappingServiceView& view) {
    m_view = view;
    update();
}

QSize SafeBar::minimumSizeHint() const {
    return {look().metrics().chart(), 2 * look().space(Space::Large)};
}

void SafeBar::paintEvent(QPaintEvent*) {
    if (m_view.criticalZKp_perS <= 0.0 || m_view.lowestZKp_perS <= 0.0) {
        return;
    }
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double inset = look().space(Space::Medium);
    const QRectF line(inset, 0.0, width() - 2.0 * inset, height());
    // Gains are ratios: the scale is logarithmic.
    const double bottom_perS = m_view.lowestZKp_perS / kAirRatio;
    const double span = std::log(std::max(m_view.criticalZKp_perS, m_view.highestZKp_perS) * kAirRatio / bottom_perS);
    const auto x = [&](double gain_perS) {
        return line.left() + std::clamp(std::log(gain_perS / bottom_perS) / span, 0.0, 1.0) * line.width();
    };
    const double middle = height() / 2.0;
    const double r = inset / 2.0;
    painter.setPen(look().pen(Token::Line, Stroke::Normal));
    painter.drawLine(QPointF(line.left(), middle), QPointF(line.right(), middle));
    painter.fillRect(
        QRectF(QPointF(x(m_view.lowestZKp_perS), middle - r), QPointF(x(m_view.highestZKp_perS), middle + r)),
        look().palette().band(Token::Measured));
    painter.setPen(look().pen(Token::Limit, Stroke::Normal));
    for (const double gain_perS : {m_view.lowestZKp_perS, m_view.highestZKp_perS}) {
        painter.drawLine(QPointF(x(gain_perS), middle - 2.0 * r), QPointF(x(gain_perS), middle + 2.0 * r));
    }
    painter.setPen(look().pen(Token::Text, Stroke::Bold));
    painter.drawLine(QPointF(x(m_view.criticalZKp_perS), 0.0), QPointF(x(m_view.criticalZKp_perS), height()));
    painter.setPen(Qt::NoPen);
    if (m_view.state == TuningState::Proposed && !m_view.finished) {
        const double at = x(m_view.next.zKp_perS);
        painter.setBrush(look().color(Token::Predicted));
        painter.drawPolygon(QPolygonF{QPointF(at, middle - inset), QPointF(at + inset, middle),
                                      QPointF(at, middle + inset), QPointF(at - inset, middle)});
    }
    painter.setBrush(look().color(Token::Measured));
    painter.drawEllipse(QPointF(x(m_view.inForce.zKp_perS), middle), 1.5 * r, 1.5 * r);
}

GainsPanel::GainsPanel(Look& look, QWidget* parent)
    : Card(look, parent),
      m_look(look),
      m_state(makeLabel(TextRole::Body, this)),
      m_grid(new QGridLayout),
      m_bar(new SafeBar(look, this)),
      m_safe(makeLabel(TextRole::Small, this, true)),
      m_reason(makeLabel(TextRole::Body, this, true)),
      m_drift(makeLabel(TextRole::Small, this, true)),
      m_loopReason(makeLabel(TextRole::Small, this, true)),
      m_modes(new ModeButtons(look, ProcessId::Tapping, this)) {
    setObjectName(QStringLiteral("tappingGains"));
    m_state->setObjectName(QStringLiteral("tappingState"));
    m_safe->setObjectName(QStringLiteral("tappingSafe"));
    m_reason->setObjectName(QStringLiteral("tappingReason"));
    m_drift->setObjectName(QStringLiteral("tappingDrift"));
    m_loopReason->setObjectName(QStringLiteral("tappingLoopReason"));
    header()->addWidget(m_state);
    for (std::size_t column = 0; column < kColumns; ++column) {
        m_heads[column] = makeLabel(TextRole::Small, this);
        m_heads[column]->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        m_grid->addWidget(m_heads[column], 0, static_cast<int>(column) + 1);
    }
    for (std::size_t row = 0; row < kRows; ++row) {
        m_names[row] = makeLabel(TextRole::Small, this);
        m_grid->addWidget(m_names[row], static_cast<int>(row) + 1, 0);
        for (std::size_t column = 0; column < kColumns; ++column) {
            QLabel* cell = makeLabel(column == 1 ? TextRole::Body : TextRole::Dim, this);
            cell->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
            cell->setObjectName(QStringLiteral("tappingGain%1%2").arg(row).arg(column));
            m_cells[row][column] = cell;
            m_grid->addWidget(cell, static_cast<int>(row) + 1, static_cast<int>(column) + 1);
        }
    }
    m_grid->setColumnStretch(0, 1);
    body()->addLayout(m_grid);
    body()->addWidget(m_bar);
    body()->addWidget(m_safe);
    body()->addWidget(m_reason);
    body()->addWidget(m_drift);
    body()->addStretch(1);
    body()->addWidget(m_loopReason);
    body()->addWidget(m_modes);
    connect(m_modes, &ModeButtons::modeRequested, this, &GainsPanel::modeRequested);
    connect(&look, &Look::changed, this, [this] { retranslate(); });
    retranslate();
}

void GainsPanel::setSession(OperatorSession& session) {
    m_modes->setSession(session);
    connect(m_modes, &ModeButtons::permissionChanged, this, &GainsPanel::showLoop);
    showLoop();
}

void GainsPanel::retranslate() {
    const auto name = [this](Term term) { return termText(term, m_look.wording()); };
    setTitle(name(Term::GainsTitle));
    m_heads[0]->setText(tr("before"));
    m_heads[1]->setText(tr("now"));
    m_heads[2]->setText(tr("next"));
    m_names[0]->setText(name(Term::SpindleGain));
    m_names[1]->setText(name(Term::ZGain));
    m_names[2]->setText(name(Term::SpeedFeedForward));
    m_names[3]->setText(name(Term::AccelFeedForward));
    m_names[4]->setText(tr("trim, %1", "largest learned trim, unit").arg(m_look.units().of("um").symbol));
    m_grid->setHorizontalSpacing(m_look.space(Space::Medium));
    m_grid->setVerticalSpacing(m_look.space(Space::Hair));
    showView();
    showLoop();
}

void GainsPanel::setView(const TappingServiceView& view) {
    m_view = view;
    showView();
}

void GainsPanel::showView() {
    m_state->setText(stateText(m_view));
    const UnitSystem& units = m_look.units();
    const bool proposes = m_view.state == TuningState::Proposed && !m_view.finished;
    const TapSettingsView* before = m_view.proof            ? &m_view.proof->before
                                    : m_view.trials.empty() ? nullptr
                                                            : &m_view.trials.front().settings;
    const TapSettingsView* settings[kColumns] = {before, &m_view.inForce, proposes ? &m_view.next : nullptr};
    const std::array<int, kRows> decimals{kGainDecimals, kGainDecimals, 4, 3, kErrorDecimals};
    for (std::size_t column = 0; column < kColumns; ++column) {
        m_heads[column]->setVisible(column < 2 || proposes);
        for (std::size_t row = 0; row < kRows; ++row) {
            QString text = QStringLiteral("–");
            if (settings[column] != nullptr) {
                const TapSettingsView& s = *settings[column];
                const std::array<double, kRows> values{s.spindleKp_perS, s.zKp_perS, s.zVelocityFf, s.zAccelFf,
                                                       s.trimPeak_um};
                text = row == 4 ? units.number(values[row], "um", decimals[row])
                                : UnitSystem::fixed(values[row], decimals[row]);
            }
            m_cells[row][column]->setText(text);
            m_cells[row][column]->setVisible(column < 2 || proposes);
        }
    }
    const bool known = m_view.criticalZKp_perS > 0.0;
    m_bar->setView(m_view);
    m_bar->setVisible(known);
    m_safe->setText(
        known ? tr("Safe Z gain %1 to %2 1/s; unstable from about %3 1/s, %4 dB away.")
                    .arg(UnitSystem::fixed(m_view.lowestZKp_perS, 1), UnitSystem::fixed(m_view.highestZKp_perS, 1),
                         UnitSystem::fixed(m_view.criticalZKp_perS, 0), UnitSystem::fixed(margin_dB(m_view), 1))
              : tr("The safe set of gains is estimated with the first trial tap."));
    const bool decided = m_view.state == TuningState::Done;
    QString reason = decided && m_view.help.empty() ? QString() : sentenceText(m_view.reason, units);
    if (!m_view.help.empty()) reason += QLatin1Char(' ') + sentenceText(m_view.help, units);
    m_reason->setText(reason.isEmpty() ? sourceText(m_view) : reason);
}

void GainsPanel::setStatus(const Status& status) {
    const LoopStatus& loop = status.loops[static_cast<std::size_t>(ProcessId::Tapping)];
    const bool same =
        loop.mode == m_loop.mode && loop.fitted == m_loop.fitted && loop.state == m_loop.state &&
        loop.reason.text == m_loop.reason.text && m_tapping.productionTaps == status.tapping.productionTaps &&
        m_tapping.wantsTuning == status.tapping.wantsTuning && m_tapping.driftShare == status.tapping.driftShare;
    m_loop = loop;
    m_tapping = status.tapping;
    if (!same) {
        showLoop();
    }
}

void GainsPanel::showLoop() {
    m_modes->setLoop(m_loop);
    const QString why = sentenceText(m_loop.reason, m_look.units());
    m_loopReason->setText(m_loop.fitted ? m_modes->words() : tr("This machine has no tapping loop: %1").arg(why));
    const int percent = static_cast<int>(std::lround(kPercent * std::min(1.0, m_tapping.driftShare / kDriftAlarm)));
    m_drift->setVisible(m_tapping.productionTaps > 0);
    m_drift->setText(m_tapping.wantsTuning ? tr("Tune again: the sum of errors has grown above that of the first taps.")
                                           : tr("Drift watch: %1 % of what asks for a new tune, after %2 taps.")
                                                 .arg(percent)
                                                 .arg(m_tapping.productionTaps));
}

}  // namespace kerf::ui
