// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "ui/charts/chart.h"
#include "ui/dialogs/sheet.h"
#include "ui/services/milling_service.h"
#include "ui/widgets/action_button.h"
#include "ui/widgets/keypad.h"
#include "ui/widgets/value_field.h"

namespace kerf::ui {

/// The blank profile of a part type: typed step by step, or imported from a CSV file.
///
/// Object names: millingBlankChart, millingBlankBegin, millingBlankHeight, millingBlankEnd (ValueFields),
/// millingBlankAdd, millingBlankRemove, millingBlankFile, millingBlankImport, millingBlankMessage, millingBlankCancel,
/// millingBlankUse
class MillingBlankForm : public FaceWidget {
    Q_OBJECT
 public:
    using Author = std::function<std::string()>;
    static MillingBlankForm* open(SheetHost& host, Look& look, MillingService& service, Author author,
                                  const QString& file);

 protected:
    void refresh() override;
    bool eventFilter(QObject* watched, QEvent* event) override;

 private:
    MillingBlankForm(Look& look, MillingService& service, Author author, const QString& file, Sheet* sheet);
    void build();
    void addStep();
    void removeStep();
    void importFile();
    void use();
    void showProfile();
    void take(const MillingBlank& blank);
    [[nodiscard]] QString whyNotUse() const;

    MillingService& m_service;
    Author m_author;
    Sheet* m_sheet;
    Chart* m_chart;
    Chart::CurveId m_outline;
    ValueField* m_begin;
    ValueField* m_height;
    ValueField* m_end;
    ActionButton* m_add;
    ActionButton* m_remove;
    QLineEdit* m_file;
    ActionButton* m_import;
    QLabel* m_message;
    Keypad* m_keypad;
    QPushButton* m_cancel;
    ActionButton* m_use;
    QHBoxLayout* m_columns;
    QHBoxLayout* m_fieldRow;
    QHBoxLayout* m_stepRow;
    QHBoxLayout* m_fileRow;
    std::vector<MillingBlankStep> m_steps;
    std::string m_source;
};

}  // namespace kerf::ui
