// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/data_file.h"

#include <sys/stat.h>

#include <QDateTime>
#include <QFile>
#include <QLockFile>

#include "db/connection.h"
#include "db/head_file.h"
#include "db/outbox.h"
#include "db/restore.h"
#include "db/statement.h"
#include "db/stores/store.h"

namespace kerf::db {
namespace {

/// An outbox item that this version does not know is not thrown away.
void keepBeside(const std::string& path, const std::vector<std::string>& items) {
    QFile file(QString::fromStdString(path) + QStringLiteral(".outbox-") +
               QDateTime::currentDateTimeUtc().toString(QStringLiteral("yyyyMMdd'T'HHmmsszzz'Z'")));
    if (file.open(QIODevice::WriteOnly)) {
        for (const std::string& item : items) {
            file.write(QByteArray::fromStdString(item + '\n'));
        }
    }
}

Sentence fileGone() {
    return Sentence(KERF_TEXT(
        "The data file was deleted, moved or replaced while Kerf runs: nothing is stored. Put it back, or end "
        "Kerf and start it anew; what waits is kept beside it."));
}

Sentence logGone() {
    return Sentence(KERF_TEXT(
        "The log file (-wal) beside the data file was deleted, moved or replaced while Kerf runs: nothing more is "
        "stored. End Kerf and start it anew; what waits is kept beside it."));
}

template <class T>
void must(const Result<T>& done) {
    if (!done) {
        throw SqlFailure(done.error(), 0, done.error().english());
    }
}

/// What the last run left waiting. On a disk that is still full it stays where it is, for the writer to try again.
void storeOutbox(const std::string& path, Store& store, DataFile::Finding& finding) {
    Outbox outbox(path);
    std::vector<std::string> unknown;
    for (const std::string& text : outbox.found()) {
        const auto item = waitingOf(text);
        if (!item) {
            unknown.push_back(text);
            continue;
        }
        const auto stored = store.addWaiting(*item);
        if (!stored) {
            return;
        }
        finding.partsFound += *stored && std::holds_alternative<FinishedPart>(*item) ? 1 : 0;
    }
    if (!unknown.empty()) {
        keepBeside(path, unknown);
        finding.notRead = unknown.size();
    }
    outbox.clear();
}

}  // namespace

Result<std::unique_ptr<QLockFile>> lockDataFile(const std::string& path) {
    auto lock = std::make_unique<QLockFile>(QString::fromStdString(path) + QStringLiteral(".lock"));
    lock->setStaleLockTime(0);
    if (lock->tryLock(0)) {
        return lock;
    }
    return tl::unexpected<Sentence>(lock->error() == QLockFile::LockFailedError
                                        ? Sentence(KERF_TEXT("Another Kerf is already working with this data file."))
                                        : sentenceForCode(8));
}

bool saysMissing(const Sentence& sentence) {
    return sentence.english() == fileGone().english() || sentence.english() == logGone().english();
}

DataFile::DataFile(std::string path, std::unique_ptr<QLockFile> lock)
    : m_path(std::move(path)), m_lock(std::move(lock)) {}

DataFile::~DataFile() = default;

Result<std::unique_ptr<DataFile>> DataFile::open(const std::string& path) {
    auto lock = lockDataFile(path);
    if (!lock) {
        return tl::unexpected(lock.error());
    }
    std::unique_ptr<DataFile> file(new DataFile(path, std::move(*lock)));
    const auto restored = putInPlace(path);
    if (!restored) {
        return tl::unexpected(restored.error());
    }
    HeadFile headFile(path);
    const auto expected = headFile.read();  // before SQLite looks at the log file
    const auto migrated = prepareDatabase(path);
    if (!migrated) {
        return tl::unexpected(migrated.error());
    }
    Finding& finding = file->m_finding;
    finding.migration = *migrated;
    const Result<void> settled = guarded([&] {
        const Connection connection(path, Access::Write);
        Store store(connection.database());
        if (expected) {
            finding.missing = missingSince(*expected, connection.database());
        }
        if (!finding.missing.empty()) {
            AddAudit entry{"Kerf", "data found missing", "data file", expected->auditId, expected->auditHash, {}, {}};
            entry.newValue = headOf(connection.database()).auditHash;
            entry.reason = finding.missing.english();
            must(store.apply(entry));
        }
        must(store.adoptEarlierForms());
        if (*restored) {
            const Restored& one = **restored;
            must(store.apply(AddAudit{one.request.author, "backup restored", "data file", 0, one.setAside,
                                      one.request.backup, one.request.reason}));
            finding.setAside = one.setAside;
        }
        storeOutbox(path, store, finding);
        headFile.write(headOf(connection.database()));
    });
    if (!settled) {
        return tl::unexpected(settled.error());
    }
    return file;
}

FilePresence::Place FilePresence::placeOf(const std::string& path) {
    struct stat status {};
    return ::stat(path.c_str(), &status) == 0 ? Place{path, status.st_dev, status.st_ino} : Place{path};
}

bool FilePresence::Place::there() const noexcept {
    struct stat status {};
    return inode == 0 || (::stat(path.c_str(), &status) == 0 && status.st_dev == device && status.st_ino == inode);
}

FilePresence::FilePresence(const std::string& path) : m_file(placeOf(path)), m_log(placeOf(path + "-wal")) {}

Sentence FilePresence::missing() const {
    return !m_file.there() ? fileGone() : !m_log.there() ? logGone() : Sentence();
}

}  // namespace kerf::db
