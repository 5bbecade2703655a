// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/scroll_box.h"

#include <QEvent>
#include <QLayout>
#include <QScrollBar>
#include <QScroller>

namespace kerf::ui {

ScrollBox::ScrollBox(QWidget* parent) : QScrollArea(parent) {
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::NoFocus);
    QScroller::grabGesture(viewport(), QScroller::TouchGesture);
}

void ScrollBox::setContent(QWidget* content) {
    setWidget(content);
    content->show();
    fit();
}

QSize ScrollBox::least(int width) const {
    const QWidget* content = widget();
    if (content == nullptr) {
        return {0, 0};
    }
    const QLayout* layout = content->layout();
    if (layout == nullptr) {
        return content->minimumSizeHint().expandedTo(content->minimumSize());
    }
    const QSize size = layout->totalMinimumSize();
    return {size.width(), layout->hasHeightForWidth() ? layout->totalMinimumHeightForWidth(qMax(width, size.width()))
                                                      : size.height()};
}

int ScrollBox::wantedHeight(int width) const {
    const QWidget* content = widget();
    if (content == nullptr) {
        return 0;
    }
    const QLayout* layout = content->layout();
    if (layout == nullptr) {
        return content->sizeHint().height();
    }
    const int least_width = layout->totalMinimumSize().width();
    const int bar = least_width > width ? horizontalScrollBar()->sizeHint().height() : 0;
    return bar + (layout->hasHeightForWidth() ? layout->totalHeightForWidth(qMax(width, least_width))
                                              : layout->totalSizeHint().height());
}

QSize ScrollBox::sizeHint() const {
    const QWidget* content = widget();
    return content == nullptr ? QSize(0, 0) : content->sizeHint();
}

bool ScrollBox::scrolls() const {
    return widget() != nullptr &&
           (widget()->width() > viewport()->width() || widget()->height() > viewport()->height());
}

void ScrollBox::fit() {
    if (widget() == nullptr || m_fitting) {
        return;
    }
    m_fitting = true;
    const QSize room = maximumViewportSize();
    const int acrossBar = horizontalScrollBar()->sizeHint().height();
    const int downBar = verticalScrollBar()->sizeHint().width();
    QSize free = room;
    QSize need = least(free.width());
    if (need.width() > free.width()) {
        free.rheight() -= acrossBar;
    }
    if (need.height() > free.height()) {
        free.rwidth() -= downBar;
        const bool across = need.width() > free.width() && free.height() == room.height();
        free.rheight() -= across ? acrossBar : 0;
        need = least(free.width());
    }
    widget()->resize(free.expandedTo(need));
    m_fitting = false;
}

void ScrollBox::resizeEvent(QResizeEvent* event) {
    fit();
    QScrollArea::resizeEvent(event);
}

bool ScrollBox::eventFilter(QObject* watched, QEvent* event) {
    if (watched == widget() && event->type() == QEvent::LayoutRequest) {
        fit();
    }
    return QScrollArea::eventFilter(watched, event);
}

}  // namespace kerf::ui
