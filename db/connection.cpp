// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/connection.h"

#include <unistd.h>

#include <QFile>
#include <QFileInfo>
#include <QSqlError>
#include <QUrl>
#include <atomic>

#include "db/prepared.h"
#include "db/statement.h"

namespace kerf::db {
namespace {
std::atomic<std::uint64_t> connectionCount{0};

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
            QUrl url = QUrl::fromLocalFile(QFileInfo(name).absoluteFilePath());
            url.setQuery(QStringLiteral("immutable=1"));
            name = QString::fromLatin1(url.toEncoded());
            options += QStringLiteral(";QSQLITE_OPEN_URI");
        }
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
