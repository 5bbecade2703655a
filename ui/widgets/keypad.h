// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGridLayout>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <vector>

#include "ui/widgets/face_widget.h"

namespace kerf::ui {

/// Number keys for gloved fingers: at least 15 mm, 3 mm apart. Types into its target, or into whatever QLineEdit has
/// the focus; never takes the focus itself. Enter does what Return does in the editor.
class Keypad : public FaceWidget {
    Q_OBJECT
 public:
    /// Tall: four rows with a sign key. Wide: three rows of five, for a low panel and values that are never negative.
    enum class Shape { Tall, Wide };

    explicit Keypad(Look& look, QWidget* parent = nullptr) : Keypad(look, Shape::Tall, parent) {}
    Keypad(Look& look, Shape shape, QWidget* parent = nullptr);

    /// Without a target the keys go to the field that waits: the one with the focus, else the one touched last beside
    /// this pad, else the first for figures.
    void setTarget(QLineEdit* edit) { m_target = edit; }
    bool eventFilter(QObject* watched, QEvent* event) override;
    /// Text of the enter key ("Enter" when empty).
    void setEnterText(const QString& text);

 protected:
    void refresh() override;

 private:
    QPushButton* addKey(const QString& face, const char* name, int row, int column, int columns = 1);
    void addSign(int row, int column);
    void type(const QString& text, int key);
    [[nodiscard]] QLineEdit* field() const;
    [[nodiscard]] bool beside(const QWidget* widget) const;

    QGridLayout* m_grid;
    QPointer<QLineEdit> m_target;
    QPointer<QLineEdit> m_touched;
    QPushButton* m_enter{nullptr};
    QPushButton* m_clear{nullptr};
    QString m_enterText;
    std::vector<QPushButton*> m_keys;
};

}  // namespace kerf::ui
