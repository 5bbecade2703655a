// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/api/status.h"
#include "ui/services/turning_service.h"
#include "ui/widgets/card.h"
#include "ui/widgets/number_display.h"

class QGridLayout;

namespace kerf::ui {

/// The trim between the two ends of its authority.
class TrimBar : public FaceWidget {
    Q_OBJECT
 public:
    explicit TrimBar(Look& look, QWidget* parent = nullptr);
    void set(double trim_um, double authority_um);
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
    void paintEvent(QPaintEvent* event) override;

 private:
    double m_trim_um{0.0};
    double m_authority_um{0.0};
};

/// Margins of the loop, guaranteed over the identified process, and the trim with its authority.
class MarginPanel : public Card {
    Q_OBJECT
 public:
    explicit MarginPanel(Look& look, QWidget* parent = nullptr);
    void setView(const TurningServiceView& view);
    void setStatus(const Status& status);

 private:
    void retranslate() override;
    void showMargins();

    Look& m_look;
    QGridLayout* m_grid;
    NumberDisplay* m_gain;
    NumberDisplay* m_phase;
    NumberDisplay* m_delay;
    NumberDisplay* m_modulus;
    QLabel* m_note;
    QLabel* m_trim;
    TrimBar* m_bar;
    TurningMargins m_margins{};
    double m_authority_um{0.0};
    double m_applied_um{0.0};
    std::int64_t m_shown_ns{-1};
};

}  // namespace kerf::ui
