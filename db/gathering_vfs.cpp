// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/gathering_vfs.h"

#include <sqlite3.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <memory>
#include <new>

namespace kerf::db {
namespace {

constexpr int kFrameHeader_bytes = 24;  // sqlite.org/fileformat2.html, 4.1
constexpr int kLargestPage_bytes = 65536;
/// SQLite's unix VFS writes at most this at a time.
constexpr int kRoom_bytes = 0x1FFFF;

/// A data file or its write-ahead log. SQLite allocates it, followed by the file of the VFS below.
struct File {
    sqlite3_file base;
    sqlite3_io_methods methods;
    File* other;          ///< of the data file its log, of the log its data file; null: none
    char* gathered;       ///< null: there was no memory for it, each write goes through
    int size_bytes;       ///< of what is gathered
    sqlite3_int64 begin;  ///< where it belongs
    sqlite3_int64 end;    ///< behind the last write; -1: not known
    bool pageMissing;     ///< the last thing gathered is a frame's header
    bool commit;          ///< of a frame that ends a transaction
};

File& own(sqlite3_file* file) noexcept {
    return *reinterpret_cast<File*>(file);
}
sqlite3_file* below(sqlite3_file* file) noexcept {
    return reinterpret_cast<sqlite3_file*>(reinterpret_cast<File*>(file) + 1);
}
sqlite3_vfs* below(sqlite3_vfs* vfs) noexcept {
    return static_cast<sqlite3_vfs*>(vfs->pAppData);
}

int writeGathered(sqlite3_file* file) noexcept {
    File& log = own(file);
    if (log.size_bytes == 0) {
        return SQLITE_OK;
    }
    const int result = below(file)->pMethods->xWrite(below(file), log.gathered, log.size_bytes, log.begin);
    log.size_bytes = 0;
    log.pageMissing = false;
    log.end = result == SQLITE_OK ? log.end : -1;
    return result;
}

void gather(File& log, const void* bytes, int count, sqlite3_int64 at) noexcept {
    log.begin = log.size_bytes == 0 ? at : log.begin;
    std::memcpy(log.gathered + log.size_bytes, bytes, static_cast<std::size_t>(count));
    log.size_bytes += count;
    log.end = at + count;
}

int writeLog(sqlite3_file* file, const void* bytes, int count, sqlite3_int64 at) {
    File& log = own(file);
    if (log.gathered != nullptr && at == log.end) {
        if (log.pageMissing && count <= kLargestPage_bytes) {
            gather(log, bytes, count, at);
            log.pageMissing = false;
            const bool full = log.size_bytes + kFrameHeader_bytes + kLargestPage_bytes > kRoom_bytes;
            return log.commit || full ? writeGathered(file) : SQLITE_OK;
        }
        if (!log.pageMissing && count == kFrameHeader_bytes) {
            gather(log, bytes, count, at);
            log.pageMissing = true;
            // Bytes 4 to 7: size of the database behind a commit, 0 in all other frames.
            const auto* header = static_cast<const unsigned char*>(bytes);
            log.commit = (header[4] | header[5] | header[6] | header[7]) != 0;
            return SQLITE_OK;
        }
    }
    if (const int result = writeGathered(file); result != SQLITE_OK) {
        return result;
    }
    log.end = at + count;
    return below(file)->pMethods->xWrite(below(file), bytes, count, at);
}

int closeLog(sqlite3_file* file) {
    const int written = writeGathered(file);
    const std::unique_ptr<char[]> gathered(own(file).gathered);
    if (own(file).other != nullptr) {
        own(file).other->other = nullptr;
    }
    const int closed = below(file)->pMethods->xClose(below(file));
    return written != SQLITE_OK ? written : closed;
}

/// A method of the VFS below as it is.
template <auto Method, class... Arguments>
auto same(sqlite3_file* file, Arguments... arguments) {
    return (below(file)->pMethods->*Method)(below(file), arguments...);
}
/// A method of the log: what is gathered goes first.
template <auto Method, class... Arguments>
int after(sqlite3_file* file, Arguments... arguments) {
    const int written = writeGathered(file);
    return written != SQLITE_OK ? written : same<Method>(file, arguments...);
}

/// Locks of the log's index. Frames of a transaction that is rolled back go before its lock does: another connection
/// writes in their place.
int lockIndex(sqlite3_file* file, int offset, int count, int flags) {
    const int written = own(file).other != nullptr ? writeGathered(&own(file).other->base) : SQLITE_OK;
    const bool unlocks = (flags & SQLITE_SHM_UNLOCK) != 0;
    return written != SQLITE_OK && !unlocks ? written : same<&sqlite3_io_methods::xShmLock>(file, offset, count, flags);
}

using Methods = sqlite3_io_methods;

constexpr Methods kLogMethods{
    1,  // memory-mapped pages and the index are the data file's
    closeLog,
    after<&Methods::xRead, void*, int, sqlite3_int64>,
    writeLog,
    after<&Methods::xTruncate, sqlite3_int64>,
    after<&Methods::xSync, int>,
    after<&Methods::xFileSize, sqlite3_int64*>,
    after<&Methods::xLock, int>,
    after<&Methods::xUnlock, int>,
    after<&Methods::xCheckReservedLock, int*>,
    after<&Methods::xFileControl, int, void*>,
    same<&Methods::xSectorSize>,
    same<&Methods::xDeviceCharacteristics>,
    nullptr,
    nullptr,
    nullptr,
    nullptr,
    nullptr,
    nullptr,
};

constexpr Methods kDataMethods{
    3,  // or what is below has
    same<&Methods::xClose>,
    same<&Methods::xRead, void*, int, sqlite3_int64>,
    same<&Methods::xWrite, const void*, int, sqlite3_int64>,
    same<&Methods::xTruncate, sqlite3_int64>,
    same<&Methods::xSync, int>,
    same<&Methods::xFileSize, sqlite3_int64*>,
    same<&Methods::xLock, int>,
    same<&Methods::xUnlock, int>,
    same<&Methods::xCheckReservedLock, int*>,
    same<&Methods::xFileControl, int, void*>,
    same<&Methods::xSectorSize>,
    same<&Methods::xDeviceCharacteristics>,
    same<&Methods::xShmMap, int, int, int, void volatile**>,
    lockIndex,
    same<&Methods::xShmBarrier>,
    same<&Methods::xShmUnmap, int>,
    same<&Methods::xFetch, sqlite3_int64, int, void**>,
    same<&Methods::xUnfetch, sqlite3_int64, void*>,
};

int openFile(sqlite3_vfs* vfs, sqlite3_filename name, sqlite3_file* file, int flags, int* outFlags) {
    const bool isLog = (flags & SQLITE_OPEN_WAL) != 0;
    if (!isLog && (flags & SQLITE_OPEN_MAIN_DB) == 0) {
        return below(vfs)->xOpen(below(vfs), name, file, flags, outFlags);
    }
    file->pMethods = nullptr;
    if (const int opened = below(vfs)->xOpen(below(vfs), name, below(file), flags, outFlags); opened != SQLITE_OK) {
        return opened;
    }
    own(file) = {{}, isLog ? kLogMethods : kDataMethods, nullptr, nullptr, 0, 0, -1, false, false};
    own(file).methods.iVersion = std::min(own(file).methods.iVersion, below(file)->pMethods->iVersion);
    file->pMethods = &own(file).methods;
    if (isLog) {
        own(file).gathered = new (std::nothrow) char[kRoom_bytes];
        own(file).other = &own(sqlite3_database_file_object(name));
        own(file).other->other = &own(file);
    }
    return SQLITE_OK;
}

}  // namespace

bool registerGatheringVfs(const char* name, const char* over) {
    sqlite3_vfs* const under = sqlite3_vfs_find(over);
    if (under == nullptr) {
        return false;
    }
    // Never freed: a connection may be open until the program ends. What a method needs of its VFS is the one below's.
    auto* const vfs = new sqlite3_vfs(*under);
    vfs->zName = name;
    vfs->pNext = nullptr;
    vfs->pAppData = under;
    vfs->szOsFile = static_cast<int>(sizeof(File)) + under->szOsFile;
    vfs->xOpen = openFile;
    vfs->xDelete = [](sqlite3_vfs* v, const char* file, int sync) { return below(v)->xDelete(below(v), file, sync); };
    vfs->xAccess = [](sqlite3_vfs* v, const char* file, int flags, int* result) {
        return below(v)->xAccess(below(v), file, flags, result);
    };
    vfs->xFullPathname = [](sqlite3_vfs* v, const char* file, int size, char* out) {
        return below(v)->xFullPathname(below(v), file, size, out);
    };
    vfs->xGetLastError = [](sqlite3_vfs* v, int size, char* out) {
        return below(v)->xGetLastError(below(v), size, out);
    };
    return sqlite3_vfs_register(vfs, 0) == SQLITE_OK;
}

const char* gatheringVfs() {
    constexpr const char* kName = "kerf-gathering";
    static const bool registered = registerGatheringVfs(kName, nullptr);
    return registered ? kName : nullptr;
}

}  // namespace kerf::db
