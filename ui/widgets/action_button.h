// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPushButton>
#include <functional>

#include "ui/theme/look.h"

namespace kerf::ui {

/// A style sheet's min-width is written into the button as its minimum, and layouts then no longer ask how wide its
/// words are: they cut them off. The touch width stays in the hints.
void forgetStyledWidth(QAbstractButton& button);

/// A button that says why it is off. The predicate gives an empty text when the action is possible, else one
/// (translated) sentence; the button is then disabled and shows that sentence under its name.
class ActionButton : public QPushButton {
    Q_OBJECT
 public:
    using WhyNot = std::function<QString()>;

    explicit ActionButton(Look& look, QWidget* parent = nullptr);

    void setPredicate(WhyNot whyNot);
    /// Who may, asked before the predicate.
    void setPermission(WhyNot whoMay);
    /// What it waits for a moment, asked last.
    void setRest(WhyNot whyNow);
    /// Ask the predicate again; cheap, may be called on every status. Done once more when the button is touched.
    void reconsider();
    [[nodiscard]] QString reason() const { return m_reason; }
    /// The action the page expects next: a heavier frame.
    void setPrimary(bool primary);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;

 private:
    [[nodiscard]] int titleHeight(int width) const;
    [[nodiscard]] int textHeight(int width) const;

    Look& m_look;
    WhyNot m_whyNot;
    WhyNot m_whoMay;
    WhyNot m_whyNow;
    QString m_reason;
};

}  // namespace kerf::ui
