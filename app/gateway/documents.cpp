// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gateway/documents.h"

#include <QUrl>
#include <QXmlStreamWriter>
#include <algorithm>
#include <pugixml.hpp>

namespace kerf::gateway {
namespace {

constexpr const char* kVersion = "2.7";
const QString kXsi = QStringLiteral("http://www.w3.org/2001/XMLSchema-instance");

QString L(const char* text) {
    return QString::fromLatin1(text);
}

/// Opens root and header; the caller goes on inside the root.
void begin(QXmlStreamWriter& xml, const char* kind, const Observations& observations) {
    const QString space = L("urn:mtconnect.org:MTConnect") + L(kind) + L(":") + L(kVersion);
    xml.writeStartDocument();
    xml.writeStartElement(L("MTConnect") + L(kind));
    xml.writeDefaultNamespace(space);
    xml.writeNamespace(kXsi, L("xsi"));
    xml.writeAttribute(
        kXsi, L("schemaLocation"),
        space + L(" http://schemas.mtconnect.org/schemas/MTConnect") + L(kind) + L("_") + L(kVersion) + L(".xsd"));
    xml.writeStartElement(L("Header"));
    xml.writeAttribute(L("creationTime"), isoTime(QDateTime::currentMSecsSinceEpoch()));
    xml.writeAttribute(L("sender"), L("kerf-gateway"));
    xml.writeAttribute(L("instanceId"), QString::number(observations.instance()));
    xml.writeAttribute(L("version"), L(kVersion));
    xml.writeAttribute(L("deviceModelChangeTime"), isoTime(static_cast<qint64>(observations.instance()) * 1000));
}

void writeDataItem(QXmlStreamWriter& xml, const DataItem& item) {
    xml.writeEmptyElement(L("DataItem"));
    xml.writeAttribute(L("id"), L(item.id));
    xml.writeAttribute(L("category"), item.category == Category::Sample  ? L("SAMPLE")
                                      : item.category == Category::Event ? L("EVENT")
                                                                         : L("CONDITION"));
    xml.writeAttribute(L("type"), L(item.type));
    xml.writeAttribute(L("name"), L(item.id));
    for (const auto& [name, value] : {std::pair{"subType", item.subType},
                                      {"units", item.units},
                                      {"nativeUnits", item.units},
                                      {"representation", item.representation}}) {
        if (*value != '\0') {
            xml.writeAttribute(L(name), L(value));
        }
    }
}

void writeItemsOf(QXmlStreamWriter& xml, const char* component) {
    const auto mine = [component](const DataItem& item) { return qstrcmp(item.component, component) == 0; };
    if (std::any_of(dataItems().begin(), dataItems().end(), mine)) {
        xml.writeStartElement(L("DataItems"));
        for (const DataItem& item : dataItems()) {
            if (mine(item)) {
                writeDataItem(xml, item);
            }
        }
        xml.writeEndElement();
    }
}

void writeComponentsOf(QXmlStreamWriter& xml, const char* parent) {
    const auto mine = [parent](const Component& component) { return qstrcmp(component.parent, parent) == 0; };
    if (std::none_of(components().begin(), components().end(), mine)) {
        return;
    }
    xml.writeStartElement(L("Components"));
    for (const Component& component : components()) {
        if (mine(component)) {
            xml.writeStartElement(L(component.element));
            xml.writeAttribute(L("id"), L(component.id));
            xml.writeAttribute(L("name"), L(component.name));
            writeItemsOf(xml, component.id);
            writeComponentsOf(xml, component.id);
            xml.writeEndElement();
        }
    }
    xml.writeEndElement();
}

void writeObservation(QXmlStreamWriter& xml, const Observation& observation) {
    const DataItem& item = *observation.item;
    const Value& value = observation.value;
    const bool condition = item.category == Category::Condition;
    xml.writeStartElement(condition ? observation.condition.level : L(item.element));
    xml.writeAttribute(L("dataItemId"), L(item.id));
    xml.writeAttribute(L("name"), L(item.id));
    xml.writeAttribute(L("sequence"), QString::number(observation.sequence));
    xml.writeAttribute(L("timestamp"), isoTime(observation.utc_ms));
    if (*item.subType != '\0') {
        xml.writeAttribute(L("subType"), L(item.subType));
    }
    if (condition) {
        xml.writeAttribute(L("type"), L(item.type));
        if (!observation.condition.code.isEmpty()) {
            xml.writeAttribute(L("nativeCode"), observation.condition.code);
            xml.writeAttribute(L("conditionId"), observation.condition.code);
        }
        xml.writeCharacters(observation.condition.text);
    } else if (*item.representation != '\0') {
        xml.writeAttribute(L("count"), value.available ? QString::number(value.entries.size()) : L("0"));
        if (!value.available) {
            xml.writeCharacters(L("UNAVAILABLE"));
        }
        for (const Entry& entry : value.entries) {
            xml.writeStartElement(L("Entry"));
            xml.writeAttribute(L("key"), entry.key);
            xml.writeCharacters(entry.text);
            for (const auto& [key, text] : entry.cells) {
                xml.writeStartElement(L("Cell"));
                xml.writeAttribute(L("key"), key);
                xml.writeCharacters(text);
                xml.writeEndElement();
            }
            xml.writeEndElement();
        }
    } else {
        if (qstrcmp(item.id, "asset_chg") == 0 || qstrcmp(item.id, "asset_rem") == 0) {
            xml.writeAttribute(L("assetType"), value.available ? L("Part") : L("UNAVAILABLE"));
        }
        xml.writeCharacters(value.available ? value.text : L("UNAVAILABLE"));
    }
    xml.writeEndElement();
}

/// Observations by component, then by category, as the schema wants them.
void writeStreams(QXmlStreamWriter& xml, const Device& device, const std::vector<const Observation*>& all) {
    xml.writeStartElement(L("Streams"));
    xml.writeStartElement(L("DeviceStream"));
    xml.writeAttribute(L("name"), device.name);
    xml.writeAttribute(L("uuid"), device.uuid);
    const auto writeComponent = [&](const char* id, const char* element, const QString& name, const QString& shownId) {
        std::vector<const Observation*> mine;
        for (const Observation* observation : all) {
            if (qstrcmp(observation->item->component, id) == 0) {
                mine.push_back(observation);
            }
        }
        if (mine.empty()) {
            return;
        }
        xml.writeStartElement(L("ComponentStream"));
        xml.writeAttribute(L("component"), L(element));
        xml.writeAttribute(L("name"), name);
        xml.writeAttribute(L("componentId"), shownId);
        for (const auto& [category, group] : {std::pair{Category::Sample, "Samples"},
                                              {Category::Event, "Events"},
                                              {Category::Condition, "Condition"}}) {
            bool open = false;
            for (const Observation* observation : mine) {
                if (observation->item->category == category) {
                    if (!open) {
                        xml.writeStartElement(L(group));
                        open = true;
                    }
                    writeObservation(xml, *observation);
                }
            }
            if (open) {
                xml.writeEndElement();
            }
        }
        xml.writeEndElement();
    };
    writeComponent("", "Device", device.name, L("dev"));
    for (const Component& component : components()) {
        writeComponent(component.id, component.element, L(component.name), L(component.id));
    }
    xml.writeEndElement();
    xml.writeEndElement();
}

void streamHeader(QXmlStreamWriter& xml, const Observations& observations, quint64 next) {
    xml.writeAttribute(L("bufferSize"), QString::number(observations.capacity()));
    xml.writeAttribute(L("nextSequence"), QString::number(next));
    xml.writeAttribute(L("firstSequence"), QString::number(observations.firstSequence()));
    xml.writeAttribute(L("lastSequence"), QString::number(observations.nextSequence() - 1));
    xml.writeEndElement();
}

bool wanted(const std::optional<Ids>& ids, const DataItem& item) {
    return !ids || ids->contains(item.id);
}

}  // namespace

QString isoTime(qint64 utc_ms) {
    return QDateTime::fromMSecsSinceEpoch(utc_ms, Qt::UTC).toString(QStringLiteral("yyyy-MM-ddTHH:mm:ss.zzzZ"));
}

QByteArray devicesDocument(const Device& device, const Observations& observations, std::size_t assets) {
    QByteArray text;
    QXmlStreamWriter xml(&text);
    begin(xml, "Devices", observations);
    xml.writeAttribute(L("bufferSize"), QString::number(observations.capacity()));
    xml.writeAttribute(L("assetBufferSize"), L("1024"));
    xml.writeAttribute(L("assetCount"), QString::number(assets));
    xml.writeEndElement();
    xml.writeStartElement(L("Devices"));
    xml.writeStartElement(L("Device"));
    xml.writeAttribute(L("id"), L("dev"));
    xml.writeAttribute(L("name"), device.name);
    xml.writeAttribute(L("uuid"), device.uuid);
    xml.writeEmptyElement(L("Description"));
    xml.writeAttribute(L("manufacturer"), L("Kerf"));
    writeItemsOf(xml, "");
    writeComponentsOf(xml, "");
    xml.writeEndDocument();
    return text;
}

QByteArray currentDocument(const Device& device, const Observations& observations, const std::optional<Ids>& ids,
                           std::optional<quint64> at) {
    QByteArray text;
    QXmlStreamWriter xml(&text);
    begin(xml, "Streams", observations);
    streamHeader(xml, observations, observations.nextSequence());
    std::vector<const Observation*> all;
    if (!at) {
        for (const DataItem& item : dataItems()) {
            if (wanted(ids, item)) {
                for (const Observation& observation : observations.newest(item)) {
                    all.push_back(&observation);
                }
            }
        }
    } else {
        std::map<std::string, const Observation*> last;
        for (quint64 i = observations.firstSequence(); i <= *at; ++i) {
            const Observation& observation = observations.at(i);
            if (wanted(ids, *observation.item)) {
                last[observation.item->id] = &observation;
            }
        }
        for (const auto& [id, observation] : last) {
            all.push_back(observation);
        }
    }
    writeStreams(xml, device, all);
    xml.writeEndDocument();
    return text;
}

SampleDocument sampleDocument(const Device& device, const Observations& observations, const std::optional<Ids>& ids,
                              quint64 from, quint64 count) {
    SampleDocument document;
    const quint64 end = observations.nextSequence();
    std::vector<const Observation*> all;
    quint64 i = from;
    for (; i < end && all.size() < count; ++i) {
        const Observation& observation = observations.at(i);
        if (wanted(ids, *observation.item)) {
            all.push_back(&observation);
        }
    }
    document.next = i;
    QXmlStreamWriter xml(&document.text);
    begin(xml, "Streams", observations);
    streamHeader(xml, observations, document.next);
    if (all.empty()) {
        xml.writeEmptyElement(L("Streams"));
    } else {
        writeStreams(xml, device, all);
    }
    xml.writeEndDocument();
    return document;
}

QByteArray assetsDocument(const Device& device, const Observations& observations,
                          const std::vector<PartAsset>& assets) {
    QByteArray text;
    QXmlStreamWriter xml(&text);
    begin(xml, "Assets", observations);
    xml.writeAttribute(L("assetBufferSize"), L("1024"));
    xml.writeAttribute(L("assetCount"), QString::number(assets.size()));
    xml.writeEndElement();
    xml.writeStartElement(L("Assets"));
    for (const PartAsset& asset : assets) {
        xml.writeStartElement(L("Part"));
        xml.writeAttribute(L("assetId"), asset.id);
        xml.writeAttribute(L("timestamp"), isoTime(asset.utc_ms));
        xml.writeAttribute(L("deviceUuid"), device.uuid);
        xml.writeAttribute(L("serialNumber"), asset.name);
        xml.writeAttribute(L("revision"), L("1"));
        xml.writeEndElement();
    }
    xml.writeEndDocument();
    return text;
}

QByteArray errorDocument(const Observations& observations, const QString& uri, const Fault& fault) {
    QByteArray text;
    QXmlStreamWriter xml(&text);
    begin(xml, "Error", observations);
    xml.writeAttribute(L("bufferSize"), QString::number(observations.capacity()));
    xml.writeEndElement();
    xml.writeStartElement(L("Errors"));
    xml.writeStartElement(L(fault.element));
    if (qstrcmp(fault.element, "AssetNotFound") == 0) {
        QString id = fault.parameter;
        for (QChar& letter : id) {  // XML has no control characters, and the schema no empty name
            letter = letter.isPrint() ? letter : QChar(u'?');
        }
        xml.writeTextElement(L("AssetId"), id);
    } else if (!fault.parameter.isEmpty()) {
        xml.writeStartElement(L("QueryParameter"));
        xml.writeAttribute(L("name"), fault.parameter);
        if (fault.maximum) {
            xml.writeTextElement(L("Maximum"), QString::number(*fault.maximum));
        }
        if (fault.minimum) {
            xml.writeTextElement(L("Minimum"), QString::number(*fault.minimum));
        }
        xml.writeTextElement(L("Value"), fault.value.left(100));
        xml.writeEndElement();
    }
    xml.writeTextElement(L("URI"), QString::fromLatin1(QUrl::toPercentEncoding(uri.left(500), "/")));
    xml.writeTextElement(L("ErrorMessage"), fault.message);
    xml.writeEndDocument();
    return text;
}

namespace {

/// Paths inside predicates are looked through for every element, and again inside those: forty characters would keep
/// everybody waiting for hours. Without them the work grows with the elements alone.
bool isBounded(const QString& path) {
    QChar quote;
    bool predicate = false;
    for (const QChar letter : path) {
        if (!quote.isNull()) {
            quote = letter == quote ? QChar() : quote;
        } else if (letter == u'\'' || letter == u'"') {
            quote = letter;
        } else if (predicate && (letter == u'/' || letter == u'[' || letter == u':')) {
            return false;
        } else if (letter == u'[' || letter == u']') {
            predicate = letter == u'[';
        }
    }
    return true;
}

}  // namespace

std::optional<Ids> itemsOfPath(const QByteArray& devices, const QString& path) {
    if (!isBounded(path)) {
        return std::nullopt;
    }
    pugi::xml_document document;
    if (!document.load_buffer(devices.constData(), static_cast<std::size_t>(devices.size()))) {
        return std::nullopt;
    }
    Ids ids;
    try {
        for (const pugi::xpath_node& node : document.select_nodes(path.toUtf8().constData())) {
            const std::string name = node.node().name();
            if (name == "DataItem") {
                ids.insert(node.node().attribute("id").value());
            } else if (node.node()) {
                for (const pugi::xpath_node& inner : node.node().select_nodes(".//DataItem")) {
                    ids.insert(inner.node().attribute("id").value());
                }
            }
        }
    } catch (const pugi::xpath_exception&) {
        return std::nullopt;
    }
    return ids.empty() ? std::nullopt : std::optional(ids);
}

}  // namespace kerf::gateway
