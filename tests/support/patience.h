// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace kerf::test {

/// How long a test waits for what is bound to come, ms: longer where a sanitizer makes everything slow.
constexpr int patience_ms(int plain_ms) {
#ifdef KERF_SANITIZED
    constexpr int kSlower = 10;
#else
    constexpr int kSlower = 1;
#endif
    return kSlower * plain_ms;
}

}  // namespace kerf::test
