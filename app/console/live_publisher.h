// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "app/live/live_page.h"
#include "engine/api/engine_api.h"

namespace kerf::console {

/// The live values as a JSON object, as kerf-gateway reads them. A value that is not good is null.
[[nodiscard]] std::string liveText(const Status& status, const Capabilities& capabilities,
                                   const std::string& shop = {});

/// Puts the engine's newest status on the data folder's live page. An engine that stands still goes silent there, as a
/// console that has ended does. GUI thread.
class LivePublisher {
 public:
    LivePublisher(EngineApi& engine, const std::string& dataFolder)
        : m_engine(engine), m_page(live::livePagePath(dataFolder)) {}
    /// `shop` is the state of the way to the shop as JSON; empty: there is none.
    void poll(const std::string& shop);

 private:
    EngineApi& m_engine;
    live::PageWriter m_page;
    std::uint64_t m_lastCycle{0};
};

}  // namespace kerf::console
