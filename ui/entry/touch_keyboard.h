// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <vector>

#include "ui/entry/hangul.h"
#include "ui/widgets/face_widget.h"

class QLineEdit;
class QPushButton;
class QVBoxLayout;

namespace kerf::ui {

/// Letters for a panel without a keyboard: Latin, Hangul (two-set) and signs, over the page area.
///
/// It comes when a field for text is touched, and goes with its own key, with the field, with a touch elsewhere, or
/// with the first key of a real keyboard. A field for numbers gets it only where no number pad stands beside it.
///
/// Object names: touchKeyboard; keys touchKey_q …, touchShift, touchLanguage, touchSigns, touchSpace, touchBack,
/// touchEnter, touchHide.
class TouchKeyboard : public FaceWidget {
    Q_OBJECT
 public:
    /// @param area the widget it lies over; it filters the application's events for touches on fields inside it
    TouchKeyboard(Look& look, QWidget* area);

    bool eventFilter(QObject* watched, QEvent* event) override;
    void openFor(QLineEdit* field);
    [[nodiscard]] QLineEdit* field() const { return m_field; }

 protected:
    void refresh() override;

 private:
    enum class Page { Latin, Hangul, Signs };
    void build();
    void place();
    void show(Page page);
    void showFaces();
    void touched(std::size_t key);
    void type(const QString& text);
    void typeKey(int key, const QString& text = {});
    void compose(const HangulComposer::Step& step);
    [[nodiscard]] bool syllableStands() const;
    void endSyllable();
    void onTouch(QObject* watched);
    [[nodiscard]] static bool wantsLetters(const QLineEdit* field);
    QPushButton* addKey(int row, const char* name, int stretch);

    QPointer<QLineEdit> m_field;
    QVBoxLayout* m_rows;
    std::vector<QPushButton*> m_letters;
    std::vector<QPushButton*> m_all;
    QPushButton* m_shift{nullptr};
    QPushButton* m_language{nullptr};
    QPushButton* m_signs{nullptr};
    QPushButton* m_space{nullptr};
    QPushButton* m_enter{nullptr};
    QPushButton* m_hide{nullptr};
    HangulComposer m_composer;
    QString m_syllable;  ///< in the making, as it stands before the cursor
    Page m_page{Page::Latin};
    Page m_words{Page::Latin};  ///< the page before the signs
    bool m_shifted{false};
};

}  // namespace kerf::ui
