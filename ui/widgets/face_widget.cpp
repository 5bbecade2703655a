// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/face_widget.h"

#include <QEvent>

namespace kerf::ui {

FaceWidget::FaceWidget(Look& look, QWidget* parent) : QWidget(parent), m_look(look) {
    connect(&look, &Look::changed, this, [this] { refresh(); });
}

void FaceWidget::refresh() {
    updateGeometry();
    update();
}

void FaceWidget::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        refresh();
    }
}

}  // namespace kerf::ui
