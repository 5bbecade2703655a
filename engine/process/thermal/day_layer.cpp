// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/thermal/day_layer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kerf::thermal {
namespace {

/// Variances of a hypothesis over those of the days trained on, and how likely it is before anything is measured.
struct Hypothesis {
    double day{1.0};     ///< × gain², slope², offset²
    double wander{1.0};  ///< × wander²
    double prior{1.0};
};
constexpr std::array<Hypothesis, DayPosterior::kHypotheses> kHypothesis{
    {{1.0, 1.0, 0.80}, {4.0, 1.0, 0.08}, {16.0, 1.0, 0.04}, {64.0, 4.0, 0.02}, {4.0, 4.0, 0.04}, {16.0, 16.0, 0.02}}};

constexpr double kNormal = 1.96;  // σ that hold 95 % of a normal
/// Share of the σ by which days differ that a prediction must reach to be corrected in full; below, by the square.
constexpr double kEvidence = 0.5;

}  // namespace

DayPosterior::DayPosterior(const DayLayer& layer) : m_law(layer.axis) {
    m_terms = std::min(layer.termScale_K.size(), kMaxLayerTerms);
    std::copy_n(layer.termScale_K.begin(), m_terms, m_scale_K.begin());
    if (layer.whiten.size() == m_terms * m_terms) {
        m_whiten = layer.whiten;
    }
    clear();
}

void DayPosterior::clear() noexcept {
    m_count = 0;
    m_usedCount = {};
    for (auto& axis : m_weight) {
        for (std::size_t h = 0; h < kHypotheses; ++h) {
            axis[h] = kHypothesis[h].prior;
        }
    }
}

double DayPosterior::covariance(const DayInstant& a, const DayInstant& b, std::size_t axis,
                                std::size_t hypothesis) const noexcept {
    const DayLaw& law = m_law[axis];
    double linear = 0.0;
    double lever = 0.0;
    for (std::size_t k = 0; k < m_terms; ++k) {
        linear += a.term[k] * b.term[k];
        lever += a.lever[k] * b.lever[k];
    }
    double day = law.gain * law.gain * (a.mean_um[axis] + a.doubted_um[axis]) * (b.mean_um[axis] + b.doubted_um[axis]) +
                 a.doubted_um[axis] * b.doubted_um[axis] + law.slope_um * law.slope_um * linear +
                 law.lever_um * law.lever_um * lever;
    double wander = 0.0;
    if (a.reference == b.reference) {
        day += law.offset_um * law.offset_um;
        const double s = std::max(a.time_min, 0.0);
        const double t = std::max(b.time_min, 0.0);
        wander = law.wander_um * law.wander_um *
                 (std::exp(-std::abs(s - t) / law.wander_min) - std::exp(-(s + t) / law.wander_min));
    }
    return a.spread[axis] * b.spread[axis] *
           (kHypothesis[hypothesis].day * day + kHypothesis[hypothesis].wander * wander);
}

void DayPosterior::add(const DayMeasurement& measurement) noexcept {
    DayMeasurement taken = measurement;
    bool any = false;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        taken.known[axis] = taken.known[axis] && std::isfinite(taken.drift_um[axis]);
        any = any || taken.known[axis];
    }
    if (!any || m_terms == 0) {
        return;
    }
    if (m_count == kMaxDayMeasurements) {
        std::move(m_measured.begin() + 1, m_measured.end(), m_measured.begin());
        --m_count;
    }
    setLever(taken.at);
    m_measured[m_count++] = taken;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        condition(axis);
    }
}

void DayPosterior::condition(std::size_t axis) noexcept {
    std::size_t n = 0;
    for (std::size_t k = 0; k < m_count; ++k) {
        if (m_measured[k].known[axis]) {
            m_used[axis][n++] = k;
        }
    }
    m_usedCount[axis] = n;
    std::array<double, kHypotheses> logWeight{};
    double best = -1e300;
    for (std::size_t h = 0; h < kHypotheses; ++h) {
        Factor& factor = m_factor[axis][h];
        std::array<double, kMaxDayMeasurements> white{};
        double logLikelihood = 0.0;
        for (std::size_t i = 0; i < n; ++i) {  // Cholesky, row by row, with the forward solution
            const DayMeasurement& a = m_measured[m_used[axis][i]];
            for (std::size_t j = 0; j <= i; ++j) {
                double sum = covariance(a.at, m_measured[m_used[axis][j]].at, axis, h);
                if (i == j) {
                    sum += m_law[axis].noise_um * m_law[axis].noise_um + a.noise_um * a.noise_um;
                }
                for (std::size_t k = 0; k < j; ++k) {
                    sum -= factor.lower[i][k] * factor.lower[j][k];
                }
                factor.lower[i][j] = i == j ? std::sqrt(std::max(sum, 1e-6)) : sum / factor.lower[j][j];
            }
            double rest = a.drift_um[axis] - a.at.mean_um[axis];
            for (std::size_t k = 0; k < i; ++k) {
                rest -= factor.lower[i][k] * white[k];
            }
            white[i] = rest / factor.lower[i][i];
            logLikelihood -= 0.5 * white[i] * white[i] + std::log(factor.lower[i][i]);
        }
        for (std::size_t i = n; i-- > 0;) {
            double sum = white[i];
            for (std::size_t k = i + 1; k < n; ++k) {
                sum -= factor.lower[k][i] * factor.solved[k];
            }
            factor.solved[i] = sum / factor.lower[i][i];
        }
        logWeight[h] = std::log(kHypothesis[h].prior) + logLikelihood;
        best = std::max(best, logWeight[h]);
    }
    double total = 0.0;
    for (std::size_t h = 0; h < kHypotheses; ++h) {
        m_weight[axis][h] = std::exp(logWeight[h] - best);
        total += m_weight[axis][h];
    }
    for (double& weight : m_weight[axis]) {
        weight /= total;
    }
}

void DayPosterior::setLever(DayInstant& now) const noexcept {
    if (m_whiten.empty()) {
        return;
    }
    for (std::size_t row = 0; row < m_terms; ++row) {
        double sum = 0.0;
        for (std::size_t k = 0; k <= row; ++k) {
            sum += m_whiten[row * m_terms + k] * now.term[k];
        }
        now.lever[row] = sum;
    }
}

double DayPosterior::borneOut(const DayInstant& now, std::size_t axis, double law_um) const noexcept {
    const DayLaw& law = m_law[axis];
    double linear = 0.0;
    double lever = 0.0;
    for (std::size_t k = 0; k < m_terms; ++k) {
        linear += now.term[k] * now.term[k];
        lever += now.lever[k] * now.lever[k];
    }
    const double square_um2 = law_um * law_um;
    const double spread_um2 =
        law.slope_um * law.slope_um * linear + law.lever_um * law.lever_um * lever + law.gain * law.gain * square_um2;
    const double small = square_um2 / std::max({square_um2, kEvidence * kEvidence * spread_um2, 1e-12});
    const double strange = law.usual > 0.0 && lever > law.usual ? 1.0 - std::sqrt(law.usual / lever) : 0.0;
    return law.trust * small * (1.0 - law.doubt * strange);
}

double DayPosterior::quantile(const std::array<double, kHypotheses>& weight,
                              const std::array<double, kHypotheses>& mean_um,
                              const std::array<double, kHypotheses>& sigma_um) noexcept {
    constexpr int kHalvings = 30;
    double high = 0.0;
    for (std::size_t h = 0; h < kHypotheses; ++h) {
        high = std::max(high, std::abs(mean_um[h]) + 2.0 * sigma_um[h]);
    }
    double low = 0.0;
    for (int k = 0; k < kHalvings; ++k) {
        const double half = 0.5 * (low + high);
        double outside = 0.0;
        for (std::size_t h = 0; h < kHypotheses; ++h) {
            const double unit = std::numbers::sqrt2 * std::max(sigma_um[h], 1e-6);
            outside +=
                weight[h] * 0.5 * (std::erfc((half - mean_um[h]) / unit) + std::erfc((half + mean_um[h]) / unit));
        }
        (outside > 0.05 ? low : high) = half;
    }
    return high;
}

DayPosterior::Correction DayPosterior::at(const DayInstant& now, std::size_t axis) const noexcept {
    const std::size_t n = m_usedCount[axis];
    std::array<double, kHypotheses> mean{};
    std::array<double, kHypotheses> sigma{};
    Correction out;
    if (n == 0) {  // nothing measured: the interval is that of days left out
        out.half_um = m_law[axis].widening * std::sqrt(covariance(now, now, axis, 0));
        return out;
    }
    for (std::size_t h = 0; h < kHypotheses; ++h) {
        const Factor& factor = m_factor[axis][h];
        std::array<double, kMaxDayMeasurements> white{};
        double variance = covariance(now, now, axis, h);
        for (std::size_t i = 0; i < n; ++i) {
            const double cross = covariance(now, m_measured[m_used[axis][i]].at, axis, h);
            mean[h] += cross * factor.solved[i];
            double rest = cross;
            for (std::size_t k = 0; k < i; ++k) {
                rest -= factor.lower[i][k] * white[k];
            }
            white[i] = rest / factor.lower[i][i];
            variance -= white[i] * white[i];
        }
        sigma[h] = std::sqrt(std::max(variance, 0.0));
        out.shift_um += m_weight[axis][h] * mean[h];
    }
    for (double& value : mean) {
        value -= out.shift_um;
    }
    // Before anything is measured the width is that of the days trained on alone, because it is what held on days left
    // out. So a wider law counts by the weight that measurements have given it beyond what it began with: one that fits
    // narrows the interval, one that does not widens it. And the quantile of the mixture, not a factor over its σ: a
    // few hundredths of weight on a law eight times as wide are most of the variance and hardly any of the 95 %.
    std::array<double, kHypotheses> raised{};
    raised[0] = 1.0;
    for (std::size_t h = 1; h < kHypotheses; ++h) {
        raised[h] = std::max(m_weight[axis][h] - kHypothesis[h].prior, 0.0);
        raised[0] -= raised[h];
    }
    out.half_um = m_law[axis].widening / kNormal * quantile(raised, mean, sigma);
    return out;
}

double DayPosterior::changed() const noexcept {
    double worst = 0.0;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        if (m_usedCount[axis] > 0) {
            worst = std::max(worst, 1.0 - m_weight[axis][0]);
        }
    }
    return worst;
}

}  // namespace kerf::thermal
