// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/console/background.h"
#include "app/service/quality/quality_watch.h"
#include "app/service/quality/stored_quality_service.h"
#include "ui/services/boring_service.h"

namespace kerf::db {
class DatabaseReader;
}
namespace kerf::ui {
class Look;
}

namespace kerf::console {

/// Quality on the console: the service of its page, and the watch over parts as they are stored. GUI thread.
class QualityDesk {
 public:
    struct Links {
        StoreWriter& writer;
        db::DatabaseReader& reader;
        std::string databasePath{};
        Background& background;
        const ui::Look& look;
        std::function<void(const AlarmEvent&)> raise{};       ///< called only after start()
        std::function<const AlarmSpec*(AlarmCode)> specOf{};  ///< texts of alarms, any thread
        Rights rights{};
        std::vector<ProcessId> processes{};                          ///< of this console
        std::function<RecipeHeld(ProcessId)> recipe{};               ///< what a process without lots works by now
        std::function<void(ProcessId, RecipeRevisionId)> revised{};  ///< limits have made a revision of it
    };
    explicit QualityDesk(Links links);

    [[nodiscard]] StoredQualityService& service() { return *m_service; }
    /// The window is there: alarms may be raised. `bores`: null where nothing is bored.
    void start(BoringService* bores);
    void poll();

 private:
    void lookAtNewest();
    void followRecipes();

    Links m_links;
    std::unique_ptr<StoredQualityService> m_service;
    std::unique_ptr<QualityWatch> m_watch{};
    std::unique_ptr<Subscription> m_bores{};
    std::optional<PartId> m_newest{};
    std::map<ProcessId, std::string> m_partTypes{};  ///< as stored
    bool m_changed{true};
    int m_polls{0};
};

}  // namespace kerf::console
