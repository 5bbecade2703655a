// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/label.h"

#include <QStyle>

namespace kerf::ui {

QLabel* makeLabel(TextRole role, QWidget* parent, bool wrap) {
    auto* label = new QLabel(parent);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(wrap);
    setTextRole(label, role);
    return label;
}

void setTextRole(QLabel* label, TextRole role) {
    const char* name = "";
    switch (role) {
        case TextRole::Body:
            name = "body";
            break;
        case TextRole::Dim:
            name = "dim";
            break;
        case TextRole::Small:
            name = "label";
            break;
        case TextRole::Title:
            name = "title";
            break;
        case TextRole::CardNumber:
            name = "card";
            break;
    }
    if (label->property("role").toString() == QLatin1String(name)) {
        return;
    }
    label->setProperty("role", QLatin1String(name));
    label->style()->unpolish(label);
    label->style()->polish(label);
}

QFrame* makeRule(Qt::Orientation orientation, QWidget* parent) {
    auto* rule = new QFrame(parent);
    rule->setProperty("role", QStringLiteral("rule"));
    if (orientation == Qt::Horizontal) {
        rule->setFixedHeight(1);
    } else {
        rule->setFixedWidth(1);
    }
    return rule;
}

}  // namespace kerf::ui
