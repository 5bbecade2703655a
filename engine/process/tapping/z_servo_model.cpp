// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/tapping/z_servo_model.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include "engine/process/tapping/tap_drive.h"

namespace kerf::tapping {
namespace {

constexpr double kAuthorityBelow = 0.5;  ///< of the initial gain
constexpr double kAuthorityAbove = 1.6;
constexpr double kGainMargin = 2.5;   ///< critical gain over highest gain: 8 dB
constexpr double kTrimOfPitch = 0.8;  ///< the learned trim stays below this share of a pitch
constexpr std::array<double DriveParams::*, 3> kFitted{&DriveParams::zBandwidth_perS, &DriveParams::zIntegral_perS,
                                                       &DriveParams::zTorqueLag_s};
constexpr std::array<double, 3> kPriorSpread{0.5, 0.5, 1.0};
constexpr double kFitNoise_mm = 0.002;
constexpr double kLongestLag_s = 0.01;
constexpr int kFitSteps = 10;

}  // namespace

DriveParams withSettings(const DriveParams& params, const TapSettings& settings) {
    DriveParams out = params;
    out.spindleKp_perS = settings.spindleKp_perS;
    out.zKp_perS = settings.zKp_perS;
    out.zVelocityFf = settings.zVelocityFf;
    out.zAccelFf = settings.zAccelFf;
    return out;
}

std::vector<double> predictZ(const DriveParams& assumed, const TapSettings& settings,
                             std::span<const double> spindle_rev) {
    const DriveParams params = withSettings(assumed, settings);
    const TapTrajectory path(params.depth_rev, params.speed_rpm, params.ramp_revPerS2);
    ZServo servo(params);
    std::vector<double> z_mm(spindle_rev.size());
    const bool slaved = params.slaved > 0.5;
    double last_rev = 0.0;
    const auto late = static_cast<std::size_t>(std::lround(params.referenceDelay_s / params.tick_s));
    double lastReference_rev = 0.0;
    double lastReference_revPerS = 0.0;
    for (std::size_t k = 0; k < z_mm.size(); ++k) {
        z_mm[k] = servo.position_mm();
        const double time_s = static_cast<double>(k) * params.tick_s;
        const double speed_revPerS = (spindle_rev[k] - last_rev) / params.tick_s;
        last_rev = spindle_rev[k];
        TapTrajectory::Point point = path.at(time_s);
        if (slaved) {
            const double reference_rev = k < late ? 0.0 : spindle_rev[k - late];
            const double reference_revPerS = (reference_rev - lastReference_rev) / params.tick_s;
            const double accel_revPerS2 = (reference_revPerS - lastReference_revPerS) / params.tick_s;
            point = {reference_rev, reference_revPerS, params.referenceAccel * accel_revPerS2};
            lastReference_rev = reference_rev;
            lastReference_revPerS = reference_revPerS;
        }
        const double trim_mm = k < settings.zTrim_mm.size() ? settings.zTrim_mm[k] : 0.0;
        servo.command({params.pitch_mm * point.position_rev + trim_mm, params.pitch_mm * point.velocity_revPerS,
                       params.pitch_mm * point.accel_revPerS2});
        const double engaged = std::clamp((spindle_rev[k] - params.engage_rev) / params.chamfer_rev, 0.0, 1.0);
        const double thrust_mmPerS2 = params.thrust_mmPerS2 * engaged * std::tanh(speed_revPerS / params.reversalSpeed);
        for (int s = 0; s < static_cast<int>(params.substeps); ++s)
            servo.substep(thrust_mmPerS2);
    }
    return z_mm;
}

std::vector<double> trimResponse(const DriveParams& assumed, std::span<const double> trim_mm) {
    DriveParams linear = assumed;
    linear.zCoulomb_mmPerS2 = 0.0;
    linear.zBacklash_um = 0.0;
    linear.zAccelMax_mmPerS2 = 1e12;
    ZServo servo(linear);
    std::vector<double> z_mm(trim_mm.size());
    for (std::size_t k = 0; k < z_mm.size(); ++k) {
        z_mm[k] = servo.position_mm();
        servo.command({trim_mm[k], 0.0, 0.0});
        for (int s = 0; s < static_cast<int>(linear.substeps); ++s)
            servo.substep(0.0);
    }
    return z_mm;
}

namespace {

/// Misfit of a model to the recorded Z, prior included; mm².
double misfit_mm2(const DriveParams& assumed, const DriveParams& model, std::span<const double> predicted_mm,
                  const TapSignals& tap) {
    double sum_mm2 = 0.0;
    for (std::size_t k = 0; k < predicted_mm.size(); ++k) {
        if (tap.valid.empty() || tap.valid[k] != 0) sum_mm2 += std::pow(tap.z_mm[k] - predicted_mm[k], 2);
    }
    for (std::size_t i = 0; i < kFitted.size(); ++i) {
        const double far = std::log(model.*kFitted[i] / assumed.*kFitted[i]) / kPriorSpread[i];
        sum_mm2 += kFitNoise_mm * kFitNoise_mm * far * far;
    }
    return sum_mm2;
}

DriveParams moved(const DriveParams& model, const DriveParams& assumed, const Eigen::Vector3d& step) {
    DriveParams out = model;
    for (std::size_t i = 0; i < kFitted.size(); ++i)
        out.*kFitted[i] *= std::exp(step(static_cast<Eigen::Index>(i)));
    const double shortest_s = 1.01 * assumed.tick_s / assumed.substeps;
    out.zBandwidth_perS = std::clamp(out.zBandwidth_perS, 0.3 * assumed.zBandwidth_perS, 3.0 * assumed.zBandwidth_perS);
    out.zIntegral_perS = std::clamp(out.zIntegral_perS, 0.2 * assumed.zIntegral_perS, 5.0 * assumed.zIntegral_perS);
    out.zTorqueLag_s = std::clamp(out.zTorqueLag_s, shortest_s, kLongestLag_s);
    return out;
}

}  // namespace

DriveParams fitServo(const DriveParams& assumed, const TapSettings& settings, const TapSignals& tap) {
    DriveParams fitted = moved(assumed, assumed, Eigen::Vector3d::Zero());
    std::vector<double> base = predictZ(fitted, settings, tap.spindle_rev);
    double misfit = misfit_mm2(assumed, fitted, base, tap);
    double damping = 1e-3;
    for (int iteration = 0; iteration < kFitSteps; ++iteration) {
        constexpr double kStep = 0.02;
        std::array<std::vector<double>, 3> slopes;
        for (std::size_t i = 0; i < kFitted.size(); ++i) {
            DriveParams aside = fitted;
            aside.*kFitted[i] *= std::exp(kStep);
            slopes[i] = predictZ(aside, settings, tap.spindle_rev);
        }
        Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
        Eigen::Vector3d right = Eigen::Vector3d::Zero();
        for (std::size_t i = 0; i < 3; ++i) {
            const auto row = static_cast<Eigen::Index>(i);
            const double weight = kFitNoise_mm * kFitNoise_mm / (kPriorSpread[i] * kPriorSpread[i]);
            normal(row, row) += weight;
            right(row) += weight * std::log(assumed.*kFitted[i] / fitted.*kFitted[i]);
        }
        for (std::size_t k = 0; k < base.size(); ++k) {
            if (!tap.valid.empty() && tap.valid[k] == 0) continue;
            const Eigen::Vector3d slope((slopes[0][k] - base[k]) / kStep, (slopes[1][k] - base[k]) / kStep,
                                        (slopes[2][k] - base[k]) / kStep);
            normal += slope * slope.transpose();
            right += slope * (tap.z_mm[k] - base[k]);
        }
        bool better = false;
        for (int attempt = 0; attempt < 4 && !better; ++attempt) {
            Eigen::Matrix3d damped = normal;
            damped.diagonal() *= 1.0 + damping;
            const DriveParams candidate =
                moved(fitted, assumed, damped.ldlt().solve(right).cwiseMax(-1.0).cwiseMin(1.0).eval());
            std::vector<double> predicted = predictZ(candidate, settings, tap.spindle_rev);
            const double candidateMisfit = misfit_mm2(assumed, candidate, predicted, tap);
            better = candidateMisfit < misfit;
            damping = better ? 0.1 * damping : std::max(10.0 * damping, 1e-2);
            if (!better) continue;
            const bool settled = misfit - candidateMisfit < 1e-4 * misfit;
            fitted = candidate;
            base = std::move(predicted);
            misfit = candidateMisfit;
            if (settled) return fitted;
        }
        if (!better) break;
    }
    return fitted;
}

std::complex<double> openLoop(const DriveParams& drive, double omega_perS) {
    using Complex = std::complex<double>;
    const Complex s(0.0, omega_perS);
    const Complex torque = 1.0 / ((1.0 + drive.zTorqueLag_s * s) * (s + drive.zViscous_perS));
    const Complex control = drive.zBandwidth_perS * (s + drive.zIntegral_perS) / s;
    Complex velocity = control * torque / (1.0 + control * torque);
    if (drive.zResonance_Hz > 0.0) {
        const double own_perS = 2.0 * std::numbers::pi * drive.zResonance_Hz;
        velocity *= 1.0 - drive.zResonanceShare * s * s /
                              (s * s + 2.0 * drive.zResonanceDamping * own_perS * s + own_perS * own_perS);
    }
    return velocity / s * std::exp(-s * (drive.zDelay_s + 0.5 * drive.tick_s));
}

double criticalZKp_perS(const DriveParams& drive) {
    const double highest_perS = std::numbers::pi / drive.tick_s;
    double least_perS = 1.0 / std::abs(openLoop(drive, highest_perS));
    bool crossed = false;
    std::complex<double> last{};
    for (double omega_perS = 1.0; omega_perS < highest_perS; omega_perS *= 1.005) {
        const std::complex<double> value = openLoop(drive, omega_perS);
        // The locus crosses the negative real axis.
        if (last != std::complex<double>{} && value.real() < 0.0 && last.real() < 0.0 &&
            last.imag() * value.imag() <= 0.0) {
            const double here_perS = 1.0 / std::abs(value);
            least_perS = crossed ? std::min(least_perS, here_perS) : here_perS;
            crossed = true;
        }
        last = value;
    }
    return least_perS;
}

SafeGains safeGains(double critical_perS, double stable_perS, double pitch_mm, double initialZKp_perS) {
    SafeGains safe;
    safe.critical_perS = critical_perS;
    safe.highest_perS = std::min(kAuthorityAbove * initialZKp_perS, stable_perS);
    safe.lowest_perS = std::min(kAuthorityBelow * initialZKp_perS, safe.highest_perS);
    safe.highestTrim_mm = kTrimOfPitch * pitch_mm;
    return safe;
}

SafeGains safeGains(const DriveParams& assumed, const DriveParams& fitted, double initialZKp_perS) {
    const double critical_perS = std::min(criticalZKp_perS(assumed), criticalZKp_perS(fitted));
    return safeGains(critical_perS, critical_perS / kGainMargin, fitted.pitch_mm, initialZKp_perS);
}

}  // namespace kerf::tapping
