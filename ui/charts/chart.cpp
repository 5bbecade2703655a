// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/chart.h"

#include <QAreaSeries>
#include <QFontMetrics>
#include <QGraphicsLayout>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>

namespace kerf::ui {
namespace {

/// Smallest range that holds everything it has been shown.
struct Extent {
    double low{std::numeric_limits<double>::infinity()};
    double high{-std::numeric_limits<double>::infinity()};
    void take(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    [[nodiscard]] bool empty() const { return !(low <= high); }
};

}  // namespace

Chart::Chart(Look& look, QWidget* parent)
    // Given its chart at once: the one a view makes for itself would be left without an owner by setChart().
    : QChartView(new QChart, parent), m_look(look), m_chart(chart()), m_x(new QValueAxis), m_y(new QValueAxis) {
    setFrameShape(QFrame::NoFrame);
    setRenderHint(QPainter::Antialiasing);
    setViewportUpdateMode(QGraphicsView::FullViewportUpdate);
    setFocusPolicy(Qt::NoFocus);
    setBackgroundBrush(Qt::NoBrush);
    viewport()->setAutoFillBackground(false);
    m_chart->legend()->hide();
    m_chart->setBackgroundVisible(false);
    m_chart->setMargins(QMargins(0, 0, 0, 0));
    m_chart->layout()->setContentsMargins(0, 0, 0, 0);
    m_chart->setAnimationOptions(QChart::NoAnimation);
    m_chart->addAxis(m_x, Qt::AlignBottom);
    m_chart->addAxis(m_y, Qt::AlignLeft);
    for (QValueAxis* axis : {m_x, m_y}) {
        axis->setTickType(QValueAxis::TicksDynamic);
    }
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    connect(&look, &Look::changed, this, [this] {
        restyle();
        retitle();
        rebuild();
        updateGeometry();
    });
    restyle();
    (void)applyRange(m_x, 0.0, 1.0, false);
    (void)applyRange(m_y, 0.0, 1.0, false);
}

void Chart::setXAxis(const QString& title, const char* unit, bool wholeNumbers) {
    m_xTitle = title;
    m_xUnit = unit;
    m_wholeNumbers = wholeNumbers;
    retitle();
    rebuild();
}

void Chart::setYAxis(const QString& title, const char* unit) {
    m_yTitle = title;
    m_yUnit = unit;
    retitle();
    rebuild();
}

void Chart::setLowTitles(bool low) {
    m_lowTitles = low;
    retitle();
}

void Chart::setXRange(double from, double to) {
    m_xRange = {from, to};
    fit();
}

void Chart::setYRange(double from, double to) {
    m_yRange = {from, to};
    fit();
}

void Chart::setYIncludes(std::vector<double> values) {
    m_yIncludes = std::move(values);
    fit();
}

Chart::CurveId Chart::addCurve(const CurveStyle& style) {
    auto* series = new QLineSeries;
    m_chart->addSeries(series);
    series->attachAxis(m_x);
    series->attachAxis(m_y);
    m_curves.push_back({style, {}, {}, {}, series});
    restyle();
    return m_curves.size() - 1;
}

void Chart::setCurveLabel(CurveId curve, const QString& label) {
    m_curves[curve].label = label;
    viewport()->update();
}

void Chart::setPoints(CurveId curve, const std::vector<QPointF>& points) {
    if (m_curves[curve].points == points) {
        return;  // nothing is painted that did not change
    }
    Curve& changed = m_curves[curve];
    if (changed.style.kind != Kind::Points || !changed.label.isEmpty()) {
        changed.points = points;
        draw(changed);
        fit();
        return;
    }
    // Points alone, the live one above all: where the axes stay, only what they cover is painted again.
    const QRegion before = covered(changed);
    const bool wasEmpty = changed.shown.isEmpty();
    changed.points = points;
    draw(changed);
    if (fitAxes() || wasEmpty != changed.shown.isEmpty()) {
        viewport()->update();
    } else {
        viewport()->update(before + covered(changed));
    }
}

Chart::BandId Chart::addBand(Token token) {
    Band band{token, {}, new QLineSeries(m_chart), new QLineSeries(m_chart), nullptr};
    band.area = new QAreaSeries(band.high, band.low);
    m_chart->addSeries(band.area);
    band.area->attachAxis(m_x);
    band.area->attachAxis(m_y);
    m_bands.push_back(band);
    restyle();
    return m_bands.size() - 1;
}

void Chart::setBand(BandId band, const std::vector<BandPoint>& points) {
    m_bands[band].points = points;
    rebuild();
}

void Chart::setLimits(std::vector<Limit> limits) {
    m_limits = std::move(limits);
    fit();
}

void Chart::setMarks(std::vector<Mark> marks) {
    m_marks = std::move(marks);
    viewport()->update();
}

void Chart::setEmptyText(const QString& sentence) {
    m_emptyText = sentence;
    fit();
}

QList<QPointF> Chart::drawn(CurveId curve) const {
    return m_curves[curve].shown;
}

void Chart::resizeEvent(QResizeEvent* event) {
    QChartView::resizeEvent(event);
    fit();  // as many ticks as the height has room for
}

QSize Chart::sizeHint() const {
    return {m_look.metrics().sideWidth(), m_look.metrics().chart()};
}

QSize Chart::minimumSizeHint() const {
    return {m_look.metrics().chart(), m_look.metrics().chart() / 2};
}

void Chart::restyle() {
    const QFont small = m_look.font(TextSize::Label);
    for (QValueAxis* axis : {m_x, m_y}) {
        axis->setLabelsFont(small);
        axis->setTitleFont(small);
        axis->setLabelsBrush(m_look.color(Token::Dim));
        axis->setTitleBrush(m_look.color(Token::Dim));
        axis->setLinePen(m_look.pen(Token::Line, Stroke::Thin));
        axis->setGridLinePen(QPen(m_look.palette().grid(), m_look.metrics().stroke(Stroke::Thin)));
    }
    for (const Curve& curve : m_curves) {
        const bool line = curve.style.kind != Kind::Points;
        const Qt::PenStyle style = curve.style.kind == Kind::Dashed ? Qt::DashLine : Qt::SolidLine;
        QPen pen = line ? m_look.pen(curve.style.token, curve.style.stroke, style) : QPen(Qt::NoPen);
        pen.setJoinStyle(Qt::RoundJoin);
        curve.series->setPen(pen);
    }
    for (const Band& band : m_bands) {
        band.area->setPen(QPen(Qt::NoPen));
        band.area->setBrush(m_look.palette().band(band.token));
    }
}

void Chart::retitle() {
    const auto title = [this](const QString& name, const char* unit) {
        const QString symbol = m_look.units().of(unit).symbol;
        if (symbol.isEmpty() || name.isEmpty()) {
            return symbol.isEmpty() ? name : symbol;
        }
        return tr("%1, %2", "axis title, unit").arg(name, symbol);
    };
    m_x->setTitleText(title(m_xTitle, m_xUnit));
    m_y->setTitleText(title(m_yTitle, m_yUnit));
    m_x->setTitleVisible(!m_xTitle.isEmpty() && !m_lowTitles);
    m_y->setTitleVisible(!m_yTitle.isEmpty() && !m_lowTitles);
}

void Chart::draw(Curve& curve) {
    const DisplayUnit x = m_look.units().of(m_xUnit);
    const DisplayUnit y = m_look.units().of(m_yUnit);
    QList<QPointF> shown;
    shown.reserve(static_cast<qsizetype>(curve.points.size()));
    for (const QPointF& p : curve.points) {
        shown.append({x.toShown(p.x()), y.toShown(p.y())});
    }
    curve.shown = shown;
    if (curve.style.kind != Kind::Points) {  // points are painted over the scene
        curve.series->replace(shown);
    }
}

void Chart::rebuild() {
    const DisplayUnit x = m_look.units().of(m_xUnit);
    const DisplayUnit y = m_look.units().of(m_yUnit);
    for (Curve& curve : m_curves) {
        draw(curve);
    }
    for (const Band& band : m_bands) {
        QList<QPointF> low;
        QList<QPointF> high;
        for (const BandPoint& p : band.points) {
            low.append({x.toShown(p.x), y.toShown(p.low)});
            high.append({x.toShown(p.x), y.toShown(p.high)});
        }
        band.low->replace(low);
        band.high->replace(high);
    }
    fit();
}

bool Chart::applyRange(QValueAxis* axis, double from, double to, bool widen, bool wholeNumbers) {
    AxisRange range = roundRange(from, to);
    if (wholeNumbers) {
        range.step = std::max(1.0, std::ceil(range.step));
        range.decimals = 0;
    }
    if (axis == m_y) {
        // Qt Charts cuts a label that has less than its height between two ticks.
        const double perTick = QFontMetricsF(m_look.font(TextSize::Label)).height() + m_look.space(Space::Large);
        const double most = std::max(2.0, m_chart->plotArea().height() / perTick);
        while ((range.to - range.from) / range.step > most) {
            range.step *= 2.0;
        }
    }
    if (!widen) {
        range.from = from;
        range.to = to;
    }
    // Qt Charts draws a tick at anchor + n·interval; a range of hundreds of intervals never comes out of roundRange.
    const double anchor = std::ceil(range.from / range.step - 1e-9) * range.step;
    const QString format = QStringLiteral("%.%1f").arg(range.decimals);
    if (axis->tickAnchor() == anchor && axis->tickInterval() == range.step && axis->min() == range.from &&
        axis->max() == range.to && axis->labelFormat() == format) {
        return false;
    }
    axis->setTickAnchor(anchor);
    axis->setTickInterval(range.step);
    axis->setRange(range.from, range.to);
    axis->setLabelFormat(format);
    return true;
}

void Chart::fit() {
    (void)fitAxes();
    viewport()->update();
}

bool Chart::fitAxes() {
    const DisplayUnit x = m_look.units().of(m_xUnit);
    const DisplayUnit y = m_look.units().of(m_yUnit);
    Extent across;
    Extent up;
    for (const Curve& curve : m_curves) {
        for (const QPointF& p : curve.points) {
            across.take(x.toShown(p.x()));
            up.take(y.toShown(p.y()));
        }
    }
    for (const Band& band : m_bands) {
        for (const BandPoint& p : band.points) {
            across.take(x.toShown(p.x));
            up.take(y.toShown(p.low));
            up.take(y.toShown(p.high));
        }
    }
    for (const Limit& limit : m_limits) {
        up.take(y.toShown(limit.value));
    }
    for (const double value : m_yIncludes) {
        up.take(y.toShown(value));
    }
    // Figures on the axes of a chart without anything in it would be of nothing.
    const bool figures = !across.empty() || m_emptyText.isEmpty();
    m_x->setLabelsVisible(figures || m_xRange.has_value());
    m_y->setLabelsVisible(figures || m_yRange.has_value());
    m_x->setGridLineVisible(figures);  // and no lines through the sentence
    m_y->setGridLineVisible(figures);
    bool moved = false;
    if (m_xRange) {
        moved = applyRange(m_x, x.toShown(m_xRange->first), x.toShown(m_xRange->second), false, m_wholeNumbers);
    } else if (!across.empty()) {
        // Half a part of air on both sides when the axis counts parts.
        const double air = m_wholeNumbers ? 0.5 : 0.0;
        moved = applyRange(m_x, across.low - air, across.high + air, !m_wholeNumbers, m_wholeNumbers);
    }
    if (m_yRange) {
        moved |= applyRange(m_y, y.toShown(m_yRange->first), y.toShown(m_yRange->second), false);
    } else if (!up.empty()) {
        moved |= applyRange(m_y, up.low, up.high, true);
    }
    return moved;
}

void Chart::fitY(double from, double to, bool keepWide) {
    if (m_yRange) {
        return;
    }
    m_y->setLabelsVisible(true);
    const DisplayUnit y = m_look.units().of(m_yUnit);
    Extent up;
    up.take(from);
    up.take(to);
    for (const Limit& limit : m_limits) {
        up.take(y.toShown(limit.value));
    }
    for (const double value : m_yIncludes) {
        up.take(y.toShown(value));
    }
    const bool inside = up.low >= m_y->min() && up.high <= m_y->max();
    if (keepWide && inside && (m_y->max() - m_y->min()) < 3.0 * (up.high - up.low)) {
        return;
    }
    (void)applyRange(m_y, up.low, up.high, true);
}

double Chart::radius() const {
    return m_look.metrics().stroke(Stroke::Bold) * 1.5;
}

QRegion Chart::covered(const Curve& curve) const {
    const double reach = 1.4 * radius() + m_look.metrics().stroke(Stroke::Normal) + 1.0;  // a diamond is the widest
    QRegion region;
    for (const QPointF& point : curve.shown) {
        const QPointF at = place(point);
        region += QRectF(at - QPointF(reach, reach), at + QPointF(reach, reach)).toAlignedRect();
    }
    return region;
}

QPointF Chart::place(const QPointF& shown) const {
    const QRectF plot = m_chart->plotArea();
    return {plot.left() + (shown.x() - m_x->min()) / (m_x->max() - m_x->min()) * plot.width(),
            plot.bottom() - (shown.y() - m_y->min()) / (m_y->max() - m_y->min()) * plot.height()};
}

void Chart::drawForeground(QPainter* painter, const QRectF&) {
    const QRectF plot = m_chart->plotArea();
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    if (m_lowTitles) {
        paintLowTitle(*painter, plot);
    }
    const bool empty = std::all_of(m_curves.begin(), m_curves.end(), [](const Curve& c) { return c.shown.isEmpty(); });
    painter->setFont(m_look.font(TextSize::Label));
    if (empty && !m_emptyText.isEmpty()) {
        painter->setFont(m_look.font(TextSize::Body));
        painter->setPen(m_look.color(Token::Dim));
        const double inset = m_look.space(Space::Large);
        painter->drawText(plot.adjusted(inset, 0, -inset, 0), Qt::AlignCenter | Qt::TextWordWrap, m_emptyText);
        painter->restore();
        return;
    }
    std::vector<QRectF> taken;
    paintMarks(*painter, plot);
    paintLimits(*painter, plot, taken);
    paintLines(*painter, plot);
    paintCurves(*painter, plot, taken);
    painter->restore();
}

void Chart::paintLowTitle(QPainter& painter, const QRectF& plot) const {
    painter.setFont(m_look.font(TextSize::Label));
    painter.setPen(m_look.color(Token::Dim));
    const QRectF row(0.0, plot.bottom(), plot.right(), viewport()->height() - plot.bottom());
    const QFontMetricsF metrics(painter.font());
    const double titleEnd = metrics.horizontalAdvance(m_x->titleText()) + m_look.space(Space::Small);
    const double tick = m_x->tickAnchor();  // the first one: its label gives way to a title that reaches it
    const int decimals = QStringView(m_x->labelFormat()).mid(2, 1).toInt();  // "%.2f"
    const double half = metrics.horizontalAdvance(UnitSystem::fixed(tick, decimals)) / 2.0 + m_look.space(Space::Small);
    const double tickAt = place({tick, m_y->min()}).x();
    if (tickAt - half < titleEnd) {
        painter.fillRect(QRectF(0.0, row.top() + 0.45 * metrics.height(), tickAt + half, row.height()),
                         m_look.color(Token::Panel));
    }
    painter.drawText(row, Qt::AlignLeft | Qt::AlignBottom, m_x->titleText());
}

void Chart::paintLines(QPainter&, const QRectF&) const {}

void Chart::paintLimits(QPainter& painter, const QRectF& plot, std::vector<QRectF>& taken) const {
    const DisplayUnit unit = m_look.units().of(m_yUnit);
    const QFontMetrics metrics(m_look.font(TextSize::Label));
    for (const Limit& limit : m_limits) {
        const double y = place({m_x->min(), unit.toShown(limit.value)}).y();
        if (y < plot.top() - 1.0 || y > plot.bottom() + 1.0) {
            continue;
        }
        painter.setPen(m_look.pen(limit.token, Stroke::Thin, limit.dashed ? Qt::DashLine : Qt::SolidLine));
        painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
        if (limit.label.isEmpty()) {
            continue;
        }
        const double height = metrics.height();
        const bool under = limit.below ? y + height <= plot.bottom() : y - height < plot.top();
        const double top = under ? y : y - height;
        const QRectF box(plot.left() + m_look.space(Space::Small), top, metrics.horizontalAdvance(limit.label), height);
        painter.fillRect(box, m_look.color(Token::Panel));  // readable where a curve passes behind it
        painter.setPen(m_look.color(limit.token));
        painter.drawText(box, Qt::AlignLeft | Qt::AlignVCenter, limit.label);
        taken.push_back(box);
    }
}

void Chart::paintMarks(QPainter& painter, const QRectF& plot) const {
    const DisplayUnit unit = m_look.units().of(m_xUnit);
    const QFontMetrics metrics(m_look.font(TextSize::Label));
    std::vector<std::pair<QRectF, QString>> written;
    for (const Mark& mark : m_marks) {
        const double x = place({unit.toShown(mark.x), m_y->min()}).x();
        if (x < plot.left() - 1.0 || x > plot.right() + 1.0) {
            continue;
        }
        painter.setPen(m_look.pen(mark.token, Stroke::Thin, Qt::DotLine));
        painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
        const double width = metrics.horizontalAdvance(mark.label);
        const double gap = m_look.space(Space::Small);
        const double left = x + gap + width > plot.right() ? x - gap - width : x + gap;
        // Marks close to each other: the same word stands once, another one in the next line.
        QRectF label(left, plot.top(), width, metrics.height());
        const auto meets = [&label](const auto& one) { return one.first.intersects(label); };
        auto other = std::ranges::find_if(written, meets);
        while (other != written.end() && other->second != mark.label) {
            label.moveTop(other->first.bottom() + 1.0);
            other = std::ranges::find_if(written, meets);
        }
        if (other == written.end()) {
            painter.setPen(m_look.color(Token::Dim));
            painter.drawText(label, Qt::AlignCenter, mark.label);
            written.emplace_back(label, mark.label);
        }
    }
}

// What the drawn lines cover of the columns from `left` to `right`, px.
std::vector<QRectF> Chart::linesBetween(double left, double right) const {
    std::vector<QRectF> covered;
    for (const Curve& curve : m_curves) {
        if (curve.style.kind == Kind::Points) {
            continue;
        }
        for (qsizetype i = 1; i < curve.shown.size(); ++i) {
            QPointF a = place(curve.shown[i - 1]);
            QPointF b = place(curve.shown[i]);
            if (std::max(a.x(), b.x()) < left || std::min(a.x(), b.x()) > right || a.x() == b.x()) {
                continue;
            }
            const double slope = (b.y() - a.y()) / (b.x() - a.x());
            const auto at = [&](double x) {
                return a.y() + slope * (std::clamp(x, std::min(a.x(), b.x()), std::max(a.x(), b.x())) - a.x());
            };
            const double low = std::min(at(left), at(right));
            covered.emplace_back(left, low - 1.0, right - left, std::abs(at(right) - at(left)) + 2.0);
        }
    }
    return covered;
}

void Chart::paintCurves(QPainter& painter, const QRectF& plot, std::vector<QRectF>& taken) const {
    const QFontMetrics metrics(m_look.font(TextSize::Label));
    const double r = radius();
    for (const Curve& curve : m_curves) {
        const QList<QPointF>& points = curve.shown;
        const QColor color = m_look.color(curve.style.token);
        if (curve.style.kind == Kind::Points || curve.style.kind == Kind::LineAndPoints) {
            painter.setPen(QPen(color, m_look.metrics().stroke(Stroke::Normal)));
            painter.setBrush(curve.style.marker == Marker::Ring ? QBrush(m_look.color(Token::Panel)) : QBrush(color));
            for (const QPointF& point : points) {
                const QPointF at = place(point);
                if (!plot.adjusted(-1, -1, 1, 1).contains(at)) {
                    continue;
                }
                switch (curve.style.marker) {
                    case Marker::Disc:
                    case Marker::Ring:
                        painter.drawEllipse(at, r, r);
                        break;
                    case Marker::Diamond:
                        painter.drawPolygon(QPolygonF{at + QPointF(0, -1.4 * r), at + QPointF(1.4 * r, 0),
                                                      at + QPointF(0, 1.4 * r), at + QPointF(-1.4 * r, 0)});
                        break;
                    case Marker::Triangle:
                        painter.drawPolygon(
                            QPolygonF{at + QPointF(0, -1.3 * r), at + QPointF(1.2 * r, r), at + QPointF(-1.2 * r, r)});
                        break;
                }
            }
        }
        if (curve.label.isEmpty() || points.isEmpty()) {
            continue;
        }
        // The name at the newest point, moved away from names already there.
        const QPointF end = place(points.last());
        const double width = metrics.horizontalAdvance(curve.label);
        const double height = metrics.height();
        double left = std::min(end.x() + r + m_look.space(Space::Small), plot.right() - width);
        double top = std::clamp(end.y() - height - r, plot.top(), plot.bottom() - height);
        const std::vector<QRectF> drawn = linesBetween(left, left + width);
        const auto touches = [](const std::vector<QRectF>& those, const QRectF& box) {
            return std::ranges::any_of(those, [&box](const QRectF& other) { return other.intersects(box); });
        };
        QRectF box(left, top, width, height);
        std::optional<QRectF> second;  // clear of names, but on a line
        for (int attempt = 0; attempt < 12; ++attempt) {
            const double shift = 0.5 * height * (attempt / 2 + 1);
            const bool free = !touches(taken, box);
            if (free && !touches(drawn, box)) {
                second = box;
                break;
            }
            second = free && !second ? std::optional(box) : second;
            box.moveTop(std::clamp(attempt % 2 == 0 ? top + shift : top - shift, plot.top(), plot.bottom() - height));
        }
        box = second.value_or(box);
        taken.push_back(box);
        painter.setPen(color);
        painter.drawText(box, Qt::AlignLeft | Qt::AlignVCenter, curve.label);
    }
}

}  // namespace kerf::ui
