// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/boring/boring_view.h"

#include <algorithm>
#include <cmath>

namespace kerf {
namespace {

constexpr std::size_t kPartsShown = 25;
constexpr double kTwoSided95 = 1.959963984540054;

BoringChange changeOf(boring::StretchKind kind) {
    switch (kind) {
        case boring::StretchKind::Reground:
            return BoringChange::Reground;
        case boring::StretchKind::Material:
            return BoringChange::Material;
        default:
            return BoringChange::Insert;
    }
}

void addEstimates(const LotRecords& records, BoringServiceView& view) {
    for (const auto& step : records.tracker().steps()) {
        const boring::Estimate estimate = boring::estimateOf(step.after);
        if (!estimate.ready) {
            continue;
        }
        const auto& p = estimate.covariance;
        view.estimates.push_back(
            {step.visit.part,
             {estimate.law.lnC, estimate.law.alpha, estimate.law.beta},
             {kTwoSided95 * std::sqrt(std::max(0.0, p[0])), kTwoSided95 * std::sqrt(std::max(0.0, p[3])),
              kTwoSided95 * std::sqrt(std::max(0.0, p[5]))}});
    }
}

void addNext(const BoringViewBasis& basis, BoringServiceView& view) {
    const LotRecords& records = basis.records;
    const boring::FeedAdvice advice = records.advice();
    view.nextSchedule = basis.next;
    if (const auto predicted = basis.predictions.find(basis.next.revision); predicted != basis.predictions.end()) {
        view.nextPrediction = predicted->second;
    }
    view.nextRestsOn = records.restsOn();
    if (const auto* announced = records.announcedNext(); announced != nullptr && basis.showsAnnounced) {
        view.announced = changeOf(announced->kind);
    }
    view.nextLimited = advice.limited;
    view.nextReason = advice.limited ? advice.reason : records.reason();
    view.scheduleAccepted = basis.accepted;
}

/// Values of a part that a person sees: what holds, and what was taken out; not what a correction stands for.
void addMeasurements(const LotRecords& records, PartId part, BorePartView& shown) {
    for (const MeasurementRow& row : records.rows()) {
        if (row.part != part || row.kind == MeasurementKind::Void) {
            continue;
        }
        const bool replaced = std::ranges::any_of(records.rows(), [&](const MeasurementRow& later) {
            return later.replaces == row.id && later.kind == MeasurementKind::Correction;
        });
        if (!replaced) {
            const bool standing = records.standing(row.id) != nullptr;
            shown.measurements.push_back({row.id, row.station, row.diameter_mm.value_or(0.0), !standing,
                                          row.kind == MeasurementKind::Correction});
        }
    }
}

Sentence whyPerturbed(const BoringViewBasis& basis, const boring::LotTracker::Step& step) {
    return basis.kind == boring::EstimatorKind::Kalman
               ? Sentence(KERF_TEXT("The bores differ from their prediction by more than chance: T² %1, limit %2."),
                          SentenceArg(step.statistic(), 1), SentenceArg(boring::changeThreshold(step.visit.count), 1))
               : Sentence(KERF_TEXT("Three measurements in a row lie more than 3σ off the target deflection."));
}

BorePartView partView(const BoringViewBasis& basis, const ServicePart& part, BoringServiceView& view) {
    const LotRecords& records = basis.records;
    BorePartView shown;
    shown.id = part.id;
    shown.number = part.number;
    shown.cut = part.complete;
    shown.schedule = part.schedule;
    shown.feed = part.feed;
    addMeasurements(records, part.id, shown);
    shown.complete = part.complete;
    for (std::uint8_t depth = 0; depth < records.depthsOf(part) && part.complete; ++depth) {
        if (records.measured(part.id, depth) == nullptr) {
            shown.complete = false;
            if (!view.awaiting) {
                view.awaiting = part.id;
                view.awaitingDepth = depth;
            }
        }
    }
    if (const auto predicted = basis.predictions.find(part.schedule.revision); predicted != basis.predictions.end()) {
        shown.predicted = predicted->second;
    }
    shown.predicted.resize(view.depths.size());
    for (const auto& step : records.tracker().steps()) {
        if (step.visit.part == part.number && step.perturbed()) {
            shown.perturbed = true;
            shown.perturbedReason = whyPerturbed(basis, step);
        }
    }
    return shown;
}

/// Cpk at one depth over the shown parts; none below kFewestParts.
std::optional<CapabilityView> capabilityAt(const BoringViewBasis& basis, const BoringServiceView& view,
                                           std::uint8_t depth) {
    double sum = 0.0;
    double squares = 0.0;
    std::uint32_t count = 0;
    for (const BorePartView& part : view.parts) {
        if (const MeasurementRow* row = basis.records.measured(part.id, depth)) {
            const double off_mm = *row->diameter_mm - view.targetDiameter_mm;  // small numbers: no cancellation
            sum += off_mm;
            squares += off_mm * off_mm;
            ++count;
        }
    }
    if (count < CapabilityView::kFewestParts) {
        return std::nullopt;
    }
    const double mean_mm = sum / count;
    const double variance_mm2 = (squares - sum * mean_mm) / (count - 1.0);
    if (variance_mm2 <= 0.0) {
        return std::nullopt;
    }
    const double room_mm = std::min(view.upperTolerance_mm - view.targetDiameter_mm - mean_mm,
                                    view.targetDiameter_mm + mean_mm - view.lowerTolerance_mm);
    return CapabilityView{room_mm / (3.0 * std::sqrt(variance_mm2)), depth, count};
}

}  // namespace

BoringServiceView boringView(const BoringViewBasis& basis) {
    const LotRecords& records = basis.records;
    const BoringRecipe& recipe = records.recipe();
    BoringServiceView view;
    view.partType = basis.lot.partTypeName;
    view.lot = basis.lot.name;
    view.lotSize = basis.lot.size;
    view.lotClosed = basis.lot.closedUtc_ms.has_value();
    view.recipeRevision = basis.recipeRevision;
    view.targetDiameter_mm = recipe.targetDiameter_mm;
    view.settingRing_mm = recipe.settingRing_mm;
    view.lowerTolerance_mm = recipe.lowerTolerance_mm;
    view.upperTolerance_mm = recipe.upperTolerance_mm;
    view.depths = recipe.depths;
    view.estimator = boring::estimatorKey(basis.kind);
    addEstimates(records, view);
    addNext(basis, view);
    const auto& all = records.parts();
    const std::size_t first = all.size() > kPartsShown ? all.size() - kPartsShown : 0;
    for (std::size_t i = first; i < all.size(); ++i) {
        view.parts.push_back(partView(basis, all[i], view));
    }
    for (std::uint8_t depth = 0; depth < view.depths.size(); ++depth) {
        const auto found = capabilityAt(basis, view, depth);
        if (found && (!view.capability || found->cpk < view.capability->cpk)) {
            view.capability = found;
        }
    }
    return view;
}

}  // namespace kerf
