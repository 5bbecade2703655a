// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/clamp_label.h"

#include <QPainter>
#include <QTextLayout>

namespace kerf::ui {

ClampLabel::ClampLabel(int lines, QWidget* parent) : QLabel(parent), m_lines(lines) {
    setTextFormat(Qt::PlainText);
    setProperty("elides", true);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
}

void ClampLabel::say(const QString& words) {
    if (words != text()) {
        setText(words);
        setToolTip(words);
        setAccessibleName(words);
    }
}

QSize ClampLabel::sizeHint() const {
    const QFontMetrics metrics(font());
    return {metrics.averageCharWidth() * 30, m_lines * metrics.lineSpacing()};
}

QSize ClampLabel::minimumSizeHint() const {
    return {0, sizeHint().height()};
}

void ClampLabel::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setPen(palette().color(foregroundRole()));
    painter.setFont(font());
    const QFontMetrics metrics(font());
    QTextLayout layout(text(), font());
    layout.beginLayout();
    std::vector<QTextLine> lines;
    for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
        line.setLineWidth(width());
        lines.push_back(line);
    }
    layout.endLayout();
    const int count = qMin(m_lines, static_cast<int>(lines.size()));
    int y = (height() - count * metrics.lineSpacing()) / 2 + metrics.ascent();
    for (int i = 0; i < count; ++i) {
        const QTextLine& line = lines[static_cast<std::size_t>(i)];
        const bool cut = i == m_lines - 1 && static_cast<int>(lines.size()) > m_lines;
        painter.drawText(0, y,
                         cut ? metrics.elidedText(text().mid(line.textStart()), Qt::ElideRight, width())
                             : text().mid(line.textStart(), line.textLength()));
        y += metrics.lineSpacing();
    }
}

}  // namespace kerf::ui
