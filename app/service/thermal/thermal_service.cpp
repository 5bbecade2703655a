// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/thermal/thermal_service.h"

#include <algorithm>
#include <cmath>

#include "app/service/thermal/thermal_places.h"
#include "app/service/thermal/thermal_records.h"
#include "engine/process/thermal/plant/simulated_elements.h"
#include "engine/process/thermal/thermal_setup.h"

namespace kerf {
namespace {

namespace records = thermal_records;

constexpr std::size_t kMinutesKept = 1440;
constexpr std::size_t kRowsShown = 200;
constexpr std::uint32_t kRecordsRead = 50;
constexpr std::int64_t kWriteEvery_ms = 10'000;
constexpr std::int64_t kDay_ms = 12LL * 3600 * 1000;  ///< so old may be what was learnt of today
constexpr double kSameZero_um = 1e-6;
constexpr const char* kNamelessMachine = "Machine";  // as migration 006 calls it

/// Newest first, as many as are shown.
template <class Row>
void putFirst(std::vector<Row>& rows, const Row& row) {
    rows.push_back(row);
    std::rotate(rows.rbegin(), rows.rbegin() + 1, rows.rend());
    rows.resize(std::min(rows.size(), kRowsShown));
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
    trainFirst();
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
        if (learnt && records::utcNow_ms() - learnt->utc_ms < kDay_ms) m_recalled.push_back(*learnt);
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
    loadSessions(newest(records::kSession, kRecordsRead));
    loadMemory(reader);
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

void StoredThermalService::keep(const char* kind, std::string body, const std::string& author, std::string reason,
                                std::function<void(const Receipt&)> stored) {
    AddRoomRecord record{ProcessId::Thermal,
                         kind,
                         std::string(m_links.engine.capabilities().machineName.data()),
                         std::move(body),
                         author.empty() ? kItself : author,
                         std::move(reason)};
    m_way.keep([&](StoreWriter::Done answer) { m_links.writer.submit(std::move(record), std::move(answer)); },
               [stored = std::move(stored)](const Receipt& receipt) {
                   if (stored) stored(receipt);
               },
               {});
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
    next.revision = m_asked.from(m_view.setup).revision + 1;
    const auto store = [&](StoreWriter::Done stored) {
        m_asked.ask(next);
        m_recipes.begin(recipeName(), records::setupToJson(m_view.setup), kItself);
        m_recipes.keep(
            recipeName(), records::setupToJson(next), author, reason, restoredFrom,
            [this, alive = std::weak_ptr(m_alive), stored = std::move(stored)](const Result<Receipt>& receipt) {
                if (alive.lock()) {
                    m_asked.answered();
                    stored(receipt);
                }
            });
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
        keep(records::kLearnt, records::learntToJson({records::utcNow_ms(), m_live->model.fingerprint, measurement}),
             {}, "learnt");
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
    ThermalShiftRow row{records::utcNow_ms(), minute.minutes, {}, {}};
    bool same = !m_view.shifts.empty();
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        row.shift_um[axis] = std::round(static_cast<double>(minute.shift_um[axis]));
        row.drift_um[axis] = static_cast<double>(minute.drift_um[axis]);
        same = same && row.shift_um[axis] == m_view.shifts.front().shift_um[axis];
    }
    if (same) return;
    putFirst(m_view.shifts, row);
    m_unwritten.push_back(row);
}

void StoredThermalService::takeGap(const ThermalStatus& status) {
    if (status.gap.phase == GapPhase::Done && status.gap.number != m_gapSeen) {
        m_gapSeen = status.gap.number;
        ThermalGapRow row{records::utcNow_ms(), status.gap.measured_um,     status.gap.predicted_um,
                          status.gap.half_um,   status.gap.predictionKnown, status.gap.byPart,
                          status.gap.known};
        row.allowed_um = m_view.setup.allowed_um;
        row.leftKnown = row.byPart || std::ranges::all_of(status.shifted_um, &Reading::good);
        for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
            row.left_um[axis] = row.byPart      ? m_partDeviation_um[axis]
                                : row.leftKnown ? row.measured_um[axis] + status.shifted_um[axis].value
                                                : 0.0;
        }
        putFirst(m_view.gaps, row);
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

void StoredThermalService::writeShifts(bool now) {
    const std::int64_t time_ms = records::utcNow_ms();
    if (m_unwritten.empty() || (!now && time_ms - m_lastWrite_ms < kWriteEvery_ms)) return;
    m_lastWrite_ms = time_ms;
    keep(records::kShifts, records::shiftsToJson(m_unwritten), {}, "followed");
    m_unwritten.clear();
}

}  // namespace kerf
