// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ui/charts/chart.h"
#include "ui/services/turning_service.h"

namespace kerf::ui {

/// Amplitude over frequency of the predicted surface, with and without the trim; the tones named above their peaks, one
/// that the force cannot see marked with a diamond and the word.
class SpectrumChart : public Chart {
    Q_OBJECT
 public:
    explicit SpectrumChart(Look& look, QWidget* parent = nullptr);

    void setSpectrum(const TurningSpectrum& spectrum);
    void setTones(std::vector<TurningTone> tones);
    [[nodiscard]] const std::vector<TurningTone>& tones() const { return m_tones; }
    /// Texts in the present language.
    void retranslate();
    /// What the axes mean, for the title of the card: the chart is low and has no titles of its own.
    [[nodiscard]] QString axesText() const;
    /// What stands above a tone (tests).
    [[nodiscard]] QString toneLabel(const TurningTone& tone) const;

 protected:
    void paintLines(QPainter& painter, const QRectF& plot) const override;

 private:
    void fitRanges();

    CurveId m_untreated;
    CurveId m_treated;
    TurningSpectrum m_spectrum;
    std::vector<TurningTone> m_tones;
};

}  // namespace kerf::ui
