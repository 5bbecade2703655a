// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace kerf::db {

/// Name of a VFS over SQLite's own in which the frames of one transaction go into the write-ahead log in one write:
/// SQLite writes each frame's header and page apart, 24 writes for an accepted measurement. Nothing else is changed.
///
/// What is gathered is written before the write of a commit's last page returns, with that write's result, and before
/// anything else is done with the log (read, sync, truncate, size, close) or with the locks of its index, in the order
/// in which it came. So whatever `synchronous` is, nothing that is committed stands here alone, nothing is written once
/// the transaction's lock is gone, and a program that is killed leaves what it would have left a moment earlier without
/// this.
///
/// Any thread; registered at the first call. Null: SQLite refused, and its own does as well.
[[nodiscard]] const char* gatheringVfs();

/// The same over another VFS, under another name; for tests. False: there is no such VFS.
[[nodiscard]] bool registerGatheringVfs(const char* name, const char* over);

}  // namespace kerf::db
