// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "db/api/rows.h"
#include "engine/core/result.h"

namespace kerf {

/// Which parts. Pages follow each other by key (`before`, or `after` with oldestFirst), so the last page costs what the
/// first does.
struct PartQuery {
    std::optional<ProcessId> process{};
    std::optional<LotId> lot{};
    std::optional<std::uint32_t> numberWithoutLot{};  ///< the part of this number that is of no lot
    std::string text{};  ///< start of the serial number, or any piece of the lot's or part type's name
    std::optional<std::int64_t> fromUtc_ms{};  ///< ended at or after
    std::optional<std::int64_t> toUtc_ms{};    ///< ended before
    std::optional<PartId> before{};            ///< only older parts than this one: the last one of the page before
    std::optional<PartId> after{};             ///< only newer parts than this one
    bool oldestFirst{false};
    std::uint32_t limit{100};
};

/// Parts for tables. Own read-only connection; use it on the thread that made it.
class PartReader {
 public:
    PartReader() = default;
    PartReader(const PartReader&) = delete;
    PartReader& operator=(const PartReader&) = delete;
    virtual ~PartReader() = default;

    [[nodiscard]] virtual Result<std::vector<PartRow>> parts(const PartQuery& query) = 0;
    /// How many parts match; counts at most `atMost` of them.
    [[nodiscard]] virtual Result<std::uint64_t> count(const PartQuery& query, std::uint64_t atMost) = 0;
    /// Empty optional: no such part.
    [[nodiscard]] virtual Result<std::optional<PartDetail>> part(PartId id) = 0;
};

}  // namespace kerf
