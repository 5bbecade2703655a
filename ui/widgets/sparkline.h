// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <deque>
#include <optional>
#include <vector>

#include "ui/widgets/face_widget.h"

class QPainter;

namespace kerf::ui {

/// The recent course of one number without axes; the newest value is the dot at the right. Where limits are known it
/// stands between them, and they are named at their lines.
class Sparkline : public FaceWidget {
    Q_OBJECT
 public:
    explicit Sparkline(Look& look, QWidget* parent = nullptr);

    void setCapacity(std::size_t points) { m_capacity = points; }
    void push(double value);
    void setValues(const std::vector<double>& values);
    void clear();
    struct Limit {
        double value{0.0};
        QString name{};
        bool operator==(const Limit&) const = default;
    };
    void setLimits(const std::optional<Limit>& lower, const std::optional<Limit>& upper);
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
    void paintEvent(QPaintEvent* event) override;

 private:
    void paintLimit(QPainter& painter, const Limit& limit, double y, bool nameAbove) const;
    std::deque<double> m_values;
    std::size_t m_capacity{300};
    std::optional<Limit> m_lower{};
    std::optional<Limit> m_upper{};
};

}  // namespace kerf::ui
