// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <vector>

#include "ui/charts/histogram_chart.h"
#include "ui/shell/page.h"
#include "ui/widgets/action_button.h"
#include "ui/widgets/card.h"

namespace kerf::ui {

/// How the engine keeps time, what the screen lost, and which versions run.
class DiagnosticsPage : public Page {
    Q_OBJECT
 public:
    explicit DiagnosticsPage(const PageContext& context, QWidget* parent = nullptr);

 protected:
    void refresh() override;

 private:
    struct Fact {
        QLabel* name;
        QLabel* value;
    };
    Fact addFact(Card* card, const char* objectName);
    void askBackup();
    void startBackup(const QString& file);
    void onStatus(const Status& status);
    void update(const Status& status);

    Card* m_costCard;
    Card* m_lateCard;
    HistogramChart* m_cost;
    HistogramChart* m_late;
    Card* m_engine;
    Card* m_link;
    Fact m_period{};
    Fact m_cycles{};
    Fact m_overruns{};
    Fact m_dropped{};
    Fact m_speed{};
    QLabel* m_scheduling;
    ActionButton* m_backup;
    ActionButton* m_restore;
    bool m_backingUp{false};
    Fact m_machine{};
    Fact m_state{};
    Fact m_clock{};
    Fact m_versions{};
    Fact m_shop{};
    QElapsedTimer m_since;
};

}  // namespace kerf::ui
