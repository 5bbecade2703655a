// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/service/rights.h"
#include "engine/api/engine_api.h"
#include "ui/services/command_deeds.h"

namespace kerf {

/// The engine as the pages see it: a command that changes something is let through for those who may, whatever page
/// sends it. Services stand behind the gate and check for themselves. GUI thread.
class EngineGate final : public EngineApi {
 public:
    struct Links {
        EngineApi& engine;
        std::function<std::string()> author;  ///< who is signed on; empty: nobody
        Rights rights;
        /// A change that nobody else writes down. Author, key of the deed, what was asked for.
        std::function<void(const std::string& author, const char* key, const std::string& what)> record;
        std::function<void(const Sentence& why)> refused;
    };
    explicit EngineGate(Links links) : m_links(std::move(links)) {}

    [[nodiscard]] std::optional<std::uint32_t> send(const Command& command) noexcept override;
    void holdAll() noexcept override { m_links.engine.holdAll(); }
    [[nodiscard]] Status status() noexcept override { return m_links.engine.status(); }
    [[nodiscard]] const Capabilities& capabilities() const noexcept override { return m_links.engine.capabilities(); }
    [[nodiscard]] std::size_t drainSamples(std::span<Sample> samples) noexcept override {
        return m_links.engine.drainSamples(samples);
    }
    [[nodiscard]] bool nextAlarm(AlarmEvent& event) noexcept override { return m_links.engine.nextAlarm(event); }
    [[nodiscard]] const AlarmSpec* alarmSpec(AlarmCode code) const noexcept override {
        return m_links.engine.alarmSpec(code);
    }

 private:
    Links m_links;
};

}  // namespace kerf
