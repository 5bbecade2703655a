// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/live_plot.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>

namespace kerf::ui {
namespace {
constexpr int kColumn = 2;             ///< pixels that share one lowest and highest value
constexpr double kMostColumns = 1000;  ///< a wider chart has wider columns: no eye tells more of them apart
constexpr double kSmooth_px = 0.3;     ///< a smooth line may leave its points by so much

int columnWidth(double plotWidth) {
    return std::max(kColumn, static_cast<int>(std::ceil(plotWidth / kMostColumns)));
}

/// Drops points that a straight line passes anyway: a stroke costs by the point. The open end stays.
void addSmooth(QPolygonF& line, const QPointF& point) {
    if (line.size() >= 3) {
        const QPointF from = line[line.size() - 3];
        const QPointF middle = line[line.size() - 2];
        const QPointF last = line.last();
        const auto off = [&](const QPointF& p) {
            const double along = last.x() - from.x();
            return along <= 0.0 ? 1.0 : std::abs(from.y() + (last.y() - from.y()) * (p.x() - from.x()) / along - p.y());
        };
        if (off(middle) < kSmooth_px) {
            line.remove(line.size() - 2);
        }
    }
    line << point;
}
}  // namespace

LivePlot::LivePlot(Look& look, double window_s, QWidget* parent) : Chart(look, parent), m_window_s(window_s) {
    setWindow(window_s);
    connect(&look, &Look::changed, this, [this] { m_ground.picture = QPixmap(); });
}

void LivePlot::setWindow(double window_s) {
    m_window_s = window_s;
    setXRange(-window_s, 0.0);
    rebuild();
}

void LivePlot::append(CurveId curve, double time_s, double stored) {
    std::vector<QPointF>& points = curves()[curve].points;
    if (!points.empty() && time_s < points.back().x()) {
        points.clear();  // the clock went back: another machine, another start
    }
    points.emplace_back(time_s, stored);
}

void LivePlot::advance(double now_s) {
    m_now_s = now_s;
    for (Curve& curve : curves()) {
        forget(curve);
    }
    if (isVisible()) {
        rebuild();
    }
}

void LivePlot::clear() {
    for (Curve& curve : curves()) {
        curve.points.clear();
    }
    rebuild();
}

void LivePlot::setPoints(CurveId curve, const std::vector<QPointF>& points) {
    curves()[curve].points = points;
    rebuild();
}

void LivePlot::showEvent(QShowEvent* event) {
    m_ground.picture = QPixmap();
    Chart::showEvent(event);
    rebuild();
}

// Old points go in blocks, so that the vector is moved rarely.
void LivePlot::forget(Curve& curve) const {
    constexpr std::ptrdiff_t kBlock = 4096;
    const double oldest_s = m_now_s - m_window_s;
    const auto first = std::lower_bound(curve.points.begin(), curve.points.end(), oldest_s,
                                        [](const QPointF& p, double t) { return p.x() < t; });
    if (first - curve.points.begin() > kBlock) {
        curve.points.erase(curve.points.begin(), first - 1);
    }
}

void LivePlot::rebuild() {
    const DisplayUnit unit = look().units().of(yUnit());
    const int columns =
        std::max(50, static_cast<int>(chart()->plotArea().width()) / columnWidth(chart()->plotArea().width()));
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (Curve& curve : curves()) {
        decimate(curve.points, m_now_s - m_window_s, m_now_s, columns, curve.shown);
        for (QPointF& p : curve.shown) {
            p = {p.x() - m_now_s, unit.toShown(p.y())};
            if (p.x() >= -m_window_s) {
                low = std::min(low, p.y());
                high = std::max(high, p.y());
            }
        }
    }
    if (low <= high) {
        fitY(low, high, true);
    }
    viewport()->update();
}

// The scene of Qt Charts costs more than the curves; between two ticks only these have moved.
void LivePlot::paintEvent(QPaintEvent* event) {
    const qreal ratio = viewport()->devicePixelRatioF();
    const QSize wanted = viewport()->size() * ratio;
    const QString axes = axesText();
    if (m_ground.picture.size() != wanted || m_ground.plot != chart()->plotArea() || m_ground.axes != axes) {
        m_ground = {QPixmap(wanted), chart()->plotArea(), axes};
        m_ground.picture.setDevicePixelRatio(ratio);
        m_ground.picture.fill(look().color(Token::Panel));
        QPainter painter(&m_ground.picture);
        m_paintingGround = true;
        QGraphicsView::render(&painter, QRectF(viewport()->rect()), viewport()->rect());
        m_paintingGround = false;
    }
    QPainter painter(viewport());
    painter.setClipRegion(event->region());
    painter.drawPixmap(0, 0, m_ground.picture);
    Chart::drawForeground(&painter, QRectF(viewport()->rect()));
}

void LivePlot::drawForeground(QPainter* painter, const QRectF& rect) {
    if (!m_paintingGround) {
        Chart::drawForeground(painter, rect);
    }
}

QString LivePlot::axesText() const {
    return QStringLiteral("%1 %2 %3 %4 ")
               .arg(xAxis()->min())
               .arg(xAxis()->max())
               .arg(yAxis()->min(), 0, 'g', 17)
               .arg(yAxis()->max(), 0, 'g', 17) +
           xAxis()->titleText() + u'|' + yAxis()->titleText();
}

void LivePlot::paintLines(QPainter& painter, const QRectF& plot) const {
    painter.save();
    painter.setClipRect(plot);
    for (const Curve& curve : curves()) {
        if (curve.style.kind != Kind::Points) {
            paintLine(painter, plot, curve);
        }
    }
    painter.restore();
}

// A noisy signal fills whole columns from its lowest to its highest value: they are filled as rectangles, as an
// oscilloscope draws them, which costs a tenth of stroking the zigzag. Where it is quiet a smooth line is drawn.
void LivePlot::paintLine(QPainter& painter, const QRectF& plot, const Curve& curve) const {
    const double width = look().metrics().stroke(curve.style.stroke);
    const double tall = 3.0 * width;
    const bool dashed = curve.style.kind == Kind::Dashed;
    const QPen pen = look().pen(curve.style.token, curve.style.stroke, dashed ? Qt::DashLine : Qt::SolidLine);
    const QColor color = look().color(curve.style.token);
    painter.setPen(pen);
    const int columnWidth_px = columnWidth(plot.width());
    QPolygonF smooth;
    const auto flush = [&painter, &smooth] {
        if (smooth.size() > 1) {
            painter.drawPolyline(smooth);
        }
        smooth.clear();
    };
    const QList<QPointF>& points = curve.shown;
    for (qsizetype i = 0; i < points.size();) {
        const QPointF first = place(points[i]);
        const double column = std::floor((first.x() - plot.left()) / columnWidth_px);
        double low = first.y();
        double high = first.y();
        QPointF last = first;
        for (; i < points.size(); ++i) {
            const QPointF at = place(points[i]);
            if (std::floor((at.x() - plot.left()) / columnWidth_px) != column) {
                break;
            }
            low = std::min(low, at.y());
            high = std::max(high, at.y());
            last = at;
        }
        if (high - low <= tall) {
            addSmooth(smooth, last);
        } else {
            if (!smooth.isEmpty()) {  // the column reaches to where the line before it ended: no gap, no stroke
                low = std::min(low, smooth.last().y());
                high = std::max(high, smooth.last().y());
            }
            flush();
            const double left = plot.left() + column * columnWidth_px;
            painter.fillRect(QRectF(left, low - width / 2, columnWidth_px, high - low + width).toAlignedRect(), color);
            smooth << last;
        }
    }
    flush();
}

}  // namespace kerf::ui
