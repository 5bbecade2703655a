// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/thermal/thermal_service.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/files/text_encoding.h"
#include "app/files/thermal_files.h"
#include "app/files/thermal_model_json.h"
#include "app/service/thermal/thermal_places.h"
#include "app/service/thermal/thermal_records.h"
#include "engine/process/thermal/plant/simulated_day.h"
#include "engine/process/thermal/plant/simulated_elements.h"
#include "engine/process/thermal/thermal_setup.h"

namespace kerf {
namespace {

namespace records = thermal_records;
using nlohmann::json;

constexpr std::size_t kMinutesKept = 1440;
constexpr std::size_t kRowsShown = 200;
constexpr std::uint32_t kRecordsRead = 50;
constexpr std::uint32_t kModelsRead = 2;
constexpr std::int64_t kWriteEvery_ms = 10'000;
constexpr std::int64_t kDay_ms = 12LL * 3600 * 1000;  ///< so old may be what was learnt of today
constexpr double kSameZero_um = 1e-6;
constexpr const char* kAuthor = "Kerf";
constexpr const char* kNamelessMachine = "Machine";  // as migration 006 calls it
constexpr const char* kBuiltInDays = "built-in:";
constexpr const char* kFile = "file:";
constexpr const char* kSession = "session:";

std::int64_t utcNow_ms() {
    using namespace std::chrono;
    return duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count();
}

ThermalJudgementView judgementView(thermal::ModelKind kind, const thermal::Judgement& judgement, std::size_t sensors) {
    ThermalJudgementView view;
    view.kind = thermal::modelKindKey(kind);
    view.sensors = static_cast<std::uint32_t>(sensors);
    view.heldOut = judgement.heldOut;
    view.rms_um = judgement.rms_um;
    view.worst_um = judgement.worst_um;
    return view;
}

ThermalModelCard cardOf(const thermal::ThermalModel& model) {
    ThermalModelCard card;
    card.judgement = judgementView(model.kind, model.judgement, model.sensors.size());
    card.formula = thermal::formulaLines(model);
    card.trainedOn = model.trainedOn;
    card.rows = static_cast<std::uint32_t>(std::max(model.trainingRows, 0));
    for (const thermal::ModelSensor& sensor : model.sensors) {
        card.sensors.push_back(sensor.name);
    }
    return card;
}

}  // namespace

StoredThermalService::StoredThermalService(const Links& links, RoomRecordReader& reader, LotReader& lots)
    : m_links(links),
      m_recipes(m_links.writer, lots, ProcessId::Thermal),
      m_history({m_recipes, [this] { return recipeName(); },
                 [this](const RecipeRevision& revision, const std::string& author, const std::string& reason,
                        RecipeHistory::Done done) { restoreRevision(revision, author, reason, std::move(done)); }}) {
    const Capabilities& machine = m_links.engine.capabilities();
    m_view.sensors =
        m_links.sensors.empty() ? thermalSensors(machine.temperatureCount, machine.simulated) : m_links.sensors;
    m_view.dayFolder = m_links.dayFolder;
    load(reader);
    findDays();
    if (!m_live && builtInHeat()) {
        m_firstModel = true;
        std::vector<std::string> days;
        for (const ThermalDayView& day : m_view.days) {
            if (day.id.starts_with(kBuiltInDays)) days.push_back(day.id);
        }
        (void)train("hierarchical", days);
    }
    changed();
}

bool StoredThermalService::builtInHeat() const {
    return m_links.engine.capabilities().simulated && m_links.sensors.empty();
}

void StoredThermalService::load(RoomRecordReader& reader) {
    const auto newest = [&](const char* kind, std::uint32_t limit) {
        auto rows = reader.roomRecords(ProcessId::Thermal, kind, {}, limit);
        if (!rows) m_way.setStoreProblem(rows.error());
        return rows ? std::move(*rows) : std::vector<RoomRecordRow>{};
    };
    for (const RoomRecordRow& row : newest(records::kLearnt, thermal::kMaxDayMeasurements)) {
        const auto learnt = records::learntFromJson(row.bodyJson);
        if (learnt && utcNow_ms() - learnt->utc_ms < kDay_ms) m_recalled.push_back(*learnt);
    }
    std::ranges::reverse(m_recalled);  // oldest first
    loadModels(reader);
    for (const RoomRecordRow& row : newest(records::kShifts, kRecordsRead)) {
        std::vector<ThermalShiftRow> shifts = records::shiftsFromJson(row.bodyJson);
        m_view.shifts.insert(m_view.shifts.end(), shifts.rbegin(), shifts.rend());
    }
    m_view.shifts.resize(std::min(m_view.shifts.size(), kRowsShown));
    for (const RoomRecordRow& row : newest(records::kGap, kRecordsRead)) {
        if (const auto gap = records::gapFromJson(row.bodyJson)) m_view.gaps.push_back(*gap);
    }
    for (const RoomRecordRow& row : newest(records::kSession, kRecordsRead)) {
        if (auto day = records::sessionFromJson(row.bodyJson)) {
            m_sessions.emplace_back(kSession + std::to_string(row.id), std::move(*day));
        }
    }
    if (const auto rows = newest(records::kZero, 1); !rows.empty()) {
        m_keptZero = records::zeroFromJson(rows.front().bodyJson);
    }
    loadSetup();
    if (m_keptZero) {  // any zero that is known is this one, or has been measured since
        m_way.owe(LoadGapZero{*m_keptZero}, [](const Status& status) { return status.thermal.gapZeroKnown; });
    }
}

void StoredThermalService::loadSetup() {
    const auto recipes = m_recipes.newest();
    if (!recipes) {
        m_way.setStoreProblem(recipes.error());
    } else if (!recipes->empty()) {
        if (const auto setup = records::setupFromJson(recipes->back().revision.parametersJson)) {
            m_view.setup = *setup;
            m_recipe = recipes->back().revision.id;
        } else {
            m_way.setStoreProblem(
                Sentence(KERF_TEXT("This recipe revision is of another version, or cannot be used.")));
        }
    }
    if (m_view.setup.revision > 0) oweSetup();
}

void StoredThermalService::oweSetup() {
    m_way.owe(LoadThermalSetup{m_view.setup, WorkOrder{0, m_recipe, 0}},
              [wanted = m_view.setup.revision](const Status& status) { return status.thermal.setup == wanted; });
}

std::string StoredThermalService::recipeName() const {
    const std::string machine(m_links.engine.capabilities().machineName.data());
    return machine.empty() ? kNamelessMachine : machine;
}

void StoredThermalService::loadModels(RoomRecordReader& reader) {
    const auto rows = reader.roomRecords(ProcessId::Thermal, records::kModel, {}, kModelsRead);
    if (!rows) {
        m_way.setStoreProblem(rows.error());
        return;
    }
    for (auto row = rows->rbegin(); row != rows->rend(); ++row) {
        auto model = formats::thermalModelFromJson(row->bodyJson);
        if (!model) continue;  // of a newer version: the service goes on without it
        KeptModel kept{std::move(*model), {}};
        kept.card = cardOf(kept.model);
        kept.card.createdUtc_ms = row->createdUtc_ms;
        kept.card.author = row->author;
        install(std::move(kept));
    }
}

void StoredThermalService::keep(const char* kind, std::string body, const std::string& author, std::string reason,
                                std::function<void()> stored) {
    AddRoomRecord record{ProcessId::Thermal,
                         kind,
                         std::string(m_links.engine.capabilities().machineName.data()),
                         std::move(body),
                         author.empty() ? kAuthor : author,
                         std::move(reason)};
    m_way.keep([&](StoreWriter::Done answer) { m_links.writer.submit(std::move(record), std::move(answer)); },
               [stored = std::move(stored)](const Receipt&) {
                   if (stored) stored();
               },
               {});
}

Result<void> StoredThermalService::makeLive(KeptModel model, const std::string& author, std::string reason) {
    const std::vector<std::string> names = channelNames();
    if (const auto fits = LiveModel::make(model.model, names, 0); !fits) {
        return tl::unexpected(fits.error());
    }
    model.card.author = author;
    model.card.createdUtc_ms = utcNow_ms();
    std::string body = formats::thermalModelToJson(model.model);
    const auto shared = std::make_shared<KeptModel>(std::move(model));
    keep(records::kModel, std::move(body), author, std::move(reason), [this, shared] {
        install(std::move(*shared));
        changed();
    });
    return {};
}

void StoredThermalService::install(KeptModel model) {
    const std::vector<std::string> names = channelNames();
    auto live = LiveModel::make(model.model, names, m_modelNumber + 1);
    if (!live) {
        m_way.setStoreProblem(live.error());
        return;
    }
    model.card.revision = ++m_modelNumber;
    for (const records::Learnt& one : m_recalled) {
        if (one.fingerprint == model.model.fingerprint) (*live)->estimator.recall(one.measurement);
    }
    m_links.exchange.offer(std::move(*live));
    m_previous = std::move(m_live);
    m_live = std::move(model);
    m_view.live = m_live->card;
    m_view.canRollBack = m_previous.has_value();
}

std::vector<std::string> StoredThermalService::channelNames() const {
    std::vector<std::string> names;
    for (const ThermalSensorView& sensor : m_view.sensors) {
        names.push_back(sensor.name);
    }
    return names;
}

Result<void> StoredThermalService::send(const decltype(Command::action)& action) {
    Command command;
    command.action = action;
    if (!m_links.engine.send(command)) {
        return fail(KERF_TEXT("The engine takes no commands at the moment; try again."));
    }
    return {};
}

std::vector<std::pair<double, double>> StoredThermalService::temperatures(std::size_t sensor) const {
    std::vector<std::pair<double, double>> out;
    for (const ThermalMinute& minute : m_minutes) {
        if (sensor < kMaxTemperatures && (minute.present >> sensor & 1U) != 0U) {
            out.emplace_back(minute.minutes, static_cast<double>(minute.temp_degC[sensor]));
        }
    }
    return out;
}

ThermalErrorMap StoredThermalService::errorMap(double z_mm, bool exact) const {
    constexpr std::uint32_t kColumns = 20;
    constexpr std::uint32_t kRows = 12;
    ThermalErrorMap map;
    map.known = builtInHeat();
    if (!map.known) return map;
    map.range_mm = {{{0.0, thermal::kTravelX_mm}, {0.0, thermal::kTravelY_mm}, {0.0, thermal::kTravelZ_mm}}};
    map.columns = kColumns;
    map.rows = kRows;
    const thermal::ErrorElements elements = thermal::simulatedElements();
    const auto at = [&](const Eigen::Vector3d& position_mm) -> Eigen::Vector3d {
        const thermal::VolumetricChain chain = elements.at(position_mm);
        return 1000.0 * (exact ? thermal::exactError_mm(chain) : thermal::firstOrderError_mm(chain));
    };
    const Eigen::Vector3d zero_um = at(Eigen::Vector3d::Zero());  // the work origin is set there
    for (std::uint32_t row = 0; row < kRows; ++row) {
        for (std::uint32_t column = 0; column < kColumns; ++column) {
            const Eigen::Vector3d position_mm((column + 0.5) / kColumns * thermal::kTravelX_mm,
                                              (row + 0.5) / kRows * thermal::kTravelY_mm, z_mm);
            const Eigen::Vector3d error_um = at(position_mm) - zero_um;
            map.error_um.push_back({error_um.x(), error_um.y(), error_um.z()});
        }
    }
    return map;
}

void StoredThermalService::findDays() {
    m_view.days.clear();
    std::error_code error;
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(m_links.dayFolder, error)) {
        if (entry.path().extension() == ".csv") files.push_back(entry.path().filename().string());
    }
    std::ranges::sort(files);
    for (const std::string& file : files) {
        m_view.days.push_back({kFile + file, kerf::files::utf8Of(file), 0});
    }
    for (const auto& [id, day] : m_sessions) {
        m_view.days.push_back({id, day.label, static_cast<std::uint32_t>(day.workRows())});
    }
    if (builtInHeat()) {
        for (std::size_t k = 0; k < thermal::kTrainingDays; ++k) {
            m_view.days.push_back({kBuiltInDays + std::to_string(k), thermal::trainingDayLabel(k), 360});
        }
    }
    changed();
}

Result<void> StoredThermalService::train(const std::string& kind, const std::vector<std::string>& dayIds) {
    if (m_trainer.running()) return fail(KERF_TEXT("A model is being trained."));
    if (dayIds.empty()) return fail(KERF_TEXT("Choose at least one day to train on."));
    std::vector<std::string> files;
    std::vector<thermal::ThermalHistory> ready;
    std::vector<std::size_t> builtIn;
    for (const std::string& id : dayIds) {
        if (id.starts_with(kFile)) {
            files.push_back(m_links.dayFolder + '/' + id.substr(std::string(kFile).size()));
        } else if (id.starts_with(kBuiltInDays)) {
            builtIn.push_back(static_cast<std::size_t>(std::stoul(id.substr(std::string(kBuiltInDays).size()))));
        } else {
            const auto found = std::ranges::find(m_sessions, id, &decltype(m_sessions)::value_type::first);
            if (found == m_sessions.end()) return fail(KERF_TEXT("One of the days is not there any more."));
            ready.push_back(found->second);
        }
    }
    m_candidate.reset();
    m_view.training = {};
    m_view.training.state = TrainingState::Running;
    m_trainingNotes = std::make_shared<std::vector<std::string>>();
    m_trainer.start(kind, [files, ready, builtIn, notes = m_trainingNotes, seed = m_links.machineSeed,
                           hardSeed = m_links.hardSeed] {
        std::vector<thermal::ThermalHistory> days;
        if (!files.empty()) days = headless::readThermalHistories(files, {}, notes.get());
        days.insert(days.end(), ready.begin(), ready.end());
        for (const std::size_t k : builtIn)
            days.push_back(thermal::trainingDay(seed, k, hardSeed));
        return days;
    });
    changed();
    return {};
}

Result<void> StoredThermalService::goLive(const std::string& author) {
    if (const auto may = permitted(m_links.rights, author, Deed::ThermalModel); !may) return may;
    if (!m_candidate) return fail(KERF_TEXT("There is no trained model that waits to go live."));
    KeptModel model = *m_candidate;
    if (const auto live = makeLive(std::move(model), author, "trained"); !live) return live;
    m_candidate.reset();
    m_view.training = {};
    changed();
    return {};
}

Result<void> StoredThermalService::rollBack(const std::string& author) {
    if (const auto may = permitted(m_links.rights, author, Deed::ThermalModel); !may) return may;
    if (!m_previous) return fail(KERF_TEXT("There is no model before this one."));
    return makeLive(*m_previous, author, "rolled back");
}

void StoredThermalService::changeSetup(const ThermalSetup& setup, const std::string& author, const std::string& reason,
                                       RecipeHistory::Done done) {
    accept(setup, author, reason, std::nullopt, std::move(done));
}

void StoredThermalService::restoreRevision(const RecipeRevision& revision, const std::string& author,
                                           const std::string& reason, RecipeHistory::Done done) {
    if (const auto setup = records::setupFromJson(revision.parametersJson)) {
        return accept(*setup, author, reason, revision.revision, std::move(done));
    }
    answer(done, fail(KERF_TEXT("This recipe revision is of another version, or cannot be used.")));
}

void StoredThermalService::accept(const ThermalSetup& setup, const std::string& author, const std::string& reason,
                                  std::optional<std::uint32_t> restoredFrom, RecipeHistory::Done done) {
    ThermalSetup next = setup;
    next.revision = m_view.setup.revision + 1;
    const auto store = [&](StoreWriter::Done stored) {
        m_recipes.begin(recipeName(), records::setupToJson(m_view.setup), kAuthor);
        m_recipes.keep(recipeName(), records::setupToJson(next), author, reason, restoredFrom, std::move(stored));
    };
    m_way.change(
        mayAccept(next, author, reason), store,
        [this, next](const Receipt& revision) {
            m_view.setup = next;
            m_recipe = revision.id;
            oweSetup();
        },
        std::move(done));
}

Result<void> StoredThermalService::mayAccept(const ThermalSetup& setup, const std::string& author,
                                             const std::string& reason) const {
    const bool far = raisedFar(m_view.setup.maxShift_um, setup.maxShift_um);
    if (const auto may = permittedLimit(m_links.rights, author, Deed::ThermalLimits, reason, far); !may) return may;
    if (const auto why = thermal::whyUnusable(setup)) return tl::unexpected(*why);
    return {};
}

Result<void> StoredThermalService::measureByPart(const std::array<std::optional<double>, kAxisCount>& deviation_um,
                                                 const std::string& author) {
    if (const auto may = permitted(m_links.rights, author, Deed::ThermalReference); !may) return may;
    if (!m_links.engine.status().thermal.partToMeasure) {
        return fail(KERF_TEXT("No part has been finished since the reference that has not been measured yet."));
    }
    MeasureByPart part;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        part.known[axis] = deviation_um[axis].has_value();
        part.deviation_um[axis] = deviation_um[axis].value_or(0.0);
    }
    if (const auto sent = send(part); !sent) return sent;
    m_partAuthor = author;
    m_partDeviation_um = part.deviation_um;
    return {};
}

Result<void> StoredThermalService::beginSession(const std::string& author) {
    if (const auto may = permitted(m_links.rights, author, Deed::ThermalSession); !may) return may;
    if (m_view.session.recording) return fail(KERF_TEXT("A session is being recorded."));
    if (const auto sent = send(TakeThermalReference{false}); !sent) return sent;
    if (const auto sent = send(RecordGaps{true}); !sent) return sent;
    m_session.clear();
    m_sessionReference = m_reference + 1;
    m_sessionAuthor = author;
    m_view.session = {};
    m_view.session.recording = true;
    m_view.session.whyNotKept = Sentence(KERF_TEXT("Nothing has been measured yet."));
    changed();
    return {};
}

Result<void> StoredThermalService::endSession(const std::string& author) {
    if (const auto may = permitted(m_links.rights, author, Deed::ThermalSession); !may) return may;
    if (!m_view.session.recording) return fail(KERF_TEXT("No session is being recorded."));
    (void)send(RecordGaps{false});
    m_view.session.recording = false;
    const thermal::ThermalHistory day = sessionDay();
    changed();
    if (const auto fault = thermal::whyNotTrainable(day)) {
        m_view.session.whyNotKept = fault->reason;
        return tl::unexpected(fault->reason);
    }
    m_view.session.whyNotKept = {};
    m_sessions.emplace(m_sessions.begin(), kSession + day.label, day);
    keep(records::kSession, records::sessionToJson(day), author, "recorded");
    findDays();
    return {};
}

thermal::ThermalHistory StoredThermalService::sessionDay() const {
    thermal::ThermalHistory day;
    day.label = "session " + std::to_string(m_sessionReference) + ", " + std::to_string(m_session.size()) + " rows";
    std::vector<const ThermalMinute*> rows;
    std::uint64_t everywhere = ~std::uint64_t{0};
    for (const ThermalMinute& minute : m_session) {
        if (minute.minutes >= 0.0 && !minute.measured) break;
        rows.push_back(&minute);
        everywhere &= minute.present;
    }
    std::vector<std::size_t> channels;
    for (std::size_t k = 0; k < m_view.sensors.size(); ++k) {
        if ((everywhere >> k & 1U) != 0U) {
            channels.push_back(k);
            day.sensors.push_back(m_view.sensors[k].name);
        }
    }
    const auto count = static_cast<Eigen::Index>(rows.size());
    day.temp_degC.resize(count, static_cast<Eigen::Index>(channels.size()));
    day.present = thermal::PresentMask::Constant(count, day.temp_degC.cols(), true);
    day.drift_um = Eigen::MatrixXd::Zero(count, 3);
    const auto first = std::ranges::find_if(rows, [](const ThermalMinute* row) { return row->minutes >= 0.0; });
    const auto baselineRows = static_cast<double>(first - rows.begin());
    for (Eigen::Index row = 0; row < count; ++row) {
        const ThermalMinute& minute = *rows[static_cast<std::size_t>(row)];
        const double period_min = m_view.setup.period_min;
        day.time_min.push_back((static_cast<double>(row) - baselineRows) * period_min);
        day.speed_rpm.push_back(static_cast<double>(minute.speed_rpm));
        for (std::size_t k = 0; k < channels.size(); ++k) {
            day.temp_degC(row, static_cast<Eigen::Index>(k)) = static_cast<double>(minute.temp_degC[channels[k]]);
        }
        for (std::size_t axis = 0; axis < kAxisCount && minute.minutes >= 0.0; ++axis) {
            // The loop counts from minus the shift the session began with.
            day.drift_um(row, static_cast<Eigen::Index>(axis)) =
                static_cast<double>(minute.measured_um[axis]) + static_cast<double>((*first)->shift_um[axis]);
        }
    }
    return day;
}

void StoredThermalService::poll() {
    m_links.exchange.collect();
    m_way.poll();
    takeMinutes();
    takeLearnt();
    takeGap(m_links.engine.status().thermal);
    takeTraining();
    writeShifts(false);
}

void StoredThermalService::takeMinutes() {
    ThermalMinute minute;
    bool any = false;
    while (m_links.exchange.minutes.tryPop(minute)) {
        takeMinute(minute);
        any = true;
    }
    if (!any) return;
    if (m_view.session.recording) {
        const auto fault = thermal::whyNotTrainable(sessionDay());
        m_view.session.whyNotKept = fault ? fault->reason : Sentence{};
    }
    changed();
}

void StoredThermalService::takeLearnt() {
    thermal::DayMeasurement measurement;
    while (m_links.exchange.learnt.tryPop(measurement)) {
        if (!m_live) continue;
        keep(records::kLearnt, records::learntToJson({utcNow_ms(), m_live->model.fingerprint, measurement}), {},
             "learnt");
    }
}

void StoredThermalService::takeMinute(const ThermalMinute& minute) {
    if (minute.reference > 1) m_recalled.clear();  // a new reference: what it holds is the loop's to know
    if (minute.reference != m_reference) {
        m_reference = minute.reference;
        m_minutes.clear();
        m_view.course.clear();
    }
    m_minutes.push_back(minute);
    if (m_minutes.size() > kMinutesKept) m_minutes.pop_front();
    if (m_view.session.recording && minute.reference >= m_sessionReference) {
        m_session.push_back(minute);
        m_view.session.rows += minute.measured ? 1U : 0U;
    }
    if (minute.minutes < 0.0) return;
    m_view.course.push_back({minute.minutes, minute.predicted, minute.measured, minute.drift_um, minute.half_um,
                             minute.shift_um, minute.measured_um});
    if (m_view.course.size() > kMinutesKept) m_view.course.erase(m_view.course.begin());
    ThermalShiftRow row{utcNow_ms(), minute.minutes, {}, {}};
    bool same = !m_view.shifts.empty();
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        row.shift_um[axis] = std::round(static_cast<double>(minute.shift_um[axis]));
        row.drift_um[axis] = static_cast<double>(minute.drift_um[axis]);
        same = same && row.shift_um[axis] == m_view.shifts.front().shift_um[axis];
    }
    if (same) return;
    m_view.shifts.insert(m_view.shifts.begin(), row);
    m_view.shifts.resize(std::min(m_view.shifts.size(), kRowsShown));
    m_unwritten.push_back(row);
}

void StoredThermalService::takeGap(const ThermalStatus& status) {
    if (status.gap.phase == GapPhase::Done && status.gap.number != m_gapSeen) {
        m_gapSeen = status.gap.number;
        ThermalGapRow row{utcNow_ms(),        status.gap.measured_um,     status.gap.predicted_um,
                          status.gap.half_um, status.gap.predictionKnown, status.gap.byPart,
                          status.gap.known};
        row.allowed_um = m_view.setup.allowed_um;
        row.leftKnown = row.byPart || std::ranges::all_of(status.shifted_um, &Reading::good);
        for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
            row.left_um[axis] = row.byPart      ? m_partDeviation_um[axis]
                                : row.leftKnown ? row.measured_um[axis] + status.shifted_um[axis].value
                                                : 0.0;
        }
        m_view.gaps.insert(m_view.gaps.begin(), row);
        m_view.gaps.resize(std::min(m_view.gaps.size(), kRowsShown));
        keep(records::kGap, records::gapToJson(row), row.byPart ? m_partAuthor : std::string(),
             row.byPart ? "measured on a part" : "measured");
        changed();
    }
    if (!status.gapZeroKnown) return;
    bool same = m_keptZero.has_value();
    for (std::size_t axis = 0; axis < kAxisCount && same; ++axis) {
        same = std::abs((*m_keptZero)[axis] - status.gapZero_um[axis]) < kSameZero_um;
    }
    if (!same) {
        m_keptZero = status.gapZero_um;
        keep(records::kZero, records::zeroToJson(status.gapZero_um), {}, "reference");
    }
}

void StoredThermalService::takeTraining() {
    if (m_view.training.state != TrainingState::Running) return;
    if (m_view.training.progress != m_trainer.progress()) {
        m_view.training.progress = m_trainer.progress();
        changed();
    }
    const auto outcome = m_trainer.takeOutcome();
    if (!outcome) return;
    ThermalTrainingView& training = m_view.training;
    training.progress = 1.0;
    if (outcome->cancelled) {
        training.state = TrainingState::Cancelled;
    } else if (outcome->problem) {
        training.state = TrainingState::Failed;
        training.problem = outcome->problem->sentence;
        training.detail = outcome->problem->detail;
    } else {
        training.state = TrainingState::Ready;
        for (const thermal::Candidate& one : outcome->trained->compared) {
            training.compared.push_back(judgementView(one.kind, one.judgement, one.sensors));
            training.compared.back().chosen = one.kind == outcome->trained->best.kind;
        }
        m_candidate = KeptModel{outcome->trained->best, cardOf(outcome->trained->best)};
        training.candidate = m_candidate->card;
        for (const std::string& note : *m_trainingNotes) {
            training.detail += (training.detail.empty() ? "" : "\n");
            training.detail += note;
        }
        if (m_firstModel) (void)goLive(kAuthor);
    }
    m_firstModel = false;
    changed();
}

void StoredThermalService::writeShifts(bool now) {
    const std::int64_t time_ms = utcNow_ms();
    if (m_unwritten.empty() || (!now && time_ms - m_lastWrite_ms < kWriteEvery_ms)) return;
    m_lastWrite_ms = time_ms;
    keep(records::kShifts, records::shiftsToJson(m_unwritten), {}, "followed");
    m_unwritten.clear();
}

}  // namespace kerf
