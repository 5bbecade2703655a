// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "engine/process/tapping/drive_params.h"
#include "engine/process/tapping/tap_trajectory.h"

namespace kerf::tapping {

/// The Z servo alone: position P, velocity PI, torque lag, friction, optional dead time of the speed command.
///
///   v_c = K_pz (z_c − z) + ff_z ż_c
///   b = w_z (v_c − v) + I + fa_z z̈_c, clipped at a_max,z; I frozen while clipped; lag t_a
///   v̇ = b − vis_z v − coul_z tanh(v/v_c) − thrust·engaged·tanh(ω/v_c)
/// With backlash the table stands still until the play is taken up; with a resonance (ω, ζ, share p) the structure
/// swings against it, q̈ + 2ζω q̇ + ω² q = −v̇, and the measured position is z_table + p q. Stiction s makes Coulomb's
/// friction 1 + s exp(−(v/4v_c)²) times as large.
/// The plant and the tuner's assumed model are the same code with different constants. tick() may run in the cycle.
class ZServo {
 public:
    struct Command {
        double position_mm{0.0};
        double velocity_mmPerS{0.0};
        double accel_mmPerS2{0.0};
    };

    explicit ZServo(const DriveParams& params) noexcept;
    void setParams(const DriveParams& params) noexcept;
    /// Hold a new command until the next tick.
    void command(const Command& command) noexcept;
    /// One velocity-loop step; `thrust_mmPerS2` opposes positive motion.
    void substep(double thrust_mmPerS2) noexcept;
    /// Measured: at the table, with the structure's swing. The position loop is closed over it.
    [[nodiscard]] double position_mm() const noexcept { return m_measured_mm; }
    /// Standing still at a position, all memory of the motion gone: after a stop.
    void restAt(double position_mm) noexcept;

 private:
    /// The structure's oscillator over one substep under a constant acceleration, exact.
    struct Swing {
        double a11{1.0}, a12{0.0}, a21{0.0}, a22{1.0}, b1{0.0}, b2{0.0};
    };
    void measure(double accel_mmPerS2) noexcept;

    static constexpr std::size_t kDelayLine = 1024;
    DriveParams m_p;
    Swing m_swing{};
    double m_swing_mm{0.0}, m_swing_mmPerS{0.0}, m_table_mm{0.0}, m_measured_mm{0.0};
    double m_z_mm{0.0}, m_v_mmPerS{0.0}, m_torque_mmPerS2{0.0}, m_integral_mmPerS2{0.0};
    double m_wanted_mmPerS{0.0}, m_accelFf_mmPerS2{0.0};
    std::array<double, kDelayLine> m_delayed_mmPerS{};
    std::size_t m_delayHead{0};
    std::size_t m_delaySteps{0};
};

/// Spindle and Z servo of a tapping machine, one position tick at a time.
///
///   spindle  ω_c = K_ps (θ_c − θ) + ff_s θ̇_c; filter t_f; a = w_s e + I, clipped at a_max,s, I frozen while clipped
///            ω̇ = a − vis_s ω − load·engaged·tanh(ω/v_c), another load coming out
///   order    in a substep: filter, spindle torque, load (old θ), spindle speed and angle, then Z with the new ω:
///   torque,
///            friction, speed, position. Semi-implicit Euler, step tick/substeps.
/// Signs: positive is into the hole, for both axes. A slaved Z takes z_c = pitch·θ as measured at the tick, and its
/// speed from the difference of two ticks. Source: process reference vectors for high-speed rigid tapping.
/// tick() allocates nothing and may run in the cycle.
class TapDrive {
 public:
    struct Axis {
        double spindle_rev{0.0};
        double z_mm{0.0};
    };

    explicit TapDrive(const DriveParams& params) noexcept;
    /// Position of both axes now.
    [[nodiscard]] Axis axes() const noexcept { return {m_theta_rev, m_zServo.position_mm()}; }
    [[nodiscard]] double spindleSpeed_revPerS() const noexcept { return m_omega_revPerS; }
    /// One tick under a spindle command; `zTrim_mm` is added to the Z position command.
    void tick(const TapTrajectory::Point& command, double zTrim_mm) noexcept;
    void restAt(const Axis& axes) noexcept;
    /// Change gains or load between two ticks; state stays.
    void setParams(const DriveParams& params) noexcept;
    [[nodiscard]] const DriveParams& params() const noexcept { return m_p; }

 private:
    DriveParams m_p;
    double m_theta_rev{0.0}, m_omega_revPerS{0.0}, m_filtered_revPerS{0.0}, m_integral_revPerS2{0.0};
    double m_lastReference_mm{0.0};
    ZServo m_zServo;
};

/// Ticks of one whole tap: there, back, and the tail.
[[nodiscard]] std::size_t tapTicks(const DriveParams& params);

/// Runs one tap from rest. Spans hold tapTicks() values, sampled before each tick's update; `zTrim_mm` may be empty.
void simulateTap(const DriveParams& params, std::span<const double> zTrim_mm, std::span<double> spindle_rev,
                 std::span<double> z_mm);

}  // namespace kerf::tapping
