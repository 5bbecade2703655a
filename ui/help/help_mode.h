// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>

#include "ui/dialogs/sheet.h"
#include "ui/help/help_texts.h"

namespace kerf::ui {

/// "?": the next touch explains what it touches instead of doing it. HOLD ALL does what it does, always.
///
/// Object names: helpWords, helpFormula, helpGuide, helpGuideText.
class HelpMode : public QObject {
    Q_OBJECT
 public:
    HelpMode(Look& look, SheetHost& sheets, QWidget* window);

    void setActive(bool active);
    [[nodiscard]] bool active() const { return m_active; }
    /// Explains `widget`: the nearest of its ancestors that has a paragraph.
    void explain(const QWidget* widget);
    /// The operator's guide, as it stands beside the program.
    void openGuide();

 signals:
    void changed(bool active);

 protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

 private:
    Sheet* open(const QString& title);
    void show(const HelpText& text);

    Look& m_look;
    SheetHost& m_sheets;
    QWidget* m_window;
    bool m_active{false};
    QPointer<Sheet> m_open{};
    QPointer<QObject> m_swallow{};  ///< the release of the touch that was a question
};

}  // namespace kerf::ui
