// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/api/status.h"
#include "ui/pages/turning/spectrum_chart.h"
#include "ui/services/turning_service.h"
#include "ui/widgets/action_button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/number_display.h"

namespace kerf::ui {

class ClampLabel;

/// Predicted surface: RMS and P-V with what they would be without the trim, spectrum with the tones named, and the
/// blind tones with a better spindle speed.
class SurfacePanel : public Card {
    Q_OBJECT
 public:
    explicit SurfacePanel(Look& look, QWidget* parent = nullptr);

    void setView(const TurningServiceView& view);
    void setStatus(const Status& status);
    [[nodiscard]] SpectrumChart* spectrum() const { return m_spectrum; }

 signals:
    /// The operator wants the suggested spindle speed for the next part.
    void speedWanted(double speed_rpm);

 private:
    void retranslate() override;
    void showBlind();
    [[nodiscard]] QString blindText() const;

    Look& m_look;
    NumberDisplay* m_rms;
    NumberDisplay* m_pv;
    NumberDisplay* m_without;
    SpectrumChart* m_spectrum;
    QLabel* m_axes;
    ClampLabel* m_blind;
    ActionButton* m_useSpeed;
    QHBoxLayout* m_columns;
    QVBoxLayout* m_numbers;
    QHBoxLayout* m_blindRow;
    TurningBlindView m_blindView{};
    std::uint64_t m_revision{0};
    std::vector<TurningTone> m_archived{};
    bool m_live{false};
    bool m_partShown{false};
};

}  // namespace kerf::ui
