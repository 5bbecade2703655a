// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QModbusClient>
#include <QObject>
#include <QTimer>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "app/sensors/channel_judge.h"
#include "app/sensors/reading_plan.h"

namespace kerf::sensors {

/// One way to modules: a TCP connection with one module behind it, or a serial line with one or several. Asks one
/// question at a time and never blocks, so lines do not wait for each other.
///
/// A connection that is lost, or silent for kSilentRounds questions in a row (half-open TCP), is closed and made anew.
/// An answer counts only for the question that is open: over TCP by its transaction number. Over RTU answers carry
/// none, so after a time-out the unit is left alone for kLateAnswer_ms: what comes meanwhile falls into the void.
/// Nothing is asked twice, a lost question is made up for by the next round.
class ModbusLine : public QObject {
    Q_OBJECT
 public:
    static constexpr int kSilentRounds = 3;
    static constexpr int kLateAnswer_ms = 2000;
    static constexpr int kReconnect_ms = 1000;
    static constexpr int kConnect_ms = 3000;
    static constexpr int kUnwritten_ms = 1000;  ///< a question without even a time-out, behind its time-out

    /// `modules` are those of this line; `judges` one per channel of the file, all outlive the line.
    ModbusLine(const SensorFile& file, const std::vector<std::size_t>& modules, std::vector<ChannelJudge>& judges,
               QObject* parent = nullptr);
    ~ModbusLine() override;

    void start();
    /// What was asked, answered, timed out since the start. For diagnostics and tests.
    struct Counts {
        std::uint64_t asked{0};
        std::uint64_t answered{0};
        std::uint64_t timedOut{0};
        std::uint64_t connected{0};
    };
    [[nodiscard]] const Counts& counts() const noexcept { return m_counts; }

 private:
    struct Unit {
        std::size_t module{0};
        ReadingPlan plan{};
        std::vector<std::vector<quint16>> answers{};  ///< per block of the round under way
        std::vector<bool> refused{};                  ///< per block: the module has no such registers
        bool apart{false};                            ///< the plan asks for every channel by itself
        std::int64_t due_ns{0};
        std::int64_t quietUntil_ns{0};
    };

    void plan(Unit& unit, bool apart) const;
    void makeClient();
    void dropClient();
    void connectNow();
    void stateChanged(QModbusDevice::State state);
    void next();
    void ask();
    void answered(QModbusReply& reply);
    void finishRound();
    void endRound();
    void silent();

    const SensorFile& m_file;
    std::vector<ChannelJudge>& m_judges;
    std::vector<Unit> m_units{};
    std::unique_ptr<QModbusClient> m_client;
    std::unique_ptr<QModbusReply> m_reply;
    QTimer m_next;          ///< the next question, or the next attempt to connect
    QTimer m_patience;      ///< with a connection that does not come about, and with a question that ends in nothing
    std::size_t m_unit{0};  ///< of the round under way
    std::size_t m_block{0};
    bool m_inRound{false};
    int m_silent{0};
    Counts m_counts{};
};

}  // namespace kerf::sensors
