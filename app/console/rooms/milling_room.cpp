// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/rooms/milling_room.h"

#include <algorithm>
#include <array>

#include "app/service/milling/milling_json.h"
#include "engine/process/milling/hard_machine.h"
#include "engine/process/milling/milling_loop.h"
#include "ui/pages/milling/milling_page.h"

namespace kerf::console {

ui::PageEntry MillingRoom::page() const {
    return ui::millingPageEntry();
}

bool MillingRoom::fits(const std::string& machineKind) const {
    return machineKind != "diamond-lathe";
}

std::unique_ptr<SimulatedProcess> MillingRoom::makePlant(const Options& options) {
    constexpr std::array kHeights_mm{1.0, 2.0, 3.0, 2.0, 1.0};  // the published experiment's blank
    constexpr double kSegment_mm = 20.0;
    SimulatedMilling::Params params;
    params.blanks = {milling::BlankProfile::ofSegments(kHeights_mm, kSegment_mm)->inAir(true, true)};
    params.wearPerPart = 0.015;  // twenty parts to the usual threshold: a shift sees the trend
    params.seed = options.seed;
    if (options.machineSeed != 0) {  // the noise of a mean says nothing of single samples: theirs stays
        const milling::HardMachine machine = milling::hardMachine(options.machineSeed);
        params.plant = machine.plant;
        params.shape = machine.shape;
        params.driveLag_s = std::max(params.driveLag_s, machine.axisLag_s);
        params.revolutionNoise_N = machine.forceNoise_N;
        params.late = machine.late;
        params.drift_NPerS = machine.drift_NPerS;
        params.corner_Hz = machine.corner_Hz;
        params.chattersFrom_mm = machine.chattersFrom_mm;
        params.chatter_Hz = machine.chatter_Hz;
        params.blanks = {machine.blank.inAir(true, true)};
    }
    auto plant = std::make_unique<SimulatedMilling>(params);
    m_plant = plant.get();
    return plant;
}

std::unique_ptr<ProcessLoop> MillingRoom::makeLoop() {
    return std::make_unique<MillingLoop>();
}

void MillingRoom::open(const Context& context) {
    StoredMillingService::Links links{context.writer, context.engine,         context.author, {},
                                      context.rights, context.options.machine};
    if (m_plant != nullptr) {
        links.toolChanged = [plant = m_plant](std::uint32_t parts) { plant->setTool(parts); };
    }
    m_service =
        std::make_unique<StoredMillingService>(std::move(links), context.reader, context.reader, context.reader);
}

void MillingRoom::serve(ui::Services& services) {
    services.millingService = m_service.get();
}

bool MillingRoom::prepared(EngineApi& engine) {
    return !m_service || cutBeforehand(engine, ProcessId::Milling, engine.status().milling.partsCut, 2);
}

void MillingRoom::toolIsNew(const std::string& author) {
    m_service->newTool(author, [](const Result<void>&) {});
}

void MillingRoom::poll() {
    m_service->poll();
}

RecipeHeld MillingRoom::recipe() {
    const MillingServiceView& view = m_service->view();
    return {view.partType, m_service->recipeJson()};
}

void MillingRoom::recipeRevised(RecipeRevisionId revision) {
    m_service->recipeRevised(revision);
}

}  // namespace kerf::console
