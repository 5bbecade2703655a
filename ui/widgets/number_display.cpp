// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/number_display.h"

#include <QFontMetrics>
#include <QPainter>

namespace kerf::ui {
namespace {
constexpr int kPeriod_ms = 200;
}

NumberDisplay::NumberDisplay(Look& look, const char* unit, int decimals, TextSize size, QWidget* parent)
    : FaceWidget(look, parent), m_unit(unit), m_decimals(decimals), m_size(size) {
    setSizePolicy(QSizePolicy::MinimumExpanding, QSizePolicy::Fixed);
    m_later.setSingleShot(true);
    connect(&m_later, &QTimer::timeout, this, &NumberDisplay::changed);
}

NumberDisplay::NumberDisplay(Look& look, const ParamSpec& spec, TextSize size, QWidget* parent)
    : NumberDisplay(look, spec.unit, spec.decimals, size, parent) {
    m_widest = spec.max;
}

void NumberDisplay::setLabel(const QString& label) {
    if (label == m_label) {
        return;
    }
    m_label = label;
    setAccessibleName(label);
    updateGeometry();
    update();
}

void NumberDisplay::setValue(double stored) {
    m_content.value = stored;
    m_content.age_s.reset();
    changed();
}

void NumberDisplay::setNothing() {
    m_content = Content{};
    changed();
}

void NumberDisplay::setReading(const Reading& reading, std::int64_t now_ns) {
    m_content.value.reset();
    m_content.age_s.reset();
    if (reading.good() || (reading.quality == Quality::Stale && std::isfinite(reading.value))) {
        m_content.value = reading.value;
    }
    if (reading.quality == Quality::Stale) {
        m_content.age_s = static_cast<int>((now_ns - reading.stamp_ns) / 1'000'000'000);
    }
    changed();
}

void NumberDisplay::setHalf95(std::optional<double> half) {
    m_content.half95 = half;
    changed();
}

void NumberDisplay::setLimited(bool limited) {
    m_content.limited = limited;
    changed();
}

void NumberDisplay::setWidest(double stored) {
    m_widest = stored;
    updateGeometry();
}

// The first change shows at once; those that follow within the period are shown together when it ends.
void NumberDisplay::changed() {
    if (m_content == m_shown) {
        return;
    }
    if (m_since.isValid() && m_since.elapsed() < kPeriod_ms) {
        if (!m_later.isActive()) {
            m_later.start(kPeriod_ms - static_cast<int>(m_since.elapsed()));
        }
        return;
    }
    m_since.start();
    m_shown = m_content;
    setAccessibleName(m_label + u' ' + text());
    update();
}

QString NumberDisplay::text() const {
    return m_content.value ? look().units().number(*m_content.value, m_unit, m_decimals) : QStringLiteral("–");
}

QString NumberDisplay::remark() const {
    if (m_shown.age_s) {
        return tr("%1 s old").arg(*m_shown.age_s);
    }
    if (m_shown.limited) {
        return tr("at limit");
    }
    if (m_shown.value && m_shown.half95) {
        return QStringLiteral("±") + QChar(QChar::Nbsp) +
               look().units().difference(*m_shown.half95, m_unit, m_decimals);
    }
    return {};
}

void NumberDisplay::refresh() {
    FaceWidget::refresh();
}

QSize NumberDisplay::sizeFor(const QString& digits) const {
    const QFontMetrics number(look().font(m_size, QFont::Medium));
    const QFontMetrics small(look().font(TextSize::Label));
    const int unit = small.horizontalAdvance(look().units().of(m_unit).symbol);
    const int width =
        number.horizontalAdvance(digits) + look().space(Space::Small) + qMax(unit, small.horizontalAdvance(remark()));
    const int labelHeight = m_label.isEmpty() ? 0 : small.height();
    return {qMax(width, small.horizontalAdvance(m_label)), labelHeight + qMax(number.height(), 2 * small.height())};
}

QSize NumberDisplay::sizeHint() const {
    return sizeFor(look().units().number(-m_widest, m_unit, m_decimals)).expandedTo(minimumSizeHint());
}

QSize NumberDisplay::minimumSizeHint() const {
    return sizeFor(text());
}

void NumberDisplay::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const QFont numberFont = look().font(m_size, QFont::Medium);
    const QFont smallFont = look().font(TextSize::Label);
    const QFontMetrics number(numberFont);
    const QFontMetrics small(smallFont);
    int top = 0;
    if (!m_label.isEmpty()) {
        painter.setFont(smallFont);
        painter.setPen(look().color(Token::Dim));
        painter.drawText(QRect(0, 0, width(), small.height()), Qt::AlignLeft | Qt::AlignVCenter, m_label);
        top = small.height();
    }
    const QString digits =
        m_shown.value ? look().units().number(*m_shown.value, m_unit, m_decimals) : QStringLiteral("–");
    const bool dim = !m_shown.value || m_shown.age_s;
    const int line = height() - top;
    painter.setFont(numberFont);
    painter.setPen(look().color(dim ? Token::Dim : Token::Text));
    painter.drawText(QRect(0, top, width(), line), Qt::AlignLeft | Qt::AlignVCenter, digits);
    const int x = number.horizontalAdvance(digits) + look().space(Space::Small);
    // Unit on the number's baseline; the remark above it.
    const int baseline = top + (line - number.height()) / 2 + number.ascent();
    painter.setFont(smallFont);
    painter.setPen(look().color(Token::Dim));
    painter.drawText(QPoint(x, baseline), look().units().of(m_unit).symbol);
    const QString note = remark();
    if (!note.isEmpty()) {
        const int noteBaseline = baseline - small.height();
        if (m_shown.limited && !m_shown.age_s) {
            painter.setPen(look().pen(Token::Limit, Stroke::Bold));
            const int y = noteBaseline - small.ascent();
            painter.drawLine(x, y, x + small.horizontalAdvance(note), y);
            painter.setPen(look().color(Token::Text));
        } else {
            painter.setPen(look().color(m_shown.half95 ? Token::Text : Token::Dim));
        }
        painter.drawText(QPoint(x, noteBaseline), note);
    }
}

}  // namespace kerf::ui
