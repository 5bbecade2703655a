// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/tapping/trial_bars.h"

#include <QPainter>
#include <algorithm>

#include "ui/pages/tapping/tapping_texts.h"

namespace kerf::ui {
namespace {
constexpr double kBarShare = 0.6;    ///< of a bar's place
constexpr std::size_t kPlaces = 4;   ///< fewer bars leave room at the right
constexpr double kWholeFrom = 9.95;  ///< no decimals from here
constexpr double kHeadroom = 1.05;
}  // namespace

TrialBars::TrialBars(Look& look, Figure figure, QWidget* parent) : FaceWidget(look, parent), m_figure(figure) {
    setObjectName(figure == Figure::Saec ? QStringLiteral("tappingSaecBars") : QStringLiteral("tappingPpBars"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    refresh();
}

void TrialBars::setView(const TappingServiceView& view) {
    m_view = view;
    rebuild();
}

void TrialBars::refresh() {
    FaceWidget::refresh();
    rebuild();
}

void TrialBars::rebuild() {
    m_bars.clear();
    const auto figure = [this](const TapFigures& f) { return m_figure == Figure::Saec ? f.saec_mm : f.engagedPp_um; };
    for (const TapTrialView& trial : m_view.trials) {
        m_bars.push_back({figure(trial.figures), QString::number(trial.number), trial.counted, trial.accepted});
    }
    if (m_bars.empty() && m_view.proof) {
        m_bars.push_back({figure(m_view.proof->first), tr("before"), true, false});
        m_bars.push_back({figure(m_view.proof->last), tr("after"), true, !m_view.proof->rolledBack});
    }
    setAccessibleName(values().join(u' '));
    update();
}

QString TrialBars::text(const Bar& bar) const {
    return look().units().number(bar.value, unit(), bar.value < kWholeFrom ? 1 : 0);
}

QStringList TrialBars::values() const {
    QStringList out;
    for (const Bar& bar : m_bars) {
        out << text(bar);
    }
    return out;
}

QSize TrialBars::minimumSizeHint() const {
    const QFontMetrics small(look().font(TextSize::Label));
    return {look().metrics().chart(), 6 * small.height()};
}

void TrialBars::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_bars.empty()) {
        painter.setFont(look().font(TextSize::Body));
        painter.setPen(look().color(Token::Dim));
        painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, tr("One bar per trial tap appears here."));
        return;
    }
    const QFont small = look().font(TextSize::Label);
    const QFontMetricsF metrics(small);
    painter.setFont(small);
    const QRectF plot = QRectF(rect()).adjusted(0, metrics.height(), 0, -metrics.height());
    double top = m_figure == Figure::EngagedPp ? m_view.thread.allowedPp_um : 0.0;
    for (const Bar& bar : m_bars) {
        top = std::max(top, bar.value);
    }
    top *= kHeadroom;
    const auto y = [&](double value) { return plot.bottom() - value / std::max(top, 1e-9) * plot.height(); };
    const auto places = static_cast<double>(std::max(kPlaces, m_bars.size()));
    const double place = m_view.trials.empty() ? plot.width() / 2.0 : plot.width() / places;
    painter.setPen(look().pen(Token::Line, Stroke::Thin));
    painter.drawLine(plot.bottomLeft(), plot.bottomRight());
    std::vector<QRectF> labels;
    for (std::size_t i = m_bars.size(); i-- > 0;) {  // the newest has its figure first
        const Bar& bar = m_bars[i];
        const double left = plot.left() + static_cast<double>(i) * place;
        const double width = std::min(place * kBarShare, plot.width() / static_cast<double>(kPlaces));
        const QRectF box(left + (place - width) / 2.0, y(bar.value), width, plot.bottom() - y(bar.value));
        painter.setPen(bar.counted ? QPen(Qt::NoPen) : look().pen(Token::Dim, Stroke::Thin, Qt::DashLine));
        painter.setBrush(!bar.counted        ? QBrush(Qt::NoBrush)
                         : bar.kept && i > 0 ? look().color(Token::Measured)
                                             : look().color(Token::Past));
        painter.drawRect(box);
        const QString value = text(bar);
        const double wide = metrics.horizontalAdvance(value);
        const QRectF label(left + (place - wide) / 2.0, box.top() - metrics.height(), wide, metrics.height());
        const auto touches = [&label](const QRectF& other) { return other.intersects(label); };
        if (std::ranges::none_of(labels, touches)) {  // where they are too close, every other one
            painter.setPen(look().color(Token::Text));
            painter.drawText(label, Qt::AlignCenter, value);
            labels.push_back(label);
        }
        painter.setPen(look().color(Token::Dim));
        painter.drawText(QRectF(left, plot.bottom(), place, metrics.height()), Qt::AlignCenter, bar.name);
    }
    if (m_figure == Figure::EngagedPp) {
        const double line = y(m_view.thread.allowedPp_um);
        painter.setPen(look().pen(Token::Limit, Stroke::Thin));
        painter.drawLine(QPointF(plot.left(), line), QPointF(plot.right(), line));
        const QString name = tr("allowed %1").arg(errorText(m_view.thread.allowedPp_um, look().units()));
        const QRectF box(plot.right() - metrics.horizontalAdvance(name), line - metrics.height(),
                         metrics.horizontalAdvance(name), metrics.height());
        painter.fillRect(box, look().color(Token::Panel));
        painter.setPen(look().color(Token::Limit));
        painter.drawText(box, Qt::AlignRight | Qt::AlignBottom, name);
    }
}

}  // namespace kerf::ui
