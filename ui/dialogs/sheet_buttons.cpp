// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/sheet_buttons.h"

#include <QEvent>

namespace kerf::ui {

SheetButtons::SheetButtons(Look& look, QWidget* parent) : FaceWidget(look, parent) {}

void SheetButtons::add(QPushButton* button) {
    button->setParent(this);
    button->show();
    m_buttons.push_back(button);
    place();
    updateGeometry();
}

int SheetButtons::heightForWidth(int width) const {
    return arrange(width, nullptr);
}

namespace {
int leastWidth(const QPushButton* button) {
    return button->minimumSizeHint().expandedTo(button->minimumSize()).width();
}
}  // namespace

int SheetButtons::arrange(int width, std::vector<std::pair<QPushButton*, QRect>>* places) const {
    const int gap = look().metrics().touchGap();
    std::vector<std::vector<std::pair<QPushButton*, int>>> rows;
    int least = 0;
    for (QPushButton* button : m_buttons) {
        least += button->isHidden() ? 0 : leastWidth(button) + gap;
    }
    const bool oneRow = least - gap <= width;
    int used = 0;
    for (QPushButton* button : m_buttons) {
        if (button->isHidden()) {
            continue;
        }
        const int wanted =
            qMin(width, oneRow ? leastWidth(button) : qMax(leastWidth(button), button->sizeHint().width()));
        if (rows.empty() || (!oneRow && used + gap + wanted > width)) {
            rows.emplace_back();
            used = -gap;
        }
        rows.back().emplace_back(button, wanted);
        used += gap + wanted;
    }
    int y = 0;
    for (auto& row : rows) {
        // What is left goes to those that would like more, then between them.
        int left = width - gap * (static_cast<int>(row.size()) - 1);
        for (const auto& [button, has] : row) {
            left -= has;
        }
        for (auto& [button, has] : row) {
            const int more = qBound(0, button->sizeHint().width() - has, left);
            has += more;
            left -= more;
        }
        int height = 0;
        for (const auto& [button, has] : row) {
            height =
                qMax(height, button->hasHeightForWidth() ? button->heightForWidth(has) : button->sizeHint().height());
        }
        const int spread = row.size() > 1 ? left / (static_cast<int>(row.size()) - 1) : 0;
        int x = 0;
        for (const auto& [button, has] : row) {
            if (places != nullptr) {
                places->emplace_back(button, QRect(x, y, has, height));
            }
            x += has + gap + spread;
        }
        y += height + gap;
    }
    return qMax(0, y - gap);
}

void SheetButtons::place() {
    std::vector<std::pair<QPushButton*, QRect>> places;
    (void)arrange(width(), &places);
    for (const auto& [button, rect] : places) {
        button->setGeometry(rect);
    }
}

void SheetButtons::resizeEvent(QResizeEvent* event) {
    FaceWidget::resizeEvent(event);
    place();
}

// A reason that came or went makes a button higher: the sheet is told by the same event.
bool SheetButtons::event(QEvent* event) {
    if (event->type() == QEvent::LayoutRequest) {
        place();
    }
    return FaceWidget::event(event);
}

}  // namespace kerf::ui
