// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPushButton>
#include <vector>

#include "ui/widgets/face_widget.h"

namespace kerf::ui {

/// A sheet's answers from left to right, the safe one apart from the others; in as many rows as the width asks for.
class SheetButtons : public FaceWidget {
    Q_OBJECT
 public:
    SheetButtons(Look& look, QWidget* parent);

    void add(QPushButton* button);
    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return {0, 0}; }

 protected:
    void resizeEvent(QResizeEvent* event) override;
    bool event(QEvent* event) override;

 private:
    /// Places of the shown buttons in that width, and the height of all.
    [[nodiscard]] int arrange(int width, std::vector<std::pair<QPushButton*, QRect>>* places) const;
    void place();

    std::vector<QPushButton*> m_buttons;
};

}  // namespace kerf::ui
