// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "engine/api/status.h"
#include "ui/widgets/card.h"
#include "ui/widgets/sparkline.h"

class QGridLayout;
class QLabel;

namespace kerf::ui {

/// The identified cutting process: a1, b0, b1 with their 95 % intervals beside what the law is tuned to, how much the
/// cut excites the identification, and the course of the covariance's trace.
class ProcessPanel : public Card {
    Q_OBJECT
 public:
    explicit ProcessPanel(Look& look, QWidget* parent = nullptr);
    void setStatus(const Status& status);

 private:
    void retranslate() override;
    void show(const TurningStatus& turning);
    [[nodiscard]] QString excitationText(const TurningIdentification& found) const;

    Look& m_look;
    QGridLayout* m_grid;
    QLabel* m_foundTitle;
    QLabel* m_lawTitle;
    std::array<QLabel*, 3> m_names{};
    std::array<QLabel*, 3> m_found{};
    std::array<QLabel*, 3> m_law{};
    QLabel* m_excitation;
    QLabel* m_traceName;
    Sparkline* m_trace;
    QLabel* m_note;
    TurningStatus m_last{};
    std::int64_t m_shown_ns{-1};
};

}  // namespace kerf::ui
