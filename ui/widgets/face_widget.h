// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/theme/look.h"

namespace kerf::ui {

/// A widget that follows the look. Override refresh(): set texts (tr), sizes and colours there. It is called whenever
/// theme, scale, unit or language changes; the constructor of the derived class calls it once itself.
class FaceWidget : public QWidget {
    Q_OBJECT
 public:
    explicit FaceWidget(Look& look, QWidget* parent = nullptr);

    [[nodiscard]] Look& look() const { return m_look; }

 protected:
    virtual void refresh();
    void changeEvent(QEvent* event) override;

 private:
    Look& m_look;
};

}  // namespace kerf::ui
