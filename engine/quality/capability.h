// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "engine/core/sentence.h"
#include "engine/quality/verdict.h"

/// How a series lies in its tolerance, and how sure that is.
///
///   Pp   = (U − L)/(6 s)                 interval  Pp·√(χ²_{n−1}(α/2)/(n−1)) … Pp·√(χ²_{n−1}(1 − α/2)/(n−1))
///   Ppk  = min(U − x̄, x̄ − L)/(3 s)      interval  Ppk ± z·√(1/(9n) + Ppk²/(2(n−1)))
///   Cp, Cpk: the same figures, claimed only while the residual chart is quiet
///
/// The distinction is ISO 22514's: performance (Pp, Ppk) describes the parts that were made and is always allowed;
/// capability (Cp, Cpk) promises the next ones and needs a process in control. One-sided tolerances have Ppk alone.
/// The variance of the gauge is inside s and is not subtracted. Values, limits and s share the unit of the
/// characteristic.
namespace kerf::quality {

inline constexpr std::size_t kFewestForIndices = 10;   ///< below: no index at all
inline constexpr std::size_t kPreliminaryBelow = 50;   ///< below: indices are preliminary
inline constexpr double kCapabilityConfidence = 0.95;  ///< two-sided

/// n, mean and s of a series, in one pass (Welford): also for a million values.
class Moments {
 public:
    void add(double value) noexcept;
    [[nodiscard]] std::size_t count() const noexcept { return m_count; }
    [[nodiscard]] double mean() const noexcept { return m_first + m_meanOff; }
    /// With n − 1; 0 below two values.
    [[nodiscard]] double deviation() const noexcept;
    [[nodiscard]] double smallest() const noexcept { return m_smallest; }
    [[nodiscard]] double largest() const noexcept { return m_largest; }

 private:
    std::size_t m_count{0};
    double m_first{0.0};    ///< counted from: a spread of µm on a value of metres keeps its digits
    double m_meanOff{0.0};  ///< of the distances from it
    double m_squares{0.0};
    double m_smallest{0.0};
    double m_largest{0.0};
};

struct IndexWithInterval {
    double value{0.0};
    double low{0.0};
    double high{0.0};
};

struct Capability {
    std::size_t count{0};
    double mean{0.0};
    double deviation{0.0};                  ///< s with n − 1
    std::optional<IndexWithInterval> pp{};  ///< two-sided tolerances only
    std::optional<IndexWithInterval> ppk{};
    std::optional<IndexWithInterval> cp{};  ///< only while the residual chart is quiet
    std::optional<IndexWithInterval> cpk{};
    bool preliminary{false};
    Sentence reason{};  ///< why something above is missing; empty when nothing is
};

/// `quiet`: the residual chart shows no signal over these parts.
[[nodiscard]] Capability capability(const Moments& moments, const Tolerance& tolerance, bool quiet,
                                    double confidence = kCapabilityConfidence);
[[nodiscard]] Capability capability(std::span<const double> values, const Tolerance& tolerance, bool quiet,
                                    double confidence = kCapabilityConfidence);

/// The intervals alone. @pre n ≥ 2, 0 < confidence < 1
[[nodiscard]] IndexWithInterval potentialInterval(double index, std::size_t n, double confidence);
[[nodiscard]] IndexWithInterval centredInterval(double index, std::size_t n, double confidence);

}  // namespace kerf::quality
