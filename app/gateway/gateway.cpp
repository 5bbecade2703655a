// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gateway/gateway.h"

#include <QCryptographicHash>
#include <QElapsedTimer>
#include <QFile>
#include <QJsonDocument>

namespace kerf::gateway {
namespace {

constexpr int kFile_ms = 1000;
constexpr quint64 kDefaultCount = 100;
constexpr int kMinInterval_ms = 10;
constexpr int kMaxInterval_ms = 3600000;
constexpr int kDefaultHeartbeat_ms = 10000;
constexpr int kMinHeartbeat_ms = 100;
constexpr qint64 kEnoughWaiting = 512 * 1024;
constexpr qsizetype kMaxPath = 200;
const QByteArray kBoundary = QByteArrayLiteral("kerf-gateway-part");

QByteArray part(const QByteArray& document) {
    return QByteArrayLiteral("--") + kBoundary + QByteArrayLiteral("\r\nContent-type: text/xml\r\nContent-length: ") +
           QByteArray::number(document.size()) + QByteArrayLiteral("\r\n\r\n") + document + QByteArrayLiteral("\r\n");
}

/// A whole number of a query. False: it stands there and is none, or is outside.
template <class Integer>
bool integerOf(const QUrlQuery& query, const char* name, Integer low, Integer high, std::optional<Integer>& value) {
    const QString key = QLatin1String(name);
    if (!query.hasQueryItem(key)) {
        return true;
    }
    bool good = false;
    const qlonglong read = query.queryItemValue(key).toLongLong(&good);
    value = static_cast<Integer>(read);
    return good && read >= static_cast<qlonglong>(low) && read <= static_cast<qlonglong>(high);
}

}  // namespace

Gateway::Gateway(GatewayOptions options, QObject* parent)
    : QObject(parent),
      m_options(std::move(options)),
      m_observations(m_options.bufferSize),
      m_source(m_options.dataFolder) {
    connect(&m_live, &QTimer::timeout, this, &Gateway::look);
    connect(&m_file, &QTimer::timeout, this, [this] { (void)m_source.readFile(m_observations); });
    (void)m_source.readFile(m_observations);
    look();
    m_live.setTimerType(Qt::PreciseTimer);
    m_live.start(m_options.period_ms);
    m_file.start(kFile_ms);
}

void Gateway::look() {
    m_source.readLive(m_observations);
    emit looked();
}

bool Gateway::allowed(const QByteArray& token) const {
    const QByteArray hash = QCryptographicHash::hash(token, QCryptographicHash::Sha256).toHex();
    bool found = m_options.tokenHashes.empty();
    for (const QByteArray& known : m_options.tokenHashes) {
        found = found || known == hash;
    }
    return found;
}

void Gateway::refuse(const HttpRequest& request, HttpClient& client, int status, const Fault& fault) {
    client.reply(status, "text/xml", errorDocument(m_observations, request.path, fault));
}

void Gateway::serve(const HttpRequest& request, HttpClient& client) {
    if (!allowed(request.token)) {
        refuse(request, client, 401, {"Unauthorized", tr("This device has no token for the gateway.")});
        return;
    }
    QString path = request.path;
    const QString device = u'/' + m_source.device().name + u'/';
    if (path.startsWith(device)) {
        path = path.mid(device.size() - 1);
    }
    if (path == QLatin1String("/probe")) {
        client.reply(200, "text/xml", devicesDocument(m_source.device(), m_observations, m_source.assets().size()));
    } else if (path == QLatin1String("/current")) {
        current(request, client);
    } else if (path == QLatin1String("/sample")) {
        sample(request, client);
    } else if (path == QLatin1String("/assets") || path == QLatin1String("/asset") ||
               path == QLatin1String("/assets/") || path == QLatin1String("/asset/")) {
        client.reply(200, "text/xml", assetsDocument(m_source.device(), m_observations, m_source.assets()));
    } else if (path.startsWith(QLatin1String("/assets/")) || path.startsWith(QLatin1String("/asset/"))) {
        const QString id = path.section(u'/', 2);
        std::vector<PartAsset> found;
        for (const PartAsset& asset : m_source.assets()) {
            if (asset.id == id) {
                found.push_back(asset);
            }
        }
        if (found.empty()) {
            refuse(request, client, 404, {"AssetNotFound", tr("There is no such asset."), id.left(100)});
        } else {
            client.reply(200, "text/xml", assetsDocument(m_source.device(), m_observations, found));
        }
    } else if (path == QLatin1String("/") || path == QLatin1String("/board")) {
        QFile page(QStringLiteral(":/kerf/gateway/board.html"));
        const bool there = page.open(QIODevice::ReadOnly);
        client.reply(there ? 200 : 500, "text/html; charset=utf-8", page.readAll());
    } else if (path == QLatin1String("/board.json")) {
        client.reply(200, "application/json", boardJson());
    } else if (path == QLatin1String("/events")) {
        events(client);
    } else {
        refuse(request, client, 404,
               {"InvalidURI",
                tr("There is nothing at this path; expected /probe, /current, /sample, /assets or / for the board.")});
    }
}

bool Gateway::select(const HttpRequest& request, HttpClient& client, std::optional<Ids>& ids) {
    const QString path = request.query.queryItemValue(QStringLiteral("path"), QUrl::FullyDecoded);
    if (path.isEmpty()) {
        return true;
    }
    ids = path.size() > kMaxPath ? std::nullopt
                                 : itemsOfPath(devicesDocument(m_source.device(), m_observations, 0), path);
    if (!ids) {
        refuse(
            request, client, 400,
            {"InvalidXPath",
             tr("path must be an XPath of at most %1 characters, without a path inside [ ], that selects something in "
                "/probe.")
                 .arg(kMaxPath)});
    }
    return ids.has_value();
}

void Gateway::current(const HttpRequest& request, HttpClient& client) {
    std::optional<quint64> at;
    if (!integerOf<quint64>(request.query, "at", m_observations.firstSequence(), m_observations.nextSequence() - 1,
                            at)) {
        // The schema of errors knows no query parameter "at".
        refuse(request, client, 404,
               {"InvalidURI", tr("at must be a number from %1 to %2, the numbers that the buffer holds.")
                                  .arg(m_observations.firstSequence())
                                  .arg(m_observations.nextSequence() - 1)});
        return;
    }
    std::optional<int> interval_ms;
    if (!integerOf(request.query, "interval", 0, kMaxInterval_ms, interval_ms) || (at && interval_ms)) {
        refuse(request, client, 400,
               {"InvalidParameterValue", tr("interval must be a number within its range."), QStringLiteral("interval"),
                request.query.queryItemValue(QStringLiteral("interval")), static_cast<qint64>(0),
                static_cast<qint64>(kMaxInterval_ms)});
        return;
    }
    std::optional<Ids> ids;
    if (!select(request, client, ids)) {
        return;
    }
    if (interval_ms) {
        stream(request, client, ids, 0, 0, std::max(*interval_ms, kMinInterval_ms), kDefaultHeartbeat_ms, false);
        return;
    }
    client.reply(200, "text/xml", currentDocument(m_source.device(), m_observations, ids, at));
}

void Gateway::sample(const HttpRequest& request, HttpClient& client) {
    std::optional<quint64> from;
    std::optional<quint64> count;
    std::optional<int> interval_ms;
    std::optional<int> heartbeat_ms;
    if (!integerOf<quint64>(request.query, "from", m_observations.firstSequence(), m_observations.nextSequence(),
                            from)) {
        refuse(
            request, client, 404,
            {"OutOfRange", tr("from must be a number within its range."), QStringLiteral("from"),
             request.query.queryItemValue(QStringLiteral("from")), static_cast<qint64>(m_observations.firstSequence()),
             static_cast<qint64>(m_observations.nextSequence())});
        return;
    }
    if (!integerOf<quint64>(request.query, "count", 1, m_observations.capacity(), count)) {
        refuse(request, client, 404,
               {"OutOfRange", tr("count must be a number within its range."), QStringLiteral("count"),
                request.query.queryItemValue(QStringLiteral("count")), static_cast<qint64>(1),
                static_cast<qint64>(m_observations.capacity())});
        return;
    }
    const bool beats = integerOf(request.query, "heartbeat", kMinHeartbeat_ms, kMaxInterval_ms, heartbeat_ms);
    if (!integerOf(request.query, "interval", 0, kMaxInterval_ms, interval_ms) || !beats) {
        const QString name = beats ? QStringLiteral("interval") : QStringLiteral("heartbeat");
        refuse(request, client, 400,
               {"InvalidParameterValue", tr("%1 must be a number within its range.").arg(name), name,
                request.query.queryItemValue(name), static_cast<qint64>(beats ? 0 : kMinHeartbeat_ms),
                static_cast<qint64>(kMaxInterval_ms)});
        return;
    }
    std::optional<Ids> ids;
    if (!select(request, client, ids)) {
        return;
    }
    const quint64 first = from.value_or(m_observations.firstSequence());
    if (interval_ms) {
        stream(request, client, ids, first, count.value_or(kDefaultCount), std::max(*interval_ms, kMinInterval_ms),
               heartbeat_ms.value_or(kDefaultHeartbeat_ms), true);
        return;
    }
    client.reply(200, "text/xml",
                 sampleDocument(m_source.device(), m_observations, ids, first, count.value_or(kDefaultCount)).text);
}

void Gateway::stream(const HttpRequest& request, HttpClient& client, std::optional<Ids> ids, quint64 from,
                     quint64 count, int interval_ms, int heartbeat_ms, bool samples) {
    client.beginStream(QByteArrayLiteral("multipart/x-mixed-replace;boundary=") + kBoundary);
    struct State {
        quint64 next;
        QElapsedTimer sinceSent;
    };
    const auto state = std::make_shared<State>(State{from, {}});
    state->sinceSent.start();
    auto* timer = new QTimer(&client);
    const auto tick = [this, &client, ids = std::move(ids), count, heartbeat_ms, samples, state, timer,
                       uri = request.path] {
        if (client.unsent() > kEnoughWaiting) {
            return;  // it reads slowly: nothing more until it has; when the buffer overtakes it, it is told
        }
        if (!samples) {
            client.send(part(currentDocument(m_source.device(), m_observations, ids, std::nullopt)));
            return;
        }
        if (state->next < m_observations.firstSequence()) {
            client.send(part(errorDocument(
                m_observations, uri,
                {"OutOfRange", tr("The buffer has gone on; ask again from its first number."), QStringLiteral("from"),
                 QString::number(state->next), static_cast<qint64>(m_observations.firstSequence()),
                 static_cast<qint64>(m_observations.nextSequence())})));
            timer->stop();
            client.finish();
            return;
        }
        const bool due = state->sinceSent.elapsed() >= heartbeat_ms;
        if (state->next == m_observations.nextSequence() && !due) {
            return;
        }
        const SampleDocument document = sampleDocument(m_source.device(), m_observations, ids, state->next, count);
        state->next = document.next;
        state->sinceSent.restart();
        client.send(part(document.text));
    };
    connect(timer, &QTimer::timeout, &client, tick);
    timer->start(interval_ms);
    tick();
}

QByteArray Gateway::boardJson() const {
    return QJsonDocument(QJsonObject{{QStringLiteral("utc_ms"), QDateTime::currentMSecsSinceEpoch()},
                                     {QStringLiteral("machines"), QJsonArray{m_source.board()}}})
        .toJson(QJsonDocument::Compact);
}

void Gateway::events(HttpClient& client) {
    client.beginStream(QByteArrayLiteral("text/event-stream"));
    auto* timer = new QTimer(&client);
    const auto tick = [this, &client] {
        if (client.unsent() < kEnoughWaiting) {
            client.send(QByteArrayLiteral("data: ") + boardJson() + QByteArrayLiteral("\n\n"));
        }
    };
    connect(timer, &QTimer::timeout, &client, tick);
    timer->start(500);
    client.send(QByteArrayLiteral("retry: 1000\n\n"));
    tick();
}

}  // namespace kerf::gateway
