// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "ui/services/turning_service.h"
#include "ui/widgets/action_button.h"
#include "ui/widgets/card.h"

class QGridLayout;
class QLabel;

namespace kerf::ui {

/// The newest part under the loop beside the newest one without it, cut with the same setup under the same disturbance.
class ComparisonPanel : public Card {
    Q_OBJECT
 public:
    explicit ComparisonPanel(Look& look, QWidget* parent = nullptr);
    void setView(const TurningServiceView& view);

 signals:
    void archiveWanted();

 private:
    static constexpr std::size_t kRows = 3;
    static constexpr std::size_t kColumns = 4;
    void retranslate() override;
    void show();

    Look& m_look;
    QGridLayout* m_grid;
    QWidget* m_table;
    std::array<std::array<QLabel*, kColumns>, kRows + 1> m_cells{};
    QLabel* m_empty;
    ActionButton* m_archive;
    std::optional<TurningComparison> m_comparison{};
    std::size_t m_parts{0};
};

}  // namespace kerf::ui
