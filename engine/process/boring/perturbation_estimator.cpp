// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/boring/perturbation_estimator.h"

#include <algorithm>
#include <cmath>

namespace kerf::boring {
namespace {

constexpr std::uint8_t kRunLength = 3;
constexpr double kBandSigmas = 3.0;

Eigen::Vector3d regressor(const Measurement& m) noexcept {
    return {1.0, std::log(m.feed_mmPerRev), std::log(m.overhang_mm)};
}

std::uint8_t& counterAt(PerturbationState& state, double overhang_mm) noexcept {
    for (std::uint8_t i = 0; i < state.overhangCount; ++i) {
        if (state.overhang_mm[i] == overhang_mm) {
            return state.inARowAt[i];
        }
    }
    if (state.overhangCount == kMaxBoreDepths) {  // more depths than a bore has: the oldest makes room
        std::rotate(state.overhang_mm.begin(), state.overhang_mm.begin() + 1, state.overhang_mm.end());
        std::rotate(state.inARowAt.begin(), state.inARowAt.begin() + 1, state.inARowAt.end());
        --state.overhangCount;
    }
    state.overhang_mm[state.overhangCount] = overhang_mm;
    state.inARowAt[state.overhangCount] = 0;
    return state.inARowAt[state.overhangCount++];
}

void apply(PerturbationState& state, const PerturbationParams& params, const Measurement& m) noexcept {
    const double ratio = params.sigma_mm / params.targetDeflection_mm;
    const double r = ratio * ratio;
    const double a = params.noise == PerturbationParams::Noise::Unit ? 1.0 : r;
    const double b = params.noise == PerturbationParams::Noise::Consistent ? r : 1.0;
    Eigen::Vector3d theta = vectorOf(state.law);
    Eigen::Matrix3d p = matrixOf(state.covariance);
    recursiveLeastSquaresStep(theta, p, regressor(m), std::log(m.deflection_mm), a, b);
    state.law = lawOf(theta);
    state.covariance = covarianceOf(p);
}

/// Eqs. 9-10 as soon as two of the waiting measurements have different overhangs.
bool begin(PerturbationState& state, const PerturbationParams& params, std::uint32_t part) noexcept {
    const Measurement& newest = state.waiting[state.waitingCount - 1U];
    for (std::uint8_t i = 0; i + 1 < state.waitingCount; ++i) {
        if (state.waiting[i].overhang_mm != newest.overhang_mm) {
            state.law = firstEstimate(params.alpha0, state.waiting[i], newest);
            state.ready = true;
            state.firstPart = part;
            return true;
        }
    }
    return false;
}

RowOutcome outcomeOf(const PerturbationState& state, bool perturbed) noexcept {
    const auto longest = std::max(state.inARow, *std::ranges::max_element(state.inARowAt));
    return {{state.ready, state.law, state.covariance},
            perturbed,
            perturbed ? double{kRunLength} : static_cast<double>(longest)};
}

}  // namespace

double recursiveLeastSquaresStep(Eigen::Vector3d& theta, Eigen::Matrix3d& p, const Eigen::Vector3d& x, double y,
                                 double a, double b) noexcept {
    const Eigen::Vector3d px = p * x;
    const double xpx = x.dot(px);
    const double innovation = y - x.dot(theta);
    theta += px * (innovation / (a + xpx));
    p -= px * (px.transpose() / (b + xpx));
    return innovation;
}

bool noticeOutside(PerturbationState& state, const PerturbationParams& params,
                   const Measurement& measurement) noexcept {
    if (measurement.feedAtLimit) {
        return false;
    }
    const bool outside =
        std::abs(measurement.deflection_mm - params.targetDeflection_mm) > kBandSigmas * params.sigma_mm;
    std::uint8_t& here = counterAt(state, measurement.overhang_mm);
    state.inARow = outside ? static_cast<std::uint8_t>(state.inARow + 1) : std::uint8_t{0};
    here = outside ? static_cast<std::uint8_t>(here + 1) : std::uint8_t{0};
    const bool consecutive = params.trigger != PerturbationParams::Trigger::SameOverhang && state.inARow >= kRunLength;
    const bool sameOverhang = params.trigger != PerturbationParams::Trigger::Consecutive && here >= kRunLength;
    if (!consecutive && !sameOverhang) {
        return false;
    }
    state.inARow = 0;
    state.inARowAt.fill(0);
    return true;
}

PerturbationState update(const PerturbationState& before, const PerturbationParams& params, const PartVisit& visit,
                         std::span<RowOutcome> rows) noexcept {
    PerturbationState state = before;
    const auto note = [&](std::size_t row, bool perturbed) {
        if (!rows.empty()) {
            rows[row] = outcomeOf(state, perturbed);
        }
    };
    for (std::size_t i = 0; i < visit.count; ++i) {
        const Measurement& m = visit.rows[i];
        if (!state.ready) {
            if (state.waitingCount == kMaxBoreDepths) {
                std::rotate(state.waiting.begin(), state.waiting.begin() + 1, state.waiting.end());
                --state.waitingCount;
            }
            state.waiting[state.waitingCount++] = m;
            note(i, false);
            if (begin(state, params, visit.part)) {
                for (std::size_t k = 0; k < state.waitingCount; ++k) {
                    if (params.firstPartUpdates) {
                        apply(state, params, state.waiting[k]);
                    }
                    if (i + 1 + k >= state.waitingCount) {  // this visit's own rows
                        note(i + 1 + k - state.waitingCount, false);
                    }
                }
                state.waitingCount = 0;
                state.waiting = {};
            }
            continue;
        }
        const bool watched = visit.part > state.firstPart;
        const bool perturbed = watched && noticeOutside(state, params, m);
        if (perturbed && params.timing == PerturbationParams::Timing::BeforeUpdate) {
            state.covariance = PerturbationState{}.covariance;
        }
        if (watched || params.firstPartUpdates) {
            apply(state, params, m);
        }
        if (perturbed && params.timing == PerturbationParams::Timing::AfterUpdate) {
            state.covariance = PerturbationState{}.covariance;
        }
        note(i, perturbed);
    }
    return state;
}

}  // namespace kerf::boring
