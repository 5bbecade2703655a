// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/shop/pg_connection.h"

#include <libpq-fe.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <string_view>

namespace kerf::db {
namespace {

std::int64_t now_ms() {
    using namespace std::chrono;
    return duration_cast<milliseconds>(steady_clock::now().time_since_epoch()).count();
}

PgFailure::Kind kindOf(std::string_view state) {
    const std::string_view family = state.substr(0, 2);
    if (family == "22" || family == "23" || family == "54") {
        return PgFailure::Kind::BadValue;
    }
    if (state == "42501" || family == "28") {
        return PgFailure::Kind::NoRight;
    }
    if (state == "3F000" || state == "42883" || state == "42P01") {
        return PgFailure::Kind::NoSchema;
    }
    if (state.empty() || family == "08" || family == "57" || family == "53" || family == "40" || family == "55" ||
        family == "58") {
        return PgFailure::Kind::Unreachable;
    }
    return PgFailure::Kind::Other;
}

std::string firstLine(const char* text) {
    const std::string whole(text == nullptr ? "" : text);
    return whole.substr(0, whole.find('\n'));
}

struct ResultCloser {
    void operator()(PGresult* result) const noexcept { PQclear(result); }
};
using PgResult = std::unique_ptr<PGresult, ResultCloser>;

struct OptionsCloser {
    void operator()(PQconninfoOption* options) const noexcept { PQconninfoFree(options); }
};

}  // namespace

Interrupt::Interrupt() : m_descriptor(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {}

Interrupt::~Interrupt() {
    ::close(m_descriptor);
}

void Interrupt::trigger() noexcept {
    const std::uint64_t one = 1;
    (void)!::write(m_descriptor, &one, sizeof one);
}

bool Interrupt::triggered() const noexcept {
    return wait(0);
}

bool Interrupt::wait(int timeout_ms) const noexcept {
    pollfd watched{m_descriptor, POLLIN, 0};
    return ::poll(&watched, 1, timeout_ms) > 0;
}

void PgConnection::Closer::operator()(pg_conn* connection) const noexcept {
    PQfinish(connection);
}

PgConnection::PgConnection(const std::string& conninfo, const Interrupt& interrupt, Timeouts timeouts)
    : m_interrupt(interrupt), m_timeouts(timeouts) {
    // The caller's string comes last but one: what it names wins over these, except the encoding.
    const std::array<const char*, 7> keys{
        "tcp_user_timeout", "keepalives_idle", "application_name", "dbname", "client_encoding", nullptr, nullptr};
    const std::array<const char*, 7> values{"20000", "10", "kerf", conninfo.c_str(), "UTF8", nullptr, nullptr};
    m_connection.reset(PQconnectStartParams(keys.data(), values.data(), 1));
    if (!m_connection || PQstatus(m_connection.get()) == CONNECTION_BAD) {
        fail("connect");
    }
    const std::int64_t deadline = now_ms() + m_timeouts.connect_ms;
    for (auto state = PGRES_POLLING_WRITING; state != PGRES_POLLING_OK; state = PQconnectPoll(m_connection.get())) {
        if (state == PGRES_POLLING_FAILED) {
            fail("connect");
        }
        waitFor(state == PGRES_POLLING_WRITING, deadline);
    }
    PQsetnonblocking(m_connection.get(), 1);
    PQsetNoticeProcessor(
        m_connection.get(), [](void*, const char*) {}, nullptr);
}

PgConnection::~PgConnection() = default;

void PgConnection::waitFor(bool write, std::int64_t deadline_ms) {
    std::array<pollfd, 2> watched{
        pollfd{PQsocket(m_connection.get()), static_cast<short>(write ? POLLIN | POLLOUT : POLLIN), 0},
        pollfd{m_interrupt.descriptor(), POLLIN, 0}};
    for (;;) {
        const std::int64_t left_ms = deadline_ms - now_ms();
        const int ready = left_ms <= 0 ? 0 : ::poll(watched.data(), watched.size(), static_cast<int>(left_ms));
        if (watched[1].revents != 0) {
            throw PgFailure(PgFailure::Kind::Interrupted, "ended by the caller");
        }
        if (ready > 0) {
            return;
        }
        if (ready == 0) {
            throw PgFailure(PgFailure::Kind::Unreachable, "the server does not answer");
        }
        if (errno != EINTR) {
            throw PgFailure(PgFailure::Kind::Unreachable, "the socket fails");
        }
    }
}

void PgConnection::fail(const char* doing) {
    const std::string detail = m_connection ? firstLine(PQerrorMessage(m_connection.get())) : "out of memory";
    // A refused log-in has no SQLSTATE in libpq 15; its text is the server's own and begins with FATAL.
    const bool refused =
        detail.find("FATAL:") != std::string::npos && detail.find("starting up") == std::string::npos &&
        detail.find("shutting down") == std::string::npos && detail.find("too many") == std::string::npos &&
        detail.find("terminating") == std::string::npos && detail.find("recovery") == std::string::npos;
    throw PgFailure(refused ? PgFailure::Kind::NoRight : PgFailure::Kind::Unreachable,
                    std::string(doing) + ": " + detail);
}

std::vector<PgRow> PgConnection::query(const std::string& sql, const PgRow& parameters) {
    std::vector<const char*> values;
    values.reserve(parameters.size());
    for (const auto& parameter : parameters) {
        values.push_back(parameter ? parameter->c_str() : nullptr);
    }
    PGconn* connection = m_connection.get();
    if (PQsendQueryParams(connection, sql.c_str(), static_cast<int>(values.size()), nullptr, values.data(), nullptr,
                          nullptr, 0) == 0) {
        fail("send");
    }
    const std::int64_t deadline = now_ms() + m_timeouts.query_ms;
    for (int left = PQflush(connection); left != 0; left = PQflush(connection)) {
        if (left < 0) {
            fail("send");
        }
        waitFor(true, deadline);
        if (PQconsumeInput(connection) == 0) {
            fail("receive");
        }
    }
    std::vector<PgRow> rows;
    std::optional<PgFailure> failure;
    for (;;) {
        while (PQisBusy(connection) != 0) {
            waitFor(false, deadline);
            if (PQconsumeInput(connection) == 0) {
                fail("receive");
            }
        }
        const PgResult result(PQgetResult(connection));
        if (!result) {
            break;
        }
        const ExecStatusType status = PQresultStatus(result.get());
        if (status == PGRES_TUPLES_OK) {
            for (int r = 0; r < PQntuples(result.get()); ++r) {
                PgRow row;
                for (int c = 0; c < PQnfields(result.get()); ++c) {
                    row.push_back(PQgetisnull(result.get(), r, c) != 0
                                      ? std::nullopt
                                      : std::optional(std::string(PQgetvalue(result.get(), r, c))));
                }
                rows.push_back(std::move(row));
            }
        } else if (status != PGRES_COMMAND_OK) {
            const char* state = PQresultErrorField(result.get(), PG_DIAG_SQLSTATE);
            const char* message = PQresultErrorField(result.get(), PG_DIAG_MESSAGE_PRIMARY);
            failure.emplace(kindOf(state == nullptr ? "" : state),
                            firstLine(message == nullptr ? PQresultErrorMessage(result.get()) : message));
        }
    }
    if (failure) {
        throw *failure;
    }
    return rows;
}

std::optional<std::string> PgConnection::value(const std::string& sql, const PgRow& parameters) {
    const std::vector<PgRow> rows = query(sql, parameters);
    return rows.empty() || rows.front().empty() ? std::nullopt : rows.front().front();
}

bool holdsPassword(const std::string& conninfo) {
    const std::unique_ptr<PQconninfoOption, OptionsCloser> options(PQconninfoParse(conninfo.c_str(), nullptr));
    for (const PQconninfoOption* option = options.get(); option != nullptr && option->keyword != nullptr; ++option) {
        if (std::string_view(option->keyword) == "password" && option->val != nullptr) {
            return true;
        }
    }
    return false;
}

std::string conninfoFault(const std::string& conninfo) {
    char* message = nullptr;
    const std::unique_ptr<PQconninfoOption, OptionsCloser> options(PQconninfoParse(conninfo.c_str(), &message));
    if (options) {
        return {};
    }
    const std::string fault = firstLine(message);
    PQfreemem(message);
    return fault.empty() ? "it cannot be read" : fault;
}

}  // namespace kerf::db
