// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/services/thermal_service.h"
#include "ui/widgets/face_widget.h"

namespace kerf::ui {

/// Error of the cutting point over X and Y of the work space for one axis: darker is larger, figures at the corners and
/// in the middle with their sign.
class ErrorMap : public FaceWidget {
    Q_OBJECT
 public:
    ErrorMap(Look& look, std::size_t axis, QWidget* parent = nullptr);

    /// @param scale_um what is darkest, the same for all axes
    void setMap(const ThermalErrorMap& map, double scale_um);
    [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
    void paintEvent(QPaintEvent* event) override;

 private:
    std::size_t m_axis;
    ThermalErrorMap m_map;
    double m_scale_um{1.0};
};

[[nodiscard]] double largestError_um(const ThermalErrorMap& map);

}  // namespace kerf::ui
