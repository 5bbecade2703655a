// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/rooms/turning_room.h"

#include "app/service/turning/turning_records.h"
#include "engine/machine/simulated/simulated_turning.h"
#include "engine/process/turning/hard_lathe.h"
#include "engine/process/turning/turning_loop.h"
#include "ui/pages/turning/turning_page.h"

namespace kerf::console {
namespace {

constexpr double kMotionSensorNoise_um = 0.005;  ///< the lathe's gap sensor at the tool post: the process is identified

}  // namespace

ui::PageEntry TurningRoom::page() const {
    return ui::turningPageEntry();
}

bool TurningRoom::fits(const std::string& machineKind) const {
    return machineKind == "diamond-lathe";
}

std::unique_ptr<SimulatedProcess> TurningRoom::makePlant(const Options& options) {
    SimulatedTurning::Params params;
    params.seed = options.seed;
    const turning::HardLathe lathe = turning::hardLathe(options.machineSeed);
    params.process = lathe.process;
    params.forceNoise_N = lathe.forceNoise_N;
    params.white_um = lathe.white_um;
    params.motionSensorNoise_um = kMotionSensorNoise_um;
    return std::make_unique<SimulatedTurning>(params);
}

std::unique_ptr<ProcessLoop> TurningRoom::makeLoop() {
    return std::make_unique<TurningLoop>(m_exchange.get());
}

void TurningRoom::open(const Context& context) {
    m_service = std::make_unique<StoredTurningService>(
        StoredTurningService::Links{context.writer, context.engine, *m_exchange, context.reader, context.reader,
                                    context.rights, context.options.machine});
}

void TurningRoom::serve(ui::Services& services) {
    services.turningService = m_service.get();
}

bool TurningRoom::prepared(EngineApi& engine) {
    return !m_service || cutBeforehand(engine, ProcessId::Turning, engine.status().turning.partsCut, 1);
}

void TurningRoom::poll() {
    m_service->poll();
}

RecipeHeld TurningRoom::recipe() {
    return {StoredTurningService::kPartType, m_service->recipeJson()};
}

void TurningRoom::recipeRevised(RecipeRevisionId revision) {
    m_service->recipeRevised(revision);
}

}  // namespace kerf::console
