// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <optional>
#include <set>
#include <string>

#include "app/gateway/observations.h"

/// MTConnect 2.7 documents.
namespace kerf::gateway {

/// Who the device is.
struct Device {
    QString name{QStringLiteral("Kerf")};
    QString uuid{};
};

/// A finished part, for /assets.
struct PartAsset {
    QString id{};
    QString name{};
    qint64 utc_ms{0};
};

using Ids = std::set<std::string>;

[[nodiscard]] QByteArray devicesDocument(const Device& device, const Observations& observations, std::size_t assets);
/// Newest value of each item (all when `ids` is empty), as of now or as of `at`.
[[nodiscard]] QByteArray currentDocument(const Device& device, const Observations& observations,
                                         const std::optional<Ids>& ids, std::optional<quint64> at);
struct SampleDocument {
    QByteArray text{};
    quint64 next{0};  ///< the number to ask for next
};
/// Observations from `from` on, at most `count` numbers.
[[nodiscard]] SampleDocument sampleDocument(const Device& device, const Observations& observations,
                                            const std::optional<Ids>& ids, quint64 from, quint64 count);
[[nodiscard]] QByteArray assetsDocument(const Device& device, const Observations& observations,
                                        const std::vector<PartAsset>& assets);
/// What a client asked wrongly.
struct Fault {
    const char*
        element;  ///< kind: "OutOfRange", "InvalidParameterValue", "InvalidURI", "InvalidXPath", "AssetNotFound", …
    QString message{};
    QString parameter{};  ///< of a wrong parameter: its name; of a missing asset: its id
    QString value{};
    std::optional<qint64> minimum{};
    std::optional<qint64> maximum{};
};
[[nodiscard]] QByteArray errorDocument(const Observations& observations, const QString& uri, const Fault& fault);
/// Items an XPath selects in /probe. Nothing: it is no XPath, or selects nothing.
[[nodiscard]] std::optional<Ids> itemsOfPath(const QByteArray& devices, const QString& path);

[[nodiscard]] QString isoTime(qint64 utc_ms);

}  // namespace kerf::gateway
