// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/core/result.h"
#include "engine/process/boring/boring_types.h"
#include "engine/process/boring/estimator.h"
#include "engine/process/boring/feed_law.h"

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

/// The ordered history of one lot and the estimate it leads to.
///
/// Whatever is added late, voided or corrected, the state is the one a fresh replay of the surviving history gives, bit
/// for bit: the history is grouped into visits, and everything after the first visit that differs is stepped again.
///   kalman        one visit per part, parts in the order of their numbers: a late bore is used where it belongs, and
///                 together with the part's other bores (the change test counts as many as there are)
///   perturbation  in the order of entry, as the paper takes it; neighbours of the same part form a visit
/// A correction takes the place of what it replaces. Not in the cycle: allocates.
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

    explicit LotTracker(const EstimatorParams& params);

    /// A part that has been cut. Numbers may come in any order, each once.
    [[nodiscard]] Result<void> addPart(const CutPart& part);
    /// A bore of a cut part. The feed is the one that part was cut with at this overhang.
    [[nodiscard]] Result<void> add(EntryId id, std::uint32_t part, double overhang_mm, double deflection_mm);
    /// `replacement` takes the place of `id`.
    [[nodiscard]] Result<void> correct(EntryId id, EntryId replacement, double deflection_mm);
    [[nodiscard]] Result<void> voidEntry(EntryId id);

    /// A whole history at once (restart, replay of a file): as if added one by one. @pre the tracker is empty, entries
    /// are usable, and no part has more than kMaxBoreDepths of them
    void restore(std::vector<CutPart> parts, std::vector<Entry> entries);

    [[nodiscard]] const EstimatorParams& params() const noexcept { return m_params; }
    [[nodiscard]] const EstimatorState& state() const noexcept {
        return m_steps.empty() ? m_initial : m_steps.back().after;
    }
    /// State before the first visit to `part` (or a later one): what its prediction rests on.
    [[nodiscard]] const EstimatorState& stateBefore(std::uint32_t part) const noexcept;
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

    EstimatorParams m_params;
    EstimatorState m_initial;
    std::vector<CutPart> m_parts;  ///< by number
    std::vector<Entry> m_entries;  ///< by entry
    std::vector<Step> m_steps;     ///< by visit
};

}  // namespace kerf::boring
