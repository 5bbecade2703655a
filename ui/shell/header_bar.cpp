// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/header_bar.h"

#include <QHBoxLayout>

#include "ui/widgets/label.h"

namespace kerf::ui {

namespace {
constexpr double kLongestName_mm = 32.0;
}

HeaderBar::HeaderBar(Look& look, OperatorSession& session, QWidget* parent)
    : FaceWidget(look, parent),
      m_session(session),
      m_path(makeLabel(TextRole::Title, this)),
      m_lots(new QPushButton(this)),
      m_link(new Lamp(look, this)),
      m_speed(new QPushButton(this)),
      m_clock(makeLabel(TextRole::Body, this)),
      m_operator(new QPushButton(this)),
      m_language(new QPushButton(this)),
      m_help(new QPushButton(this)),
      m_settings(new QPushButton(this)) {
    m_path->setObjectName(QStringLiteral("path"));
    m_path->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_lots->setObjectName(QStringLiteral("lots"));
    m_lots->hide();
    m_link->setObjectName(QStringLiteral("link"));
    m_speed->setObjectName(QStringLiteral("simulationSpeed"));
    m_operator->setObjectName(QStringLiteral("operator"));
    m_language->setObjectName(QStringLiteral("language"));
    m_help->setObjectName(QStringLiteral("help"));
    m_help->setCheckable(true);
    m_help->setText(QStringLiteral("?"));
    m_settings->setObjectName(QStringLiteral("settings"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_path, 1);
    row->addWidget(m_lots);
    row->addWidget(m_link);
    row->addWidget(m_speed);
    row->addWidget(m_clock);
    row->addWidget(m_operator);
    row->addWidget(m_language);
    row->addWidget(m_help);
    row->addWidget(m_settings);
    connect(m_lots, &QPushButton::clicked, this, &HeaderBar::lotsRequested);
    connect(m_operator, &QPushButton::clicked, this, &HeaderBar::operatorRequested);
    connect(m_speed, &QPushButton::clicked, this, &HeaderBar::speedRequested);
    connect(m_help, &QPushButton::clicked, this, &HeaderBar::helpRequested);
    connect(m_settings, &QPushButton::clicked, this, &HeaderBar::settingsRequested);
    connect(&session, &OperatorSession::changed, this, &HeaderBar::rebuild);
    connect(m_language, &QPushButton::clicked, this, &HeaderBar::languageRequested);
    refresh();
}

void HeaderBar::setStatus(const Status& status, const Capabilities& capabilities) {
    const QString machine = QString::fromUtf8(capabilities.machineName.data());
    if (machine == m_machine && status.link == m_linkState && status.machineOn == m_machineOn &&
        status.emergencyStop == m_emergencyStop && capabilities.simulated == m_simulated &&
        status.simulationSpeed == m_factor) {
        return;
    }
    m_machine = machine;
    m_linkState = status.link;
    m_machineOn = status.machineOn;
    m_emergencyStop = status.emergencyStop;
    m_simulated = capabilities.simulated;
    m_factor = status.simulationSpeed;
    rebuild();
}

void HeaderBar::setWork(const BoringServiceView* view, const Status& status) {
    QStringList work;
    if (view != nullptr && !view->partType.empty()) {
        work << QString::fromStdString(view->partType);
        work << tr("lot %1").arg(QString::fromStdString(view->lot));
        std::uint32_t part = 0;
        for (const BorePartView& p : view->parts) {
            part = std::max(part, p.cut ? p.number : p.number - 1);
        }
        const bool cutting = status.program == ProgramState::Running || status.program == ProgramState::Paused;
        work << tr("part %1/%2")
                    .arg(std::min(part + (cutting ? 1 : 0), std::max(view->lotSize, part)))
                    .arg(view->lotSize);
        if (view->lotClosed) {
            work << tr("closed");
        } else if (lotFull(*view) && !cutting) {
            work << tr("full");
        }
    }
    if (work != m_work) {
        m_work = work;
        rebuild();
    }
}

void HeaderBar::setTime(const QString& clock) {
    if (clock != m_clock->text()) {
        m_clock->setText(clock);
    }
}

void HeaderBar::rebuild() {
    QStringList path{m_machine};
    path += m_work;
    path.removeAll(QString());
    m_path->setText(path.join(QStringLiteral("  ▸  ")));
    m_path->setToolTip(m_path->text());
    if (m_emergencyStop) {
        m_link->set(Sign::Held, tr("emergency stop"));
    } else if (m_linkState == LinkState::Up) {
        m_link->set(m_machineOn ? Sign::Up : Sign::Off, m_machineOn ? tr("connected") : tr("machine off"));
    } else {
        m_link->set(Sign::Off, m_linkState == LinkState::Connecting ? tr("connecting") : tr("no link"));
    }
    m_speed->setVisible(m_simulated);
    m_speed->setText(m_factor > 0.0 ? tr("simulator ×%1").arg(m_factor) : tr("simulator, free run"));
    const QFontMetrics metrics(look().font(TextSize::Body));
    m_operator->setText(m_session.signedOn()
                            ? metrics.elidedText(m_session.name(), Qt::ElideRight, look().px(kLongestName_mm))
                            : tr("Sign on"));
    m_operator->setToolTip(m_session.name());
}

void HeaderBar::refresh() {
    // Shows the language it switches to, in that language.
    m_language->setText(look().preferences().language == Language::Korean ? QStringLiteral("EN")
                                                                          : QStringLiteral("한"));
    m_language->setAccessibleName(tr("Language"));
    m_lots->setText(tr("Lots"));
    m_help->setAccessibleName(tr("Help: touch what you want explained"));
    m_help->setToolTip(m_help->accessibleName());
    m_settings->setText(tr("Settings"));
    layout()->setSpacing(look().metrics().touchGap());
    rebuild();
    FaceWidget::refresh();
}

}  // namespace kerf::ui
