// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <optional>
#include <vector>

#include "ui/services/boring_lots.h"
#include "ui/shell/page.h"
#include "ui/widgets/action_button.h"
#include "ui/widgets/keypad.h"
#include "ui/widgets/value_field.h"

class QLineEdit;
class QScrollArea;
class QTableWidget;

namespace kerf::ui {

/// A part type's recipe: every number with range, default and source; where the bore is measured; older revisions, what
/// differs from them, and the way back. Without a part type: a new one.
///
/// A lot keeps the revision it was opened with, so nothing here touches the lot in work.
///
/// Object names: recipeName (new part type), recipeField0… (one per number), recipeDepth0…, recipeDepthRemove0…,
/// recipeDepthAdd, recipeRevisions, recipeDifference, recipeReason, recipeMessage, recipeKeypad; buttons: recipeCancel,
/// recipeRestore, recipeSave.
class RecipeForm : public FaceWidget {
    Q_OBJECT
 public:
    /// Opens the sheet. @pre context.services.boringLots is there
    static RecipeForm* open(const PageContext& context, std::optional<PartTypeId> partType);

 protected:
    void refresh() override;

 private:
    RecipeForm(const PageContext& context, std::optional<PartTypeId> partType, Sheet* sheet);
    void build(Sheet* sheet);
    void read();
    void showForm(const BoringRecipeForm& form);
    void addDepth(double overhang_mm);
    void layDepths();
    void showRevision(int row);
    void showDifference();
    void reconsider();
    void save();
    void beginWaiting();
    void restore();
    void answered(const Result<void>& result, const QString& done);
    /// What is typed now; empty while a field does not hold a number in its range.
    [[nodiscard]] std::optional<BoringRecipeForm> typed() const;
    [[nodiscard]] const BoringRecipeView* shownRevision() const;
    [[nodiscard]] QString valueText(const ParamSpec* spec, const std::optional<double>& value) const;
    [[nodiscard]] QString whyNoChange() const;
    [[nodiscard]] QString whyNoSave() const;
    [[nodiscard]] QString whyNoRestore() const;

    PageContext m_context;
    BoringLots& m_lots;
    std::optional<PartTypeId> m_partType;
    QPointer<Sheet> m_sheet;
    QLineEdit* m_name;
    QScrollArea* m_area;
    QGridLayout* m_grid;
    QGridLayout* m_depthGrid;
    std::vector<ValueField*> m_fields;
    std::vector<QLabel*> m_hints;
    QLabel* m_depthTitle;
    struct Depth {
        ValueField* field;
        QPushButton* remove;
    };
    std::vector<Depth> m_depths;
    ActionButton* m_add;
    QTableWidget* m_revisions;
    QLabel* m_difference;
    QLineEdit* m_reason;
    QLabel* m_message;
    Keypad* m_keypad;
    QPushButton* m_cancel;
    ActionButton* m_restore;
    ActionButton* m_save;
    QHBoxLayout* m_columns;
    QVBoxLayout* m_side;
    std::vector<BoringRecipeView> m_known;
    QString m_trouble{};
    bool m_pending{false};
    std::optional<BoringRecipeForm> m_sent{};  ///< what the fields held when the answer began to be awaited
    QString m_sentReason{};
};

}  // namespace kerf::ui
