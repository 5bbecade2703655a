// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/turning/surface_record.h"

#include <cmath>

namespace kerf::turning {
namespace {
constexpr double kRunningShare = 1.0 / 1000.0;  // .2 s
constexpr double kSteadyBegin = 0.5;
constexpr double kSteadyEnd = 0.97;  // the exit of the cut is no part of the second half

double rms(double sum_um2, std::uint64_t count) noexcept {
    return std::sqrt(sum_um2 / static_cast<double>(count));
}
}  // namespace

void SurfaceRecord::clear(std::uint32_t revolutionSamples) noexcept {
    const double width_um = m_revolutionWidth_um;
    *this = SurfaceRecord{};
    m_revolutionSamples = revolutionSamples;
    m_revolutionWidth_um = width_um;
}

void SurfaceRecord::take(const SurfaceSample& sample) noexcept {
    const double error_um2 = sample.error_um * sample.error_um;
    const double untreated_um2 = sample.untreated_um * sample.untreated_um;
    m_running_um2 += kRunningShare * (error_um2 - m_running_um2);
    m_runningUntreated_um2 += kRunningShare * (untreated_um2 - m_runningUntreated_um2);
    if (sample.counts) {
        m_whole.error_um2 += error_um2;
        m_whole.untreated_um2 += untreated_um2;
        ++m_whole.count;
        if (sample.progress >= kSteadyBegin && sample.progress < kSteadyEnd) {
            m_steadyExtent.take(sample.error_um);
            m_steadyUntreated.take(sample.untreated_um);
            m_steady.error_um2 += error_um2;
            m_steady.untreated_um2 += untreated_um2;
            m_steadyForce_N += sample.force_N;
            ++m_steady.count;
        }
    }
    m_revolution.take(sample.error_um);
    if (m_revolution.count >= m_revolutionSamples) {
        m_revolutionWidth_um = m_revolution.width();
        m_revolution = Extent{};
    }
}

void SurfaceRecord::show(TurningStatus& status) const noexcept {
    status.surfacePv_um = m_revolutionWidth_um;
    status.surfaceRms_um = std::sqrt(m_running_um2);
    status.untreatedRms_um = std::sqrt(m_runningUntreated_um2);
}

void SurfaceRecord::fill(TurningRecord& record) const noexcept {
    record.surfacePv_um = m_revolutionWidth_um;
    if (m_whole.count > 0) {
        record.surfaceRms_um = rms(m_whole.error_um2, m_whole.count);
        record.untreatedRms_um = rms(m_whole.untreated_um2, m_whole.count);
    }
    if (m_steady.count > 0) {
        record.steadyRms_um = rms(m_steady.error_um2, m_steady.count);
        record.openSteadyRms_um = rms(m_steady.untreated_um2, m_steady.count);
        record.steadyPv_um = m_steadyExtent.width();
        record.openSteadyPv_um = m_steadyUntreated.width();
        record.steadyForce_N = m_steadyForce_N / static_cast<double>(m_steady.count);
    }
}

}  // namespace kerf::turning
