// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <vector>

#include "ui/services/boring_lots.h"
#include "ui/shell/page.h"
#include "ui/widgets/action_button.h"
#include "ui/widgets/keypad.h"
#include "ui/widgets/value_field.h"

class QButtonGroup;
class QComboBox;
class QLineEdit;
class QTableWidget;

namespace kerf::ui {

/// The lots of this machine: open the next one, go on with an earlier one, close the current one; from here to part
/// types and their recipes. The next lot stands filled in, so that opening it is one touch.
///
/// Object names: lotNow, lotPartType, lotName, lotSize, lotKalman, lotPerturbation, lotKeypad, lotTable, lotMessage,
/// lotReason, lotGrade, lotMaterial, lotLeaveOut; buttons: lotCancel, lotClose, lotRecipe, lotNewPartType, lotChoose,
/// lotOpen.
class LotForm : public FaceWidget {
    Q_OBJECT
 public:
    /// Opens the sheet. @pre context.services.boringLots and boringService are there
    static LotForm* open(const PageContext& context);

    /// Part type of the lot to be opened (one that has just been made).
    void choosePartType(PartTypeId partType);

 protected:
    void refresh() override;

 private:
    LotForm(const PageContext& context, Sheet* sheet);
    void read();
    void fillTable();
    void propose();
    void reconsider();
    void openRecipe(std::optional<PartTypeId> type);
    void openLot();
    void chooseLot();
    void closeLot();
    void leaveOut();
    [[nodiscard]] int ownRows() const;
    [[nodiscard]] const BoringMemoryLotView* rememberedIn(int row) const;
    [[nodiscard]] static QString counts(const BoringMemoryLotView* memory);
    [[nodiscard]] const BoringMemoryLotView* remembered() const;
    [[nodiscard]] QString whyNoLeaveOut() const;
    void change(const QString& done, std::function<void(const PageContext&, BoringLots::Done)> act);
    void answered(const Result<void>& result, const QString& done);
    [[nodiscard]] PartTypeId partType() const;
    [[nodiscard]] const BoringLotView* chosen() const;
    [[nodiscard]] QString whyNoChange() const;
    [[nodiscard]] QString whyNoOpen() const;
    [[nodiscard]] QString whyNoChoice() const;
    [[nodiscard]] QString whyNoClose() const;

    PageContext m_context;
    BoringLots& m_lots;
    QPointer<Sheet> m_sheet;
    QLabel* m_now;
    QLabel* m_partTypeLabel;
    QComboBox* m_partType;
    QLabel* m_nameLabel;
    QLineEdit* m_name;
    QLineEdit* m_grade;
    QLineEdit* m_material;
    ValueField* m_size;
    QButtonGroup* m_estimator;
    QPushButton* m_kalman;
    QPushButton* m_perturbation;
    Keypad* m_keypad;
    QTableWidget* m_table;
    QLineEdit* m_reason;
    ActionButton* m_leaveOut;
    QLabel* m_message;
    QPushButton* m_cancel;
    ActionButton* m_close;
    QPushButton* m_recipe;
    ActionButton* m_newPartType;
    ActionButton* m_choose;
    ActionButton* m_open;
    QGridLayout* m_fields;
    QHBoxLayout* m_columns;
    std::vector<BoringPartTypeView> m_types;
    std::vector<BoringLotView> m_known;
    std::vector<BoringMemoryLotView> m_memory;
    QString m_trouble{};
    bool m_pending{false};
};

}  // namespace kerf::ui
