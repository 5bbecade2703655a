// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/boring/lot_tracker.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace kerf::boring {
namespace {

std::optional<Sentence> whyUnusable(double deflection_mm) {
    if (std::isfinite(deflection_mm) && deflection_mm > 0.0) {
        return std::nullopt;
    }
    return Sentence(KERF_TEXT("A deflection must be a number above 0 mm."));
}

// An axis runs up and down within millimetres; a schedule changes by less than this from one point to the next.
constexpr double kRunUp_mm = 3.0;
constexpr double kRunUpShare = 0.95;
constexpr double kNeighbour_mm = 10.0;  // further away a lower feed is the schedule's

void append(LotTracker::Step& step, const LotTracker::Entry& entry) {
    assert(step.visit.count < kMaxBoreDepths);
    step.ids[step.visit.count] = entry.id;
    step.visit.rows[step.visit.count++] = entry.measurement;
}

bool sameInput(const LotTracker::Step& a, const LotTracker::Step& b) noexcept {
    return a.visit == b.visit && a.ids == b.ids;
}

}  // namespace

double cutFeed_mmPerRev(const CutPart& part, double overhang_mm) noexcept {
    const FeedTrace& trace = part.feed;
    if (trace.count == 0) {
        return part.schedule.feed_mmPerRev(overhang_mm);
    }
    std::size_t first = 0;
    std::size_t last = trace.count - 1U;
    const auto at = [&](std::size_t i) { return static_cast<double>(trace.overhang_mm[i]); };
    const auto feed = [&](std::size_t i) { return static_cast<double>(trace.feed_mmPerRev[i]); };
    const auto slower = [&](std::size_t end, std::size_t inside) {
        return feed(end) < kRunUpShare * feed(inside) && std::abs(at(end) - at(inside)) < kNeighbour_mm;
    };
    while (first < last && at(first) - at(0) < kRunUp_mm && slower(first, first + 1)) {
        ++first;
    }
    while (last > first && at(trace.count - 1U) - at(last) < kRunUp_mm && slower(last, last - 1)) {
        --last;
    }
    if (overhang_mm <= at(first)) {
        return feed(first);
    }
    for (std::size_t i = first + 1; i <= last; ++i) {
        if (overhang_mm <= at(i)) {
            const double share = (overhang_mm - at(i - 1)) / (at(i) - at(i - 1));
            return feed(i - 1) + share * (feed(i) - feed(i - 1));
        }
    }
    return feed(last);
}

bool LotTracker::Step::perturbed() const noexcept {
    // The Kalman filter judges the part as a whole (last row), the paper every measurement.
    if (std::holds_alternative<KalmanState>(after)) {
        return visit.count > 0 && rows[visit.count - 1U].perturbed;
    }
    return std::any_of(rows.begin(), rows.begin() + visit.count, [](const RowOutcome& row) { return row.perturbed; });
}

LotTracker::LotTracker(const EstimatorParams& params, LotBegin begin)
    : m_params(params), m_begin(std::move(begin)), m_initial(initialState(params)) {
    m_begin.memory = m_begin.memory && params.kind == EstimatorKind::Kalman;
    if (m_begin.memory) {
        const Memory memory = memoryNow();
        if (memory.usable()) {
            m_initial = stateFrom(memory.start(), m_params.kalman);
        }
    }
    m_state = m_initial;
}

Memory LotTracker::memoryNow() const {
    static const std::vector<PastLot> kNone;
    return {m_begin.past ? *m_begin.past : kNone, m_begin.context, m_params.kalman, stretches()};
}

std::vector<Stretch> LotTracker::stretches() const {
    return stretchesOfFirst(m_steps.size());
}

std::vector<Stretch> LotTracker::stretchesOfFirst(std::size_t steps) const {
    std::vector<PartVisit> visits;
    for (std::size_t i = 0; i < steps; ++i) {
        visits.push_back(m_steps[i].visit);
    }
    return stretchesOf(visits, m_announced, m_params.kalman);
}

void LotTracker::setAnnounced(std::vector<AnnouncedChange> announced) {
    m_announced = std::move(announced);
    std::ranges::sort(m_announced, {}, &AnnouncedChange::part);
    if (m_begin.memory) {
        stepFrom(0);
    }
}

const AnnouncedChange* LotTracker::changeIn(std::uint32_t after, std::uint32_t to) const noexcept {
    const AnnouncedChange* found = nullptr;
    for (const AnnouncedChange& change : m_announced) {
        // The first part of a lot begins anew anyway.
        if (m_begin.memory && change.part > std::max(after, 1U) && change.part <= to) {
            found = &change;
        }
    }
    return found;
}

EstimatorState LotTracker::changed(const EstimatorState& before, std::size_t steps,
                                   const AnnouncedChange& change) const {
    static const std::vector<PastLot> kNone;
    const Memory memory(m_begin.past ? *m_begin.past : kNone, m_begin.context, m_params.kalman,
                        stretchesOfFirst(steps));
    return memory.usable() ? EstimatorState(stateFrom(memory.start(change.kind), m_params.kalman)) : before;
}

Result<void> LotTracker::addPart(const CutPart& part) {
    if (part.number == 0 || LotTracker::part(part.number) != nullptr) {
        return fail(KERF_TEXT("Part %1 is already in the lot."), SentenceArg(part.number, 0));
    }
    const auto place = std::ranges::upper_bound(m_parts, part.number, {}, &CutPart::number);
    m_parts.insert(place, part);
    return {};
}

Result<void> LotTracker::add(EntryId id, std::uint32_t partNumber, double overhang_mm, double deflection_mm) {
    if (const auto why = whyUnusable(deflection_mm)) {
        return tl::unexpected(*why);
    }
    if (!(overhang_mm > 0.0) || !std::isfinite(overhang_mm)) {
        return fail(KERF_TEXT("An overhang must be a number above 0 mm."));
    }
    const CutPart* cut = part(partNumber);
    if (cut == nullptr) {
        return fail(KERF_TEXT("Part %1 has not been cut yet."), SentenceArg(partNumber, 0));
    }
    if (find(id) != m_entries.end()) {
        return fail(KERF_TEXT("Measurement %1 is already in the lot."), SentenceArg(static_cast<double>(id), 0));
    }
    const auto sameDepth = [&](const Entry& entry) {
        return entry.part == partNumber && entry.measurement.overhang_mm == overhang_mm;
    };
    if (std::ranges::any_of(m_entries, sameDepth)) {
        return fail(KERF_TEXT("Part %1 has been measured at %2 mm; correct that value instead."),
                    SentenceArg(partNumber, 0), SentenceArg(overhang_mm, 0));
    }
    if (std::ranges::count(m_entries, partNumber, &Entry::part) >= static_cast<std::ptrdiff_t>(kMaxBoreDepths)) {
        return fail(KERF_TEXT("Part %1 has all of its %2 measurements."), SentenceArg(partNumber, 0),
                    SentenceArg(static_cast<double>(kMaxBoreDepths), 0));
    }
    Measurement measurement = measurementAt(cut->schedule, overhang_mm, deflection_mm);
    measurement.feed_mmPerRev = cutFeed_mmPerRev(*cut, overhang_mm);
    if (!(measurement.feed_mmPerRev > 0.0) || !std::isfinite(measurement.feed_mmPerRev)) {
        return fail(KERF_TEXT("Part %1 has no known feed at %2 mm."), SentenceArg(partNumber, 0),
                    SentenceArg(overhang_mm, 0));
    }
    m_entries.push_back({id, partNumber, measurement});
    if (!appendNewest()) {
        replay();
    }
    return {};
}

Result<void> LotTracker::correct(EntryId id, EntryId replacement, double deflection_mm) {
    if (const auto why = whyUnusable(deflection_mm)) {
        return tl::unexpected(*why);
    }
    const auto entry = find(id);
    if (entry == m_entries.end()) {
        return fail(KERF_TEXT("Measurement %1 is not in use any more."), SentenceArg(static_cast<double>(id), 0));
    }
    if (replacement != id && find(replacement) != m_entries.end()) {
        return fail(KERF_TEXT("Measurement %1 is already in the lot."),
                    SentenceArg(static_cast<double>(replacement), 0));
    }
    entry->id = replacement;
    entry->measurement.deflection_mm = deflection_mm;
    replay();
    return {};
}

Result<void> LotTracker::voidEntry(EntryId id) {
    const auto entry = find(id);
    if (entry == m_entries.end()) {
        return fail(KERF_TEXT("Measurement %1 is not in use any more."), SentenceArg(static_cast<double>(id), 0));
    }
    m_entries.erase(entry);
    replay();
    return {};
}

const EstimatorState& LotTracker::stateBefore(std::uint32_t number) const noexcept {
    return stateBelow(number, number > 0 ? number - 1 : 0);
}

const EstimatorState& LotTracker::stateFor(std::uint32_t number) const noexcept {
    return stateBelow(number, number);
}

const EstimatorState& LotTracker::stateBelow(std::uint32_t number, std::uint32_t announcedTo) const noexcept {
    const EstimatorState* before = &m_initial;
    std::uint32_t measured = 0;
    for (const Step& step : m_steps) {
        if (step.visit.part >= number) {
            break;
        }
        before = &step.after;
        measured = step.visit.part;
    }
    const AnnouncedChange* change = changeIn(measured, announcedTo);
    const auto after = change != nullptr ? m_changed.find(change->part) : m_changed.end();
    return after != m_changed.end() ? after->second : *before;
}

const CutPart* LotTracker::part(std::uint32_t number) const noexcept {
    const auto found = std::ranges::lower_bound(m_parts, number, {}, &CutPart::number);
    return found != m_parts.end() && found->number == number ? &*found : nullptr;
}

std::vector<LotTracker::Entry>::iterator LotTracker::find(EntryId id) {
    return std::ranges::find(m_entries, id, &Entry::id);
}

void LotTracker::restore(std::vector<CutPart> parts, std::vector<Entry> entries) {
    assert(m_parts.empty() && m_entries.empty());
    m_parts = std::move(parts);
    std::ranges::sort(m_parts, {}, &CutPart::number);
    m_entries = std::move(entries);
    replay();
}

bool LotTracker::appendNewest() {
    const Entry& newest = m_entries.back();
    const bool inOrder =
        m_steps.empty() || m_params.kind == EstimatorKind::Perturbation || newest.part >= m_steps.back().visit.part;
    if (!inOrder) {
        return false;
    }
    if (m_steps.empty() || m_steps.back().visit.part != newest.part) {
        m_steps.emplace_back().visit.part = newest.part;
    }
    append(m_steps.back(), newest);
    stepFrom(m_steps.size() - 1);
    return true;
}

void LotTracker::replay() {
    std::vector<const Entry*> order;
    order.reserve(m_entries.size());
    for (const Entry& entry : m_entries) {
        order.push_back(&entry);
    }
    if (m_params.kind == EstimatorKind::Kalman) {
        std::ranges::stable_sort(order, {}, [](const Entry* entry) { return entry->part; });
    }
    std::vector<Step> steps;
    steps.reserve(m_steps.size() + 1);
    for (const Entry* entry : order) {
        if (steps.empty() || steps.back().visit.part != entry->part) {
            steps.emplace_back().visit.part = entry->part;
        }
        append(steps.back(), *entry);
    }
    std::size_t known = 0;
    while (known < steps.size() && known < m_steps.size() && sameInput(steps[known], m_steps[known])) {
        steps[known] = m_steps[known];
        ++known;
    }
    m_steps = std::move(steps);
    stepFrom(known);
}

void LotTracker::stepFrom(std::size_t first) {
    const auto partBefore = [this](std::size_t i) { return i == 0 ? 0U : m_steps[i - 1].visit.part; };
    const auto base = [this](std::size_t i) -> const EstimatorState& {
        return i == 0 ? m_initial : m_steps[i - 1].after;
    };
    const auto begins = [&](std::size_t i, std::uint32_t part) -> const EstimatorState& {
        const AnnouncedChange* change = changeIn(partBefore(i), part);
        return change == nullptr ? base(i) : (m_changed[change->part] = changed(base(i), i, *change));
    };
    m_changed.erase(m_changed.upper_bound(partBefore(first)), m_changed.end());
    for (std::size_t i = first; i < m_steps.size(); ++i) {
        Step& next = m_steps[i];
        next.after =
            step(begins(i, next.visit.part), m_params, next.visit, std::span(next.rows).first(next.visit.count));
    }
    m_state = begins(m_steps.size(), std::numeric_limits<std::uint32_t>::max());
}

}  // namespace kerf::boring
