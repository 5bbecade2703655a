// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/turning/margin_panel.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/link/vocabulary.h"
#include "ui/pages/turning/turning_texts.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {
constexpr std::int64_t kMarginPeriod_ns = 200'000'000;
constexpr double kShownGain = 99.0;
}  // namespace

TrimBar::TrimBar(Look& look, QWidget* parent) : FaceWidget(look, parent) {
    setObjectName(QStringLiteral("turningTrimBar"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    refresh();
}

void TrimBar::set(double trim_um, double authority_um) {
    m_trim_um = trim_um;
    m_authority_um = authority_um;
    update();
}

QSize TrimBar::sizeHint() const {
    return {look().metrics().chart() / 2, look().metrics().lamp() + look().space(Space::Small)};
}

void TrimBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF area = QRectF(rect()).adjusted(1, 1, -1, -1);
    const double middle = area.center().y();
    const double half = area.width() / 2.0;
    painter.setPen(look().pen(Token::Line, Stroke::Normal));
    painter.drawLine(QPointF(area.left(), middle), QPointF(area.right(), middle));
    painter.setPen(look().pen(Token::Limit, Stroke::Normal));
    for (const double x : {area.left(), area.right()}) {
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    }
    painter.setPen(look().pen(Token::Dim, Stroke::Thin));
    painter.drawLine(QPointF(area.center().x(), area.top()), QPointF(area.center().x(), area.bottom()));
    if (m_authority_um <= 0.0) {
        return;
    }
    const double share = std::clamp(m_trim_um / m_authority_um, -1.0, 1.0);
    painter.setPen(Qt::NoPen);
    painter.setBrush(look().color(Token::Measured));
    const double radius = look().metrics().lamp() / 3.0;
    painter.drawEllipse(QPointF(area.center().x() + share * (half - radius), middle), radius, radius);
}

MarginPanel::MarginPanel(Look& look, QWidget* parent)
    : Card(look, parent),
      m_look(look),
      m_grid(new QGridLayout),
      m_gain(new NumberDisplay(look, "", 1, TextSize::Body, this)),
      m_phase(new NumberDisplay(look, "°", 0, TextSize::Body, this)),
      m_delay(new NumberDisplay(look, "ms", 2, TextSize::Body, this)),
      m_modulus(new NumberDisplay(look, "", 2, TextSize::Body, this)),
      m_note(makeLabel(TextRole::Small, this, true)),
      m_trim(makeLabel(TextRole::Body, this)),
      m_bar(new TrimBar(look, this)) {
    setObjectName(QStringLiteral("turningMargins"));
    m_gain->setObjectName(QStringLiteral("turningGainMargin"));
    m_phase->setObjectName(QStringLiteral("turningPhaseMargin"));
    m_delay->setObjectName(QStringLiteral("turningDelayMargin"));
    m_modulus->setObjectName(QStringLiteral("turningModulusMargin"));
    m_note->setObjectName(QStringLiteral("turningMarginNote"));
    m_trim->setObjectName(QStringLiteral("turningTrim"));
    int place = 0;
    for (NumberDisplay* number : {m_gain, m_phase, m_delay, m_modulus}) {
        number->setWidest(kShownGain);
        m_grid->addWidget(number, place / 2, place % 2);
        ++place;
    }
    body()->addLayout(m_grid);
    body()->addWidget(m_note);
    body()->addStretch(1);
    auto* trim = new QHBoxLayout;
    trim->addWidget(m_trim);
    trim->addWidget(m_bar, 1);
    body()->addLayout(trim);
    connect(&look, &Look::changed, this, [this] { retranslate(); });
    retranslate();
}

void MarginPanel::retranslate() {
    const auto name = [this](Term term) { return termText(term, m_look.wording()); };
    setTitle(name(Term::MarginsTitle));
    m_gain->setLabel(name(Term::GainMargin));
    m_phase->setLabel(name(Term::PhaseMargin));
    m_delay->setLabel(name(Term::DelayMargin));
    m_modulus->setLabel(name(Term::ModulusMargin));
    m_grid->setHorizontalSpacing(m_look.space(Space::Large));
    m_grid->setVerticalSpacing(m_look.space(Space::Small));
    m_shown_ns = -1;
    showMargins();
}

void MarginPanel::setView(const TurningServiceView& view) {
    m_margins = view.margins;
    m_authority_um = view.setup.trimAuthority_um;
    showMargins();
}

void MarginPanel::showMargins() {
    constexpr double kSample_ms = 0.2;
    if (m_margins.known) {
        m_gain->setValue(std::min(kShownGain, m_margins.gain.value_or(kShownGain)));
        m_phase->setValue(m_margins.phase_deg);
        m_delay->setValue(m_margins.delay_samples.value_or(0.0) * kSample_ms);
        m_modulus->setValue(m_margins.modulus);
    } else {
        for (NumberDisplay* number : {m_gain, m_phase, m_delay, m_modulus}) {
            number->setNothing();
        }
    }
    m_note->setText(!m_margins.known       ? tr("Margins appear as soon as a law acts.")
                    : m_margins.identified ? tr("Guaranteed for every process within the 95 % intervals.")
                                           : tr("For the process the law assumes; it is not identified."));
    const auto words = [this](double trim_um) {
        return tr("trim %1 of ± %2", "applied trim, authority")
            .arg(m_look.units().withUnit(trim_um, "um", kDepthDecimals),
                 m_look.units().withUnit(m_authority_um, "um", kDepthDecimals));
    };
    m_trim->setText(words(m_applied_um));
    // A minus sign that comes and goes must not move the bar, nor be cut off until it has moved.
    const QFontMetrics metrics = m_trim->fontMetrics();
    const QString widest = words(-m_authority_um);
    m_trim->setMinimumWidth(std::max(metrics.size(0, widest).width(), metrics.boundingRect(widest).width()) +
                            metrics.averageCharWidth());
    m_bar->set(m_applied_um, m_authority_um);
}

void MarginPanel::setStatus(const Status& status) {
    if (std::abs(status.machineTime_ns - m_shown_ns) < kMarginPeriod_ns) {
        return;
    }
    m_shown_ns = status.machineTime_ns;
    m_applied_um = status.turning.stage == TurningStage::Idle ? 0.0 : status.turning.appliedTrim_um;
    showMargins();
}

}  // namespace kerf::ui
