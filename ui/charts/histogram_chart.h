// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/core/histogram.h"
#include "ui/widgets/face_widget.h"

namespace kerf::ui {

/// Distribution of a time on a logarithmic axis: bars are the share of all cycles, on a logarithmic scale too, because
/// one late cycle in a million is what one looks for. Median, 99.9 % and the worst are named at their place.
class HistogramChart : public FaceWidget {
    Q_OBJECT
 public:
    explicit HistogramChart(Look& look, QWidget* parent = nullptr);

    void setTitle(const QString& title);
    void setHistogram(const TimeHistogram& histogram);
    /// A line at the period of the cycle; 0 hides it.
    void setDeadline(std::int64_t deadline_ns);
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
    void paintEvent(QPaintEvent* event) override;

 private:
    QString m_title;
    TimeHistogram m_histogram;
    std::int64_t m_deadline_ns{0};
};

/// "8.4 µs", "1.20 ms": three figures that a person reads.
[[nodiscard]] QString timeText(std::int64_t time_ns);

}  // namespace kerf::ui
