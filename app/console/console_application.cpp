// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/console_application.h"

#include <spdlog/spdlog.h>

#include <QDir>
#include <QStandardPaths>
#include <algorithm>

#include "app/console/logging.h"
#include "app/console/preferences.h"
#include "db/migrator.h"
#include "engine/boring/boring_loop.h"
#include "engine/machine/linuxcnc/linuxcnc_machine.h"
#include "ui/link/texts.h"

namespace kerf::console {
namespace {

constexpr const char* kPartTypeName = "Cylinder 50";
constexpr const char* kLotName = "1";
constexpr const char* kAuthor = "Kerf";
constexpr int kPoll_ms = 200;

/// The diamond turning lathe is the only machine without a boring spindle.
bool bores(const Options& options) {
    return options.machine != "diamond-lathe";
}

}  // namespace

ConsoleApplication::ConsoleApplication(Options options) : m_options(std::move(options)) {}

ConsoleApplication::~ConsoleApplication() {
    m_shift.reset();
    m_poll.stop();
    m_window.reset();
    if (m_engine) {
        m_engine->stop();  // no new parts; then all that has been made goes to the disk
    }
    if (m_writer) {
        if (const std::size_t unsaved = m_writer->stop(); unsaved > 0) {
            spdlog::critical("{} finished parts could not be stored", unsaved);
        }
    }
    m_deskChanges.reset();
    m_desk.reset();
    m_modes.reset();
    m_rooms.clear();
    m_writer.reset();
}

Result<void> ConsoleApplication::start() {
    if (const auto data = openData(); !data) {
        return data;
    }
    if (const auto machine = openMachine(); !machine) {
        return machine;
    }
    makeEngine();
    m_writer = std::make_unique<db::WriterThread>(m_databasePath, &m_engine->partRecords());
    if (const auto writing = m_writer->start(); !writing) {
        return writing;
    }
    m_writer->submit(CloseAlarmsOfLastRun{}, {});

    m_look = std::make_unique<ui::Look>();
    m_savedPreferences = storedPreferences(*m_reader);
    ui::Preferences preferences = m_savedPreferences;
    if (!m_options.language.empty()) {
        preferences.language = m_options.language == "ko" ? ui::Language::Korean : ui::Language::English;
    }
    if (!m_options.theme.empty()) {
        preferences.brightness = m_options.theme == "dark" ? ui::Brightness::Dark : ui::Brightness::Light;
    }
    if (!m_options.unit.empty()) {
        preferences.length = m_options.unit == "inch" ? ui::LengthUnit::Inch : ui::LengthUnit::Millimetre;
    }
    m_look->apply(preferences);
    openRooms();
    if (bores(m_options)) {
        openLot();
    } else {
        QTimer::singleShot(0, this, &ConsoleApplication::openWindow);  // ready() comes from the event loop, always
    }
    return {};
}

Room* ConsoleApplication::room(ProcessId process) const noexcept {
    const auto found = std::find_if(m_rooms.begin(), m_rooms.end(),
                                    [process](const auto& room) { return room->process() == process; });
    return found == m_rooms.end() ? nullptr : found->get();
}

void ConsoleApplication::makeEngine() {
    std::vector<std::unique_ptr<ProcessLoop>> loops;
    if (bores(m_options)) {
        loops.push_back(std::make_unique<BoringLoop>());
    }
    for (const auto& room : m_rooms) {
        loops.push_back(room->makeLoop());
    }
    m_engine = std::make_unique<Engine>(*m_machine, std::move(loops));
}

void ConsoleApplication::openRooms() {
    const Room::Context context{*m_engine, *m_writer,      *m_reader,
                                m_options, m_databasePath, [this] { return author(); }};
    for (const auto& room : m_rooms) {
        room->open(context);
    }
    m_modes = std::make_unique<LoopModes>(
        *m_engine, *m_reader, [this](const std::string& key, const std::string& value) { saveSetting(key, value); });
}

Result<void> ConsoleApplication::openData() {
    QString folder = QString::fromStdString(m_options.dataDir);
    if (folder.isEmpty()) {
        folder = QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) + QStringLiteral("/kerf");
    }
    if (!QDir().mkpath(folder)) {
        return fail(KERF_TEXT("The data folder cannot be made; choose another one with --data."));
    }
    startLogging(folder.toStdString());
    m_databasePath = (folder + QStringLiteral("/kerf.db")).toStdString();
    if (const auto prepared = db::prepareDatabase(m_databasePath); !prepared) {
        return tl::unexpected(prepared.error());
    }
    auto reader = db::DatabaseReader::open(m_databasePath);
    if (!reader) {
        return tl::unexpected(reader.error());
    }
    m_reader = std::move(*reader);
    return {};
}

Result<void> ConsoleApplication::openMachine() {
    for (auto& room : standardRooms()) {
        if (room->fits(m_options.machine)) {
            m_rooms.push_back(std::move(room));
        }
    }
    if (m_options.machine == "linuxcnc") {
        m_realMachine = std::make_unique<linuxcnc::LinuxCncMachine>(linuxcnc::LinuxCncMachine::Params{});
        m_machine = m_realMachine.get();
        return m_machine->connect();
    }
    Simulator::Params params;
    params.seed = m_options.seed;
    params.changeAtPart = m_options.changeAtPart;
    PartQuery newest;
    newest.process = bores(m_options) ? ProcessId::Boring : ProcessId::Turning;
    newest.limit = 1;
    if (const auto parts = m_reader->parts(newest); parts && !parts->empty()) {
        params.partsSoFar = parts->front().number;  // the machine goes on where it was
    }
    params.diamondLathe = !bores(m_options);
    Simulator::Plants plants;
    for (const auto& room : m_rooms) {
        if (auto plant = room->makePlant(m_options)) {
            plants.push_back(std::move(plant));
        }
    }
    m_simulator = std::make_unique<Simulator>(params, std::move(plants));
    m_machine = &m_simulator->machine();
    return m_machine->connect();
}

void ConsoleApplication::openLot() {
    BoringLotRequest request;
    request.machineName = std::string(m_machine->capabilities().machineName.data());
    request.machineKind = m_options.machine;
    request.partTypeName = std::string(kPartTypeName);
    request.lotName = std::string(kLotName);
    request.lotSize = m_options.lotSize;
    request.author = std::string(kAuthor);
    openBoringLot(*m_writer, request, [this](const Result<LotId>& lot) {
        if (lot) {
            lotIsOpen(*lot);
        } else {
            emit failed(ui::sentenceText(lot.error()));
        }
    });
}

void ConsoleApplication::lotIsOpen(LotId lot) {
    StoredBoringDesk::Links links{*m_writer, *m_engine};
    links.gauge = [this](std::uint32_t partSequence, double overhang_mm) -> std::optional<double> {
        const Simulator::Bore bore;
        return m_simulator ? m_simulator->gaugeReading_mm(partSequence, overhang_mm, bore) : std::nullopt;
    };
    auto desk = StoredBoringDesk::open(links, *m_reader, lot);
    if (!desk) {
        emit failed(ui::sentenceText(desk.error()));
        return;
    }
    m_desk = std::move(*desk);
    if (!m_desk->restartFinding().empty()) {
        spdlog::warn("{}", m_desk->restartFinding().english());
    }
    for (const BorePartView& part : m_desk->view().parts) {
        for (const BoreMeasurementView& measurement : part.measurements) {
            m_lastAnnounced = std::max(m_lastAnnounced, measurement.id);
        }
    }
    m_deskChanges = m_desk->onChanged([this] { announceAccepted(); });
    openWindow();
}

void ConsoleApplication::openWindow() {
    m_window = std::make_unique<ui::MainWindow>(*m_look, services());
    connect(&m_window->client(), &ui::EngineClient::alarmArrived, this, &ConsoleApplication::keepAlarm);
    m_engine->start();
    m_window->client().start();
    m_modes->restore();
    if (m_simulator && m_desk) {
        const SimulatedShift::Params shift{m_options.preparedParts, m_options.autoOperator, m_options.simulationSpeed};
        m_shift = std::make_unique<SimulatedShift>(shift, *m_engine, *m_desk);
    }
    connect(&m_poll, &QTimer::timeout, this, &ConsoleApplication::poll);
    m_poll.start(kPoll_ms);
    poll();
    emit ready();
}

void ConsoleApplication::poll() {
    if (m_desk) {
        m_desk->poll();
    }
    for (const auto& room : m_rooms) {
        room->poll();
    }
    m_modes->poll();
}

std::string ConsoleApplication::author() const {
    const QString name = m_window ? m_window->session().name() : QString();
    return name.isEmpty() ? kAuthor : name.toStdString();
}

ui::Services ConsoleApplication::services() {
    ui::Services services{*m_engine};
    services.boringDesk = m_desk.get();
    services.parts = m_reader.get();
    services.openParts = [path = m_databasePath]() -> std::unique_ptr<PartReader> {
        auto reader = db::DatabaseReader::open(path);
        return reader ? std::move(*reader) : nullptr;
    };
    services.lots = m_reader.get();
    services.alarms = m_reader.get();
    services.audit = m_reader.get();
    services.settings = m_reader.get();
    services.operators = storedOperators(*m_reader);
    services.savePreferences = [this](const ui::Preferences& now) {
        savePreferences(m_savedPreferences, now,
                        [this](const std::string& key, const std::string& value) { saveSetting(key, value); });
        m_savedPreferences = now;
    };
    services.saveOperators = [this](const QStringList& operators) {
        saveOperators(operators, [this](const std::string& key, const std::string& value) { saveSetting(key, value); });
    };
    services.acknowledgeAlarm = [this](AlarmCode code, const QString& author) { acknowledgeAlarm(code, author); };
    for (const auto& room : m_rooms) {
        room->serve(services);
    }
    return services;
}

void ConsoleApplication::keepAlarm(const AlarmEvent& event) {
    if (event.raised) {
        const AlarmSpec* spec = m_engine->alarmSpec(event.code);
        m_writer->submit(RaiseAlarm{event.code, spec != nullptr ? spec->priority : std::uint8_t{3}, event.detail}, {});
    } else {
        m_writer->submit(ClearAlarm{event.code}, {});
    }
}

void ConsoleApplication::acknowledgeAlarm(AlarmCode code, const QString& author) {
    const auto open = m_reader->openAlarms();
    if (!open) {
        spdlog::error("acknowledge: {}", open.error().english());
        return;
    }
    for (const AlarmRow& row : *open) {
        if (row.code == code && !row.acknowledgedUtc_ms) {
            m_writer->submit(AcknowledgeAlarm{row.id, author.toStdString()}, {});
        }
    }
}

void ConsoleApplication::announceAccepted() {
    const BoringDeskView& view = m_desk->view();
    MeasurementId newest = m_lastAnnounced;
    for (const BorePartView& part : view.parts) {
        for (const BoreMeasurementView& measurement : part.measurements) {
            if (measurement.id > m_lastAnnounced) {
                newest = std::max(newest, measurement.id);
                const BoringSchedule& next = view.nextSchedule;
                emit accepted(
                    QString::asprintf("accepted %lld part %u depth %u diameter_mm %.17g next %u %.17g %.17g %.17g",
                                      static_cast<long long>(measurement.id), part.number, measurement.depth,
                                      measurement.diameter_mm, next.revision, next.lnC, next.alpha, next.beta));
            }
        }
    }
    m_lastAnnounced = newest;
}

void ConsoleApplication::saveSetting(const std::string& key, const std::string& value) {
    m_writer->submit(ChangeSetting{key, value, author(), {}}, [key](const Result<Receipt>& result) {
        if (!result) {
            spdlog::error("setting {}: {}", key, result.error().english());
        }
    });
}

}  // namespace kerf::console
