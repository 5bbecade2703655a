// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QLoggingCategory>
#include <memory>
#include <string>

#include "db/readers/database_reader.h"

/// What every command that reads the data file shares.
namespace kerf::headless {

/// Qt's SQL drivers want an application object; it lives as long as the command.
struct QtForSql {
    /// What goes wrong is one sentence of the command's own.
    QtForSql() { QLoggingCategory::setFilterRules(QStringLiteral("kerf.db.warning=false\nkerf.setups.info=false")); }
    int argc{1};
    char name[5]{"kerf"};
    char* argv[2]{name, nullptr};
    QCoreApplication application{argc, argv};
};

/// The data file of a folder (empty: the user's), after a look that this program can read it. Never brings it up to
/// date: only the console does. @throws BadInput
[[nodiscard]] std::string checkedDataFile(const std::string& folder);
/// @throws BadInput
[[nodiscard]] std::unique_ptr<db::DatabaseReader> openReader(const std::string& path);

/// A connection string of PostgreSQL, looked at: what libpq cannot read is said with the option's name, a password in
/// it is said to be visible. @throws BadInput
[[nodiscard]] std::string checkedConninfo(const std::string& option, const std::string& conninfo);
/// Which console's history this file is. @throws db::SqlFailure
[[nodiscard]] std::string storeOf(const std::string& file);

}  // namespace kerf::headless
