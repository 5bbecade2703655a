// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/turning/depth_control.h"

#include <algorithm>

namespace kerf::turning {
namespace {

constexpr double kAuthorityStep = 0.0025;  ///< per sample: full trim after 400
constexpr std::size_t kMendAfter = 1000;
constexpr double kMendSigmas = 4.0;
constexpr double kAuthorityDrop = 0.05;  ///< per sample: none after 20, 4 ms

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
    out.meanGuard = params.onMachine;
    if (out.forceOnly) {
        out.tracker.levelWalk_um2 = 1e-7;  // the sum over revolutions drifts
        out.levelVariance_um2 = 1.0;
    }
    return out;
}

/// The published PI laws see x̂_i with its leak inside the loop; everybody else tells the observer what the trim does.
bool trimKnown(const DepthControlParams& params) noexcept {
    return params.kind == ControllerKind::Default || params.onMachine;
}

}  // namespace

PiGains paperGains(PlantKind plant, double gain) noexcept {
    return scaled(plant, gain, 0.02, 0.3, 0.02);
}
PiGains tunedGains(PlantKind plant, double gain) noexcept {
    return scaled(plant, gain, 0.045, 2.0, 0.0375);
}

namespace {
PiGains piGains(const DepthControlParams& params, ControllerKind kind) noexcept {
    return kind == ControllerKind::Paper ? paperGains(params.plant, params.piGain)
                                         : tunedGains(params.plant, params.piGain);
}
}  // namespace

DepthControl::DepthControl(const DepthControlParams& params) noexcept
    : m_params(params),
      m_next(params.kind),
      m_trimKnown(trimKnown(params)),
      m_observer(params.process, params.revolutionSamples),
      m_path(params.plant, params.process, params.slidePole, params.nominalGain_NPerUm),
      m_canceller(cancellerParams(params), m_path),
      m_pi(piGains(params, params.kind)) {}

void DepthControl::reset() noexcept {
    *this = DepthControl(m_params);
}

void DepthControl::beginCut() noexcept {
    m_observer.beginCut();
    m_canceller.reset();
    m_pi.reset();
    m_reference.reset();
    m_guard.reset();
    m_command_um = m_error_um = m_authority = 0.0;
    m_actingSamples = 0;
}

void DepthControl::setProcess(const ProcessParams& process) noexcept {
    m_params.process = process;
    m_observer.setProcess(process);
    m_path.setProcess(process);
    m_canceller.setProcess(process);
}

void DepthControl::setApplied(double command_um) noexcept {
    m_canceller.setApplied(command_um);
    if (m_params.kind == ControllerKind::Paper || m_params.kind == ControllerKind::Pi) {
        m_pi.shift(command_um - m_command_um);  // what a limit took away must not be integrated
        m_command_um = command_um;
    }
}

bool DepthControl::acting() const noexcept {
    switch (m_params.kind) {
        case ControllerKind::Default:
            return m_canceller.acting();
        case ControllerKind::Paper:
        case ControllerKind::Pi:
            return ready();
        case ControllerKind::Open:
            break;
    }
    return false;
}

double DepthControl::update(const Input& input) noexcept {
    const double inner_um = m_params.plant == PlantKind::B2
                                ? m_observer.inner_um(input.force_N, m_trimKnown ? m_canceller.applied_um() : 0.0)
                                : input.inner_um;
    if (m_params.plant == PlantKind::B2 && !m_observer.ready()) {
        return 0.0;
    }
    double cancel_um = 0.0;
    if (m_params.kind == ControllerKind::Default || m_params.onMachine) {
        m_canceller.setSilent(m_silent || m_params.kind != ControllerKind::Default || m_next != m_params.kind);
        cancel_um = m_canceller.update(inner_um);
        m_error_um = inner_um - m_canceller.level_um();
    }
    if (m_params.onMachine) {
        mendSurface(inner_um);
    }
    switch (m_params.kind) {
        case ControllerKind::Open:
            m_command_um = 0.0;
            break;
        case ControllerKind::Default:
            m_command_um = cancel_um;
            break;
        case ControllerKind::Paper:
        case ControllerKind::Pi:
            m_command_um = piCommand_um(inner_um);
            break;
    }
    if (m_next != m_params.kind && m_command_um == 0.0) {
        m_params.kind = m_next;
        m_pi = PiLaw(piGains(m_params, m_next));
        m_guard.reset();
        m_authority = 0.0;
    }
    return m_command_um;
}

/// While the depth built up at the touch û was no motion: those few places of the revolution carry the error on. Once
/// the tones are known they are given what the tones say, during two revolutions.
void DepthControl::mendSurface(double inner_um) noexcept {
    m_actingSamples = m_canceller.acting() ? m_actingSamples + 1 : 0;
    const bool now = m_actingSamples > kMendAfter && m_actingSamples <= kMendAfter + 2 * m_params.revolutionSamples;
    const ToneTracker& tracker = m_canceller.tracker();
    const double innovation_um = m_canceller.innovation_um();
    if (now && innovation_um * innovation_um >
                   kMendSigmas * kMendSigmas * (tracker.noise_um2() + tracker.predictedVariance_um2())) {
        m_observer.replaceLast(inner_um - innovation_um);
    }
}

double DepthControl::piCommand_um(double inner_um) noexcept {
    const double untreated_um = inner_um - m_path.step_um(m_command_um);
    m_error_um = inner_um - m_reference.update_um(untreated_um, m_path.entryShape());
    if (!m_params.onMachine) {
        return m_guard.pass_um(m_pi.update(m_error_um));
    }
    const bool off = m_silent || m_next != m_params.kind;
    m_authority = std::clamp(m_authority + (off ? -kAuthorityDrop : kAuthorityStep), 0.0, 1.0);
    if (off && m_authority == 0.0) {
        m_pi.reset();
        m_guard.reset();
        return 0.0;
    }
    // While it ramps in the integral follows the whole command, so that it goes on where the ramp ends.
    const double whole_um = m_guard.pass_um(m_pi.update(m_error_um));
    const double command_um = m_authority * whole_um;
    m_pi.shift(command_um - whole_um);
    return command_um;
}

}  // namespace kerf::turning
