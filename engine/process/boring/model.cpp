// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/boring/model.h"

#include <cmath>
#include <numbers>

namespace kerf::boring {
namespace {

double twoCosPhi(double phi_deg) noexcept {
    return 2.0 * std::cos(phi_deg * std::numbers::pi / 180.0);
}

}  // namespace

double deflection_mm(double k, double alpha, double beta, double gamma, double feed_mmPerRev, double overhang_mm,
                     double depthOfCut_mm) noexcept {
    return k * std::pow(feed_mmPerRev, alpha) * std::pow(overhang_mm, beta) * std::pow(depthOfCut_mm, gamma);
}

double constantC(double k, double gamma, double depthOfCut_mm) noexcept {
    return k * std::pow(depthOfCut_mm, gamma);
}

double deflection_mm(const LawConstants& law, double feed_mmPerRev, double overhang_mm) noexcept {
    return std::exp(law.lnC + law.alpha * std::log(feed_mmPerRev) + law.beta * std::log(overhang_mm));
}

double optimalFeed_mmPerRev(const LawConstants& law, double targetDeflection_mm, double overhang_mm) noexcept {
    return std::exp((std::log(targetDeflection_mm) - law.lnC - law.beta * std::log(overhang_mm)) / law.alpha);
}

LawConstants firstEstimate(double alpha0, const Measurement& first, const Measurement& second) noexcept {
    const double lnS1 = std::log(first.feed_mmPerRev);
    const double lnL1 = std::log(first.overhang_mm);
    const double lnRatioD = std::log(first.deflection_mm / second.deflection_mm);
    const double lnRatioS = lnS1 - std::log(second.feed_mmPerRev);
    const double beta = (lnRatioD - alpha0 * lnRatioS) / (lnL1 - std::log(second.overhang_mm));
    return {std::log(first.deflection_mm) - alpha0 * lnS1 - beta * lnL1, alpha0, beta};
}

double deflectionFromDiameter_mm(double measured_mm, double target_mm, double targetDeflection_mm,
                                 double phi_deg) noexcept {
    return targetDeflection_mm + (target_mm - measured_mm) / twoCosPhi(phi_deg);
}

double diameterFromDeflection_mm(double deflection_mm, double target_mm, double targetDeflection_mm,
                                 double phi_deg) noexcept {
    return target_mm - (deflection_mm - targetDeflection_mm) * twoCosPhi(phi_deg);
}

}  // namespace kerf::boring
