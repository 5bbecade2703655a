// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>

/// Who commands a machine. The bridge's memory holds one claim: process and its start time, so that a number given out
/// again is not taken for the same program.
namespace kerf::linuxcnc {

using Claim = std::atomic<std::uint64_t>;  ///< 0: nobody

/// What this process writes into a claim.
[[nodiscard]] std::uint64_t ownClaim();
/// The process of a claim.
[[nodiscard]] inline std::uint32_t processOf(std::uint64_t claim) noexcept {
    return static_cast<std::uint32_t>(claim >> 32U);
}
/// The program of this claim still runs. Looks into /proc: never in the cycle.
[[nodiscard]] bool alive(std::uint64_t claim);

/// Claims what is free, or whose owner has died; never what a living program holds. True when it is ours now. Called
/// when a program is started, which is a person's act: nobody takes a machine over by himself later on.
[[nodiscard]] bool claim(Claim& owner);
/// Cycle: claims again in a new bridge's memory, where nobody has been before us.
[[nodiscard]] inline bool claimIfFree(Claim& owner, std::uint64_t own) noexcept {
    std::uint64_t nobody = 0;
    return owner.compare_exchange_strong(nobody, own) || nobody == own;
}
/// Ours no longer; another one's is left alone.
void giveUp(Claim& owner);

}  // namespace kerf::linuxcnc
