// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/boring/estimator.h"

#include <algorithm>
#include <cassert>

namespace kerf::boring {
namespace {

struct Collector {
    StateNumbers out{};
    void add(double value) noexcept {
        assert(out.count < kStateNumbers);
        out.value[out.count++] = value;
    }
    void add(const LawConstants& law) noexcept {
        add(law.lnC);
        add(law.alpha);
        add(law.beta);
    }
    void add(const Covariance& covariance) noexcept {
        for (const double value : covariance) {
            add(value);
        }
    }
};

StateNumbers numbers(const PerturbationState& state) noexcept {
    Collector all;
    all.add(state.ready ? 1.0 : 0.0);
    all.add(state.firstPart);
    all.add(state.law);
    all.add(state.covariance);
    all.add(state.inARow);
    for (std::size_t i = 0; i < state.overhangCount; ++i) {
        all.add(state.overhang_mm[i]);
        all.add(state.inARowAt[i]);
    }
    for (std::size_t i = 0; i < state.waitingCount; ++i) {
        all.add(state.waiting[i].overhang_mm);
        all.add(state.waiting[i].feed_mmPerRev);
        all.add(state.waiting[i].deflection_mm);
    }
    return all.out;
}

StateNumbers numbers(const KalmanState& state) noexcept {
    Collector all;
    all.add(state.ready ? 1.0 : 0.0);
    all.add(state.part);
    all.add(state.lnFeed);
    all.add(state.lnOverhang);
    for (const KalmanMode& mode : state.modes) {
        all.add(mode.law);
        all.add(mode.covariance);
    }
    all.add(state.movingProbability);
    return all.out;
}

}  // namespace

std::optional<EstimatorKind> estimatorOf(std::string_view key) noexcept {
    for (const auto kind : {EstimatorKind::Perturbation, EstimatorKind::Kalman}) {
        if (key == estimatorKey(kind)) {
            return kind;
        }
    }
    return std::nullopt;
}

EstimatorParams estimatorParams(EstimatorKind kind, double sigma_mm, double targetDeflection_mm, double alpha0) {
    EstimatorParams params;
    params.kind = kind;
    params.perturbation.sigma_mm = sigma_mm;
    params.perturbation.targetDeflection_mm = targetDeflection_mm;
    params.perturbation.alpha0 = alpha0;
    params.kalman.sigma_mm = sigma_mm;
    return params;
}

EstimatorState initialState(const EstimatorParams& params) noexcept {
    if (params.kind == EstimatorKind::Perturbation) {
        return PerturbationState{};
    }
    return KalmanState{};
}

Estimate estimateOf(const EstimatorState& state) noexcept {
    if (const auto* kalman = std::get_if<KalmanState>(&state)) {
        return combined(*kalman);
    }
    if (const auto* perturbation = std::get_if<PerturbationState>(&state)) {
        return {perturbation->ready, perturbation->law, perturbation->covariance};
    }
    return {};
}

EstimatorState step(const EstimatorState& before, const EstimatorParams& params, const PartVisit& visit,
                    std::span<RowOutcome> rows, ChangeKnowledge knowledge) noexcept {
    if (const auto* perturbation = std::get_if<PerturbationState>(&before)) {
        return update(*perturbation, params.perturbation, visit, rows);
    }
    const auto* kalman = std::get_if<KalmanState>(&before);
    if (kalman == nullptr) {
        return before;
    }
    PartVisit soFar = visit;
    for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
        soFar.count = static_cast<std::uint8_t>(i + 1);
        (void)update(*kalman, params.kalman, soFar, &rows[i], knowledge);
    }
    return update(*kalman, params.kalman, visit, rows.empty() ? nullptr : &rows.back(), knowledge);
}

StateNumbers numbersOf(const EstimatorState& state) noexcept {
    return std::visit([](const auto& s) { return numbers(s); }, state);
}

}  // namespace kerf::boring
