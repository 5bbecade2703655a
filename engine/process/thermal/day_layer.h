// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/process/thermal/compensation.h"
#include "engine/process/thermal/features.h"

/// What one day may differ from the machine's mean law by, and what a measurement of the origin says about it.
///
///   drift(t) = m(t) + g·m(t) + xᵀγ + zᵀδ + b + e(t)    µm, per axis
///
/// m the mean law as far as the training days bear it out, x its sensor terms over their training rms and √(number of
/// terms), z = W·x the same whitened: a pattern of temperatures that the training days hardly had weighs as much as it
/// is strange, so a sensor moved or a machine heated elsewhere widens the interval. Drawn anew each day: g ~ N(0,
/// gain²), γ ~ N(0, slope²·I), δ ~ N(0, lever²·I), b ~ N(0, offset²). e wanders from 0 at the reference:
///   cov(e(s), e(t)) = wander²·(exp(−|s−t|/τ) − exp(−(s+t)/τ))
/// so that minutes a few τ apart count as independent and neighbours do not. A measurement has σ `noise`, too.
///
/// Borne out is trust·d·s of what the law says: trust by how much of it days left out differed by; d = min(1,
/// (m/.5σ)²), σ what the day's coefficients may add here; s = 1 − doubt·(1 − √(usual/|z|²)) beyond the usual, which is
/// the law at the last usual state on the way. What is left out stands in the interval, and a measurement brings it
/// back.
///
/// All of it is one Gaussian process over the day: measurements condition it, exactly, in the order made. A machine
/// that has changed draws from a wider law: kHypotheses widths are carried beside each other, weighed by how well they
/// foretell the measurements (Bayesian model averaging). So one measurement far off is believed to be a changed day,
/// and the coefficients move instead of the offset alone. The interval is a quantile of that mixture in which a wider
/// law counts by the weight it has gained: a measurement that fits narrows it.
namespace kerf::thermal {

/// Probability of a changed day from which it is said: "today differs from the days trained on: measure".
inline constexpr double kDayDiffers = 0.9;
inline constexpr std::size_t kMaxLayerTerms = 42;       ///< sensor terms of the largest regression
inline constexpr std::size_t kMaxDayMeasurements = 24;  ///< the oldest goes when one more is made

/// Between-day law of one axis, from days left out of the mean law that predicts them.
struct DayLaw {
    double gain{0.0};         ///< σ of g
    double slope_um{0.0};     ///< σ of xᵀγ at the training rms
    double offset_um{0.0};    ///< σ of b
    double wander_um{0.0};    ///< σ of e far from the reference
    double wander_min{60.0};  ///< τ
    double noise_um{0.3};     ///< σ of one measurement, > 0
    /// Half width of the 95 % interval over the standard deviation: what holds on days left out, Student's t for few.
    double widening{2.0};
    double lever_um{0.0};  ///< σ of zᵀδ at the training rms
    double trust{1.0};     ///< share of the mean law that the days left out bear out, (0, 1]
    double usual{0.0};     ///< |z|² up to which a state is like those trained on; 0: any is
    double doubt{0.0};     ///< 0…1: how far a state less usual is not corrected for
    friend bool operator==(const DayLaw&, const DayLaw&) = default;
};

struct DayLayer {
    std::array<DayLaw, kAxes> axis{};
    std::vector<double> termScale_K{};  ///< per sensor term: training rms × √(number of terms); 0: not used
    /// z = whiten·x, terms × terms by rows, lower triangle used: x seen by how little of it the training days had.
    /// Empty: no such part.
    std::vector<double> whiten{};
};

/// A day at one instant: what the law is evaluated with.
struct DayInstant {
    double time_min{0.0};
    std::uint32_t reference{0};                       ///< rising; b and e begin anew with a reference, g and γ do not
    std::array<double, kAxes> mean_um{};              ///< m, as far as it is borne out: what is corrected for
    std::array<double, kAxes> doubted_um{};           ///< the rest of what the mean law says
    std::array<double, kAxes> spread{1.0, 1.0, 1.0};  ///< × every σ but the noise: lost sensors, a warm start
    std::array<double, kMaxLayerTerms> term{};        ///< x, scaled
    std::array<double, kMaxLayerTerms> lever{};       ///< z
};

/// A measurement of the origin beside the state it was made in; replaying a day gives the same again.
struct DayMeasurement {
    DayInstant at{};
    std::array<double, kAxes> drift_um{};  ///< since the reference
    std::array<bool, kAxes> known{};       ///< axes measured
    double noise_um{0.0};                  ///< σ beyond the law's own
};

/// What a day's measurements make of the law. No allocation, lock, throw or I/O after construction.
class DayPosterior {
 public:
    static constexpr std::size_t kHypotheses = 6;

    DayPosterior() = default;
    explicit DayPosterior(const DayLayer& layer);

    /// A day begins: nothing is known of it.
    void clear() noexcept;
    /// At once; a measurement that is not finite, or of no axis, is not taken.
    void add(const DayMeasurement& measurement) noexcept;

    struct Correction {
        double shift_um{0.0};  ///< posterior mean of drift − m
        double half_um{0.0};   ///< half width of the 95 % interval
    };
    [[nodiscard]] Correction at(const DayInstant& now, std::size_t axis) const noexcept;

    [[nodiscard]] std::size_t count() const noexcept { return m_count; }
    [[nodiscard]] const DayMeasurement& measurement(std::size_t k) const noexcept { return m_measured[k]; }
    [[nodiscard]] bool present() const noexcept { return m_terms > 0; }
    /// Probability that this day is drawn from a wider law than the days trained on, the worst axis; 0 unmeasured.
    [[nodiscard]] double changed() const noexcept;
    [[nodiscard]] std::size_t terms() const noexcept { return m_terms; }
    [[nodiscard]] double termScale_K(std::size_t term) const noexcept { return m_scale_K[term]; }
    /// Fills z of an instant from its x.
    void setLever(DayInstant& now) const noexcept;
    /// Share of the mean law's `law_um` at this instant that the training days bear out, 0…1.
    [[nodiscard]] double borneOut(const DayInstant& now, std::size_t axis, double law_um) const noexcept;

 private:
    struct Factor {
        std::array<std::array<double, kMaxDayMeasurements>, kMaxDayMeasurements> lower{};
        std::array<double, kMaxDayMeasurements> solved{};  ///< K⁻¹·(y − m)
    };
    [[nodiscard]] double covariance(const DayInstant& a, const DayInstant& b, std::size_t axis,
                                    std::size_t hypothesis) const noexcept;
    void condition(std::size_t axis) noexcept;
    /// Half width that holds 95 % of a mixture of normals about `centre_um`, 1.96 σ of one.
    [[nodiscard]] static double quantile(const std::array<double, kHypotheses>& weight,
                                         const std::array<double, kHypotheses>& mean_um,
                                         const std::array<double, kHypotheses>& sigma_um) noexcept;

    std::array<DayLaw, kAxes> m_law{};
    std::array<double, kMaxLayerTerms> m_scale_K{};
    std::vector<double> m_whiten{};
    std::size_t m_terms{0};
    std::array<DayMeasurement, kMaxDayMeasurements> m_measured{};
    std::size_t m_count{0};
    std::array<std::array<std::size_t, kMaxDayMeasurements>, kAxes> m_used{};  ///< measurements of the axis
    std::array<std::size_t, kAxes> m_usedCount{};
    std::array<std::array<Factor, kHypotheses>, kAxes> m_factor{};
    std::array<std::array<double, kHypotheses>, kAxes> m_weight{};
};

}  // namespace kerf::thermal
