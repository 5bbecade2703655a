// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/api/csv_export.h"

#include <fmt/format.h>

#include <chrono>
#include <iterator>

namespace kerf {
namespace {

constexpr std::uint32_t kPageSize = 500;
constexpr double kNanosecondsPerSecond = 1e9;

/// A text as one CSV field.
std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) {
        return text;
    }
    std::string field = "\"";
    for (const char c : text) {
        field += c;
        if (c == '"') {
            field += '"';
        }
    }
    return field + '"';
}

std::string number(const std::optional<double>& value) {
    return value ? fmt::format("{:.17g}", *value) : std::string();
}

const char* kindName(MeasurementKind kind) {
    switch (kind) {
        case MeasurementKind::Entry:
            return "entry";
        case MeasurementKind::Correction:
            return "correction";
        case MeasurementKind::Void:
            break;
    }
    return "void";
}

const char* sourceName(MeasurementSource source) {
    return source == MeasurementSource::Gauge ? "gauge" : "keypad";
}

/// Counts lines and hands over page by page.
class Lines {
 public:
    Lines(std::string_view header, const CsvSink& sink) : m_sink(sink), m_text(header) { m_text += '\n'; }
    template <class... Args>
    void add(fmt::format_string<Args...> format, Args&&... args) {
        fmt::format_to(std::back_inserter(m_text), format, std::forward<Args>(args)...);
        m_text += '\n';
        ++m_rows;
    }
    [[nodiscard]] bool flush() {
        const bool taken = m_text.empty() || m_sink(m_text);
        m_text.clear();
        return taken;
    }
    [[nodiscard]] std::uint64_t rows() const { return m_rows; }

 private:
    const CsvSink& m_sink;
    std::string m_text;
    std::uint64_t m_rows{0};
};

Result<std::uint64_t> stopped() {
    return fail(KERF_TEXT("The export could not be written completely."));
}

/// Every matching part, oldest first.
Result<std::uint64_t> eachPart(PartReader& reader, PartQuery query, Lines& lines,
                               const std::function<Result<void>(const PartRow&)>& add) {
    query.oldestFirst = true;  // `before` and `after` stay: an export of one part is one between its neighbours
    query.limit = kPageSize;
    while (true) {
        const Result<std::vector<PartRow>> page = reader.parts(query);
        if (!page) {
            return tl::unexpected<Sentence>(page.error());
        }
        for (const PartRow& part : *page) {
            if (const Result<void> added = add(part); !added) {
                return tl::unexpected<Sentence>(added.error());
            }
        }
        if (!lines.flush()) {
            return stopped();
        }
        if (page->size() < kPageSize) {
            return lines.rows();
        }
        query.after = page->back().id;
    }
}

}  // namespace

std::string isoTime(std::int64_t utc_ms) {
    using namespace std::chrono;
    const sys_time<milliseconds> instant{milliseconds(utc_ms)};
    const auto day = floor<days>(instant);
    const year_month_day date(day);
    const hh_mm_ss time(instant - day);
    return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:03}Z", static_cast<int>(date.year()),
                       static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()), time.hours().count(),
                       time.minutes().count(), time.seconds().count(), time.subseconds().count());
}

Result<std::uint64_t> exportParts(PartReader& reader, const PartQuery& query, const CsvSink& sink) {
    Lines lines(
        "part_id,process,part_type,lot,number,serial,complete,ended_utc,cutting_time_s,station,position_mm,diameter_mm,"
        "source,author,accepted_utc,corrected",
        sink);
    return eachPart(reader, query, lines, [&lines](const PartRow& part) -> Result<void> {
        const double cutting_s = static_cast<double>(part.machineEnd_ns - part.machineBegin_ns) / kNanosecondsPerSecond;
        const std::string head =
            fmt::format("{},{},{},{},{},{},{},{},{:.17g}", part.id, processKey(part.process), quoted(part.partTypeName),
                        quoted(part.lotName), part.number, quoted(part.serial), part.complete ? 1 : 0,
                        isoTime(part.endedUtc_ms), cutting_s);
        const std::vector<MeasurementRow> effective = effectiveMeasurements(part.measurements);
        for (const MeasurementRow& row : effective) {
            lines.add("{},{},{:.17g},{},{},{},{},{}", head, row.station, row.position_mm, number(row.diameter_mm),
                      sourceName(row.source), quoted(row.author), isoTime(row.acceptedUtc_ms),
                      row.kind == MeasurementKind::Correction ? 1 : 0);
        }
        if (effective.empty()) {
            lines.add("{},,,,,,,", head);
        }
        return {};
    });
}

Result<std::uint64_t> exportMeasurements(PartReader& reader, const PartQuery& query, const CsvSink& sink) {
    Lines lines(
        "part_id,part_type,lot,number,measurement_id,kind,replaces_id,station,position_mm,diameter_mm,source,confirmed,"
        "author,reason,accepted_utc",
        sink);
    return eachPart(reader, query, lines, [&lines](const PartRow& part) -> Result<void> {
        for (const MeasurementRow& row : part.measurements) {
            lines.add("{},{},{},{},{},{},{},{},{:.17g},{},{},{},{},{},{}", part.id, quoted(part.partTypeName),
                      quoted(part.lotName), part.number, row.id, kindName(row.kind),
                      row.replaces ? std::to_string(*row.replaces) : std::string(), row.station, row.position_mm,
                      number(row.diameter_mm), sourceName(row.source), row.confirmed ? 1 : 0, quoted(row.author),
                      quoted(row.reason), isoTime(row.acceptedUtc_ms));
        }
        return {};
    });
}

Result<std::uint64_t> exportFigures(PartReader& reader, const PartQuery& query, const CsvSink& sink) {
    Lines lines("part_id,process,part_type,lot,number,serial,ended_utc,figure,value", sink);
    return eachPart(reader, query, lines, [&lines](const PartRow& part) -> Result<void> {
        for (const PartFigure& figure : part.figures) {
            lines.add("{},{},{},{},{},{},{},{},{:.17g}", part.id, processKey(part.process), quoted(part.partTypeName),
                      quoted(part.lotName), part.number, quoted(part.serial), isoTime(part.endedUtc_ms), figure.key,
                      figure.value);
        }
        return {};
    });
}

Result<std::uint64_t> exportFeed(PartReader& reader, const PartQuery& query, const CsvSink& sink) {
    Lines lines("part_id,lot,number,schedule_revision,overhang_mm,scheduled_feed_mm_per_rev,cut_feed_mm_per_rev", sink);
    return eachPart(reader, query, lines, [&lines, &reader](const PartRow& part) -> Result<void> {
        const Result<std::optional<PartDetail>> detail = reader.part(part.id);
        if (!detail) {
            return tl::unexpected<Sentence>(detail.error());
        }
        if (!*detail) {
            return {};
        }
        const auto& schedule = (*detail)->schedule;
        const FeedTrace& feed = (*detail)->feed;
        for (std::size_t i = 0; i < feed.count; ++i) {
            const auto overhang_mm = static_cast<double>(feed.overhang_mm[i]);
            const std::optional<double> scheduled =
                schedule ? std::optional(schedule->schedule.feed_mmPerRev(overhang_mm)) : std::nullopt;
            lines.add("{},{},{},{},{:.17g},{},{:.17g}", part.id, quoted(part.lotName), part.number,
                      schedule ? std::to_string(schedule->schedule.revision) : std::string(), overhang_mm,
                      number(scheduled), static_cast<double>(feed.feed_mmPerRev[i]));
        }
        return {};
    });
}

Result<std::uint64_t> exportAudit(AuditReader& reader, const CsvSink& sink) {
    Lines lines("id,utc,author,action,object,object_id,old_value,new_value,reason,previous_hash,hash", sink);
    std::int64_t last = 0;
    while (true) {
        const Result<std::vector<AuditRow>> page = reader.auditAfter(last, kPageSize);
        if (!page) {
            return tl::unexpected<Sentence>(page.error());
        }
        for (const AuditRow& row : *page) {
            lines.add("{},{},{},{},{},{},{},{},{},{},{}", row.id, isoTime(row.utc_ms), quoted(row.author),
                      quoted(row.action), quoted(row.object), row.objectId, quoted(row.oldValue), quoted(row.newValue),
                      quoted(row.reason), row.previousHash, row.hash);
        }
        if (!lines.flush()) {
            return stopped();
        }
        if (page->size() < kPageSize) {
            return lines.rows();
        }
        last = page->back().id;
    }
}

}  // namespace kerf
