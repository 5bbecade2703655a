// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/headless/data_file.h"

#include <fmt/format.h>

#include "app/files/table.h"
#include "db/location.h"
#include "db/migrator.h"

namespace kerf::headless {

std::string databasePath(const std::string& folder) {
    return db::databaseFile(folder.empty() ? db::defaultDataFolder() : folder);
}

std::string checkedDatabase(const std::string& folder) {
    const std::string path = databasePath(folder);
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

std::unique_ptr<db::DatabaseReader> openDatabase(const std::string& path) {
    Result<std::unique_ptr<db::DatabaseReader>> reader = db::DatabaseReader::open(path);
    if (!reader) {
        throw BadInput(fmt::format("{}: {}", path, reader.error().english()));
    }
    return std::move(*reader);
}

}  // namespace kerf::headless
