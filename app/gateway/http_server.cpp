// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gateway/http_server.h"

#include <QSslServer>
#include <QTimer>
#include <QUrl>

namespace kerf::gateway {
namespace {

const char* reason(int status) {
    switch (status) {
        case 200:
            return "OK";
        case 400:
            return "Bad Request";
        case 401:
            return "Unauthorized";
        case 404:
            return "Not Found";
        case 405:
            return "Method Not Allowed";
        case 431:
            return "Request Header Fields Too Large";
        case 503:
            return "Service Unavailable";
        default:
            return "Internal Server Error";
    }
}

QByteArray head(int status, const QByteArray& type) {
    return QByteArrayLiteral("HTTP/1.1 ") + QByteArray::number(status) + ' ' + reason(status) +
           QByteArrayLiteral("\r\nContent-Type: ") + type +
           QByteArrayLiteral("\r\nConnection: close\r\nCache-Control: no-store\r\nX-Content-Type-Options: nosniff\r\n");
}

}  // namespace

HttpClient::HttpClient(QTcpSocket* socket, QObject* parent) : QObject(parent), m_socket(socket) {}

void HttpClient::reply(int status, const char* type, const QByteArray& body) {
    m_socket->write(head(status, type) + QByteArrayLiteral("Content-Length: ") + QByteArray::number(body.size()) +
                    QByteArrayLiteral("\r\n\r\n") + body);
    finish();
}

void HttpClient::beginStream(const QByteArray& type) {
    m_socket->write(head(200, type) + QByteArrayLiteral("\r\n"));
}

bool HttpClient::send(const QByteArray& bytes) {
    if (m_socket->state() != QAbstractSocket::ConnectedState) {
        return false;
    }
    if (m_socket->bytesToWrite() > HttpServer::kMaxUnsent) {
        m_socket->abort();  // it does not read: what waits for it would only grow
        return false;
    }
    m_socket->write(bytes);
    return true;
}

void HttpClient::finish() {
    m_socket->disconnectFromHost();
    // A client that does not take its answer is let go.
    QTimer::singleShot(HttpServer::kPatience_ms * 2, m_socket, &QTcpSocket::abort);
}

HttpServer::HttpServer(Handler handler, QObject* parent) : QObject(parent), m_handler(std::move(handler)) {}

bool HttpServer::listen(const QHostAddress& address, quint16 port, const std::optional<QSslConfiguration>& tls) {
    if (tls) {
        auto server = std::make_unique<QSslServer>();
        server->setSslConfiguration(*tls);
        server->setHandshakeTimeout(kPatience_ms);
        m_server = std::move(server);
    } else {
        m_server = std::make_unique<QTcpServer>();
    }
    m_server->setMaxPendingConnections(kMaxClients);
    connect(m_server.get(), &QTcpServer::pendingConnectionAvailable, this, [this] {
        while (QTcpSocket* socket = m_server->nextPendingConnection()) {
            accept(socket);
        }
    });
    return m_server->listen(address, port);
}

void HttpServer::accept(QTcpSocket* socket) {
    if (m_clients >= kMaxClients) {
        socket->write("HTTP/1.1 503 Service Unavailable\r\nConnection: close\r\nContent-Length: 0\r\n\r\n");
        connect(socket, &QTcpSocket::disconnected, socket, &QObject::deleteLater);
        socket->disconnectFromHost();
        QTimer::singleShot(1000, socket, &QObject::deleteLater);
        return;
    }
    ++m_clients;
    connect(socket, &QObject::destroyed, this, [this] { --m_clients; });
    connect(socket, &QTcpSocket::disconnected, socket, &QObject::deleteLater);
    socket->setReadBufferSize(kMaxHead + 1);
    auto* patience = new QTimer(socket);
    patience->setSingleShot(true);
    connect(patience, &QTimer::timeout, socket, &QTcpSocket::abort);
    patience->start(kPatience_ms);
    const auto received = std::make_shared<QByteArray>();
    connect(socket, &QTcpSocket::readyRead, this, [this, socket, received, patience] {
        if (patience->isActive()) {
            read(socket, *received);
        } else {
            (void)socket->readAll();  // answered already: whatever more comes is not listened to
        }
    });
    if (socket->bytesAvailable() > 0) {
        read(socket, *received);
    }
}

void HttpServer::read(QTcpSocket* socket, QByteArray& received) {
    received += socket->readAll();
    const qsizetype end = received.indexOf("\r\n\r\n");
    if (end < 0 && received.size() <= kMaxHead) {
        return;
    }
    socket->findChild<QTimer*>()->stop();
    auto* client = new HttpClient(socket, socket);
    if (end < 0 || end > kMaxHead) {
        client->reply(431, "text/plain", "The head of a request is at most 8192 bytes.\n");
        return;
    }
    const QList<QByteArray> lines = received.left(end).split('\n');
    const QList<QByteArray> words = lines.front().trimmed().split(' ');
    if (words.size() != 3 || !words[2].startsWith("HTTP/1.") || !words[1].startsWith('/')) {
        client->reply(400, "text/plain", "This is not an HTTP request.\n");
        return;
    }
    if (words[0] != "GET") {
        client->reply(405, "text/plain", "Only GET: nothing can be written here.\n");
        return;
    }
    HttpRequest request;
    request.target = QString::fromLatin1(words[1]);
    const QUrl url = QUrl::fromEncoded(words[1]);
    request.path = url.path();
    request.query = QUrlQuery(url);
    for (const QByteArray& line : lines) {
        const QByteArray text = line.trimmed();
        if (text.toLower().startsWith("authorization: bearer ")) {
            request.token = text.mid(22).trimmed();
        }
    }
    if (request.token.isEmpty()) {
        request.token = request.query.queryItemValue(QStringLiteral("token")).toLatin1();
    }
    received.clear();
    m_handler(request, *client);
}

}  // namespace kerf::gateway
