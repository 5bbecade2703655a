// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/turning/plant.h"

#include <utility>

namespace kerf::turning {

Plant::Plant(const PlantParams& params) noexcept
    : m_params(params), m_process(params.process), m_surface(params.revolutionSamples) {}

Plant::Line Plant::line(double disturbance_um) const noexcept {
    const ProcessParams& p = m_process.params();
    if (m_params.kind == PlantKind::R0) {
        return {m_process.memory_N() + p.b0 * (disturbance_um + m_params.depth_um), p.b0};
    }
    if (m_params.kind == PlantKind::B2) {
        return {disturbance_um, -1.0};
    }
    const double h = slideGain_umPerN();
    const double s = m_params.regeneration;
    const double chip_um = s > 0.0 ? s * (m_params.depth_um + m_surface.oldest()) : m_params.depth_um;
    const double offset_um =
        disturbance_um + m_params.slidePole * m_slide_um + h * (m_process.memory_N() + p.b0 * chip_um);
    const double loop = 1.0 + h * p.b0 * s;  // x_i stands on both sides when regeneration is on
    return {offset_um / loop, h * p.b0 / loop};
}

PlantSample Plant::step(double disturbance_um, double command_um) noexcept {
    const double acting_um = m_params.extraDelay > 0 ? std::exchange(m_delayed_um, command_um) : command_um;
    const Line here = line(disturbance_um);
    PlantSample sample;
    sample.command_um = acting_um;
    sample.inner_um = here.offset_um + here.slope * acting_um;
    switch (m_params.kind) {
        case PlantKind::R0:
            sample.depth_um = disturbance_um + m_params.depth_um + acting_um;
            sample.force_N = m_process.step(sample.depth_um);
            break;
        case PlantKind::R1:
        case PlantKind::B1: {
            const double s = m_params.regeneration;
            sample.depth_um = acting_um + (s > 0.0 ? s * (m_params.depth_um + m_surface.oldest() - sample.inner_um)
                                                   : m_params.depth_um);
            sample.force_N = m_process.step(sample.depth_um);
            m_slide_um = m_params.slidePole * m_slide_um + slideGain_umPerN() * sample.force_N;
            break;
        }
        case PlantKind::B2:
            sample.depth_um = m_params.depth_um + m_surface.oldest() - sample.inner_um;
            sample.force_N = m_process.step(sample.depth_um);
            break;
    }
    m_surface.push(sample.inner_um);
    return sample;
}

}  // namespace kerf::turning
