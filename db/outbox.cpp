// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/outbox.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <QByteArray>
#include <charconv>

namespace kerf::db {
namespace {

constexpr std::size_t kBlock = 4096;
constexpr std::size_t kChecksumDigits = 4;

std::string checksum(std::string_view text) {
    return fmt::format("{:04x}", qChecksum(QByteArrayView(text.data(), static_cast<qsizetype>(text.size()))));
}

bool writeAll(int file, std::string_view bytes, std::int64_t at) {
    while (!bytes.empty()) {
        const ssize_t done = ::pwrite(file, bytes.data(), bytes.size(), at);
        if (done <= 0) {
            return false;
        }
        bytes.remove_prefix(static_cast<std::size_t>(done));
        at += done;
    }
    return true;
}

}  // namespace

Outbox::Outbox(const std::string& databasePath) {
    m_file = ::open((databasePath + ".outbox").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (m_file < 0) {
        return;
    }
    readFound();
    if (::posix_fallocate(m_file, 0, kRoom_bytes) != 0 && m_used == 0) {
        ::close(m_file);  // what was found before is read and stays where it is
        m_file = -1;
    }
}

Outbox::~Outbox() {
    if (m_file >= 0) {
        ::close(m_file);
    }
}

void Outbox::readFound() {
    std::string text(static_cast<std::size_t>(kRoom_bytes), '\0');
    const ssize_t got = ::pread(m_file, text.data(), text.size(), 0);
    text.resize(static_cast<std::size_t>(got < 0 ? 0 : got));
    std::size_t from = 0;
    for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', from)) {
        const std::string_view line = std::string_view(text).substr(from, end - from);
        if (line.size() <= kChecksumDigits + 1 || checksum(line.substr(kChecksumDigits + 1)) != line.substr(0, 4)) {
            break;
        }
        m_found.emplace_back(line.substr(kChecksumDigits + 1));
        from = end + 1;
    }
    m_used = static_cast<std::int64_t>(from);
}

bool Outbox::add(std::string_view text) {
    const std::string line = checksum(text) + ' ' + std::string(text) + '\n';
    if (m_file < 0 || m_used + static_cast<std::int64_t>(line.size()) > kRoom_bytes ||
        !writeAll(m_file, line, m_used) || ::fdatasync(m_file) != 0) {
        return false;
    }
    m_used += static_cast<std::int64_t>(line.size());
    return true;
}

void Outbox::clear() {
    if (m_file < 0 || m_used == 0) {
        return;
    }
    // A first line that does not check ends the reading; the whole is made zero so that nothing comes back later.
    const std::string zeros(kBlock, '\0');
    for (std::int64_t at = 0; at < m_used; at += static_cast<std::int64_t>(kBlock)) {
        (void)writeAll(m_file, zeros, at);
    }
    (void)::fdatasync(m_file);
    m_used = 0;
}

}  // namespace kerf::db
