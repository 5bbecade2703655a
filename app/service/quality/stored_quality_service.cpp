// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/quality/stored_quality_service.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "app/files/dfq_files.h"
#include "app/files/table.h"
#include "app/service/quality/gauge_records.h"
#include "app/service/quality/lot_dfq.h"
#include "db/readers/database_reader.h"

namespace kerf {
namespace {

constexpr std::uint32_t kMostRecords = 100'000;

std::int64_t now_ms() {
    using namespace std::chrono;
    return duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count();
}

}  // namespace

Result<QualityLot> readQualityLot(const std::string& databasePath, LotId lot) {
    const auto reader = db::DatabaseReader::open(databasePath);
    if (!reader) {
        return tl::unexpected(reader.error());
    }
    auto history = (*reader)->history(lot);
    if (!history) {
        return tl::unexpected(history.error());
    }
    if (!*history) {
        return fail(KERF_TEXT("There is no such lot."));
    }
    const ProcessId process = (*history)->lot.process;
    std::vector<FigureLimit> limits = standardLimits(process);
    if (const auto records = (*reader)->roomRecords(process, kFigureLimits, {}, 1); records && !records->empty()) {
        const auto stored = limitsFromJson(process, records->front().bodyJson);
        if (!stored) {
            return tl::unexpected(stored.error());
        }
        limits = *stored;
    }
    QualityLot result{std::move(**history), {}};
    result.quality = analyseLot(result.history, limits);
    return result;
}

StoredQualityService::StoredQualityService(Links links) : m_links(std::move(links)) {
    readRecords();
}

void StoredQualityService::readRecords() {
    if (const auto rows = m_links.records.roomRecords(ProcessId::Boring, kGaugeRecord, {}, kMostRecords)) {
        for (const RoomRecordRow& row : *rows) {  // newest first: the first of an identity holds
            const auto gauge = gaugeFromJson(row.bodyJson);
            if (gauge && std::ranges::find(m_gauges, gauge->identity, &Gauge::identity) == m_gauges.end()) {
                m_gauges.push_back(*gauge);
            }
        }
        std::ranges::sort(m_gauges, {}, &Gauge::identity);
    }
    for (const ProcessId process : kAllProcesses) {
        const auto rows = m_links.records.roomRecords(process, kDispositionRecord, {}, kMostRecords);
        for (const RoomRecordRow& row : rows ? *rows : std::vector<RoomRecordRow>{}) {
            const auto json = nlohmann::json::parse(row.bodyJson, nullptr, false);
            if (json.is_object() && json.contains("what")) {
                m_dispositions.emplace(std::atoll(row.subject.c_str()),
                                       Disposition{json.value("what", ""), row.author, row.createdUtc_ms});
            }
        }
    }
}

void StoredQualityService::tell() {
    for (const auto& changed : m_listeners) {
        changed();
    }
}

void StoredQualityService::show(LotId lot) {
    m_wanted = lot;
    if (m_reading) {
        return;  // the newest wish is read when this one is there
    }
    m_reading = true;
    const auto read = std::make_shared<LotQuality>();
    m_links.background(
        [path = m_links.databasePath, lot, read]() -> Result<void> {
            auto result = readQualityLot(path, lot);
            if (!result) {
                return tl::unexpected(result.error());
            }
            *read = std::move(result->quality);
            return {};
        },
        [this, lot, read](const Result<void>& done) {
            m_reading = false;
            m_problem = done ? Sentence{} : done.error();
            if (done) {
                m_lot = read;
            }
            tell();
            if (m_wanted && *m_wanted != lot) {
                show(*m_wanted);
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
    const ProcessId process = m_lot ? m_lot->lot.process : ProcessId::Boring;
    const nlohmann::json body{{"what", what}};
    store(
        {process, kDispositionRecord, std::to_string(part), body.dump(), author, what},
        [this, part, what, author] {
            m_dispositions[part] = {what, author, now_ms()};
        },
        std::move(done));
}

void StoredQualityService::saveGauge(const Gauge& gauge, const std::string& author, Done done) {
    if (const auto why = whyInvalid(gauge)) {
        done(tl::unexpected(*why));
        return;
    }
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
    updated.sigma_mm = finding->sigma_mm;
    updated.sigmaFrom = study.method;
    store(
        {ProcessId::Boring, kStudyRecord, study.gauge, studyJson(study, *finding), author, {}}, [] {},
        [this, updated, author, done](const Result<void>& stored) {
            stored ? saveGauge(updated, author, done) : done(stored);
        });
}

void StoredQualityService::writeReport(LotId lot, const std::string& file, Done done) {
    m_links.background(
        [path = m_links.databasePath, lot, file, report = m_links.makeReport(), dispositions = m_dispositions,
         gauges = m_gauges]() -> Result<void> {
            const auto read = readQualityLot(path, lot);
            return read ? report(*read, dispositions, gauges, file) : Result<void>(tl::unexpected(read.error()));
        },
        std::move(done));
}

void StoredQualityService::writeDfq(LotId lot, const std::string& file, Done done) {
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
