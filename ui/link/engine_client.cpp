// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/engine_client.h"

#include <algorithm>

namespace kerf::ui {

EngineClient::EngineClient(EngineApi& engine, QObject* parent) : QObject(parent), m_engine(engine) {
    m_timer.setTimerType(Qt::PreciseTimer);
    m_timer.setInterval(1000 / kTickRate_Hz);
    connect(&m_timer, &QTimer::timeout, this, &EngineClient::tick);
}

void EngineClient::start() {
    m_timer.start();
}

void EngineClient::stop() {
    m_timer.stop();
}

void EngineClient::tick() {
    m_status = m_engine.status();
    settleCommands();
    AlarmEvent event;
    for (int i = 0; i < kAlarmsPerTick && m_engine.nextAlarm(event); ++i) {
        emit alarmArrived(event);
    }
    const std::size_t count = m_engine.drainSamples(m_samples);
    if (count > 0) {
        emit samplesArrived(std::span<const Sample>(m_samples.data(), count));
    }
    emit statusChanged(m_status);
}

bool EngineClient::send(const Command& command) {
    if (const Sentence why = m_guard ? m_guard(command) : Sentence(); !why.empty()) {
        emit refused(why);
        return false;
    }
    const std::optional<std::uint32_t> number = m_engine.send(command);
    if (!number) {
        emit refused(
            Sentence(KERF_TEXT("The command was not sent: the engine has not taken the earlier ones yet. Try again.")));
        return false;
    }
    m_pending.push_back(*number);
    return true;
}

// The status echoes the newest few results. A command older than all of them is no longer pending: its fate is unknown.
void EngineClient::settleCommands() {
    const std::uint32_t newest = m_status.lastCommand.number;
    for (auto result = m_status.recentCommands.rbegin(); result != m_status.recentCommands.rend(); ++result) {
        const auto found = std::find(m_pending.begin(), m_pending.end(), result->number);
        if (found == m_pending.end()) {
            continue;
        }
        m_pending.erase(found);
        if (result->done) {
            emit accepted(result->number);
        } else {
            emit refused(result->reason);
        }
    }
    std::erase_if(m_pending, [newest](std::uint32_t number) { return number <= newest; });
}

}  // namespace kerf::ui
