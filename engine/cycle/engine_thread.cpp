// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/cycle/engine_thread.h"

#include <pthread.h>
#include <sched.h>
#include <time.h>

#include <algorithm>

#include "engine/cycle/real_time.h"

namespace kerf {
namespace {

constexpr int kFifoPriority = 60;                        // above ordinary threads, below a control's servo thread
constexpr std::int64_t kSampleInterval_ns = 10'000'000;  // 100 chart samples per second
constexpr std::int64_t kStatusInterval_ns = 1'000'000;
constexpr std::int64_t kWindow_ns = 1'000'000'000;
constexpr double kBatchShare = 0.8;  // of a period, for accelerated simulation

std::int64_t monotonic_ns() {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return static_cast<std::int64_t>(now.tv_sec) * 1'000'000'000 + now.tv_nsec;
}

void sleepUntil(std::int64_t deadline_ns) {
    timespec when{};
    when.tv_sec = static_cast<time_t>(deadline_ns / 1'000'000'000);
    when.tv_nsec = static_cast<long>(deadline_ns % 1'000'000'000);
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &when, nullptr) != 0) {
    }
}

/// Whether the thread goes before all other work from now on.
bool schedule(bool realTime) {
    sched_param param{};
    param.sched_priority = realTime ? kFifoPriority : 0;
    return pthread_setschedparam(pthread_self(), realTime ? SCHED_FIFO : SCHED_OTHER, &param) == 0 && realTime;
}

}  // namespace

void EngineThread::start() {
    m_stop = false;
    m_thread = std::thread([this] { run(); });
}

void EngineThread::stop() noexcept {
    m_stop = true;
    if (m_thread.joinable()) {
        m_thread.join();
    }
}

std::int64_t EngineThread::runBatch(std::int64_t wake_ns) noexcept {
    const double speed = m_simulated ? m_cycle.simulationSpeed() : 1.0;
    const auto budgetEnd_ns = wake_ns + static_cast<std::int64_t>(kBatchShare * static_cast<double>(m_period_ns));
    m_stepsOwed = speed > 0.0 ? std::min(m_stepsOwed + speed, 2.0 * speed) : 1e9;
    std::int64_t before_ns = wake_ns;
    while (m_stepsOwed >= 1.0) {
        m_machineTime_ns = m_simulated ? m_machineTime_ns + m_period_ns : wake_ns;
        m_cycle.step(m_machineTime_ns);
        m_stepsOwed -= 1.0;
        ++m_stats.cycles;
        const std::int64_t after_ns = monotonic_ns();
        m_stats.cost.add(after_ns - before_ns);
        before_ns = after_ns;
        if (m_simulated && after_ns > budgetEnd_ns) {
            m_stepsOwed = std::min(m_stepsOwed, speed);  // slower than asked; shown as achieved speed
            break;
        }
    }
    return before_ns;
}

void EngineThread::run() noexcept {
    // A simulation faster than time has no deadline that matters, and at this priority it would take a processor away
    // from everything else.
    const auto wantsRealTime = [this] { return !m_simulated || m_cycle.simulationSpeed() == 1.0; };
    bool realTime = wantsRealTime();
    prefault();
    if (!m_simulated) {  // its pages stay, whatever else this computer does
        (void)lockMemory();
    }
    m_stats.realTimeScheduling = realTime && schedule(true);
    std::int64_t deadline_ns = monotonic_ns();
    std::int64_t nextSample_ns = deadline_ns;
    std::int64_t nextStatus_ns = deadline_ns;
    std::int64_t windowBegin_ns = deadline_ns;
    std::int64_t windowMachine_ns = m_machineTime_ns;
    std::uint64_t windowOverruns = 0;
    while (!m_stop.load(std::memory_order_relaxed)) {
        sleepUntil(deadline_ns);
        const std::int64_t wake_ns = monotonic_ns();
        m_stats.lateness.add(std::max<std::int64_t>(wake_ns - deadline_ns, 0));
        const std::int64_t end_ns = runBatch(wake_ns);
        if (end_ns >= nextSample_ns) {
            m_cycle.emitSample(end_ns);
            nextSample_ns = std::max(nextSample_ns + kSampleInterval_ns, end_ns);
        }
        if (end_ns >= nextStatus_ns) {
            m_cycle.publish(m_stats);
            nextStatus_ns = std::max(nextStatus_ns + kStatusInterval_ns, end_ns);
        }
        if (wantsRealTime() != realTime) {
            realTime = !realTime;
            m_stats.realTimeScheduling = schedule(realTime);
        }
        deadline_ns += m_period_ns;
        const std::int64_t late_ns = monotonic_ns() - deadline_ns;
        if (late_ns > 0) {
            const std::int64_t missed = late_ns / m_period_ns + 1;
            m_stats.overruns += static_cast<std::uint64_t>(missed);
            deadline_ns += missed * m_period_ns;
        }
        if (end_ns - windowBegin_ns >= kWindow_ns) {
            const auto wall = static_cast<double>(end_ns - windowBegin_ns);
            m_stats.achievedSpeed = static_cast<double>(m_machineTime_ns - windowMachine_ns) / wall;
            // A share of more than 1 % of all periods in the last second is worth a line to the operator.
            const double periods = wall / static_cast<double>(m_period_ns);
            m_cycle.reportOverruns(static_cast<double>(m_stats.overruns - windowOverruns) > 0.01 * periods &&
                                   !m_simulated);
            windowBegin_ns = end_ns;
            windowMachine_ns = m_machineTime_ns;
            windowOverruns = m_stats.overruns;
        }
    }
    m_cycle.publish(m_stats);
}

}  // namespace kerf
