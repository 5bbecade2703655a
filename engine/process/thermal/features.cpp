// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/thermal/features.h"

namespace kerf::thermal {

Eigen::VectorXd baselineOf(const ThermalHistory& history) {
    return history.temp_degC.topRows(history.baselineRows()).colwise().mean().transpose();
}

Eigen::MatrixXd featureMatrix(const ThermalHistory& history, const FeatureSpec& spec) {
    const Eigen::Index first = history.baselineRows();
    const Eigen::Index sensors = history.temp_degC.cols();
    const Eigen::VectorXd baseline = baselineOf(history);
    Eigen::MatrixXd out = Eigen::MatrixXd::Zero(history.workRows(), sensors * kTermsPerSensor + kSpeedTerms);
    const auto dtOf = [&history](Eigen::Index row) {
        const auto k = static_cast<std::size_t>(row);
        return history.time_min[k] - history.time_min[k - 1];
    };
    std::vector<std::array<double, 2>> shares;
    for (Eigen::Index row = first; row < history.rows(); ++row) {
        shares.push_back({leakShare(dtOf(row), spec.leak_min[0]), leakShare(dtOf(row), spec.leak_min[1])});
    }
    for (Eigen::Index s = 0; s < sensors; ++s) {
        SensorTerms terms;
        for (Eigen::Index row = first; row < history.rows(); ++row) {
            terms.update(history.temp_degC(row, s) - baseline[s], shares[static_cast<std::size_t>(row - first)]);
            for (int k = 0; k < kTermsPerSensor; ++k) {
                out(row - first, s * kTermsPerSensor + k) = terms.value[static_cast<std::size_t>(k)];
            }
        }
    }
    if (!history.speed_rpm.empty()) {
        SpeedTerms terms;
        for (Eigen::Index row = first; row < history.rows(); ++row) {
            terms.update(history.speed_rpm[static_cast<std::size_t>(row)], dtOf(row), spec);
            for (int k = 0; k < kSpeedTerms; ++k) {
                out(row - first, sensors * kTermsPerSensor + k) = terms.value[static_cast<std::size_t>(k)];
            }
        }
    }
    return out;
}

Eigen::MatrixXd printedInputs(const ThermalHistory& history) {
    const Eigen::Index first = history.baselineRows();
    const Eigen::Index work = history.workRows();
    Eigen::MatrixXd out(work, 2 * history.temp_degC.cols());
    out << history.temp_degC.bottomRows(work), history.temp_degC.middleRows(first - 1, work);
    return out;
}

}  // namespace kerf::thermal
