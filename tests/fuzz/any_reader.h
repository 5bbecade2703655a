// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace kerf::test {

inline constexpr int kReaders = 16;  ///< DFQ is the last

/// Any bytes to any reader: a result, or one sentence. The first byte names the reader, the second its options, so that
/// one corpus serves all. Whatever else is thrown passes; a law that does not hold is thrown as std::logic_error.
void readAnything(std::string_view input);

}  // namespace kerf::test
