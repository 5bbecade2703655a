// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <set>

#include "app/console/background.h"
#include "app/service/rights.h"
#include "db/api/part_reader.h"
#include "db/api/room_records.h"
#include "db/api/store_writer.h"
#include "engine/api/engine_api.h"
#include "ui/services/shift_service.h"
#include "ui/theme/look.h"

namespace kerf::console {

/// The shift page's service: reads on a worker with a reader of its own, writes through the writer, counts the parts of
/// each tool and says when its life comes to an end.
class ShiftDesk final : public ShiftService {
 public:
    struct Links {
        StoreWriter& writer;
        PartReader& parts;
        RoomRecordReader& records;
        std::string databasePath{};
        Background& background;
        const ui::Look& look;
        Rights rights{};
        std::function<const AlarmSpec*(AlarmCode)> specOf{};
        std::function<void(const AlarmEvent&)> raise{};
        /// A new tool is also told to who learns its wear.
        std::function<void(ProcessId, const std::string& author)> toolIsNew{};
    };
    explicit ShiftDesk(Links links);

    /// A part may have been stored.
    void poll();

    void read(int back, Read done) override;
    void nameStop(std::int64_t fromUtc_ms, const std::string& reason, const std::string& author, Done done) override;
    void note(const std::string& text, const std::string& author, Done done) override;
    void handOver(const std::string& text, const std::string& author, Done done) override;
    void writePdf(const ShiftView& shift, const std::string& file, Done done) override;
    [[nodiscard]] const std::vector<ToolLife>& tools() const override { return m_tools; }
    void newTool(ProcessId process, const std::string& author, Done done) override;
    void setToolLife(ProcessId process, std::uint32_t parts, const std::string& author, Done done) override;

 private:
    void add(AddRoomRecord record, Deed deed, Done done);
    void countTools();
    void warn();

    Links m_links;
    std::shared_ptr<bool> m_alive{std::make_shared<bool>(true)};
    std::vector<ToolLife> m_tools{};
    PartId m_newest{-1};
    std::set<ProcessId> m_warned{};
    bool m_raised{false};
};

}  // namespace kerf::console
