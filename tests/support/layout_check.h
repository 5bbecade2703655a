// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QFontMetrics>
#include <QLabel>
#include <QLineEdit>
#include <QStringList>
#include <QWidget>

#include "ui/theme/look.h"

namespace kerf::test {

inline QString nameOf(const QWidget* widget) {
    QString name = QString::fromLatin1(widget->metaObject()->className());
    for (const QWidget* w = widget; w != nullptr; w = w->parentWidget()) {
        if (!w->objectName().isEmpty() && !w->objectName().startsWith(QStringLiteral("qt_"))) {
            return name + u'#' + w->objectName();
        }
    }
    return name;
}

inline bool insideScrollArea(const QWidget* widget) {
    for (const QWidget* w = widget->parentWidget(); w != nullptr; w = w->parentWidget()) {
        if (qobject_cast<const QAbstractScrollArea*>(w) != nullptr) {
            return true;
        }
    }
    return false;
}

/// Every visible text that does not fit where it stands, and every widget that sticks out of its parent.
inline QStringList clippedTexts(const QWidget* root) {
    QStringList problems;
    for (const QWidget* widget : root->findChildren<QWidget*>()) {
        if (!widget->isVisibleTo(root) || widget->width() == 0) {
            continue;
        }
        const QWidget* parent = widget->parentWidget();
        const bool inside = parent == nullptr || parent->rect().adjusted(-1, -1, 1, 1).contains(widget->geometry());
        if (!inside && !insideScrollArea(widget)) {
            problems << QStringLiteral("%1 sticks out of its parent").arg(nameOf(widget));
        }
        QString text;
        QSize needed;
        if (widget->property("elides").toBool()) {
            needed = widget->minimumSizeHint();  // a sentence that ends in an ellipsis, where it has its place
        } else if (const auto* label = qobject_cast<const QLabel*>(widget)) {
            text = label->text();
            const QFontMetrics metrics(label->font());
            const int flags = label->wordWrap() ? Qt::TextWordWrap : 0;
            needed =
                metrics
                    .boundingRect(QRect(0, 0, label->wordWrap() ? label->contentsRect().width() : 100'000, 100'000),
                                  flags, text)
                    .size();
        } else if (qobject_cast<const QAbstractButton*>(widget) != nullptr) {
            text = static_cast<const QAbstractButton*>(widget)->text();
            const QFontMetrics metrics(widget->font());  // the style sheet's bold counts, too
            needed = widget->minimumSizeHint().expandedTo(metrics.size(0, text) + QSize(4, 4));
            if (widget->hasHeightForWidth()) {
                needed.setHeight(widget->heightForWidth(widget->width()));
            }
        } else if (widget->property("face").toBool() || widget->inherits("kerf::ui::FaceWidget")) {
            needed = widget->minimumSizeHint();
            text = widget->accessibleName();
        } else {
            continue;
        }
        if (needed.width() > widget->width() + 1 || needed.height() > widget->height() + 1) {
            problems << QStringLiteral("%1 “%2” needs %3×%4, has %5×%6")
                            .arg(nameOf(widget), text)
                            .arg(needed.width())
                            .arg(needed.height())
                            .arg(widget->width())
                            .arg(widget->height());
        }
    }
    return problems;
}

/// Every visible button or editor with a side below 15 mm.
inline QStringList smallTargets(const QWidget* root, const ui::Look& look) {
    QStringList problems;
    const int least = look.metrics().touch();
    for (const QWidget* widget : root->findChildren<QWidget*>()) {
        const bool target = qobject_cast<const QAbstractButton*>(widget) != nullptr ||
                            qobject_cast<const QLineEdit*>(widget) != nullptr;
        if (target && widget->isVisibleTo(root) && widget->isEnabled() &&
            (widget->width() < least || widget->height() < least)) {
            problems << QStringLiteral("%1 is %2×%3, touch needs %4")
                            .arg(nameOf(widget))
                            .arg(widget->width())
                            .arg(widget->height())
                            .arg(least);
        }
    }
    return problems;
}

}  // namespace kerf::test
