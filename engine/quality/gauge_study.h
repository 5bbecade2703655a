// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "engine/core/result.h"

/// Studies of a gauge: is it good enough for the tolerance, and how much do repetition and person add?
///
///   type 1   one reference x_m, n ≥ 25 readings   Cg = .2 T/(6 s), Cgk = (.1 T − |x̄ − x_m|)/(3 s), pass at 1.33
///   crossed  every person measures every part equally often
///     average and range  EV = R̄ K1, AV² = (X̄diff K2)² − EV²/(n r), PV = R_p K3
///     ANOVA              variance components from mean squares; the interaction is pooled when its F test says so
///     both               GRR² = EV² + AV² (+ interaction²), TV² = GRR² + PV², ndc = ⌊1.41 PV/GRR⌋
///
/// n parts, k persons, r trials. Source: AIAG, Measurement Systems Analysis, with its rounded constants K (products of
/// tables of d2*); larger studies than its tables use the same constants to more places. Negative variance components
/// are 0 and said so. Values, T and x_m share the unit of the characteristic.
namespace kerf::quality {

inline constexpr std::size_t kFewestTypeOneReadings = 25;
inline constexpr double kGaugePass = 1.33;
/// Significance above which the interaction of persons and parts is pooled with the repeatability (AIAG).
inline constexpr double kPoolingAlpha = 0.05;

struct TypeOneStudy {
    std::size_t count{0};
    double mean{0.0};
    double deviation{0.0};         ///< s with n − 1: the repeatability
    double cg{0.0};                ///< 0: s is 0, see below
    std::optional<double> cgk{};   ///< only with a reference
    std::optional<double> bias{};  ///< x̄ − x_m
    double deviationLow{0.0};      ///< 95 % interval of σ, by χ²
    double deviationHigh{0.0};
    bool pass{false};  ///< every index there is is at least 1.33
};

/// From n, x̄ and s. Refused: n < 25, T ≤ 0, s ≤ 0 (a gauge that never varies is stuck or too coarse).
[[nodiscard]] Result<TypeOneStudy> typeOneStudy(std::size_t count, double mean, double deviation, double tolerance,
                                                std::optional<double> reference);
[[nodiscard]] Result<TypeOneStudy> typeOneStudy(std::span<const double> readings, double tolerance,
                                                std::optional<double> reference);

/// One reading of a crossed study. Parts, persons and trials count from 0 without gaps.
struct StudyReading {
    std::uint32_t part{0};
    std::uint32_t person{0};
    std::uint32_t trial{0};
    double value{0.0};
};

struct CrossedStudy {
    std::size_t parts{0};
    std::size_t persons{0};
    std::size_t trials{0};
    double ev{0.0};           ///< repeatability (equipment variation), a standard deviation
    double av{0.0};           ///< reproducibility (appraiser variation)
    double interaction{0.0};  ///< ANOVA, not pooled
    double grr{0.0};
    double pv{0.0};                                 ///< part variation
    double tv{0.0};                                 ///< total variation
    double grrPercent{0.0};                         ///< 100 GRR/TV
    std::optional<double> grrPercentOfTolerance{};  ///< 100·6 GRR/T
    std::uint32_t ndc{0};                           ///< distinct categories, at least 1
    double evLow{0.0};                              ///< 95 % interval of the repeatability, by χ²
    double evHigh{0.0};
    bool avNegative{false};  ///< the variance component came out negative and was set to 0
    bool pvNegative{false};
    bool interactionNegative{false};

    // average and range
    double meanRange{0.0};   ///< R̄
    double personDiff{0.0};  ///< X̄diff
    double partRange{0.0};   ///< R_p

    // ANOVA
    double ssPerson{0.0};
    double ssPart{0.0};
    double ssInteraction{0.0};
    double ssRepeatability{0.0};
    double ssTotal{0.0};
    std::optional<double> fInteraction{};  ///< none: the repeated readings are all alike
    double pInteraction{1.0};
    bool pooled{false};
};

enum class StudyMethod : std::uint8_t { AverageRange, Anova };

/// Refused with the reason: not crossed (a cell is missing or stands twice), fewer than 2 parts, persons or trials,
/// more than 25 of one of them with average and range, T ≤ 0, no variation at all.
[[nodiscard]] Result<CrossedStudy> crossedStudy(std::span<const StudyReading> readings, StudyMethod method,
                                                std::optional<double> tolerance);

}  // namespace kerf::quality
