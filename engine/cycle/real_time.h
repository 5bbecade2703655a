// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace kerf {

/// Takes first touches of memory out of the cycle: the calling thread's stack to come (256 KB), and the code of the
/// program and of the C and mathematics libraries. What the engine's objects hold has been touched by their
/// constructors. Call on the thread that will run the cycle, before its first one; takes milliseconds.
void prefault() noexcept;

/// Keeps every page this process has touched, or will touch, in memory (mlockall, on fault: nothing is brought in that
/// nobody uses). False where the system does not allow it; the cycle then runs as before, and a page that was swapped
/// out makes it late.
[[nodiscard]] bool lockMemory() noexcept;

}  // namespace kerf
