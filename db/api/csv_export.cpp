// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/api/csv_export.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <type_traits>

namespace kerf {
namespace {

constexpr std::uint32_t kPageSize = 500;
constexpr double kNanosecondsPerSecond = 1e9;

/// A text as one CSV field.
std::string quoted(std::string text, char separator) {
    if (!text.empty() && std::string_view("=+-@\t\r").find(text.front()) != std::string_view::npos) {
        text.insert(text.begin(), '\'');
    }
    if (text.find_first_of("\"\r\n") == std::string::npos && text.find(separator) == std::string::npos) {
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

/// Counts lines and hands over page by page.
class Lines {
 public:
    /// `local`: names of the local times, behind the others when they are wanted.
    Lines(std::string_view header, std::string_view local, const CsvSink& sink, const CsvFormat& format)
        : m_sink(sink), m_format(format) {
        if (format.byteOrderMark) {
            m_text = "\xEF\xBB\xBF";
        }
        const std::size_t begin = m_text.size();
        m_text += header;
        if (format.localTime) {
            m_text += local;
        }
        std::replace(m_text.begin() + static_cast<std::ptrdiff_t>(begin), m_text.end(), ',', format.separator);
        m_text += '\n';
    }
    template <class... Cells>
    void add(const Cells&... cells) {
        bool first = true;
        ((cell(cells, first), first = false), ...);
        ++m_rows;
    }
    /// Ends the row. `utc_ms`: its times, as in the header.
    void end(std::initializer_list<std::optional<std::int64_t>> utc_ms = {}) {
        if (m_format.localTime) {
            for (const auto& time : utc_ms) {
                m_text += m_format.separator;
                m_text += time ? localTime(*time) : std::string();
            }
        }
        m_text += '\n';
    }
    [[nodiscard]] bool flush() {
        const bool taken = m_text.empty() || m_sink(m_text);
        m_text.clear();
        return taken;
    }
    [[nodiscard]] std::uint64_t rows() const { return m_rows; }
    [[nodiscard]] std::string numberText(double value) const {
        std::string text = fmt::format("{}", value);
        std::ranges::replace(text, '.', m_format.decimal);
        return text;
    }

 private:
    template <class Cell>
    void cell(const Cell& value, bool first) {
        if (!first) {
            m_text += m_format.separator;
        }
        if constexpr (std::is_same_v<Cell, std::optional<double>>) {
            if (value) number(*value);
        } else if constexpr (std::is_floating_point_v<Cell>) {
            number(static_cast<double>(value));
        } else if constexpr (std::is_same_v<Cell, bool>) {
            m_text += value ? '1' : '0';
        } else if constexpr (std::is_integral_v<Cell>) {
            fmt::format_to(std::back_inserter(m_text), "{}", value);
        } else {
            m_text += quoted(std::string(value), m_format.separator);
        }
    }
    void number(double value) { m_text += numberText(value); }

    const CsvSink& m_sink;
    const CsvFormat& m_format;
    std::string m_text{};
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

std::string numberOrNone(const std::optional<std::int64_t>& number) {
    return number ? std::to_string(*number) : std::string();
}

ExportedVerdict judged(const VerdictOf& verdictOf, const PartRow& part, std::string_view key) {
    return verdictOf ? verdictOf(part, key) : ExportedVerdict{};
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

std::string localTime(std::int64_t utc_ms) {
    const std::time_t seconds = static_cast<std::time_t>(utc_ms / 1000 - (utc_ms % 1000 < 0 ? 1 : 0));
    std::tm local{};
    if (localtime_r(&seconds, &local) == nullptr) {
        return {};
    }
    return fmt::format("{:04}-{:02}-{:02} {:02}:{:02}:{:02}", local.tm_year + 1900, local.tm_mon + 1, local.tm_mday,
                       local.tm_hour, local.tm_min, local.tm_sec);
}

Result<std::uint64_t> exportParts(PartReader& reader, const PartQuery& query, const CsvSink& sink,
                                  const CsvFormat& format, const VerdictOf& verdictOf) {
    Lines lines(
        "part_id,process,part_type,lot,number,serial,complete,ended_utc,cutting_time_s,station,position_mm,diameter_mm,"
        "source,author,accepted_utc,corrected,lower_mm,upper_mm,verdict,part_verdict,source_name,decision,decision_by,"
        "lot_id,recipe_revision",
        ",ended_local,accepted_local", sink, format);
    return eachPart(reader, query, lines, [&](const PartRow& part) -> Result<void> {
        const double cutting_s = static_cast<double>(part.machineEnd_ns - part.machineBegin_ns) / kNanosecondsPerSecond;
        const auto add = [&](const auto&... rest) {
            lines.add(part.id, processKey(part.process), part.partTypeName, part.lotName, part.number, part.serial,
                      part.complete, isoTime(part.endedUtc_ms), cutting_s, rest..., numberOrNone(part.lot),
                      part.recipeRevision > 0 ? std::to_string(part.recipeRevision) : std::string());
        };
        const std::vector<MeasurementRow> effective = effectiveMeasurements(part.measurements);
        for (const MeasurementRow& row : effective) {
            const ExportedVerdict verdict = judged(verdictOf, part, "bore_" + std::to_string(row.station));
            add(row.station, row.position_mm, row.diameter_mm, sourceKey(row.source), row.author,
                isoTime(row.acceptedUtc_ms), row.kind == MeasurementKind::Correction, verdict.lower, verdict.upper,
                verdict.value, verdict.part, row.sourceName, verdict.decision, verdict.decisionBy);
            lines.end({part.endedUtc_ms, row.acceptedUtc_ms});
        }
        if (effective.empty()) {
            const ExportedVerdict verdict = judged(verdictOf, part, {});
            add("", "", "", "", "", "", "", "", "", "", verdict.part, "", verdict.decision, verdict.decisionBy);
            lines.end({part.endedUtc_ms, std::nullopt});
        }
        return {};
    });
}

Result<std::uint64_t> exportBores(PartReader& reader, const PartQuery& query, const FeedAt& feedAt, const CsvSink& sink,
                                  const CsvFormat& format) {
    Lines lines("part,overhang_mm,feed_mm_per_rev,diameter_mm,lot,source,source_name", "", sink, format);
    return eachPart(reader, query, lines, [&](const PartRow& part) -> Result<void> {
        const std::vector<MeasurementRow> effective = effectiveMeasurements(part.measurements);
        if (effective.empty()) {
            return {};
        }
        const Result<std::optional<PartDetail>> detail = reader.part(part.id);
        if (!detail) {
            return tl::unexpected<Sentence>(detail.error());
        }
        for (const MeasurementRow& row : effective) {
            const auto feed_mmPerRev = *detail ? feedAt(**detail, row.position_mm) : std::nullopt;
            if (feed_mmPerRev && row.diameter_mm) {
                lines.add(part.number, row.position_mm, *feed_mmPerRev, *row.diameter_mm, part.lotName,
                          sourceKey(row.source), row.sourceName);
                lines.end();
            }
        }
        return {};
    });
}

Result<std::uint64_t> exportMeasurements(PartReader& reader, const PartQuery& query, const CsvSink& sink,
                                         const CsvFormat& format) {
    Lines lines(
        "part_id,part_type,lot,number,measurement_id,kind,replaces_id,station,position_mm,diameter_mm,source,confirmed,"
        "author,reason,accepted_utc,source_name",
        ",accepted_local", sink, format);
    return eachPart(reader, query, lines, [&lines](const PartRow& part) -> Result<void> {
        for (const MeasurementRow& row : part.measurements) {
            lines.add(part.id, part.partTypeName, part.lotName, part.number, row.id, kindName(row.kind),
                      row.replaces ? std::to_string(*row.replaces) : std::string(), row.station, row.position_mm,
                      row.diameter_mm, sourceKey(row.source), row.confirmed, row.author, row.reason,
                      isoTime(row.acceptedUtc_ms), row.sourceName);
            lines.end({row.acceptedUtc_ms});
        }
        return {};
    });
}

Result<std::uint64_t> exportFigures(PartReader& reader, const PartQuery& query, const CsvSink& sink,
                                    const CsvFormat& format, const VerdictOf& verdictOf) {
    Lines lines(
        "part_id,process,part_type,lot,number,serial,ended_utc,figure,value,lower,upper,verdict,part_verdict,"
        "decision,decision_by",
        ",ended_local", sink, format);
    return eachPart(reader, query, lines, [&](const PartRow& part) -> Result<void> {
        for (const PartFigure& figure : part.figures) {
            const ExportedVerdict verdict = judged(verdictOf, part, figure.key);
            lines.add(part.id, processKey(part.process), part.partTypeName, part.lotName, part.number, part.serial,
                      isoTime(part.endedUtc_ms), figure.key, figure.value, verdict.lower, verdict.upper, verdict.value,
                      verdict.part, verdict.decision, verdict.decisionBy);
            lines.end({part.endedUtc_ms});
        }
        return {};
    });
}

Result<std::uint64_t> exportFeed(PartReader& reader, const PartQuery& query, const CsvSink& sink,
                                 const CsvFormat& format) {
    Lines lines("part_id,lot,number,schedule_revision,overhang_mm,scheduled_feed_mm_per_rev,cut_feed_mm_per_rev", "",
                sink, format);
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
            const std::string scheduled =
                schedule ? lines.numberText(schedule->schedule.feed_mmPerRev(overhang_mm)) : std::string();
            lines.add(part.id, part.lotName, part.number,
                      schedule ? std::to_string(schedule->schedule.revision) : std::string(), overhang_mm, scheduled,
                      static_cast<double>(feed.feed_mmPerRev[i]));
            lines.end();
        }
        return {};
    });
}

Result<std::uint64_t> exportRecipes(LotReader& reader, std::optional<ProcessId> process, const CsvSink& sink,
                                    const CsvFormat& format) {
    Lines lines("revision_id,process,part_type,revision,restored_from,author,reason,created_utc,parameters",
                ",created_local", sink, format);
    const auto types = reader.partTypes(process);
    if (!types) {
        return tl::unexpected<Sentence>(types.error());
    }
    std::vector<std::pair<RecipeRevision, const PartTypeRow*>> rows;
    for (const PartTypeRow& type : *types) {
        auto revisions = reader.recipes(type.id);
        if (!revisions) {
            return tl::unexpected<Sentence>(revisions.error());
        }
        for (RecipeRevision& revision : *revisions) {
            rows.emplace_back(std::move(revision), &type);
        }
    }
    std::ranges::sort(rows, {}, [](const auto& row) { return row.first.id; });
    for (const auto& [row, type] : rows) {
        lines.add(row.id, processKey(type->process), type->name, row.revision,
                  row.restoredFrom ? std::to_string(*row.restoredFrom) : std::string(), row.author, row.reason,
                  isoTime(row.createdUtc_ms), row.parametersJson);
        lines.end({row.createdUtc_ms});
    }
    return lines.flush() ? Result<std::uint64_t>(lines.rows()) : stopped();
}

Result<std::uint64_t> exportLots(LotReader& reader, std::optional<ProcessId> process, const CsvSink& sink,
                                 const CsvFormat& format) {
    Lines lines(
        "lot_id,process,part_type,lot,machine,recipe_revision,size,estimator,tool,gauge,opened_utc,opened_by,closed_"
        "utc,"
        "closed_by",
        ",opened_local,closed_local", sink, format);
    const auto lots = reader.lots(std::nullopt, std::numeric_limits<std::uint32_t>::max(), process);
    if (!lots) {
        return tl::unexpected<Sentence>(lots.error());
    }
    for (auto lot = lots->rbegin(); lot != lots->rend(); ++lot) {
        lines.add(lot->id, processKey(lot->process), lot->partTypeName, lot->name, lot->machineName,
                  lot->recipeRevision, lot->size, lot->estimator, lot->tool, lot->gauge, isoTime(lot->openedUtc_ms),
                  lot->openedBy, lot->closedUtc_ms ? isoTime(*lot->closedUtc_ms) : std::string(), lot->closedBy);
        lines.end({lot->openedUtc_ms, lot->closedUtc_ms});
    }
    return lines.flush() ? Result<std::uint64_t>(lines.rows()) : stopped();
}

Result<std::uint64_t> exportAudit(AuditReader& reader, const CsvSink& sink, const CsvFormat& format) {
    Lines lines("id,utc,author,action,object,object_id,old_value,new_value,reason,previous_hash,hash", ",local", sink,
                format);
    std::int64_t last = 0;
    while (true) {
        const Result<std::vector<AuditRow>> page = reader.auditAfter(last, kPageSize);
        if (!page) {
            return tl::unexpected<Sentence>(page.error());
        }
        for (const AuditRow& row : *page) {
            lines.add(row.id, isoTime(row.utc_ms), row.author, row.action, row.object, row.objectId, row.oldValue,
                      row.newValue, row.reason, row.previousHash, row.hash);
            lines.end({row.utc_ms});
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
