// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/machine/simulated/simulated_thermal.h"

#include <algorithm>
#include <cmath>

namespace kerf {
namespace {

constexpr double kStep_s = 1.0;
constexpr std::uint32_t kMemoryEvery_s = 60;
constexpr double kOpen_degC = 1200.0;  // a broken couple burns out upscale
constexpr double kStuck_degC = 23.0;
constexpr double kShortAt_degC = -45.0;
constexpr double kFaultOffset_K = 4.0;
constexpr double kFaultNoise_K = 3.0;

}  // namespace

SimulatedThermal::SimulatedThermal(const Params& params) noexcept
    : m_plant(params.machineSeed, params.daySeed,
              thermal::hardThermal(params.hardSeed, params.season, params.daySeed)) {
    m_frame.count = static_cast<std::uint16_t>(kMaxTemperatures);
}

void SimulatedThermal::resume(const Memory& memory) noexcept {
    m_plant.resume(memory.plant);
    m_keptOffset_um = memory.workOffset_um;
}

std::optional<SimulatedThermal::Memory> SimulatedThermal::newMemory() noexcept {
    return m_memory.refresh() ? std::optional(m_memory.value()) : std::nullopt;
}

void SimulatedThermal::fit(Capabilities& capabilities) const {
    for (Capability* capability : {&capabilities.temperatures, &capabilities.gapSensors}) {
        capability->fitted = true;
        capability->why = Sentence{};
    }
    capabilities.temperatureCount = static_cast<std::uint16_t>(kMaxTemperatures);
}

Result<void> SimulatedThermal::begin(const StartProgram& program, std::uint32_t) noexcept {
    const bool sound = program.spindleSpeed_rpm > 0.0 && program.revolutions > 0.0 &&
                       std::isfinite(program.spindleSpeed_rpm * program.revolutions);
    if (!sound) return fail(KERF_TEXT("The warm-up program needs speed and revolutions above zero."));
    m_speed_rpm = program.spindleSpeed_rpm;
    m_left_rev = program.revolutions;
    return {};
}

bool SimulatedThermal::advance(const SimulationStep& step, MachineInputs& inputs) noexcept {
    const bool warmingUp = m_left_rev > 0.0;
    if (warmingUp) {
        const double speed_rpm = step.feedFactor > 0.0 ? m_speed_rpm * step.spindleFactor : 0.0;
        inputs.spindleSpeed_rpm =
            simulatedReading(speed_rpm, step.now_ns, step.faults->spindleSpeed, inputs.spindleSpeed_rpm);
        m_left_rev -= speed_rpm / 60.0 * step.dt_s;
        m_turned_rev += speed_rpm / 60.0 * step.dt_s;
    } else if (std::isfinite(inputs.spindleSpeed_rpm.value)) {
        m_turned_rev += std::abs(inputs.spindleSpeed_rpm.value) / 60.0 * step.dt_s;
    }
    m_owed_s += step.dt_s;
    if (m_owed_s >= kStep_s) {
        const double elapsed_s = m_frame.revision == 0 ? 0.0 : m_owed_s;
        if (elapsed_s > 0.0) {
            m_plant.advance(m_turned_rev * 60.0 / elapsed_s, elapsed_s);
        }
        m_owed_s = 0.0;
        m_turned_rev = 0.0;
        const bool otherProgram =
            inputs.program == ProgramState::Running && inputs.programProcess != ProcessId::Thermal;
        refresh(step, !otherProgram);
        if (++m_sinceMemory_s >= kMemoryEvery_s) {
            m_sinceMemory_s = 0;
            Memory& memory = m_memory.writeSlot();
            memory.plant = m_plant.state();
            for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
                memory.workOffset_um[axis] = inputs.workOffset_um[axis].value;
            }
            m_memory.publish();
        }
    }
    inputs.temperatures = &m_frame;
    inputs.gap_um = m_gap_um;
    return m_left_rev > 0.0;
}

void SimulatedThermal::refresh(const SimulationStep& step, bool barInSpindle) noexcept {
    readCouples(step);
    const std::array<double, kAxisCount> drift_um = m_plant.measureDrift();
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        const SignalFault fault = barInSpindle ? step.faults->gaps : SignalFault::Unplugged;
        m_gap_um[axis] = simulatedReading(kGapAtRest_um + drift_um[axis], step.now_ns, fault, m_gap_um[axis]);
    }
}

void SimulatedThermal::readCouples(const SimulationStep& step) noexcept {
    const std::array<double, kMaxTemperatures> temps_degC = m_plant.readThermocouples();
    for (std::size_t k = 0; k < kMaxTemperatures; ++k) {
        m_frame.temp_degC[k] =
            simulatedReading(temps_degC[k], step.now_ns, step.faults->temperatures, m_frame.temp_degC[k]);
    }
    for (const CoupleFault& fault : step.faults->couples) {
        if (fault.couple >= kMaxTemperatures) continue;
        Reading& reading = m_frame.temp_degC[fault.couple];
        switch (fault.kind) {
            case CoupleFaultKind::None:
                break;
            case CoupleFaultKind::Open:
                reading.value = kOpen_degC;
                break;
            case CoupleFaultKind::Short:
                reading.value = kShortAt_degC;
                break;
            case CoupleFaultKind::Stuck:
                reading.value = kStuck_degC;
                break;
            case CoupleFaultKind::Offset:
                reading.value += kFaultOffset_K;
                break;
            case CoupleFaultKind::Noisy:
                reading.value += kFaultNoise_K * m_faultNoise.gauss();
                break;
        }
    }
    ++m_frame.revision;
}

}  // namespace kerf
