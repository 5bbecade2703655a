// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/core/result.h"

namespace kerf {

/// A person known at this machine.
struct AccountRow {
    std::string name{};
    std::string roleKey{};  ///< "operator", "setter", "engineer"
    std::string seal{};     ///< of the PIN; empty: none is asked
    std::uint32_t wrongTries{0};
    std::int64_t lastWrongUtc_ms{0};
};

/// Use it on one thread.
class AccountReader {
 public:
    AccountReader() = default;
    AccountReader(const AccountReader&) = delete;
    AccountReader& operator=(const AccountReader&) = delete;
    virtual ~AccountReader() = default;

    /// By name.
    [[nodiscard]] virtual Result<std::vector<AccountRow>> accounts() = 0;
};

}  // namespace kerf
