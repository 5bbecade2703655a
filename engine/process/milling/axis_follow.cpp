// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/milling/axis_follow.h"

#include <algorithm>
#include <cmath>

namespace kerf::milling {
namespace {
constexpr double kMemory = 1.0 - 1.0 / 60.0;
constexpr double kLeastError_mm2 = 1e-5;  // of one period: below nothing is to be gained
constexpr double kEvidence = 6.0;         // log-likelihood by which another pair must explain the feed better
constexpr double kLeastShare = 0.05;      // of the mean: below, the feed at the begin of a period is not seen in it
constexpr double kMuchBetter = -1.204;    // of the mean ln(error²) that a time constant must leave
constexpr double kLarge = 0.3;            // change of the decided feed that counts as large
constexpr double kHardest = 2.5;          // a lagging axis is driven at most so many times the change wanted
constexpr std::array<double, AxisFollow::kLags> kLag_periods{0.0, 0.15, 0.3, 0.5, 0.8, 1.2, 2.0, 3.0};
}  // namespace

AxisFollow::Lag AxisFollow::lagOf(std::size_t index) noexcept {
    const double lag_periods = kLag_periods[index % kLags];
    if (lag_periods <= 0.0) {
        return {};
    }
    const double decay = std::exp(-1.0 / lag_periods);
    return {decay, lag_periods * (1.0 - decay)};
}

double AxisFollow::next_mm(const Lag& lag, double before_mm, double decidedBefore_mm, double decided_mm) noexcept {
    // before = c + (v − c) s: the feed at the end of that period is c + (v − c) e^(−1/τ).
    const double end_mm = lag.share < kLeastShare
                              ? decidedBefore_mm
                              : decidedBefore_mm + (before_mm - decidedBefore_mm) * lag.decay / lag.share;
    return decided_mm + (end_mm - decided_mm) * lag.share;
}

double AxisFollow::lag_periods() const noexcept {
    return kLag_periods[m_best % kLags];
}

void AxisFollow::measured(double feed_mm) noexcept {
    if (m_hasMeasured && m_known > 0) {
        for (std::size_t i = m_known; i < m_decided_mm.size(); ++i) {
            m_decided_mm[i] = m_measured_mm;  // as good as known: what was decided before, the axis made
        }
        for (std::size_t late = 0; late < kLates; ++late) {
            learn(late, feed_mm);
        }
        m_count = kMemory * m_count + 1.0;
        m_usual_mm2 = std::exp(*std::ranges::min_element(m_lnError) / m_count);
        const auto doubt = [&](std::size_t i) {  // negative log-likelihood, up to what all share
            return 0.5 * m_lnDoubt[i] + (i == 0 ? 0.0 : kEvidence);
        };
        std::size_t best = 0;
        for (std::size_t i = 1; i < m_lnDoubt.size(); ++i) {
            best = doubt(i) < doubt(best) ? i : best;
        }
        const std::size_t prompt = best / kLags * kLags;  // the same, reached at once
        best = m_lnDoubt[best] < m_lnDoubt[prompt] + kMuchBetter * m_count ? best : prompt;
        // Who has the floor keeps it unless clearly beaten.
        const bool stays = m_best % kLags == 0 || best % kLags != 0;  // what is no longer much better goes at once
        m_best = !stays || doubt(best) + 1.0 < doubt(m_best) ? best : m_best;
    }
    m_measured_mm = feed_mm;
    m_hasMeasured = true;
    predictPending();
}

void AxisFollow::learn(std::size_t late, double feed_mm) noexcept {
    std::array<double, kLags> error_mm2{};
    for (std::size_t lag = 0; lag < kLags; ++lag) {
        const double error_mm =
            feed_mm - next_mm(lagOf(lag), m_measured_mm, m_decided_mm[late + 1], m_decided_mm[late]);
        error_mm2[lag] = error_mm * error_mm;
    }
    // A large change is made at the rate the machine allows: it says when it was begun, not how the axis settles.
    const bool large = std::abs(m_decided_mm[late] - m_decided_mm[late + 1]) > kLarge * m_decided_mm[late + 1];
    const double least_mm2 = *std::ranges::min_element(error_mm2);
    for (std::size_t lag = 0; lag < kLags; ++lag) {
        const double told_mm2 = large ? least_mm2 : error_mm2[lag];
        double& lnDoubt = m_lnDoubt[late * kLags + lag];
        lnDoubt = kMemory * lnDoubt + std::log(told_mm2 + m_usual_mm2);
        double& lnError = m_lnError[late * kLags + lag];
        lnError = kMemory * lnError + std::log(told_mm2 + kLeastError_mm2);
    }
}

void AxisFollow::predictPending() noexcept {
    const std::size_t lateness = late();
    m_last_mm = m_measured_mm;
    m_lastDecided_mm = lateness < m_known ? m_decided_mm[lateness] : m_measured_mm;
    for (std::size_t i = 0; i < lateness; ++i) {
        const std::size_t age = lateness - 1 - i;
        const double decided_mm = age < m_known ? m_decided_mm[age] : m_last_mm;
        m_pending_mm[i] = std::max(0.0, next_mm(lagOf(m_best), m_last_mm, m_lastDecided_mm, decided_mm));
        m_last_mm = m_pending_mm[i];
        m_lastDecided_mm = decided_mm;
    }
}

double AxisFollow::toMake_mm(double wanted_mm) const noexcept {
    const Lag lag = lagOf(m_best);
    if (lag.share < kLeastShare) {
        return wanted_mm;
    }
    const double end_mm = m_lastDecided_mm + (m_last_mm - m_lastDecided_mm) * lag.decay / lag.share;
    const double factor = std::min(1.0 / (1.0 - lag.share), kHardest);
    return std::max(0.0, end_mm + (wanted_mm - end_mm) * factor);
}

void AxisFollow::decided(double feed_mm) noexcept {
    std::shift_right(m_decided_mm.begin(), m_decided_mm.end(), 1);
    m_decided_mm[0] = feed_mm;
    m_known = std::min(m_known + 1, m_decided_mm.size());
}

}  // namespace kerf::milling
