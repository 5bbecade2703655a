// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "engine/core/result.h"

/// Group method of data handling: a network of two-input polynomials that grows layer by layer and chooses its inputs.
///
///   neuron     z = A + B·xi + C·xj + D·xi² + E·xj² + F·xi·xj        for every pair of inputs (Quadratic)
///              z = A + B·xi + C·xj + F·xi·xj                        (Bilinear: D = E = 0)
///   regularity r² = Σ_C (y − z)² / Σ_C y²                           eq. 10, on the check rows C
///   unbiased   u² = Σ_all (z_A − z_B)² / Σ_all y²                   eq. 11, z_A and z_B fitted on training sets A and
///   B combined   c  = √(r² + u²)                                      eq. 12
///
/// The neuron itself is fitted on A and B together. The best `width` neurons of a layer are the inputs of the next; a
/// layer whose best criterion does not fall is dropped and the best neuron before it is the model.
///
/// Source: Ivakhnenko; Ahn & Chung eqs. 9-12. Guards against what goes wrong as printed: standardised inputs, ridge
/// (λ·rows on the diagonal but the constant), every neuron clamped to its training range ± clampSpans spans, few
/// layers, and A and B as blocks (the caller's rows).
///
/// How all pairs are fitted: the normal equations of every pair are entries of X'X, (X²)'X, (X²)'(X²), (X³)'X and
/// X'·diag(y)·X, five matrix products per row set; r and u follow from the same products. Without ridge the best
/// candidates are fitted again by QR from the rows, because normal equations of nearly equal inputs lose digits.
namespace kerf::thermal {

enum class GmdhBasis : std::uint8_t { Quadratic, Bilinear };
enum class GmdhCriterion : std::uint8_t { Combined, Regularity, Unbiased };

struct GmdhOptions {
    GmdhBasis basis{GmdhBasis::Quadratic};
    GmdhCriterion criterion{GmdhCriterion::Combined};
    int width{20};                          ///< neurons kept per layer, ≥ 1
    int maxLayers{3};                       ///< ≥ 1
    double ridge{1e-3};                     ///< λ ≥ 0, on standardised inputs
    bool standardise{true};                 ///< inputs to zero mean and unit deviation over A and B, output likewise
    std::optional<double> clampSpans{1.0};  ///< empty: neurons are not clamped
    double minFall{1e-3};                   ///< the criterion must fall by this share, or growth stops

    [[nodiscard]] static GmdhOptions asPrinted() noexcept {
        return {GmdhBasis::Quadratic, GmdhCriterion::Combined, 20, 12, 0.0, true, std::nullopt, 1e-3};
    }
    /// No squares: the bilinear basis stays tame outside the training range.
    [[nodiscard]] static GmdhOptions guarded() noexcept {
        return {GmdhBasis::Bilinear, GmdhCriterion::Combined, 20, 3, 1e-3, true, 1.0, 1e-3};
    }
};

/// Row numbers of the two training sets and the check set; each row in at most one of them.
struct GmdhRows {
    std::vector<Eigen::Index> a{};
    std::vector<Eigen::Index> b{};
    std::vector<Eigen::Index> check{};
};

/// Coefficients in the order A, B, C, D, E, F of the printed equation.
using GmdhCoefficients = std::array<double, 6>;

struct GmdhNeuron {
    int i{0};  ///< inputs: of the model in layer 1, neurons of the layer before in later ones
    int j{0};
    GmdhCoefficients coef{};
    double low{-std::numeric_limits<double>::max()};  ///< output is clamped to [low, high]
    double high{std::numeric_limits<double>::max()};
    double c{0.0};
    double r{0.0};
    double u{0.0};
};

struct GmdhLayerReport {
    int inputs{0};
    int candidates{0};
    double bestCriterion{0.0};
};

/// A trained network with only the neurons its output needs. Inputs are numbered as the caller's columns.
struct GmdhModel {
    int inputCount{0};
    std::vector<double> inputMean{};   ///< 0 when not standardised
    std::vector<double> inputScale{};  ///< 1 when not standardised
    double outputMean{0.0};
    double outputScale{1.0};
    std::vector<std::vector<GmdhNeuron>> layers{};  ///< the last one has one neuron
    std::vector<GmdhLayerReport> growth{};

    /// Inputs that reach the output, rising.
    [[nodiscard]] std::vector<int> usedInputs() const;
    /// Renumber so that inputs are exactly usedInputs(), in that order.
    [[nodiscard]] GmdhModel pruned() const;
    /// `x` has inputCount values. Pure; no allocation.
    [[nodiscard]] double predict(std::span<const double> x) const noexcept;
};

/// Largest layer predict() can evaluate.
inline constexpr int kMaxGmdhWidth = 128;

/// One candidate of a layer, for tests and reports.
struct GmdhCandidate {
    int i{0};
    int j{0};
    GmdhCoefficients coef{};
    GmdhCoefficients coefA{};
    GmdhCoefficients coefB{};
    double r{0.0};
    double u{0.0};
    double c{0.0};
};

/// Every candidate of the first layer, in the order (0,1), (0,2), … , for one output, as trainGmdh ranks them.
[[nodiscard]] std::vector<GmdhCandidate> firstLayerCandidates(const Eigen::MatrixXd& x, const Eigen::VectorXd& y,
                                                              const GmdhRows& rows, const GmdhOptions& options);

/// One model per column of y (rows × outputs), from x (rows × inputs). Not for the cycle.
/// Errors: fewer than 2 inputs, or a row set with fewer rows than coefficients, or a width out of 1…kMaxGmdhWidth.
[[nodiscard]] Result<std::vector<GmdhModel>> trainGmdh(const Eigen::MatrixXd& x, const Eigen::MatrixXd& y,
                                                       const GmdhRows& rows, const GmdhOptions& options);

}  // namespace kerf::thermal
