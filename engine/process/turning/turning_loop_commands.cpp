// SPDX-License-Identifier: GPL-3.0-or-later
// What the turning loop is told, and the start it asks the machine for.
#include "engine/process/turning/turning_alarms.h"
#include "engine/process/turning/turning_loop.h"
#include "engine/process/turning/turning_setup.h"

namespace kerf {

turning::ControllerKind TurningLoop::kindOf(TurningController controller) noexcept {
    switch (controller) {
        case TurningController::Open:
            return turning::ControllerKind::Open;
        case TurningController::Paper:
            return turning::ControllerKind::Paper;
        case TurningController::Pi:
            return turning::ControllerKind::Pi;
        case TurningController::Tones:
            break;
    }
    return turning::ControllerKind::Default;
}

std::span<const AlarmSpec> TurningLoop::alarms() const noexcept {
    return turning_alarm::kSpecs;
}

std::optional<Sentence> TurningLoop::whyUnusable(const TurningSetup& setup) noexcept {
    return turning::whyUnusable(setup);
}

CommandResult TurningLoop::handle(const Command& command) noexcept {
    if (const auto* load = std::get_if<LoadTurningSetup>(&command.action)) {
        if (const auto why = whyUnusable(load->setup)) {
            return CommandResult::refused(*why);
        }
        m_next = load->setup;
        m_status.nextSetup = m_next.revision;
        return CommandResult::ok();
    }
    if (const auto* set = std::get_if<SetTurningController>(&command.action)) {
        if (static_cast<std::size_t>(set->controller) >= kTurningControllers) {
            return CommandResult::refused(Sentence(KERF_TEXT("The turning loop does not know this controller.")));
        }
        m_controller = set->controller;
        m_status.controller = m_controller;
        m_control.select(kindOf(m_controller));
        return CommandResult::ok();
    }
    if (std::holds_alternative<StartPart>(command.action)) {
        if (m_next.revision == 0) {
            return CommandResult::refused(Sentence(KERF_TEXT("No turning setup is loaded: enter the cut first.")));
        }
        m_startWanted = true;
        return CommandResult::ok();
    }
    return CommandResult::refused(Sentence(KERF_TEXT("The turning loop does not know this command.")));
}

void TurningLoop::setMode(LoopMode mode) noexcept {
    m_mode = mode;
}

void TurningLoop::startRequest(LoopOutputs& outputs) noexcept {
    StartProgram program;
    program.process = ProcessId::Turning;
    program.programmedFeed_mmPerRev = m_next.feed_umPerRev / 1000.0;
    program.spindleSpeed_rpm = m_next.spindleSpeed_rpm;
    program.from_mm = m_next.faceFrom_mm;
    program.to_mm = m_next.faceTo_mm;
    program.depth_um = m_next.depth_um;
    outputs.request.number = m_program.nextRequest();
    outputs.request.action = program;
}

}  // namespace kerf
