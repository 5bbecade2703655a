// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/mode_buttons.h"

#include <QButtonGroup>
#include <QEvent>
#include <QHBoxLayout>

#include "ui/link/texts.h"

namespace kerf::ui {
namespace {

constexpr std::array kModes{LoopMode::Off, LoopMode::Advise, LoopMode::Control};
constexpr std::array kNames{"ModeOff", "ModeAdvise", "ModeControl"};

}  // namespace

ModeButtons::ModeButtons(Look& look, ProcessId process, QWidget* parent)
    : QWidget(parent), m_look(look), m_row(new QHBoxLayout(this)) {
    m_row->setContentsMargins(0, 0, 0, 0);
    auto* group = new QButtonGroup(this);
    for (std::size_t i = 0; i < kModes.size(); ++i) {
        auto* button = new QPushButton(this);
        button->setObjectName(QLatin1String(processKey(process)) + QLatin1String(kNames[i]));
        button->setCheckable(true);
        button->setFocusPolicy(Qt::TabFocus);
        group->addButton(button, static_cast<int>(i));
        m_row->addWidget(button, 1);
        m_buttons[i] = button;
    }
    connect(group, &QButtonGroup::idClicked, this, [this](int id) {
        apply();  // the engine says what the mode is, not the touch
        emit modeRequested(kModes[static_cast<std::size_t>(id)]);
    });
    connect(&look, &Look::changed, this, [this] { retranslate(); });
    retranslate();
}

void ModeButtons::setSession(OperatorSession& session) {
    m_session = &session;
    connect(&session, &OperatorSession::changed, this, [this] {
        apply();
        emit permissionChanged();
    });
    apply();
}

void ModeButtons::setLoop(const LoopStatus& loop) {
    m_loop = loop;
    apply();
}

QString ModeButtons::whyNot() const {
    return m_session != nullptr && m_loop.fitted ? m_session->whyNot(Deed::SwitchLoop) : QString();
}

QString ModeButtons::words() const {
    const QString reason = sentenceText(m_loop.reason, m_look.units());
    const QString state = stateName(m_loop.state);
    if (const QString why = whyNot(); !why.isEmpty()) {
        return state + QStringLiteral(" · ") + why;
    }
    return reason.isEmpty() ? state : state + QStringLiteral(": ") + reason;
}

void ModeButtons::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    }
}

void ModeButtons::retranslate() {
    for (std::size_t i = 0; i < kModes.size(); ++i) {
        m_buttons[i]->setText(modeName(kModes[i]));
    }
    m_row->setSpacing(m_look.metrics().touchGap());
    apply();
}

void ModeButtons::apply() {
    const QString why = whyNot();
    for (std::size_t i = 0; i < kModes.size(); ++i) {
        m_buttons[i]->setChecked(m_loop.mode == kModes[i]);
        m_buttons[i]->setEnabled(m_loop.fitted && why.isEmpty());
        m_buttons[i]->setAccessibleDescription(why);
    }
}

}  // namespace kerf::ui
