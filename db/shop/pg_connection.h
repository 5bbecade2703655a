// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

struct pg_conn;

namespace kerf::db {

/// Ends waits for a server from another thread, at once and for good.
class Interrupt {
 public:
    Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;
    ~Interrupt();
    void trigger() noexcept;
    [[nodiscard]] bool triggered() const noexcept;
    [[nodiscard]] int descriptor() const noexcept { return m_descriptor; }
    /// Waits for the trigger; true when it has come.
    bool wait(int timeout_ms) const noexcept;

 private:
    int m_descriptor;
};

/// What went wrong between here and the server.
class PgFailure : public std::runtime_error {
 public:
    enum class Kind : std::uint8_t {
        Unreachable,  ///< no server, link cut, server ending, time is up: try again later
        Interrupted,
        BadValue,  ///< the server cannot take a value (SQLSTATE classes 22, 23, 54): the same row fails again
        NoRight,   ///< not enrolled, not allowed
        NoSchema,  ///< no schema or function "shop" there
        Other,
    };
    PgFailure(Kind kind, const std::string& detail) : std::runtime_error(detail), m_kind(kind) {}
    [[nodiscard]] Kind kind() const noexcept { return m_kind; }

 private:
    Kind m_kind;
};

using PgRow = std::vector<std::optional<std::string>>;

/// One connection to PostgreSQL, text in and out. Every wait ends after its time or by the interrupt, which is why this
/// is libpq's asynchronous side and not Qt's driver: a cut link must not hold up a console that is being closed.
class PgConnection {
 public:
    struct Timeouts {
        int connect_ms{10000};
        int query_ms{60000};
    };
    /// `conninfo` as libpq takes it (key=value or URI). @throws PgFailure
    PgConnection(const std::string& conninfo, const Interrupt& interrupt, Timeouts timeouts);
    PgConnection(const std::string& conninfo, const Interrupt& interrupt)
        : PgConnection(conninfo, interrupt, Timeouts{}) {}
    ~PgConnection();
    PgConnection(const PgConnection&) = delete;
    PgConnection& operator=(const PgConnection&) = delete;

    /// One statement; parameters are $1, $2 … @throws PgFailure
    std::vector<PgRow> query(const std::string& sql, const PgRow& parameters = {});
    /// First column of the first row; empty when there is none or it is null.
    std::optional<std::string> value(const std::string& sql, const PgRow& parameters = {});

 private:
    struct Closer {
        void operator()(pg_conn* connection) const noexcept;
    };
    /// Waits until the socket can be read (or written); throws when time is up or somebody wants to end.
    void waitFor(bool write, std::int64_t deadline_ms);
    [[noreturn]] void fail(const char* doing);

    std::unique_ptr<pg_conn, Closer> m_connection;
    const Interrupt& m_interrupt;
    Timeouts m_timeouts;
};

/// True when the connection string carries a password, which everybody on the computer could read.
[[nodiscard]] bool holdsPassword(const std::string& conninfo);
/// Why libpq cannot read it; empty when it can.
[[nodiscard]] std::string conninfoFault(const std::string& conninfo);

}  // namespace kerf::db
