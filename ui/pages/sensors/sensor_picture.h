// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPixmap>
#include <optional>
#include <vector>

#include "ui/services/sensor_service.h"
#include "ui/widgets/face_widget.h"

namespace kerf::ui {

/// A picture of one's own machine with its channels as points: filled when they read, a ring when not. Touching it says
/// where, 0…1 from the left and from the top.
class SensorPicture : public FaceWidget {
    Q_OBJECT
 public:
    explicit SensorPicture(Look& look, QWidget* parent = nullptr);

    /// PNG; empty or unreadable: a frame alone.
    void setPicture(const QString& file);
    void setChannels(const std::vector<SensorChannelView>& channels);
    void select(std::optional<std::size_t> channel);
    [[nodiscard]] QSize minimumSizeHint() const override;

 signals:
    void touched(double x, double y);

 protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;

 private:
    [[nodiscard]] QRectF area() const;

    QString m_file;
    QPixmap m_picture;
    std::vector<SensorChannelView> m_channels;
    std::optional<std::size_t> m_selected;
};

}  // namespace kerf::ui
