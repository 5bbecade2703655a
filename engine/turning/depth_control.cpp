// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/turning/depth_control.h"

namespace kerf::turning {
namespace {

PiGains scaled(PlantKind plant, double gain, double onProcess, double onSlide, double onTool) noexcept {
    PiGains gains;
    switch (plant) {
        case PlantKind::R0:
            gains.gain = onProcess;
            break;
        case PlantKind::R1:
        case PlantKind::B1:
            gains.gain = onSlide;
            break;
        case PlantKind::B2:
            gains.gain = onTool;
            break;
    }
    gains.gain = gain > 0.0 ? gain : gains.gain;
    if (plant == PlantKind::B2) {
        gains.gain = -gains.gain;  // x_i falls when the command rises
    }
    return gains;
}

ToneCanceller::Params cancellerParams(const DepthControlParams& params) noexcept {
    ToneCanceller::Params out;
    out.revolutionSamples = params.revolutionSamples;
    out.forceOnly = params.plant == PlantKind::B2;
    out.knownTones_Hz = params.knownTones_Hz;
    out.knownCount = params.knownCount;
    if (out.forceOnly) {
        out.tracker.levelWalk_um2 = 1e-7;  // the sum over revolutions drifts
        out.levelVariance_um2 = 1.0;
    }
    return out;
}

}  // namespace

PiGains paperGains(PlantKind plant, double gain) noexcept {
    return scaled(plant, gain, 0.02, 0.3, 0.02);
}
PiGains tunedGains(PlantKind plant, double gain) noexcept {
    return scaled(plant, gain, 0.045, 2.0, 0.0375);
}

DepthControl::DepthControl(const DepthControlParams& params) noexcept
    : m_params(params),
      m_observer(params.process, params.revolutionSamples),
      m_path(params.plant, params.process, params.slidePole, params.nominalGain_NPerUm),
      m_canceller(cancellerParams(params), m_path),
      m_pi(params.kind == ControllerKind::Paper ? paperGains(params.plant, params.piGain)
                                                : tunedGains(params.plant, params.piGain)) {}

void DepthControl::reset() noexcept {
    *this = DepthControl(m_params);
}

double DepthControl::update(const Input& input) noexcept {
    const double inner_um = m_params.plant == PlantKind::B2 ? m_observer.inner_um(input.force_N) : input.inner_um;
    if (m_params.kind == ControllerKind::Open || (m_params.plant == PlantKind::B2 && !m_observer.ready())) {
        return 0.0;
    }
    if (m_params.kind == ControllerKind::Default) {
        m_command_um = m_canceller.update(inner_um);
        m_error_um = inner_um - m_canceller.level_um();
        return m_command_um;
    }
    const double untreated_um = inner_um - m_path.step_um(m_command_um);
    m_error_um = inner_um - m_reference.update_um(untreated_um, m_path.entryShape());
    m_command_um = m_guard.pass_um(m_pi.update(m_error_um));
    return m_command_um;
}

}  // namespace kerf::turning
