// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "db/api/account_reader.h"
#include "db/api/alarm_reader.h"
#include "db/api/audit_reader.h"
#include "db/api/lot_reader.h"
#include "db/api/part_reader.h"
#include "db/api/room_records.h"
#include "db/api/settings_reader.h"
#include "db/connection.h"

namespace kerf::db {

/// All readers on one read-only connection, for the thread that made it. Never waits for the writer (WAL).
class DatabaseReader final : public PartReader,
                             public LotReader,
                             public SettingsReader,
                             public AlarmReader,
                             public AuditReader,
                             public RoomRecordReader,
                             public AccountReader {
 public:
    /// The file must have been brought up to date by prepareDatabase().
    [[nodiscard]] static Result<std::unique_ptr<DatabaseReader>> open(const std::string& path);

    [[nodiscard]] Result<std::vector<PartRow>> parts(const PartQuery& query) override;
    [[nodiscard]] Result<std::uint64_t> count(const PartQuery& query, std::uint64_t atMost) override;
    [[nodiscard]] Result<std::optional<PartDetail>> part(PartId id) override;

    [[nodiscard]] Result<std::vector<MachineRow>> machines() override;
    [[nodiscard]] Result<std::vector<PartTypeRow>> partTypes(std::optional<ProcessId> process) override;
    [[nodiscard]] Result<std::vector<RecipeRevision>> recipes(PartTypeId partType) override;
    [[nodiscard]] Result<std::vector<RecipeRevision>> newestRecipes(ProcessId process) override;
    [[nodiscard]] Result<std::vector<RecipeRevision>> allRecipes(ProcessId process) override;
    [[nodiscard]] Result<std::vector<LotRow>> lots(std::optional<PartTypeId> partType, std::uint32_t limit,
                                                   std::optional<ProcessId> process = std::nullopt) override;
    [[nodiscard]] Result<std::optional<LotId>> activeLot(ProcessId process) override;
    [[nodiscard]] Result<std::optional<RecipeRevision>> recipeOf(LotId lot) override;
    [[nodiscard]] Result<std::optional<LotHistory>> newestParts(LotId lot, std::uint32_t count,
                                                                std::optional<PartId> last) override;
    [[nodiscard]] Result<std::optional<LotHistory>> history(LotId lot) override;

    [[nodiscard]] Result<std::optional<std::string>> setting(const std::string& key) override;
    [[nodiscard]] Result<std::vector<SettingRow>> settings() override;

    [[nodiscard]] Result<std::vector<AlarmRow>> alarms(std::optional<AlarmId> before, std::uint32_t limit) override;
    [[nodiscard]] Result<std::vector<AlarmRow>> openAlarms() override;

    [[nodiscard]] Result<std::vector<AuditRow>> audit(std::optional<std::int64_t> before, std::uint32_t limit) override;
    [[nodiscard]] Result<std::vector<AuditRow>> auditAfter(std::int64_t after, std::uint32_t limit) override;
    [[nodiscard]] Result<AuditVerdict> verifyAudit() override;

    [[nodiscard]] Result<std::vector<AccountRow>> accounts() override;

    [[nodiscard]] Result<std::vector<RoomRecordRow>> newestRoomRecords(ProcessId process,
                                                                       const std::string& kind) override;
    [[nodiscard]] Result<std::vector<RoomRecordRow>> roomRecords(ProcessId process, const std::string& kind,
                                                                 const std::string& subject,
                                                                 std::uint32_t limit) override;

 private:
    explicit DatabaseReader(const std::string& path) : m_path(path), m_connection(path, Access::Read) {}
    [[nodiscard]] const QSqlDatabase& database() const noexcept { return m_connection.database(); }

    std::string m_path;
    Connection m_connection;
};

}  // namespace kerf::db
