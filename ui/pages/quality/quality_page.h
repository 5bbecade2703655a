// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "ui/pages/quality/gauge_sheet.h"
#include "ui/pages/quality/quality_panels.h"
#include "ui/pages/quality/quality_sheets.h"
#include "ui/services/boring_service.h"
#include "ui/shell/page.h"
#include "ui/widgets/action_button.h"
#include "ui/widgets/card.h"

class QComboBox;
class QHBoxLayout;
class QGridLayout;

namespace kerf::ui {

/// Is the process in control, and how do the parts lie in their tolerance: one sentence, four charts, both indices, and
/// the parts that want a decision.
///
/// Object names: qualityPage, qualityLot, qualityCharacteristic, qualitySentence, qualityCounts, qualityIndices,
/// qualityResiduals, qualityRaw, qualityAction, qualitySpread, qualityDecide, qualityGauges, qualityFiles,
/// qualityLimits, qualityRules, qualityGaugeNote, qualityGroup, qualityOlder, qualityNewer; sheet of qualityDecide:
/// decideReworked, decideScrapped, decideAccepted; sheet of qualityRules: rule_nelson1 …, rulesDefault, rulesSave
class QualityPage : public Page {
    Q_OBJECT
 public:
    explicit QualityPage(const PageContext& context, QWidget* parent = nullptr);
    ~QualityPage() override;

 protected:
    void refresh() override;
    void showEvent(QShowEvent* event) override;

 private:
    void build();
    void listLots();
    void showLot();
    void showCharacteristic();
    void listGroups(const LotQuality& lot);
    void turnPage(bool older);
    [[nodiscard]] PartWindow window() const;
    [[nodiscard]] LotId chosenLot() const;
    void decide();
    [[nodiscard]] const LotPart* undecided() const;
    [[nodiscard]] QString whyNoFile() const;

    QualityService* m_service;
    std::unique_ptr<Subscription> m_bores{};
    GaugeSheets* m_gaugeSheets{nullptr};
    QualitySheets* m_sheets{nullptr};
    QLabel* m_missing{nullptr};
    QHBoxLayout* m_tools{nullptr};
    QHBoxLayout* m_pages{nullptr};
    QGridLayout* m_grid{nullptr};
    QComboBox* m_lots{nullptr};
    QComboBox* m_characteristics{nullptr};
    QComboBox* m_groups{nullptr};
    ActionButton* m_older{nullptr};
    ActionButton* m_newer{nullptr};
    PartId m_last{0};  ///< last part on the charts; 0: the newest
    QLabel* m_sentence{nullptr};
    QLabel* m_counts{nullptr};
    QLabel* m_indices{nullptr};
    QLabel* m_gaugeNote{nullptr};
    ActionButton* m_decide{nullptr};
    QPushButton* m_gauges{nullptr};
    ActionButton* m_files{nullptr};
    ActionButton* m_limits{nullptr};
    QPushButton* m_rules{nullptr};
    Card* m_residualCard{nullptr};
    Card* m_rawCard{nullptr};
    Card* m_actionCard{nullptr};
    Card* m_spreadCard{nullptr};
    ResidualChart* m_residuals{nullptr};
    RawChart* m_raw{nullptr};
    ActionChart* m_action{nullptr};
    SpreadChart* m_spread{nullptr};
};

}  // namespace kerf::ui
