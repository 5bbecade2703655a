// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QGridLayout>
#include <vector>

#include "ui/charts/live_plot.h"
#include "ui/shell/page.h"
#include "ui/widgets/action_button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/lamp.h"
#include "ui/widgets/number_display.h"
#include "ui/widgets/sparkline.h"

namespace kerf::ui {

/// One loop on Overview: lamp, one sentence, the number that matters, its recent course. A touch opens the loop's page.
class LoopCard : public Card {
    Q_OBJECT
 public:
    LoopCard(Look& look, const PageEntry& entry, QWidget* parent = nullptr);

    void show(const LoopStatus& loop, const KeyFigure& figure);
    void sample(const KeyFigure& figure);
    void retitle();

 signals:
    void opened();

 protected:
    void mouseReleaseEvent(QMouseEvent* event) override;

 private:
    Look& m_look;
    PageEntry m_entry;
    Lamp* m_lamp;
    QLabel* m_reason;
    QVBoxLayout* m_place;
    NumberDisplay* m_number{nullptr};
    KeyFigure m_kind;
    Sparkline* m_course;
};

/// State of every loop at a glance, live feed and position, part counter.
class OverviewPage : public Page {
    Q_OBJECT
 public:
    explicit OverviewPage(const PageContext& context, QWidget* parent = nullptr);

 protected:
    void refresh() override;

 private:
    void buildMachine();
    void onStatus(const Status& status);
    /// Whether what is stored here has reached the shop; nothing where none is wanted.
    void showShop();
    /// Cards of the fitted loops in two rows, the machine's beside them; nothing stands for what is not there.
    void arrange(const Status& status);
    /// What this machine is there for: the first loop that is fitted.
    [[nodiscard]] ProcessId mainProcess() const;
    [[nodiscard]] QString whyNoStart() const;
    [[nodiscard]] QString whyNoRelease() const;
    [[nodiscard]] std::optional<ProcessId> stopped() const;
    [[nodiscard]] QString stopText(const StopStatus& stop) const;
    void release();
    [[nodiscard]] QString machineSentence() const;

    PageList m_entries;  ///< of the processes; one card each
    std::vector<LoopCard*> m_cards;
    std::vector<bool> m_arranged;  ///< which are fitted, as arranged
    QGridLayout* m_grid;
    Card* m_machine;
    Lamp* m_machineLamp;
    QLabel* m_sentence;
    QLabel* m_shop;
    NumberDisplay* m_feed;
    Sparkline* m_feedCourse;
    std::vector<NumberDisplay*> m_position;
    NumberDisplay* m_parts;
    ActionButton* m_start;
    ActionButton* m_release;
    QElapsedTimer m_sinceSample;
};

}  // namespace kerf::ui
