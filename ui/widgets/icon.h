// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QRectF>

class QPainter;

namespace kerf::ui {

/// Draw the icon of a page (resources/icons/<key>.svg) into a square box, in one colour; nothing when there is none.
void paintIcon(QPainter& painter, const QRectF& box, const char* key, const QColor& color);

}  // namespace kerf::ui
