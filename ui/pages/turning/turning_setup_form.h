// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <functional>
#include <string>
#include <vector>

#include "ui/dialogs/sheet.h"
#include "ui/services/turning_service.h"
#include "ui/widgets/action_button.h"
#include "ui/widgets/keypad.h"
#include "ui/widgets/value_field.h"

class QButtonGroup;
class QGridLayout;
class QStackedWidget;

namespace kerf::ui {

/// Sheet with the cut of the next part on one side and the machine's known tones on the other. The overlap factor of
/// radius, depth and feed is shown while they are typed.
///
/// Object names: turningSetupForm; switch turningSetupCut, turningSetupTones; fields turningField0…6 (depth, spindle
/// speed, feed, tool radius, face from, face to, trim authority), turningTone0…7 (empty: none); turningOverlap,
/// turningSetupMessage, turningSetupKeypad; buttons turningSetupCancel, turningSetupApply.
class TurningSetupForm : public FaceWidget {
    Q_OBJECT
 public:
    using Author = std::function<std::string()>;
    using OnDone = std::function<void(const QString& sentence)>;

    /// @param setup what the fields begin with
    static TurningSetupForm* open(SheetHost& host, Look& look, TurningService& service, Author author,
                                  const TurningSetup& setup, OnDone onDone);

 protected:
    void refresh() override;

 private:
    TurningSetupForm(Look& look, TurningService& service, Author author, const TurningSetup& setup, OnDone onDone,
                     Sheet* sheet);
    void reconsider();
    void apply();
    void answered(const Result<void>& result);
    void takeFocus();
    [[nodiscard]] TurningSetup typed() const;
    [[nodiscard]] QString whyNot() const;
    ValueField* makeField(const ParamSpec& spec, const QString& name, QGridLayout* grid, int place, int columns);

    TurningService& m_service;
    Author m_author;
    TurningSetup m_setup;
    OnDone m_onDone;
    QPointer<Sheet> m_sheet;
    QButtonGroup* m_sides;
    QPushButton* m_cut;
    QPushButton* m_tones;
    QStackedWidget* m_pages;
    QGridLayout* m_cutGrid;
    QGridLayout* m_toneGrid;
    std::vector<ValueField*> m_fields;
    std::vector<ValueField*> m_toneFields;
    QLabel* m_overlap;
    QLineEdit* m_reason;
    QLabel* m_message;
    Keypad* m_keypad;
    QHBoxLayout* m_columns;
    QHBoxLayout* m_sideRow;
    QPushButton* m_cancel;
    ActionButton* m_apply;
    Sentence m_refusal{};
    bool m_pending{false};
};

}  // namespace kerf::ui
