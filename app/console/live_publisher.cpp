// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/live_publisher.h"
#include "engine/port/state_keys.h"

#include <QDateTime>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <cmath>

namespace kerf::console {
namespace {

QJsonValue number(const Reading& reading) {
    return reading.good() ? QJsonValue(reading.value) : QJsonValue(QJsonValue::Null);
}

QJsonValue force(const Status& status) {
    return number(status.programProcess == ProcessId::Turning ? status.turning.force_N : status.milling.force_N);
}

}  // namespace

std::string liveText(const Status& status, const Capabilities& capabilities, const std::string& shop) {
    QJsonObject live;
    live[QLatin1String("utc_ms")] = QDateTime::currentMSecsSinceEpoch();
    live[QLatin1String("machine")] = QString::fromUtf8(capabilities.machineName.data());
    live[QLatin1String("simulated")] = capabilities.simulated;
    live[QLatin1String("link")] = status.link == LinkState::Up;
    live[QLatin1String("on")] = status.machineOn;
    live[QLatin1String("estop")] = status.emergencyStop;
    live[QLatin1String("feedhold")] = status.feedHold;
    live[QLatin1String("held")] = status.held;
    live[QLatin1String("program")] = QLatin1String(stateKey(status.program));
    live[QLatin1String("process")] = QLatin1String(processKey(status.programProcess));
    live[QLatin1String("part")] = static_cast<qint64>(status.partSequence);
    live[QLatin1String("override")] = status.operatorOverride;
    live[QLatin1String("scale")] = status.feedScale;
    live[QLatin1String("feed_mmPerS")] = number(status.actualFeed_mmPerS);
    live[QLatin1String("feed_mmPerRev")] =
        status.boring.cutting ? number(status.boring.feed_mmPerRev) : QJsonValue(QJsonValue::Null);
    live[QLatin1String("speed_rpm")] = number(status.spindleSpeed_rpm);
    live[QLatin1String("force_N")] = force(status);
    QJsonArray position;
    QJsonArray offset;
    QJsonArray drift;
    const LoopStatus& thermal = status.loops[static_cast<std::size_t>(ProcessId::Thermal)];
    const bool predicted = thermal.fitted && status.thermal.model != 0 && status.thermal.updates > 0;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        position.append(number(status.position_mm[axis]));
        offset.append(status.workOffset_um[axis]);
        drift.append(predicted ? QJsonValue(status.thermal.drift_um[axis]) : QJsonValue(QJsonValue::Null));
    }
    live[QLatin1String("position_mm")] = position;
    live[QLatin1String("offset_um")] = offset;
    live[QLatin1String("drift_um")] = drift;
    QJsonArray temps;
    const auto count = std::min<std::size_t>(status.thermal.count, status.thermal.temp_degC.size());
    for (std::size_t i = 0; i < count; ++i) {
        const double temp_degC = static_cast<double>(status.thermal.temp_degC[i]);
        const bool good = status.thermal.couple[i] <= CoupleState::Suspect && std::isfinite(temp_degC);
        temps.append(good ? QJsonValue(temp_degC) : QJsonValue(QJsonValue::Null));
    }
    live[QLatin1String("temp_degC")] = temps;
    QJsonArray loops;
    for (const ProcessId id : allProcesses()) {
        const LoopStatus& loop = status.loops[static_cast<std::size_t>(id)];
        if (loop.fitted) {
            loops.append(QJsonObject{{QStringLiteral("process"), QLatin1String(processKey(id))},
                                     {QStringLiteral("state"), QLatin1String(stateKey(loop.state))}});
        }
    }
    live[QLatin1String("loops")] = loops;
    if (!shop.empty()) {
        live[QLatin1String("shop")] = QJsonDocument::fromJson(QByteArray::fromStdString(shop)).object();
    }
    return QJsonDocument(live).toJson(QJsonDocument::Compact).toStdString();
}

void LivePublisher::poll(const std::string& shop) {
    const Status& status = m_engine.status();
    if (status.cycle == m_lastCycle) {
        return;
    }
    m_lastCycle = status.cycle;
    m_page.write(liveText(status, m_engine.capabilities(), shop));
}

}  // namespace kerf::console
