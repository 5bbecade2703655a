// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableView>
#include <QTimer>
#include <memory>

#include "ui/models/parts_model.h"
#include "ui/pages/parts/part_detail_panel.h"
#include "ui/pages/parts/part_export.h"
#include "ui/services/boring_service.h"
#include "ui/shell/page.h"

class QComboBox;
class QLineEdit;

namespace kerf::ui {

/// Every part of every process: search, look, correct, export.
///
/// Object names, stable for tests:
///   partsPage, partsSearch, partsThisLot, partsBad (switches), partsProcess, partsExport, partsCount, partsTable
///   partDetail: partFacts, partFeedChart, partMeasurements (one row per accepted row), partCorrect, partVoid,
///     partSerial, partReport
///   sheet of partSerial: serialNumber, serialSave; of partReport: reportFile, reportPdf, reportCsv, reportClose
///   sheet of partsExport: exportFile, exportParts, exportMeasurements, exportFeed, exportClose
///   sheet of correct / take out: see MeasurementForm
class PartsPage : public Page {
    Q_OBJECT
 public:
    explicit PartsPage(const PageContext& context, QWidget* parent = nullptr);
    ~PartsPage() override;

 protected:
    void refresh() override;
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

 private:
    void build();
    void search();
    void update();
    void afterReading();
    void fitColumns();
    void askSerial();
    void openReport();
    void writeReport(PartId part, const QString& file);
    void showCount();
    void choose(PartId id);
    void openForm(const MeasurementRow& row, bool takeOut);
    void openExport();
    [[nodiscard]] QString whyNoExport() const;

    PartReader* m_reader;
    BoringService* m_service;
    std::unique_ptr<Subscription> m_subscription;
    QLabel* m_missing{nullptr};
    QLineEdit* m_search{nullptr};
    QComboBox* m_process{nullptr};
    QPushButton* m_thisLot{nullptr};
    QPushButton* m_bad{nullptr};
    ActionButton* m_export{nullptr};
    QLabel* m_count{nullptr};
    QTableView* m_table{nullptr};
    PartsModel* m_model{nullptr};
    PartDetailPanel* m_detail{nullptr};
    PartExport* m_exporter{nullptr};
    QHBoxLayout* m_columns{nullptr};
    QHBoxLayout* m_tools{nullptr};
    QTimer m_typing;
    std::optional<PartId> m_chosen;
    Sentence m_problem{};
    bool m_searched{false};
    bool m_behind{true};
};

}  // namespace kerf::ui
