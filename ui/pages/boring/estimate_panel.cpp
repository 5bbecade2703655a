// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/boring/estimate_panel.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/charts/decimate.h"
#include "ui/link/vocabulary.h"

namespace kerf::ui {
namespace {

constexpr int kDecimals = 3;
constexpr double kFewestParts = 12.0;

QString nameOf(std::size_t strip, Wording wording) {
    constexpr std::array kTerms{Term::FeedExponent, Term::OverhangExponent, Term::BendingConstant};
    return termText(kTerms[strip], wording);
}

}  // namespace

EstimateStrips::EstimateStrips(Look& look, QWidget* parent) : FaceWidget(look, parent) {
    setObjectName(QStringLiteral("boringEstimates"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    refresh();
}

void EstimateStrips::setView(const BoringServiceView& view) {
    for (auto& strip : m_strips) {
        strip.clear();
    }
    for (const EstimateView& estimate : view.estimates) {
        const auto part = static_cast<double>(estimate.part);
        const auto [lnC, alpha, beta] = estimate.value;
        const auto [lnCHalf, alphaHalf, betaHalf] = estimate.half95;
        m_strips[0].push_back({part, alpha, alpha - alphaHalf, alpha + alphaHalf});
        m_strips[1].push_back({part, beta, beta - betaHalf, beta + betaHalf});
        // The interval is symmetric in ln C, so it is not in C.
        m_strips[2].push_back({part, std::exp(lnC), std::exp(lnC - lnCHalf), std::exp(lnC + lnCHalf)});
    }
    m_changes.clear();
    for (const BorePartView& part : view.parts) {
        if (part.perturbed) {
            m_changes.push_back(part.number);
        }
    }
    m_from = 0.5;
    m_to = std::max(kFewestParts, m_strips[0].empty() ? 0.0 : m_strips[0].back().part) + 0.5;
    QString words;
    for (std::size_t strip = 0; strip < m_strips.size(); ++strip) {
        words += nameOf(strip, look().wording()) + u' ' + text(strip) + u' ';
    }
    setAccessibleName(words.trimmed());
    update();
}

QString EstimateStrips::text(std::size_t strip) const {
    if (m_strips[strip].empty()) {
        return QStringLiteral("–");
    }
    const Point& last = m_strips[strip].back();
    return UnitSystem::fixed(last.value, kDecimals) + QStringLiteral(" ± ") +
           UnitSystem::fixed((last.high - last.low) / 2.0, kDecimals);
}

int EstimateStrips::labelWidth() const {
    const QFontMetrics number(look().font(TextSize::Body, QFont::Medium));
    int width = number.horizontalAdvance(QStringLiteral("±0.000"));
    if (look().wording() == Wording::Shop) {
        for (std::size_t strip = 0; strip < m_strips.size(); ++strip) {
            width = std::max(width, number.horizontalAdvance(nameOf(strip, Wording::Shop)));
        }
    }
    return width + look().space(Space::Large);
}

QSize EstimateStrips::minimumSizeHint() const {
    const QFontMetrics small(look().font(TextSize::Label));
    const QFontMetrics body(look().font(TextSize::Body));
    return {labelWidth() + look().metrics().chart(), 3 * (body.height() + small.height()) + 2 * small.height()};
}

void EstimateStrips::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_strips[0].empty()) {
        painter.setFont(look().font(TextSize::Body));
        painter.setPen(look().color(Token::Dim));
        painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("The estimated constants of the law appear here after the first measured part."));
        return;
    }
    const QFontMetricsF small(look().font(TextSize::Label));
    const double axis = small.height() * 1.3;
    const double gap = look().space(Space::Medium);
    const double each = (height() - axis - 2.0 * gap) / 3.0;
    for (std::size_t strip = 0; strip < 3; ++strip) {
        paintStrip(painter, QRectF(0, static_cast<double>(strip) * (each + gap), width(), each), strip);
    }
    const double left = labelWidth();
    const double right = width() - small.horizontalAdvance(QStringLiteral("0.000")) - look().space(Space::Medium);
    const auto x = [&](double part) { return left + (part - m_from) / (m_to - m_from) * (right - left); };
    painter.setFont(look().font(TextSize::Label));
    painter.setPen(look().color(Token::Dim));
    const double top = height() - axis;
    painter.drawText(QRectF(0, top, left, axis), Qt::AlignVCenter | Qt::AlignLeft, tr("part"));
    const AxisRange ticks = roundRange(m_from, m_to);
    const double step = std::max(1.0, ticks.step);
    for (double part = std::ceil(m_from / step) * step; part <= m_to; part += step) {
        painter.drawText(QRectF(x(part) - left, top, 2.0 * left, axis), Qt::AlignCenter, QString::number(part, 'f', 0));
    }
    for (const double part : m_changes) {
        if (part >= m_from) {
            painter.setPen(look().pen(Token::Dim, Stroke::Thin, Qt::DotLine));
            painter.drawLine(QPointF(x(part), 0), QPointF(x(part), top));
        }
    }
}

void EstimateStrips::paintStrip(QPainter& painter, const QRectF& area, std::size_t strip) const {
    const std::vector<Point>& points = m_strips[strip];
    const QFontMetricsF small(look().font(TextSize::Label));
    const double left = labelWidth();
    const double right = width() - small.horizontalAdvance(QStringLiteral("0.000")) - look().space(Space::Medium);
    // The first intervals are wide: the scale follows the values and the newest intervals, the rest is cut off.
    double low = points.back().low;
    double high = points.back().high;
    for (const Point& point : points) {
        low = std::min(low, point.value);
        high = std::max(high, point.value);
    }
    const double air = std::max(1e-3, (high - low) * 0.15);
    low -= air;
    high += air;
    const auto place = [&](double part, double value) {
        return QPointF(left + (part - m_from) / (m_to - m_from) * (right - left),
                       area.bottom() - (std::clamp(value, low, high) - low) / (high - low) * area.height());
    };
    painter.setPen(QPen(look().palette().grid(), look().metrics().stroke(Stroke::Thin)));
    painter.drawLine(QPointF(left, area.bottom()), QPointF(right, area.bottom()));
    painter.drawLine(QPointF(left, area.top()), QPointF(right, area.top()));
    QPolygonF band;
    QPolygonF line;
    for (const Point& point : points) {
        band << place(point.part, point.high);
        line << place(point.part, point.value);
    }
    for (auto it = points.rbegin(); it != points.rend(); ++it) {
        band << place(it->part, it->low);
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(look().palette().band(Token::Predicted));
    painter.drawPolygon(band);
    painter.setPen(look().pen(Token::Predicted, Stroke::Normal));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(line);
    painter.setBrush(look().color(Token::Predicted));
    const double r = look().metrics().stroke(Stroke::Bold);
    painter.drawEllipse(line.back(), r, r);
    painter.setFont(look().font(TextSize::Label));
    painter.setPen(look().color(Token::Dim));
    const QRectF scale(right + look().space(Space::Small), area.top(), width() - right, area.height());
    painter.drawText(scale, Qt::AlignTop | Qt::AlignLeft, UnitSystem::fixed(high, 2));
    painter.drawText(scale, Qt::AlignBottom | Qt::AlignLeft, UnitSystem::fixed(low, 2));

    painter.setFont(look().font(TextSize::Body, QFont::Medium));
    painter.setPen(look().color(Token::Text));
    const QFontMetricsF body(painter.font());
    const double block = body.height() + small.height();
    const double top = area.top() + (area.height() - block) / 2.0;
    const QString value = UnitSystem::fixed(points.back().value, kDecimals);
    const QString half = u'±' + UnitSystem::fixed((points.back().high - points.back().low) / 2.0, kDecimals);
    const QString name = nameOf(strip, look().wording());
    const bool words = look().wording() == Wording::Shop;  // they have a line of their own
    painter.drawText(QRectF(0, top, left, body.height()), Qt::AlignLeft | Qt::AlignVCenter,
                     words ? name : name + u' ' + value);
    painter.setFont(look().font(TextSize::Label));
    painter.setPen(look().color(Token::Dim));
    painter.drawText(QRectF(0, top + body.height(), left, small.height()), Qt::AlignLeft | Qt::AlignVCenter,
                     words ? value + u' ' + half : half);
}

EstimatePanel::EstimatePanel(Look& look, QWidget* parent)
    : Card(look, parent), m_look(look), m_strips(new EstimateStrips(look, this)) {
    setObjectName(QStringLiteral("boringEstimatePanel"));
    body()->addWidget(m_strips, 1);
    connect(&look, &Look::changed, this, [this] { retranslate(); });
    retranslate();
}

void EstimatePanel::setView(const BoringServiceView& view) {
    if (m_estimator != view.estimator) {
        m_estimator = view.estimator;
        retranslate();
    }
    m_strips->setView(view);
}

void EstimatePanel::retranslate() {
    const QString name = termText(Term::BendingLaw, m_look.wording());
    setTitle(m_estimator.empty() || m_look.wording() == Wording::Shop
                 ? tr("%1, 95 % intervals", "of estimated figures").arg(name)
                 : tr("%1 (%2), 95 % intervals", "estimated figures, by which estimator")
                       .arg(name, QString::fromStdString(m_estimator)));
}

}  // namespace kerf::ui
