// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/head_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <QByteArray>
#include <array>
#include <nlohmann/json.hpp>

#include "db/statement.h"

namespace kerf::db {
namespace {

constexpr std::size_t kPlace = 1024;  // bytes

std::string checksum(const std::string& text) {
    return fmt::format("{:04x}", qChecksum(QByteArrayView(text.data(), static_cast<qsizetype>(text.size()))));
}

struct Placed {
    std::uint64_t turn{0};
    Head head{};
};

std::optional<Placed> placedAt(const std::string& block) {
    const std::size_t end = block.find('\n');
    if (end == std::string::npos || end < 6 || checksum(block.substr(5, end - 5)) != block.substr(0, 4)) {
        return std::nullopt;
    }
    const auto json = nlohmann::json::parse(block.substr(5, end - 5), nullptr, false);
    if (!json.is_object()) {
        return std::nullopt;
    }
    Placed placed;
    placed.turn = json.value("turn", std::uint64_t{0});
    placed.head.auditId = json.value("audit_id", std::int64_t{0});
    placed.head.auditHash = json.value("audit_hash", std::string());
    placed.head.rows = json.value("rows", std::map<std::string, std::int64_t>{});
    return placed;
}

std::optional<Placed> newest(const std::string& path) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) {
        return std::nullopt;
    }
    std::optional<Placed> best;
    for (std::size_t place = 0; place < 2; ++place) {
        std::string block(kPlace, '\0');
        if (::pread(file, block.data(), kPlace, static_cast<off_t>(place * kPlace)) > 0) {
            const auto placed = placedAt(block);
            best = placed && (!best || placed->turn > best->turn) ? placed : best;
        }
    }
    ::close(file);
    return best;
}

}  // namespace

Head headOf(const QSqlDatabase& database) {
    Head head;
    Statement audit(database, "SELECT id, hash FROM audit ORDER BY id DESC LIMIT 1");
    if (audit.run().next()) {
        head.auditId = audit.integer(0);
        head.auditHash = audit.text(1);
    }
    // Of tables that SQLite keeps no highest number for (migration 008) it is that of the newest row.
    Statement rows(database,
                   "SELECT name, seq FROM sqlite_sequence UNION ALL SELECT 'measurements', max(id) FROM measurements "
                   "UNION ALL SELECT 'estimator_states', max(id) FROM estimator_states UNION ALL SELECT 'audit', "
                   "max(id) FROM audit UNION ALL SELECT 'outbox', max(seq) FROM outbox");
    rows.run();
    while (rows.next()) {
        if (!rows.isNull(1)) {
            head.rows[rows.text(0)] = rows.integer(1);
        }
    }
    return head;
}

HeadFile::~HeadFile() {
    if (m_file >= 0) {
        (void)::fdatasync(m_file);
        ::close(m_file);
    }
}

std::optional<Head> HeadFile::read() const {
    const auto placed = newest(m_path);
    return placed ? std::optional(placed->head) : std::nullopt;
}

void HeadFile::write(const Head& head) noexcept {
    if (m_file < 0) {
        const auto before = newest(m_path);
        m_turn = before ? before->turn : 0;
        m_file = ::open(m_path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
    } else if (head == m_last) {
        return;
    }
    if (m_file < 0) {
        return;
    }
    m_last = head;
    ++m_turn;
    const nlohmann::json json{
        {"turn", m_turn}, {"audit_id", head.auditId}, {"audit_hash", head.auditHash}, {"rows", head.rows}};
    const std::string text = json.dump();
    std::string block = checksum(text) + ' ' + text + '\n';
    block.resize(kPlace, ' ');
    (void)!::pwrite(m_file, block.data(), kPlace, static_cast<off_t>((m_turn % 2) * kPlace));
}

Sentence missingSince(const Head& expected, const QSqlDatabase& database) {
    const Head now = headOf(database);
    const auto number = [](std::int64_t value) { return SentenceArg(static_cast<double>(value), 0); };
    Statement entry(database, "SELECT hash FROM audit WHERE id = ?");
    if (expected.auditId > 0 && !entry.bind(expected.auditId).run().next()) {
        return Sentence(
            KERF_TEXT("The newest entries are missing: %1 had been written to the audit log, it ends at %2. A "
                      "log file (-wal) was cut or deleted, or an older copy was put back."),
            number(expected.auditId), number(now.auditId));
    }
    if (expected.auditId > 0 && entry.text(0) != expected.auditHash) {
        return Sentence(KERF_TEXT("Audit entry %1 is not the one that had been written: this is another file."),
                        number(expected.auditId));
    }
    for (const auto& [table, rows] : expected.rows) {
        const auto found = now.rows.find(table);
        const std::int64_t left = found == now.rows.end() ? 0 : found->second;
        if (left < rows) {
            return Sentence(KERF_TEXT("The newest rows of %1 are missing: %2 had been written, %3 are left. A log file "
                                      "(-wal) was cut or deleted, or an older copy was put back."),
                            SentenceArg(table), number(rows), number(left));
        }
    }
    return {};
}

}  // namespace kerf::db
