// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/hold_all_button.h"

#include <QEvent>
#include <QFontMetrics>
#include <QStyle>

namespace kerf::ui {

HoldAllButton::HoldAllButton(Look& look, EngineApi& engine, QWidget* parent) : QPushButton(parent), m_look(look) {
    setObjectName(QStringLiteral("holdAll"));
    setFocusPolicy(Qt::NoFocus);
    setShortcut(QKeySequence(Qt::Key_Pause));
    setProperty("primary", true);
    connect(this, &QPushButton::pressed, this, [&engine] { engine.holdAll(); });
    connect(&look, &Look::changed, this, [this] { refresh(); });
    refresh();
}

void HoldAllButton::setHeld(bool held) {
    if (held != m_held) {
        m_held = held;
        refresh();
    }
}

void HoldAllButton::changeEvent(QEvent* event) {
    QPushButton::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        refresh();
    } else if (event->type() == QEvent::EnabledChange && !isEnabled()) {
        setEnabled(true);  // whatever is switched off around it
    }
}

void HoldAllButton::refresh() {
    const QKeySequence key = shortcut();
    setText(m_held ? tr("HELD – all loops off") : tr("HOLD ALL"));
    setShortcut(key);
    setToolTip(tr("All loops off, last offset held (Pause key). This is not an emergency stop."));
    updateGeometry();
}

// As wide as the longer of its two texts, so that nothing moves when it is pressed.
QSize HoldAllButton::sizeHint() const {
    const QFontMetrics metrics(m_look.font(TextSize::Body, QFont::Bold));
    const int text =
        qMax(metrics.horizontalAdvance(tr("HELD – all loops off")), metrics.horizontalAdvance(tr("HOLD ALL")));
    return {text + 4 * m_look.space(Space::Large), m_look.metrics().touch()};
}

}  // namespace kerf::ui
