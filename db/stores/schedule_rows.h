// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSqlDatabase>

#include "db/api/rows.h"

namespace kerf::db {

/// The row with this lot, revision and values, or a new one; prediction, reason and acceptance are filled in when
/// given.
/// @throws SqlFailure
ScheduleId findOrAddSchedule(const QSqlDatabase& database, const ScheduleRow& row);

}  // namespace kerf::db
