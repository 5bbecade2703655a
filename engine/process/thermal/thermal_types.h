// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "engine/core/reading.h"
#include "engine/port/machine_port.h"

/// What the thermal page sets and sees. Drift > 0: the cutting point has moved along +axis; the shift is against it.
namespace kerf {

/// How the loop compensates. Sent whole; holds from the next prediction on.
struct ThermalSetup {
    std::uint32_t revision{0};       ///< 0: the defaults below
    double period_min{1.0};          ///< between two predictions, [.1, 60]
    double allowed_um{4.0};          ///< what the part allows: half width of the interval, and "ready for ±"; (0, 100]
    double maxShift_um{100.0};       ///< |shift| per axis, [1, 200]
    double maxStep_umPerMin{15.0};   ///< [1, 60]
    double warmUpSpeed_rpm{3000.0};  ///< [100, 30000]
    double warmUp_min{20.0};         ///< [1, 120]
    bool betweenParts{false};        ///< the shift moves only while no part is being cut
};

enum class ThermalStage : std::uint8_t {
    NoTemperatures,  ///< the machine reports none
    NoModel,
    Baseline,   ///< the temperatures everything is counted from are being taken
    CatchUp,    ///< a new model runs through what has happened since the baseline
    Following,  ///< predicting
    Holding,    ///< no prediction that can be used: the last shift stays
};

/// State of one thermocouple as the loop sees it. The order is that of thermal::SensorState, Unread added.
enum class CoupleState : std::uint8_t { Healthy, Suspect, Open, Short, Stuck, Noisy, Offset, Disagrees, Unread };
[[nodiscard]] constexpr bool isSick(CoupleState state) noexcept {
    return state > CoupleState::Suspect && state < CoupleState::Unread;
}

enum class WarmUpState : std::uint8_t {
    Unknown,  ///< too early, or the drift does not settle yet
    Ready,    ///< within what the part allows
    Waiting,  ///< ready in `ready_min`
    TooWide,  ///< the interval alone is wider than the part allows: measure
};

/// Spot measurement of the origin with the test bar.
enum class GapPhase : std::uint8_t { None, Measuring, Done, Failed };
struct GapMeasurement {
    std::uint32_t number{0};  ///< rises with every one begun
    GapPhase phase{GapPhase::None};
    Sentence reason{};  ///< of Failed
    std::int64_t time_ns{0};
    std::array<double, kAxisCount> measured_um{};  ///< drift
    std::array<double, kAxisCount> predicted_um{};
    std::array<double, kAxisCount> half_um{};
    bool predictionKnown{false};
    bool byPart{false};                                      ///< from a finished part, not from the gap sensors
    std::array<bool, kAxisCount> known{{true, true, true}};  ///< axes measured
};

/// Live figures of the thermal loop, part of Status.
struct ThermalStatus {
    ThermalStage stage{ThermalStage::NoTemperatures};
    std::uint32_t model{0};    ///< revision of the model in force; 0: none
    std::uint32_t updates{0};  ///< predictions since the baseline
    std::uint32_t setup{0};
    std::array<double, kAxisCount> drift_um{};     ///< predicted, from the reference
    std::array<double, kAxisCount> half_um{};      ///< 95 %
    std::array<double, kAxisCount> target_um{};    ///< shift wanted (control: commanded)
    std::array<Reading, kAxisCount> shifted_um{};  ///< as the control reports it
    std::array<bool, kAxisCount> sizeLimited{};
    std::array<bool, kAxisCount> rateLimited{};
    double outside{0.0};     ///< spans beyond the training range
    double speedShare{0.0};  ///< 0: warm start or speed unknown, temperatures alone
    int lostSensors{0};      ///< of the model's own
    bool measureNow{false};
    bool learns{false};         ///< the model in force learns from a measurement of the origin
    bool differs{false};        ///< today differs from the days trained on, by today's measurements
    bool waitsForPart{false};   ///< a part is being cut and the shift moves only between parts
    bool partToMeasure{false};  ///< a part is finished that may be measured: the origin as it was then
    double allowed_um{0.0};
    double nextUpdate_s{0.0};
    double minutes{0.0};  ///< machine time since the baseline
    WarmUpState warmUp{WarmUpState::Unknown};
    double ready_min{0.0};  ///< valid when Waiting
    bool warmUpRunning{false};
    double warmUpLeft_min{0.0};
    bool recording{false};  ///< a gap-sensor session is being recorded
    bool gapsReadable{false};
    bool gapZeroKnown{false};
    std::array<double, kAxisCount> gapZero_um{};
    GapMeasurement gap{};
    std::uint16_t count{0};
    std::uint64_t inModel{0};  ///< bit k: channel k is one of the model's sensors
    std::array<float, kMaxTemperatures> temp_degC{};
    std::array<CoupleState, kMaxTemperatures> couple{};
};
static_assert(std::is_trivially_copyable_v<ThermalStatus>);

/// One minute as the loop lived it, for charts, training and the records.
struct ThermalMinute {
    std::int64_t time_ns{0};
    double minutes{0.0};         ///< since the baseline; < 0: one of its readings
    std::uint32_t reference{0};  ///< which baseline, rising
    float speed_rpm{0.0F};       ///< heat-equivalent mean over the period
    bool speedKnown{false};
    bool predicted{false};
    bool measured{false};
    std::array<float, kAxisCount> drift_um{};
    std::array<float, kAxisCount> half_um{};
    std::array<float, kAxisCount> shift_um{};                      ///< reported by the control
    std::array<float, kAxisCount> measured_um{};                   ///< gap sensors, drift
    bool spot{false};                                              ///< measured once, to learn from
    std::array<float, kAxisCount> learnt_um{};                     ///< of a spot: measured drift since the reference
    std::array<bool, kAxisCount> learntKnown{{true, true, true}};  ///< of a spot: axes measured
    float learntNoise_um{0.0F};                                    ///< of a spot: σ beyond the gap sensors'
    std::uint64_t present{0};
    std::array<float, kMaxTemperatures> temp_degC{};
};
static_assert(std::is_trivially_copyable_v<ThermalMinute>);

}  // namespace kerf
