// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "engine/api/status.h"
#include "ui/services/thermal_service.h"
#include "ui/widgets/face_widget.h"

namespace kerf::ui {

/// The machine from the side with its thermocouples as points: filled ones are the model's, a sick one has the alarm's
/// shape and colour and its name. Touch one to read it.
class MachineDrawing : public FaceWidget {
    Q_OBJECT
 public:
    explicit MachineDrawing(Look& look, QWidget* parent = nullptr);

    void setSensors(const std::vector<ThermalSensorView>& sensors);
    void setStatus(const ThermalStatus& status);
    void select(std::optional<std::size_t> sensor);
    [[nodiscard]] QSize minimumSizeHint() const override;
    /// Where a sensor is drawn (tests).
    [[nodiscard]] QPointF place(std::size_t sensor) const;

 signals:
    void sensorTouched(std::size_t sensor);

 protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;

 private:
    [[nodiscard]] QRectF area() const;
    void paintMachine(QPainter& painter) const;

    std::vector<ThermalSensorView> m_sensors;
    std::array<CoupleState, kMaxTemperatures> m_states{};
    std::uint64_t m_inModel{0};
    std::optional<std::size_t> m_selected;
};

}  // namespace kerf::ui
