// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QHBoxLayout>
#include <QHash>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QVBoxLayout>
#include <functional>
#include <vector>

#include "engine/core/result.h"
#include "ui/widgets/face_widget.h"

namespace kerf::ui {

class ScrollBox;
class SheetButtons;
class SheetHost;

/// A question or form laid over the page area. It is modal for the pages only: the bottom line with HOLD ALL, the
/// header and the engine stay reachable. Made by SheetHost; deletes itself when closed. What does not fit is scrolled,
/// the buttons stay in sight.
///
/// Focus: the field for which setFocus() was called while the sheet was built has the keys once it is laid out; when
/// there is none, the first field for text.
class Sheet : public FaceWidget {
    Q_OBJECT
 public:
    void setTitle(const QString& title);
    void setText(const QString& text);
    /// Use the whole page area: for forms with many fields.
    void setWide();
    /// Put fields here.
    [[nodiscard]] QVBoxLayout* body() const { return m_body; }
    /// Buttons from left to right; the first is the safe one and answers Escape. Use ActionButton or QPushButton.
    void addButton(QPushButton* button, std::function<void()> onClicked, bool closes = true);
    QPushButton* addButton(const QString& text, std::function<void()> onClicked, bool closes = true);
    void close();
    /// The language may change while this sheet is open: it looks after its own words, or is made anew by `remake`.
    /// Any other sheet keeps its words, so the language stays until it is closed (SheetHost::languageMayChange()).
    void followLanguage(std::function<void()> remake = {});

    /// What stands in the fields now is on its way into the store …
    void sent();
    /// … and has been taken: the sheet closes, unless something else was typed meanwhile. Then it stays, and says that
    /// this is not stored yet. True: it closed.
    bool taken();
    /// The same for one button: sent() now and the button at rest; with the answer taken(), or a refusal above the
    /// fields, in which everything stays. The sheet may have gone. `then` has every answer.
    using Answer = std::function<void(const Result<void>&)>;
    [[nodiscard]] Answer whenStored(QPushButton* button, Answer then);

 signals:
    void closed();

 protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void refresh() override;

 private:
    friend class SheetHost;
    Sheet(Look& look, QWidget* host);
    void place();
    void settleFocus();

    QFrame* m_frame;
    QWidget* m_content;
    ScrollBox* m_scroll;
    SheetButtons* m_buttons;
    QVBoxLayout* m_column;
    bool m_wide{false};
    QLabel* m_title;
    QLabel* m_text;
    QVBoxLayout* m_body;
    QHash<const QLineEdit*, QString> m_sent;
    std::vector<QPushButton*> m_list;
    bool m_follows{false};
    std::function<void()> m_remake{};
};

/// The page area that sheets cover. One sheet is seen at a time. A sheet that was opened over another gives it back as
/// it was when it closes; opening one for itself closes all. When the last one has gone, the field that had the focus
/// has it again.
class SheetHost : public QWidget {
    Q_OBJECT
 public:
    explicit SheetHost(Look& look, QWidget* parent = nullptr);

    /// An empty sheet, shown at once; those that are open close. For what a person asked for now: an answer that
    /// comes later asks isOpen() first, or it takes a form from under somebody's fingers.
    Sheet* open(const QString& title, const QString& text = {});
    /// As open(), but the sheet that is open comes back as it was when this one closes: for help, for questions, for
    /// whatever somebody opens from a form and comes back from.
    Sheet* openOver(const QString& title, const QString& text = {});
    /// This very sheet is open, and seen.
    [[nodiscard]] bool isOpen(const Sheet* sheet) const { return sheet != nullptr && m_current == sheet; }
    /// A question with two answers, over what is open: the safe one left.
    void ask(const QString& title, const QString& text, const QString& safe, const QString& proceed,
             std::function<void()> onProceed);
    /// A sentence with "Close", over what is open.
    void tell(const QString& title, const QString& text);
    [[nodiscard]] Sheet* current() const { return m_current; }
    /// No sheet is open that would keep the words it was opened with.
    [[nodiscard]] bool languageMayChange() const;
    /// The sheet that waits for figures: the lowest one, when others lie over it.
    [[nodiscard]] Sheet* waiting() const { return m_beneath.empty() ? m_current : m_beneath.front().sheet; }

 protected:
    void resizeEvent(QResizeEvent* event) override;

 private:
    /// Hidden by one that was opened over it.
    struct Beneath {
        Sheet* sheet{nullptr};
        QPointer<QWidget> focus{};
    };
    Sheet* make(const QString& title, const QString& text);
    void onClosed(Sheet* sheet);
    void settleLater(Sheet* sheet);
    void giveBackFocus();

    Look& m_look;
    Language m_language;
    Sheet* m_current{nullptr};
    std::vector<Beneath> m_beneath{};  ///< the lowest first
    QPointer<QWidget> m_before;        ///< had the focus when the first sheet came
};

}  // namespace kerf::ui
