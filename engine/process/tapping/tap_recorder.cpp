// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/tapping/tap_recorder.h"

#include <algorithm>
#include <cmath>

namespace kerf {
namespace {

constexpr std::uint32_t kLostTicks = 20;
constexpr double kMaxMissing = 0.05;
constexpr double kPitchCheck_rev = 1.5;   ///< the ratio of the axes tells a pitch after this
constexpr double kPitchAtDepth = 0.01;    ///< at the bottom, where both stand …
constexpr double kPitchAtDepth_mm = 0.3;  ///< … or this far off, whichever is more

}  // namespace

void TapRecorder::begin(std::uint32_t gainsRevision, TapKind kind, std::int64_t now_ns) noexcept {
    TapRecord& tap = m_records.writeSlot();
    tap.count = 0;
    tap.job = m_job.revision;
    tap.gains = gainsRevision;
    tap.kind = kind;
    tap.figures = {};
    m_figures = {};
    m_squares_um2 = 0.0;
    m_engaged = false;
    m_low_um = 0.0;
    m_high_um = 0.0;
    m_lostInARow = 0;
    m_signalLost = false;
    m_deepest_rev = 0.0;
    m_deepest_mm = 0.0;
    m_recording = true;
    m_begin_ns = now_ns;
}

void TapRecorder::follow(double spindle_rev, double z_mm) noexcept {
    if (m_recording && count() == 0) {
        m_spindleZero_rev = spindle_rev;
        m_zZero_mm = z_mm;
    }
    m_spindle_rev = spindle_rev - m_spindleZero_rev;
    m_z_mm = m_zZero_mm - z_mm;
    m_error_um = 1000.0 * (m_job.pitch_mm * m_spindle_rev - m_z_mm);
}

void TapRecorder::keep(bool good) noexcept {
    TapRecord& tap = m_records.writeSlot();
    if (tap.count < kMaxTapTicks) {
        const std::uint32_t k = tap.count++;
        tap.spindle_rev[k] = static_cast<float>(m_spindle_rev);
        tap.z_mm[k] = static_cast<float>(m_z_mm);
        tap.valid[k] = good ? 1 : 0;
    }
    m_lostInARow = good ? 0 : m_lostInARow + 1;
    if (!good) {
        ++m_figures.missing;
        return;
    }
    ++m_figures.samples;
    m_deepest_rev = std::max(m_deepest_rev, m_spindle_rev);
    m_deepest_mm = std::max(m_deepest_mm, m_z_mm);
    m_figures.saec_mm += std::abs(m_error_um) / 1000.0;
    m_figures.peak_um = std::max(m_figures.peak_um, std::abs(m_error_um));
    m_squares_um2 += m_error_um * m_error_um;
    if (m_spindle_rev >= m_job.engage_rev) {
        m_low_um = m_engaged ? std::min(m_low_um, m_error_um) : m_error_um;
        m_high_um = m_engaged ? std::max(m_high_um, m_error_um) : m_error_um;
        m_engaged = true;
    }
}

void TapRecorder::fillGap(std::int64_t now_ns, std::int64_t tick_ns) noexcept {
    TapRecord& tap = m_records.writeSlot();
    const auto due =
        static_cast<std::uint64_t>((now_ns - m_begin_ns + tick_ns / 10) / std::max<std::int64_t>(1, tick_ns));
    while (tap.count > 0 && tap.count < due && tap.count < kMaxTapTicks) {
        const std::uint32_t k = tap.count++;
        tap.spindle_rev[k] = tap.spindle_rev[k - 1];
        tap.z_mm[k] = tap.z_mm[k - 1];
        tap.valid[k] = 0;
        ++m_figures.missing;
        ++m_lostInARow;
    }
}

void TapRecorder::watchSignal() noexcept {
    m_signalLost = m_signalLost || m_lostInARow > kLostTicks;
}

bool TapRecorder::sumUp(bool whole) noexcept {
    const double total = std::max(1.0, static_cast<double>(m_figures.samples + m_figures.missing));
    if (m_figures.samples > 0) {
        m_figures.rms_um = std::sqrt(m_squares_um2 / static_cast<double>(m_figures.samples));
        m_figures.engagedPp_um = m_high_um - m_low_um;
        if (whole) m_figures.saec_mm *= total / static_cast<double>(m_figures.samples);
    }
    return m_figures.samples > 0 && static_cast<double>(m_figures.missing) <= kMaxMissing * total;
}

void TapRecorder::publish(std::uint32_t number, TapOutcome outcome) noexcept {
    if (!m_recording) return;
    m_recording = false;
    TapRecord& tap = m_records.writeSlot();
    tap.number = number;
    tap.outcome = outcome;
    tap.figures = m_figures;
    m_records.publish();
}

std::optional<double> TapRecorder::pitchMoving_mm() const noexcept {
    if (m_spindle_rev <= kPitchCheck_rev) return std::nullopt;
    return m_z_mm / m_spindle_rev;
}

double TapRecorder::pitchAtDepth_mm() const noexcept {
    return m_deepest_mm / std::max(m_deepest_rev, 1e-9);
}

bool TapRecorder::pitchFits() const noexcept {
    const double programmed_mm = m_job.pitch_mm * m_deepest_rev;
    return std::abs(m_deepest_mm - programmed_mm) <= std::max(kPitchAtDepth * programmed_mm, kPitchAtDepth_mm);
}

}  // namespace kerf
