// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/milling/force_watch.h"

#include <algorithm>
#include <cmath>

namespace kerf::milling {

void ForceWatch::Feed::take(std::optional<double> feed_mmPerS) noexcept {
    if (feed_mmPerS) {
        lowest_mmPerS = std::min(lowest_mmPerS.value_or(*feed_mmPerS), *feed_mmPerS);
        highest_mmPerS = std::max(highest_mmPerS.value_or(*feed_mmPerS), *feed_mmPerS);
    }
}

double ForceWatch::feedShare(const Feed& now, const Feed& then) noexcept {
    const bool known = now.lowest_mmPerS && then.highest_mmPerS && *then.highest_mmPerS > 0.0;
    return known ? std::clamp(*now.lowest_mmPerS / *then.highest_mmPerS, 0.0, 1.0) : 1.0;
}

void ForceWatch::disarm() noexcept {
    m_peak_N = {};
    m_feedNow = {};
    m_peakNow_N = 0.0;
    m_collapsed = false;
    m_chipped = false;
    m_sectorsKnown = false;
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

const ForceWatch::Feed& ForceWatch::feed(int ago) const noexcept {
    static constexpr Feed kUnknown{};
    return ago < m_teeth ? m_toothFeed[static_cast<std::size_t>(m_teeth - 1 - ago) % kTeethKept] : kUnknown;
}

bool ForceWatch::collapsesNow() const noexcept {
    const int flutes = std::clamp(m_params.flutes, 1, kMaxFlutes);
    const auto collapsedFrom = [&](int ago) {
        const double before_N = peak_N(ago);
        const auto fallen = [&](int tooth) {
            return peak_N(tooth) < m_params.collapseShare * before_N * feedShare(feed(tooth), feed(ago));
        };
        return before_N > m_params.inWork_N && before_N >= m_params.steadyShare * peak_N(ago + flutes) && fallen(1) &&
               fallen(0);
    };
    return collapsedFrom(2) || collapsedFrom(3);
}

void ForceWatch::nextTooth(std::int64_t tooth) noexcept {
    if (tooth != m_tooth + 1) {  // a gap, or the angle began anew: there is nothing to compare with
        disarm();
    } else {
        m_peak_N[static_cast<std::size_t>(m_teeth) % kTeethKept] = m_peakNow_N;
        m_toothFeed[static_cast<std::size_t>(m_teeth) % kTeethKept] = m_feedNow;
        m_peakNow_N = 0.0;
        m_feedNow = {};
        m_mean_N[static_cast<std::size_t>(m_teeth % kMaxFlutes)] = m_countNow > 0 ? m_sumNow_N / m_countNow : 0.0;
        ++m_teeth;
        m_sumNow_N = 0.0;
        m_countNow = 0;
        m_collapsed = m_collapsed || collapsesNow();
    }
    m_tooth = tooth;
}

std::optional<double> ForceWatch::sectorPeak_N(std::int64_t first, std::int64_t last) const noexcept {
    double highest_N = kNoSample_N;
    for (std::int64_t sector = first; sector <= last; ++sector) {
        highest_N = std::max(highest_N, m_sector_N[static_cast<std::size_t>(sector) % kSectorsKept]);
    }
    return highest_N > kNoSample_N ? std::optional(highest_N) : std::nullopt;
}

ForceWatch::Feed ForceWatch::sectorFeed(std::int64_t first, std::int64_t last) const noexcept {
    Feed feed;
    for (std::int64_t sector = first; sector <= last; ++sector) {
        const Feed& one = m_sectorFeed[static_cast<std::size_t>(sector) % kSectorsKept];
        feed.take(one.lowest_mmPerS);
        feed.take(one.highest_mmPerS);
    }
    return feed;
}

bool ForceWatch::chipsNow() const noexcept {
    const int flutes = std::clamp(m_params.flutes, 1, kMaxFlutes);
    const std::int64_t turn = static_cast<std::int64_t>(flutes) * kSectorsPerTooth;
    const std::int64_t last = m_sector - 1;  // the last whole one
    // A pitch, a sector in which the edges meet, three sectors within the pitch in question, one again, a pitch.
    const std::array<std::array<std::int64_t, 2>, 3> spans{
        {{last - 12, last - 9}, {last - 7, last - 5}, {last - 3, last}}};
    if (flutes < 2 || spans[0][0] - turn < m_sectorsFrom) {
        return false;
    }
    const std::array shares{m_params.steadyShare, m_params.chippedShare, m_params.steadyShare};
    // A feed that falls and stays down shows in the pitch after as well, whose edge has to cut what a broken one has
    // left; one that falls for this pitch alone does not.
    const auto feedOf = [&](std::size_t i) { return sectorFeed(spans[i][0], spans[i][1]); };
    const double dip = std::max(feedShare(feedOf(1), feedOf(0)), feedShare(feedOf(1), feedOf(2)));
    double healthy_N = 0.0;  // of the pitch in question, a revolution earlier
    for (std::size_t i = 0; i < spans.size(); ++i) {
        const auto now_N = sectorPeak_N(spans[i][0], spans[i][1]);
        const auto then_N = sectorPeak_N(spans[i][0] - turn, spans[i][1] - turn);
        if (!now_N || !then_N || *then_N <= m_params.inWork_N) {
            return false;
        }
        const bool fallen = *now_N < shares[i] * *then_N * (i == 1 ? dip : 1.0);
        if (fallen != (i == 1) || (i == 2 && *now_N < m_params.steadyShare * healthy_N)) {
            return false;
        }
        healthy_N = i == 1 ? *then_N : healthy_N;
    }
    return true;
}

void ForceWatch::nextSector(std::int64_t sector) noexcept {
    const int flutes = std::clamp(m_params.flutes, 1, kMaxFlutes);
    if (!m_sectorsKnown || sector < m_sector || sector - m_sector > kSectorsPerTooth * flutes / 2) {
        m_sectorsKnown = true;  // a gap, or the angle began anew
        m_sectorsFrom = sector;
        m_sector_N[static_cast<std::size_t>(sector) % kSectorsKept] = kNoSample_N;
        m_sectorFeed[static_cast<std::size_t>(sector) % kSectorsKept] = {};
        m_sector = sector;
        return;
    }
    while (m_sector < sector) {  // a fast spindle leaves some without a sample
        ++m_sector;
        m_sector_N[static_cast<std::size_t>(m_sector) % kSectorsKept] = kNoSample_N;
        m_sectorFeed[static_cast<std::size_t>(m_sector) % kSectorsKept] = {};
        m_chipped = m_chipped || chipsNow();
    }
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
    const auto sector = static_cast<std::int64_t>(std::floor(m_angle_rev * m_params.flutes * kSectorsPerTooth));
    if (sector != m_sector || !m_sectorsKnown) {
        nextSector(sector);
    }
    if (sector == m_sector) {
        double& highest_N = m_sector_N[static_cast<std::size_t>(sector) % kSectorsKept];
        highest_N = std::max(highest_N, sample.force_N);
        Feed& feed = m_sectorFeed[static_cast<std::size_t>(sector) % kSectorsKept];
        feed.take(m_feedBefore_mmPerS);
        feed.take(m_feed_mmPerS);
    }
    m_feedNow.take(m_feedBefore_mmPerS);
    m_feedNow.take(m_feed_mmPerS);
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
