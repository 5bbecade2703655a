// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/services/quality_service.h"
#include "ui/shell/page.h"

namespace kerf::ui {

/// Reports and files of a lot, and the limits of figures, as sheets over the page.
///
/// Object names: fileName, fileLotReport, fileFirstArticle, fileDfq; dfqFolder, dfqPattern, dfqSave, dfqWhy;
/// those of the limits are ui/dialogs/limits_sheet.h's
class QualitySheets : public QObject {
    Q_OBJECT
 public:
    QualitySheets(const PageContext& context, QualityService& service, QObject* parent);

    /// @pre service.shown() != nullptr
    void openFiles();
    void openAutomaticFiles();
    void openLimits(ProcessId process);
    /// Which rules of the charts are switched on.
    void openRules();

 private:
    void tell(const QString& file, const Result<void>& written);

    PageContext m_context;
    QualityService& m_service;
};

}  // namespace kerf::ui
