// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/shift/shift_records.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "app/service/boring/boring_recipe.h"
#include "app/service/quality/characteristics.h"
#include "app/service/quality/part_judge.h"
#include "engine/process/boring/lot_tracker.h"
#include "engine/process/boring/model.h"

namespace kerf {
namespace {

using nlohmann::json;

constexpr std::uint32_t kRecordsLooked = 1000;
constexpr std::uint32_t kPage = 500;
constexpr std::uint32_t kMostParts = 5000;  // of one shift; a page is drawn from them, not a history
constexpr double kNanosecondsPerMillisecond = 1e6;
constexpr const char* kConsole = "Kerf";        // the author where nobody has signed on
constexpr ProcessId kHome = ProcessId::Boring;  // where records of the whole machine are kept

json bodyOf(const RoomRecordRow& row) {
    return json::parse(row.bodyJson, nullptr, false);
}

std::int64_t numberOf(const std::string& text) {
    std::int64_t value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

double figureOrZero(const PartRow& part, std::string_view key) {
    const auto found = std::ranges::find(part.figures, key, &PartFigure::key);
    return found == part.figures.end() ? 0.0 : found->value;
}

Result<std::vector<PartRow>> partsBetween(PartReader& reader, std::int64_t from_ms, std::int64_t to_ms) {
    std::vector<PartRow> all;
    PartQuery query;
    query.fromUtc_ms = from_ms;
    query.toUtc_ms = to_ms;
    query.limit = kPage;
    while (all.size() < kMostParts) {
        auto page = reader.parts(query);
        if (!page) {
            return page;
        }
        if (page->empty()) {
            break;
        }
        query.before = page->back().id;
        std::ranges::move(*page, std::back_inserter(all));
    }
    std::ranges::reverse(all);
    return all;
}

void count(ShiftView& view, const PartRow& part, quality::Verdict verdict) {
    auto row = std::ranges::find(view.parts, part.process, &ShiftParts::process);
    if (row == view.parts.end()) {
        row = view.parts.insert(row, ShiftParts{part.process});
    }
    ++row->made;
    row->aborted += part.complete ? 0 : 1;
    row->good += verdict == quality::Verdict::Good ? 1 : 0;
    row->rework += verdict == quality::Verdict::Rework ? 1 : 0;
    row->scrap += verdict == quality::Verdict::Scrap ? 1 : 0;
    row->notJudged += verdict == quality::Verdict::NotJudged ? 1 : 0;
    row->cutting_s += static_cast<double>(part.machineEnd_ns - part.machineBegin_ns) * 1e-9;
}

/// What the recipe's first feed, kept for ever, would have made of this bore: the measured deflection, carried to that
/// feed with the exponent estimated at that time.
void countBores(ShiftView& view, const ShiftSources& from, const PartRow& part,
                const std::vector<Characteristic>& limits) {
    const auto detail = from.parts.part(part.id);
    const auto revision =
        part.lot ? from.lots.recipeOf(*part.lot) : Result<std::optional<RecipeRevision>>(std::nullopt);
    if (!detail || !*detail || !(*detail)->schedule || !revision || !*revision) {
        return;
    }
    const auto recipe = recipeFromJson((*revision)->parametersJson);
    if (!recipe) {
        return;
    }
    const boring::CutPart cut{part.number, (*detail)->schedule->schedule, (*detail)->feed};
    const double alpha = (*detail)->states.empty() ? cut.schedule.alpha : (*detail)->states.back().theta[1];
    for (const MeasurementRow& row : effectiveMeasurements(part.measurements)) {
        const auto limit = std::ranges::find(limits, "bore_" + std::to_string(row.station), &Characteristic::key);
        if (!row.diameter_mm || limit == limits.end() || !limit->tolerance.lower || !limit->tolerance.upper) {
            continue;
        }
        const double deflection_mm = boring::deflectionFromDiameter_mm(*row.diameter_mm, recipe->targetDiameter_mm,
                                                                       recipe->targetDeflection_mm, recipe->phi_deg);
        const double feed = boring::cutFeed_mmPerRev(cut, row.position_mm);
        if (!(deflection_mm > 0.0) || !(feed > 0.0)) {
            continue;
        }
        const double without_mm =
            boring::diameterFromDeflection_mm(deflection_mm * std::pow(recipe->firstFeed_mmPerRev / feed, alpha),
                                              recipe->targetDiameter_mm, recipe->targetDeflection_mm, recipe->phi_deg);
        const auto inside = [&](double diameter_mm) {
            return diameter_mm >= *limit->tolerance.lower && diameter_mm <= *limit->tolerance.upper;
        };
        ++view.saving.bores;
        view.saving.partsKept += inside(*row.diameter_mm) && !inside(without_mm) ? 1 : 0;
    }
}

Result<void> readParts(ShiftView& view, const ShiftSources& from, std::vector<ShiftCut>& cuts) {
    const auto parts = partsBetween(from.parts, view.fromUtc_ms, view.toUtc_ms);
    if (!parts) {
        return tl::unexpected(parts.error());
    }
    PartJudge judge(from.lots, from.records);
    for (const PartRow& part : *parts) {
        count(view, part, judge.judge(part).verdict);
        const auto lasted_ms = static_cast<std::int64_t>(
            static_cast<double>(part.machineEnd_ns - part.machineBegin_ns) / kNanosecondsPerMillisecond);
        cuts.push_back({part.endedUtc_ms - lasted_ms, part.endedUtc_ms});
        if (part.process == ProcessId::Milling && part.complete && figureOrZero(part, "planned_time_s") > 0.0) {
            view.saving.saved_s += figureOrZero(part, "planned_time_s") - figureOrZero(part, "cut_time_s");
            ++view.saving.cuts;
        } else if (part.process == ProcessId::Boring && part.complete) {
            countBores(view, from, part, judge.characteristics(part));
        }
    }
    std::ranges::sort(view.parts, {}, &ShiftParts::process);
    return {};
}

Result<void> readAlarms(ShiftView& view, AlarmReader& reader) {
    const auto rows = reader.alarms(std::nullopt, kRecordsLooked);
    if (!rows) {
        return tl::unexpected(rows.error());
    }
    for (const AlarmRow& row : *rows) {  // newest first
        if (row.raisedUtc_ms < view.fromUtc_ms || row.raisedUtc_ms >= view.toUtc_ms) {
            continue;
        }
        const auto same = std::ranges::find(view.alarms, row.code, &ShiftAlarm::code);
        if (same == view.alarms.end()) {
            view.alarms.push_back({row.code, row.priority, 1, row.raisedUtc_ms, !row.clearedUtc_ms});
        } else {
            ++same->times;
        }
    }
    return {};
}

Result<void> readChanges(ShiftView& view, AuditReader& reader) {
    std::optional<std::int64_t> before;
    for (std::uint32_t seen = 0; seen < kMostParts;) {
        const auto rows = reader.audit(before, kPage);
        if (!rows) {
            return tl::unexpected(rows.error());
        }
        for (const AuditRow& row : *rows) {
            if (row.utc_ms < view.fromUtc_ms) {
                return {};
            }
            // Measured diameters are the work itself; notes and reasons stand on the page already; what the console
            // does by itself is nobody's change, but for its settings.
            const bool work = row.action == "measured" || row.action == "signed on" || row.action == "signed off" ||
                              row.action.find(" shift_") != std::string::npos ||
                              (row.author == kConsole && row.action != "setting changed");
            if (!work && !row.author.empty() && row.utc_ms < view.toUtc_ms) {
                view.changes.push_back(
                    {row.utc_ms, row.author, row.action, row.object, row.oldValue, row.newValue, row.reason});
            }
        }
        if (rows->size() < kPage) {
            return {};
        }
        before = rows->back().id;
        seen += kPage;
    }
    return {};
}

}  // namespace

std::string noteJson(const std::string& text, bool handover) {
    return json{{"text", text}, {"handover", handover}}.dump();
}
std::string stopReasonJson(const std::string& reason) {
    return json{{"reason", reason}}.dump();
}
std::string toolChangeJson(PartId lastPart) {
    return json{{"last_part", lastPart}}.dump();
}
std::string toolLifeJson(std::uint32_t parts) {
    return json{{"parts", parts}}.dump();
}

std::vector<ShiftStop> stopsBetween(const std::vector<ShiftCut>& cuts, std::int64_t from_ms, std::int64_t to_ms,
                                    bool current) {
    std::vector<ShiftStop> stops;
    std::int64_t busyUntil_ms = from_ms;
    for (const ShiftCut& cut : cuts) {
        if (cut.begin_ms - busyUntil_ms >= ShiftService::kShortestStop_ms) {
            stops.push_back({busyUntil_ms, cut.begin_ms, false, {}, {}});
        }
        busyUntil_ms = std::max(busyUntil_ms, cut.end_ms);
    }
    if (to_ms - busyUntil_ms >= ShiftService::kShortestStop_ms) {
        stops.push_back({busyUntil_ms, to_ms, current, {}, {}});
    }
    return stops;
}

Result<ShiftView> readShift(const ShiftSources& from, int back, std::int64_t now_ms) {
    const auto notes = from.records.roomRecords(kHome, kShiftNote, {}, kRecordsLooked);
    const auto reasons = from.records.roomRecords(kHome, kShiftStopReason, {}, kRecordsLooked);
    if (!notes || !reasons) {
        return tl::unexpected(notes ? reasons.error() : notes.error());
    }
    ShiftView view;
    view.toUtc_ms = now_ms;
    int handovers = 0;
    for (const RoomRecordRow& row : *notes) {  // newest first
        const json body = bodyOf(row);
        if (!body.is_object() || !body.value("handover", false)) {
            continue;
        }
        if (handovers == back) {
            view.fromUtc_ms = row.createdUtc_ms;
            view.takenFrom = row.author;
            break;
        }
        ++handovers;
        view.toUtc_ms = row.createdUtc_ms;
        view.current = false;
    }
    view.current = back == 0;
    view.fromUtc_ms = std::max(view.fromUtc_ms, view.toUtc_ms - ShiftService::kLongest_ms);
    for (auto row = notes->rbegin(); row != notes->rend(); ++row) {
        const json body = bodyOf(*row);
        // The handover that began the shift is the first thing to be read in it.
        if (body.is_object() && row->createdUtc_ms >= view.fromUtc_ms && row->createdUtc_ms <= view.toUtc_ms) {
            view.notes.push_back(
                {row->createdUtc_ms, row->author, body.value("text", std::string()), body.value("handover", false)});
        }
    }
    std::vector<ShiftCut> cuts;
    if (const auto read = readParts(view, from, cuts); !read) {
        return tl::unexpected(read.error());
    }
    // Where nobody has handed over the hours before the first part are no stop: nobody has said that work had begun.
    if (!view.takenFrom.empty()) {
        view.stops = stopsBetween(cuts, view.fromUtc_ms, view.toUtc_ms, view.current);
    } else if (!cuts.empty()) {
        const auto first = std::ranges::min_element(cuts, {}, &ShiftCut::begin_ms);
        view.stops = stopsBetween(cuts, first->begin_ms, view.toUtc_ms, view.current);
    }
    for (ShiftStop& stop : view.stops) {
        const auto named = std::ranges::find_if(
            *reasons, [&](const RoomRecordRow& row) { return numberOf(row.subject) == stop.fromUtc_ms; });
        if (named != reasons->end()) {
            const json body = bodyOf(*named);
            stop.reason = body.is_object() ? body.value("reason", std::string()) : std::string();
            stop.author = named->author;
        }
    }
    if (const auto read = readAlarms(view, from.alarms); !read) {
        return tl::unexpected(read.error());
    }
    if (const auto read = readChanges(view, from.audit); !read) {
        return tl::unexpected(read.error());
    }
    return view;
}

Result<std::vector<ToolLife>> readTools(PartReader& parts, RoomRecordReader& records) {
    std::vector<ToolLife> tools;
    for (const ProcessDescriptor* descriptor : processes()) {
        if (!descriptor->makesParts) {
            continue;
        }
        const ProcessId process = descriptor->id;
        ToolLife tool;
        tool.process = process;
        const auto changes = records.roomRecords(process, kToolChange, {}, 1);
        const auto lives = records.roomRecords(process, kToolLife, {}, 1);
        if (!changes || !lives) {
            return tl::unexpected(changes ? lives.error() : changes.error());
        }
        PartQuery query;
        query.process = process;
        if (!changes->empty()) {
            const json body = bodyOf(changes->front());
            query.after = body.is_object() ? body.value("last_part", PartId{0}) : PartId{0};
            tool.sinceUtc_ms = changes->front().createdUtc_ms;
            tool.changedBy = changes->front().author;
        }
        if (!lives->empty()) {
            const json body = bodyOf(lives->front());
            tool.life = body.is_object() ? body.value("parts", 0U) : 0U;
        }
        const auto made = parts.count(query, std::numeric_limits<std::uint32_t>::max());
        if (!made) {
            return tl::unexpected(made.error());
        }
        tool.parts = static_cast<std::uint32_t>(*made);
        tools.push_back(tool);
    }
    return tools;
}

}  // namespace kerf
