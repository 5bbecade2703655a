// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/machine_strip.h"

#include <QFontMetrics>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/link/texts.h"

namespace kerf::ui {
namespace {

constexpr double kSecondsPerMinute = 60.0;
constexpr int kPeriod_ms = 200;
const QString kNoValue = QStringLiteral("–");

QString clockTime(double left_s) {
    const auto whole = static_cast<long long>(std::ceil(left_s));
    return QStringLiteral("%1:%2").arg(whole / 60).arg(whole % 60, 2, 10, QLatin1Char('0'));
}

bool same(const std::vector<StripFigure>& a, const std::vector<StripFigure>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const StripFigure& x, const StripFigure& y) {
        return x.label == y.label && x.value == y.value && x.stale == y.stale;
    });
}

}  // namespace

MachineStrip::MachineStrip(Look& look, QWidget* parent) : FaceWidget(look, parent) {
    setObjectName(QStringLiteral("machineStrip"));
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    refresh();
}

void MachineStrip::setStatus(const Status& status, const StripTool& tool) {
    const bool turn = status.program != m_status.program || status.link != m_status.link;
    if (m_since.isValid() && !turn && m_since.elapsed() < kPeriod_ms) {
        return;  // numbers do not jitter
    }
    m_since.start();
    m_status = status;
    m_tool = tool;
    std::vector<StripFigure> now = figuresOf(status, tool);
    if (same(now, m_figures)) {
        return;
    }
    m_figures = std::move(now);
    QStringList words;
    for (const StripFigure& figure : m_figures) {
        words << figure.label + u' ' + figure.value;
    }
    setAccessibleName(words.join(QStringLiteral(", ")));
    update();
}

StripFigure MachineStrip::load(const Status& status) const {
    const Reading& force =
        status.programProcess == ProcessId::Turning ? status.turning.force_N : status.milling.force_N;
    const bool has = (status.programProcess == ProcessId::Milling && status.milling.cutting) ||
                     (status.programProcess == ProcessId::Turning && status.turning.stage == TurningStage::Cutting);
    return {tr("Force"),
            has && force.good() ? look().units().withUnit(force.value, "N", force.value < 10.0 ? 2 : 0) : kNoValue,
            !has || !force.good()};
}

std::vector<StripFigure> MachineStrip::figuresOf(const Status& status, const StripTool& tool) const {
    const UnitSystem& units = look().units();
    const bool runs = status.program == ProgramState::Running || status.program == ProgramState::Paused;
    const bool linked = status.link == LinkState::Up;
    std::vector<StripFigure> shown;
    const QString program = status.program == ProgramState::Paused ? tr("%1, paused") : QStringLiteral("%1");
    shown.push_back({tr("Program"), runs ? program.arg(processName(status.programProcess)) : tr("none runs"), !runs});
    const Reading& speed = status.spindleSpeed_rpm;
    shown.push_back({tr("S"), linked && speed.good() ? units.withUnit(std::abs(speed.value), "rpm", 0) : kNoValue,
                     !linked || !speed.good()});
    const Reading& feed = status.actualFeed_mmPerS;
    shown.push_back({tr("F"),
                     linked && feed.good()
                         ? units.withUnit(feed.value * kSecondsPerMinute, "mm/min", feed.value < .2 ? 1 : 0)
                         : kNoValue,
                     !linked || !feed.good()});
    shown.push_back({tr("Knob"),
                     linked ? QStringLiteral("%1 %").arg(std::lround(100.0 * status.operatorOverride)) : kNoValue,
                     !linked});
    if (std::abs(status.feedScale - 1.0) > .005 && runs) {
        shown.back().value += QStringLiteral(" × %1 %").arg(std::lround(100.0 * status.feedScale));
    }
    shown.push_back(load(status));
    if (tool.known) {
        shown.push_back({tr("Tool"),
                         tool.partsLeft ? tr("%n parts left", nullptr, static_cast<int>(*tool.partsLeft))
                                        : tr("%n parts", nullptr, static_cast<int>(tool.parts)),
                         false});
    }
    const bool bores = runs && status.programProcess == ProcessId::Boring && status.boring.cutting;
    double left_s = bores ? status.boring.remaining_s : 0.0;
    if (runs && status.programProcess == ProcessId::Milling && status.milling.cutting && feed.good() &&
        feed.value > 0.0 && status.milling.progress > .02) {
        left_s = status.milling.position_mm / status.milling.progress * (1.0 - status.milling.progress) / feed.value;
    }
    shown.push_back({tr("To go"), left_s > 0.0 ? clockTime(left_s) : kNoValue, left_s <= 0.0});
    return shown;
}

QSize MachineStrip::sizeHint() const {
    const QFontMetrics metrics(look().font(TextSize::Label));
    return {metrics.averageCharWidth() * 40, metrics.height() + look().space(Space::Small)};
}

QSize MachineStrip::minimumSizeHint() const {
    return {0, sizeHint().height()};
}

void MachineStrip::refresh() {
    m_figures.clear();
    m_since.invalidate();
    setStatus(m_status, m_tool);
    FaceWidget::refresh();
}

void MachineStrip::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), look().color(Token::Panel));
    const QFont label = look().font(TextSize::Label);
    const QFont value = look().font(TextSize::Label, QFont::DemiBold);
    const int gap = look().space(Space::Large) + look().space(Space::Medium);
    const int small = look().space(Space::Small);
    std::vector<int> widths;
    for (const StripFigure& figure : m_figures) {
        widths.push_back(QFontMetrics(label).horizontalAdvance(figure.label) + small +
                         QFontMetrics(value).horizontalAdvance(figure.value) + gap);
    }
    int room = width() - 2 * look().space(Space::Medium);
    std::vector<bool> drawn(m_figures.size(), true);
    int used = 0;
    for (const int w : widths) {
        used += w;
    }
    for (std::size_t i = m_figures.size(); i-- > 0 && used - gap > room;) {
        if (i + 1 < m_figures.size()) {  // the time to go stays
            drawn[i] = false;
            used -= widths[i];
        }
    }
    int x = look().space(Space::Medium);
    for (std::size_t i = 0; i < m_figures.size(); ++i) {
        if (!drawn[i]) {
            continue;
        }
        const StripFigure& figure = m_figures[i];
        painter.setFont(label);
        painter.setPen(look().color(Token::Dim));
        painter.drawText(QRect(x, 0, width(), height()), Qt::AlignVCenter | Qt::AlignLeft, figure.label);
        const int after = x + QFontMetrics(label).horizontalAdvance(figure.label) + small;
        painter.setFont(value);
        painter.setPen(look().color(figure.stale ? Token::Dim : Token::Text));
        painter.drawText(QRect(after, 0, width(), height()), Qt::AlignVCenter | Qt::AlignLeft, figure.value);
        x += widths[i];
    }
}

}  // namespace kerf::ui
