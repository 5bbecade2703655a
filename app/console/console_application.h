// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>
#include <string>
#include <vector>

#include "app/console/background.h"
#include "app/console/live_publisher.h"
#include "app/console/loop_modes.h"
#include "app/console/options.h"
#include "app/console/quality_desk.h"
#include "app/console/rooms/boring_room.h"
#include "app/console/rooms/room.h"
#include "app/console/sensor_choice.h"
#include "app/console/sensor_service.h"
#include "app/console/sensors.h"
#include "app/console/shift_desk.h"
#include "app/console/shop_link.h"
#include "app/console/simulated_shift.h"
#include "app/console/simulator.h"
#include "app/console/stop_keeper.h"
#include "app/service/data/data_keeper.h"
#include "app/service/engine_gate.h"
#include "app/service/rights.h"
#include "db/data_file.h"
#include "db/readers/database_reader.h"
#include "db/writer_thread.h"
#include "engine/cycle/engine.h"
#include "engine/machine/described_machine.h"
#include "ui/shell/main_window.h"
#include "ui/theme/look.h"

namespace kerf::console {

/// Builds the console's parts, joins them, and takes them down in the right order. Everything here is on the GUI
/// thread; the engine and the database writer have their own.
class ConsoleApplication : public QObject {
    Q_OBJECT
 public:
    /// Who acts where nobody has signed on.
    static constexpr const char* kAuthor = "Kerf";

    explicit ConsoleApplication(Options options, std::vector<std::unique_ptr<Room>> rooms = standardRooms());
    /// Stops the engine, then waits until everything that has been made is on the disk.
    ~ConsoleApplication() override;

    /// Opens data and machine; then ready() or failed() follows from the event loop. The sentence says why it cannot
    /// even begin (data folder, database, machine).
    [[nodiscard]] Result<void> start();

    /// Null before ready().
    [[nodiscard]] ui::MainWindow* window() const noexcept { return m_window.get(); }
    [[nodiscard]] Engine& engine() noexcept { return *m_engine; }
    /// @pre the machine bores
    [[nodiscard]] StoredBoringService& boringService() noexcept { return boringLots().service().stored(); }
    /// @pre the machine bores
    [[nodiscard]] StoredBoringLots& boringLots() noexcept { return boring()->lots(); }
    [[nodiscard]] MachinePort& machine() noexcept { return *m_machine; }
    /// Null with a real machine.
    [[nodiscard]] Simulator* simulator() const noexcept { return m_simulator.get(); }
    [[nodiscard]] SimulatedShift* shift() const noexcept { return m_shift.get(); }
    /// Null: not on this machine.
    [[nodiscard]] Room* room(ProcessId process) const noexcept;
    [[nodiscard]] ui::Look& look() noexcept { return *m_look; }
    /// What the pages work with.
    [[nodiscard]] ui::Services services();
    [[nodiscard]] const std::string& databasePath() const noexcept { return m_databasePath; }

 signals:
    void ready();
    void failed(const QString& sentence);
    /// A measurement is accepted: on the disk, in the estimate, and its schedule on the way to the engine.
    void accepted(const QString& line);

 private:
    [[nodiscard]] Result<void> openData();
    [[nodiscard]] Result<void> openMachine();
    [[nodiscard]] Result<void> openRecordedDay();
    [[nodiscard]] Result<void> joinSensors();
    void makeEngine();
    void openRooms();
    void openSensors();
    [[nodiscard]] std::string sensorFolder() const;
    [[nodiscard]] std::string chosenSensorFile() const;
    void waitForRoom(std::size_t next);
    /// Null where nothing is bored.
    [[nodiscard]] BoringRoom* boring() const noexcept;
    void openWindow();
    void readyOnceKnown(int looks);
    void poll();
    void lookAtPort();
    [[nodiscard]] std::string author() const;
    void keepAlarm(const AlarmEvent& event);
    /// What the services ask before they change anything.
    [[nodiscard]] Rights rights();
    /// A line in the audit log for what is no row of a table.
    void audit(const std::string& who, const std::string& action, const char* object, const std::string& reason);
    void wrapOldSeals();
    [[nodiscard]] std::vector<Sentence> startFindings() const;
    void serveFiles(ui::Services& services);
    void serveShift(ui::Services& services);
    void acknowledgeAlarm(AlarmCode code, const QString& author);
    void saveSetting(const std::string& key, const std::string& value, const std::string& reason = {});

    Options m_options;
    std::string m_databasePath;
    std::unique_ptr<db::DataFile> m_dataFile;
    std::unique_ptr<db::DatabaseReader> m_reader;
    std::vector<std::unique_ptr<Room>> m_rooms;  ///< those that fit the machine
    ui::PageList m_pages;                        ///< of all processes, in their order
    std::unique_ptr<Simulator> m_simulator;
    std::unique_ptr<MachinePort> m_realMachine;
    std::unique_ptr<DescribedMachine> m_described;         ///< null without a machine file
    std::vector<std::string> m_recordedSensors;            ///< of a recorded day
    std::unique_ptr<StoredSensorService> m_sensorService;  ///< null without a sensor file
    std::unique_ptr<ConsoleSensors> m_sensors;             ///< null without a sensor file
    std::unique_ptr<SensorChoice> m_sensorChoice;          ///< which sensor file the next start reads
    std::string m_notRead;                                 ///< sensor file that was chosen but could not be used
    MachinePort* m_machine{nullptr};
    std::unique_ptr<Engine> m_engine;
    std::unique_ptr<DataKeeper> m_keeper;
    std::unique_ptr<EngineGate> m_gate;  ///< the engine as the pages see it
    std::unique_ptr<db::WriterThread> m_writer;
    std::unique_ptr<QualityDesk> m_quality;
    std::unique_ptr<ShiftDesk> m_shiftDesk;
    std::unique_ptr<StopKeeper> m_stops;
    std::unique_ptr<LoopModes> m_modes;
    std::unique_ptr<LivePublisher> m_live;  ///< for gateways
    std::unique_ptr<ShopLink> m_shop;
    QTimer m_poll;
    QTimer m_portLook;
    bool m_portOpen{false};
    std::unique_ptr<ui::Look> m_look;
    ui::Preferences m_savedPreferences{};
    ui::SignOnSettings m_savedSignOn{};
    std::unique_ptr<ui::MainWindow> m_window;
    std::unique_ptr<SimulatedShift> m_shift;
    Background m_background;
};

}  // namespace kerf::console
