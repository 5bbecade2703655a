// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/first_paint.h"

#include <QApplication>
#include <QEvent>
#include <algorithm>
#include <utility>

#include "ui/shell/main_window.h"

namespace kerf::console {

FirstPaint::FirstPaint(ui::MainWindow& window, std::function<void(int without)> done)
    : QObject(&window), m_window(window), m_done(std::move(done)) {
    qApp->installEventFilter(this);
}

bool FirstPaint::hasContent() const {
    const auto& loops = m_window.client().status().loops;
    return std::ranges::any_of(loops, &LoopStatus::fitted) &&
           std::ranges::all_of(m_window.pages(), [&](const ui::PageEntry& entry) {
               const auto* card = m_window.findChild<QWidget*>(QStringLiteral("card_") + QLatin1String(entry.key));
               return card == nullptr || card->isVisible() || !entry.process ||
                      !loops[static_cast<std::size_t>(*entry.process)].fitted;
           });
}

bool FirstPaint::eventFilter(QObject* watched, QEvent* event) {
    if (!m_seen && event->type() == QEvent::Paint && watched == m_window.page("overview")) {
        if (hasContent()) {
            m_seen = true;
            QMetaObject::invokeMethod(
                this, [this] { m_done(m_without); }, Qt::QueuedConnection);  // after this paint is on the screen
        } else {
            ++m_without;
        }
    }
    return QObject::eventFilter(watched, event);
}

}  // namespace kerf::console
