// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/service/boring/boring_recipe.h"
#include "db/api/rows.h"
#include "engine/process/boring/lot_tracker.h"

namespace kerf {

/// Diameters expected at each depth; empty where nothing is known yet.
using Predictions = std::vector<std::optional<DiameterPrediction>>;

/// A part of the lot as the service knows it.
struct ServicePart {
    PartId id{0};
    std::uint32_t number{0};
    bool complete{true};  ///< false: aborted, nothing to measure
    std::uint32_t sequence{
        0};  ///< the machine's count, for its gauge; 0: from an earlier run of the console or another lot
    BoringSchedule schedule{};
    FeedTrace feed{};
};

/// As it was stored.
[[nodiscard]] ServicePart servicePartOf(const PartDetail& detail);

/// Everything stored about the lot that the service works with, and what follows from it. No database, no engine:
/// values in, values out, so that a restart is the same computation as the shift before it.
class LotRecords {
 public:
    LotRecords(BoringRecipe recipe, boring::EstimatorKind kind, boring::LotBegin begin = {});

    /// Changes announced in this lot, in place of those before.
    void setAnnounced(std::vector<boring::AnnouncedChange> announced);

    void addPart(const ServicePart& part);
    /// A row that is safely stored. Its deflection must be usable for the estimator (see whyRefused()).
    void addRow(const MeasurementRow& row);
    /// Many rows at once, after a restart.
    void restoreRows(std::vector<MeasurementRow> rows);

    [[nodiscard]] const BoringRecipe& recipe() const noexcept { return m_recipe; }
    [[nodiscard]] const boring::LotTracker& tracker() const noexcept { return m_tracker; }
    [[nodiscard]] const std::vector<ServicePart>& parts() const noexcept { return m_parts; }
    [[nodiscard]] const std::vector<MeasurementRow>& rows() const noexcept { return m_rows; }
    [[nodiscard]] const ServicePart* part(PartId id) const noexcept;
    /// The row with this id when it still holds: not replaced, not voided.
    [[nodiscard]] const MeasurementRow* standing(MeasurementId id) const noexcept;
    [[nodiscard]] std::optional<MeasurementId> newestStanding() const noexcept;
    /// The standing row of a part and depth.
    [[nodiscard]] const MeasurementRow* measured(PartId part, std::uint8_t depth) const noexcept;

    [[nodiscard]] double deflectionOf_mm(double diameter_mm) const noexcept;
    [[nodiscard]] EntryCheck check(PartId part, std::uint8_t depth, double diameter_mm) const;
    /// The schedule that follows from the estimate, revision 0.
    [[nodiscard]] boring::FeedAdvice advice() const noexcept;
    [[nodiscard]] Predictions predictionFor(const BoringSchedule& schedule) const;
    /// Why the schedule is what it is.
    [[nodiscard]] Sentence reason() const;
    /// What the expected diameters of the next part rest on; empty before there are any.
    [[nodiscard]] Sentence restsOn() const;
    /// Number of the part that is cut next.
    [[nodiscard]] std::uint32_t nextNumber() const noexcept { return m_parts.empty() ? 1 : m_parts.back().number + 1; }
    /// Announced for it.
    [[nodiscard]] const boring::AnnouncedChange* announcedNext() const noexcept;
    /// How many of the recipe's depths this part is measured at: all when it teaches, else without the middle that was
    /// added for it.
    [[nodiscard]] std::size_t depthsOf(const ServicePart& part) const noexcept;

    /// The estimator rows to be stored with `next`, the newest row of these records, which has no id yet: every state
    /// that differs from `before`, the lot's last state at the end.
    [[nodiscard]] std::vector<EstimatorStateRow> changedStates(const boring::LotTracker& before) const;
    [[nodiscard]] EstimatorStateRow lastState() const;

 private:
    void track(const MeasurementRow& row);

    BoringRecipe m_recipe;
    std::size_t m_everyPart;  ///< depths each part is measured at; those behind are for a part that teaches
    boring::EstimatorKind m_kind;
    boring::LotTracker m_tracker;
    std::vector<ServicePart> m_parts;    ///< by number
    std::vector<MeasurementRow> m_rows;  ///< in the order of acceptance
};

[[nodiscard]] std::string predictionsJson(const Predictions& predictions);
/// Empty for a text that is none.
[[nodiscard]] Predictions predictionsFromJson(const std::string& text);
[[nodiscard]] bool sameLaw(const BoringSchedule& a, const BoringSchedule& b) noexcept;
/// Full state as stored: same state, same text.
[[nodiscard]] std::string stateJson(const boring::EstimatorState& state);

}  // namespace kerf
