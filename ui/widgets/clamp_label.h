// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

namespace kerf::ui {

/// A sentence that has its place: it wraps to so many lines and ends in an ellipsis, however long it is, and nothing
/// around it moves when it grows. text() is the whole of it, and the tool tip says it.
class ClampLabel : public QLabel {
    Q_OBJECT
 public:
    explicit ClampLabel(int lines, QWidget* parent = nullptr);

    void say(const QString& text);
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;
    [[nodiscard]] bool hasHeightForWidth() const override { return false; }
    [[nodiscard]] int heightForWidth(int) const override { return -1; }

 protected:
    void paintEvent(QPaintEvent* event) override;

 private:
    int m_lines;
};

}  // namespace kerf::ui
