// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/alarm_list.h"

#include <algorithm>

namespace kerf::ui {

AlarmList::AlarmList(const EngineApi& engine, QObject* parent) : QObject(parent), m_engine(engine) {}

void AlarmList::take(const AlarmEvent& event, const QDateTime& now) {
    const auto standing = std::find_if(m_entries.begin(), m_entries.end(),
                                       [&event](const AlarmEntry& e) { return e.code == event.code && e.active(); });
    if (!event.raised) {
        if (standing != m_entries.end()) {
            standing->cleared = now;
            emit changed();
        }
        return;
    }
    if (standing != m_entries.end()) {
        standing->detail = event.detail;
        emit changed();
        return;
    }
    const AlarmSpec* known = m_engine.alarmSpec(event.code);
    AlarmEntry entry;
    entry.code = event.code;
    entry.priority = known != nullptr ? known->priority : 2;
    entry.detail = event.detail;
    entry.raised = now;
    entry.firstOut = std::none_of(m_entries.begin(), m_entries.end(), [](const AlarmEntry& e) { return e.active(); });
    m_entries.push_back(entry);
    if (m_entries.size() > kKept) {
        const auto oldest =
            std::find_if(m_entries.begin(), m_entries.end(), [](const AlarmEntry& e) { return !e.open(); });
        m_entries.erase(oldest == m_entries.end() ? m_entries.begin() : oldest);
    }
    emit changed();
}

void AlarmList::acknowledge(AlarmCode code, const QString& author, const QDateTime& now) {
    bool any = false;
    for (AlarmEntry& entry : m_entries) {
        if (entry.code == code && !entry.acknowledged) {
            entry.acknowledged = now;
            entry.acknowledgedBy = author;
            any = true;
        }
    }
    if (any) {
        emit acknowledgedByOperator(code, author);
        emit changed();
    }
}

const AlarmEntry* AlarmList::firstUnacknowledged() const {
    const auto before = [](const AlarmEntry& a, const AlarmEntry& b) {
        return a.active() != b.active() ? a.active() : a.priority < b.priority;
    };
    const AlarmEntry* first = nullptr;
    for (const AlarmEntry& entry : m_entries) {
        if (!entry.acknowledged && (first == nullptr || before(entry, *first))) {
            first = &entry;
        }
    }
    return first;
}

int AlarmList::unacknowledged() const {
    return static_cast<int>(
        std::count_if(m_entries.begin(), m_entries.end(), [](const AlarmEntry& e) { return !e.acknowledged; }));
}

}  // namespace kerf::ui
