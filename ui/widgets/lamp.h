// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "ui/widgets/face_widget.h"
#include "ui/widgets/sign.h"

namespace kerf::ui {

/// Shape, word and colour of one state: "● controlling".
class Lamp : public FaceWidget {
    Q_OBJECT
 public:
    explicit Lamp(Look& look, QWidget* parent = nullptr);

    /// State of a loop with its word.
    void setState(LoopState state);
    /// Any sign with any (translated) word.
    void set(Sign sign, const QString& word);
    [[nodiscard]] Sign sign() const { return m_sign; }
    [[nodiscard]] QString word() const { return m_word; }
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
    void paintEvent(QPaintEvent* event) override;
    void refresh() override;

 private:
    Sign m_sign{Sign::None};
    QString m_word;
    std::optional<LoopState> m_state;
};

}  // namespace kerf::ui
