// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/thermal/day_layer.h"

#include <algorithm>
#include <cmath>

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

}  // namespace

DayPosterior::DayPosterior(const DayLayer& layer) : m_law(layer.axis) {
    m_terms = std::min(layer.termScale_K.size(), kMaxLayerTerms);
    std::copy_n(layer.termScale_K.begin(), m_terms, m_scale_K.begin());
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
    for (std::size_t k = 0; k < m_terms; ++k) {
        linear += a.term[k] * b.term[k];
    }
    double day = law.gain * law.gain * a.mean_um[axis] * b.mean_um[axis] + law.slope_um * law.slope_um * linear;
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
                    sum += m_law[axis].noise_um * m_law[axis].noise_um;
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

DayPosterior::Correction DayPosterior::at(const DayInstant& now, std::size_t axis) const noexcept {
    std::array<double, kHypotheses> mean{};
    std::array<double, kHypotheses> variance{};
    const std::size_t n = m_usedCount[axis];
    Correction out;
    for (std::size_t h = 0; h < kHypotheses; ++h) {
        if (n == 0 && h > 0) {  // nothing measured: the interval is that of the days trained on
            break;
        }
        const Factor& factor = m_factor[axis][h];
        std::array<double, kMaxDayMeasurements> white{};
        variance[h] = covariance(now, now, axis, h);
        for (std::size_t i = 0; i < n; ++i) {
            const double cross = covariance(now, m_measured[m_used[axis][i]].at, axis, h);
            mean[h] += cross * factor.solved[i];
            double rest = cross;
            for (std::size_t k = 0; k < i; ++k) {
                rest -= factor.lower[i][k] * white[k];
            }
            white[i] = rest / factor.lower[i][i];
            variance[h] -= white[i] * white[i];
        }
        variance[h] = std::max(variance[h], 0.0);
    }
    if (n == 0) {
        out.half_um = m_law[axis].widening * std::sqrt(variance[0]);
        return out;
    }
    for (std::size_t h = 0; h < kHypotheses; ++h) {
        out.shift_um += m_weight[axis][h] * mean[h];
    }
    double spread = 0.0;
    for (std::size_t h = 0; h < kHypotheses; ++h) {
        const double apart = mean[h] - out.shift_um;
        spread += m_weight[axis][h] * (variance[h] + apart * apart);
    }
    out.half_um = m_law[axis].widening * std::sqrt(spread);
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
