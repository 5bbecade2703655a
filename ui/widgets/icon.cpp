// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/icon.h"

#include <QFile>
#include <QSvgRenderer>

// A static library's resources are linked only when named; the macro must be outside any namespace.
static void initIconResources() {
    Q_INIT_RESOURCE(icons);
}

namespace kerf::ui {

void paintIcon(QPainter& painter, const QRectF& box, const char* key, const QColor& color) {
    initIconResources();
    QFile file(QStringLiteral(":/kerf/icons/") + QLatin1String(key) + QStringLiteral(".svg"));
    if (!file.open(QIODevice::ReadOnly)) {
        return;
    }
    QSvgRenderer renderer(file.readAll().replace("currentColor", color.name().toLatin1()));
    renderer.render(&painter, box);
}

}  // namespace kerf::ui
