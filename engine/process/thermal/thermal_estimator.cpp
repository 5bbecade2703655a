// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/thermal/thermal_estimator.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace kerf::thermal {
namespace {

constexpr double kAtRest_K = 0.5;        // deviation up to which the heat terms count fully
constexpr double kWarm_K = 1.5;          // and from which they do not count
constexpr double kDayLasts_min = 720.0;  // without a measurement; then another day has begun
constexpr double kSmallestHalf_um = 0.1;
/// A lost sensor is replaced by what its neighbours expect of it, which never looks strange: its doubt is added.
constexpr double kLostDoubt = 0.2;
constexpr double kShareLossPerMin = 0.1;  // heat terms leave slowly when the speed signal is lost

}  // namespace

ThermalEstimator::Solved ThermalEstimator::solveAll(const NormalEquations& equations) {
    Solved solved;
    solved.half_um = equations.half_um;
    const auto sensors = static_cast<std::size_t>(equations.sensors);
    solved.weights.resize(lostSetCount(sensors));
    const auto store = [&](std::size_t set, const std::vector<std::size_t>& lost) {
        const Eigen::MatrixXd weights = solveWithout(equations, lost);
        for (Eigen::Index term = 0; term < weights.rows(); ++term) {
            for (std::size_t axis = 0; axis < kAxes; ++axis) {
                solved.weights[set][static_cast<std::size_t>(term)][axis] =
                    weights(term, static_cast<Eigen::Index>(axis));
            }
        }
    };
    store(lostSetIndex(sensors), {});
    for (std::size_t i = 0; i < sensors; ++i) {
        store(lostSetIndex(sensors, i), {i});
        for (std::size_t j = i + 1; j < sensors; ++j) {
            store(lostSetIndex(sensors, i, j), {i, j});
        }
    }
    return solved;
}

ThermalEstimator::ThermalEstimator(const ThermalModel& model, const HealthParams& health)
    : m_count(model.sensors.size()),
      m_spec(model.features),
      m_period_min(model.period_min),
      m_driftRange(model.drift_um),
      m_sensors(model.sensors),
      m_gmdh(model.gmdh),
      m_day(model.days ? DayPosterior(*model.days) : DayPosterior()),
      m_axes(model.axes),
      m_health(model, health) {
    assert(m_count <= kMaxModelSensors);
    if (model.regression) {
        m_plain = solveAll(model.regression->temperatures);
        if (model.regression->withSpeed) {
            m_withSpeed = solveAll(*model.regression->withSpeed);
        }
    }
}

void ThermalEstimator::reset() noexcept {
    m_health.reset();
    m_baselineSum_degC.fill(0.0);
    m_baselineCount.fill(0);
    m_terms.fill({});
    m_heat = {};
    m_baselineReadings = 0;
    m_started = false;
    m_last_min.reset();
    m_restDeviation_K = 0.0;
    m_speedShare = 0.0;
    m_speedKnown = true;
    m_nowKnown = false;
    ++m_now.reference;
    m_measuredRange = {};
    m_measured_min.reset();
}

void ThermalEstimator::newDay() noexcept {
    m_day.clear();
    m_measuredRange = {};
    m_measured_min.reset();
}

void ThermalEstimator::measured(const PerAxis& drift_um, const std::array<bool, kAxes>& known,
                                double noise_um) noexcept {
    if (m_nowKnown) {
        measuredAt(m_now, drift_um, known, noise_um);
    }
}

void ThermalEstimator::measuredAt(const DayInstant& at, const PerAxis& drift_um, const std::array<bool, kAxes>& known,
                                  double noise_um) noexcept {
    if (!m_day.present()) {
        return;
    }
    m_day.add({at, drift_um, known, noise_um});
    m_measured_min = std::max(m_measured_min.value_or(at.time_min), at.time_min);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        if (known[axis] && std::isfinite(drift_um[axis])) {
            Range& range = m_measuredRange[axis];
            range.low = std::min(range.low, drift_um[axis]);
            range.high = std::max(range.high, drift_um[axis]);
        }
    }
}

void ThermalEstimator::recall(const DayMeasurement& measurement) noexcept {
    m_now.reference = std::max(m_now.reference, measurement.at.reference + 1);
    m_day.add(measurement);
}

void ThermalEstimator::applyDay(double time_min, ThermalPrediction& out) noexcept {
    m_now.time_min = time_min;
    if (m_measured_min && time_min - *m_measured_min > kDayLasts_min) {
        newDay();
    }
    for (std::size_t k = 0; k < m_day.terms(); ++k) {
        const double scale_K = m_day.termScale_K(k);
        bool bounded = false;
        m_now.term[k] = scale_K > 0.0 ? clampedTerm(k / kTermsPerSensor, k % kTermsPerSensor, bounded) / scale_K : 0.0;
    }
    m_day.setLever(m_now);
    const Solved& reference = m_withSpeed ? *m_withSpeed : m_plain;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        // A correction is not larger than its evidence.
        const double law_um = out.drift_um[axis];
        out.drift_um[axis] *= m_day.borneOut(m_now, axis, law_um);
        m_now.mean_um[axis] = out.drift_um[axis];
        m_now.doubted_um[axis] = law_um - out.drift_um[axis];
        m_now.spread[axis] =
            out.half_um[axis] / reference.half_um[lostSetIndex(m_count)][axis] * (1.0 + kLostDoubt * out.lostSensors);
        const DayPosterior::Correction correction = m_day.at(m_now, axis);
        out.drift_um[axis] += correction.shift_um;
        out.half_um[axis] = std::max(correction.half_um, kSmallestHalf_um);
    }
    out.changed = m_day.changed();
    m_nowKnown = true;
}

void ThermalEstimator::baseline(double time_min, std::span<const Reading> readings) noexcept {
    assert(readings.size() == m_count);
    const double dt_min = m_last_min ? std::max(time_min - *m_last_min, 0.0) : m_period_min;
    m_last_min = time_min;
    for (std::size_t i = 0; i < m_count; ++i) {
        m_health.observe(i, readings[i], dt_min);
        if (!m_health.leftOut(i)) {
            m_baselineSum_degC[i] += readings[i].value;
            ++m_baselineCount[i];
            m_now_degC[i] = readings[i].value;
        }
    }
    ++m_baselineReadings;
}

void ThermalEstimator::finishBaseline() noexcept {
    double mean = 0.0;
    double patternMean = 0.0;
    int healthy = 0;
    for (std::size_t i = 0; i < m_count; ++i) {
        m_baseline_degC[i] = m_baselineCount[i] > 0 ? m_baselineSum_degC[i] / m_baselineCount[i] : 0.0;
        if (!m_health.leftOut(i) && m_baselineCount[i] > 0) {
            mean += m_baseline_degC[i];
            patternMean += m_sensors[i].restPattern_K;
            ++healthy;
        }
    }
    double sum = 0.0;
    for (std::size_t i = 0; i < m_count && healthy > 0; ++i) {
        if (!m_health.leftOut(i) && m_baselineCount[i] > 0) {
            const double deviation_K =
                (m_baseline_degC[i] - mean / healthy) - (m_sensors[i].restPattern_K - patternMean / healthy);
            sum += deviation_K * deviation_K;
        }
    }
    m_restDeviation_K = healthy > 0 ? std::sqrt(sum / healthy) : 0.0;
    m_speedShare =
        m_withSpeed && healthy > 0 ? std::clamp((kWarm_K - m_restDeviation_K) / (kWarm_K - kAtRest_K), 0.0, 1.0) : 0.0;
    m_started = true;
}

double ThermalEstimator::clampedTerm(std::size_t sensor, std::size_t term, bool& bounded) const noexcept {
    const Range& range = m_sensors[sensor].range[term];
    const double value = m_terms[sensor].value[term];
    const double inside = std::clamp(value, range.low - range.span(), range.high + range.span());
    bounded = bounded || inside != value;
    return inside;
}

double ThermalEstimator::outside() const noexcept {
    double worst = 0.0;
    for (std::size_t i = 0; i < m_count; ++i) {
        if (!m_health.leftOut(i)) {
            // The leaky mean: one noisy reading is not a new regime.
            worst = std::max(worst, outsideSpans(m_sensors[i].range[1], m_terms[i].value[1]));
        }
    }
    return worst;
}

void ThermalEstimator::predictRegression(std::size_t lostSet, ThermalPrediction& out) const noexcept {
    std::array<double, kMaxTerms> x{};
    for (std::size_t i = 0; i < m_count; ++i) {
        for (std::size_t term = 0; term < kTermsPerSensor; ++term) {
            x[i * kTermsPerSensor + term] = clampedTerm(i, term, out.bounded);
        }
    }
    const std::size_t temperatureTerms = m_count * kTermsPerSensor;
    for (std::size_t k = 0; k < kSpeedTerms; ++k) {
        x[temperatureTerms + k] = m_heat.value[k];
    }
    const auto add = [&](const Solved& solved, std::size_t terms, double share) {
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
            double sum = 0.0;
            for (std::size_t term = 0; term < terms; ++term) {
                sum += solved.weights[lostSet][term][axis] * x[term];
            }
            out.drift_um[axis] += share * sum;
            out.half_um[axis] += share * solved.half_um[lostSet][axis];
        }
    };
    out.speedShare = m_withSpeed ? m_speedShare : 0.0;
    if (out.speedShare > 0.0) {
        add(*m_withSpeed, temperatureTerms + kSpeedTerms, out.speedShare);
    }
    if (out.speedShare < 1.0) {
        add(m_plain, temperatureTerms, 1.0 - out.speedShare);
    }
}

void ThermalEstimator::predictNetworks(ThermalPrediction& out) const noexcept {
    std::array<double, 2 * kMaxGmdhWidth> x{};
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const auto& inputs = m_gmdh->inputs[axis];
        for (std::size_t k = 0; k < inputs.size(); ++k) {
            const auto sensor = static_cast<std::size_t>(inputs[k].sensor);
            switch (inputs[k].kind) {
                case InputKind::Term:
                    x[k] = clampedTerm(sensor, static_cast<std::size_t>(inputs[k].term), out.bounded);
                    break;
                case InputKind::Now:
                    x[k] = m_now_degC[sensor];
                    break;
                case InputKind::Before:
                    x[k] = m_before_degC[sensor];
                    break;
            }
        }
        out.drift_um[axis] = m_gmdh->network[axis].predict(std::span<const double>(x.data(), inputs.size()));
        out.half_um[axis] = m_gmdh->half_um[axis];
    }
    if (out.lostSensors > 0) {
        for (double& half : out.half_um) {
            half *= 1.0 + 0.5 * out.lostSensors;
        }
    }
}

ThermalPrediction ThermalEstimator::update(double time_min, std::optional<double> speed_rpm,
                                           std::span<const Reading> readings) noexcept {
    assert(readings.size() == m_count);
    ThermalPrediction out;
    m_nowKnown = false;
    if (m_baselineReadings == 0) {
        return out;
    }
    if (!m_started) {
        finishBaseline();
    }
    const double dt_min = m_last_min ? std::max(time_min - *m_last_min, 0.0) : m_period_min;
    m_last_min = time_min;
    std::array<double, kMaxModelSensors> rise_K{};
    for (std::size_t i = 0; i < m_count; ++i) {
        m_health.observe(i, readings[i], dt_min);
        if (m_baselineCount[i] == 0) {
            m_health.observe(i, Reading{}, dt_min);  // never seen at the baseline: its rise is unknown
        }
        rise_K[i] = m_health.leftOut(i) && isSick(m_health.state(i)) ? 0.0 : readings[i].value - m_baseline_degC[i];
    }
    m_health.compare(std::span<const double>(rise_K.data(), m_count));

    int leftOutCount = 0;
    for (std::size_t i = 0; i < m_count; ++i) {
        leftOutCount += m_health.leftOut(i) ? 1 : 0;
    }
    std::array<std::size_t, kMaxLost> lost{};
    for (std::size_t i = 0; i < m_count; ++i) {
        const bool leftOut = m_health.leftOut(i);
        if (leftOut) {
            if (out.lostSensors < kMaxLost) {
                lost[static_cast<std::size_t>(out.lostSensors)] = i;
            }
            ++out.lostSensors;
            // With too many lost there is nobody to ask: the last rise stands until they are back, so that the means
            // of the past do not run to zero meanwhile.
            rise_K[i] = leftOutCount > kMaxLost ? m_terms[i].value[0] : m_health.expectedRise_K(i);
        }
        m_terms[i].update(rise_K[i], dt_min, m_spec);
        m_before_degC[i] = m_now_degC[i];
        m_now_degC[i] = m_baseline_degC[i] + rise_K[i];
    }
    if (speed_rpm) {
        m_heat.update(*speed_rpm, dt_min, m_spec);
    } else {
        m_speedKnown = false;
    }
    if (!m_speedKnown) {
        m_speedShare = std::max(0.0, m_speedShare - kShareLossPerMin * dt_min);
    }
    out.usable = out.lostSensors <= kMaxLost;
    if (!out.usable) {
        return out;
    }
    if (m_gmdh) {
        predictNetworks(out);
    } else {
        const std::size_t set = out.lostSensors == 0   ? lostSetIndex(m_count)
                                : out.lostSensors == 1 ? lostSetIndex(m_count, lost[0])
                                                       : lostSetIndex(m_count, lost[0], lost[1]);
        predictRegression(set, out);
        if (m_day.present()) {
            applyDay(time_min, out);
        }
    }
    out.outside = outside();
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const Range& range = m_driftRange[axis];
        const double low = std::min(range.low, m_measuredRange[axis].low) - range.span();
        const double high = std::max(range.high, m_measuredRange[axis].high) + range.span();
        // A network as printed has no bound of its own; what is not a number counts as out of bounds.
        const double inside = std::isfinite(out.drift_um[axis]) ? std::clamp(out.drift_um[axis], low, high) : 0.0;
        out.bounded = out.bounded || inside != out.drift_um[axis];
        out.drift_um[axis] = inside;
        out.half_um[axis] *= intervalWidening(out.outside);
    }
    return out;
}

}  // namespace kerf::thermal
