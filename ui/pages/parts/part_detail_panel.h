// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableWidget>
#include <optional>

#include "db/api/rows.h"
#include "ui/charts/chart.h"
#include "ui/services/quality_service.h"
#include "ui/widgets/action_button.h"
#include "ui/widgets/card.h"

namespace kerf::ui {

/// One part: schedule against the feed really cut, and every measurement with what became of it.
class PartDetailPanel : public Card {
    Q_OBJECT
 public:
    PartDetailPanel(Look& look, std::function<QString()> whyNoChange, QWidget* parent = nullptr);

    void show(const std::optional<PartDetail>& part);
    /// Instead of a part: why it could not be read.
    void showProblem(const Sentence& problem);
    /// Who says whether a part is in its tolerance.
    void setJudge(std::function<PartJudgement(const PartRow&)> judge) { m_judge = std::move(judge); }
    void retranslate() override;
    /// Whether serial numbers and reports can be made here.
    void setFileActions(bool serial, bool report);
    [[nodiscard]] const std::optional<PartDetail>& part() const { return m_part; }

 signals:
    void correctRequested(const kerf::MeasurementRow& row);
    void voidRequested(const kerf::MeasurementRow& row);
    void serialRequested();
    void reportRequested();

 private:
    void showPart();
    void showHistory();
    [[nodiscard]] const MeasurementRow* chosen() const;
    [[nodiscard]] QString whyNot() const;

    Look& m_look;
    std::function<QString()> m_whyNoChange;
    std::function<PartJudgement(const PartRow&)> m_judge{};
    PartJudgement m_judgement{};
    QLabel* m_facts;
    QLabel* m_feedTitle;
    Chart* m_chart;
    Chart::CurveId m_schedule;
    Chart::CurveId m_cut;
    QTableWidget* m_history;
    ActionButton* m_correct;
    ActionButton* m_void;
    ActionButton* m_serial;
    ActionButton* m_report;
    QHBoxLayout* m_buttons;
    bool m_canSerial{false};
    bool m_canReport{false};
    std::optional<PartDetail> m_part;
    Sentence m_problem{};
};

}  // namespace kerf::ui
