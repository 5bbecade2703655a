// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "engine/core/result.h"

/// A backup in the place of the data file. It is checked and laid ready while the console works, and takes its place at
/// the next start, under the data file's lock and before anything else opens it: no running program loses its file.
///
/// What was there is set aside under a name of its own, never deleted; who has put it back, and why, stands in the
/// audit log of the restored file. A stop of the computer in between leaves the one file or the other, whole.
namespace kerf::db {

struct RestoreRequest {
    std::string backup{};  ///< file
    std::string author{};
    std::string reason{};
};

/// Checks the backup as checkDatabase() does and lays it ready beside `path`; an earlier one that waits is replaced.
/// Refused: no data file of Kerf's, of a later version, damaged, or its log does not agree with its rows.
[[nodiscard]] Result<void> layReady(const std::string& path, const RestoreRequest& request);

struct Restored {
    RestoreRequest request{};
    std::string setAside{};  ///< where the file is that was there; empty: there was none
};

/// Puts what lies ready in place. Empty: nothing does. @pre the data file's lock is held and nobody has it open
[[nodiscard]] Result<std::optional<Restored>> putInPlace(const std::string& path);

}  // namespace kerf::db
