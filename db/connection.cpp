// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/connection.h"

#include <sqlite3.h>
#include <unistd.h>

#include <QFile>
#include <QFileInfo>
#include <QSqlError>
#include <QUrl>
#include <atomic>

#include "db/gathering_vfs.h"
#include "db/prepared.h"
#include "db/statement.h"

namespace kerf::db {
namespace {
std::atomic<std::uint64_t> connectionCount{0};

/// SQLite counts the memory it uses, under a lock for each piece of it; nobody asks. Only before its first connection.
void leaveMemoryUncounted() {
    static const int done = sqlite3_config(SQLITE_CONFIG_MEMSTATUS, 0);
    (void)done;
}

QString uriOf(const QString& path, const QString& query) {
    const QByteArray place = QUrl::toPercentEncoding(QFileInfo(path).absoluteFilePath(), "/");
    return QStringLiteral("file://") + QString::fromLatin1(place) + u'?' + query;
}

/// A write-ahead log needs a folder to make its index in.
bool onUnwritableMedium(const std::string& path) {
    const auto slash = path.rfind('/');
    const std::string folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
    return ::access(path.c_str(), R_OK) == 0 && ::access(folder.c_str(), W_OK) != 0;
}

std::unique_ptr<QTemporaryDir> copyWithLog(const QString& path) {
    auto folder = std::make_unique<QTemporaryDir>();
    const QString copy = folder->filePath(QStringLiteral("kerf.db"));
    const bool done = folder->isValid() && QFile::copy(path, copy) &&
                      QFile::copy(path + QStringLiteral("-wal"), copy + QStringLiteral("-wal"));
    if (!done) {
        return nullptr;
    }
    for (const QString& name : {copy, copy + QStringLiteral("-wal")}) {
        QFile::setPermissions(name, QFile::ReadOwner | QFile::WriteOwner);
    }
    return folder;
}
}  // namespace

Connection::Connection(const std::string& path, Access access)
    : m_name(QStringLiteral("kerf-%1").arg(connectionCount.fetch_add(1))),
      m_database(QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), m_name)) {
    leaveMemoryUncounted();
    const auto giveUp = [this] {
        m_database = QSqlDatabase();
        QSqlDatabase::removeDatabase(m_name);
    };
    QString name = QString::fromStdString(path);
    QString options = access == Access::Read ? QStringLiteral("QSQLITE_OPEN_READONLY;QSQLITE_BUSY_TIMEOUT=2000")
                                             : QStringLiteral("QSQLITE_BUSY_TIMEOUT=2000");
    if (access == Access::Read && onUnwritableMedium(path)) {
        if (QFileInfo(name + QStringLiteral("-wal")).size() > 0) {
            m_copy = copyWithLog(name);
            name = m_copy ? m_copy->filePath(QStringLiteral("kerf.db")) : name;
        } else {
            name = uriOf(name, QStringLiteral("immutable=1"));
            options += QStringLiteral(";QSQLITE_OPEN_URI");
        }
    }
    if (const char* vfs = access == Access::Write ? gatheringVfs() : nullptr) {
        name = uriOf(name, QStringLiteral("vfs=") + QLatin1String(vfs));
        options += QStringLiteral(";QSQLITE_OPEN_URI");
    }
    m_database.setDatabaseName(name);
    m_database.setConnectOptions(options);
    if (!m_database.open()) {
        const QSqlError error = m_database.lastError();
        const int code = error.nativeErrorCode().toInt() & 0xFF;
        giveUp();
        throw SqlFailure(sentenceForCode(code), code, error.text().toStdString());
    }
    try {
        if (access == Access::Write) {
            execute(m_database, QStringLiteral("PRAGMA journal_mode = WAL"));
            execute(m_database, QStringLiteral("PRAGMA synchronous = FULL"));
            execute(m_database, QStringLiteral("PRAGMA foreign_keys = ON"));
            // INSERT OR REPLACE must not get past the delete triggers of the append-only tables.
            execute(m_database, QStringLiteral("PRAGMA recursive_triggers = ON"));
            execute(m_database, QStringLiteral("PRAGMA journal_size_limit = 67108864"));
            // Emptying the log costs two waits for the disk: once in 500 acceptances instead of once in 120.
            execute(m_database, QStringLiteral("PRAGMA wal_autocheckpoint = 4000"));
            // Frames of trigger programs are larger than the slots that SQLite has ready by itself.
            sqlite3_db_config(handleOf(m_database), SQLITE_DBCONFIG_LOOKASIDE, nullptr, 4096, 64);
            keepPrepared(handleOf(m_database));
        } else {
            execute(m_database, QStringLiteral("PRAGMA query_only = ON"));
        }
    } catch (const SqlFailure&) {
        giveUp();
        throw;
    }
}

Connection::~Connection() {
    dropPrepared(handleOf(m_database));
    m_database.close();
    m_database = QSqlDatabase();
    QSqlDatabase::removeDatabase(m_name);
}

}  // namespace kerf::db
