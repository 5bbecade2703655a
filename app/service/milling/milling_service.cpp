// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/milling/milling_service.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "engine/process/milling/cut_record.h"
#include "engine/process/milling/milling_setup.h"

namespace kerf {
namespace {

constexpr std::size_t kCutsShown = 25;
constexpr std::uint32_t kMostRecords = 20'000;
constexpr const char* kMemoryRecord = "tool_memory";
constexpr const char* kItself = "Kerf";
constexpr double kSameRadius_mm = 1e-6;
constexpr std::size_t kLargestFile = 1U << 20U;
constexpr const char* kAtTheMachine = "changed while cutting";

void answer(const MillingService::Done& done, const Result<void>& result) {
    if (done) {
        done(result);
    }
}

template <class Action>
bool send(EngineApi& engine, const Action& action) {
    Command command;
    command.action = action;
    return engine.send(command).has_value();
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

Sentence signOnFirst() {
    return Sentence(KERF_TEXT("Sign on first: a change needs a name."));
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

}  // namespace

StoredMillingService::StoredMillingService(Links links, RoomRecordReader& records, PartReader& parts, LotReader& lots)
    : m_links(std::move(links)),
      m_recipes(m_links.writer, lots, ProcessId::Milling),
      m_history({m_recipes, [this] { return m_type; },
                 [this](const RecipeRevision& revision, const std::string& author, const std::string& reason,
                        Done done) { restoreRevision(revision, author, reason, std::move(done)); }}),
      m_lots({m_links.writer, m_links.engine, lots, ProcessId::Milling, m_links.rights, [this] { return m_type; },
              [this] { return millingSetupJson(m_types[m_type].setup); }, [this] { return settled(); },
              m_links.machineKind}) {
    restore(records, parts);
    m_partsSubscription = m_links.writer.onPartStored([this](const StoredPart& part) { partStored(part); });
    use(m_type);
    poll();
}

template <class Value>
Value StoredMillingService::keep(const Result<Value>& value, const Value& fallback) {
    if (!value) {
        m_way.setStoreProblem(value.error());
        return fallback;
    }
    return *value;
}

void StoredMillingService::restore(RoomRecordReader& records, PartReader& parts) {
    restorePartTypes(records);
    restoreTool(records, parts);
    restorePast(records);
}

void StoredMillingService::restorePast(RoomRecordReader& records) {
    const auto tools =
        keep(records.roomRecords(ProcessId::Milling, "tool", {}, kMostRecords), std::vector<RoomRecordRow>{});
    for (const RoomRecordRow& row : tools) {  // newest first: the first of a tool is all that was learnt of it
        if (const auto tool = millingToolFromJson(row.bodyJson); tool && tool->learnt && tool->tool.parts > 0) {
            m_past.try_emplace(tool->since, *tool);
        }
    }
    for (RoomRecordRow& row :
         keep(records.newestRoomRecords(ProcessId::Milling, kMemoryRecord), std::vector<RoomRecordRow>{})) {
        const auto since = static_cast<std::int64_t>(std::strtoll(row.subject.c_str(), nullptr, 10));
        m_toldOfPast.insert_or_assign(since, std::move(row));
    }
}

milling::ToolMemory StoredMillingService::memory() const {
    const MillingSetup& setup = m_types.at(m_type).setup;
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

void StoredMillingService::restorePartTypes(RoomRecordReader& records) {
    const PartType first = [] {
        PartType type;
        type.setup.revision = 1;
        return type;
    }();
    const auto read = [&](const char* kind) {
        return keep(records.newestRoomRecords(ProcessId::Milling, kind), std::vector<RoomRecordRow>{});
    };
    m_types.try_emplace(m_type, first);     // the one every machine begins with stays, whatever was chosen since
    const auto chosen = read("part_type");  // what was chosen last comes last
    for (const RoomRecordRow& row : chosen) {
        m_type = row.subject;
        m_types.try_emplace(m_type, first);
    }
    for (const RecipeBook::Recipe& recipe : keep(m_recipes.newest(), std::vector<RecipeBook::Recipe>{})) {
        PartType& type = m_types.try_emplace(recipe.partType, first).first->second;
        type.setup = keep(millingSetupFromJson(recipe.revision.parametersJson), first.setup);
        type.recipe = recipe.revision.id;
    }
    for (const RoomRecordRow& row : read("blank")) {
        m_types.try_emplace(row.subject, first).first->second.blank =
            keep(millingBlankFromJson(row.bodyJson), NamedBlank{});
    }
}

namespace {

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

std::span<const MillingField> StoredMillingService::fields() const {
    return milling::setupFields();
}

std::optional<Sentence> StoredMillingService::whyUnusable(const MillingSetup& setup) const {
    MillingSetup checked = setup;
    checked.revision = std::max(1U, checked.revision);
    return milling::whyUnusable(checked);
}

Result<MillingBlank> StoredMillingService::blankOf(std::span<const MillingBlankStep> steps, double end_mm) const {
    if (steps.size() > MillingBlank::kMaxSteps) {
        return fail(KERF_TEXT("A blank profile needs from 1 to %1 steps."),
                    SentenceArg(static_cast<double>(MillingBlank::kMaxSteps), 0));
    }
    MillingBlank blank;
    blank.count = static_cast<std::uint16_t>(steps.size());
    blank.end_mm = steps.empty() ? 0.0 : end_mm;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        blank.begin_mm[i] = steps[i].begin_mm;
        blank.height_mm[i] = steps[i].height_mm;
    }
    if (const auto why = milling::whyUnusable(blank)) {
        return tl::unexpected(*why);
    }
    return blank;
}

Result<MillingBlank> StoredMillingService::readBlank(const std::string& file) const {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    if (!in || !(text << in.rdbuf())) {
        return fail(KERF_TEXT("The file cannot be read. Check its name and folder."));
    }
    if (text.view().size() > kLargestFile) {
        return fail(KERF_TEXT("The file is too large for a blank profile."));
    }
    return millingBlankFromCsv(text.view());
}

void StoredMillingService::store(const std::string& kind, const std::string& subject, const std::string& body,
                                 const std::string& author, const std::string& reason, Done done,
                                 std::function<void()> then) {
    if (author.empty()) {
        return answer(done, tl::unexpected(signOnFirst()));
    }
    m_way.keep(
        [&](StoreWriter::Done stored) {
            m_links.writer.submit(AddRoomRecord{ProcessId::Milling, kind, subject, body, author, reason},
                                  std::move(stored));
        },
        [then = std::move(then)](const Receipt&) {
            if (then) {
                then();
            }
        },
        std::move(done));
    rebuild();
}

std::optional<Sentence> StoredMillingService::whyBusy() const {
    if (m_links.engine.status().milling.cutting) {
        return Sentence(KERF_TEXT("A part is being cut: law and reference can be changed now, the rest after it."));
    }
    return std::nullopt;
}

void StoredMillingService::saveSetup(const MillingSetup& setup, const std::string& author, const std::string& reason,
                                     Done done) {
    accept(setup, author, reason, std::nullopt, std::move(done));
}

void StoredMillingService::restoreRevision(const RecipeRevision& revision, const std::string& author,
                                           const std::string& reason, Done done) {
    const auto setup = millingSetupFromJson(revision.parametersJson);
    if (!setup) {
        return answer(done, tl::unexpected(setup.error()));
    }
    accept(*setup, author, reason, revision.revision, std::move(done));
}

void StoredMillingService::accept(const MillingSetup& setup, const std::string& author, const std::string& reason,
                                  std::optional<std::uint32_t> restoredFrom, Done done) {
    const auto store = [&](StoreWriter::Done stored) {
        m_recipes.begin(m_type, millingSetupJson(m_types[m_type].setup), kItself);
        m_recipes.keep(m_type, millingSetupJson(setup), author, reason, restoredFrom, std::move(stored));
    };
    m_way.change(
        mayAccept(setup, author, reason), store,
        [this, setup, type = m_type](const Receipt& revision) {
            m_types[type].setup = setup;
            m_types[type].recipe = revision.id;
            use(m_type);
        },
        std::move(done));
    rebuild();
}

Result<void> StoredMillingService::mayAccept(const MillingSetup& setup, const std::string& author,
                                             const std::string& reason) const {
    if (const auto why = whyBusy()) {
        return tl::unexpected(*why);
    }
    if (const auto why = whyUnusable(setup)) {
        return tl::unexpected(*why);
    }
    const bool limits = setup.overload_N > m_setup.overload_N || setup.highestFeed_mmPerS > m_setup.highestFeed_mmPerS;
    const bool far = raisedFar(m_setup.overload_N, setup.overload_N) ||
                     raisedFar(m_setup.highestFeed_mmPerS, setup.highestFeed_mmPerS);
    return permittedLimit(m_links.rights, author, limits ? Deed::MillingLimits : Deed::MillingSetup, reason, far);
}

void StoredMillingService::saveBlank(const MillingBlank& blank, const std::string& source, const std::string& author,
                                     Done done) {
    if (const auto why = whyBusy()) {
        return answer(done, tl::unexpected(*why));
    }
    if (const auto why = milling::whyUnusable(blank)) {
        return answer(done, tl::unexpected(*why));
    }
    if (const auto may = permitted(m_links.rights, author, Deed::MillingBlank); !may) {
        return answer(done, may);
    }
    const NamedBlank named{blank, source};
    store("blank", m_type, millingBlankJson(named), author, source.empty() ? "typed" : "from " + source,
          std::move(done), [this, named, type = m_type] {
              m_types[type].blank = named;
              use(m_type);
          });
}

void StoredMillingService::choosePartType(const std::string& name, const std::string& author, Done done) {
    if (const auto why = whyBusy()) {
        return answer(done, tl::unexpected(*why));
    }
    if (name.empty()) {
        return answer(done, fail(KERF_TEXT("A part type needs a name.")));
    }
    if (const auto may = permitted(m_links.rights, author, Deed::MillingPartType); !may) {
        return answer(done, may);
    }
    PartType like;
    like.setup = m_types[m_type].setup;
    const auto known = m_types.find(name);
    const MillingSetup& setup = known == m_types.end() ? like.setup : known->second.setup;
    // The setup it begins with is its first revision; who has chosen it is kept once that is on the disk.
    m_recipes.begin(name, millingSetupJson(setup), author,
                    [this, name, like, author, done = std::move(done),
                     alive = std::weak_ptr(m_alive)](const Result<Receipt>& begun) mutable {
                        if (!alive.lock()) {
                            return;
                        }
                        if (!begun) {
                            return answer(done, tl::unexpected(begun.error()));
                        }
                        if (begun->second > 0) {
                            like.recipe = begun->second;
                        }
                        store("part_type", name, "{}", author, "chosen", std::move(done), [this, name, like] {
                            m_types.try_emplace(name, like);
                            m_type = name;
                            use(name);
                        });
                    });
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
    store(kMemoryRecord, std::to_string(since), body, author, reason, std::move(done),
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

void StoredMillingService::use(const std::string& partType) {
    const PartType& type = m_types[partType];
    m_setup = type.setup;
    m_blank = type.blank.blank;
    m_setup.revision = ++m_revision;
    m_blank.revision = m_revision;
    if (m_setup.law == MillingLaw::Preview && m_blank.count == 0) {
        m_setup.law = MillingLaw::Model;
    }
    useRecipe();
    m_way.owe(LoadMillingBlank{m_blank},
              [wanted = m_revision](const Status& status) { return status.milling.blank == wanted; });
    m_way.owe(LoadMillingSetup{m_setup, m_lots.withLoad()},
              [wanted = m_revision](const Status& status) { return status.milling.setup == wanted; });
    beginFromMemory();  // a tool of another kind may belong to this part type
    rebuild();
}

void StoredMillingService::useRecipe() {
    const RecipeRevisionId recipe = m_types[m_type].recipe;
    m_lots.use(recipe);
    m_used[recipe] = {m_type, m_setup.toolRadius_mm, m_setup.flutes};
}

void StoredMillingService::recipeRevised(RecipeRevisionId revision) {
    m_types[m_type].recipe = revision;
    useRecipe();
}

bool StoredMillingService::settled() {
    return m_way.settled() && m_links.engine.status().milling.setup == m_setup.revision;
}

void StoredMillingService::tellTool() {
    const bool told = m_toolOwed == ToolOwed::Kept    ? send(m_links.engine, RestoreMillingTool{m_tool.tool})
                      : m_toolOwed == ToolOwed::Fresh ? send(m_links.engine, NewMillingTool{})
                                                      : true;
    m_toolOwed = told ? ToolOwed::Nothing : m_toolOwed;  // else the ring is full: with the next poll
}

void StoredMillingService::poll() {
    m_way.poll();
    m_lots.send();
    const Status& status = m_links.engine.status();
    const MillingStatus& now = status.milling;
    if (!now.cutting) {
        tellTool();
    }
    if (now.setup != m_setup.revision || (now.law == m_setup.law && now.reference_N == m_setup.reference_N)) {
        return;
    }
    m_setup.law = now.law;
    m_setup.reference_N = now.reference_N;
    m_recipes.begin(m_type, millingSetupJson(m_types[m_type].setup), kItself);
    m_types[m_type].setup = m_setup;
    const std::string author = m_links.author();
    m_way.keep(
        [&](StoreWriter::Done stored) {
            m_recipes.keep(m_type, millingSetupJson(m_setup), author.empty() ? kItself : author, kAtTheMachine,
                           std::nullopt, std::move(stored));
        },
        [this, type = m_type](const Receipt& revision) {
            m_types[type].recipe = revision.id;
            if (type == m_type) {
                useRecipe();
                m_lots.send();
            }
        },
        {});
    rebuild();
}

void StoredMillingService::rebuild() {
    m_view.partType = m_type;
    m_view.partTypes.clear();
    for (const auto& [name, type] : m_types) {
        m_view.partTypes.push_back(name);
    }
    m_view.setup = m_setup;
    m_view.blank = m_blank;
    m_view.blankSource = m_types[m_type].blank.source;
    m_view.cuts.assign(m_cuts.begin(), m_cuts.end());
    for (MillingCutView& cut : m_view.cuts) {
        cut.withThisTool = cut.id > m_tool.after;
    }
    const milling::ToolMemory found = memory();
    m_view.memory = {toolsLike(m_past, m_toldOfPast, m_tool, m_setup), viewed(found.lnKx), viewed(found.stiffness),
                     !m_tool.learnt && found.lnKx.has_value()};
    m_view.busy = m_way.busy();
    m_view.problem = m_way.problem().empty() ? m_links.writer.problem() : m_way.problem();
    ++m_view.revision;
    m_listeners.tell();
}

}  // namespace kerf
