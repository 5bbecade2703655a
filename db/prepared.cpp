// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/prepared.h"

#include <mutex>
#include <unordered_map>
#include <utility>

namespace kerf::db {
namespace {

using Kept = std::unordered_map<QString, QSqlQuery>;

std::mutex keptLock;
std::unordered_map<QString, Kept>& kept() {
    static std::unordered_map<QString, Kept> all;
    return all;
}

}  // namespace

void keepPrepared(const QString& connection) {
    const std::lock_guard lock(keptLock);
    kept()[connection];
}

void dropPrepared(const QString& connection) {
    const std::lock_guard lock(keptLock);
    kept().erase(connection);
}

std::optional<QSqlQuery> takePrepared(const QString& connection, const QString& sql) {
    const std::lock_guard lock(keptLock);
    const auto mine = kept().find(connection);
    if (mine == kept().end()) {
        return std::nullopt;
    }
    const auto found = mine->second.find(sql);
    if (found == mine->second.end()) {
        return std::nullopt;
    }
    std::optional<QSqlQuery> query(std::move(found->second));
    mine->second.erase(found);
    return query;
}

void giveBackPrepared(const QString& connection, const QString& sql, QSqlQuery query) {
    const std::lock_guard lock(keptLock);
    if (const auto mine = kept().find(connection); mine != kept().end()) {
        mine->second.insert_or_assign(sql, std::move(query));
    }
}

}  // namespace kerf::db
