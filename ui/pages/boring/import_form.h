// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>

#include "ui/services/boring_service.h"
#include "ui/shell/page.h"
#include "ui/widgets/action_button.h"

class QLineEdit;

namespace kerf::ui {

/// Diameters from a file into the open lot: choose it by touch, see what taking it over would do, confirm. The gate
/// asks of each value what it asks of a typed one; while one row is refused nothing is taken.
///
/// Object names: importFile0 … (files that are there, newest first), importPath, importPlan; buttons importCancel,
/// importLook, importTake.
class ImportForm : public FaceWidget {
    Q_OBJECT
 public:
    /// @pre context.services.boringService and readBores are there
    static ImportForm* open(const PageContext& context);

 protected:
    void refresh() override;

 private:
    ImportForm(const PageContext& context, Sheet* sheet);
    void listFiles();
    void lookInto();
    void found(const ReadBores& read);
    void take();
    void answered(const Result<void>& result);
    [[nodiscard]] QString planText() const;
    [[nodiscard]] QString whyNoTake() const;

    PageContext m_context;
    BoringService& m_service;
    QPointer<Sheet> m_sheet;
    QLineEdit* m_path;
    QLabel* m_plan;
    ActionButton* m_look;
    ActionButton* m_take;
    std::vector<QPushButton*> m_files{};
    std::optional<ReadBores> m_read{};
    BoreImportPlan m_would{};
    Sentence m_refusal{};
    bool m_busy{false};
};

}  // namespace kerf::ui
