// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/engine_gate.h"

#include <variant>

namespace kerf {
namespace {

/// Modes, laws and stops are written by whoever follows them in the status; these are events.
const char* eventOf(const Command& command) {
    if (const auto* reference = std::get_if<TakeThermalReference>(&command.action)) {
        return reference->clearShift ? "reference taken, shift back to zero" : "reference taken";
    }
    if (std::holds_alternative<MeasureOrigin>(command.action)) {
        return "origin measured";
    }
    if (std::holds_alternative<MeasureByPart>(command.action)) {
        return "origin measured by a part";
    }
    return std::holds_alternative<AdoptMeasurement>(command.action) ? "measurement taken over" : nullptr;
}

}  // namespace

std::optional<std::uint32_t> EngineGate::send(const Command& command) noexcept {
    const auto deed = deedOf(command);
    if (!deed) {
        return m_links.engine.send(command);
    }
    const std::string author = m_links.author();
    if (const auto may = permitted(m_links.rights, author, *deed); !may) {
        if (m_links.refused) {
            m_links.refused(may.error());
        }
        return std::nullopt;
    }
    const auto number = m_links.engine.send(command);
    if (const char* event = eventOf(command); number && event != nullptr && m_links.record) {
        m_links.record(author, permissionOf(*deed).key, event);
    }
    return number;
}

}  // namespace kerf
