// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/simulated_shift.h"

#include <spdlog/spdlog.h>

#include <algorithm>

namespace kerf::console {
namespace {

constexpr const char* kGauge = "simulated";

template <class Action>
Command commandOf(const Action& action) {
    Command command;
    command.action = action;
    return command;
}

}  // namespace

SimulatedShift::SimulatedShift(const Params& params, EngineApi& engine, BoringService* service, QObject* parent)
    : QObject(parent), m_params(params), m_engine(engine), m_service(service) {
    m_prepared = params.preparedParts == 0 || (service != nullptr && partsDone() >= params.preparedParts);
    setSpeed(m_prepared ? params.simulationSpeed : 0.0);
    connect(&m_timer, &QTimer::timeout, this, &SimulatedShift::tick);
    m_timer.start(kTick_ms);
}

std::uint32_t SimulatedShift::partsDone() const {
    const auto& parts = m_service->view().parts;
    const auto last =
        std::find_if(parts.rbegin(), parts.rend(), [](const BorePartView& part) { return part.complete; });
    return last == parts.rend() ? 0 : last->number;
}

void SimulatedShift::setSpeed(double factor) {
    (void)m_engine.send(commandOf(SetSimulationSpeed{factor}));
}

void SimulatedShift::tick() {
    if (!m_prepared && boresDone()) {
        if (m_params.others && !m_params.others()) {
            return;
        }
        m_prepared = true;
        setSpeed(m_params.simulationSpeed);
        emit preparationDone();
    }
    if (m_service == nullptr) {
        return;
    }
    if (m_service->view().awaiting) {
        if (!m_prepared || m_params.autoOperator) {
            enterWhatTheGaugeShows();
        }
        return;
    }
    loadNextBlank();
}

void SimulatedShift::enterWhatTheGaugeShows() {
    if (m_entering) {
        return;
    }
    const BoringServiceView& view = m_service->view();
    const auto reading_mm = m_service->gaugeReading_mm(*view.awaiting, view.awaitingDepth);
    if (!reading_mm) {
        return;
    }
    BoreEntry entry;
    entry.part = *view.awaiting;
    entry.depth = view.awaitingDepth;
    entry.diameter_mm = *reading_mm;
    entry.author = kAuthor;
    entry.fromGauge = true;
    entry.gauge = kGauge;
    entry.confirmed = true;  // the gauge is read again and again until it is believed
    m_entering = true;
    m_service->enter(entry, [this](const Result<void>& result) {
        m_entering = false;
        if (!result) {
            spdlog::warn("simulated operator: {}", result.error().english());
        }
    });
}

void SimulatedShift::loadNextBlank() {
    const Status& status = m_engine.status();
    const BoringServiceView& view = m_service->view();
    const std::uint32_t cut = view.parts.empty() ? 0 : view.parts.back().number;
    const bool machineFree = status.program != ProgramState::Running && status.program != ProgramState::Paused;
    if (!machineFree && m_startWait > 0) {
        m_startWait = kStartPatience_ticks;  // the wait is for the service, not for the cut
    }
    // The part just finished shows up at the service a moment after the machine has finished it.
    const bool known = m_startWait == 0 || cut > m_startedAfter || --m_startWait == 0;
    // Opening a lot is opening it: its first part is started by a touch of its own.
    if (const std::string lot = view.partType + '/' + view.lot; lot != m_lot) {
        m_opened = !m_lot.empty();
        m_lot = lot;
    }
    m_opened = m_opened && machineFree && cut == 0;
    if (m_opened || !machineFree || !known || status.held || status.link != LinkState::Up ||
        status.boring.nextSchedule == 0 || view.lotClosed || lotFull(view)) {
        return;
    }
    if (m_engine.send(commandOf(StartPart{ProcessId::Boring}))) {
        m_startedAfter = cut;
        m_startWait = kStartPatience_ticks;
    }
}

}  // namespace kerf::console
