// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <thread>

#include "engine/cycle/cycle.h"

namespace kerf {

/// Runs the cycle against absolute deadlines of the monotonic clock, SCHED_FIFO where the system allows it; a
/// simulation faster or slower than time runs as an ordinary thread.
///
/// A real machine: one step per period, machine time = monotonic time. A simulated machine: per period as many steps
/// as the simulation speed asks and the period has room for; machine time counts steps. A missed deadline is counted,
/// never made up for.
class EngineThread {
 public:
    EngineThread(Cycle& cycle, std::int64_t period_ns, bool simulated) noexcept
        : m_cycle(cycle), m_period_ns(period_ns), m_simulated(simulated) {}
    EngineThread(const EngineThread&) = delete;
    EngineThread& operator=(const EngineThread&) = delete;
    ~EngineThread() { stop(); }

    void start();
    void stop() noexcept;

 private:
    void run() noexcept;
    [[nodiscard]] std::int64_t runBatch(std::int64_t wake_ns) noexcept;

    Cycle& m_cycle;
    std::int64_t m_period_ns;
    bool m_simulated;
    CycleStats m_stats{};
    std::int64_t m_machineTime_ns{0};
    double m_stepsOwed{0.0};
    std::atomic<bool> m_stop{false};
    std::thread m_thread;
};

}  // namespace kerf
