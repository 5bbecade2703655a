// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHostAddress>
#include <QPointer>
#include <QSslConfiguration>
#include <QTcpServer>
#include <QTcpSocket>
#include <QUrlQuery>
#include <functional>
#include <memory>
#include <optional>

namespace kerf::gateway {

struct HttpRequest {
    QString path{};
    QUrlQuery query{};
    QString target{};    ///< as it was asked for
    QByteArray token{};  ///< "Authorization: Bearer …", or the query's token for browsers' event streams
};

/// One client that was answered or is being streamed to. Gone with its socket.
class HttpClient : public QObject {
    Q_OBJECT
 public:
    HttpClient(QTcpSocket* socket, QObject* parent);
    /// A whole answer; the connection is closed behind it.
    void reply(int status, const char* type, const QByteArray& body);
    /// Head of an answer without end; then send() as often as wanted.
    void beginStream(const QByteArray& type);
    /// False: the client is gone, or has taken so little that it was cut.
    bool send(const QByteArray& bytes);
    void finish();
    [[nodiscard]] qint64 unsent() const { return m_socket->bytesToWrite(); }

 private:
    QTcpSocket* m_socket;
};

/// HTTP/1.1, GET only, for a few hundred clients of which some are slow, wrong or hostile.
///
/// Qt's own HTTP server (6.4) can neither stream nor bound a client, so this is one of our own: the head of a request
/// is at most 8 kB and must be there within 5 s, a body is not read, one answer per connection, at most kMaxClients at
/// a time and kMaxUnsent bytes waiting for each.
class HttpServer : public QObject {
    Q_OBJECT
 public:
    static constexpr int kMaxClients = 300;
    static constexpr int kMaxHead = 8192;
    static constexpr int kPatience_ms = 5000;
    static constexpr qint64 kMaxUnsent = 4 * 1024 * 1024;

    using Handler = std::function<void(const HttpRequest&, HttpClient&)>;
    HttpServer(Handler handler, QObject* parent = nullptr);
    /// `tls` empty: plain. Port 0: any free one.
    bool listen(const QHostAddress& address, quint16 port, const std::optional<QSslConfiguration>& tls = std::nullopt);
    [[nodiscard]] quint16 port() const { return m_server->serverPort(); }
    [[nodiscard]] QString fault() const { return m_server->errorString(); }
    [[nodiscard]] int clients() const { return m_clients; }

 private:
    void accept(QTcpSocket* socket);
    void read(QTcpSocket* socket, QByteArray& head);

    Handler m_handler;
    std::unique_ptr<QTcpServer> m_server;
    int m_clients{0};
};

}  // namespace kerf::gateway
