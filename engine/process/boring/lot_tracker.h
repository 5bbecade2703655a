// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "engine/core/result.h"
#include "engine/process/boring/boring_types.h"
#include "engine/process/boring/estimator.h"
#include "engine/process/boring/feed_law.h"
#include "engine/process/boring/memory.h"

namespace kerf::boring {

/// A part as it was cut: the schedule it had then, and the really cut feed where the loop recorded one.
struct CutPart {
    std::uint32_t number{0};  ///< ≥ 1 within the lot
    BoringSchedule schedule{};
    FeedTrace feed{};  ///< empty: the schedule's feed was cut
};
/// Feed at an overhang: from the trace (straight line between its points, nearest point outside), else the schedule.
/// Within 3 mm of an end, where the axis runs up from a standstill or down to it, the feed next to it counts: a gauge's
/// contact has a length and stays off the edge.
[[nodiscard]] double cutFeed_mmPerRev(const CutPart& part, double overhang_mm) noexcept;

/// What a lot begins from. Without memory: the wide prior, and announced changes are not used. The paper's estimator
/// has no memory.
struct LotBegin {
    bool memory{false};
    MemoryContext context{};
    std::shared_ptr<const std::vector<PastLot>> past{};  ///< may be null: no past
};

/// The ordered history of one lot and the estimate it leads to.
///
/// Whatever is added late, voided or corrected, the state is the one a fresh replay of the surviving history gives, bit
/// for bit: the history is grouped into visits, and everything after the first visit that differs is stepped again.
///   kalman        one visit per part, parts in the order of their numbers: a late bore is used where it belongs, and
///                 together with the part's other bores (the change test counts as many as there are)
///   perturbation  in the order of entry, as the paper takes it; neighbours of the same part form a visit
/// A correction takes the place of what it replaces. With memory the first part begins from the lots before, and the
/// first part after an announced change from them and from what this lot has shown. Not in the cycle: allocates.
class LotTracker {
 public:
    using EntryId = std::int64_t;

    struct Entry {
        EntryId id{0};
        std::uint32_t part{0};
        Measurement measurement{};
    };
    /// One visit with what came of it.
    struct Step {
        PartVisit visit{};
        std::array<EntryId, kMaxBoreDepths> ids{};
        std::array<RowOutcome, kMaxBoreDepths> rows{};
        EstimatorState after{};
        [[nodiscard]] bool perturbed() const noexcept;
        [[nodiscard]] double statistic() const noexcept {
            return visit.count > 0 ? rows[visit.count - 1U].statistic : 0.0;
        }
    };

    explicit LotTracker(const EstimatorParams& params, LotBegin begin = {});

    /// A part that has been cut. Numbers may come in any order, each once.
    [[nodiscard]] Result<void> addPart(const CutPart& part);
    /// A bore of a cut part. The feed is the one that part was cut with at this overhang.
    [[nodiscard]] Result<void> add(EntryId id, std::uint32_t part, double overhang_mm, double deflection_mm);
    /// `replacement` takes the place of `id`.
    [[nodiscard]] Result<void> correct(EntryId id, EntryId replacement, double deflection_mm);
    [[nodiscard]] Result<void> voidEntry(EntryId id);

    /// All changes announced in this lot, in place of those before.
    void setAnnounced(std::vector<AnnouncedChange> announced);

    /// A whole history at once (restart, replay of a file): as if added one by one. @pre the tracker is empty, entries
    /// are usable, and no part has more than kMaxBoreDepths of them
    void restore(std::vector<CutPart> parts, std::vector<Entry> entries);

    [[nodiscard]] const EstimatorParams& params() const noexcept { return m_params; }
    /// What the next part is cut with: an announced change that no measured part shows yet counts.
    [[nodiscard]] const EstimatorState& state() const noexcept { return m_state; }
    /// After the newest measured part, whatever was announced since.
    [[nodiscard]] const EstimatorState& measuredState() const noexcept {
        return m_steps.empty() ? m_initial : m_steps.back().after;
    }
    /// With the bores of all parts below `part` and the changes announced for them.
    [[nodiscard]] const EstimatorState& stateBefore(std::uint32_t part) const noexcept;
    /// What the bores of this part were expected from: a change announced for it counts too.
    [[nodiscard]] const EstimatorState& stateFor(std::uint32_t part) const noexcept;
    [[nodiscard]] const LotBegin& begin() const noexcept { return m_begin; }
    /// The lot began from the lots before it.
    [[nodiscard]] bool fromMemory() const noexcept { return estimateOf(m_initial).ready; }
    /// It began so, or an announced change has drawn on memory since.
    [[nodiscard]] bool drewOnMemory() const noexcept { return fromMemory() || !m_changed.empty(); }
    [[nodiscard]] const std::vector<AnnouncedChange>& announced() const noexcept { return m_announced; }
    /// Memory with what the lot has shown up to the newest measured part.
    [[nodiscard]] Memory memoryNow() const;
    /// What the lot leaves to the next ones.
    [[nodiscard]] std::vector<Stretch> stretches() const;
    [[nodiscard]] const std::vector<Step>& steps() const noexcept { return m_steps; }
    /// Surviving entries in the order they were made.
    [[nodiscard]] const std::vector<Entry>& entries() const noexcept { return m_entries; }
    [[nodiscard]] const std::vector<CutPart>& parts() const noexcept { return m_parts; }
    [[nodiscard]] const CutPart* part(std::uint32_t number) const noexcept;

 private:
    [[nodiscard]] std::vector<Entry>::iterator find(EntryId id);
    /// Regroups the history and steps again from the first visit that differs.
    void replay();
    /// The newest entry came last in order: only the last visit changes, or a new one begins.
    [[nodiscard]] bool appendNewest();
    void stepFrom(std::size_t first);
    [[nodiscard]] std::vector<Stretch> stretchesOfFirst(std::size_t steps) const;
    [[nodiscard]] const EstimatorState& stateBelow(std::uint32_t part, std::uint32_t announcedTo) const noexcept;
    /// The last change announced for a part in (after, to]; null: none, or no memory.
    [[nodiscard]] const AnnouncedChange* changeIn(std::uint32_t after, std::uint32_t to) const noexcept;
    /// What holds after that change, with the first `steps` steps known.
    [[nodiscard]] EstimatorState changed(const EstimatorState& before, std::size_t steps,
                                         const AnnouncedChange& change) const;

    EstimatorParams m_params;
    LotBegin m_begin;
    EstimatorState m_initial;
    EstimatorState m_state;
    std::vector<AnnouncedChange> m_announced;
    std::map<std::uint32_t, EstimatorState> m_changed;  ///< by the part the change was announced for
    std::vector<CutPart> m_parts;                       ///< by number
    std::vector<Entry> m_entries;                       ///< by entry
    std::vector<Step> m_steps;                          ///< by visit
};

}  // namespace kerf::boring
