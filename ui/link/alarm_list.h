// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QObject>
#include <QString>
#include <optional>
#include <vector>

#include "engine/api/engine_api.h"

namespace kerf::ui {

/// One alarm of this run, from its rise to its end.
struct AlarmEntry {
    AlarmCode code{0};
    int priority{3};
    Sentence detail{};
    QDateTime raised{};
    std::optional<QDateTime> cleared{};
    std::optional<QDateTime> acknowledged{};
    QString acknowledgedBy{};
    bool firstOut{false};  ///< the first of the group that stood together: look here for the cause

    [[nodiscard]] bool active() const { return !cleared; }
    [[nodiscard]] bool open() const { return active() || !acknowledged; }
};

/// The alarms since the console started, kept from the engine's events. Newest last.
class AlarmList : public QObject {
    Q_OBJECT
 public:
    static constexpr std::size_t kKept = 500;

    explicit AlarmList(const EngineApi& engine, QObject* parent = nullptr);

    void take(const AlarmEvent& event, const QDateTime& now);
    void acknowledge(AlarmCode code, const QString& author, const QDateTime& now);

    [[nodiscard]] const std::vector<AlarmEntry>& entries() const { return m_entries; }
    /// What the bottom line shows: of the unacknowledged ones those still active go first, then the highest priority,
    /// then the oldest; null when there is none.
    [[nodiscard]] const AlarmEntry* firstUnacknowledged() const;
    [[nodiscard]] int unacknowledged() const;
    [[nodiscard]] const AlarmSpec* spec(AlarmCode code) const { return m_engine.alarmSpec(code); }

 signals:
    void changed();
    void acknowledgedByOperator(kerf::AlarmCode code, const QString& author);

 private:
    const EngineApi& m_engine;
    std::vector<AlarmEntry> m_entries;
};

}  // namespace kerf::ui
