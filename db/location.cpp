// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/location.h"

#include <QDir>
#include <QStandardPaths>

namespace kerf::db {

std::string defaultDataFolder() {
    const QString base = QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation);
    return QDir(base).filePath(QStringLiteral("kerf")).toStdString();
}

std::string databaseFile(const std::string& folder) {
    return QDir(QString::fromStdString(folder)).filePath(QStringLiteral("kerf.db")).toStdString();
}

}  // namespace kerf::db
