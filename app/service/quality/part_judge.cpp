// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/quality/part_judge.h"

#include <algorithm>

namespace kerf {

std::vector<FigureLimit> figureLimits(RoomRecordReader& records, ProcessId process) {
    const auto stored = records.roomRecords(process, kFigureLimits, {}, 1);
    if (!stored || stored->empty()) {
        return standardLimits(process);
    }
    const auto limits = limitsFromJson(process, stored->front().bodyJson);
    return limits ? *limits : std::vector<FigureLimit>{};
}

const std::vector<Characteristic>& PartJudge::characteristics(const PartRow& part) {
    if (part.process != ProcessId::Boring || !part.lot) {
        auto& known = m_byProcess[static_cast<std::size_t>(part.process)];
        if (!known) {
            known = characteristicsOf(part.process, {}, figureLimits(m_records, part.process));
        }
        return *known;
    }
    const auto found = m_byLot.find(*part.lot);
    if (found != m_byLot.end()) {
        return found->second;
    }
    const auto recipe = m_lots.recipeOf(*part.lot);
    return m_byLot
        .emplace(*part.lot, recipe && *recipe ? characteristicsOf(part.process, (*recipe)->parametersJson, {})
                                              : std::vector<Characteristic>{})
        .first->second;
}

VerdictOf PartJudge::forExport() {
    return [this](const PartRow& part, std::string_view key) {
        const std::vector<Characteristic>& all = characteristics(part);
        const PartJudgement judgement = judgePart(part, all);
        ExportedVerdict row;
        row.part = quality::verdictKey(judgement.verdict);
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

void PartJudge::forget() {
    m_byLot.clear();
    m_byProcess = {};
}

}  // namespace kerf
