// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/machine/simulated/simulated_tapping.h"

#include <algorithm>
#include <cmath>

namespace kerf {
namespace {

constexpr double kInHole_rev = 0.2;  ///< less is not inside the hole
constexpr double kHome_rev = 1e-3;   ///< closer than this the way back is over

tapping::TapTrajectory pathOf(const tapping::DriveParams& drive) {
    return {drive.depth_rev, drive.speed_rpm, drive.ramp_revPerS2};
}

}  // namespace

SimulatedTapping::SimulatedTapping(const Params& params)
    : m_params(params),
      m_gains(params.drive),
      m_path(pathOf(params.drive)),
      m_drive(params.drive),
      m_scatter(Random(params.seed).stream(1)),
      m_noise(Random(params.seed).stream(2)) {}

void SimulatedTapping::fit(Capabilities& capabilities) const {
    for (Capability* capability : {&capabilities.servoGains, &capabilities.zTrim}) {
        capability->fitted = true;
        capability->why = Sentence{};
    }
}

Result<void> SimulatedTapping::begin(const StartProgram& program, std::uint32_t) noexcept {
    const bool sound = program.pitch_mm > 0.0 && program.revolutions > 0.0 && program.spindleSpeed_rpm > 0.0 &&
                       std::isfinite(program.pitch_mm * program.revolutions * program.spindleSpeed_rpm);
    if (!sound) return fail(KERF_TEXT("The tapping program needs pitch, revolutions and speed above zero."));
    if (std::abs(m_drive.axes().spindle_rev) > 0.5) return fail(KERF_TEXT("The tap stands in the hole."));
    m_gains.pitch_mm = m_params.programPitch_mm > 0.0 ? m_params.programPitch_mm : program.pitch_mm;
    m_gains.depth_rev = program.revolutions;
    m_gains.speed_rpm = program.spindleSpeed_rpm;
    tapping::DriveParams drive = m_gains;
    const double load = program.air ? 0.0 : 1.0 + m_params.loadSpread * m_scatter.uniform(-1.0, 1.0);
    const double friction = 1.0 + m_params.frictionSpread * m_scatter.uniform(-1.0, 1.0);
    drive.load_revPerS2 *= load;
    drive.loadOut_revPerS2 *= load;
    drive.thrust_mmPerS2 *= load;
    drive.zCoulomb_mmPerS2 *= friction;
    drive.zViscous_perS *= friction;
    m_path = pathOf(drive);
    m_angleZero_rev += m_drive.axes().spindle_rev;
    m_drive = tapping::TapDrive(drive);
    m_command = {};
    m_ticks = 0;
    m_lastTick = static_cast<std::int64_t>(tapping::tapTicks(drive));
    m_owed_s = 0.0;
    m_retracting = false;
    m_running = true;
    return {};
}

void SimulatedTapping::abort() noexcept {
    m_running = false;
    m_drive.restAt(m_drive.axes());
    m_command = {m_drive.axes().spindle_rev, 0.0, 0.0};
}

bool SimulatedTapping::standsInWork() const noexcept {
    return !m_running && std::abs(m_drive.axes().spindle_rev) > kInHole_rev;
}

void SimulatedTapping::takenOut() noexcept {
    m_angleZero_rev += m_drive.axes().spindle_rev;  // the spindle has not turned, the hole is another one
    m_drive.restAt({});
    m_command = {};
}

Result<void> SimulatedTapping::setGains(const ServoGains& gains) noexcept {
    if (m_running) return fail(KERF_TEXT("Gains change only between taps."));
    m_gains.spindleKp_perS = gains.spindleKp_perS;
    m_gains.zKp_perS = gains.zKp_perS;
    m_gains.zVelocityFf = gains.zFeedForward[0];
    m_gains.zAccelFf = gains.zFeedForward[1];
    return {};
}

Result<void> SimulatedTapping::retractInSync() noexcept {
    if (!m_running) m_command = {m_drive.axes().spindle_rev, 0.0, 0.0};
    m_retracting = true;
    m_running = true;
    m_owed_s = 0.0;
    m_lastTick = m_ticks + static_cast<std::int64_t>(60.0 / m_gains.tick_s);  // until the command is back
    return {};
}

tapping::TapTrajectory::Point SimulatedTapping::retractCommand() noexcept {
    const double dt_s = m_gains.tick_s;
    const double ramp_revPerS2 = m_gains.ramp_revPerS2;
    const double left_rev = std::max(m_command.position_rev, 0.0);
    const double fastest_revPerS = std::min(m_path.peakSpeed_revPerS(), std::sqrt(2.0 * ramp_revPerS2 * left_rev));
    // Never faster than what reaches the start in one tick.
    const double wanted_revPerS = -std::min(fastest_revPerS, left_rev / dt_s);
    const double accel_revPerS2 =
        std::clamp((wanted_revPerS - m_command.velocity_revPerS) / dt_s, -ramp_revPerS2, 2.0 * ramp_revPerS2);
    m_command.accel_revPerS2 = accel_revPerS2;
    m_command.velocity_revPerS += accel_revPerS2 * dt_s;
    m_command.position_rev += m_command.velocity_revPerS * dt_s;
    if (m_command.position_rev < kHome_rev) {
        m_command = {};
        m_lastTick = std::min(m_lastTick, m_ticks + static_cast<std::int64_t>(m_gains.tail_s / dt_s) + 1);
    }
    return m_command;
}

void SimulatedTapping::tick(const MachineOutputs& outputs) noexcept {
    m_command = m_retracting ? retractCommand() : m_path.at(static_cast<double>(m_ticks) * m_gains.tick_s);
    m_drive.tick(m_command, outputs.zTrim_um / 1000.0);
    ++m_ticks;
}

bool SimulatedTapping::advance(const SimulationStep& step, MachineInputs& inputs) noexcept {
    inputs.servoGains = ServoGains{m_gains.spindleKp_perS, m_gains.zKp_perS, {m_gains.zVelocityFf, m_gains.zAccelFf}};
    inputs.servoGainsQuality = Quality::Good;
    if (!m_running && inputs.programProcess != ProcessId::Tapping) {
        m_angleZero_rev = inputs.spindleAngle_rev.value - m_drive.axes().spindle_rev;
        return false;
    }
    if (m_ticks == 0 && m_running) {
        m_angleZero_rev = inputs.spindleAngle_rev.value;
    }
    const tapping::TapDrive::Axis axes = m_drive.axes();
    const double noise_mm = m_params.noise_um > 0.0 ? m_params.noise_um / 1000.0 * m_noise.gauss() : 0.0;
    const double angle_rev = m_angleZero_rev + axes.spindle_rev;
    inputs.spindleAngle_rev = simulatedReading(angle_rev, step.now_ns, step.faults->spindleAngle, m_lastAngle_rev);
    m_lastAngle_rev = inputs.spindleAngle_rev;
    inputs.spindleSpeed_rpm = {60.0 * m_drive.spindleSpeed_revPerS(), step.now_ns, Quality::Good};
    inputs.position_mm[2] = {-(axes.z_mm + noise_mm), step.now_ns, Quality::Good};
    m_running = m_running && m_ticks < m_lastTick;  // the last tick's sample is still one of the program
    if (!m_running) return false;
    m_owed_s += step.dt_s;
    const double tick_s = m_gains.tick_s;
    while (m_owed_s > 0.5 * tick_s && m_ticks < m_lastTick) {
        m_owed_s -= tick_s;
        tick(*step.outputs);
    }
    return true;
}

}  // namespace kerf
