// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/quality/part_judge.h"

#include <algorithm>
#include <map>
#include <string>

#include "app/service/quality/gauge_records.h"

namespace kerf {

namespace {

constexpr std::uint32_t kMostChoices = 100'000;

/// Of what was made before recipes had limits.
std::vector<FigureLimit> limitsBefore(RoomRecordReader& records, ProcessId process) {
    const auto stored = records.roomRecords(process, kFigureLimits, {}, 1);
    if (!stored || stored->empty()) {
        return standardLimits(process);
    }
    return limitsFromJson(process, stored->front().bodyJson).value_or(std::vector<FigureLimit>{});
}

/// A revision was accepted, or a part type chosen.
struct Event {
    std::int64_t utc_ms{0};
    std::string partType{};
    const RecipeRevision* revision{nullptr};  ///< null: chosen
};

}  // namespace

RecipeLimits recipeLimits(LotReader& lots, RoomRecordReader& records, ProcessId process) {
    RecipeLimits limits;
    if (process == ProcessId::Boring) {
        return limits;  // its limits are the diameters of the recipe of each lot
    }
    limits.before = limitsBefore(records, process);
    limits.inForce = limits.before;
    const auto types = lots.partTypes(process);
    const auto all = lots.allRecipes(process);
    const auto chosen = records.roomRecords(process, kPartTypeRecord, {}, kMostChoices);
    if (!types || !all || !chosen) {
        return limits;
    }
    std::map<PartTypeId, std::string> names;
    for (const PartTypeRow& type : *types) {
        names[type.id] = type.name;
    }
    std::vector<Event> events;
    for (const RecipeRevision& revision : *all) {
        events.push_back({revision.createdUtc_ms, names[revision.partType], &revision});
        limits.ofRecipe[revision.id] = {revision.createdUtc_ms, revision.revision,
                                        limitsOfRecipe(process, revision.parametersJson).value_or(limits.before),
                                        names[revision.partType]};
    }
    for (auto row = chosen->rbegin(); row != chosen->rend(); ++row) {
        events.push_back({row->createdUtc_ms, row->subject, nullptr});
    }
    std::ranges::stable_sort(events, {}, &Event::utc_ms);
    std::map<std::string, const RecipeRevision*> newest;
    std::optional<std::string> worksBy;  // until something is chosen: whatever was changed last
    for (const Event& event : events) {
        if (event.revision != nullptr) {
            newest[event.partType] = event.revision;
        } else {
            worksBy = event.partType;
        }
        const auto held = newest.find(worksBy.value_or(event.partType));
        const RecipeRevision* revision = held == newest.end() ? nullptr : held->second;
        const auto own = revision != nullptr ? limitsOfRecipe(process, revision->parametersJson) : std::nullopt;
        limits.revisions.push_back({event.utc_ms, revision != nullptr ? revision->revision : 0,
                                    own.value_or(limits.before), worksBy.value_or(event.partType)});
        limits.inForce = limits.revisions.back().limits;
    }
    return limits;
}

const std::vector<Characteristic>& PartJudge::characteristics(const PartRow& part) {
    if (part.process != ProcessId::Boring) {
        const auto [found, fresh] = m_byProcess.try_emplace(part.process);
        if (fresh) {
            found->second.limits = recipeLimits(m_lots, m_records, part.process);
        }
        const std::vector<FigureLimit>& limits = found->second.limits.of(part);
        const auto [known, first] = found->second.known.try_emplace(&limits);
        if (first) {
            known->second = characteristicsOf(part.process, {}, limits);
        }
        return known->second;
    }
    const auto found = m_byLot.find(part.lot.value_or(0));
    if (found != m_byLot.end()) {
        return found->second;
    }
    const auto recipe = part.lot ? m_lots.recipeOf(*part.lot) : Result<std::optional<RecipeRevision>>{};
    return m_byLot
        .emplace(part.lot.value_or(0), recipe && *recipe
                                           ? characteristicsOf(part.process, (*recipe)->parametersJson, {})
                                           : std::vector<Characteristic>{})
        .first->second;
}

const std::map<PartId, Disposition>& PartJudge::decisions() {
    if (!m_decisions) {
        m_decisions = dispositionsIn(m_records);
    }
    return *m_decisions;
}

VerdictOf PartJudge::forExport() {
    return [this](const PartRow& part, std::string_view key) {
        const std::vector<Characteristic>& all = characteristics(part);
        const PartJudgement judgement = judgePart(part, all);
        ExportedVerdict row;
        row.part = quality::verdictKey(judgement.verdict);
        if (judgement.verdict == quality::Verdict::Rework || judgement.verdict == quality::Verdict::Scrap) {
            const auto& decided = decisions();
            const auto found = decided.find(part.id);
            row.decision = found == decided.end() ? std::string() : found->second.what;
            row.decisionBy = found == decided.end() ? std::string() : found->second.author;
        }
        row.value = quality::verdictKey(quality::Verdict::NotJudged);
        const auto found = std::ranges::find(all, key, &Characteristic::key);
        if (found != all.end()) {
            row.lower = found->tolerance.lower;
            row.upper = found->tolerance.upper;
            row.value = quality::verdictKey(judgement.values[static_cast<std::size_t>(found - all.begin())].verdict);
        }
        return row;
    };
}

}  // namespace kerf
