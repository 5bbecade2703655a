// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "engine/process/thermal/sensor_health.h"
#include "engine/process/thermal/thermal_model.h"

/// Runs a thermal model minute by minute: baseline, sensor health, terms, prediction with its interval.
///
/// Bounded on any input: every term is clamped to its training range ± 1 span, the drift to the training drift ± 1
/// span. Outside the training range the interval widens and `outside` says by how many spans; who compensates fades to
/// hold. With one or two of its sensors lost a regression goes on with coefficients solved without them, a network with
/// the neighbours' expectation; with more the prediction is not usable.
///
/// The heat terms need to know the spindle's past. They count fully when the machine was at rest at the baseline (its
/// temperature pattern is that of a cold machine) and not at all after a warm start, where the coefficients from
/// temperatures alone take over; between 0.5 and 1.5 K of deviation both are mixed.
///
/// With a between-day law (see day_layer.h) the interval carries what a day may differ by, and a measurement of the
/// origin updates the day's coefficients.
///
/// baseline(), update() and measured() run in the cycle: no allocation, lock, throw or I/O. Construction does not.
namespace kerf::thermal {

struct ThermalPrediction {
    PerAxis drift_um{};      ///< > 0: the cutting point has moved along +axis
    PerAxis half_um{};       ///< half width of the 95 % interval
    double outside{0.0};     ///< spans beyond the training range, 0 inside
    double speedShare{0.0};  ///< 0…1: share of the coefficients with heat terms
    int lostSensors{0};      ///< of the model's own
    double changed{0.0};     ///< probability that today differs from the days trained on, by today's measurements
    bool usable{false};      ///< false: no baseline, or more than two sensors lost
    bool bounded{false};     ///< a clamp was in force
};

class ThermalEstimator {
 public:
    static constexpr int kMaxLost = 2;

    explicit ThermalEstimator(const ThermalModel& model, const HealthParams& health = {});

    /// Forget baseline, terms and health: a new reference for the drift begins. What was measured of the day stays.
    void reset() noexcept;
    /// One reading of the machine as it stands while the origin is measured. `readings` in the model's sensor order.
    void baseline(double time_min, std::span<const Reading> readings) noexcept;
    /// One step. @pre readings.size() == sensors()
    ThermalPrediction update(double time_min, std::optional<double> speed_rpm,
                             std::span<const Reading> readings) noexcept;

    /// The origin was measured in the state of the last update(): `drift_um` since the reference. Used from the next
    /// update on. Without a between-day law, or before the first update, it changes nothing.
    /// `noise_um`: σ of this one beyond that of the measurements trained on.
    void measured(const PerAxis& drift_um, const std::array<bool, kAxes>& known, double noise_um = 0.0) noexcept;
    /// The state of the last update(), to be measured later: a part that is on its way to the gauge.
    [[nodiscard]] const DayInstant& instant() const noexcept { return m_now; }
    /// As measured(), in a state that instant() gave since the reference.
    void measuredAt(const DayInstant& at, const PerAxis& drift_um, const std::array<bool, kAxes>& known,
                    double noise_um) noexcept;
    /// A measurement of this day made before a new reference; its coefficients still hold, its offset does not.
    void recall(const DayMeasurement& measurement) noexcept;
    [[nodiscard]] const DayPosterior& day() const noexcept { return m_day; }
    /// The day is over: what was measured says nothing about the next.
    void newDay() noexcept;

    [[nodiscard]] std::size_t sensors() const noexcept { return m_count; }
    [[nodiscard]] const SensorHealth& health() const noexcept { return m_health; }
    [[nodiscard]] int baselineReadings() const noexcept { return m_baselineReadings; }
    [[nodiscard]] double rise_K(std::size_t sensor) const noexcept { return m_terms[sensor].value[0]; }
    /// RMS deviation of the baseline from the pattern of a machine at rest, K; valid after the first update().
    [[nodiscard]] double restDeviation_K() const noexcept { return m_restDeviation_K; }

 private:
    static constexpr std::size_t kMaxTerms = kMaxRegressionSensors * kTermsPerSensor + kSpeedTerms;
    using Weights = std::array<PerAxis, kMaxTerms>;
    struct Solved {
        std::vector<Weights> weights{};  ///< per lost set
        std::vector<PerAxis> half_um{};
    };
    static Solved solveAll(const NormalEquations& equations);
    void finishBaseline() noexcept;
    double clampedTerm(std::size_t sensor, std::size_t term, bool& bounded) const noexcept;
    void predictRegression(std::size_t lostSet, ThermalPrediction& out) const noexcept;
    void predictNetworks(ThermalPrediction& out) const noexcept;
    [[nodiscard]] double outside() const noexcept;
    void applyDay(double time_min, ThermalPrediction& out) noexcept;

    std::size_t m_count;
    FeatureSpec m_spec;
    double m_period_min;
    std::array<Range, kAxes> m_driftRange;
    std::vector<ModelSensor> m_sensors;
    Solved m_plain{};
    std::optional<Solved> m_withSpeed{};
    std::optional<GmdhPart> m_gmdh;
    DayPosterior m_day{};
    DayInstant m_now{};
    bool m_nowKnown{false};
    std::optional<double> m_measured_min{};  ///< last measurement since the reference
    std::array<bool, kAxes> m_axes{};
    std::array<Range, kAxes> m_measuredRange{};  ///< what today's measurements add to the drift's range

    SensorHealth m_health;
    std::array<double, kMaxModelSensors> m_baselineSum_degC{};
    std::array<int, kMaxModelSensors> m_baselineCount{};
    std::array<double, kMaxModelSensors> m_baseline_degC{};
    std::array<double, kMaxModelSensors> m_now_degC{};
    std::array<double, kMaxModelSensors> m_before_degC{};
    std::array<SensorTerms, kMaxModelSensors> m_terms{};
    SpeedTerms m_heat{};
    int m_baselineReadings{0};
    bool m_started{false};
    std::optional<double> m_last_min{};
    double m_restDeviation_K{0.0};
    double m_speedShare{0.0};
    bool m_speedKnown{true};
};

}  // namespace kerf::thermal
