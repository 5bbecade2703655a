// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "ui/theme/look.h"

namespace kerf::ui {

/// A panel with a title line; put content into body(), and what belongs beside the title into header(). A change of
/// language calls retranslate().
class Card : public QFrame {
    Q_OBJECT
 public:
    explicit Card(Look& look, QWidget* parent = nullptr);

    void setTitle(const QString& title);
    [[nodiscard]] QVBoxLayout* body() const { return m_body; }
    [[nodiscard]] QHBoxLayout* header() const { return m_header; }

 protected:
    void changeEvent(QEvent* event) override;
    /// Sets every text anew, in the language that holds now.
    virtual void retranslate() {}

 private:
    void refresh();

    Look& m_look;
    QVBoxLayout* m_outer;
    QHBoxLayout* m_header;
    QVBoxLayout* m_body;
    QLabel* m_title;
};

}  // namespace kerf::ui
