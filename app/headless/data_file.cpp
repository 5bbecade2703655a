// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/headless/data_file.h"

#include <fmt/format.h>

#include <cstdio>

#include "app/files/table.h"
#include "db/connection.h"
#include "db/location.h"
#include "db/migrator.h"
#include "db/shop/outbox.h"
#include "db/shop/pg_connection.h"

namespace kerf::headless {

std::string checkedDataFile(const std::string& folder) {
    const std::string path = db::databaseFile(folder.empty() ? db::defaultDataFolder() : folder);
    const int newest = static_cast<int>(db::builtInMigrations().size());
    const Result<int> version = db::fileVersion(path, newest);
    if (!version) {
        throw BadInput(fmt::format("{}: {}", path, version.error().english()));
    }
    if (*version == 0) {
        throw BadInput(fmt::format("{}: there is no data file; expected --data FOLDER with a kerf.db in it.", path));
    }
    if (*version < newest) {
        throw BadInput(
            fmt::format("{}: the data file has version {}, expected {}; start the console once to bring it "
                        "up to date (it makes a backup first).",
                        path, *version, newest));
    }
    return path;
}

std::unique_ptr<db::DatabaseReader> openReader(const std::string& path) {
    Result<std::unique_ptr<db::DatabaseReader>> reader = db::DatabaseReader::open(path);
    if (!reader) {
        throw BadInput(fmt::format("{}: {}", path, reader.error().english()));
    }
    return std::move(*reader);
}

std::string checkedConninfo(const std::string& option, const std::string& conninfo) {
    if (const std::string fault = db::conninfoFault(conninfo); !fault.empty()) {
        throw BadInput(
            fmt::format("{}: {}; expected key=value pairs or postgresql://… as libpq takes them", option, fault));
    }
    if (db::holdsPassword(conninfo)) {
        std::fputs(
            "kerf: a password on the command line can be read by everybody on this computer; use a certificate, a "
            "service file or PGPASSFILE.\n",
            stderr);
    }
    return conninfo;
}

std::string storeOf(const std::string& file) {
    const db::Connection connection(file, db::Access::Read);
    return db::OutboxReader(connection.database()).identity().store;
}

}  // namespace kerf::headless
