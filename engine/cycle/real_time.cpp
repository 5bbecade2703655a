// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/cycle/real_time.h"

#include <link.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace kerf {
namespace {

constexpr std::size_t kStack_bytes = 256UL * 1024UL;  // far more than any loop uses

[[gnu::noinline]] void touchStack() noexcept {
    std::array<char, kStack_bytes> stack;
    volatile char* const bytes = stack.data();
    for (std::size_t i = 0; i < kStack_bytes; i += 1024) {
        bytes[i] = 0;
    }
}

/// Libraries by an address in each of them.
struct Wanted {
    std::array<std::uintptr_t, 2> addresses{};
};

int populate(dl_phdr_info* info, std::size_t /*size*/, void* data) {
    const auto* wanted = static_cast<const Wanted*>(data);
    const auto pageSize = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
    bool ours = info->dlpi_name == nullptr || *info->dlpi_name == '\0';  // the program itself
    for (int i = 0; i < info->dlpi_phnum && !ours; ++i) {
        const auto& segment = info->dlpi_phdr[i];
        const std::uintptr_t begin = info->dlpi_addr + segment.p_vaddr;
        for (const std::uintptr_t address : wanted->addresses) {
            ours = ours || (segment.p_type == PT_LOAD && address >= begin && address < begin + segment.p_memsz);
        }
    }
    for (int i = 0; i < info->dlpi_phnum && ours; ++i) {
        const auto& segment = info->dlpi_phdr[i];
        if (segment.p_type == PT_LOAD) {
            const std::uintptr_t begin = (info->dlpi_addr + segment.p_vaddr) & ~(pageSize - 1);
            const std::uintptr_t end = info->dlpi_addr + segment.p_vaddr + segment.p_memsz;
            // Older kernels do not know it and say so; then the first cycles touch what they need.
            auto* const from = reinterpret_cast<void*>(begin);  // NOLINT(performance-no-int-to-ptr): an address
            (void)madvise(from, end - begin, MADV_POPULATE_READ);
        }
    }
    return 0;
}

}  // namespace

void prefault() noexcept {
    touchStack();
    double (*const sine)(double) = &std::sin;
    Wanted wanted{{reinterpret_cast<std::uintptr_t>(sine), reinterpret_cast<std::uintptr_t>(&std::malloc)}};
    (void)dl_iterate_phdr(populate, &wanted);
}

bool lockMemory() noexcept {
    return mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT) == 0;
}

}  // namespace kerf
