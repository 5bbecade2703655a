// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QObject>
#include <QTimer>
#include <set>
#include <vector>

#include "app/gateway/console_source.h"
#include "app/gateway/http_server.h"

namespace kerf::gateway {

struct GatewayOptions {
    std::string dataFolder{};
    std::size_t bufferSize{131072};
    int period_ms{100};                     ///< between two looks at the console's page
    std::vector<QByteArray> tokenHashes{};  ///< SHA-256 of each device's token; empty: no token is asked for
};

/// One console for everybody else: MTConnect, SHDR and the board. Nothing can be written through it.
class Gateway : public QObject {
    Q_OBJECT
 public:
    explicit Gateway(GatewayOptions options, QObject* parent = nullptr);
    void serve(const HttpRequest& request, HttpClient& client);
    [[nodiscard]] Observations& observations() { return m_observations; }
    [[nodiscard]] const ConsoleSource& source() const { return m_source; }
    /// Looks at the console's page now.
    void look();

 signals:
    void looked();

 private:
    void current(const HttpRequest& request, HttpClient& client);
    void sample(const HttpRequest& request, HttpClient& client);
    void stream(const HttpRequest& request, HttpClient& client, std::optional<Ids> ids, quint64 from, quint64 count,
                int interval_ms, int heartbeat_ms, bool samples);
    void events(HttpClient& client);
    [[nodiscard]] QByteArray boardJson() const;
    /// What ?path= selects; false: it selects nothing, and the client has been told.
    bool select(const HttpRequest& request, HttpClient& client, std::optional<Ids>& ids);
    void refuse(const HttpRequest& request, HttpClient& client, int status, const Fault& fault);
    [[nodiscard]] bool allowed(const QByteArray& token) const;

    GatewayOptions m_options;
    Observations m_observations;
    ConsoleSource m_source;
    QTimer m_live;
    QTimer m_file;
};

}  // namespace kerf::gateway
