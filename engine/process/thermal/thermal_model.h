// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/process/thermal/compensation.h"
#include "engine/process/thermal/day_layer.h"
#include "engine/process/thermal/features.h"
#include "engine/process/thermal/gmdh.h"

/// A trained thermal model as data: what a model file holds, what the estimator is built from.
namespace kerf::thermal {

enum class ModelKind : std::uint8_t { GmdhPaper, Gmdh, Regression, Hierarchical };
inline constexpr int kModelVersion = 1;
inline constexpr std::size_t kMaxRegressionSensors = 14;
inline constexpr std::size_t kMaxModelSensors = 64;

using PerAxis = std::array<double, kAxes>;

struct Range {
    double low{0.0};
    double high{0.0};
    [[nodiscard]] double span() const noexcept { return high - low; }
};

/// How far a sensor's leaky mean is beyond its training range, in spans; 0 inside and up to a tenth of a span outside.
[[nodiscard]] double outsideSpans(const Range& trained_K, double leaky_K) noexcept;
/// The interval outside the training range: × (1 + 3 · spans).
[[nodiscard]] constexpr double intervalWidening(double outside) noexcept {
    return 1.0 + 3.0 * outside;
}

/// One sensor the model reads, with what its health is judged by.
struct ModelSensor {
    std::string name{};
    double noise_K{0.0};        ///< σ of one reading, from second differences of the training days
    int longestRepeat{0};       ///< equal readings in a row seen in training
    double restPattern_K{0.0};  ///< baseline reading minus the mean over the model's sensors, machine at rest
    std::array<Range, kTermsPerSensor> range{};  ///< of its terms over the training days, K
};

/// One ridge regression as its normal equations, so that it can be solved again without any two of its sensors.
///
///   (G + λ_axis·rows·diag(s²))·w = g_axis       G = XᵀX, g = Xᵀy, s² = mean square of each term
struct NormalEquations {
    int sensors{0};            ///< terms beyond 3 · sensors are heat terms
    Eigen::MatrixXd gram{};    ///< terms × terms
    Eigen::MatrixXd moment{};  ///< terms × axes
    double rows{0.0};
    PerAxis ridge{};  ///< λ of temperature terms per axis; heat terms have kSpeedRidge
    /// Half width of the 95 % interval per lost set (see lostSetIndex), µm.
    std::vector<PerAxis> half_um{};
};
inline constexpr double kSpeedRidge = 1e-4;

/// No sensor lost: 0. Sensor i lost: 1 + i. Sensors i < j lost: after those, (0,1), (0,2), … , (1,2), …
[[nodiscard]] std::size_t lostSetIndex(std::size_t sensors) noexcept;
[[nodiscard]] std::size_t lostSetIndex(std::size_t sensors, std::size_t i) noexcept;
[[nodiscard]] std::size_t lostSetIndex(std::size_t sensors, std::size_t i, std::size_t j) noexcept;
[[nodiscard]] constexpr std::size_t lostSetCount(std::size_t sensors) noexcept {
    return 1 + sensors + sensors * (sensors - 1) / 2;
}

/// Coefficients of the terms of the sensors left, zero for lost ones; terms × axes. @pre lost ≤ 2 entries, in range
[[nodiscard]] Eigen::MatrixXd solveWithout(const NormalEquations& equations, const std::vector<std::size_t>& lost);

struct RegressionPart {
    NormalEquations temperatures{};              ///< 3 terms per sensor
    std::optional<NormalEquations> withSpeed{};  ///< 3 terms per sensor and 3 heat terms; only for a start at rest
};

enum class InputKind : std::uint8_t {
    Term,
    Now,
    Before
};  ///< Term: one of a sensor's three; Now, Before: absolute degC
struct GmdhInput {
    int sensor{0};
    InputKind kind{InputKind::Term};
    int term{0};
};
struct GmdhPart {
    std::array<GmdhModel, kAxes> network{};              ///< pruned
    std::array<std::vector<GmdhInput>, kAxes> inputs{};  ///< what each network's inputs are
    PerAxis half_um{};
};

/// How well a model does on days it has not seen.
struct Judgement {
    bool heldOut{false};  ///< false: one training day only, judged on its own check rows
    PerAxis rms_um{};     ///< of the drift, measurement noise taken off
    PerAxis worst_um{};   ///< of measured minus predicted: contains the measurement's own noise
};

struct ThermalModel {
    ModelKind kind{ModelKind::Regression};
    FeatureSpec features{};
    std::vector<ModelSensor> sensors{};
    Eigen::MatrixXd riseMoment_K2{};  ///< sensors × sensors: mean of r·rᵀ over training, for the neighbours' opinion
    std::array<Range, kAxes> drift_um{};  ///< over the training days
    std::optional<RegressionPart> regression{};
    std::optional<GmdhPart> gmdh{};
    std::optional<DayLayer> days{};  ///< of a hierarchical model, on the regression as its mean law
    std::array<bool, kAxes> axes{true, true,
                                 true};  ///< axes that were measured in training; the others are not predicted
    Judgement judgement{};
    std::uint64_t fingerprint{0};
    std::vector<std::string> trainedOn{};
    int trainingRows{0};
    double period_min{1.0};
};

[[nodiscard]] const char* modelKindKey(
    ModelKind kind) noexcept;  ///< "gmdh-paper", "gmdh", "regression", "hierarchical"

/// One line per axis a person can read, all sensors healthy. Not for the cycle.
[[nodiscard]] std::vector<std::string> formulaLines(const ThermalModel& model);

}  // namespace kerf::thermal
