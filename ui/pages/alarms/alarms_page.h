// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableView>

#include "ui/models/alarm_model.h"
#include "ui/shell/page.h"
#include "ui/widgets/action_button.h"
#include "ui/widgets/card.h"

namespace kerf::ui {

/// Standing and unseen alarms, or the history over restarts; for the chosen one cause, consequence and action.
class AlarmsPage : public Page {
    Q_OBJECT
 public:
    explicit AlarmsPage(const PageContext& context, QWidget* parent = nullptr);

    void showHistory(bool history);

 protected:
    void refresh() override;
    void showEvent(QShowEvent* event) override;

 private:
    void reload();
    void loadMore();
    void showDetail();
    void selectFirstUnseen();
    void askExport();
    [[nodiscard]] Result<void> writeHistory(const QString& file) const;
    [[nodiscard]] bool wanted(const AlarmLine& line) const { return line.priority <= m_lowest; }
    [[nodiscard]] QString whyNoAcknowledge() const;
    [[nodiscard]] const AlarmLine* chosen() const;

    static constexpr std::uint32_t kHistoryPage = 100;

    AlarmModel m_model;
    QPushButton* m_nowButton;
    QPushButton* m_historyButton;
    QTableView* m_table;
    QLabel* m_empty;
    Card* m_detail;
    QLabel* m_title;
    struct Part {
        QLabel* name;
        QLabel* text;
    };
    Part m_cause{};
    Part m_consequence{};
    Part m_action{};
    ActionButton* m_acknowledge;
    ActionButton* m_more;
    QPushButton* m_filter;
    QPushButton* m_export;
    int m_lowest{3};  ///< priority down to which the history is shown
    std::vector<AlarmLine> m_history;
    std::optional<AlarmId> m_oldest;
    bool m_complete{false};
    bool m_showHistory{false};
    QString m_problem;
};

}  // namespace kerf::ui
