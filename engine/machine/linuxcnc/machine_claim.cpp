// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/machine/linuxcnc/machine_claim.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <string>

namespace kerf::linuxcnc {
namespace {

constexpr int kStartTimeField = 22;  // of /proc/<pid>/stat, in clock ticks since the computer's start
constexpr std::uint64_t kLow = 0xFFFF'FFFF;

/// 0: no such process.
std::uint64_t startOf(std::uint32_t process) {
    const int file =
        ::open((std::string("/proc/").append(std::to_string(process)).append("/stat")).c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) {
        return 0;
    }
    std::array<char, 1024> text{};
    const ssize_t got = ::read(file, text.data(), text.size() - 1);
    ::close(file);
    // The name stands in parentheses and may hold blanks: fields are counted from its end.
    const char* at = got > 0 ? std::strrchr(text.data(), ')') : nullptr;
    if (at == nullptr || at[1] == '\0' || at[2] == 'Z') {
        return 0;
    }
    for (int field = 2; at != nullptr && field < kStartTimeField; ++field) {
        at = std::strchr(at + 1, ' ');
    }
    return at == nullptr ? 0 : std::strtoull(at + 1, nullptr, 10) & kLow;
}

}  // namespace

std::uint64_t ownClaim() {
    const auto process = static_cast<std::uint32_t>(::getpid());
    return (static_cast<std::uint64_t>(process) << 32U) | startOf(process);
}

bool alive(std::uint64_t claim) {
    return claim != 0 && startOf(processOf(claim)) == (claim & kLow);
}

bool claim(Claim& owner) {
    const std::uint64_t own = ownClaim();
    std::uint64_t seen = owner.load();
    while (seen != own && !alive(seen)) {
        if (owner.compare_exchange_strong(seen, own)) {
            return true;
        }
    }
    return seen == own;
}

void giveUp(Claim& owner) {
    std::uint64_t own = ownClaim();
    (void)owner.compare_exchange_strong(own, 0);
}

}  // namespace kerf::linuxcnc
