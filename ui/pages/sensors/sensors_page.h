// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QTableWidget>
#include <optional>

#include "ui/pages/sensors/sensor_picture.h"
#include "ui/pages/sensors/sensor_setup_panel.h"
#include "ui/services/sensor_service.h"
#include "ui/shell/page.h"
#include "ui/widgets/action_button.h"
#include "ui/widgets/card.h"

namespace kerf::ui {

/// Sensors and gauges of this machine: what is found, what it reads, where it sits. For the process engineer.
class SensorsPage : public Page {
    Q_OBJECT
 public:
    explicit SensorsPage(const PageContext& context, QWidget* parent = nullptr);

 protected:
    void refresh() override;

 private:
    void build();
    void onStatus();
    void show(const SensorServiceView& view);
    void showChannels(const SensorServiceView& view);
    void showModules(const SensorServiceView& view);
    void showFinger(const SensorServiceView& view);
    void choose(std::optional<std::size_t> channel);
    void placeAt(double x, double y);

    SensorService* m_service;
    QLabel* m_missing{nullptr};
    SensorSetupPanel* m_panel{nullptr};  ///< where there is no sensor file
    Card* m_list{nullptr};
    Card* m_side{nullptr};
    QTableWidget* m_channels{nullptr};
    QTableWidget* m_modules{nullptr};
    SensorPicture* m_picture{nullptr};
    QLabel* m_hint{nullptr};
    ActionButton* m_finger{nullptr};
    ActionButton* m_place{nullptr};
    ActionButton* m_ask{nullptr};
    ActionButton* m_setup{nullptr};
    std::optional<std::size_t> m_chosen{};
    bool m_placing{false};
    QElapsedTimer m_since;
    std::uint64_t m_shown{0};
};

}  // namespace kerf::ui
