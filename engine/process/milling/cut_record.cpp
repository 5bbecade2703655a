// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/milling/cut_record.h"

#include <algorithm>
#include <cmath>

namespace kerf::milling {
namespace {
constexpr double kOver = 1.1;  // of the reference: counts as above it
}

CutRecord::CutRecord(const Params& params, MillingLaw law, bool advised) noexcept : m_params(params) {
    m_cut.law = law;
    m_cut.advised = advised;
    m_cut.reference_N = params.reference_N;
}

void CutRecord::add(const CutRevolution& revolution) noexcept {
    const double moved_mm = revolution.feed_mmPerS * revolution.revolution_s;
    m_cut.cutTime_s += revolution.revolution_s;
    m_cut.plannedTime_s += moved_mm / m_params.planned_mmPerS;
    const bool inWork = revolution.force_N >= m_params.airForce_N;
    const bool other = m_cut.advised && inWork && revolution.controlledFeed_mmPerS > 0.0;
    m_cut.controlledTime_s += other ? moved_mm / revolution.controlledFeed_mmPerS : revolution.revolution_s;
    if (!inWork) {
        return;
    }
    if (!m_contact) {
        m_contact = true;
        m_contact_mm = revolution.position_mm;
    }
    if (revolution.force_N > m_cut.peakForce_N) {
        m_cut.peakForce_N = revolution.force_N;
        m_cut.peakAt_mm = revolution.position_mm;
    }
    m_forceTime_Ns += revolution.force_N * revolution.revolution_s;
    m_workTime_s += revolution.revolution_s;
    m_cut.meanForce_N = m_forceTime_Ns / m_workTime_s;
    m_cut.overReference_s += revolution.force_N > kOver * m_params.reference_N ? revolution.revolution_s : 0.0;
    if (revolution.stiffness.valid) {  // weighed by path, so that slow passages do not count more
        m_stiffnessWeight += moved_mm;
        m_stiffnessSum += moved_mm * revolution.stiffness.lnCb;
        m_halfSum += moved_mm * revolution.stiffness.half95;  // neighbours are not independent: no √n
        if (m_stiffnessWeight > 0.0) {
            m_cut.stiffnessMean = m_stiffnessSum / m_stiffnessWeight;
            m_cut.stiffnessHalf95 = m_halfSum / m_stiffnessWeight;
        }
    }
    addWall(revolution.position_mm, revolution.force_N / m_params.ky_NPerMm * 1e3);
}

void CutRecord::addWall(double position_mm, double deviation_um) noexcept {
    const double kept_mm = m_params.exit_mm + m_params.spot_mm;
    while (m_count > 0 && (m_count == kWindow || position_mm - m_at_mm[m_first] > kept_mm)) {
        m_first = (m_first + 1) % kWindow;
        --m_count;
    }
    const std::size_t last = (m_first + m_count) % kWindow;
    m_at_mm[last] = position_mm;
    m_deviation_um[last] = deviation_um;
    ++m_count;
    // Whether the tool is already leaving the work shows only later: the spot lags by the tool's radius.
    const double spotEnd_mm = position_mm - m_params.exit_mm;
    if (spotEnd_mm - m_params.spot_mm < m_contact_mm + m_params.from_mm) {
        return;
    }
    double sum_um = 0.0;
    int inSpot = 0;
    for (std::size_t i = 0; i < m_count && m_at_mm[(m_first + i) % kWindow] <= spotEnd_mm; ++i) {
        sum_um += m_deviation_um[(m_first + i) % kWindow];
        ++inSpot;
    }
    if (inSpot > 0) {
        m_low_um = std::min(m_low_um, sum_um / inSpot);
        m_high_um = std::max(m_high_um, sum_um / inSpot);
        m_cut.waviness_um = m_high_um - m_low_um;
    }
}

void WearTrend::addPart(double meanStiffness) noexcept {
    m_first = m_parts == 0 ? meanStiffness : m_first;
    m_last = meanStiffness;
    const double y = meanStiffness - m_first;
    m_sumY += y;
    m_sumXy += m_parts * y;
    ++m_parts;
}

double WearTrend::perPart() const noexcept {
    if (m_parts < 3) {
        return 0.0;
    }
    const double n = m_parts;
    const double sumX = n * (n - 1.0) / 2.0;
    const double sumXx = sumX * (2.0 * n - 1.0) / 3.0;
    return (n * m_sumXy - sumX * m_sumY) / (n * sumXx - sumX * sumX);
}

void WearTrend::save(MillingToolState& tool) const noexcept {
    tool.parts = m_parts;
    tool.firstStiffness = m_first;
    tool.lastStiffness = m_last;
    tool.sumRise = m_sumY;
    tool.sumIndexRise = m_sumXy;
}

void WearTrend::restore(const MillingToolState& tool) noexcept {
    m_parts = tool.parts;
    m_first = tool.firstStiffness;
    m_last = tool.lastStiffness;
    m_sumY = tool.sumRise;
    m_sumXy = tool.sumIndexRise;
}

}  // namespace kerf::milling
