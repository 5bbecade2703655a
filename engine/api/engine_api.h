// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "engine/api/command.h"
#include "engine/api/status.h"

namespace kerf {

/// All of the engine that a screen may touch. One caller thread (the GUI's); no call blocks or allocates in the engine.
class EngineApi {
 public:
    EngineApi() = default;
    EngineApi(const EngineApi&) = delete;
    EngineApi& operator=(const EngineApi&) = delete;
    virtual ~EngineApi() = default;

    /// Number of the command, to be found again in Status::lastCommand; empty when the ring is full (tell the
    /// operator).
    [[nodiscard]] virtual std::optional<std::uint32_t> send(const Command& command) noexcept = 0;
    /// All loops off, last offset held. An atomic flag read first in every cycle: cannot be refused, any thread.
    virtual void holdAll() noexcept = 0;
    /// The newest status, a copy: what a caller holds nobody else's call changes.
    [[nodiscard]] virtual Status status() noexcept = 0;
    /// What the machine can do.
    [[nodiscard]] virtual const Capabilities& capabilities() const noexcept = 0;
    /// Take up to samples.size() chart samples, oldest first; returns how many.
    [[nodiscard]] virtual std::size_t drainSamples(std::span<Sample> samples) noexcept = 0;
    /// Take one alarm event; false when there is none.
    [[nodiscard]] virtual bool nextAlarm(AlarmEvent& event) noexcept = 0;
    /// Texts of an alarm code; null for an unknown one.
    [[nodiscard]] virtual const AlarmSpec* alarmSpec(AlarmCode code) const noexcept = 0;
};

}  // namespace kerf
