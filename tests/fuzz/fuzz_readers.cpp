// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>

#include "tests/fuzz/any_reader.h"

/// What a sanitizer finds, whatever is thrown, a hang or 1 GB ends the campaign (scripts/fuzz).
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    kerf::test::readAnything({reinterpret_cast<const char*>(data), size});
    return 0;
}
