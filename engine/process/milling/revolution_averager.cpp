// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/milling/revolution_averager.h"

#include <algorithm>
#include <cmath>

namespace kerf::milling {
namespace {

bool trusted(const FastSample& sample) noexcept {
    return sample.quality == Quality::Good && std::isfinite(sample.force_N);
}

Quality qualityOf(const FastSample& sample) noexcept {
    return sample.quality == Quality::Good && !std::isfinite(sample.force_N) ? Quality::Bad : sample.quality;
}

}  // namespace

void RevolutionAverager::reset() noexcept {
    *this = RevolutionAverager(m_params);
}

void RevolutionAverager::startAt(double mark_rev, std::int64_t time_ns) noexcept {
    m_mark_rev = mark_rev;
    m_begin_ns = time_ns;
    m_sum_Nrev = 0.0;
    m_trusted_rev = 0.0;
    m_any = false;
    m_worst = Quality::Good;
}

void RevolutionAverager::note(const FastSample& sample) noexcept {
    m_worst = std::min(m_worst, qualityOf(sample));  // the enumeration rises with trust
    if (trusted(sample)) {
        m_peak_N = m_any ? std::max(m_peak_N, sample.force_N) : sample.force_N;
        m_low_N = m_any ? std::min(m_low_N, sample.force_N) : sample.force_N;
        m_any = true;
    }
}

void RevolutionAverager::accumulate(double from_rev, double to_rev, double from_N, double to_N, bool trust) noexcept {
    if (trust) {
        m_sum_Nrev += 0.5 * (from_N + to_N) * (to_rev - from_rev);
        m_trusted_rev += to_rev - from_rev;
    }
}

RevolutionForce RevolutionAverager::finish(std::int64_t end_ns) const noexcept {
    RevolutionForce result;
    result.revolution = static_cast<std::int64_t>(m_mark_rev);
    result.begin_ns = m_begin_ns;
    result.end_ns = end_ns;
    result.peak_N = m_any ? m_peak_N : 0.0;
    result.low_N = m_any ? m_low_N : 0.0;
    result.trustedShare = std::min(m_trusted_rev, 1.0);
    const bool covered = m_trusted_rev >= m_params.minTrustedShare;
    const bool stuck =
        m_any && m_peak_N - m_low_N <= m_params.stuckBand_N && std::abs(m_peak_N) > m_params.stuckAbove_N;
    if (covered && !stuck) {
        result.quality = Quality::Good;
        result.mean_N = m_sum_Nrev / m_trusted_rev;
    } else if (covered) {
        result.quality = Quality::Bad;
    } else {
        result.quality = m_worst == Quality::Good ? Quality::Stale : m_worst;  // good samples too far apart
    }
    return result;
}

std::optional<RevolutionForce> RevolutionAverager::add(const FastSample& sample) noexcept {
    const double angle_rev = sample.spindleAngle_rev;
    if (!std::isfinite(angle_rev)) {
        note(sample);
        m_worst = std::min(m_worst, Quality::Bad);
        return std::nullopt;
    }
    const double step_rev = angle_rev - m_last.spindleAngle_rev;
    if (!m_started || std::abs(step_rev) > 1.0) {
        m_started = true;
        m_marked = false;
        m_last = sample;
        startAt(std::floor(angle_rev), sample.stamp_ns);
        return std::nullopt;
    }
    note(sample);
    if (step_rev <= 0.0) {  // standing or swinging back: the sample with the higher angle stays the last one
        return std::nullopt;
    }
    const bool trust = trusted(m_last) && trusted(sample) && step_rev <= m_params.maxGap_rev;
    const double mark_rev = m_mark_rev + 1.0;
    if (angle_rev < mark_rev) {
        accumulate(m_last.spindleAngle_rev, angle_rev, m_last.force_N, sample.force_N, trust);
        m_last = sample;
        return std::nullopt;
    }
    const double share = (mark_rev - m_last.spindleAngle_rev) / step_rev;
    const double force_N = m_last.force_N + share * (sample.force_N - m_last.force_N);
    const auto time_ns =
        m_last.stamp_ns + static_cast<std::int64_t>(share * static_cast<double>(sample.stamp_ns - m_last.stamp_ns));
    accumulate(m_last.spindleAngle_rev, mark_rev, m_last.force_N, force_N, trust);
    const bool whole = m_marked;
    const RevolutionForce finished = finish(time_ns);
    startAt(mark_rev, time_ns);
    m_marked = true;
    accumulate(mark_rev, angle_rev, force_N, sample.force_N, trust);
    note(sample);
    m_last = sample;
    return whole ? std::optional(finished) : std::nullopt;
}

}  // namespace kerf::milling
