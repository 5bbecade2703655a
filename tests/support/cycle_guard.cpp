// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/cycle_guard.h"

#include <dlfcn.h>
#include <pthread.h>
#include <sys/resource.h>

#include <cerrno>
#include <cstddef>
#include <cstdlib>

namespace {
struct Counts {
    bool armed{false};
    std::uint64_t allocations{0};
    std::uint64_t locks{0};
    std::uint64_t throws{0};
    std::uint64_t faultsBefore{0};
};
thread_local Counts t_counts;

/// Pages this thread has touched for the first time, or again after they were taken away.
std::uint64_t pageFaultsSoFar() noexcept {
    rusage usage{};
    (void)getrusage(RUSAGE_THREAD, &usage);
    return static_cast<std::uint64_t>(usage.ru_minflt) + static_cast<std::uint64_t>(usage.ru_majflt);
}
}  // namespace

namespace kerf::test {

CycleGuard::CycleGuard() noexcept {
    t_counts = Counts{};
    t_counts.faultsBefore = pageFaultsSoFar();
    t_counts.armed = true;
}
CycleGuard::~CycleGuard() {
    t_counts.armed = false;
}
std::uint64_t CycleGuard::allocations() const noexcept {
    return t_counts.allocations;
}
std::uint64_t CycleGuard::locks() const noexcept {
    return t_counts.locks;
}
std::uint64_t CycleGuard::throws() const noexcept {
    return t_counts.throws;
}

std::uint64_t CycleGuard::pageFaults() const noexcept {
    return pageFaultsSoFar() - t_counts.faultsBefore;
}

bool CycleGuard::available() noexcept {
#ifdef KERF_SANITIZED
    return false;
#else
    return true;
#endif
}

}  // namespace kerf::test

#ifndef KERF_SANITIZED
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* block);

void* malloc(std::size_t size) {
    t_counts.allocations += t_counts.armed ? 1U : 0U;
    return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
    t_counts.allocations += t_counts.armed ? 1U : 0U;
    return __libc_calloc(count, size);
}
void* realloc(void* block, std::size_t size) {
    t_counts.allocations += t_counts.armed ? 1U : 0U;
    return __libc_realloc(block, size);
}
void* memalign(std::size_t alignment, std::size_t size) {
    t_counts.allocations += t_counts.armed ? 1U : 0U;
    return __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
    return memalign(alignment, size);
}
int posix_memalign(void** block, std::size_t alignment, std::size_t size) {
    void* found = memalign(alignment, size);
    if (found == nullptr) {
        return ENOMEM;
    }
    *block = found;
    return 0;
}
void free(void* block) {
    t_counts.allocations += (t_counts.armed && block != nullptr) ? 1U : 0U;
    __libc_free(block);
}
int pthread_mutex_lock(pthread_mutex_t* mutex) {
    using Lock = int (*)(pthread_mutex_t*);
    static const Lock real = reinterpret_cast<Lock>(dlsym(RTLD_NEXT, "pthread_mutex_lock"));
    t_counts.locks += t_counts.armed ? 1U : 0U;
    return real(mutex);
}
void __cxa_throw(void* object, void* type, void (*destroy)(void*)) {
    using Throw = void (*)(void*, void*, void (*)(void*));
    static const Throw real = reinterpret_cast<Throw>(dlsym(RTLD_NEXT, "__cxa_throw"));
    t_counts.throws += t_counts.armed ? 1U : 0U;
    real(object, type, destroy);
    std::abort();  // the real one does not return
}
}
#endif
