// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
#include <vector>

#include "engine/api/status.h"
#include "ui/shell/page.h"

namespace kerf::ui {

/// One row of the navigation: word, and for a loop its lamp and state.
class NavigationItem : public QAbstractButton {
    Q_OBJECT
 public:
    NavigationItem(Look& look, const PageEntry& entry, QWidget* parent = nullptr);

    void setLoop(const LoopStatus& loop);
    /// A number behind the word (unacknowledged alarms); 0 hides it.
    void setCount(int count);
    void retitle();
    [[nodiscard]] QSize sizeHint() const override;

 protected:
    void paintEvent(QPaintEvent* event) override;

 private:
    Look& m_look;
    const PageEntry& m_entry;
    std::optional<std::pair<LoopState, bool>> m_loop;  ///< state, fitted
    int m_count{0};
};

/// The column at the left.
class Navigation : public FaceWidget {
    Q_OBJECT
 public:
    Navigation(Look& look, const PageList& pages, QWidget* parent = nullptr);

    void setStatus(const Status& status);
    void setAlarmCount(int count);
    void setCurrent(std::size_t index);

 signals:
    void chosen(std::size_t index);

 protected:
    void refresh() override;

 private:
    const PageList& m_pages;
    std::vector<NavigationItem*> m_items;
};

}  // namespace kerf::ui
