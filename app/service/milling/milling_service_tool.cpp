// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "app/service/milling/milling_service.h"
#include "engine/process/milling/cut_record.h"

/// The tool in the spindle and those before it, and what was cut with them.
namespace kerf {
namespace {

constexpr std::size_t kCutsShown = 25;
constexpr std::uint32_t kMostRecords = 20'000;
constexpr const char* kToolMemoryRecord = "tool_memory";
constexpr double kSameRadius_mm = 1e-6;

/// Of a tool the status says nothing that would tell one from another.
bool neverShown(const Status& /*status*/) {
    return false;
}

/// Tools before the one in the spindle, of its radius and flutes, newest first.
std::vector<MillingToolView> toolsLike(const std::map<std::int64_t, MillingToolRecord>& past,
                                       const std::map<std::int64_t, RoomRecordRow>& told, const MillingToolRecord& now,
                                       const MillingSetup& setup) {
    std::vector<MillingToolView> tools;
    for (auto tool = past.rbegin(); tool != past.rend(); ++tool) {
        const MillingToolRecord& record = tool->second;
        if (record.since == now.since || record.flutes != setup.flutes ||
            std::abs(record.toolRadius_mm - setup.toolRadius_mm) > kSameRadius_mm) {
            continue;
        }
        MillingToolView view{record.since,
                             record.tool.parts,
                             record.partType,
                             record.tool.firstStiffness,
                             std::exp(milling::meanLnKx(record.tool.kxLogWeight)),
                             false,
                             {},
                             {}};
        if (const auto said = told.find(record.since); said != told.end()) {
            view.leftOut = said->second.bodyJson.find("true") != std::string::npos;
            view.reason = said->second.reason;
            view.author = said->second.author;
        }
        tools.push_back(std::move(view));
    }
    return tools;
}

std::optional<MillingExpected> viewed(const std::optional<milling::Expected>& expected) {
    return expected ? std::optional(MillingExpected{expected->mean, expected->half95, expected->tools}) : std::nullopt;
}

/// The cut as its stored figures tell it; law and mode are not among them.
MillingCut cutOf(const std::vector<PartFigure>& figures) {
    MillingCut cut;
    const auto value = [&](std::string_view key) {
        const auto found = std::ranges::find(figures, key, &PartFigure::key);
        return found == figures.end() ? 0.0 : found->value;
    };
    cut.reference_N = value("reference_N");
    cut.waviness_um = value("waviness_um");
    cut.meanForce_N = value("force_mean_N");
    cut.peakForce_N = value("force_peak_N");
    cut.peakAt_mm = value("force_peak_at_mm");
    cut.overReference_s = value("over_reference_s");
    cut.cutTime_s = value("cut_time_s");
    cut.plannedTime_s = value("planned_time_s");
    cut.controlledTime_s = value("controlled_time_s");
    cut.stiffnessMean = value("stiffness");
    cut.stiffnessHalf95 = value("stiffness_half95");
    cut.stops = static_cast<std::uint32_t>(value("stops"));
    return cut;
}

/// A record of before version 7 names parts by their number among those of no lot.
void nameByIds(MillingToolRecord& record, PartReader& parts) {
    const auto idOf = [&parts](std::int64_t number) -> std::int64_t {
        if (number <= 0) {
            return 0;
        }
        PartQuery query;
        query.process = ProcessId::Milling;
        query.numberWithoutLot = static_cast<std::uint32_t>(number);
        query.limit = 1;
        const auto found = parts.parts(query);
        return found && !found->empty() ? found->front().id : 0;
    };
    if (record.byNumber) {
        record.after = idOf(record.after);
        record.lastPart = idOf(record.lastPart);
        record.byNumber = false;
    }
}

}  // namespace

void StoredMillingService::restorePast(RoomRecordReader& records) {
    const auto tools =
        keep(records.roomRecords(ProcessId::Milling, "tool", {}, kMostRecords), std::vector<RoomRecordRow>{});
    for (const RoomRecordRow& row : tools) {  // newest first: the first of a tool is all that was learnt of it
        if (const auto tool = millingToolFromJson(row.bodyJson); tool && tool->learnt && tool->tool.parts > 0) {
            m_past.try_emplace(tool->since, *tool);
        }
    }
    for (RoomRecordRow& row :
         keep(records.newestRoomRecords(ProcessId::Milling, kToolMemoryRecord), std::vector<RoomRecordRow>{})) {
        const auto since = static_cast<std::int64_t>(std::strtoll(row.subject.c_str(), nullptr, 10));
        m_toldOfPast.insert_or_assign(since, std::move(row));
    }
}

milling::ToolMemory StoredMillingService::memory() const {
    const MillingSetup& setup = m_types.at(m_type).recipe.setup;
    std::vector<milling::PastTool> past;
    for (const MillingToolView& view : toolsLike(m_past, m_toldOfPast, m_tool, setup)) {
        if (!view.leftOut) {
            const MillingToolRecord& tool = m_past.at(view.since);
            past.push_back({tool.tool.firstStiffness, tool.tool.kxLogWeight, tool.partType == m_type});
        }
    }
    return milling::toolMemory(past);
}

void StoredMillingService::beginFromMemory() {
    if (m_tool.learnt || m_tool.tool.parts > 0) {
        return;
    }
    const milling::ToolMemory found = memory();
    m_tool.tool = {};
    if (found.lnKx) {
        m_tool.tool.kxLogWeight = found.kxLogWeight;
        m_toolOwed = ToolOwed::Kept;
    } else if (m_begun) {  // it had begun from tools that are left out now
        m_toolOwed = ToolOwed::Fresh;
        tellTool();
    }
    m_begun = found.lnKx.has_value();
}

void StoredMillingService::restoreTool(RoomRecordReader& records, PartReader& parts) {
    std::map<std::int64_t, MillingToolRecord> perPart;
    const auto rows =
        keep(records.roomRecords(ProcessId::Milling, "tool", {}, 2 * kCutsShown), std::vector<RoomRecordRow>{});
    for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
        m_tool = keep(millingToolFromJson(row->bodyJson), m_tool);
        nameByIds(m_tool, parts);
        perPart[m_tool.lastPart] = m_tool;
    }
    PartQuery query;
    query.process = ProcessId::Milling;
    query.limit = kCutsShown;
    const auto stored = keep(parts.parts(query), std::vector<PartRow>{});
    milling::WearTrend wear;
    wear.restore(m_tool.tool);
    for (auto row = stored.rbegin(); row != stored.rend(); ++row) {
        MillingCutView cut{row->id, row->number, row->lotName, row->complete, false, cutOf(row->figures)};
        if (const auto known = perPart.find(row->id); known != perPart.end()) {
            cut.cut.law = known->second.law;
            cut.cut.advised = known->second.advised;
        }
        if (row->id > m_tool.lastPart) {  // stored, but the console ended before it could note the tool
            if (cut.complete && cut.cut.stiffnessMean != 0.0) {
                wear.addPart(cut.cut.stiffnessMean);
            }
            m_tool.lastPart = row->id;
        }
        m_cuts.push_back(cut);
    }
    wear.save(m_tool.tool);
    m_toolOwed = m_tool.learnt ? ToolOwed::Kept : ToolOwed::Nothing;  // a tool that has not cut yet: beginFromMemory()
    if (m_links.toolChanged && m_tool.tool.parts > 0) {
        m_links.toolChanged(m_tool.tool.parts);
    }
}

void StoredMillingService::newTool(const std::string& author, Done done) {
    if (const auto why = whyBusy()) {
        return answer(done, tl::unexpected(*why));
    }
    if (const auto may = permitted(m_links.rights, author, Deed::MillingTool); !may) {
        return answer(done, may);
    }
    MillingToolRecord fresh;
    fresh.since = m_tool.lastPart;
    fresh.after = m_tool.lastPart;
    fresh.lastPart = m_tool.lastPart;
    store("tool", {}, millingToolJson(fresh), author, "new tool", std::move(done), [this, fresh] {
        m_tool = fresh;
        m_toolOwed = ToolOwed::Fresh;
        tellTool();
        beginFromMemory();
        if (m_links.toolChanged) {
            m_links.toolChanged(0);
        }
    });
}

void StoredMillingService::leaveOut(std::int64_t since, bool out, const std::string& author, const std::string& reason,
                                    Done done) {
    if (const auto why = whyBusy()) {
        return answer(done, tl::unexpected(*why));
    }
    if (const auto may = permitted(m_links.rights, author, Deed::MillingMemory, reason); !may) {
        return answer(done, may);
    }
    if (!m_past.contains(since)) {
        return answer(done, fail(KERF_TEXT("There is no such tool.")));
    }
    const std::string body = out ? R"({"left_out":true})" : R"({"left_out":false})";
    store(kToolMemoryRecord, std::to_string(since), body, author, reason, std::move(done),
          [this, since, body, author, reason] {
              RoomRecordRow row;
              row.bodyJson = body;
              row.author = author;
              row.reason = reason;
              m_toldOfPast[since] = row;
              beginFromMemory();
          });
}

void StoredMillingService::partStored(const StoredPart& part) {
    if (part.record.process != ProcessId::Milling) {
        return;
    }
    const auto lot = m_lots.current();
    m_cuts.push_back({part.id, part.number, lot && part.lot == lot->id ? lot->name : std::string(),
                      part.record.complete, true, part.record.milling});
    while (m_cuts.size() > kCutsShown) {
        m_cuts.pop_front();
    }
    m_tool.tool = part.record.millingTool;  // after this cut, whatever has been cut since
    m_tool.learnt = true;
    m_tool.lastPart = part.id;
    m_tool.law = part.record.milling.law;
    m_tool.advised = part.record.milling.advised;
    const auto used = m_used.find(part.recipe.value_or(0));
    const Used cut = used != m_used.end() ? used->second : Used{m_type, m_setup.toolRadius_mm, m_setup.flutes};
    m_tool.partType = cut.partType;
    m_tool.toolRadius_mm = cut.toolRadius_mm;
    m_tool.flutes = cut.flutes;
    m_past[m_tool.since] = m_tool;
    store("tool", {}, millingToolJson(m_tool), kItself, {}, {}, {});
}

// A part may begin before the engine hears of it, and refuse: then it is told after that part.
void StoredMillingService::tellTool() {
    switch (std::exchange(m_toolOwed, ToolOwed::Nothing)) {
        case ToolOwed::Kept:  // with what has been learnt by then
            return m_way.owe(
                RestoreMillingTool{m_tool.tool}, neverShown,
                [this](Handover::Action& action, const Status&) { action = RestoreMillingTool{m_tool.tool}; });
        case ToolOwed::Fresh:
            return m_way.owe(NewMillingTool{}, neverShown);
        case ToolOwed::Nothing:
            break;
    }
}

MillingMemoryView StoredMillingService::memoryView() const {
    const milling::ToolMemory found = memory();
    return {toolsLike(m_past, m_toldOfPast, m_tool, m_setup), viewed(found.lnKx), viewed(found.stiffness),
            !m_tool.learnt && found.lnKx.has_value()};
}

}  // namespace kerf
