// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/live/live_page.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstring>

namespace kerf::live {

constexpr std::uint64_t kMagic = 0x314556494C46524BULL;  // "KRFLIVE1"
constexpr std::size_t kWords = kCapacity / 8;

/// Text in words that are each atomic: both sides may touch them at the same time without a data race.
struct Page {
    std::atomic<std::uint64_t> magic;
    std::atomic<std::uint64_t> turn;  ///< odd while being written
    std::atomic<std::int64_t> stamp_ms;
    std::atomic<std::uint64_t> length;
    std::array<std::atomic<std::uint64_t>, kWords> words;
};
static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

std::string livePagePath(const std::string& dataFolder) {
    return dataFolder + "/live.page";
}

std::int64_t monotonic_ms() {
    timespec now{};
    ::clock_gettime(CLOCK_MONOTONIC, &now);
    return static_cast<std::int64_t>(now.tv_sec) * 1000 + now.tv_nsec / 1000000;
}

PageWriter::PageWriter(const std::string& path) {
    const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (file < 0) {
        return;
    }
    // Allocated, not only sized: writing into a hole on a full disk would end the program.
    if (::posix_fallocate(file, 0, sizeof(Page)) == 0) {
        void* place = ::mmap(nullptr, sizeof(Page), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
        m_page = place == MAP_FAILED ? nullptr : static_cast<Page*>(place);
    }
    ::close(file);
    if (m_page != nullptr) {
        // A writer that was killed in the middle has left an odd turn.
        m_page->turn.store((m_page->turn.load() + 1) & ~std::uint64_t{1});
        m_page->magic.store(kMagic);
    }
}

PageWriter::~PageWriter() {
    if (m_page != nullptr) {
        write({});
        ::munmap(m_page, sizeof(Page));
    }
}

void PageWriter::write(std::string_view text) noexcept {
    if (m_page == nullptr || text.size() > kCapacity) {
        return;
    }
    const std::uint64_t turn = m_page->turn.load(std::memory_order_relaxed);
    m_page->turn.store(turn + 1, std::memory_order_relaxed);
    std::atomic_thread_fence(std::memory_order_release);
    for (std::size_t at = 0; at < text.size(); at += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, text.data() + at, std::min<std::size_t>(8, text.size() - at));
        m_page->words[at / 8].store(word, std::memory_order_relaxed);
    }
    m_page->length.store(text.size(), std::memory_order_relaxed);
    m_page->stamp_ms.store(monotonic_ms(), std::memory_order_relaxed);
    m_page->turn.store(turn + 2, std::memory_order_release);
}

PageReader::PageReader(std::string path) : m_path(std::move(path)) {}

PageReader::~PageReader() {
    if (m_page != nullptr) {
        ::munmap(const_cast<Page*>(m_page), sizeof(Page));
    }
}

std::optional<Snapshot> PageReader::read() {
    if (m_page == nullptr) {
        const int file = ::open(m_path.c_str(), O_RDONLY | O_CLOEXEC);
        if (file < 0) {
            return std::nullopt;
        }
        struct stat size {};
        if (::fstat(file, &size) == 0 && size.st_size >= static_cast<off_t>(sizeof(Page))) {
            const void* place = ::mmap(nullptr, sizeof(Page), PROT_READ, MAP_SHARED, file, 0);
            m_page = place == MAP_FAILED ? nullptr : static_cast<const Page*>(place);
        }
        ::close(file);
        if (m_page == nullptr) {
            return std::nullopt;
        }
    }
    for (int attempt = 0; attempt < 5; ++attempt) {
        const std::uint64_t turn = m_page->turn.load(std::memory_order_acquire);
        const std::uint64_t length = m_page->length.load(std::memory_order_relaxed);
        if ((turn & 1) != 0 || length > kCapacity) {
            continue;
        }
        Snapshot snapshot;
        snapshot.text.resize(length);
        for (std::size_t at = 0; at < length; at += 8) {
            const std::uint64_t word = m_page->words[at / 8].load(std::memory_order_relaxed);
            std::memcpy(snapshot.text.data() + at, &word, std::min<std::size_t>(8, length - at));
        }
        snapshot.age_ms = monotonic_ms() - m_page->stamp_ms.load(std::memory_order_relaxed);
        std::atomic_thread_fence(std::memory_order_acquire);
        if (m_page->turn.load(std::memory_order_relaxed) == turn) {
            const bool live =
                length > 0 && m_page->magic.load(std::memory_order_relaxed) == kMagic && snapshot.age_ms >= 0;
            return live ? std::optional(std::move(snapshot)) : std::nullopt;
        }
    }
    return std::nullopt;
}

}  // namespace kerf::live
