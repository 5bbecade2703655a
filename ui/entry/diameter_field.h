// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>

#include "ui/entry/diameter_input.h"
#include "ui/theme/look.h"

namespace kerf::ui {

/// The field a diameter is typed into (see DiameterInput). Figures that come from the expected bore are dim, typed
/// ones strong, open places are boxes. text() is the whole as shown.
class DiameterField : public QLineEdit {
    Q_OBJECT
 public:
    explicit DiameterField(Look& look, QWidget* parent = nullptr);

    [[nodiscard]] DiameterInput& input() { return m_input; }
    [[nodiscard]] const DiameterInput& input() const { return m_input; }
    /// After a change of input() from outside.
    void showInput();
    /// A text put in by other means (paste, a program) becomes what was typed.
    void takeText();
    void setWrong(bool wrong);

    [[nodiscard]] QSize sizeHint() const override;

 signals:
    void typed();
    void entered();  ///< Return, Enter, or the keypad's
    void cleared();  ///< Escape
    /// A key of the keypad with Num Lock off: no figure, and the next Enter enters nothing.
    void numLockOff();

 protected:
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

 private:
    Look& m_look;
    DiameterInput m_input;
    bool m_numLockOff{false};
};

}  // namespace kerf::ui
