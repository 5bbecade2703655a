// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "app/console/sensors.h"
#include "app/sensors/finger.h"
#include "app/service/rights.h"
#include "db/api/room_records.h"
#include "db/api/store_writer.h"
#include "ui/services/sensor_service.h"

namespace kerf::console {

/// The sensors' setup on the database: where channels sit on the picture is a room record of the thermal process.
class StoredSensorService final : public SensorService {
 public:
    /// `reader` is used here only; the other references outlive the service. `folder` is looked through for a PNG.
    StoredSensorService(ConsoleSensors& sensors, StoreWriter& writer, RoomRecordReader& reader, std::string folder,
                        Rights rights = {});

    [[nodiscard]] const SensorServiceView& view() const override { return m_view; }
    void lookForFinger(bool on) override;
    void askGauge(std::size_t gauge, bool test) override;
    [[nodiscard]] Result<void> place(std::size_t channel, double x, double y, const std::string& author) override;
    /// On a timer of the GUI thread; `view().revision` rises when there is something new.
    void poll();
    /// The next reading for the pages that take diameters; test reads and what is no reading stay here.
    [[nodiscard]] std::optional<ConsoleSensors::GaugeFrame> nextReading();

 private:
    void takeFrame();
    void hearGauges();
    void findPicture();

    ConsoleSensors& m_sensors;
    StoreWriter& m_writer;
    Rights m_rights;
    SensorServiceView m_view{};
    sensors::FingerFinder m_finder{};
    std::vector<std::int64_t> m_testUntil_ns{};  ///< of each gauge: what comes until then is a test read
    std::deque<ConsoleSensors::GaugeFrame> m_readings{};
    sensors::SensorFrame m_frame{};
    std::shared_ptr<bool> m_alive{std::make_shared<bool>(true)};
};

}  // namespace kerf::console
