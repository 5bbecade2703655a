// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

struct sqlite3;
struct sqlite3_stmt;

/// Prepared statements of a writing connection, kept for their next use: where triggers hang on a table, preparing one
/// takes several times as long as running it. SQLite prepares again by itself what a changed schema has made stale.
///
/// Any thread; a connection and its statements stay on one.
namespace kerf::db {

/// Where the statement of some words is kept.
struct PreparedPlace;

/// From now on the statements of this connection are kept.
void keepPrepared(sqlite3* connection);
/// Before the connection is closed: what is kept is finalised.
void dropPrepared(sqlite3* connection) noexcept;

/// The place for these words; null: nothing is kept for this connection. `statement`: what is kept there, null when
/// there is none, or it is in use by another statement just now.
[[nodiscard]] PreparedPlace* takePrepared(sqlite3* connection, const char* sql, sqlite3_stmt*& statement);
/// Reset and without values. Finalised when it is not kept.
void giveBackPrepared(sqlite3* connection, PreparedPlace* place, sqlite3_stmt* statement) noexcept;

}  // namespace kerf::db
