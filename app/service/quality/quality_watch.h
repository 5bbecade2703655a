// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "app/service/quality/dfq_export.h"
#include "engine/core/alarm.h"

namespace kerf {

/// Looks at the parts as they are stored: one out of tolerance and a signal of the charts become alarms, and each part
/// that is judged gets its Q-DAS file where a folder is set. A part is told and written again only when a correction
/// has changed its values. What is there when the console starts is known already. GUI thread; reading and writing are
/// done on a worker.
class QualityWatch {
 public:
    using Work = std::function<Result<void>()>;
    using Done = std::function<void(const Result<void>&)>;
    struct Links {
        std::string databasePath{};
        std::function<void(Work, Done)> background{};
        std::function<void(const AlarmEvent&)> raise{};
        /// Folder and pattern as they are set now; an empty folder: no files.
        std::function<std::pair<std::string, std::string>()> files{};
    };
    explicit QualityWatch(Links links) : m_links(std::move(links)), m_alive(std::make_shared<bool>(true)) {}

    /// Something may have been stored: look at the newest parts of these lots (see partsWithoutLot()).
    void look(std::vector<LotId> lots);
    /// Gauges whose date has passed, said once each.
    void tellOverdue(const std::vector<Gauge>& gauges, std::int64_t nowUtc_ms);
    /// A look is under way.
    [[nodiscard]] bool busy() const { return m_busy; }

 private:
    /// Of one part, as last seen.
    struct Seen {
        std::size_t rows{0};   ///< accepted measurements: more of them mean other values
        bool written{false};   ///< its file holds these values
        bool exported{false};  ///< it has a file, which a void makes untrue too
        std::string file{};    ///< where, when it was written since the start
    };
    /// What is known of a lot; travels to the worker and back.
    struct Known {
        bool first{true};
        std::map<PartId, Seen> parts{};
        std::uint32_t lastSignal{0};
        std::vector<AlarmEvent> alarms{};
    };
    static Result<void> lookAt(const std::string& path, LotId lot, const std::pair<std::string, std::string>& files,
                               Known& known);

    Links m_links;
    std::map<LotId, std::shared_ptr<Known>> m_known{};
    std::set<LotId> m_wanted{};
    std::set<std::string> m_overdue{};
    bool m_busy{false};
    std::shared_ptr<bool> m_alive;
};

}  // namespace kerf
