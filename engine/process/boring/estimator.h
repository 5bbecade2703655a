// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include "engine/process/boring/kalman_estimator.h"
#include "engine/process/boring/perturbation_estimator.h"

/// Both estimators behind one value type. Which one runs is part of the parameters; the state is plain data.
namespace kerf::boring {

enum class EstimatorKind : std::uint8_t { Perturbation, Kalman };

[[nodiscard]] constexpr const char* estimatorKey(EstimatorKind kind) noexcept {
    return kind == EstimatorKind::Perturbation ? "perturbation" : "kalman";
}
[[nodiscard]] std::optional<EstimatorKind> estimatorOf(std::string_view key) noexcept;

/// σ stands in both parts; set them with withSigma().
struct EstimatorParams {
    EstimatorKind kind{EstimatorKind::Kalman};
    PerturbationParams perturbation{};
    KalmanParams kalman{};

    [[nodiscard]] double sigma_mm() const noexcept {
        return kind == EstimatorKind::Kalman ? kalman.sigma_mm : perturbation.sigma_mm;
    }
};
/// Parameters for a noise, a target and (perturbation only: the Kalman filter has its own prior) an α by experience.
[[nodiscard]] EstimatorParams estimatorParams(EstimatorKind kind, double sigma_mm, double targetDeflection_mm,
                                              double alpha0);

/// Snapshot of an estimator: copied, compared bit for bit, stored.
using EstimatorState = std::variant<PerturbationState, KalmanState>;

[[nodiscard]] EstimatorState initialState(const EstimatorParams& params) noexcept;
[[nodiscard]] Estimate estimateOf(const EstimatorState& state) noexcept;

/// One visit. `rows` is empty or has visit.count places: what the estimate was after each of the visit's measurements
/// (the Kalman filter steps again from `before` with one bore more for each row).
/// @pre `state` was made by initialState() or step() with the same params.kind
[[nodiscard]] EstimatorState step(const EstimatorState& before, const EstimatorParams& params, const PartVisit& visit,
                                  std::span<RowOutcome> rows = {},
                                  ChangeKnowledge knowledge = ChangeKnowledge::Unknown) noexcept;

/// The state as a list of numbers, for storage and comparison; same state, same numbers.
inline constexpr std::size_t kStateNumbers = 64;
struct StateNumbers {
    std::size_t count{0};
    std::array<double, kStateNumbers> value{};
};
[[nodiscard]] StateNumbers numbersOf(const EstimatorState& state) noexcept;

}  // namespace kerf::boring
