// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "ui/dialogs/sheet.h"
#include "ui/services/milling_service.h"
#include "ui/widgets/action_button.h"
#include "ui/widgets/keypad.h"
#include "ui/widgets/value_field.h"

class QButtonGroup;
class QComboBox;
class QStackedWidget;

namespace kerf::ui {

/// Every number of a part type's setup, in three groups, with unit, range, default and source of the one being typed.
/// Save keeps them under the name in the box (a new name makes a part type), Open goes to that part type as stored.
///
/// Object names: millingPartType (name), millingPartTypes (stored ones), millingGroup0…2,
/// millingField0…16 in the order of MillingService::fields(), millingSetupHint, millingSetupMessage,
/// millingSetupCancel, millingSetupOpen, millingSetupSave
class MillingSetupForm : public FaceWidget {
    Q_OBJECT
 public:
    using Author = std::function<std::string()>;
    static MillingSetupForm* open(SheetHost& host, Look& look, MillingService& service, Author author);

 protected:
    void refresh() override;
    bool eventFilter(QObject* watched, QEvent* event) override;

 private:
    MillingSetupForm(Look& look, MillingService& service, Author author, Sheet* sheet);
    void build();
    void showHint(std::size_t field);
    void save();
    void openType();
    void chosen(const Result<void>& result);
    void finish(const Result<void>& result);
    /// The answer of the service, if the form is still there then.
    [[nodiscard]] MillingService::Done whenDone(void (MillingSetupForm::*then)(const Result<void>&));
    [[nodiscard]] std::string name() const;
    [[nodiscard]] std::string reason() const;
    [[nodiscard]] std::optional<MillingSetup> typed();

    MillingService& m_service;
    Author m_author;
    Sheet* m_sheet;
    QLabel* m_nameLabel;
    QLineEdit* m_name;
    QComboBox* m_types;
    QButtonGroup* m_groups;
    QHBoxLayout* m_nameRow;
    QHBoxLayout* m_groupRow;
    QHBoxLayout* m_columns;
    QStackedWidget* m_pages;
    Keypad* m_keypad;
    QLabel* m_hint;
    QLineEdit* m_reason;
    QLabel* m_message;
    QPushButton* m_cancel;
    ActionButton* m_open;
    ActionButton* m_save;
    std::vector<ValueField*> m_fields;
    std::size_t m_hinted{0};
    MillingSetup m_setup{};  ///< to be saved when its part type has been chosen
};

}  // namespace kerf::ui
