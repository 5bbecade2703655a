// SPDX-License-Identifier: GPL-3.0-or-later
// What the milling loop says of itself: status and chart samples.
#include <algorithm>

#include "engine/process/milling/force_bounds.h"
#include "engine/process/milling/milling_loop.h"
#include "engine/process/milling/milling_setup.h"

namespace kerf {

double MillingLoop::gainMargin() const noexcept {
    return milling::gainMargin(m_setup, m_law, m_controller.stiffness(), m_revolution_s * m_controller.period());
}

void MillingLoop::report(Status& status) const noexcept {
    MillingStatus& out = status.milling;
    out = m_status;
    out.inAir = m_decision.inAir;
    out.stopped = m_stopAlarm != 0;
    out.law = m_law;
    for (std::size_t i = 0; i < kMillingLawCount; ++i) {
        out.lawUnavailable[i] = whyUnavailable(static_cast<MillingLaw>(i));
    }
    out.setup = m_setup.revision;
    out.blank = m_blank.revision;
    out.reference_N = m_setup.reference_N;
    out.overload_N = m_setup.overload_N;
    out.wantedFeed_mmPerS = m_wanted_mmPerS;
    out.progress = std::clamp((m_status.position_mm - m_setup.from_mm) / (m_setup.to_mm - m_setup.from_mm), 0.0, 1.0);
    out.revolution_s = m_revolution_s;
    const milling::StiffnessEstimate& stiffness = m_controller.stiffness();
    out.stiffnessKnown = stiffness.valid;
    out.stiffness = lnCb();
    out.stiffnessHalf95 = stiffness.half95;
    out.kx_NPerMm = stiffness.kx_NPerMm;
    out.waviness_um = m_record.cut().waviness_um;
    out.gainMargin = gainMargin();
    out.signal = m_signal;
    out.decisions_Hz = 1.0 / (m_revolution_s * m_controller.period());
    out.teethSeen = milling::teethSeen(m_signal, m_setup.spindleSpeed_rpm, m_setup.flutes);
    out.zero = m_zero.state();
    out.zero_N = m_zero.zero_N();
    out.zeroDoubt_N = m_zero.doubt_N();
    out.wear = m_wear.rise();
    out.wearPerPart = m_wear.perPart();
    out.partsWithTool = m_wear.parts();
    out.wearWarning = m_setup.wearWarning;
    m_wear.save(out.tool);
    out.tool.kxLogWeight = m_controller.kxLogWeights();
    const MillingCut& cut = m_record.cut();
    out.overReference_s = cut.overReference_s;
    out.peakForce_N = cut.peakForce_N;
    out.peakAt_mm = cut.peakAt_mm;
    out.meanForce_N = cut.meanForce_N;
    out.stops = cut.stops;
    out.savedTime_s = m_record.saved_s();
}

void MillingLoop::sample(Sample& sample) const noexcept {
    if (!m_status.cutting) {
        return;
    }
    sample.force_N = static_cast<float>(m_status.force_N.good() ? m_status.force_N.value : 0.0);
    sample.forceLow_N = m_rawTaken ? 0.0F : m_rawLow_N;
    sample.forceHigh_N = m_rawTaken ? 0.0F : m_rawHigh_N;
    sample.wantedFeed_mmPerS = static_cast<float>(m_wanted_mmPerS);
    sample.path_mm = static_cast<float>(m_status.position_mm);
    sample.wallDeviation_um = static_cast<float>(m_status.wallDeviation_um);
    m_rawTaken = true;
}

}  // namespace kerf
