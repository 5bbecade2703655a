// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/tapping/tap_drive.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace kerf::tapping {
namespace {

constexpr double kSticking = 4.0;  ///< reversal speeds over which stiction fades

}  // namespace

ZServo::ZServo(const DriveParams& params) noexcept : m_p(params) {
    setParams(params);
}

void ZServo::setParams(const DriveParams& params) noexcept {
    m_p = params;
    const double steps = std::round(params.zDelay_s * params.substeps / params.tick_s);
    m_delaySteps = std::min(static_cast<std::size_t>(std::max(steps, 0.0)), kDelayLine - 1);
    if (params.zResonance_Hz <= 0.0) return;
    const double omega_perS = 2.0 * std::numbers::pi * params.zResonance_Hz;
    const double decay_perS = params.zResonanceDamping * omega_perS;
    const double swing_perS = std::sqrt(omega_perS * omega_perS - decay_perS * decay_perS);
    const double h = params.tick_s / params.substeps;
    const double left = std::exp(-decay_perS * h);
    const double c = left * std::cos(swing_perS * h);
    const double s = left * std::sin(swing_perS * h) / swing_perS;
    m_swing = {c + decay_perS * s, s, -omega_perS * omega_perS * s, c - decay_perS * s, 0.0, -s};
    m_swing.b1 = -(1.0 - m_swing.a11) / (omega_perS * omega_perS);
}

void ZServo::command(const Command& command) noexcept {
    m_wanted_mmPerS = m_p.zKp_perS * (command.position_mm - m_measured_mm) + m_p.zVelocityFf * command.velocity_mmPerS;
    m_accelFf_mmPerS2 = m_p.zAccelFf * command.accel_mmPerS2;
}

void ZServo::substep(double thrust_mmPerS2) noexcept {
    const double h = m_p.tick_s / m_p.substeps;
    m_delayed_mmPerS[m_delayHead] = m_wanted_mmPerS;
    const double wanted_mmPerS = m_delayed_mmPerS[(m_delayHead + kDelayLine - m_delaySteps) % kDelayLine];
    m_delayHead = (m_delayHead + 1) % kDelayLine;
    const double error_mmPerS = wanted_mmPerS - m_v_mmPerS;
    const double asked_mmPerS2 = m_p.zBandwidth_perS * error_mmPerS + m_integral_mmPerS2 + m_accelFf_mmPerS2;
    if (std::abs(asked_mmPerS2) < m_p.zAccelMax_mmPerS2) {
        m_integral_mmPerS2 += m_p.zIntegral_perS * m_p.zBandwidth_perS * error_mmPerS * h;
    }
    const double given_mmPerS2 = std::clamp(asked_mmPerS2, -m_p.zAccelMax_mmPerS2, m_p.zAccelMax_mmPerS2);
    m_torque_mmPerS2 += h / m_p.zTorqueLag_s * (given_mmPerS2 - m_torque_mmPerS2);
    double coulomb_mmPerS2 = m_p.zCoulomb_mmPerS2;
    if (m_p.zStiction > 0.0) {
        const double slip = m_v_mmPerS / (kSticking * m_p.reversalSpeed);
        coulomb_mmPerS2 *= 1.0 + m_p.zStiction * std::exp(-slip * slip);
    }
    const double friction_mmPerS2 =
        m_p.zViscous_perS * m_v_mmPerS + coulomb_mmPerS2 * std::tanh(m_v_mmPerS / m_p.reversalSpeed) + thrust_mmPerS2;
    m_v_mmPerS += h * (m_torque_mmPerS2 - friction_mmPerS2);
    m_z_mm += h * m_v_mmPerS;
    measure(m_torque_mmPerS2 - friction_mmPerS2);
}

void ZServo::measure(double accel_mmPerS2) noexcept {
    const double play_mm = 0.0005 * m_p.zBacklash_um;  // to either side
    m_table_mm = play_mm > 0.0 ? std::clamp(m_table_mm, m_z_mm - play_mm, m_z_mm + play_mm) : m_z_mm;
    m_measured_mm = m_table_mm;
    if (m_p.zResonance_Hz <= 0.0) return;
    const double swing_mm = m_swing.a11 * m_swing_mm + m_swing.a12 * m_swing_mmPerS + m_swing.b1 * accel_mmPerS2;
    m_swing_mmPerS = m_swing.a21 * m_swing_mm + m_swing.a22 * m_swing_mmPerS + m_swing.b2 * accel_mmPerS2;
    m_swing_mm = swing_mm;
    m_measured_mm += m_p.zResonanceShare * m_swing_mm;
}

void ZServo::restAt(double position_mm) noexcept {
    m_z_mm = m_table_mm = m_measured_mm = position_mm;
    m_swing_mm = m_swing_mmPerS = 0.0;
    m_v_mmPerS = 0.0;
    m_torque_mmPerS2 = 0.0;
    m_integral_mmPerS2 = 0.0;
    m_wanted_mmPerS = 0.0;
    m_accelFf_mmPerS2 = 0.0;
    m_delayed_mmPerS.fill(0.0);
}

TapDrive::TapDrive(const DriveParams& params) noexcept : m_p(inGear(params)), m_zServo(params) {}

void TapDrive::setParams(const DriveParams& params) noexcept {
    m_p = inGear(params);
    m_zServo.setParams(params);
}

void TapDrive::restAt(const Axis& axes) noexcept {
    m_theta_rev = axes.spindle_rev;
    m_omega_revPerS = 0.0;
    m_filtered_revPerS = 0.0;
    m_integral_revPerS2 = 0.0;
    m_lastReference_mm = m_p.pitch_mm * axes.spindle_rev;
    m_zServo.restAt(axes.z_mm);
}

void TapDrive::tick(const TapTrajectory::Point& command, double zTrim_mm) noexcept {
    const double h = m_p.tick_s / m_p.substeps;
    const bool slaved = m_p.slaved > 0.5;
    const double reference_mm = m_p.pitch_mm * (slaved ? m_theta_rev : command.position_rev);
    const double reference_mmPerS =
        slaved ? (reference_mm - m_lastReference_mm) / m_p.tick_s : m_p.pitch_mm * command.velocity_revPerS;
    const double reference_mmPerS2 = slaved ? 0.0 : m_p.pitch_mm * command.accel_revPerS2;
    m_lastReference_mm = reference_mm;
    m_zServo.command({reference_mm + zTrim_mm, reference_mmPerS, reference_mmPerS2});
    const double wanted_revPerS =
        m_p.spindleKp_perS * (command.position_rev - m_theta_rev) + m_p.spindleVelocityFf * command.velocity_revPerS;
    const int substeps = static_cast<int>(m_p.substeps);
    for (int s = 0; s < substeps; ++s) {
        m_filtered_revPerS += h / m_p.spindleFilter_s * (wanted_revPerS - m_filtered_revPerS);
        const double error_revPerS = m_filtered_revPerS - m_omega_revPerS;
        const double asked_revPerS2 = m_p.spindleBandwidth_perS * error_revPerS + m_integral_revPerS2;
        if (std::abs(asked_revPerS2) < m_p.spindleAccelMax_revPerS2) {
            m_integral_revPerS2 += m_p.spindleIntegral_perS * m_p.spindleBandwidth_perS * error_revPerS * h;
        }
        const double given_revPerS2 =
            std::clamp(asked_revPerS2, -m_p.spindleAccelMax_revPerS2, m_p.spindleAccelMax_revPerS2);
        const double engaged = std::clamp((m_theta_rev - m_p.engage_rev) / m_p.chamfer_rev, 0.0, 1.0);
        const double load_revPerS2 = (m_omega_revPerS > 0.0 ? m_p.load_revPerS2 : m_p.loadOut_revPerS2) * engaged *
                                     std::tanh(m_omega_revPerS / m_p.reversalSpeed);
        m_omega_revPerS += h * (given_revPerS2 - m_p.spindleViscous_perS * m_omega_revPerS - load_revPerS2);
        m_theta_rev += h * m_omega_revPerS;
        m_zServo.substep(m_p.thrust_mmPerS2 * engaged * std::tanh(m_omega_revPerS / m_p.reversalSpeed));
    }
}

std::size_t tapTicks(const DriveParams& params) {
    const TapTrajectory path(params.depth_rev, params.speed_rpm, params.ramp_revPerS2);
    return static_cast<std::size_t>(std::llround((path.end_s() + params.tail_s) / params.tick_s));
}

void simulateTap(const DriveParams& params, std::span<const double> zTrim_mm, std::span<double> spindle_rev,
                 std::span<double> z_mm) {
    assert(spindle_rev.size() == z_mm.size());
    const TapTrajectory path(params.depth_rev, params.speed_rpm, params.ramp_revPerS2);
    TapDrive drive(params);
    for (std::size_t k = 0; k < z_mm.size(); ++k) {
        const double time_s = static_cast<double>(k) * params.tick_s;
        const TapDrive::Axis axes = drive.axes();
        spindle_rev[k] = axes.spindle_rev;
        z_mm[k] = axes.z_mm;
        drive.tick(path.at(time_s), k < zTrim_mm.size() ? zTrim_mm[k] : 0.0);
    }
}

}  // namespace kerf::tapping
