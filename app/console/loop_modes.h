// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <string>

#include "db/api/settings_reader.h"
#include "engine/api/engine_api.h"

namespace kerf::console {

/// Keeps the mode a person has chosen for each loop over a restart.
///
/// Nothing chosen yet: control on a simulated machine, advise on a real one, so that a new installation never acts on
/// a machine unasked. GUI thread.
class LoopModes {
 public:
    using Save = std::function<void(const std::string& key, const std::string& value)>;
    LoopModes(EngineApi& engine, SettingsReader& settings, Save save);

    /// Ask the engine for the kept modes.
    void restore();
    /// Now and then: what a person has changed since is saved.
    void poll();

 private:
    EngineApi& m_engine;
    Save m_save;
    std::array<LoopMode, kProcessPlaces> m_kept{};
    std::array<bool, kProcessPlaces> m_inForce{};  ///< the engine has taken the kept mode: from now on changes count
};

}  // namespace kerf::console
