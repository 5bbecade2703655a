// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/thermal/thermal_model.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>

namespace kerf::thermal {
namespace {

/// With that many significant digits.
std::string printed(double value, int digits) {
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), "%.*g", digits, value);
    return text.data();
}

/// " + 1.234" or " - 1.234", three significant digits.
std::string signedFactor(double value) {
    return std::string(value < 0.0 ? " - " : " + ") + printed(std::abs(value), 3);
}

std::string termName(const ThermalModel& model, int sensor, int term) {
    const std::string& name = model.sensors[static_cast<std::size_t>(sensor)].name;
    if (term == 0) {
        return name;
    }
    return name + "~" + printed(model.features.leak_min[static_cast<std::size_t>(term - 1)], 6);
}

std::string regressionLine(const ThermalModel& model, const NormalEquations& equations, const Eigen::MatrixXd& weights,
                           int axis) {
    std::string line;
    for (int s = 0; s < equations.sensors; ++s) {
        for (int term = 0; term < kTermsPerSensor; ++term) {
            line += signedFactor(weights(s * kTermsPerSensor + term, axis)) + "·" + termName(model, s, term);
        }
    }
    for (Eigen::Index k = equations.sensors * kTermsPerSensor; k < weights.rows(); ++k) {
        const auto leak = static_cast<std::size_t>(k - equations.sensors * kTermsPerSensor);
        line += signedFactor(weights(k, axis)) + "·heat~" + printed(model.features.speedLeak_min[leak], 6);
    }
    return line;
}

std::string inputName(const ThermalModel& model, const GmdhInput& input) {
    const std::string& name = model.sensors[static_cast<std::size_t>(input.sensor)].name;
    switch (input.kind) {
        case InputKind::Now:
            return "abs " + name;
        case InputKind::Before:
            return "abs " + name + " before";
        case InputKind::Term:
            break;
    }
    return termName(model, input.sensor, input.term);
}

void appendNetwork(const ThermalModel& model, int axis, std::vector<std::string>& lines) {
    const GmdhPart& part = *model.gmdh;
    const GmdhModel& network = part.network[static_cast<std::size_t>(axis)];
    const auto& inputs = part.inputs[static_cast<std::size_t>(axis)];
    const std::string axisName(1, "xyz"[axis]);
    for (std::size_t layer = 0; layer < network.layers.size(); ++layer) {
        for (std::size_t n = 0; n < network.layers[layer].size(); ++n) {
            const GmdhNeuron& neuron = network.layers[layer][n];
            const auto input = [&](int index) {
                if (layer == 0) {
                    return std::string("[") + inputName(model, inputs[static_cast<std::size_t>(index)]) + "]";
                }
                return axisName + std::to_string(layer) + "." + std::to_string(index);
            };
            const std::string a = input(neuron.i);
            const std::string b = input(neuron.j);
            std::string line = axisName + std::to_string(layer + 1) + "." + std::to_string(n) + " =";
            line += signedFactor(neuron.coef[0]) + signedFactor(neuron.coef[1]) + "·" + a +
                    signedFactor(neuron.coef[2]) + "·" + b;
            if (neuron.coef[3] != 0.0 || neuron.coef[4] != 0.0) {
                line += signedFactor(neuron.coef[3]) + "·" + a + "²" + signedFactor(neuron.coef[4]) + "·" + b + "²";
            }
            line += signedFactor(neuron.coef[5]) + "·" + a + "·" + b;
            lines.push_back(std::move(line));
        }
    }
    lines.push_back(axisName + "_um = " + printed(network.outputMean, 4) + " + " + printed(network.outputScale, 4) +
                    "·" + axisName + std::to_string(network.layers.size()) +
                    ".0   ([..]: minus its mean, over its deviation)");
}

}  // namespace

double outsideSpans(const Range& trained_K, double leaky_K) noexcept {
    constexpr double kFreeMargin = 0.1;
    constexpr double kSmallestSpan_K = 0.5;
    const double span_K = std::max(trained_K.span(), kSmallestSpan_K);
    return std::max(
        {0.0, (leaky_K - trained_K.high) / span_K - kFreeMargin, (trained_K.low - leaky_K) / span_K - kFreeMargin});
}

std::size_t lostSetIndex(std::size_t /*sensors*/) noexcept {
    return 0;
}
std::size_t lostSetIndex(std::size_t /*sensors*/, std::size_t i) noexcept {
    return 1 + i;
}
std::size_t lostSetIndex(std::size_t sensors, std::size_t i, std::size_t j) noexcept {
    assert(i < j && j < sensors);
    return 1 + sensors + i * (2 * sensors - i - 1) / 2 + (j - i - 1);
}

Eigen::MatrixXd solveWithout(const NormalEquations& equations, const std::vector<std::size_t>& lost) {
    std::vector<Eigen::Index> kept;
    const Eigen::Index sensorTerms = Eigen::Index{equations.sensors} * kTermsPerSensor;
    for (Eigen::Index term = 0; term < equations.gram.rows(); ++term) {
        const auto sensor = static_cast<std::size_t>(term / kTermsPerSensor);
        if (term >= sensorTerms || std::ranges::find(lost, sensor) == lost.end()) {
            kept.push_back(term);
        }
    }
    const Eigen::MatrixXd gram = equations.gram(kept, kept);
    const Eigen::VectorXd meanSquare = gram.diagonal() / equations.rows;
    Eigen::MatrixXd out = Eigen::MatrixXd::Zero(equations.gram.rows(), static_cast<Eigen::Index>(kAxes));
    for (Eigen::Index axis = 0; axis < static_cast<Eigen::Index>(kAxes); ++axis) {
        Eigen::MatrixXd damped = gram;
        for (std::size_t k = 0; k < kept.size(); ++k) {
            const auto at = static_cast<Eigen::Index>(k);
            const double ridge = kept[k] < sensorTerms ? equations.ridge[static_cast<std::size_t>(axis)] : kSpeedRidge;
            damped(at, at) += ridge * equations.rows * meanSquare[at] + 1e-12;
        }
        const Eigen::VectorXd moment = equations.moment(kept, axis);
        const Eigen::VectorXd weights = damped.llt().solve(moment);
        for (std::size_t k = 0; k < kept.size(); ++k) {
            out(kept[k], axis) = weights[static_cast<Eigen::Index>(k)];
        }
    }
    return out;
}

const char* modelKindKey(ModelKind kind) noexcept {
    switch (kind) {
        case ModelKind::GmdhPaper:
            return "gmdh-paper";
        case ModelKind::Gmdh:
            return "gmdh";
        case ModelKind::Hierarchical:
            return "hierarchical";
        case ModelKind::Regression:
            break;
    }
    return "regression";
}

std::vector<std::string> formulaLines(const ThermalModel& model) {
    std::vector<std::string> lines;
    if (model.regression) {
        const RegressionPart& part = *model.regression;
        const Eigen::MatrixXd plain = solveWithout(part.temperatures, {});
        std::optional<Eigen::MatrixXd> assisted;
        if (part.withSpeed) {
            assisted = solveWithout(*part.withSpeed, {});
        }
        for (int axis = 0; axis < static_cast<int>(kAxes); ++axis) {
            const std::string name = std::string(1, "xyz"[axis]) + "_um";
            if (assisted) {
                lines.push_back(name + " =" + regressionLine(model, *part.withSpeed, *assisted, axis) +
                                "   (start at rest)");
            }
            lines.push_back(name + " =" + regressionLine(model, part.temperatures, plain, axis) +
                            (assisted ? "   (start warm, or speed unknown)" : ""));
        }
    }
    if (model.gmdh) {
        for (int axis = 0; axis < static_cast<int>(kAxes); ++axis) {
            appendNetwork(model, axis, lines);
        }
    }
    return lines;
}

}  // namespace kerf::thermal
