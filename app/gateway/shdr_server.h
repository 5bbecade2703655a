// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTcpServer>

#include "app/gateway/observations.h"

class QTcpSocket;

namespace kerf::gateway {

/// SHDR for agents that people already run: "time|key|value" lines over TCP, all of them at connect, then what changes.
/// "* PING" is answered with "* PONG 10000". 127.0.0.1 only: the protocol knows neither encryption nor names.
class ShdrServer : public QObject {
    Q_OBJECT
 public:
    static constexpr int kMaxClients = 32;
    static constexpr qint64 kMaxUnsent = 1024 * 1024;

    explicit ShdrServer(const Observations& observations, QObject* parent = nullptr);
    bool listen(quint16 port);
    [[nodiscard]] quint16 port() const { return m_server.serverPort(); }
    /// Sends what is new.
    void update();

 private:
    void accept();

    const Observations& m_observations;
    QTcpServer m_server;
    QList<QTcpSocket*> m_clients;
    quint64 m_next{1};
};

[[nodiscard]] QByteArray shdrLine(const Observation& observation);

}  // namespace kerf::gateway
