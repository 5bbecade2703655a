// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/quality/stored_quality_service.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "app/files/dfq_files.h"
#include "app/files/table.h"
#include "app/service/boring/boring_memory.h"
#include "app/service/change_way.h"
#include "app/service/quality/dfq_export.h"
#include "app/service/quality/gauge_records.h"
#include "app/service/quality/lot_dfq.h"
#include "db/readers/database_reader.h"

namespace kerf {
namespace {

constexpr std::uint32_t kMostRecords = 100'000;
constexpr std::uint32_t kMostAlarms = 1'000;
constexpr const char* kRulesChosen = "rules of the charts chosen";
constexpr std::int64_t kBeforeFirstPart_ms = 3'600'000;  // what went wrong while the first part was cut

std::int64_t now_ms() {
    using namespace std::chrono;
    return duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count();
}

quality::RuleSet rulesOf(SettingsReader& settings) {
    const auto stored = settings.setting(kChartRules);
    return stored && *stored ? rulesFromText(**stored) : quality::kDefaultRules;
}

quality::ChartParams chartParams(SettingsReader& settings) {
    quality::ChartParams params;
    params.active = rulesOf(settings);
    return params;
}

std::optional<PartId> newestPart(db::DatabaseReader& reader, LotId lot, ProcessId process) {
    if (lot > 0) {
        const auto newest = reader.newestParts(lot, 1, {});
        return newest && *newest && !(*newest)->parts.empty() ? std::optional((*newest)->parts.back().part.id)
                                                              : std::nullopt;
    }
    PartQuery query;
    query.process = process;
    query.limit = 1;
    const auto newest = reader.parts(query);
    return newest && !newest->empty() ? std::optional(newest->front().id) : std::nullopt;
}

/// The newest lots of a part type, until `count` parts are there.
Result<QualityLot> readAllLots(db::DatabaseReader& reader, PartTypeId type, std::uint32_t count) {
    constexpr std::uint32_t kMostLots = 200;
    const auto lots = reader.lots(type, kMostLots);
    if (!lots) {
        return tl::unexpected(lots.error());
    }
    const bool firstLook = count == kFirstLook_parts;
    std::vector<LotQuality> read;
    bool more = false;
    for (const LotRow& row : *lots) {
        more = count == 0;
        if (more) {
            break;
        }
        auto lot = readQualityLot(reader, row.id, count);
        if (!lot) {
            return tl::unexpected(lot.error());
        }
        if (!lot->quality.parts.empty()) {
            count -= std::min(count, static_cast<std::uint32_t>(lot->quality.parts.size()));
            more = lot->quality.olderParts;
            read.push_back(std::move(lot->quality));
        }
    }
    if (read.empty()) {
        return fail(KERF_TEXT("The lots have no parts yet."));
    }
    std::ranges::reverse(read);
    QualityLot result{{}, joinLots(std::move(read), chartParams(reader))};
    result.history.lot = result.quality.lot;
    result.quality.olderParts = more && firstLook;  // all of them follow; their pages end with what is read at once
    return result;
}

}  // namespace

std::string rulesText(const quality::RuleSet& rules) {
    std::string text;
    for (std::size_t i = 0; i < quality::kRules; ++i) {
        if (rules[i]) {
            text += text.empty() ? "" : ",";
            text += quality::ruleKey(static_cast<quality::Rule>(i));
        }
    }
    return text;
}

quality::RuleSet rulesFromText(std::string_view text) {
    quality::RuleSet rules;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(','), text.size());
        if (const auto rule = quality::ruleOf(text.substr(0, end))) {
            rules[static_cast<std::size_t>(*rule)] = true;
        }
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return rules;
}

Result<QualityLot> readQualityLot(db::DatabaseReader& reader, LotId lot, std::uint32_t count,
                                  std::optional<PartId> last) {
    if (const auto type = partTypeOfAllLots(lot)) {
        return readAllLots(reader, *type, count);
    }
    LotHistory history;
    std::vector<boring::AnnouncedChange> announced;
    if (lot < 0) {
        history.lot.id = lot;
        history.lot.process = static_cast<ProcessId>(-1 - lot);
        PartQuery query;
        query.process = history.lot.process;
        query.limit = count;
        query.before = last ? std::optional(*last + 1) : std::nullopt;
        auto parts = reader.parts(query);
        if (!parts) {
            return tl::unexpected(parts.error());
        }
        std::ranges::reverse(*parts);
        for (PartRow& part : *parts) {
            history.parts.emplace_back().part = std::move(part);
        }
    } else {
        auto found = reader.newestParts(lot, count, last);
        if (!found) {
            return tl::unexpected(found.error());
        }
        if (!*found) {
            return fail(KERF_TEXT("There is no such lot."));
        }
        history = std::move(**found);
        auto changes = announcedIn(reader, lot);
        if (!changes) {
            return tl::unexpected(changes.error());
        }
        announced = std::move(*changes);
    }
    QualityLot result{std::move(history), {}};
    const ProcessId process = result.history.lot.process;
    result.quality = analyseLot(result.history, recipeLimits(reader, reader, process), announced, chartParams(reader));
    if (const auto& parts = result.history.parts; !parts.empty()) {
        result.quality.olderParts = parts.size() == count && parts.front().part.number > 1;
        result.quality.newerParts = last && newestPart(reader, lot, result.history.lot.process) != parts.back().part.id;
    }
    return result;
}

Result<QualityLot> readQualityLot(const std::string& databasePath, LotId lot, std::uint32_t count,
                                  std::optional<PartId> last) {
    const auto reader = db::DatabaseReader::open(databasePath);
    if (!reader) {
        return tl::unexpected(reader.error());
    }
    return readQualityLot(**reader, lot, count, last);
}

/// The first part of a lot that is complete, as a lot of one.
Result<QualityLot> readFirstPart(db::DatabaseReader& reader, LotId lot) {
    auto read = readQualityLot(reader, lot, 1);
    if (!read) {
        return read;
    }
    PartQuery query;
    query.process = read->history.lot.process;
    query.lot = lot > 0 ? std::optional(lot) : std::nullopt;
    query.oldestFirst = true;
    query.limit = 1;
    const auto first = reader.parts(query);
    if (!first || first->empty()) {
        return first ? fail(KERF_TEXT("The lot has no parts yet.")) : Result<QualityLot>(tl::unexpected(first.error()));
    }
    const auto detail = reader.part(first->front().id);
    if (!detail || !*detail) {
        return fail(KERF_TEXT("There is no such part."));
    }
    read->history.parts = {**detail};
    read->history.measurements = (*detail)->part.measurements;
    read->quality = analyseLot(read->history, recipeLimits(reader, reader, read->history.lot.process));
    return read;
}

Result<void> readLotPapers(db::DatabaseReader& reader, const QualityLot& lot, LotPapers& papers) {
    if (lot.history.parts.empty()) {
        return {};
    }
    const std::int64_t from_ms =
        std::max(lot.history.lot.openedUtc_ms, lot.history.parts.front().part.endedUtc_ms - kBeforeFirstPart_ms);
    std::int64_t to_ms = lot.history.parts.back().part.endedUtc_ms;
    for (const MeasurementRow& row : lot.history.measurements) {
        to_ms = std::max(to_ms, row.acceptedUtc_ms);
    }
    const auto alarms = reader.alarms(std::nullopt, kMostAlarms);
    if (!alarms) {
        return tl::unexpected(alarms.error());
    }
    for (const AlarmRow& row : *alarms) {
        if (row.raisedUtc_ms >= from_ms && row.raisedUtc_ms <= to_ms) {
            papers.alarms.push_back(row);
        }
    }
    std::ranges::reverse(papers.alarms);
    if (lot.history.lot.process == ProcessId::Boring && lot.history.lot.id > 0) {
        const auto rows =
            reader.roomRecords(ProcessId::Boring, kChangeRecord, std::to_string(lot.history.lot.id), kMostRecords);
        for (const RoomRecordRow& row : rows ? *rows : std::vector<RoomRecordRow>{}) {
            const auto json = nlohmann::json::parse(row.bodyJson, nullptr, false);
            if (json.is_object()) {
                papers.changes.emplace_back(json.value("part", 0U), json.value("change", ""));
            }
        }
        std::ranges::reverse(papers.changes);
    }
    const auto head = reader.audit(std::nullopt, 1);
    if (!head) {
        return tl::unexpected(head.error());
    }
    if (!head->empty()) {
        papers.auditEntry = head->front().id;
        papers.auditHash = head->front().hash;
    }
    return {};
}

StoredQualityService::StoredQualityService(Links links)
    : m_links(std::move(links)), m_judge(m_links.lots, m_links.records) {
    readRecords();
}

void StoredQualityService::readRecords() {
    const auto folder = m_links.settings.setting(kDfqFolder);
    const auto pattern = m_links.settings.setting(kDfqPattern);
    m_files = {folder && *folder ? **folder : std::string(), pattern && *pattern ? **pattern : kDfqPatternStandard};
    if (const auto rows = m_links.records.roomRecords(ProcessId::Boring, kGaugeRecord, {}, kMostRecords)) {
        for (const RoomRecordRow& row : *rows) {  // newest first: the first of an identity holds
            const auto gauge = gaugeFromJson(row.bodyJson);
            if (gauge && std::ranges::find(m_gauges, gauge->identity, &Gauge::identity) == m_gauges.end()) {
                m_gauges.push_back(*gauge);
            }
        }
        std::ranges::sort(m_gauges, {}, &Gauge::identity);
    }
    m_dispositions = dispositionsIn(m_links.records);
}

void StoredQualityService::tell() {
    for (const auto& changed : m_listeners) {
        changed();
    }
}

void StoredQualityService::want(const Wish& wish) {
    m_wanted = wish;
    m_again = m_reading;
    if (!m_reading) {
        // Another lot: first what the charts show, then the rest.
        const bool fresh = m_lot == nullptr || m_lot->lot.id != wish.lot;
        read(fresh ? Wish{wish.lot, wish.last, kFirstLook_parts} : wish);
    }
}

// One at a time: the newest wish is read when this one is there.
void StoredQualityService::read(const Wish& wish) {
    m_reading = true;
    const auto read = std::make_shared<LotQuality>();
    m_links.background(
        [path = m_links.databasePath, wish, read]() -> Result<void> {
            auto result = readQualityLot(path, wish.lot, wish.count, wish.last);
            if (!result) {
                return tl::unexpected(result.error());
            }
            *read = std::move(result->quality);
            return {};
        },
        [this, wish, read](const Result<void>& done) {
            m_reading = false;
            m_problem = done ? Sentence{} : done.error();
            if (done) {
                m_lot = read;
            }
            // After a first look the rest, when there is more.
            const bool more = done && wish.count == kFirstLook_parts && read->olderParts;
            tell();
            if ((std::exchange(m_again, false) || more) && !m_reading && m_wanted) {
                this->read(*m_wanted);
            }
        });
}

void StoredQualityService::store(AddRoomRecord record, std::function<void()> kept, Done done) {
    m_links.writer.submit(std::move(record), [this, kept = std::move(kept), done](const Result<Receipt>& stored) {
        if (stored) {
            kept();
            tell();
        }
        if (done) {
            done(stored ? Result<void>() : Result<void>(tl::unexpected(stored.error())));
        }
    });
}

void StoredQualityService::dispose(PartId part, const std::string& what, const std::string& author, Done done) {
    if (const auto may = permitted(m_links.rights, author, Deed::QualityDecision); !may) {
        done(may);
        return;
    }
    const ProcessId process = m_lot ? m_lot->lot.process : ProcessId::Boring;
    const nlohmann::json body{{"what", what}};
    store(
        {process, kDispositionRecord, std::to_string(part), body.dump(), author, what},
        [this, part, what, author] {
            m_dispositions[part] = {what, author, now_ms()};
        },
        std::move(done));
}

std::function<VerdictOf()> StoredQualityService::openVerdicts() {
    return [path = m_links.databasePath]() -> VerdictOf {
        auto opened = db::DatabaseReader::open(path);
        if (!opened) {
            return {};
        }
        const std::shared_ptr<db::DatabaseReader> reader = std::move(*opened);
        const auto judge = std::make_shared<PartJudge>(*reader, *reader);
        return [reader, judge, verdict = judge->forExport()](const PartRow& part, std::string_view key) {
            return verdict(part, key);
        };
    };
}

std::string StoredQualityService::limitsPartType(ProcessId process) {
    return m_links.recipe ? m_links.recipe(process).partType : std::string();
}

void StoredQualityService::setLimits(ProcessId process, const std::vector<FigureLimit>& limits,
                                     const std::string& author, const std::string& reason, Done done) {
    if (const auto may = permitted(m_links.rights, author, Deed::QualityLimits, reason); !may) {
        done(may);
        return;
    }
    const std::string body = limitsJson(limits);
    if (const auto valid = limitsFromJson(process, body); !valid) {
        done(tl::unexpected(valid.error()));
        return;
    }
    const RecipeHeld held = m_links.recipe ? m_links.recipe(process) : RecipeHeld{};
    if (held.partType.empty()) {
        done(fail(KERF_TEXT("There is no part type yet whose recipe could hold limits.")));
        return;
    }
    // What it works by becomes its first revision, when it has none yet.
    m_links.writer.submit(EnsurePartType{process, held.partType, held.parametersJson, kItself}, {});
    const std::string alone = nlohmann::ordered_json{{kFigureLimits, nlohmann::ordered_json::parse(body)}}.dump();
    m_links.writer.submit(KeepRecipe{process, held.partType, alone, author, reason, {}},
                          [this, process, done](const Result<Receipt>& stored) {
                              if (stored) {
                                  if (m_links.revised) {
                                      m_links.revised(process, stored->id);
                                  }
                                  m_judge.forget();
                                  if (m_wanted) {
                                      want(*m_wanted);
                                  }
                                  tell();
                              }
                              done(stored ? Result<void>() : Result<void>(tl::unexpected(stored.error())));
                          });
}

void StoredQualityService::saveGauge(const Gauge& gauge, const std::string& author, Done done) {
    if (const auto may = permitted(m_links.rights, author, Deed::QualityGauge); !may) {
        done(may);
        return;
    }
    if (const auto why = whyInvalid(gauge)) {
        done(tl::unexpected(*why));
        return;
    }
    keepGauge(gauge, author, std::move(done));
}

void StoredQualityService::keepGauge(const Gauge& gauge, const std::string& author, Done done) {
    store(
        {ProcessId::Boring, kGaugeRecord, gauge.identity, gaugeJson(gauge), author, {}},
        [this, gauge] {
            std::erase_if(m_gauges, [&](const Gauge& other) { return other.identity == gauge.identity; });
            m_gauges.push_back(gauge);
            std::ranges::sort(m_gauges, {}, &Gauge::identity);
        },
        std::move(done));
}

void StoredQualityService::saveStudy(const GaugeStudyRecord& study, const std::string& author, Done done) {
    if (const auto may = permitted(m_links.rights, author, Deed::QualityStudy); !may) {
        done(may);
        return;
    }
    const auto gauge = std::ranges::find(m_gauges, study.gauge, &Gauge::identity);
    if (gauge == m_gauges.end()) {
        done(fail(KERF_TEXT("There is no such gauge.")));
        return;
    }
    const auto finding = findingOf(study, gauge->ring_mm);
    if (!finding) {
        done(tl::unexpected(finding.error()));
        return;
    }
    Gauge updated = *gauge;
    GaugeStudyRecord signedOne = study;
    signedOne.author = author;
    signedOne.utc_ms = now_ms();
    takeOver(signedOne, *finding, updated);
    store(
        {ProcessId::Boring, kStudyRecord, study.gauge, studyJson(study, *finding), author, {}}, [] {},
        [this, updated, author, done](const Result<void>& stored) {
            stored ? keepGauge(updated, author, done) : done(stored);
        });
}

void StoredQualityService::writeReport(LotId lot, bool firstArticle, const std::string& file, Done done) {
    if (partTypeOfAllLots(lot)) {
        return done(fail(KERF_TEXT("Choose one lot: a report and its files are of one.")));
    }
    LotPapers papers;
    papers.firstArticle = firstArticle;
    papers.dispositions = m_dispositions;
    papers.gauges = m_gauges;
    m_links.background(
        [path = m_links.databasePath, lot, file, report = m_links.makeReport(), papers]() mutable -> Result<void> {
            const auto reader = db::DatabaseReader::open(path);
            if (!reader) {
                return tl::unexpected(reader.error());
            }
            auto read = papers.firstArticle ? readFirstPart(**reader, lot) : readQualityLot(**reader, lot);
            if (!read) {
                return tl::unexpected(read.error());
            }
            if (const auto filled = readLotPapers(**reader, *read, papers); !filled) {
                return filled;
            }
            return report(*read, papers, file);
        },
        std::move(done));
}

void StoredQualityService::setDfqFiles(const DfqFiles& files, const std::string& author, Done done) {
    if (const auto may = permitted(m_links.rights, author, Deed::QualityFiles); !may) {
        done(may);
        return;
    }
    if (const auto why = files.folder.empty() ? std::nullopt : whyNoPattern(files.pattern)) {
        done(tl::unexpected(*why));
        return;
    }
    m_links.writer.submit(ChangeSetting{kDfqPattern, files.pattern, author, {}}, {});
    m_links.writer.submit(ChangeSetting{kDfqFolder, files.folder, author, {}},
                          [this, files, done](const Result<Receipt>& stored) {
                              if (stored) {
                                  m_files = files;
                                  tell();
                              }
                              done(stored ? Result<void>() : Result<void>(tl::unexpected(stored.error())));
                          });
}

quality::RuleSet StoredQualityService::rules() {
    return rulesOf(m_links.settings);
}

void StoredQualityService::setRules(const quality::RuleSet& rules, const std::string& author, Done done) {
    if (const auto may = permitted(m_links.rights, author, Deed::QualityLimits, kRulesChosen); !may) {
        done(may);
        return;
    }
    m_links.writer.submit(ChangeSetting{kChartRules, rulesText(rules), author, kRulesChosen},
                          [this, done](const Result<Receipt>& stored) {
                              if (stored && m_wanted) {
                                  want(*m_wanted);
                              }
                              done(stored ? Result<void>() : Result<void>(tl::unexpected(stored.error())));
                          });
}

void StoredQualityService::writeDfq(LotId lot, const std::string& file, Done done) {
    if (partTypeOfAllLots(lot)) {
        return done(fail(KERF_TEXT("Choose one lot: a report and its files are of one.")));
    }
    m_links.background(
        [path = m_links.databasePath, lot, file]() -> Result<void> {
            const auto read = readQualityLot(path, lot);
            if (!read) {
                return tl::unexpected(read.error());
            }
            try {
                headless::writeDfqFile(file, lotDfq(read->history, read->quality));
            } catch (const headless::BadInput&) {
                return fail(KERF_TEXT("The file cannot be written there. Choose another folder."));
            }
            return {};
        },
        std::move(done));
}

}  // namespace kerf
