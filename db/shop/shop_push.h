// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>

#include "db/connection.h"
#include "db/shop/outbox.h"
#include "db/shop/pg_connection.h"

namespace kerf::db {

/// Why nothing goes to the shop at present.
enum class ShopTrouble : std::uint8_t {
    None,
    Unreachable,   ///< no server or no way to it
    NotPrepared,   ///< no schema there: kerf shop init
    NotAllowed,    ///< not enrolled, or the log-in is refused
    NewerConsole,  ///< this console has columns the shop's schema does not know yet: it waits
    DataFile,      ///< this console's own file cannot be read
    Interrupted,
};

class ShopFailure : public std::runtime_error {
 public:
    ShopFailure(ShopTrouble trouble, const std::string& detail) : std::runtime_error(detail), m_trouble(trouble) {}
    [[nodiscard]] ShopTrouble trouble() const noexcept { return m_trouble; }

 private:
    ShopTrouble m_trouble;
};

/// How far the shop has this console's history.
struct ShopProgress {
    struct Stream {
        std::int64_t last{0};    ///< acknowledged by the server
        std::int64_t newest{0};  ///< in the outbox
        [[nodiscard]] std::int64_t unsent() const noexcept { return newest > last ? newest - last : 0; }
    };
    ShopIdentity identity{};
    std::array<Stream, 2> streams{};  ///< by ShopStream
    std::int64_t entriesSent{0};      ///< by this object
    std::int64_t setAside{0};         ///< rows the server could not take, by this object
    std::int64_t clockOffset_ms{0};   ///< this computer's clock minus the server's, at connect
    bool newEpoch{false};             ///< this connection found another history under the same identity
    [[nodiscard]] std::int64_t unsent() const noexcept { return streams[0].unsent() + streams[1].unsent(); }
};

/// Pushes a data file's outbox to the shop, one batch in flight, each row exactly once: the server says how far it is,
/// and skips what it has. Reads the file only, except that a new epoch is noted in it. A row the server cannot take is
/// found by halving the batch, put aside there with the reason, and the rest goes on. One thread.
class ShopPush {
 public:
    static constexpr std::size_t kMaxEntries = 500;
    static constexpr std::size_t kMaxBytes = 1'000'000;

    ShopPush(std::string dataFile, std::string conninfo, const Interrupt& interrupt);
    ~ShopPush();

    /// Logs in, compares histories, begins a new epoch when they differ. @throws ShopFailure
    void connect();
    /// Sends one batch; false when there is nothing left. @throws ShopFailure; connect() again after that
    bool step();
    /// Tells the server that this console is there; for quiet times. @throws ShopFailure
    void greet();
    [[nodiscard]] const ShopProgress& progress() const noexcept { return m_progress; }

 private:
    struct Answer;
    void introduce();
    /// Why the server's history is not this file's; empty when it is.
    [[nodiscard]] std::string mismatch(const Answer& answer) const;
    [[nodiscard]] Answer call(std::int64_t firstSeq, const std::string& batch);
    bool send(ShopStream stream);

    std::string m_dataFile;
    std::string m_conninfo;
    const Interrupt& m_interrupt;
    std::unique_ptr<Connection> m_file;
    std::unique_ptr<OutboxReader> m_outbox;
    std::unique_ptr<PgConnection> m_server;
    ShopProgress m_progress{};
    std::array<std::size_t, 2> m_limit{kMaxEntries, kMaxEntries};
    int m_introductions{0};  ///< since the last batch that was taken
};

}  // namespace kerf::db
