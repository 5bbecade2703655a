// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/thermal/training_common.h"

#include <algorithm>
#include <cmath>

namespace kerf::thermal {

PerAxis measurementVariance_um2(const std::vector<ThermalHistory>& days) {
    PerAxis variance{};
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        std::vector<double> second;
        for (const ThermalHistory& day : days) {
            const Eigen::VectorXd y = detail::measuredDrift(day).col(static_cast<Eigen::Index>(axis));
            for (Eigen::Index row = 2; row < y.size(); ++row) {
                second.push_back(std::abs(y[row] - 2.0 * y[row - 1] + y[row - 2]));
            }
        }
        const auto middle = second.begin() + static_cast<std::ptrdiff_t>(second.size() / 2);
        std::ranges::nth_element(second, middle);
        const double sigma = *middle / 0.6745;  // median of |normal|
        variance[axis] = sigma * sigma / 6.0;
    }
    return variance;
}

namespace detail {

std::optional<Sentence> whyNotTogether(const std::vector<ThermalHistory>& days) {
    if (days.empty()) {
        return Sentence(KERF_TEXT("No training day was given."));
    }
    for (const ThermalHistory& day : days) {
        if (day.sensors != days.front().sensors) {
            return Sentence(KERF_TEXT("%1 has other temperature columns than %2; train with days of one machine."),
                            SentenceArg(day.label), SentenceArg(days.front().label));
        }
        if (day.axes != days.front().axes) {
            return Sentence(KERF_TEXT("%1 has the drift of other axes than %2; train with days of the same axes."),
                            SentenceArg(day.label), SentenceArg(days.front().label));
        }
        if (const auto fault = whyNotTrainable(day)) {
            return fault->reason;
        }
    }
    return std::nullopt;
}

Eigen::MatrixXd measuredDrift(const ThermalHistory& day) {
    return day.drift_um.bottomRows(day.workRows());
}

RestPattern restPatternOf(const std::vector<ThermalHistory>& days) {
    constexpr double kSameState_K = 0.5;
    std::vector<Eigen::VectorXd> patterns;
    std::size_t calmest = 0;
    for (const ThermalHistory& day : days) {
        Eigen::VectorXd pattern = baselineOf(day);
        pattern.array() -= pattern.mean();
        patterns.push_back(std::move(pattern));
        if (patterns.back().squaredNorm() < patterns[calmest].squaredNorm()) {
            calmest = patterns.size() - 1;
        }
    }
    RestPattern rest;
    rest.pattern_K = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(days.front().sensors.size()));
    double count = 0.0;
    for (const Eigen::VectorXd& pattern : patterns) {
        const double rms_K = (pattern - patterns[calmest]).norm() / std::sqrt(static_cast<double>(pattern.size()));
        rest.atRest.push_back(rms_K < kSameState_K);
        if (rest.atRest.back()) {
            rest.pattern_K += pattern;
            count += 1.0;
        }
    }
    rest.pattern_K /= count;
    return rest;
}

ThermalModel modelFrame(ModelKind kind, const std::vector<ThermalHistory>& days,
                        const std::vector<Eigen::Index>& sensors, const FeatureSpec& spec) {
    ThermalModel model;
    model.kind = kind;
    model.features = spec;
    model.fingerprint = fingerprintOf(days);
    model.axes = days.front().axes;
    const auto count = static_cast<Eigen::Index>(sensors.size());
    model.riseMoment_K2 = Eigen::MatrixXd::Zero(count, count);
    model.sensors.resize(sensors.size());
    const RestPattern rest = restPatternOf(days);
    double restMean_K = 0.0;
    for (std::size_t k = 0; k < sensors.size(); ++k) {
        model.sensors[k].name = days.front().sensors[static_cast<std::size_t>(sensors[k])];
        model.sensors[k].restPattern_K = rest.pattern_K[sensors[k]];
        restMean_K += rest.pattern_K[sensors[k]] / static_cast<double>(count);
    }
    for (ModelSensor& sensor : model.sensors) {
        sensor.restPattern_K -= restMean_K;
    }
    std::vector<double> noise(sensors.size(), 0.0);
    double rows = 0.0;
    bool first = true;
    for (const ThermalHistory& day : days) {
        const Eigen::MatrixXd terms = featureMatrix(day, spec);
        const Eigen::MatrixXd drift = measuredDrift(day);
        Eigen::MatrixXd rises(terms.rows(), count);
        for (std::size_t k = 0; k < sensors.size(); ++k) {
            ModelSensor& sensor = model.sensors[k];
            for (int term = 0; term < kTermsPerSensor; ++term) {
                const auto column = terms.col(sensors[k] * kTermsPerSensor + term);
                Range& range = sensor.range[static_cast<std::size_t>(term)];
                range.low = std::min(range.low, column.minCoeff());
                range.high = std::max(range.high, column.maxCoeff());
            }
            rises.col(static_cast<Eigen::Index>(k)) = terms.col(sensors[k] * kTermsPerSensor);
            const auto raw = day.temp_degC.col(sensors[k]);
            int repeat = 0;
            for (Eigen::Index row = 1; row < raw.size(); ++row) {
                repeat = raw[row] == raw[row - 1] ? repeat + 1 : 0;
                sensor.longestRepeat = std::max(sensor.longestRepeat, repeat);
                if (row > 1) {
                    const double second = raw[row] - 2.0 * raw[row - 1] + raw[row - 2];
                    noise[k] += second * second / 6.0;
                }
            }
        }
        model.riseMoment_K2 += rises.transpose() * rises;
        rows += static_cast<double>(terms.rows());
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
            const auto column = drift.col(static_cast<Eigen::Index>(axis));
            Range& range = model.drift_um[axis];
            range.low = std::min(range.low, column.minCoeff());
            range.high = std::max(range.high, column.maxCoeff());
        }
        model.trainedOn.push_back(day.label);
        if (first) {
            const auto last = day.time_min.size() - 1;
            model.period_min = day.time_min[last] - day.time_min[last - 1];
            first = false;
        }
    }
    model.riseMoment_K2 /= rows;
    model.trainingRows = static_cast<int>(rows);
    for (std::size_t k = 0; k < sensors.size(); ++k) {
        model.sensors[k].noise_K = std::sqrt(noise[k] / rows);
    }
    return model;
}

PerAxis noiseFreeRms(const std::vector<Eigen::MatrixXd>& errors) {
    constexpr Eigen::Index kLags = 5;
    PerAxis rms{};
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        double sum = 0.0;
        double count = 0.0;
        for (const Eigen::MatrixXd& series : errors) {
            const auto e = series.col(static_cast<Eigen::Index>(axis));
            for (Eigen::Index lag = 1; lag <= std::min(kLags, e.size() - 1); ++lag) {
                sum += e.head(e.size() - lag).dot(e.tail(e.size() - lag));
                count += static_cast<double>(e.size() - lag);
            }
        }
        rms[axis] = std::sqrt(std::max(sum / std::max(count, 1.0), kSmallestRms_um * kSmallestRms_um));
    }
    return rms;
}

PerAxis worstOf(const std::vector<Eigen::MatrixXd>& errors) {
    PerAxis worst{};
    for (const Eigen::MatrixXd& series : errors) {
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
            worst[axis] = std::max(worst[axis], series.col(static_cast<Eigen::Index>(axis)).cwiseAbs().maxCoeff());
        }
    }
    return worst;
}

}  // namespace detail
}  // namespace kerf::thermal
