// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonArray>
#include <QJsonObject>
#include <QString>
#include <QTranslator>
#include <memory>
#include <vector>

#include "app/gateway/documents.h"
#include "app/live/live_page.h"

namespace kerf::db {
class Connection;
}

namespace kerf::gateway {

/// Everything a gateway knows of one console: live values from its live page, the rest from its data file, read only.
class ConsoleSource {
 public:
    /// A page older than this is silent. With the time between two looks it stays well within two seconds.
    static constexpr std::int64_t kSilent_ms = 1500;

    explicit ConsoleSource(const std::string& dataFolder);
    ~ConsoleSource();
    ConsoleSource(const ConsoleSource&) = delete;
    ConsoleSource& operator=(const ConsoleSource&) = delete;

    /// Looks at the live page; a few times per second.
    void readLive(Observations& observations);
    /// Looks at the data file; about once a second. False: it cannot be read.
    bool readFile(Observations& observations);

    [[nodiscard]] bool silent() const { return m_silent; }
    [[nodiscard]] std::int64_t age_ms() const;
    [[nodiscard]] const Device& device() const { return m_device; }
    [[nodiscard]] const std::vector<PartAsset>& assets() const { return m_assets; }
    /// What the board shows of this machine.
    [[nodiscard]] QJsonObject board() const;

 private:
    void takeOver(const QJsonObject& live, Observations& observations);
    void readParts(Observations& observations);
    void readAlarms(Observations& observations);

    std::string m_file;
    live::PageReader m_page;
    std::unique_ptr<db::Connection> m_connection;
    Device m_device{};
    bool m_silent{true};
    std::int64_t m_lastLive_ms{0};  ///< monotonic; 0: never
    QJsonObject m_live{};
    Value m_alarms{};
    Value m_bore{};
    Value m_partCount{};
    Value m_partId{};
    QJsonArray m_lastParts{};
    QJsonArray m_openAlarms{};
    QTranslator m_korean{};
    std::vector<PartAsset> m_assets{};
};

}  // namespace kerf::gateway
