// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/quality/quality_watch.h"

#include <algorithm>

#include "db/readers/database_reader.h"
#include "engine/api/quality_alarms.h"

namespace kerf {
namespace {

constexpr std::uint32_t kNewestFigures = 200;  // parts of a process without lots: their figures come with them

AlarmEvent alarm(AlarmCode code, Sentence detail) {
    AlarmEvent event;
    event.code = code;
    event.detail = detail;
    return event;
}

bool isBad(quality::Verdict verdict) {
    return verdict == quality::Verdict::Rework || verdict == quality::Verdict::Scrap;
}

}  // namespace

Result<void> QualityWatch::lookAt(const std::string& path, LotId lot, const std::pair<std::string, std::string>& files,
                                  Known& known) {
    const auto reader = db::DatabaseReader::open(path);
    if (!reader) {
        return tl::unexpected(reader.error());
    }
    const auto read = readQualityLot(**reader, lot, lot < 0 ? kNewestFigures : kNewestParts);
    if (!read) {
        return tl::unexpected(read.error());
    }
    const auto& [folder, pattern] = files;
    for (std::size_t i = 0; i < read->history.parts.size(); ++i) {
        const PartRow& part = read->history.parts[i].part;
        const PartJudgement& judgement = read->quality.parts[i].judgement;
        const bool fresh = !known.parts.contains(part.id);
        Seen& seen = known.parts[part.id];
        const bool changed = fresh || seen.rows != part.measurements.size();
        if (changed) {
            seen.rows = part.measurements.size();
            seen.written = known.first;
        }
        if (changed && !known.first && isBad(judgement.verdict)) {
            known.alarms.push_back(alarm(
                quality_alarm::kOutOfTolerance,
                judgement.verdict == quality::Verdict::Rework
                    ? Sentence(KERF_TEXT("Part %1 can be cut again."), SentenceArg(static_cast<double>(part.number), 0))
                    : Sentence(KERF_TEXT("Part %1 is scrap."), SentenceArg(static_cast<double>(part.number), 0))));
        }
        const bool judged = judgement.verdict != quality::Verdict::NotJudged;
        seen.exported = seen.exported || (known.first && judged);  // as far as anybody knows after a restart
        if (!folder.empty() && (judged || seen.exported) && !seen.written) {
            const auto written = exportPart(*read, part, folder, pattern, seen.file);
            if (written) {
                seen.written = true;
                seen.exported = true;
                seen.file = *written;
            } else {
                known.alarms.push_back(alarm(quality_alarm::kFileNotWritten, written.error()));
                break;  // the next ones would fail too
            }
        }
    }
    if (!read->quality.found.empty()) {
        const QualitySignal& last = read->quality.found.back();
        if (!known.first && last.part > known.lastSignal) {
            known.alarms.push_back(
                alarm(quality_alarm::kChartSignal,
                      Sentence(KERF_TEXT("Part %1: %2."), SentenceArg(static_cast<double>(last.part), 0),
                               SentenceArg(std::string_view(quality::ruleText(last.rule))))));
        }
        known.lastSignal = std::max(known.lastSignal, last.part);
    }
    known.first = false;
    return {};
}

void QualityWatch::look(std::vector<LotId> lots) {
    m_wanted.insert(lots.begin(), lots.end());
    if (m_busy || m_wanted.empty()) {
        return;
    }
    m_busy = true;
    const LotId lot = *m_wanted.begin();
    m_wanted.erase(m_wanted.begin());
    auto& known = m_known[lot];
    if (known == nullptr) {
        known = std::make_shared<Known>();
    }
    m_links.background(
        [path = m_links.databasePath, lot, files = m_links.files(), known] { return lookAt(path, lot, files, *known); },
        [this, known, alive = std::weak_ptr(m_alive)](const Result<void>&) {
            if (!alive.lock()) {
                return;
            }
            m_busy = false;
            for (const AlarmEvent& event : std::exchange(known->alarms, {})) {
                m_links.raise(event);
            }
            look({});
        });
}

void QualityWatch::tellOverdue(const std::vector<Gauge>& gauges, std::int64_t nowUtc_ms) {
    for (const Gauge& gauge : gauges) {
        const bool overdue = gauge.dueUtc_ms > 0 && nowUtc_ms > gauge.dueUtc_ms;
        if (!overdue) {
            m_overdue.erase(gauge.identity);
        } else if (m_overdue.insert(gauge.identity).second) {
            m_links.raise(alarm(quality_alarm::kGaugeOverdue,
                                Sentence(KERF_TEXT("Gauge %1"), SentenceArg(std::string_view(gauge.identity)))));
        }
    }
}

}  // namespace kerf
