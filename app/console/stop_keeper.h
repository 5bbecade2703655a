// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "db/api/settings_reader.h"
#include "engine/api/engine_api.h"

namespace kerf::console {

/// Keeps the stops of all processes in the data file, so that no restart of console, machine or computer loses one.
///
/// The machine keeps them as well; what either knows counts (StopSlot). GUI thread.
class StopKeeper {
 public:
    /// `reason` goes into the audit beside the change.
    using Save = std::function<void(const std::string& key, const std::string& value, const std::string& reason)>;
    StopKeeper(EngineApi& engine, SettingsReader& settings, Save save);

    /// Before the engine runs: the first of all commands.
    void restore();
    /// Now and then: what has changed since is saved.
    void poll();

 private:
    EngineApi& m_engine;
    Save m_save;
    StopSlots m_kept{};
};

}  // namespace kerf::console
