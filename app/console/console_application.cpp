// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/console_application.h"

#include <spdlog/spdlog.h>

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <algorithm>

#include "app/console/logging.h"
#include "app/console/preferences.h"
#include "app/files/replay_file.h"
#include "app/files/table.h"
#include "app/machines/machine_module_loader.h"
#include "engine/core/utf8.h"
#include "engine/cycle/machine_alarms.h"
#include "engine/machine/linuxcnc/port_exposure.h"
#include "ui/link/texts.h"
#include "ui/shell/pin_seal.h"

namespace kerf::console {
namespace {

/// Everything else is a module.
bool builtIn(const std::string& machine) {
    return machine == "simulator" || machine == "diamond-lathe" || machine == "replay";
}

constexpr int kPoll_ms = 200;
constexpr int kFirstLook_ms = 2;
constexpr int kFirstLooks = 150;
constexpr int kPortLook_ms = 600'000;

}  // namespace

ConsoleApplication::ConsoleApplication(Options options, std::vector<std::unique_ptr<Room>> rooms)
    : m_options(std::move(options)), m_rooms(std::move(rooms)) {
    for (const ProcessDescriptor* process : processes()) {
        if (const Room* known = room(process->id)) {
            m_pages.push_back(known->page());
        }
    }
}

ConsoleApplication::~ConsoleApplication() {
    m_poll.stop();
    m_live.reset();  // silent from now on
    m_shop.reset();
    if (m_engine) {
        m_engine->stop();  // no new parts; then all that has been made goes to the disk
    }
    if (m_writer) {
        if (const std::size_t unsaved = m_writer->stop(); unsaved > 0) {
            spdlog::critical("{} finished parts could not be stored", unsaved);
        } else if (const std::size_t waiting = m_writer->partsWaiting(); waiting > 0) {
            spdlog::warn("{} finished parts wait beside the data file for the next start", waiting);
        }
    }
    m_shift.reset();  // whoever asked for something to be stored has had the answer now
    m_window.reset();
    m_quality.reset();
    m_shiftDesk.reset();
    m_modes.reset();
    m_stops.reset();
    m_rooms.clear();
    m_sensorService.reset();
    m_sensorChoice.reset();
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
    db::WriterThread::Options writing;
    writing.taken = m_dataFile.get();
    writing.partsRefused = &m_engine->partsRefused();
    m_writer = std::make_unique<db::WriterThread>(m_databasePath, &m_engine->partRecords(), writing);
    if (const auto started = m_writer->start(); !started) {
        return started;
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
    waitForRoom(0);
    return {};
}

/// ready() or failed() comes from the event loop, always.
void ConsoleApplication::waitForRoom(std::size_t next) {
    if (next == m_rooms.size()) {
        QTimer::singleShot(0, this, &ConsoleApplication::openWindow);
        return;
    }
    m_rooms[next]->whenOpen([this, next](const Result<void>& opened) {
        if (opened) {
            waitForRoom(next + 1);
        } else {
            const QString why = ui::sentenceText(opened.error());
            QTimer::singleShot(0, this, [this, why] { emit failed(why); });
        }
    });
}

BoringRoom* ConsoleApplication::boring() const noexcept {
    return static_cast<BoringRoom*>(room(ProcessId::Boring));
}

Room* ConsoleApplication::room(ProcessId process) const noexcept {
    const auto found = std::find_if(m_rooms.begin(), m_rooms.end(),
                                    [process](const auto& room) { return room->process() == process; });
    return found == m_rooms.end() ? nullptr : found->get();
}

void ConsoleApplication::makeEngine() {
    std::vector<std::unique_ptr<ProcessLoop>> loops;
    for (const auto& room : m_rooms) {
        loops.push_back(room->makeLoop());
    }
    m_engine = std::make_unique<Engine>(*m_machine, std::move(loops));
    m_stops = std::make_unique<StopKeeper>(
        *m_engine, *m_reader, [this](const std::string& key, const std::string& value, const std::string& reason) {
            saveSetting(key, value, reason);
        });
    m_stops->restore();
}

void ConsoleApplication::openRooms() {
    Room::Context context{*m_engine, *m_writer, *m_reader, m_options, m_databasePath, [this] { return author(); },
                          rights()};
    context.simulator = m_simulator.get();
    context.nobody = kAuthor;
    context.accepted = [this](const QString& line) { emit accepted(line); };
    if (m_sensors) {
        context.temperatures = m_sensors->thermalSensors();
    } else if (!m_recordedSensors.empty()) {
        context.temperatures = unplacedSensors(m_recordedSensors);
    }
    for (const auto& room : m_rooms) {
        room->open(context);
    }
    const std::string folder = QFileInfo(QString::fromStdString(m_databasePath)).absolutePath().toStdString();
    m_live = std::make_unique<LivePublisher>(*m_engine, folder);
    m_shop = std::make_unique<ShopLink>(folder, m_databasePath, *m_writer);
    if (!m_shop->fault().empty()) {
        spdlog::error("shop: {}", m_shop->fault());
    }
    openSensors();
    m_modes = std::make_unique<LoopModes>(
        *m_engine, *m_reader, [this](const std::string& key, const std::string& value) { saveSetting(key, value); });
}

std::string ConsoleApplication::sensorFolder() const {
    return QFileInfo(QString::fromStdString(m_databasePath)).absolutePath().toStdString() + "/sensors";
}

std::string ConsoleApplication::chosenSensorFile() const {
    const auto chosen = m_reader->setting(SensorChoice::kSetting);
    return chosen ? chosen->value_or(std::string()) : std::string();
}

void ConsoleApplication::openSensors() {
    const std::string folder = sensorFolder();
    QDir().mkpath(QString::fromStdString(folder));
    SensorChoice::Links links{*m_writer, rights(), folder, chosenSensorFile()};
    links.byCommandLine = !m_options.sensors.empty();
    if (m_sensors) {
        m_sensors->record(folder);
        m_sensorService = std::make_unique<StoredSensorService>(*m_sensors, *m_writer, *m_reader, folder, rights());
        links.inUse = links.byCommandLine
                          ? QFileInfo(QString::fromStdString(m_options.sensors)).fileName().toStdString()
                          : links.chosen;
    }
    m_sensorChoice = std::make_unique<SensorChoice>(std::move(links));
}

Result<void> ConsoleApplication::openData() {
    QString folder = QString::fromStdString(m_options.dataDir);
    if (folder.toStdString() != m_options.dataDir) {  // Qt would make a folder of another name
        return fail(
            KERF_TEXT("The name of the data folder is not UTF-8: rename it, or choose another one with --data."));
    }
    if (folder.isEmpty()) {
        folder = QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) + QStringLiteral("/kerf");
    }
    if (!QDir().mkpath(folder)) {
        return fail(KERF_TEXT("The data folder cannot be made; choose another one with --data."));
    }
    if (auto logging = startLogging(folder.toStdString()); !logging) {
        return logging;
    }
    m_databasePath = (folder + QStringLiteral("/kerf.db")).toStdString();
    auto file = db::DataFile::open(m_databasePath);
    if (!file) {
        return tl::unexpected(file.error());
    }
    m_dataFile = std::move(*file);
    auto reader = db::DatabaseReader::open(m_databasePath);
    if (!reader) {
        return tl::unexpected(reader.error());
    }
    m_reader = std::move(*reader);
    return {};
}

Result<void> ConsoleApplication::openMachine() {
    std::erase_if(m_rooms, [this](const auto& room) { return !room->fits(m_options.machine); });
    if (!builtIn(m_options.machine)) {
        auto machine = loadMachine(m_options.machine, m_options.described);
        if (!machine) {
            return tl::unexpected(machine.error());
        }
        m_realMachine = std::move(*machine);
        m_machine = m_realMachine.get();
        return joinSensors();
    }
    if (m_options.machine == "replay") {
        return openRecordedDay();
    }
    Simulator::Params params;
    params.seed = m_options.seed;
    params.machineSeed = m_options.machineSeed;
    params.changeAtPart = m_options.changeAtPart;
    params.partsSoFar = madeUpTo(*m_reader, boring() != nullptr ? ProcessId::Boring : ProcessId::Turning, {});
    params.diamondLathe = boring() == nullptr;
    Simulator::Plants plants;
    for (const auto& room : m_rooms) {
        if (auto plant = room->makePlant(m_options)) {
            plants.push_back(std::move(plant));
        }
    }
    m_simulator = std::make_unique<Simulator>(params, std::move(plants));
    m_machine = &m_simulator->machine();
    if (!m_options.machineFile.empty()) {
        m_described = std::make_unique<DescribedMachine>(*m_machine, m_options.described);
        m_machine = m_described.get();
    }
    return joinSensors();
}

Result<void> ConsoleApplication::openRecordedDay() {
    try {
        headless::RecordedDay day = headless::readRecordedDay(m_options.replayFile);
        m_recordedSensors = std::move(day.sensors);
        m_realMachine = std::move(day.machine);
    } catch (const headless::BadInput& fault) {
        spdlog::error("{}", fault.what());
        std::fprintf(stderr, "kerf-console: %s\n", fault.what());
        return fail(KERF_TEXT("The recorded day is refused; the log says where and why."));
    }
    m_machine = m_realMachine.get();
    return m_machine->connect();
}

Result<void> ConsoleApplication::joinSensors() {
    const std::string chosen = chosenSensorFile();
    const bool named = !m_options.sensors.empty();
    if (named || !chosen.empty()) {
        auto sensors = ConsoleSensors::open(named ? m_options.sensors : sensorFolder() + '/' + chosen, *m_machine);
        if (sensors) {
            m_sensors = std::move(*sensors);
            m_machine = &m_sensors->port();
        } else if (named) {
            return tl::unexpected(sensors.error());
        } else {  // who chose it on the screen can choose another one there
            m_notRead = chosen;
        }
    }
    return m_machine->connect();
}

void ConsoleApplication::openWindow() {
    m_window = std::make_unique<ui::MainWindow>(*m_look, services(), ui::standardPages(m_pages));
    connect(&m_window->client(), &ui::EngineClient::alarmArrived, this, &ConsoleApplication::keepAlarm);
    if (m_options.ownThread) {
        m_engine->start();
    }
    m_window->client().start();
    m_modes->restore();
    if (m_options.machine == "replay") {
        Command speed;
        speed.action = SetSimulationSpeed{m_options.simulationSpeed};
        (void)m_engine->send(speed);
    }
    if (m_simulator) {
        // A day that is on record has been prepared already.
        BoringRoom* const bores = boring();
        const bool fresh = bores != nullptr || !(m_reader->parts({}) && !m_reader->parts({})->empty());
        const SimulatedShift::Params shift{
            fresh ? m_options.preparedParts : 0, m_options.autoOperator, m_options.simulationSpeed, [this] {
                return std::ranges::all_of(m_rooms, [this](const auto& room) { return room->prepared(*m_engine); });
            }};
        m_shift =
            std::make_unique<SimulatedShift>(shift, *m_engine, bores != nullptr ? &bores->lots().service() : nullptr);
    }
    m_quality->start(boring() != nullptr ? &boringLots().service() : nullptr);
    if (m_options.machine == "linuxcnc") {
        connect(&m_portLook, &QTimer::timeout, this, &ConsoleApplication::lookAtPort);
        m_portLook.start(kPortLook_ms);
        lookAtPort();
    }
    connect(&m_poll, &QTimer::timeout, this, &ConsoleApplication::poll);
    m_poll.start(kPoll_ms);
    poll();
    readyOnceKnown(m_options.ownThread ? kFirstLooks : 0);
}

/// Shown with its content: nobody is to read that no loop is fitted because the engine has not run yet.
void ConsoleApplication::readyOnceKnown(int looks) {
    m_window->client().tick();
    if (looks == 0 || std::ranges::any_of(m_window->client().status().loops, &LoopStatus::fitted)) {
        emit ready();
        return;
    }
    QTimer::singleShot(kFirstLook_ms, this, [this, looks] { readyOnceKnown(looks - 1); });
}

void ConsoleApplication::poll() {
    for (const auto& room : m_rooms) {
        room->poll();
    }
    m_quality->poll();
    m_shiftDesk->poll();
    m_stops->poll();
    m_modes->poll();
    m_shop->poll(live::monotonic_ms());
    m_live->poll(m_shop->json());
    if (m_sensors) {
        m_sensors->poll();
    }
    if (m_sensorService) {
        m_sensorService->poll();
    }
}

/// The control's command port takes orders from anyone who reaches it: said for as long as others do.
void ConsoleApplication::lookAtPort() {
    const auto address = std::make_shared<std::string>();
    m_background.run(
        [address, port = m_options.described.commandPort]() -> Result<void> {
            *address = linuxcnc::openAddress(port);
            return {};
        },
        [this, address](const Result<void>&) {
            const bool open = !address->empty();
            if (open != m_portOpen && m_window) {
                m_portOpen = open;
                const AlarmEvent event{machine_alarm::kCommandPortOpen, open, 0,
                                       Sentence(KERF_TEXT("It answers on %1."), SentenceArg(*address))};
                emit m_window->client().alarmArrived(event);
            }
        });
}

std::string ConsoleApplication::author() const {
    const QString name = m_window ? m_window->session().name() : QString();
    return name.isEmpty() ? kAuthor : name.toStdString();
}

Rights ConsoleApplication::rights() {
    return [this](const std::string& who, Deed deed) -> std::optional<Sentence> {
        const Trust least = permissionOf(deed).least;
        const bool byItself = who == kAuthor || (m_simulator && who == SimulatedShift::kAuthor);
        if (!m_window || (byItself && m_window->session().author() != who)) {
            return std::nullopt;
        }
        const ui::OperatorAccount* account = m_window->session().account(QString::fromStdString(who));
        if (account != nullptr && account->role >= least) {
            // A demonstration among people without PINs goes on alone.
            const ui::OperatorSession& session = m_window->session();
            const bool alone = session.settings().demonstration && session.possibleSeconds().isEmpty();
            if (deed == Deed::LimitFar && !alone && session.second().isEmpty()) {
                return Sentence(
                    KERF_TEXT("Raising a limit by more than half takes two: another setter or process engineer "
                              "says yes first (touch the name in the header, Second person)."));
            }
            return std::nullopt;
        }
        audit(who, "refused", permissionOf(deed).key, "role");
        return onlyWho(least);
    };
}

void ConsoleApplication::audit(const std::string& who, const std::string& action, const char* object,
                               const std::string& reason) {
    AddAudit entry;
    entry.author = who;
    entry.action = action;
    entry.object = object;
    entry.reason = reason;
    m_writer->submit(entry, {});
}

/// Seals of the first versions are a bare hash of a few digits: none is left in the file as it is.
void ConsoleApplication::wrapOldSeals() {
    for (ui::OperatorAccount& account : m_savedSignOn.accounts) {
        const QString wrapped = ui::wrappedSeal(account.pin);
        if (wrapped != account.pin) {
            account.pin = wrapped;
            m_writer->submit(SaveAccount{account.name.toStdString(), ui::roleKey(account.role), wrapped.toStdString(),
                                         std::string(kAuthor), "old seal of the PIN replaced"},
                             {});
        }
    }
}

std::vector<Sentence> ConsoleApplication::startFindings() const {
    const db::DataFile::Finding& finding = m_dataFile->finding();
    std::vector<Sentence> sentences;
    if (!finding.missing.empty()) {
        sentences.push_back(finding.missing);
    }
    if (!finding.setAside.empty()) {
        sentences.emplace_back(
            KERF_TEXT("A backup has taken the place of the data; what was there is kept as %1."),
            SentenceArg(QFileInfo(QString::fromStdString(finding.setAside)).fileName().toStdString()));
    }
    if (!m_notRead.empty()) {
        sentences.emplace_back(
            KERF_TEXT("The sensor file %1 cannot be used: only what the machine itself brings is read. Sensors says "
                      "why."),
            SentenceArg(beginOf(m_notRead, SentenceArg{}.name.size() - 1)));
    }
    if (finding.partsFound > 0) {
        sentences.emplace_back(KERF_TEXT("%1 finished parts had waited beside the data file; they are stored now."),
                               SentenceArg(static_cast<double>(finding.partsFound), 0));
    }
    if (finding.notRead > 0) {
        sentences.emplace_back(KERF_TEXT("%1 items that waited beside the data file are of another version: they are "
                                         "kept in a file beside it."),
                               SentenceArg(static_cast<double>(finding.notRead), 0));
    }
    if (m_savedSignOn.demonstration) {
        spdlog::info("simulated machine: roles may be taken without a process engineer");
    }
    for (const Sentence& sentence : sentences) {
        spdlog::warn("{}", sentence.english());
    }
    return sentences;
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

void ConsoleApplication::saveSetting(const std::string& key, const std::string& value, const std::string& reason) {
    m_writer->submit(ChangeSetting{key, value, author(), reason}, [key](const Result<Receipt>& result) {
        if (!result) {
            spdlog::error("setting {}: {}", key, result.error().english());
        }
    });
}

}  // namespace kerf::console
