// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/milling/plant.h"

#include <cmath>
#include <numbers>

namespace kerf::milling {
namespace {

double radians(double angle_deg) {
    return angle_deg * std::numbers::pi / 180.0;
}

bool within(double value, double low, double high) {
    return std::isfinite(value) && value >= low && value <= high;
}

}  // namespace

std::optional<Sentence> PlantParams::whyInvalid() const {
    struct Row {
        const char* name;
        double value, low, high;
    };
    const Row rows[] = {
        {"m", exponent, 0.3, 1.0},
        {"theta_deg", forceAngle_deg, 5.0, 85.0},
        {"kx_n_per_mm", kx_NPerMm, 10.0, 1e6},
        {"ky_n_per_mm", ky_NPerMm, 10.0, 1e6},
        {"c_n_per_mm", cuttingCoefficient, 1.0, 1e6},
        {"tool_radius_mm", toolRadius_mm, 0.1, 100.0},
    };
    for (const Row& row : rows) {
        if (!within(row.value, row.low, row.high)) {
            return Sentence(KERF_TEXT("%1 must be from %2 to %3."), SentenceArg(row.name), SentenceArg(row.low, 1),
                            SentenceArg(row.high, 1));
        }
    }
    return std::nullopt;
}

double solveCutFeed_mmPerRev(double compliance, double supply_mm, double exponent, double tolerance) noexcept {
    if (supply_mm <= 0.0) {
        return 0.0;
    }
    if (compliance <= 0.0) {
        return supply_mm;
    }
    // In y = l^m the equation y^(1/m) + c y = s is convex, so Newton from a point right of the root falls onto it
    // without ever leaving (0, start].
    const double inverse = 1.0 / exponent;
    constexpr int kMost = 64;
    double y = std::fmin(std::pow(supply_mm, exponent), supply_mm / compliance);
    double before = 0.0;
    for (int i = 0; i < kMost; ++i) {
        const double l = std::pow(y, inverse);
        const double excess = l + compliance * y - supply_mm;
        const double step = excess / (inverse * l / y + compliance);
        const double next = y - step;
        if (next == y) {
            return l;
        }
        const bool swings = next == before;
        before = y;
        y = next;
        if (std::abs(step) <= tolerance * y) {
            break;
        }
        if (swings) {  // between two neighbours for all steps to come: which of them is last is known
            return (kMost - 1 - i) % 2 != 0 ? l : std::pow(y, inverse);
        }
    }
    return std::pow(y, inverse);
}

RevolutionState stepRevolution(const PlantParams& plant, double depth_mm, double deflectionX_mm,
                               double feed_mmPerRev) noexcept {
    const double theta = radians(plant.forceAngle_deg);
    const double stiffness = plant.cuttingCoefficient * std::fmax(depth_mm, 0.0);
    RevolutionState next;
    next.cutFeed_mmPerRev = solveCutFeed_mmPerRev(stiffness * std::cos(theta) / plant.kx_NPerMm,
                                                  feed_mmPerRev + deflectionX_mm, plant.exponent);
    next.forceC_N = stiffness * std::pow(next.cutFeed_mmPerRev, plant.exponent);
    next.forceY_N = next.forceC_N * std::sin(theta);
    next.deflectionX_mm = next.forceC_N * std::cos(theta) / plant.kx_NPerMm;
    next.deflectionY_mm = next.forceY_N / plant.ky_NPerMm;
    return next;
}

LinearForm linearForm(const PlantParams& plant, double depth_mm, double cutFeed_mmPerRev,
                      double feedPerUnit_mmPerRev) noexcept {
    const double theta = radians(plant.forceAngle_deg);
    const double cot = std::cos(theta) / std::sin(theta);
    LinearForm form;
    form.ra_NPerMm = plant.cuttingCoefficient * depth_mm * std::pow(cutFeed_mmPerRev, plant.exponent - 1.0);
    form.mu = plant.ky_NPerMm / (form.ra_NPerMm * std::sin(theta));
    const auto pole = [&](double mu) { return plant.ky_NPerMm * cot / (plant.ky_NPerMm * cot + plant.kx_NPerMm * mu); };
    const auto gain = [&](double mu) {
        return feedPerUnit_mmPerRev * plant.kx_NPerMm * plant.ky_NPerMm /
               (plant.ky_NPerMm * cot + plant.kx_NPerMm * mu);
    };
    form.a1 = pole(form.mu);
    form.b0_NPerUnit = gain(form.mu);
    form.dcGain_NPerUnit = form.b0_NPerUnit / (1.0 - form.a1);
    const double tangentMu = form.mu / plant.exponent;
    form.a1Tangent = pole(tangentMu);
    form.b0Tangent_NPerUnit = gain(tangentMu);
    return form;
}

double continuousAxialDepth_mm(double toolRadius_mm, double depth_mm, double helix_deg) noexcept {
    return 2.0 * toolRadius_mm * std::asin(std::sqrt(depth_mm / (2.0 * toolRadius_mm))) / std::tan(radians(helix_deg));
}

}  // namespace kerf::milling
