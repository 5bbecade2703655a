// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/prepared.h"

#include <sqlite3.h>

#include <functional>
#include <mutex>
#include <string>
#include <unordered_map>
#include <utility>

namespace kerf::db {
namespace {

struct Hash {
    using is_transparent = void;
    std::size_t operator()(std::string_view text) const noexcept { return std::hash<std::string_view>{}(text); }
};
/// By the words, not by their address: null while in use.
using Kept = std::unordered_map<std::string, sqlite3_stmt*, Hash, std::equal_to<>>;

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
    for (const auto& [words, statement] : mine->second) {
        sqlite3_finalize(statement);
    }
    kept().erase(mine);
}

sqlite3_stmt* takePrepared(sqlite3* connection, std::string_view sql) {
    const std::lock_guard lock(keptLock);
    const auto mine = kept().find(connection);
    if (mine == kept().end()) {
        return nullptr;
    }
    const auto found = mine->second.find(sql);
    if (found == mine->second.end()) {
        mine->second.emplace(sql, nullptr);  // its place, so that giving back allocates nothing
        return nullptr;
    }
    return std::exchange(found->second, nullptr);
}

void giveBackPrepared(sqlite3* connection, std::string_view sql, sqlite3_stmt* statement) noexcept {
    const std::lock_guard lock(keptLock);
    if (const auto mine = kept().find(connection); mine != kept().end()) {
        if (const auto found = mine->second.find(sql); found != mine->second.end() && found->second == nullptr) {
            found->second = statement;
            return;
        }
    }
    sqlite3_finalize(statement);
}

}  // namespace kerf::db
