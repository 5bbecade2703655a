// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QFile>

#include "db/migrator.h"

// A static library's resources are linked only when named; the macro must be outside any namespace.
static void initMigrationResources() {
    Q_INIT_RESOURCE(migrations);
}

namespace kerf::db {

std::vector<Migration> builtInMigrations() {
    initMigrationResources();
    std::vector<Migration> migrations;
    const QDir folder(QStringLiteral(":/kerf/migrations"));
    const QStringList names = folder.entryList({QStringLiteral("*.sql")}, QDir::Files, QDir::Name);
    for (const QString& name : names) {
        QFile file(folder.filePath(name));
        if (file.open(QIODevice::ReadOnly)) {
            migrations.push_back(
                parseMigration(name.left(3).toInt(), name.toStdString(), file.readAll().toStdString()));
        }
    }
    return migrations;
}

}  // namespace kerf::db
