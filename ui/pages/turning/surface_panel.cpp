// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/turning/surface_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "ui/link/vocabulary.h"
#include "ui/pages/turning/turning_texts.h"
#include "ui/widgets/clamp_label.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {
/// Of their own height whatever they say: a label that wraps makes the card's height depend on its width, and then the
/// page gives it less than its figures need.
constexpr int kBlindLines = 2;
}  // namespace

SurfacePanel::SurfacePanel(Look& look, QWidget* parent)
    : Card(look, parent),
      m_look(look),
      m_rms(new NumberDisplay(look, "um", kSurfaceDecimals, TextSize::Card, this)),
      m_pv(new NumberDisplay(look, "um", kSurfaceDecimals, TextSize::Card, this)),
      m_without(new NumberDisplay(look, "um", kSurfaceDecimals, TextSize::Card, this)),
      m_spectrum(new SpectrumChart(look, this)),
      m_axes(makeLabel(TextRole::Dim, this)),
      m_blind(new ClampLabel(kBlindLines, this)),
      m_useSpeed(new ActionButton(look, this)),
      m_columns(new QHBoxLayout),
      m_numbers(new QVBoxLayout),
      m_blindRow(new QHBoxLayout) {
    setObjectName(QStringLiteral("turningSurface"));
    m_rms->setObjectName(QStringLiteral("turningSurfaceRms"));
    m_pv->setObjectName(QStringLiteral("turningSurfacePv"));
    m_without->setObjectName(QStringLiteral("turningUntreatedRms"));
    m_spectrum->setObjectName(QStringLiteral("turningSpectrum"));
    setTextRole(m_blind, TextRole::Body);
    m_blind->setObjectName(QStringLiteral("turningBlind"));
    m_useSpeed->setObjectName(QStringLiteral("turningUseSpeed"));
    constexpr double kWidest_um = 8.888;
    for (NumberDisplay* number : {m_rms, m_pv, m_without}) {
        number->setWidest(kWidest_um);
        m_numbers->addWidget(number);
    }
    m_numbers->addStretch(1);
    header()->addWidget(m_axes);
    m_useSpeed->setFocusPolicy(Qt::TabFocus);
    m_columns->addLayout(m_numbers);
    m_blindRow->addWidget(m_blind, 1);
    m_blindRow->addWidget(m_useSpeed);
    auto* beside = new QVBoxLayout;  // the figures have the whole height of the card
    beside->addWidget(m_spectrum, 1);
    beside->addLayout(m_blindRow);
    m_columns->addLayout(beside, 1);
    body()->addLayout(m_columns, 1);
    connect(m_useSpeed, &QPushButton::clicked, this, [this] {
        if (m_blindView.suggestedSpeed_rpm) {
            emit speedWanted(*m_blindView.suggestedSpeed_rpm);
        }
    });
    connect(&look, &Look::changed, this, [this] { retranslate(); });
    retranslate();
}

void SurfacePanel::retranslate() {
    setTitle(tr("Surface as the force shows it"));
    m_rms->setLabel(termText(Term::SurfaceRms, m_look.wording()));
    m_pv->setLabel(termText(Term::SurfacePv, m_look.wording()));
    m_without->setLabel(termText(Term::UntreatedRms, m_look.wording()));
    m_columns->setSpacing(m_look.space(Space::Large));
    m_numbers->setSpacing(m_look.space(Space::Small));
    m_blindRow->setSpacing(m_look.metrics().touchGap());
    m_spectrum->retranslate();
    m_axes->setText(m_spectrum->axesText());
    showBlind();
}

void SurfacePanel::setView(const TurningServiceView& view) {
    m_spectrum->setSpectrum(view.live);
    m_blindView = view.blind;
    m_archived.clear();
    if (!view.parts.empty()) {
        const TurningRecord& last = view.parts.back().record;
        m_archived.assign(last.tones.begin(), last.tones.begin() + last.toneCount);
    }
    m_partShown = !view.parts.empty() && view.parts.back().record.valid;
    if (!m_live) {
        m_spectrum->setTones(m_archived);
        if (m_partShown) {  // whatever page was open while it was cut
            const TurningRecord& last = view.parts.back().record;
            m_rms->setValue(last.surfaceRms_um);
            m_pv->setValue(last.surfacePv_um);
            m_without->setValue(last.untreatedRms_um);
        }
    }
    showBlind();
}

void SurfacePanel::setStatus(const Status& status) {
    const TurningStatus& turning = status.turning;
    m_live = turning.stage == TurningStage::Cutting;
    if (m_live) {
        m_rms->setValue(turning.surfaceRms_um);
        m_pv->setValue(turning.surfacePv_um);
        m_without->setValue(turning.untreatedRms_um);
        const std::vector<TurningTone>& shown = m_spectrum->tones();
        bool same = shown.size() == turning.toneCount;
        for (std::size_t j = 0; j < turning.toneCount; ++j) {
            constexpr double kMoved_Hz = 0.1;
            const TurningTone& tone = turning.tones[j];
            same = same && std::any_of(shown.begin(), shown.end(), [&](const TurningTone& other) {
                       return std::abs(other.frequency_Hz - tone.frequency_Hz) < kMoved_Hz && other.blind == tone.blind;
                   });
        }
        if (!same) {
            m_spectrum->setTones({turning.tones.begin(), turning.tones.begin() + turning.toneCount});
        }
    } else if (turning.partsCut == 0 && !m_partShown) {  // figures of the last cut stay as its spectrum does
        for (NumberDisplay* number : {m_rms, m_pv, m_without}) {
            number->setNothing();
        }
    }
}

QString SurfacePanel::blindText() const {
    if (m_blindView.tones.empty()) {
        return tr("No tone of this machine is known.");
    }
    QStringList blind;
    for (const TurningBlindTone& tone : m_blindView.tones) {
        if (tone.blind) {
            blind << UnitSystem::fixed(tone.frequency_Hz, kToneDecimals);
        }
    }
    const QString speed = m_look.units().withUnit(m_blindView.spindleSpeed_rpm, "rpm", 0);
    return blind.isEmpty() ? tr("At %1 the force sees every known tone.").arg(speed)
                           : tr("At %1 the force is blind to %2 Hz: such a tone repeats with every revolution.")
                                 .arg(speed, blind.join(QStringLiteral(", ")));
}

void SurfacePanel::showBlind() {
    m_blind->say(blindText());
    const bool better = m_blindView.anyBlind && m_blindView.suggestedSpeed_rpm.has_value();
    m_useSpeed->setVisible(better);
    if (better) {
        m_useSpeed->setText(tr("Use %1").arg(m_look.units().withUnit(*m_blindView.suggestedSpeed_rpm, "rpm", 0)));
    }
}

}  // namespace kerf::ui
