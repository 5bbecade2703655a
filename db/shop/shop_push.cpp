// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/shop/shop_push.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "db/statement.h"

namespace kerf::db {
namespace {

constexpr int kMaxIntroductions = 4;
constexpr auto kStreams = {ShopStream::Rows, ShopStream::Traces};

std::size_t indexOf(ShopStream stream) {
    return static_cast<std::size_t>(stream);
}

[[noreturn]] void rethrow(const PgFailure& failure) {
    using Kind = PgFailure::Kind;
    const ShopTrouble trouble = failure.kind() == Kind::Interrupted ? ShopTrouble::Interrupted
                                : failure.kind() == Kind::NoRight   ? ShopTrouble::NotAllowed
                                : failure.kind() == Kind::NoSchema  ? ShopTrouble::NotPrepared
                                                                    : ShopTrouble::Unreachable;
    throw ShopFailure(trouble, failure.what());
}

std::string batchText(ShopStream stream, const OutboxBatch& batch, const std::string& previousMark) {
    std::string text = fmt::format(R"({{"stream":"{}","previous_mark":{},"marks":[{}],"tables":{{)", streamKey(stream),
                                   previousMark, fmt::join(batch.marks, ","));
    std::map<std::string, std::string> tables;
    for (const OutboxRow& row : batch.rows) {
        if (!row.json.empty()) {
            std::string& rows = tables[row.table];
            rows += fmt::format(R"({}{{"seq":{},{}}})", rows.empty() ? "" : ",", row.seq, row.json);
        }
    }
    bool first = true;
    for (const auto& [name, rows] : tables) {
        text += fmt::format("{}{}:[{}]", first ? "" : ",", jsonText(name), rows);
        first = false;
    }
    return text + "}}";
}

/// One entry put aside: its number is taken, its row kept as a text.
std::string asideText(ShopStream stream, const OutboxBatch& batch, const std::string& previousMark,
                      const std::string& reason) {
    const OutboxRow& row = batch.rows.front();
    return fmt::format(
        R"({{"stream":"{}","previous_mark":{},"marks":[{}],"tables":{{}},"aside":[{{"seq":{},"table":{},"key":{},"reason":{},"row":{}}}]}})",
        streamKey(stream), previousMark, batch.marks.front(), row.seq, jsonText(row.table), jsonText(row.key),
        jsonText(reason), jsonText("{" + row.json + "}"));
}

}  // namespace

/// The server's answer to one call.
struct ShopPush::Answer {
    nlohmann::json document{};
    [[nodiscard]] std::string status() const { return document.value("status", ""); }
    [[nodiscard]] std::int64_t last(ShopStream stream) const {
        return document["streams"][streamKey(stream)]["last_seq"].get<std::int64_t>();
    }
    template <class T>
    [[nodiscard]] std::optional<T> maybe(ShopStream stream, const char* key) const {
        const nlohmann::json& value = document["streams"][streamKey(stream)][key];
        return value.is_null() ? std::nullopt : std::optional(value.get<T>());
    }
};

ShopPush::ShopPush(std::string dataFile, std::string conninfo, const Interrupt& interrupt)
    : m_dataFile(std::move(dataFile)), m_conninfo(std::move(conninfo)), m_interrupt(interrupt) {}

ShopPush::~ShopPush() {
    m_outbox.reset();  // its statements before their connection
}

ShopPush::Answer ShopPush::call(std::int64_t firstSeq, const std::string& batch) {
    const auto text =
        m_server->value("SELECT shop.ingest($1, $2, $3, $4)",
                        {m_progress.identity.store, m_progress.identity.epoch, std::to_string(firstSeq), batch});
    Answer answer;
    answer.document = nlohmann::json::parse(text.value_or(""), nullptr, false);
    if (!answer.document.is_object() || !answer.document["streams"].is_object()) {
        throw ShopFailure(ShopTrouble::NotPrepared, "the server's answer cannot be read");
    }
    return answer;
}

void ShopPush::connect() {
    m_outbox.reset();
    m_server.reset();
    try {
        m_file = std::make_unique<Connection>(m_dataFile, Access::Read);
        m_outbox = std::make_unique<OutboxReader>(m_file->database());
        m_server = std::make_unique<PgConnection>(m_conninfo, m_interrupt);
        m_introductions = 0;
        introduce();
    } catch (const PgFailure& failure) {
        rethrow(failure);
    } catch (const SqlFailure& failure) {
        throw ShopFailure(ShopTrouble::DataFile, failure.what());
    }
}

void ShopPush::introduce() {
    if (++m_introductions > kMaxIntroductions) {
        throw ShopFailure(ShopTrouble::Unreachable, "another program pushes this history at the same time");
    }
    m_progress.identity = m_outbox->identity();
    const std::int64_t sent_ms = utcNow_ms();
    const Answer answer = call(
        0, fmt::format(R"({{"hello":{{"reason":{},"began_utc_ms":{},"program":"{}","utc_ms":{}}}}})",
                       jsonText(m_progress.identity.reason), m_progress.identity.began_utc_ms, KERF_VERSION, sent_ms));
    // Half of the way there and back is taken for the way there.
    m_progress.clockOffset_ms = (sent_ms + utcNow_ms()) / 2 - answer.document.value("utc_ms", sent_ms);
    for (const FollowedTable& table : followedTables()) {
        const nlohmann::json known = answer.document["tables"].value(table.name, nlohmann::json::array());
        const std::set<std::string> names = known.get<std::set<std::string>>();
        for (const std::string& column : m_outbox->columns(table.name)) {
            if (!names.contains(column)) {
                throw ShopFailure(
                    ShopTrouble::NewerConsole,
                    fmt::format("the shop's schema does not know {}.{} yet; bring it up to date with \"kerf "
                                "shop init\" of this version",
                                table.name, column));
            }
        }
    }
    if (const std::string why = mismatch(answer); !why.empty()) {
        beginShopEpoch(m_dataFile, why);
        m_progress.newEpoch = true;
        introduce();
        return;
    }
    for (const ShopStream stream : kStreams) {
        m_progress.streams[indexOf(stream)] = {answer.last(stream), m_outbox->newestSeq(stream)};
    }
}

void ShopPush::greet() {
    try {
        m_introductions = 0;
        introduce();
    } catch (const PgFailure& failure) {
        rethrow(failure);
    } catch (const SqlFailure& failure) {
        throw ShopFailure(ShopTrouble::DataFile, failure.what());
    }
}

std::string ShopPush::mismatch(const Answer& answer) const {
    for (const ShopStream stream : kStreams) {
        const std::int64_t last = answer.last(stream);
        if (last == 0) {
            continue;
        }
        const auto mark = m_outbox->markAt(stream, last);
        if (!mark) {
            return fmt::format("an older copy: the shop has {} up to {}, this file ends at {}", streamKey(stream), last,
                               m_outbox->newestSeq(stream));
        }
        if (mark != answer.maybe<std::int64_t>(stream, "last_mark")) {
            return fmt::format("another history: {} {} is not what the shop was sent", streamKey(stream), last);
        }
    }
    const auto head = answer.maybe<std::string>(ShopStream::Rows, "audit_head");
    if (head && !m_outbox->hasAuditHead(*head, answer.last(ShopStream::Rows))) {
        return "another history: the audit log is not the one the shop was sent";
    }
    return {};
}

bool ShopPush::step() {
    try {
        return send(ShopStream::Rows) || send(ShopStream::Traces);
    } catch (const PgFailure& failure) {
        rethrow(failure);
    } catch (const SqlFailure& failure) {
        throw ShopFailure(ShopTrouble::DataFile, failure.what());
    }
}

bool ShopPush::send(ShopStream stream) {
    ShopProgress::Stream& place = m_progress.streams[indexOf(stream)];
    std::size_t& limit = m_limit[indexOf(stream)];
    place.newest = m_outbox->newestSeq(stream);
    if (place.unsent() == 0) {
        return false;
    }
    const std::int64_t first = place.last + 1;
    const OutboxBatch batch = m_outbox->batch(stream, first, limit, kMaxBytes);
    const auto mark = m_outbox->markAt(stream, place.last);  // numbers begin with 1: none before the first
    const std::string previousMark = mark.has_value() ? std::to_string(mark.value()) : std::string("null");
    bool aside = false;
    Answer answer;
    try {
        answer = call(first, batchText(stream, batch, previousMark));
    } catch (const PgFailure& failure) {
        if (failure.kind() != PgFailure::Kind::BadValue) {
            throw;
        }
        if (batch.marks.size() > 1) {
            limit = batch.marks.size() / 2;
            return true;
        }
        aside = true;
        answer = call(first, asideText(stream, batch, previousMark, failure.what()));
    }
    if (answer.status() != "ok") {
        introduce();  // somebody else was here, or the server is an older one than it was
        return true;
    }
    m_introductions = 0;
    m_progress.entriesSent += answer.last(stream) - place.last;
    m_progress.setAside += aside ? 1 : 0;
    place.last = answer.last(stream);
    limit = std::min(kMaxEntries, limit * 2);
    return true;
}

}  // namespace kerf::db
