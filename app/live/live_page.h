// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

/// The newest live values of a console, for other programs on the same computer.
///
/// A file in the data folder, mapped by both sides. The writer counts a number up before and after it copies its text,
/// and never waits for anybody: whoever reads sees that it was overtaken, and reads again. So no reader, however slow
/// or many, can slow a console. The stamp is the computer's monotonic clock, which nobody sets.
namespace kerf::live {

inline constexpr std::size_t kCapacity = 64 * 1024;

[[nodiscard]] std::string livePagePath(const std::string& dataFolder);
/// Milliseconds of the monotonic clock.
[[nodiscard]] std::int64_t monotonic_ms();

class PageWriter {
 public:
    /// Makes the file when it is missing. Without it (disk full, read-only) write() does nothing.
    explicit PageWriter(const std::string& path);
    ~PageWriter();  ///< leaves an empty page: silent at once
    PageWriter(const PageWriter&) = delete;
    PageWriter& operator=(const PageWriter&) = delete;
    /// At most kCapacity bytes; more is not written. One thread.
    void write(std::string_view text) noexcept;

 private:
    struct Page* m_page{nullptr};
};

struct Snapshot {
    std::string text{};
    std::int64_t age_ms{0};
};

class PageReader {
 public:
    explicit PageReader(std::string path);
    ~PageReader();
    PageReader(const PageReader&) = delete;
    PageReader& operator=(const PageReader&) = delete;
    /// Nothing: no console has written yet, or it has ended, or it is being written faster than it can be read.
    [[nodiscard]] std::optional<Snapshot> read();

 private:
    std::string m_path;
    const struct Page* m_page{nullptr};
};

}  // namespace kerf::live
