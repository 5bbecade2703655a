// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "engine/api/status.h"
#include "engine/cycle/process_loop.h"
#include "engine/cycle/program_follower.h"
#include "engine/process/thermal/couple_watch.h"
#include "engine/process/thermal/gap_gauge.h"
#include "engine/process/thermal/part_watch.h"
#include "engine/process/thermal/thermal_exchange.h"
#include "engine/process/thermal/thermal_log.h"

namespace kerf {

/// Predicts the drift of the machine origin once a period and shifts the work origin against it in whole µm.
///
///   drift = carried + prediction since the baseline        µm, per axis
///   shift = round(−drift) − what the control reports       limited in size and step (nextShift)
///
/// The baseline is taken when the loop first sees temperatures, in a fifth of a period each. `carried` is then minus
/// the shift the control reports: after a restart in mid-shift the first shift is no jump. Outside the training range
/// the shift fades to hold; with no usable prediction it holds. In the modes Off and Advise everything is computed and
/// nothing acts.
///
/// A measurement of the origin is learnt from by a model that can: its day's coefficients move, at the next minute. Its
/// between-day law is kept over a new reference in the same day and restored after a restart by the service.
///
/// A part that has been finished and is then measured is a measurement of the origin made when it was finished. With
/// `betweenParts` the shift moves only while no part is being cut.
///
/// A new model first runs through the minutes since the baseline, one per cycle, beside the old one; then it takes its
/// place between two cycles. Neither is made or destroyed here.
class ThermalLoop final : public ProcessLoop {
 public:
    /// `exchange` outlives the loop.
    explicit ThermalLoop(ThermalExchange& exchange) : m_exchange(exchange) {}
    ~ThermalLoop() override;

    [[nodiscard]] ProcessId id() const noexcept override { return ProcessId::Thermal; }
    [[nodiscard]] std::span<const AlarmSpec> alarms() const noexcept override;
    [[nodiscard]] CommandResult handle(const Command& command) noexcept override;
    void setMode(LoopMode mode) noexcept override;
    [[nodiscard]] LoopVerdict step(const MachineInputs& inputs, const Capabilities& capabilities, LoopOutputs& outputs,
                                   EventSink& events) noexcept override;
    void report(Status& status) const noexcept override { status.thermal = m_status; }
    void sample(Sample&) const noexcept override {}

 private:
    using PerAxis = std::array<double, kAxisCount>;

    [[nodiscard]] CommandResult measure() noexcept;
    [[nodiscard]] CommandResult measureByPart(const MeasureByPart& part) noexcept;
    [[nodiscard]] CommandResult adopt() noexcept;
    [[nodiscard]] CommandResult startWarmUp() noexcept;
    void restart(bool clearShift) noexcept;
    void takeModel() noexcept;
    void catchUp() noexcept;
    void watchSpeed(const MachineInputs& inputs) noexcept;
    void spotDone(const MachineInputs& inputs) noexcept;
    void watchPart(const MachineInputs& inputs) noexcept;
    void runWarmUp(const MachineInputs& inputs, LoopOutputs& outputs) noexcept;
    [[nodiscard]] ThermalMinute minuteNow(const MachineInputs& inputs) noexcept;
    void tick(const MachineInputs& inputs, EventSink& events) noexcept;
    void endBaseline() noexcept;
    [[nodiscard]] thermal::ThermalPrediction feed(LiveModel& model, const ThermalMinute& minute) noexcept;
    void take(const thermal::ThermalPrediction& prediction) noexcept;
    void command(const MachineInputs& inputs) noexcept;
    void forecast() noexcept;
    void raiseAlarms(const MachineInputs& inputs, EventSink& events) noexcept;
    [[nodiscard]] bool shiftReadable(const MachineInputs& inputs) const noexcept;
    [[nodiscard]] PerAxis predicted() const noexcept;
    [[nodiscard]] bool learns() const noexcept;
    void tellLearnt(std::size_t before) noexcept;

    ThermalExchange& m_exchange;
    LoopMode m_mode{LoopMode::Off};
    ThermalSetup m_setup{};
    ThermalStatus m_status{};
    ThermalLog m_log{};
    LiveModel* m_live{nullptr};
    LiveModel* m_next{nullptr};
    std::size_t m_nextBaseline{0};
    std::size_t m_nextMinute{0};

    thermal::ThermalPrediction m_prediction{};
    PerAxis m_carried_um{};
    PerAxis m_trusted_um{};
    bool m_started{false};
    bool m_targetKnown{false};
    bool m_clearShift{false};
    std::int64_t m_due_ns{0};
    std::int64_t m_referenceEnd_ns{0};
    std::int64_t m_last_ns{0};
    std::uint32_t m_reference{0};
    int m_missesOfShift{0};
    int m_wishedTicks{0};
    int m_reportedSick{0};

    double m_heat{0.0};  ///< ∫ (n/1000)^1.5 dt, s
    double m_heat_s{0.0};
    double m_blind_s{0.0};

    GapGauge m_gauge{};
    CoupleWatch m_couples{};
    PartWatch m_parts{};
    std::optional<FinishedPart> m_part{};  ///< the last one, until it has been measured
    bool m_adopted{false};
    bool m_spotPending{false};

    bool m_warmUpWanted{false};
    bool m_warmUpStopWanted{false};
    ProgramFollower m_program{ProcessId::Thermal};
    std::int64_t m_warmUpEnd_ns{0};
};

}  // namespace kerf
