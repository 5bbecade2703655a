// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "engine/core/result.h"

namespace kerf::linuxcnc {

/// What linuxcncrsh wants to hear (its options --connectpw and --enablepw): its well-known words unless told otherwise.
struct RshPassword {
    std::string connect{"EMC"};
    std::string enable{"EMCTOO"};
};

/// From a file of two lines, connect and enable, that nobody but its owner may read (mode 0600); an empty name gives
/// the well-known words. Refused: a file that others may read, a missing or empty line, blanks in a word.
[[nodiscard]] Result<RshPassword> readRshPassword(const std::string& file);

}  // namespace kerf::linuxcnc
