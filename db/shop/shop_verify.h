// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "db/shop/pg_connection.h"

namespace kerf::db {

/// The first row that is not the same here and in the shop.
struct ShopDifference {
    std::string table{};
    std::string key{};
    std::string what{};  ///< in words
};

struct ShopComparison {
    std::string store{};
    std::string epoch{};
    std::int64_t rows{0};  ///< compared and equal
    std::optional<ShopDifference> difference{};
};

/// Compares every row that travels, column by column, doubles bit by bit, with this file's present epoch in the shop.
/// @throws PgFailure, SqlFailure
[[nodiscard]] ShopComparison compareWithShop(const std::string& dataFile, PgConnection& server);

}  // namespace kerf::db
