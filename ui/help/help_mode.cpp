// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/help_mode.h"

#include <QApplication>
#include <QFile>
#include <QMouseEvent>
#include <QScroller>
#include <QTextBrowser>
#include <optional>

#include "ui/widgets/label.h"

namespace kerf::ui {

HelpMode::HelpMode(Look& look, SheetHost& sheets, QWidget* window)
    : QObject(window), m_look(look), m_sheets(sheets), m_window(window) {
    qApp->installEventFilter(this);
}

void HelpMode::setActive(bool active) {
    if (active != m_active) {
        m_active = active;
        emit changed(active);
    }
}

bool HelpMode::eventFilter(QObject* watched, QEvent* event) {
    if (m_swallow != nullptr && event->type() == QEvent::MouseButtonRelease && watched == m_swallow) {
        m_swallow = nullptr;
        return true;
    }
    if (!m_active || event->type() != QEvent::MouseButtonPress || !watched->isWidgetType()) {
        return false;
    }
    auto* widget = static_cast<QWidget*>(watched);
    const QString name = widget->objectName();
    if (widget->window() != m_window || name == QLatin1String("holdAll") || name == QLatin1String("help")) {
        return false;
    }
    m_swallow = watched;
    setActive(false);
    explain(widget);
    return true;
}

void HelpMode::explain(const QWidget* widget) {
    const std::vector<HelpText> texts = helpTexts();
    std::optional<HelpText> text;
    // The nearest paragraph; formula and source may be those of the panel or page around it.
    for (const QWidget* w = widget; w != nullptr && (!text || text->formula.isEmpty() || text->source.isEmpty());
         w = w->parentWidget()) {
        const QString page = w->property("pageKey").toString();
        for (const QString& key : {w->objectName(), page.isEmpty() ? QString() : QStringLiteral("page:") + page}) {
            const HelpText* found = findHelp(texts, key);
            if (found != nullptr && !text) {
                text = *found;
            } else if (found != nullptr) {
                text->formula = text->formula.isEmpty() ? found->formula : text->formula;
                text->source = text->source.isEmpty() ? found->source : text->source;
            }
        }
    }
    if (!text) {
        openGuide();
        return;
    }
    show(*text);
    m_sheets.current()->followLanguage([this, asked = QPointer(widget)] { asked ? explain(asked) : openGuide(); });
}

// Help on help takes its place.
Sheet* HelpMode::open(const QString& title) {
    if (m_sheets.isOpen(m_open)) {
        m_open->close();
    }
    m_open = m_sheets.openOver(title);
    return m_open;
}

void HelpMode::show(const HelpText& text) {
    Sheet* sheet = open(text.title);
    auto* words = makeLabel(TextRole::Body, sheet, true);
    words->setObjectName(QStringLiteral("helpWords"));
    words->setText(text.words);
    sheet->body()->addWidget(words);
    sheet->addButton(tr("Close"), {})->setObjectName(QStringLiteral("sheetSafe"));
    if (!text.formula.isEmpty() || !text.source.isEmpty()) {
        auto* behind = new QWidget(sheet);
        behind->setObjectName(QStringLiteral("helpBehind"));
        auto* column = new QVBoxLayout(behind);
        column->setContentsMargins(0, 0, 0, 0);
        auto* formula = makeLabel(TextRole::Title, behind, true);
        formula->setText(text.formula);
        formula->setVisible(!text.formula.isEmpty());
        column->addWidget(formula);
        auto* source = makeLabel(TextRole::Small, behind, true);
        source->setObjectName(QStringLiteral("helpSource"));
        source->setText(text.source);
        source->setVisible(!text.source.isEmpty());
        column->addWidget(source);
        sheet->body()->addWidget(behind);
        if (m_look.wording() == Wording::Shop) {  // a second touch shows what engineers see at once
            behind->hide();
            QPushButton* more = sheet->addButton(
                tr("The formula"), [behind] { behind->setVisible(!behind->isVisible()); }, false);
            more->setObjectName(QStringLiteral("helpFormula"));
        }
    }
    sheet->addButton(tr("The guide"), [this] { openGuide(); })->setObjectName(QStringLiteral("helpGuide"));
}

void HelpMode::openGuide() {
    const bool korean = m_look.preferences().language == Language::Korean;
    QFile file(korean ? QStringLiteral(":/guide/ko/operator.md") : QStringLiteral(":/guide/operator.md"));
    QString text;
    if (file.open(QIODevice::ReadOnly)) {
        text = QString::fromUtf8(file.readAll());
    }
    Sheet* sheet = open(tr("The guide"));
    sheet->setWide();
    auto* guide = new QTextBrowser(sheet);
    guide->setObjectName(QStringLiteral("helpGuideText"));
    guide->setOpenLinks(false);
    guide->setFont(m_look.font(TextSize::Body));
    guide->setMarkdown(text);
    QScroller::grabGesture(guide->viewport(), QScroller::TouchGesture);
    sheet->body()->addWidget(guide, 1);
    sheet->addButton(tr("Close"), {})->setObjectName(QStringLiteral("sheetSafe"));
    sheet->followLanguage([this] { openGuide(); });
}

}  // namespace kerf::ui
