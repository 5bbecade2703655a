// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "db/api/rows.h"
#include "engine/core/result.h"

namespace kerf {

/// What a check of the audit chain found.
struct AuditVerdict {
    std::uint64_t entries{0};                ///< looked at
    std::uint64_t measurements{0};           ///< compared with their audit entry
    std::uint64_t roomRecords{0};            ///< the same: setups, tunings, models
    std::uint64_t redacted{0};               ///< entries whose text was taken out, with an entry that says why
    std::optional<std::int64_t> firstBad{};  ///< audit entry (or measurement) where it breaks
    Sentence finding{};                      ///< empty: intact
    std::string headHash{};                  ///< hash of the newest entry: note it down to notice a cut-off end
};

/// The audit log: who, when, what, old, new, why. Use it on one thread.
class AuditReader {
 public:
    AuditReader() = default;
    AuditReader(const AuditReader&) = delete;
    AuditReader& operator=(const AuditReader&) = delete;
    virtual ~AuditReader() = default;

    /// Newest first; only entries older than `before` when given.
    [[nodiscard]] virtual Result<std::vector<AuditRow>> audit(std::optional<std::int64_t> before,
                                                              std::uint32_t limit) = 0;
    /// Oldest first, after that entry (0: from the beginning).
    [[nodiscard]] virtual Result<std::vector<AuditRow>> auditAfter(std::int64_t after, std::uint32_t limit) = 0;
    /// Recomputes the chain and compares every measurement with what was logged when it was accepted.
    [[nodiscard]] virtual Result<AuditVerdict> verifyAudit() = 0;
};

}  // namespace kerf
