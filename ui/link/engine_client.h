// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <array>
#include <functional>
#include <span>
#include <vector>

#include "engine/api/engine_api.h"

namespace kerf::ui {

/// The screen's end of the engine: drains status, samples and alarms on a display tick and emits Qt signals.
///
/// GUI thread only. Nothing here blocks the engine; what a slow screen cannot take is dropped and counted by the
/// engine (Status::stats.droppedSamples). Hold-all does not go through here: see HoldAllButton.
class EngineClient : public QObject {
    Q_OBJECT
 public:
    static constexpr int kTickRate_Hz = 60;
    static constexpr std::size_t kSamplesPerTick = 512;
    static constexpr int kAlarmsPerTick = 32;

    explicit EngineClient(EngineApi& engine, QObject* parent = nullptr);

    void start();
    void stop();
    /// One tick, as the timer does it; tests call it directly.
    void tick();

    [[nodiscard]] EngineApi& engine() { return m_engine; }
    [[nodiscard]] const Status& status() const { return m_status; }

    /// Asked before a command is sent; a sentence refuses it.
    using Guard = std::function<Sentence(const Command& command)>;
    void setGuard(Guard guard) { m_guard = std::move(guard); }

    /// Send a command. When it cannot be sent or the engine refuses it, refused() says why.
    bool send(const Command& command);
    template <class Action>
    bool sendAction(const Action& action) {
        Command command;
        command.action = action;
        return send(command);
    }
    /// Start the next part of what the screen shows: lot, recipe and schedule of the last status. The engine refuses
    /// when another one is loaded by then.
    bool startPart(ProcessId process) {
        return sendAction(StartPart{process, m_status.orders[static_cast<std::size_t>(process)]});
    }

 signals:
    void statusChanged(const kerf::Status& status);
    /// Valid only during the emission.
    void samplesArrived(std::span<const kerf::Sample> samples);
    void alarmArrived(const kerf::AlarmEvent& event);
    /// A command was not carried out. The sentence is for the operator.
    void refused(const kerf::Sentence& reason);
    void accepted(std::uint32_t number);

 private:
    void settleCommands();

    EngineApi& m_engine;
    Guard m_guard;
    QTimer m_timer;
    Status m_status;
    std::array<Sample, kSamplesPerTick> m_samples{};
    std::vector<std::uint32_t> m_pending;
};

}  // namespace kerf::ui
