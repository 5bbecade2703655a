// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPushButton>

#include "engine/api/engine_api.h"
#include "ui/theme/look.h"

namespace kerf::ui {

/// HOLD ALL: all loops off, last offset held. Acts when pressed, not when released; knows nothing but
/// EngineApi::holdAll(). Always enabled, never red: it is a software hold, not an emergency stop.
class HoldAllButton : public QPushButton {
    Q_OBJECT
 public:
    HoldAllButton(Look& look, EngineApi& engine, QWidget* parent = nullptr);

    /// What the engine says: the button then reads "HELD".
    void setHeld(bool held);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
    void changeEvent(QEvent* event) override;

 private:
    void refresh();

    Look& m_look;
    bool m_held{false};
};

}  // namespace kerf::ui
