// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/restore.h"

#include <QDateTime>
#include <QFile>
#include <QFileInfo>
#include <nlohmann/json.hpp>

#include "db/connection.h"
#include "db/migrator.h"
#include "db/statement.h"

namespace kerf::db {
namespace {

QString readyName(const std::string& path) {
    return QString::fromStdString(path) + QStringLiteral(".restore");
}
QString requestName(const std::string& path) {
    return QString::fromStdString(path) + QStringLiteral(".restore.json");
}

Result<void> mustBeOurs(const std::string& backup) {
    return guarded([&] {
        const Connection connection(backup, Access::Read);
        if (integerOf(connection.database(), QStringLiteral("PRAGMA application_id")) != kApplicationId) {
            throw SqlFailure(Sentence(KERF_TEXT("This is no data file of Kerf's.")), 0, backup);
        }
        if (integerOf(connection.database(), QStringLiteral("PRAGMA user_version")) >
            static_cast<std::int64_t>(builtInMigrations().size())) {
            throw SqlFailure(Sentence(KERF_TEXT("This backup is of a later version of Kerf.")), 0, backup);
        }
    });
}

bool writeWhole(const QString& name, const std::string& text) {
    QFile file(name);
    return file.open(QIODevice::WriteOnly) && file.write(QByteArray::fromStdString(text)) == qint64(text.size()) &&
           file.flush();
}

}  // namespace

Result<void> layReady(const std::string& path, const RestoreRequest& request) {
    if (!QFile::exists(QString::fromStdString(request.backup))) {
        return fail(KERF_TEXT("There is no such file."));
    }
    if (const auto ours = mustBeOurs(request.backup); !ours) {
        return ours;
    }
    QFile::remove(readyName(path));
    // The name of what is set aside is decided here, so that a restore that was cut short goes on under the same one.
    const QString aside = QString::fromStdString(path) + QStringLiteral(".before-") +
                          QDateTime::currentDateTimeUtc().toString(QStringLiteral("yyyyMMdd'T'HHmmss'Z'"));
    const nlohmann::json words{{"backup", request.backup},
                               {"author", request.author},
                               {"reason", request.reason},
                               {"set_aside", aside.toStdString()}};
    if (!writeWhole(requestName(path), words.dump())) {
        return tl::unexpected<Sentence>(sentenceForCode(8));
    }
    auto copied = backupDatabase(request.backup, readyName(path).toStdString());  // checked, whole or not at all
    if (!copied) {
        QFile::remove(requestName(path));
    }
    return copied;
}

Result<std::optional<Restored>> putInPlace(const std::string& path) {
    const QString ready = readyName(path);
    if (!QFile::exists(ready)) {
        return std::optional<Restored>();
    }
    QFile file(requestName(path));
    const QByteArray text = file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    const auto words = nlohmann::json::parse(text.begin(), text.end(), nullptr, false);
    if (!words.is_object() || !words.contains("set_aside")) {
        return fail(
            KERF_TEXT("A backup lies ready, but not who has asked for it: delete kerf.db.restore or ask again."));
    }
    Restored restored;
    restored.request = {words.value("backup", std::string()), words.value("author", std::string()),
                        words.value("reason", std::string())};
    const QString data = QString::fromStdString(path);
    const QString aside = QString::fromStdString(words.value("set_aside", std::string()));
    if (QFile::exists(data) || QFile::exists(aside)) {
        restored.setAside = aside.toStdString();
    }
    // The log goes first: left behind, it would be played into the restored file.
    const bool moved = (!QFile::exists(data + QStringLiteral("-wal")) ||
                        QFile::rename(data + QStringLiteral("-wal"), aside + QStringLiteral("-wal"))) &&
                       (!QFile::exists(data) || QFile::rename(data, aside));
    QFile::remove(data + QStringLiteral("-shm"));
    QFile::remove(data + QStringLiteral(".head"));  // of the other file
    if (!moved || !QFile::rename(ready, data)) {
        return fail(KERF_TEXT("The backup could not be put in place: check the folder and its permissions."));
    }
    QFile::remove(requestName(path));
    return std::optional(restored);
}

}  // namespace kerf::db
