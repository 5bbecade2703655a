// SPDX-License-Identifier: GPL-3.0-or-later
// What the milling loop is told, and the start it asks the machine for.
#include <algorithm>
#include <cmath>

#include "engine/process/milling/force_bounds.h"
#include "engine/process/milling/milling_alarms.h"
#include "engine/process/milling/milling_loop.h"
#include "engine/process/milling/milling_setup.h"

namespace kerf {

std::span<const AlarmSpec> MillingLoop::alarms() const noexcept {
    return milling_alarm::kSpecs;
}

CommandResult MillingLoop::handle(const Command& command) noexcept {
    if (const auto* loaded = std::get_if<LoadMillingSetup>(&command.action)) {
        return load(loaded->setup);
    }
    if (const auto* loaded = std::get_if<LoadMillingBlank>(&command.action)) {
        return load(loaded->blank);
    }
    if (const auto* wanted = std::get_if<SetMillingLaw>(&command.action)) {
        return select(wanted->law);
    }
    if (const auto* wanted = std::get_if<SetMillingReference>(&command.action)) {
        return setReference(wanted->reference_N);
    }
    if (std::holds_alternative<TeachMillingReference>(command.action)) {
        const double mean_N = m_record.cut().meanForce_N;
        if (mean_N <= 0.0) {
            return CommandResult::refused(
                Sentence(KERF_TEXT("No cut to learn from yet: mill one part, advising or controlled.")));
        }
        return setReference(mean_N);
    }
    if (const auto* restored = std::get_if<RestoreMillingTool>(&command.action)) {
        return load(restored->tool);
    }
    if (std::holds_alternative<NewMillingTool>(command.action)) {
        if (m_program.inPart()) {
            return CommandResult::refused(Sentence(KERF_TEXT("A part is being cut.")));
        }
        m_wear.reset();
        m_controller.newTool();
        return CommandResult::ok();
    }
    if (std::holds_alternative<StartPart>(command.action)) {
        if (m_setup.revision == 0) {
            return CommandResult::refused(Sentence(KERF_TEXT("No milling setup is loaded.")));
        }
        m_startWanted = true;
        return CommandResult::ok();
    }
    return CommandResult::refused(Sentence(KERF_TEXT("The milling loop does not know this command.")));
}

CommandResult MillingLoop::load(const MillingSetup& setup) noexcept {
    if (m_program.inPart()) {
        return CommandResult::refused(
            Sentence(KERF_TEXT("A part is being cut: law and reference can be changed now, the rest after it.")));
    }
    if (const std::optional<Sentence> why = milling::whyUnusable(setup)) {
        return CommandResult::refused(*why);
    }
    if (setup.law == MillingLaw::Preview && m_blank.count == 0) {
        return CommandResult::refused(whyUnavailable(setup.law));
    }
    const auto kx = m_controller.kxLogWeights();  // the tool's, not the setup's
    m_setup = setup;
    m_law = setup.law;
    m_controller = milling::FeedController(milling::controllerParams(setup), m_law);
    m_controller.setBlank(milling::profileOf(m_blank));
    (void)m_controller.restoreKx(kx);
    return CommandResult::ok();
}

CommandResult MillingLoop::load(const MillingToolState& tool) noexcept {
    if (m_program.inPart()) {
        return CommandResult::refused(Sentence(KERF_TEXT("A part is being cut.")));
    }
    const bool sound = std::isfinite(tool.firstStiffness) && std::isfinite(tool.lastStiffness) &&
                       std::isfinite(tool.sumRise) && std::isfinite(tool.sumIndexRise) &&
                       m_controller.restoreKx(tool.kxLogWeight);
    if (!sound) {
        return CommandResult::refused(Sentence(KERF_TEXT("The stored state of the tool cannot be used.")));
    }
    m_wear.restore(tool);
    return CommandResult::ok();
}

CommandResult MillingLoop::load(const MillingBlank& blank) noexcept {
    if (m_program.inPart()) {
        return CommandResult::refused(Sentence(KERF_TEXT("A part is being cut.")));
    }
    if (const std::optional<Sentence> why = milling::whyUnusable(blank)) {
        return CommandResult::refused(*why);
    }
    m_blank = blank;
    m_controller.setBlank(milling::profileOf(blank));
    if (m_law == MillingLaw::Preview && blank.count == 0) {
        (void)select(MillingLaw::Model);
    }
    return CommandResult::ok();
}

Sentence MillingLoop::whyUnavailable(MillingLaw law) const noexcept {
    if (law != MillingLaw::Constant && !m_forceFitted) {
        return Sentence(KERF_TEXT("This machine has no force sensor."));
    }
    if (const Sentence why = milling::whyTooSlow(m_signal, m_setup.spindleSpeed_rpm);
        law != MillingLaw::Constant && !why.empty()) {
        return why;
    }
    if (law == MillingLaw::Preview && m_blank.count == 0) {
        return Sentence(KERF_TEXT("No blank profile is loaded: enter or import one."));
    }
    return {};
}

CommandResult MillingLoop::select(MillingLaw law) noexcept {
    if (static_cast<std::size_t>(law) >= kMillingLawCount) {
        return CommandResult::refused(Sentence(KERF_TEXT("The milling loop does not know this command.")));
    }
    if (const Sentence why = whyUnavailable(law); !why.empty()) {
        return CommandResult::refused(why);
    }
    m_law = law;
    m_setup.law = law;
    m_controller.select(law);
    return CommandResult::ok();
}

CommandResult MillingLoop::setReference(double reference_N) noexcept {
    MillingSetup changed = m_setup;
    changed.reference_N = reference_N;
    if (const std::optional<Sentence> why = milling::whyUnusable(changed)) {
        return CommandResult::refused(*why);
    }
    m_setup.reference_N = reference_N;
    m_controller.setReference(reference_N);
    return CommandResult::ok();
}

void MillingLoop::setMode(LoopMode mode) noexcept {
    if (mode == LoopMode::Control && m_mode != LoopMode::Control) {
        if (m_program.inPart() && !m_paused) {  // from the feed really made on, not from what advising would have made
            m_wanted_mmPerS =
                std::min(m_feedKnown ? m_made_mmPerS : m_setup.lowestFeed_mmPerS, m_setup.highestFeed_mmPerS);
        }
        m_controller.follow(m_wanted_mmPerS);
    }
    m_mode = mode;
}

void MillingLoop::requestStart(const Capabilities& capabilities, LoopOutputs& outputs) noexcept {
    // A control that only slows down needs the highest feed in its program; one that can speed up gets the planned one.
    const double planned_mmPerS = m_setup.plannedFeed_mmPerS;
    const double programmed_mmPerS =
        m_mode == LoopMode::Control
            ? std::max(planned_mmPerS, m_setup.highestFeed_mmPerS / std::max(capabilities.maxFeedScale, 1.0))
            : planned_mmPerS;
    StartProgram program;
    program.process = ProcessId::Milling;
    program.programmedFeed_mmPerRev = programmed_mmPerS * 60.0 / m_setup.spindleSpeed_rpm;
    program.plannedFeedScale = std::min(1.0, planned_mmPerS / programmed_mmPerS);
    program.spindleSpeed_rpm = m_setup.spindleSpeed_rpm;
    program.from_mm = m_setup.from_mm;
    program.to_mm = m_setup.to_mm;
    outputs.request.number = m_program.nextRequest();
    outputs.request.action = program;
}

}  // namespace kerf
