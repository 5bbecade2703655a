// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>

#include "app/files/text_encoding.h"
#include "app/files/thermal_files.h"
#include "app/files/thermal_model_json.h"
#include "app/service/thermal/thermal_records.h"
#include "app/service/thermal/thermal_service.h"
#include "engine/process/thermal/plant/simulated_day.h"

/// Models: the days they are trained on, the sessions recorded for them, the one that is live and the one before it.
namespace kerf {
namespace {

namespace records = thermal_records;

constexpr std::uint32_t kModelsRead = 2;
constexpr const char* kBuiltInDays = "built-in:";
constexpr const char* kFile = "file:";
constexpr const char* kSession = "session:";
constexpr const char* kOut = R"({"left_out":true})";
constexpr const char* kIn = R"({"left_out":false})";

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

void StoredThermalService::trainFirst() {
    if (!m_live && builtInHeat()) {
        m_firstModel = true;
        std::vector<std::string> days;
        for (const ThermalDayView& day : m_view.days) {
            if (day.id.starts_with(kBuiltInDays) && !day.leftOut) days.push_back(day.id);
        }
        (void)train("hierarchical", days);
    }
}

void StoredThermalService::loadSessions(const std::vector<RoomRecordRow>& rows) {
    for (const RoomRecordRow& row : rows) {
        if (auto day = records::sessionFromJson(row.bodyJson)) {
            m_sessions.emplace_back(kSession + std::to_string(row.id), std::move(*day));
        }
    }
}

void StoredThermalService::loadMemory(RoomRecordReader& reader) {
    auto rows = reader.newestRoomRecords(ProcessId::Thermal, records::kMemory);
    if (!rows) return m_way.setStoreProblem(rows.error());
    for (RoomRecordRow& row : *rows) {
        m_told.insert_or_assign(row.subject, std::move(row));
    }
}

void StoredThermalService::leaveOut(const std::string& dayId, bool out, const std::string& author,
                                    const std::string& reason, RecipeHistory::Done done) {
    Result<void> may = permitted(m_links.rights, author, Deed::ThermalMemory, reason);
    if (may && std::ranges::find(m_view.days, dayId, &ThermalDayView::id) == m_view.days.end()) {
        may = fail(KERF_TEXT("One of the days is not there any more."));
    }
    RoomRecordRow row;
    row.subject = dayId;
    row.bodyJson = out ? kOut : kIn;
    row.author = author;
    row.reason = reason;
    m_way.change(
        may,
        [this, &row](StoreWriter::Done stored) {
            m_links.writer.submit(
                AddRoomRecord{ProcessId::Thermal, records::kMemory, row.subject, row.bodyJson, row.author, row.reason},
                std::move(stored));
        },
        [this, row](const Receipt&) {
            m_told[row.subject] = row;
            findDays();
        },
        std::move(done));
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

Result<void> StoredThermalService::makeLive(KeptModel model, const std::string& author, std::string reason) {
    const std::vector<std::string> names = channelNames();
    if (const auto fits = LiveModel::make(model.model, names, 0); !fits) {
        return tl::unexpected(fits.error());
    }
    model.card.author = author;
    model.card.createdUtc_ms = records::utcNow_ms();
    std::string body = formats::thermalModelToJson(model.model);
    const auto shared = std::make_shared<KeptModel>(std::move(model));
    keep(records::kModel, std::move(body), author, std::move(reason), [this, shared](const Receipt&) {
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
    for (ThermalDayView& day : m_view.days) {
        if (const auto told = m_told.find(day.id); told != m_told.end()) {
            day.leftOut = told->second.bodyJson == kOut;
            day.leftOutReason = told->second.reason;
            day.leftOutAuthor = told->second.author;
        }
    }
    changed();
}

Result<void> StoredThermalService::train(const std::string& kind, const std::vector<std::string>& dayIds) {
    if (m_trainer.running()) return fail(KERF_TEXT("A model is being trained."));
    if (dayIds.empty()) return fail(KERF_TEXT("Choose at least one day to train on."));
    for (const ThermalDayView& day : m_view.days) {
        if (day.leftOut && std::ranges::find(dayIds, day.id) != dayIds.end()) {
            return fail(KERF_TEXT("One of the days is left out of the training: take it in again first."));
        }
    }
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
    keep(records::kSession, records::sessionToJson(day), author, "recorded", [this, day](const Receipt& kept) {
        const auto known =
            std::ranges::find(m_sessions, kSession + day.label, &decltype(m_sessions)::value_type::first);
        if (known != m_sessions.end()) known->first = kSession + std::to_string(kept.id);  // as after a restart
        findDays();
    });
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
        if (m_firstModel) (void)goLive(kItself);
    }
    m_firstModel = false;
    changed();
}

}  // namespace kerf
