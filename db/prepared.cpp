// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/prepared.h"

#include <sqlite3.h>

#include <mutex>
#include <string>
#include <unordered_map>
#include <utility>

namespace kerf::db {

struct PreparedPlace {
    const std::string* words{nullptr};
    sqlite3_stmt* statement{nullptr};  ///< null while in use
};

namespace {

/// By the words; their address only says where to look first.
struct Kept {
    std::unordered_map<std::string, PreparedPlace> byWords{};
    std::unordered_map<const char*, PreparedPlace*> byAddress{};
};

std::mutex keptLock;
std::unordered_map<sqlite3*, Kept>& kept() {
    static std::unordered_map<sqlite3*, Kept> all;
    return all;
}

}  // namespace

void keepPrepared(sqlite3* connection) {
    const std::lock_guard lock(keptLock);
    kept()[connection];
}

void dropPrepared(sqlite3* connection) noexcept {
    const std::lock_guard lock(keptLock);
    const auto mine = kept().find(connection);
    if (mine == kept().end()) {
        return;
    }
    for (const auto& [words, place] : mine->second.byWords) {
        sqlite3_finalize(place.statement);
    }
    kept().erase(mine);
}

PreparedPlace* takePrepared(sqlite3* connection, const char* sql, sqlite3_stmt*& statement) {
    const std::lock_guard lock(keptLock);
    statement = nullptr;
    const auto mine = kept().find(connection);
    if (mine == kept().end()) {
        return nullptr;
    }
    PreparedPlace*& place = mine->second.byAddress[sql];
    if (place == nullptr || *place->words != sql) {
        const auto found = mine->second.byWords.try_emplace(sql).first;
        place = &found->second;
        place->words = &found->first;
    }
    statement = std::exchange(place->statement, nullptr);
    return place;
}

void giveBackPrepared(sqlite3* connection, PreparedPlace* place, sqlite3_stmt* statement) noexcept {
    const std::lock_guard lock(keptLock);
    // A place goes with its connection.
    if (place != nullptr && kept().contains(connection) && place->statement == nullptr) {
        place->statement = statement;
    } else {
        sqlite3_finalize(statement);
    }
}

}  // namespace kerf::db
