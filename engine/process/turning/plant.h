// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "engine/process/turning/cutting_process.h"
#include "engine/process/turning/revolution_buffer.h"

namespace kerf::turning {

/// The four plants the laws are judged on. d_a disturbance at the slide, w command of the trim, d0 depth, all µm.
///
///   R0   y = P·(d_a + d0 + w); the paper's PI closes it with w = −(1 − µ)·C·y. "Inner modulation" is y.
///   R1   x_i = d_a + x_2, x_2 = p·x_2' + (1 − p)/.24·F, F = P·v, v = d0 + w.
///   B1   R1, but the command of one sample acts in the next.
///   B2   the physical one: x_i = d_a − w, u = d0 + x_o − x_i, F = P·u, x_o(k) = x_i(k − d); the command of one sample
///        acts in the next.
/// In R0, R1 and B1 a positive command deepens the cut's chip; in B2 it moves the tool against x_i.
/// Source: two readings that reproduce Jeong & Kim's figures (docs/turning.md); p = .994.
enum class PlantKind : std::uint8_t { R0, R1, B1, B2 };

struct PlantParams {
    PlantKind kind{PlantKind::B1};
    ProcessParams process{};
    double slidePole{0.994};  ///< p of R1 and B1
    double nominalGain_NPerUm{0.24};
    double depth_um{0.0};  ///< d0
    std::size_t revolutionSamples{291};
    /// B1 and B2: further samples between command and action, 0 or 1. R0 and R1: 0 closes the loop within the sample.
    int extraDelay{0};
    /// R1 with regeneration (v = w + s·(d0 + x_o − x_i)); 0 in R1 proper.
    double regeneration{0.0};
};

/// What one sample shows. `depth_um` is the chip that made the force.
struct PlantSample {
    double inner_um{0.0};
    double force_N{0.0};
    double depth_um{0.0};
    double command_um{0.0};  ///< the command that acted in this sample
};

class Plant {
 public:
    explicit Plant(const PlantParams& params) noexcept;

    /// One sample with a command that is given before the sample (B1, B2; R0 and R1 without an algebraic loop).
    PlantSample step(double disturbance_um, double command_um) noexcept;

    /// x_i (R0: y) of this sample as a line in w: inner = offset + slope·w. For laws that answer within the sample.
    struct Line {
        double offset_um{0.0};
        double slope{0.0};
    };
    [[nodiscard]] Line line(double disturbance_um) const noexcept;

    /// Process change in mid-run (a chipped tool, another gain).
    void setProcess(const ProcessParams& process) noexcept { m_process.setParams(process); }
    void setDepth(double depth_um) noexcept { m_params.depth_um = depth_um; }

 private:
    [[nodiscard]] double slideGain_umPerN() const noexcept {
        return (1.0 - m_params.slidePole) / m_params.nominalGain_NPerUm;
    }

    PlantParams m_params;
    CuttingProcess m_process;
    double m_slide_um{0.0};
    double m_delayed_um{0.0};
    RevolutionBuffer m_surface;
};

}  // namespace kerf::turning
