// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gateway/shdr_server.h"

#include <QTcpSocket>

#include "app/gateway/documents.h"

namespace kerf::gateway {
namespace {

/// '|' separates fields and a line break ends a line; neither may stand in a text.
QString clean(QString text) {
    return text.replace(u'|', u'/').replace(u'\n', u' ').replace(u'\r', u' ');
}

QString quoted(const QString& text) {
    return text.contains(u' ') ? u'"' + QString(text).replace(u'"', u'\'') + u'"' : text;
}

}  // namespace

QByteArray shdrLine(const Observation& observation) {
    const DataItem& item = *observation.item;
    QString line = isoTime(observation.utc_ms) + u'|' + QLatin1String(item.id) + u'|';
    if (item.category == Category::Condition) {
        const Condition& c = observation.condition;
        line += c.level.toUpper() + u'|' + clean(c.code) + QStringLiteral("|||") + clean(c.text);
    } else if (!observation.value.available) {
        line += QStringLiteral("UNAVAILABLE");
    } else if (*item.representation != '\0') {
        QStringList entries;
        for (const Entry& entry : observation.value.entries) {
            QStringList cells;
            for (const auto& [key, text] : entry.cells) {
                cells << key + u'=' + quoted(clean(text));
            }
            entries << entry.key + u'=' +
                           (cells.isEmpty() ? quoted(clean(entry.text)) : u'{' + cells.join(u' ') + u'}');
        }
        line += entries.join(u' ');
    } else {
        line += clean(observation.value.text);
    }
    return line.toUtf8() + '\n';
}

ShdrServer::ShdrServer(const Observations& observations, QObject* parent)
    : QObject(parent), m_observations(observations), m_next(observations.nextSequence()) {
    connect(&m_server, &QTcpServer::newConnection, this, &ShdrServer::accept);
}

bool ShdrServer::listen(quint16 port) {
    return m_server.listen(QHostAddress::LocalHost, port);
}

void ShdrServer::accept() {
    while (QTcpSocket* socket = m_server.nextPendingConnection()) {
        connect(socket, &QTcpSocket::disconnected, this, [this, socket] {
            m_clients.removeAll(socket);
            socket->deleteLater();
        });
        if (m_clients.size() >= kMaxClients) {
            socket->abort();
            continue;
        }
        socket->setReadBufferSize(1024);
        connect(socket, &QTcpSocket::readyRead, socket, [socket] {
            const QByteArray asked = socket->readAll();
            if (asked.contains("* PING")) {
                socket->write("* PONG 10000\n");
            }
        });
        update();  // so that nobody gets an observation twice
        QByteArray all;
        for (const DataItem& item : dataItems()) {
            for (const Observation& observation : m_observations.newest(item)) {
                all += shdrLine(observation);
            }
        }
        socket->write(all);
        m_clients.append(socket);
    }
}

void ShdrServer::update() {
    if (m_next < m_observations.firstSequence()) {
        m_next = m_observations.firstSequence();
    }
    QByteArray lines;
    for (; m_next < m_observations.nextSequence(); ++m_next) {
        lines += shdrLine(m_observations.at(m_next));
    }
    if (lines.isEmpty()) {
        return;
    }
    const QList<QTcpSocket*> clients = m_clients;
    for (QTcpSocket* client : clients) {
        if (client->bytesToWrite() > kMaxUnsent) {
            client->abort();
        } else {
            client->write(lines);
        }
    }
}

}  // namespace kerf::gateway
