// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QScrollArea>

namespace kerf::ui {

/// Room for one widget, which has all of it and scrolls where it needs more. It never asks for more than a corner
/// itself, so nothing inside can make a window larger. Other than QScrollArea's own way of resizing, a widget is given
/// its minimum height before it scrolls, not the height it would like to have.
class ScrollBox : public QScrollArea {
    Q_OBJECT
 public:
    explicit ScrollBox(QWidget* parent = nullptr);

    void setContent(QWidget* content);
    /// Height in which `content` stands without scrolling at that width.
    [[nodiscard]] int wantedHeight(int width) const;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return {0, 0}; }
    /// It shows less than there is.
    [[nodiscard]] bool scrolls() const;

 protected:
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

 private:
    void fit();
    [[nodiscard]] QSize least(int width) const;

    bool m_fitting{false};
};

}  // namespace kerf::ui
