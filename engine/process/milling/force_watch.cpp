// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/milling/force_watch.h"

#include <algorithm>
#include <cmath>

namespace kerf::milling {

void ForceWatch::disarm() noexcept {
    m_peak_N = {};
    m_peakNow_N = 0.0;
    m_collapsed = false;
    m_teeth = 0;
    m_sumNow_N = 0.0;
    m_countNow = 0;
}

double ForceWatch::revolutionMean_N() const noexcept {
    const int flutes = std::clamp(m_params.flutes, 1, kMaxFlutes);
    if (m_teeth <= flutes) {  // the first tooth since the gap was not whole
        return 0.0;
    }
    double sum_N = 0.0;
    for (int i = 1; i <= flutes; ++i) {
        sum_N += m_mean_N[static_cast<std::size_t>((m_teeth - i) % kMaxFlutes)];
    }
    return sum_N / flutes;
}

double ForceWatch::peak_N(int ago) const noexcept {
    return ago < m_teeth ? m_peak_N[static_cast<std::size_t>(m_teeth - 1 - ago) % kTeethKept] : 0.0;
}

bool ForceWatch::collapsesNow() const noexcept {
    const int flutes = std::clamp(m_params.flutes, 1, kMaxFlutes);
    const auto collapsedFrom = [&](int ago) {
        const double before_N = peak_N(ago);
        const double limit_N = m_params.collapseShare * before_N;
        return before_N > m_params.inWork_N && before_N >= m_params.steadyShare * peak_N(ago + flutes) &&
               peak_N(1) < limit_N && peak_N(0) < limit_N;
    };
    return collapsedFrom(2) || collapsedFrom(3);
}

void ForceWatch::nextTooth(std::int64_t tooth) noexcept {
    if (tooth != m_tooth + 1) {  // a gap, or the angle began anew: there is nothing to compare with
        disarm();
    } else {
        m_peak_N[static_cast<std::size_t>(m_teeth) % kTeethKept] = m_peakNow_N;
        m_peakNow_N = 0.0;
        m_mean_N[static_cast<std::size_t>(m_teeth % kMaxFlutes)] = m_countNow > 0 ? m_sumNow_N / m_countNow : 0.0;
        ++m_teeth;
        m_sumNow_N = 0.0;
        m_countNow = 0;
        m_collapsed = m_collapsed || collapsesNow();
    }
    m_tooth = tooth;
}

void ForceWatch::add(const FastSample& sample) noexcept {
    if (std::isfinite(sample.spindleAngle_rev)) {
        m_angle_rev = sample.spindleAngle_rev;
    }
    const bool finite = std::isfinite(sample.force_N);
    const bool good = sample.quality == Quality::Good && finite;
    const bool same =
        good && m_any && sample.force_N == m_lastForce_N && std::abs(sample.force_N) > m_params.stuckAbove_N;
    m_quality = same || (sample.quality == Quality::Good && !finite) ? Quality::Bad : sample.quality;
    if (!good || same) {
        return;
    }
    const auto tooth = static_cast<std::int64_t>(std::floor(m_angle_rev * m_params.flutes));
    if (tooth != m_tooth) {
        nextTooth(tooth);
    }
    m_peakNow_N = std::max(m_peakNow_N, sample.force_N);
    m_sumNow_N += sample.force_N;
    ++m_countNow;
    m_any = true;
    m_lastForce_N = sample.force_N;
    m_trustedAngle_rev = m_angle_rev;
    m_trusted_ns = sample.stamp_ns;
}

bool ForceWatch::blind(std::int64_t now_ns, double revolution_s) const noexcept {
    if (!m_any || m_angle_rev - m_trustedAngle_rev > m_params.patience_rev) {
        return true;
    }
    return static_cast<double>(now_ns - m_trusted_ns) * 1e-9 > m_params.patience_rev * revolution_s;
}

}  // namespace kerf::milling
