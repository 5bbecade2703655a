// SPDX-License-Identifier: GPL-3.0-or-later
#include <QHash>

#include "ui/theme/look.h"

namespace kerf::ui {
namespace {

// Names in @…@ are tokens and metrics; nothing here is a literal colour or size.
constexpr const char* kTemplate = R"(
* { color: @text@; outline: none; }
QMainWindow, QDialog, QWidget#page, QScrollArea, QScrollArea > QWidget > QWidget { background: @ground@; }
QScrollArea { border: none; }
QLabel, QCheckBox, QRadioButton { background: transparent; }
QLabel[role="label"] { font-size: @label@px; color: @dim@; }
QLabel[role="dim"] { color: @dim@; }
QLabel[role="title"] { font-weight: 600; }
QFrame[role="card"] { background: @panel@; border: @hairline@px solid @line@; border-radius: @corner@px; }
QLabel[role="card"] { font-size: @card@px; background: transparent; border: none; }
QFrame[role="sheet"] { background: @panel@; border: @hairline@px solid @dim@; border-radius: @corner@px; }
QFrame[role="bar"] { background: @panel@; border: none; }
QScrollArea, QWidget[role="scrolled"] { background: transparent; border: none; }
QFrame[role="rule"] { background: @line@; border: none; }
QPushButton, QToolButton {
    background: @raised@; border: @hairline@px solid @line@; border-radius: @corner@px;
    min-height: @touchInner@px; min-width: @touchInner@px; padding: 0 @medium@px; }
QPushButton:hover, QToolButton:hover { border-color: @dim@; }
QPushButton:pressed, QToolButton:pressed { background: @line@; }
QPushButton:checked, QToolButton:checked { background: @ground@; border: @edge@px solid @text@;
    min-height: @touchEdge@px; min-width: @touchEdge@px; }
QPushButton:focus, QToolButton:focus, QLineEdit:focus, QComboBox:focus { border: @edge@px solid @measured@;
    min-height: @touchEdge@px; }
QPushButton:disabled, QToolButton:disabled { color: @dim@; background: @panel@; border-style: dashed; }
QPushButton[primary="true"] { border: @edge@px solid @text@; font-weight: 600;
    min-height: @touchEdge@px; min-width: @touchEdge@px; }
QPushButton[primary="true"]:disabled { border: @edge@px dashed @line@; font-weight: 400; }
QLineEdit, QComboBox, QAbstractSpinBox, QPlainTextEdit {
    background: @raised@; border: @hairline@px solid @line@; border-radius: @corner@px;
    min-height: @touchInner@px; padding: 0 @medium@px;
    selection-background-color: @measured@; selection-color: @onMeasured@; }
QLineEdit:disabled { color: @dim@; background: @panel@; }
QLineEdit[wrong="true"] { border: @edge@px solid @alarm2@; min-height: @touchEdge@px; }
QComboBox::drop-down { border: none; width: @touchHalf@px; }
QComboBox QAbstractItemView { background: @raised@; border: @hairline@px solid @line@; }
QComboBox QAbstractItemView::item { min-height: @touchInner@px; }
QCheckBox, QRadioButton { min-height: @touch@px; spacing: @medium@px; }
QCheckBox::indicator, QRadioButton::indicator {
    width: @box@px; height: @box@px; background: @raised@; border: @hairline@px solid @dim@; border-radius: @corner@px; }
QCheckBox::indicator:checked, QRadioButton::indicator:checked { background: @text@; }
QTableView, QListView, QTreeView { background: @panel@; alternate-background-color: @raised@; gridline-color: @line@;
    border: @hairline@px solid @line@; selection-background-color: @ground@; selection-color: @text@; }
QTableView::item, QListView::item { padding: 0 @small@px; border: none; }
QTableView::item:selected, QListView::item:selected { background: @ground@; color: @text@; }
QHeaderView { background: @panel@; }
QHeaderView::section { background: @panel@; color: @dim@; border: none; border-bottom: @hairline@px solid @line@;
    font-size: @label@px; padding: @small@px; }
QTableCornerButton::section { background: @panel@; border: none; }
QScrollBar:vertical { background: @panel@; width: @scroll@px; margin: 0; }
QScrollBar:horizontal { background: @panel@; height: @scroll@px; margin: 0; }
QScrollBar::handle { background: @past@; border-radius: @corner@px; min-height: @touch@px; min-width: @touch@px; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
QProgressBar { background: @raised@; border: @hairline@px solid @line@; border-radius: @corner@px; text-align: center; }
QProgressBar::chunk { background: @past@; }
QToolTip { background: @raised@; color: @text@; border: @hairline@px solid @dim@; padding: @small@px; }
QTabBar::tab { background: @panel@; color: @dim@; min-height: @touchInner@px; min-width: @touch@px; padding: 0 @large@px;
    border: @hairline@px solid @line@; }
QTabBar::tab:selected { background: @raised@; color: @text@; border-bottom: @edge@px solid @text@; }
QTabWidget::pane { border: none; }
)";

}  // namespace

QString styleSheet(const Look& look) {
    const Metrics& m = look.metrics();
    const int hairline = qMax(1, static_cast<int>(m.stroke(Stroke::Thin)));
    const int edge = qMax(2, static_cast<int>(m.stroke(Stroke::Normal)));
    const QHash<QString, QString> values{
        {QStringLiteral("ground"), look.color(Token::Ground).name()},
        {QStringLiteral("panel"), look.color(Token::Panel).name()},
        {QStringLiteral("raised"), look.color(Token::Raised).name()},
        {QStringLiteral("line"), look.color(Token::Line).name()},
        {QStringLiteral("text"), look.color(Token::Text).name()},
        {QStringLiteral("dim"), look.color(Token::Dim).name()},
        {QStringLiteral("measured"), look.color(Token::Measured).name()},
        {QStringLiteral("onMeasured"), Palette::on(look.color(Token::Measured)).name()},
        {QStringLiteral("past"), look.color(Token::Past).name()},
        {QStringLiteral("alarm2"), look.color(Token::Alarm2).name()},
        {QStringLiteral("label"), QString::number(m.text(TextSize::Label))},
        {QStringLiteral("body"), QString::number(m.text(TextSize::Body))},
        {QStringLiteral("card"), QString::number(m.text(TextSize::Card))},
        {QStringLiteral("small"), QString::number(m.space(Space::Small))},
        {QStringLiteral("medium"), QString::number(m.space(Space::Medium))},
        {QStringLiteral("large"), QString::number(m.space(Space::Large))},
        {QStringLiteral("corner"), QString::number(m.corner())},
        {QStringLiteral("hairline"), QString::number(hairline)},
        {QStringLiteral("edge"), QString::number(edge)},
        {QStringLiteral("touch"), QString::number(m.touch())},
        {QStringLiteral("touchInner"), QString::number(m.touch() - 2 * hairline)},
        {QStringLiteral("touchEdge"), QString::number(m.touch() - 2 * edge)},
        {QStringLiteral("touchHalf"), QString::number(m.touch() / 2)},
        {QStringLiteral("box"), QString::number(m.touch() / 2)},
        {QStringLiteral("scroll"), QString::number(m.touch() / 2)},
    };
    QString sheet;
    const QString source = QString::fromLatin1(kTemplate);
    const QStringList parts = source.split(u'@');
    for (qsizetype i = 0; i < parts.size(); ++i) {
        if (i % 2 == 0) {
            sheet += parts[i];
        } else {
            Q_ASSERT(values.contains(parts[i]));
            sheet += values.value(parts[i]);
        }
    }
    return sheet;
}

}  // namespace kerf::ui
