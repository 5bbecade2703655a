// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <vector>

#include "ui/widgets/face_widget.h"

namespace kerf::ui {

/// The recent course of one number without axes; the newest value is the dot at the right.
class Sparkline : public FaceWidget {
    Q_OBJECT
 public:
    explicit Sparkline(Look& look, QWidget* parent = nullptr);

    void setCapacity(std::size_t points) { m_capacity = points; }
    void push(double value);
    void setValues(const std::vector<double>& values);
    void clear();
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
    void paintEvent(QPaintEvent* event) override;

 private:
    std::deque<double> m_values;
    std::size_t m_capacity{300};
};

}  // namespace kerf::ui
