// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ui/services/tapping_service.h"
#include "ui/widgets/face_widget.h"

namespace kerf::ui {

/// One figure per trial as bars with their values, the thread's tolerance as a line. Without trials: before and after
/// of the stored tuning.
class TrialBars : public FaceWidget {
    Q_OBJECT
 public:
    enum class Figure { Saec, EngagedPp };
    TrialBars(Look& look, Figure figure, QWidget* parent = nullptr);

    void setView(const TappingServiceView& view);
    /// As drawn (tests).
    [[nodiscard]] QStringList values() const;
    [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
    void paintEvent(QPaintEvent* event) override;
    void refresh() override;

 private:
    struct Bar {
        double value{0.0};
        QString name{};
        bool counted{true};
        bool kept{false};
    };
    [[nodiscard]] const char* unit() const { return m_figure == Figure::Saec ? "mm" : "um"; }
    [[nodiscard]] QString text(const Bar& bar) const;
    void rebuild();

    Figure m_figure;
    TappingServiceView m_view{};
    std::vector<Bar> m_bars;
};

}  // namespace kerf::ui
