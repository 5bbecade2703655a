// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSqlQuery>
#include <QString>
#include <optional>

/// Prepared statements of a writing connection, kept for their next use: where triggers hang on a table, preparing one
/// takes several times as long as running it. SQLite prepares again by itself what a changed schema has made stale.
///
/// Any thread; a connection and its statements stay on one.
namespace kerf::db {

/// From now on the statements of this connection are kept.
void keepPrepared(const QString& connection);
/// Before the connection is closed.
void dropPrepared(const QString& connection);

/// Empty: none is kept, or it is in use by another statement just now.
[[nodiscard]] std::optional<QSqlQuery> takePrepared(const QString& connection, const QString& sql);
/// A finished one, for the next taker. Without keepPrepared() it is given up.
void giveBackPrepared(const QString& connection, const QString& sql, QSqlQuery query);

}  // namespace kerf::db
