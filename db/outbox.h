// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace kerf::db {

/// What could not be stored yet, kept beside the data file (`kerf.db.outbox`) so that neither the end of the program
/// nor of the power loses it. Its room is taken from the disk when it is opened: a full disk stops the data file, not
/// this.
///
/// One line per item, each with its checksum; a line that was cut is not read. One thread, one process: whoever holds
/// the data file's lock.
class Outbox {
 public:
    static constexpr std::int64_t kRoom_bytes = 1 << 20;  ///< some 400 parts of boring

    explicit Outbox(const std::string& databasePath);
    Outbox(const Outbox&) = delete;
    Outbox& operator=(const Outbox&) = delete;
    ~Outbox();

    /// False: there is no room for it on this disk.
    [[nodiscard]] bool usable() const noexcept { return m_file >= 0; }
    /// The items from before, oldest first.
    [[nodiscard]] const std::vector<std::string>& found() const noexcept { return m_found; }
    /// Safely on the disk when it returns true. `text` holds no line end.
    [[nodiscard]] bool add(std::string_view text);
    /// Everything in it has been stored.
    void clear();
    [[nodiscard]] bool empty() const noexcept { return m_used == 0; }

 private:
    void readFound();

    int m_file{-1};
    std::int64_t m_used{0};
    std::vector<std::string> m_found{};
};

}  // namespace kerf::db
