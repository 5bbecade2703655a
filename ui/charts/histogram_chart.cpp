// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/histogram_chart.h"

#include <QFontMetrics>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

namespace kerf::ui {
namespace {

constexpr double kFrom_ns = 100.0;
constexpr double kTo_ns = 1e8;
constexpr double kLeastShare = 1e-7;

double along(double time_ns) {
    return std::clamp(std::log(time_ns / kFrom_ns) / std::log(kTo_ns / kFrom_ns), 0.0, 1.0);
}

double up(double share) {
    return share <= 0.0 ? 0.0 : std::clamp(1.0 - std::log(share) / std::log(kLeastShare), 0.02, 1.0);
}

}  // namespace

QString timeText(std::int64_t time_ns) {
    const auto t = static_cast<double>(time_ns);
    struct Scale {
        double unit_ns;
        const char* symbol;
    };
    constexpr std::array<Scale, 4> scales{{{1.0, "ns"}, {1e3, "µs"}, {1e6, "ms"}, {1e9, "s"}}};
    std::size_t i = 0;
    while (i + 1 < scales.size() && t >= 999.5 * scales[i].unit_ns) {
        ++i;
    }
    const double value = t / scales[i].unit_ns;
    const int decimals = i == 0 || value >= 99.95 ? 0 : value >= 9.995 ? 1 : 2;
    return QString::number(value, 'f', decimals) + QChar(QChar::Nbsp) + QString::fromUtf8(scales[i].symbol);
}

HistogramChart::HistogramChart(Look& look, QWidget* parent) : FaceWidget(look, parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void HistogramChart::setTitle(const QString& title) {
    m_title = title;
    update();
}

void HistogramChart::setHistogram(const TimeHistogram& histogram) {
    m_histogram = histogram;
    update();
}

void HistogramChart::setDeadline(std::int64_t deadline_ns) {
    m_deadline_ns = deadline_ns;
    update();
}

QSize HistogramChart::sizeHint() const {
    return {look().metrics().sideWidth(), look().metrics().chart()};
}

QSize HistogramChart::minimumSizeHint() const {
    return {look().metrics().sideWidth(), look().metrics().chart() * 2 / 3};
}

void HistogramChart::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const QFont small = look().font(TextSize::Label);
    const QFontMetrics metrics(small);
    painter.setFont(small);
    const int axis = 2 * metrics.height() + look().space(Space::Small);
    const int names = 3 * metrics.height() + look().space(Space::Small);
    const int scale = metrics.horizontalAdvance(QStringLiteral("0.0001 %")) + look().space(Space::Small);
    const QRectF plot = QRectF(rect()).adjusted(scale, names, -look().space(Space::Large), -axis);
    const auto x = [&plot](double time_ns) { return plot.left() + along(time_ns) * plot.width(); };

    for (double share = 1.0; share > kLeastShare * 1.5; share /= 100.0) {
        const double y = plot.bottom() - up(share) * plot.height();
        painter.setPen(QPen(look().palette().grid(), look().metrics().stroke(Stroke::Thin)));
        painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
        painter.setPen(look().color(Token::Dim));
        painter.drawText(QRectF(0, y - metrics.height() / 2.0, scale - look().space(Space::Small), metrics.height()),
                         Qt::AlignRight | Qt::AlignVCenter, QStringLiteral("%1\u00a0%").arg(100.0 * share));
    }
    for (double time_ns = kFrom_ns; time_ns <= kTo_ns * 1.01; time_ns *= 10.0) {
        painter.setPen(QPen(look().palette().grid(), look().metrics().stroke(Stroke::Thin)));
        painter.drawLine(QPointF(x(time_ns), plot.top()), QPointF(x(time_ns), plot.bottom()));
        painter.setPen(look().color(Token::Dim));
        const double half = metrics.horizontalAdvance(QStringLiteral("100 µs"));
        const auto shown = static_cast<std::int64_t>(std::llround(time_ns));
        QString label = timeText(shown);
        label.replace(QStringLiteral(".00"), QString()).replace(QStringLiteral(".0"), QString());
        const double left = std::min(x(time_ns) - half, width() - 2 * half);
        painter.drawText(QRectF(left, plot.bottom(), 2 * half, metrics.height()), Qt::AlignCenter, label);
    }
    painter.drawText(QRectF(plot.left(), plot.bottom() + metrics.height(), plot.width(), metrics.height()),
                     Qt::AlignCenter, m_title);
    if (m_histogram.count() == 0) {
        painter.setFont(look().font(TextSize::Body));
        painter.drawText(plot, Qt::AlignCenter | Qt::TextWordWrap, tr("Appears as soon as the engine cycles."));
        return;
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(look().color(Token::Measured));
    const auto total = static_cast<double>(m_histogram.count());
    for (std::size_t i = 0; i < TimeHistogram::kBins; ++i) {
        if (m_histogram.bin(i) == 0) {
            continue;
        }
        const double from = i == 0 ? kFrom_ns : static_cast<double>(TimeHistogram::upperEdge_ns(i - 1));
        const double left = x(from);
        const double right = x(static_cast<double>(TimeHistogram::upperEdge_ns(i)));
        const double high = up(static_cast<double>(m_histogram.bin(i)) / total) * plot.height();
        painter.drawRect(QRectF(left, plot.bottom() - high, std::max(1.0, right - left - 1.0), high));
    }
    if (m_deadline_ns > 0) {
        painter.setPen(look().pen(Token::Limit, Stroke::Thin));
        const double at = x(static_cast<double>(m_deadline_ns));
        painter.drawLine(QPointF(at, plot.top()), QPointF(at, plot.bottom()));
        painter.setPen(look().color(Token::Limit));
        painter.drawText(QPointF(at + look().space(Space::Small), plot.top() + metrics.ascent()), tr("cycle"));
    }
    struct Named {
        std::int64_t time_ns;
        QString name;
    };
    const std::array<Named, 3> marks{
        {{m_histogram.percentile_ns(0.5), tr("median %1").arg(timeText(m_histogram.percentile_ns(0.5)))},
         {m_histogram.percentile_ns(0.999), tr("99.9 % %1").arg(timeText(m_histogram.percentile_ns(0.999)))},
         {m_histogram.max_ns(), tr("worst %1").arg(timeText(m_histogram.max_ns()))}}};
    for (std::size_t i = 0; i < marks.size(); ++i) {  // each name on a line of its own: they stand close together
        const double at = x(static_cast<double>(marks[i].time_ns));
        const double row = static_cast<double>(i) * metrics.height();
        painter.setPen(look().pen(Token::Text, Stroke::Thin));
        painter.drawLine(QPointF(at, row + metrics.height()), QPointF(at, plot.bottom()));
        const double textWidth = metrics.horizontalAdvance(marks[i].name);
        const double left = std::clamp(at - textWidth / 2.0, 0.0, width() - textWidth);
        const QRectF box(left, row, textWidth, metrics.height());
        painter.fillRect(box, look().color(Token::Panel));
        painter.setPen(look().color(Token::Text));
        painter.drawText(box, Qt::AlignCenter, marks[i].name);
    }
}

}  // namespace kerf::ui
