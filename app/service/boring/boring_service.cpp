// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/boring/boring_service.h"

#include <algorithm>

#include "app/service/boring/boring_view.h"
#include "engine/process/boring/boring_alarms.h"

namespace kerf {
namespace {

constexpr const char* kControlAuthor = "control";
constexpr const char* kUndone = "undone";

Sentence lookAtTheNewest() {
    return Sentence(KERF_TEXT("This value was replaced or taken out meanwhile; look at the newest one first."));
}

const WorkOrder& namedOrder(const Status& status) {
    return status.orders[static_cast<std::size_t>(ProcessId::Boring)];
}

}  // namespace

Result<std::unique_ptr<StoredBoringService>> StoredBoringService::open(const Links& links, LotReader& reader,
                                                                       LotId lot) {
    const auto history = reader.history(lot);
    if (!history) {
        return tl::unexpected(history.error());
    }
    if (!*history) {
        return fail(KERF_TEXT("There is no such lot."));
    }
    const auto recipe = recipeFromJson((*history)->recipe.parametersJson);
    if (!recipe) {
        return tl::unexpected(recipe.error());
    }
    const auto kind = boring::estimatorOf((*history)->lot.estimator);
    if (!kind) {
        return fail(KERF_TEXT("The lot asks for an estimator that this program does not have."));
    }
    BoringMemoryBasis basis;
    if (links.records != nullptr) {
        auto read = readBoringMemory(reader, *links.records, (*history)->lot);
        if (!read) {
            return tl::unexpected(read.error());
        }
        basis = std::move(*read);
    }
    return std::unique_ptr<StoredBoringService>(new StoredBoringService(links, **history, *recipe, *kind, basis));
}

StoredBoringService::StoredBoringService(const Links& links, const LotHistory& history, BoringRecipe recipe,
                                         boring::EstimatorKind kind, const BoringMemoryBasis& basis)
    : m_links(links),
      m_lot(history.lot),
      m_recipeRevision(history.recipe.revision),
      m_kind(kind),
      m_records(recipe, kind, links.records != nullptr ? lotBegin(basis, recipe) : boring::LotBegin{}) {
    m_hasMemory = links.records != nullptr && recipe.usesMemory() && kind == boring::EstimatorKind::Kalman;
    m_view.revision = links.firstRevision;
    m_records.setAnnounced(basis.announced);
    restore(history);
    m_partsSubscription = m_links.writer.onPartStored([this](const StoredPart& part) { partStored(part); });
    m_problemSubscription = m_links.writer.onProblemChanged([this] {
        if (m_links.writer.problem().empty()) {
            m_way.setStoreProblem({});
        }
        rebuild();
        m_listeners.tell();
    });
    compareWithStored(history);
    propose();
    rebuild();
    send();
}

void StoredBoringService::restore(const LotHistory& history) {
    for (const PartDetail& detail : history.parts) {
        m_records.addPart(servicePartOf(detail));
    }
    m_records.restoreRows(history.measurements);
    for (const ScheduleRow& row : history.schedules) {
        if (row.schedule.revision == 0) {
            continue;  // cut before a schedule was loaded
        }
        if (!row.predictionJson.empty()) {
            m_predictions[row.schedule.revision] = predictionsFromJson(row.predictionJson);
        }
        m_next = row.schedule;
        if (!row.acceptedBy.empty()) {
            m_accepted = row.schedule;
        }
    }
}

void StoredBoringService::compareWithStored(const LotHistory& history) {
    if (m_records.tracker().fromMemory() || !m_records.tracker().announced().empty()) {
        return;  // a correction in an earlier lot, or one left out, rightly changes all that follows from it
    }
    const bool stateSame = history.lastState
                               ? history.lastState->stateJson == stateJson(m_records.tracker().measuredState())
                               : m_records.tracker().steps().empty();
    const bool scheduleSame = m_next.revision == 0 || sameLaw(m_next, m_records.advice().schedule);
    if (!stateSame || !scheduleSame) {
        m_restartFinding =
            Sentence(KERF_TEXT("Lot %1 was computed again from its measurements and differs from the stored state."),
                     SentenceArg(m_lot.name));
        const AlarmSpec& spec = boring_alarm::kRestartDiffers;
        m_links.writer.submit(RaiseAlarm{spec.code, spec.priority, m_restartFinding}, {});
    }
}

void StoredBoringService::propose() {
    BoringSchedule schedule = m_records.advice().schedule;
    if (m_next.revision != 0 && sameLaw(schedule, m_next)) {
        return;
    }
    schedule.revision = m_next.revision + 1;
    ScheduleRow row = scheduleRow(m_records, schedule);
    const bool first = m_records.tracker().steps().empty();  // the recipe's own feed: nothing to decide
    if (first) {
        row.acceptedBy = kControlAuthor;
    }
    adopt(schedule, m_records.predictionFor(schedule), !row.acceptedBy.empty());
    m_links.writer.submit(StoreSchedule{row}, [this, alive = std::weak_ptr(m_alive)](const Result<Receipt>& receipt) {
        if (alive.lock() && !receipt) {
            m_way.setStoreProblem(receipt.error());
            rebuild();
            m_listeners.tell();
        }
    });
}

LoopMode StoredBoringService::mode() const {
    return m_links.mode ? m_links.mode()
                        : m_links.engine.status().loops[static_cast<std::size_t>(ProcessId::Boring)].mode;
}

EntryCheck StoredBoringService::check(const BoreEntry& entry) const {
    if (entry.depth < m_records.recipe().depths.size() && m_records.measured(entry.part, entry.depth) != nullptr) {
        return {EntryVerdict::Refuse, Sentence(KERF_TEXT("This bore has a value already; correct that one instead."))};
    }
    return m_records.check(entry.part, entry.depth, entry.diameter_mm);
}

Result<MeasurementRow> StoredBoringService::entryRow(const BoreEntry& entry) const {
    if (const auto may = permitted(m_links.rights, entry.author, Deed::BoringDiameter); !may) {
        return tl::unexpected(may.error());
    }
    const EntryCheck verdict = check(entry);
    if (verdict.verdict == EntryVerdict::Refuse || (verdict.verdict == EntryVerdict::Ask && !entry.confirmed)) {
        return tl::unexpected(verdict.reason);
    }
    MeasurementRow row;
    row.part = entry.part;
    row.station = entry.depth;
    row.position_mm = m_records.recipe().depths[entry.depth].overhang_mm;
    row.diameter_mm = entry.diameter_mm;
    row.source = entry.fromGauge ? MeasurementSource::Gauge : MeasurementSource::Keypad;
    row.sourceName = entry.fromGauge ? entry.gauge : std::string();
    row.confirmed = verdict.verdict == EntryVerdict::Ask;
    row.author = entry.author;
    return row;
}

void StoredBoringService::enter(const BoreEntry& entry, Done done) {
    queueOne([this, entry] { return entryRow(entry); }, std::move(done));
}

EntryCheck StoredBoringService::checkCorrection(MeasurementId id, double diameter_mm) const {
    const MeasurementRow* old = m_records.standing(id);
    return old != nullptr ? m_records.check(old->part, old->station, diameter_mm)
                          : EntryCheck{EntryVerdict::Refuse, lookAtTheNewest()};
}

Result<MeasurementRow> StoredBoringService::correctedRow(const BoreCorrection& correction) const {
    const MeasurementRow* old = m_records.standing(correction.id);
    if (old == nullptr) {
        return tl::unexpected(lookAtTheNewest());
    }
    if (const auto may = permitted(m_links.rights, correction.author, Deed::BoringCorrection, correction.reason);
        !may) {
        return tl::unexpected(may.error());
    }
    const EntryCheck verdict = m_records.check(old->part, old->station, correction.diameter_mm);
    const bool asked = verdict.verdict == EntryVerdict::Ask;
    if (verdict.verdict == EntryVerdict::Refuse || (asked && !correction.confirmed)) {
        return tl::unexpected(verdict.reason);
    }
    MeasurementRow row = *old;
    row.kind = MeasurementKind::Correction;
    row.replaces = correction.id;
    row.diameter_mm = correction.diameter_mm;
    row.source = correction.fromGauge ? MeasurementSource::Gauge : MeasurementSource::Keypad;
    row.sourceName = correction.fromGauge ? correction.gauge : std::string();
    row.confirmed = asked;
    row.author = correction.author;
    row.reason = correction.reason;
    return row;
}

void StoredBoringService::correctValue(const BoreCorrection& correction, Done done) {
    queueOne([this, correction] { return correctedRow(correction); }, std::move(done));
}

void StoredBoringService::correct(MeasurementId id, double diameter_mm, const std::string& author,
                                  const std::string& reason, Done done) {
    correctValue({id, diameter_mm, author, reason, false, false, {}}, std::move(done));
}

void StoredBoringService::voidMeasurement(MeasurementId id, const std::string& author, const std::string& reason,
                                          Done done) {
    queueOne(
        [=, this]() -> Result<MeasurementRow> {
            const MeasurementRow* old = m_records.standing(id);
            if (old == nullptr) {
                return tl::unexpected(lookAtTheNewest());
            }
            if (const auto may = permitted(m_links.rights, author, Deed::BoringCorrection, reason); !may) {
                return tl::unexpected(may.error());
            }
            MeasurementRow row = *old;
            row.kind = MeasurementKind::Void;
            row.replaces = id;
            row.diameter_mm.reset();
            row.confirmed = false;
            row.author = author;
            row.reason = reason;
            return row;
        },
        std::move(done));
}

void StoredBoringService::undoLast(const std::string& author, Done done) {
    if (m_way.busy() || !m_waiting.empty()) {
        return answer(done, fail(KERF_TEXT("A value is being stored; try again in a moment.")));
    }
    const auto newest = m_records.newestStanding();
    if (!newest) {
        return answer(done, fail(KERF_TEXT("There is no measurement to undo.")));
    }
    voidMeasurement(*newest, author, kUndone, std::move(done));
}

void StoredBoringService::queueOne(std::function<Result<MeasurementRow>()> row, Done done) {
    queue({[row = std::move(row)]() -> Rows {
               const Result<MeasurementRow> made = row();
               return made ? Rows(std::vector<MeasurementRow>{*made}) : Rows(tl::unexpected(made.error()));
           },
           std::move(done)});
}

void StoredBoringService::queue(Change change) {
    m_waiting.push_back(std::move(change));
    runNext();
}

void StoredBoringService::runNext() {
    while (!m_way.busy() && !m_waiting.empty()) {
        const Change change = std::move(m_waiting.front());
        m_waiting.pop_front();
        Rows rows = change.rows();
        if (rows) {
            submit(std::move(*rows), change.done);
        } else {
            answer(change.done, tl::unexpected(rows.error()));
        }
    }
}

void StoredBoringService::submit(std::vector<MeasurementRow> rows, Done done) {
    if (rows.size() == 1) {
        rows.front().id = 0;  // not stored yet
    }
    LotRecords tried = m_records;
    AcceptMeasurements batch;
    for (const MeasurementRow& row : rows) {
        tried.addRow(row);
        batch.measurements.push_back({row, {}, {}});
    }
    AcceptMeasurement& command = batch.measurements.back();  // what follows from all of them is stored with the last
    command.states = tried.changedStates(m_records.tracker());
    BoringSchedule schedule = tried.advice().schedule;
    schedule.revision = m_next.revision + 1;
    const bool changed = !sameLaw(schedule, m_next);
    const bool accepted = mode() == LoopMode::Control || tried.tracker().steps().empty();
    Predictions predictions = tried.predictionFor(schedule);
    if (changed) {
        command.nextSchedule = scheduleRow(tried, schedule);
        command.nextSchedule->acceptedBy = accepted ? kControlAuthor : "";
    }
    keep(
        rows.size() == 1 ? StoreCommand(std::move(command)) : StoreCommand(std::move(batch)),
        [=, this](const Receipt& receipt) {
            MeasurementId id = receipt.id;
            for (MeasurementRow row : rows) {
                row.id = id++;
                m_records.addRow(row);
            }
            if (changed) {
                adopt(schedule, predictions, accepted);
            }
        },
        std::move(done));
}

void StoredBoringService::keep(StoreCommand command, std::function<void(const Receipt&)> then, Done done) {
    m_way.keep([this, &command](StoreWriter::Done stored) { m_links.writer.submit(std::move(command), stored); },
               [this, then = std::move(then)](const Receipt& receipt) {
                   then(receipt);
                   send();
               },
               [this, done = std::move(done)](const Result<void>& result) {
                   answer(done, result);
                   runNext();
               });
}

ScheduleRow StoredBoringService::scheduleRow(const LotRecords& records, const BoringSchedule& schedule) const {
    ScheduleRow row;
    row.lot = m_lot.id;
    row.schedule = schedule;
    row.predictionJson = predictionsJson(records.predictionFor(schedule));
    row.reason = records.reason().english();
    return row;
}

void StoredBoringService::adopt(const BoringSchedule& schedule, const Predictions& predictions, bool accepted) {
    m_next = schedule;
    m_predictions[schedule.revision] = predictions;
    if (accepted) {
        m_accepted = schedule;
    }
}

void StoredBoringService::acceptSchedule(const std::string& author, Done done) {
    if (const auto may = permitted(m_links.rights, author, Deed::BoringSchedule); !may) {
        return answer(done, may);
    }
    if (m_way.busy()) {
        return answer(done, fail(KERF_TEXT("A value is being stored; try again in a moment.")));
    }
    if (m_accepted && m_accepted->revision == m_next.revision) {
        return answer(done, {});
    }
    keep(
        AcceptSchedule{m_lot.id, m_next.revision, author},
        [this, schedule = m_next](const Receipt&) { m_accepted = schedule; }, std::move(done));
}

void StoredBoringService::send() {
    if (!m_retired && !m_lotNamed) {  // the next part is this lot's, also before a schedule of it is accepted
        m_way.owe(NameOrder{ProcessId::Boring, order(0)},
                  [named = order(0)](const Status& status) { return namedOrder(status) == named; });
        m_lotNamed = true;
    }
    if (!m_retired && m_accepted && m_accepted->revision != m_sentRevision) {
        // A part begun with it belongs to this lot, whichever is active when it ends.
        m_way.owe(LoadBoringSchedule{*m_accepted, order(m_accepted->revision)},
                  [named = order(m_accepted->revision)](const Status& status) {
                      return status.boring.nextSchedule == named.schedule && namedOrder(status) == named;
                  });
        m_sentRevision = m_accepted->revision;
    }
}

void StoredBoringService::poll() {
    send();
    if (!m_retired) {
        m_way.poll();
    }
    const bool waiting = !m_accepted || m_accepted->revision != m_next.revision;
    if (!m_retired && waiting && !m_way.busy() && mode() == LoopMode::Control) {
        acceptSchedule(kControlAuthor, {});
    }
}

void StoredBoringService::retire() {
    m_retired = true;
    m_partsSubscription.reset();
}

void StoredBoringService::partStored(const StoredPart& stored) {
    if (stored.lot != m_lot.id || stored.record.process != ProcessId::Boring || m_records.part(stored.id) != nullptr) {
        return;
    }
    m_records.addPart({stored.id, stored.number, stored.record.complete, stored.record.partSequence,
                       stored.record.schedule, stored.record.feed});
    rebuild();
    m_listeners.tell();
}

void StoredBoringService::announceChange(BoringChange change, const std::string& author, Done done) {
    const auto kind = change == BoringChange::Reground   ? boring::StretchKind::Reground
                      : change == BoringChange::Material ? boring::StretchKind::Material
                                                         : boring::StretchKind::Insert;
    tellChange(kind, author, std::move(done));
}

void StoredBoringService::withdrawChange(const std::string& author, Done done) {
    tellChange(std::nullopt, author, std::move(done));
}

void StoredBoringService::tellChange(std::optional<boring::StretchKind> kind, const std::string& author, Done done) {
    if (const auto may = permitted(m_links.rights, author, Deed::BoringChange); !may) {
        return answer(done, may);
    }
    if (!m_hasMemory) {
        return answer(done,
                      fail(KERF_TEXT("This lot does not begin from earlier ones; a change is found by its bores.")));
    }
    if (!idle()) {
        return answer(done, fail(KERF_TEXT("A value is being stored; try again in a moment.")));
    }
    const Status& status = m_links.engine.status();
    const bool boring = (status.program == ProgramState::Running || status.program == ProgramState::Paused) &&
                        status.programProcess == ProcessId::Boring;
    if (boring) {
        return answer(done, fail(KERF_TEXT("A part is being bored; announce the change when it is finished.")));
    }
    const std::uint32_t part = m_records.nextNumber();
    if (part == 1) {
        return answer(done, fail(KERF_TEXT("The first part of a lot counts as cut with a new tool already.")));
    }
    AddRoomRecord record{ProcessId::Boring,      kChangeRecord, std::to_string(m_lot.id),
                         changeJson(part, kind), author,        kind ? "announced" : "withdrawn"};
    keep(
        std::move(record),
        [=, this](const Receipt&) {
            auto announced = m_records.tracker().announced();
            std::erase_if(announced, [&](const auto& one) { return one.part == part; });
            if (kind) {
                announced.push_back({part, *kind});
            }
            m_records.setAnnounced(std::move(announced));
            propose();
        },
        std::move(done));
}

std::optional<double> StoredBoringService::gaugeReading_mm(PartId id, std::uint8_t depth) {
    const ServicePart* part = m_records.part(id);
    if (part == nullptr || depth >= m_records.recipe().depths.size() || !m_links.gauge) {
        return std::nullopt;
    }
    return m_links.gauge(*part, m_records.recipe(), m_records.recipe().depths[depth].overhang_mm);
}

std::unique_ptr<Subscription> StoredBoringService::onChanged(std::function<void()> changed) {
    return m_listeners.add(std::move(changed));
}

void StoredBoringService::rebuild() {
    BoringViewBasis basis{m_lot, m_records, m_predictions};
    basis.recipeRevision = m_recipeRevision;
    basis.kind = m_kind;
    basis.next = m_next;
    basis.accepted = m_accepted && m_accepted->revision == m_next.revision;
    basis.showsAnnounced = m_hasMemory;
    const std::uint64_t revision = m_view.revision + 1;
    m_view = boringView(basis);
    m_view.revision = revision;
    m_view.storeProblem = m_way.problem().empty() ? m_links.writer.problem() : m_way.problem();
}

}  // namespace kerf
