// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

/// Prepared statements of a writing connection, kept for their next use: where triggers hang on a table, preparing one
/// takes several times as long as running it. SQLite prepares again by itself what a changed schema has made stale.
///
/// Any thread; a connection and its statements stay on one.
namespace kerf::db {

/// From now on the statements of this connection are kept.
void keepPrepared(sqlite3* connection);
/// Before the connection is closed: what is kept is finalised.
void dropPrepared(sqlite3* connection) noexcept;

/// None is kept, or it is in use by another statement just now: null.
[[nodiscard]] sqlite3_stmt* takePrepared(sqlite3* connection, std::string_view sql);
/// A finished one, for the next taker. Without keepPrepared() it is finalised.
void giveBackPrepared(sqlite3* connection, std::string_view sql, sqlite3_stmt* statement) noexcept;

}  // namespace kerf::db
