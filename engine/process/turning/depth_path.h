// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>
#include <cstdint>

#include "engine/process/turning/cutting_process.h"
#include "engine/process/turning/plant.h"

namespace kerf::turning {

class InversePath;

/// What the law knows of the way from its command to x_i, delay of one sample included: a command given at k shows in
/// x_i(k + 1). Linear and stable; the same object tells how the entry of the cut (depth from 0 to 1 µm) shows.
///
///   R0        P·z⁻¹
///   R1, B1    (1 − p)/.24 · P/(1 − p·z⁻¹) · z⁻¹
///   B2        −z⁻¹ (the trim moves the tool itself; entry shows at once and stays)
class DepthPath {
 public:
    DepthPath(PlantKind kind, const ProcessParams& process, double slidePole, double nominalGain_NPerUm) noexcept
        : m_kind(kind),
          m_slidePole(slidePole),
          m_slideGain((1.0 - slidePole) / nominalGain_NPerUm),
          m_command{CuttingProcess(process)},
          m_entry{CuttingProcess(process)} {}

    /// The same way backwards, at rest.
    [[nodiscard]] InversePath inverse() const noexcept;
    /// Effect in this sample of the command that acts in it, µm.
    double step_um(double command_um) noexcept { return advance(m_command, command_um); }
    /// Effect in this sample of a cut of 1 µm depth that began with the first call.
    double entryShape() noexcept { return m_kind == PlantKind::B2 ? 1.0 : advance(m_entry, 1.0); }
    [[nodiscard]] std::complex<double> response(double omega_radPerSample) const noexcept {
        const std::complex<double> back = std::polar(1.0, -omega_radPerSample);
        if (m_kind == PlantKind::B2) {
            return -back;
        }
        const std::complex<double> process = m_command.process.params().response(omega_radPerSample);
        return m_kind == PlantKind::R0 ? process * back : m_slideGain * process / (1.0 - m_slidePole * back) * back;
    }
    void setProcess(const ProcessParams& process) noexcept {
        m_command.process.setParams(process);
        m_entry.process.setParams(process);
    }

 private:
    struct State {
        CuttingProcess process;
        double slide_um{0.0};
    };
    double advance(State& state, double chip_um) noexcept {
        if (m_kind == PlantKind::B2) {
            return -chip_um;
        }
        const double force_N = state.process.step(chip_um);
        state.slide_um = m_slidePole * state.slide_um + m_slideGain * force_N;
        return m_kind == PlantKind::R0 ? force_N : state.slide_um;
    }

    PlantKind m_kind;
    double m_slidePole;
    double m_slideGain;
    State m_command;
    State m_entry;
};

/// The way backwards: the command whose effect in the next sample is a given one. P is invertible (usable()).
class InversePath {
 public:
    InversePath(PlantKind kind, const ProcessParams& process, double slidePole, double nominalGain_NPerUm) noexcept
        : m_kind(kind),
          m_slidePole(slidePole),
          m_slideGain((1.0 - slidePole) / nominalGain_NPerUm),
          m_process(process) {}

    double step_um(double effect_um) noexcept {
        if (m_kind == PlantKind::B2) {
            return -effect_um;
        }
        const double force_N =
            m_kind == PlantKind::R0 ? effect_um : (effect_um - m_slidePole * m_effect_um) / m_slideGain;
        m_effect_um = effect_um;
        return m_process.invert(force_N);
    }
    void setProcess(const ProcessParams& process) noexcept { m_process.setParams(process); }

 private:
    PlantKind m_kind;
    double m_slidePole;
    double m_slideGain;
    double m_effect_um{0.0};
    CuttingProcess m_process;
};

inline InversePath DepthPath::inverse() const noexcept {
    return {m_kind, m_command.process.params(), m_slidePole, (1.0 - m_slidePole) / m_slideGain};
}

}  // namespace kerf::turning
