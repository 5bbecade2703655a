// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <thread>

#include "engine/machine/linuxcnc/shared_link.h"
#include "tests/support/linuxcnc_control.h"
#include "tests/support/passed_before.h"

/// Tells lateness from wrongness in tests that run beside LinuxCNC in real time.
namespace kerf::test {

inline constexpr int kSkipped = 77;  ///< SKIP_RETURN_CODE of these tests
/// A control read at 1 kHz whose drive turns round in 10 ms is not to be judged on a computer that is later than this.
inline constexpr std::int64_t kTooLate_us = 8'000;
/// A bridge that is silent for longer has been ended, or has not begun: that is part of the tests.
inline constexpr std::int64_t kGone_us = 800'000;

/// The worst delay of a bare 1 ms clock here, and of the bridge's beat there.
class Lateness {
 public:
    Lateness() : m_thread([this] { watch(); }) {}
    ~Lateness() { (void)worst_us(); }
    Lateness(const Lateness&) = delete;
    Lateness& operator=(const Lateness&) = delete;
    /// Ends the watch.
    std::int64_t worst_us() {
        m_done.store(true);
        if (m_thread.joinable()) {
            m_thread.join();
        }
        return m_worst_us;
    }

 private:
    using Clock = std::chrono::steady_clock;
    static std::int64_t since_us(Clock::time_point then) {
        return std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - then).count();
    }
    void watch() {
        LinuxCncControl::goFirst();
        linuxcnc::SharedLink link;
        std::uint64_t beat = 0;
        Clock::time_point due = Clock::now();
        Clock::time_point beaten = due;
        while (!m_done.load()) {
            due = std::max(due + std::chrono::milliseconds(1), Clock::now());
            std::this_thread::sleep_until(due);
            m_worst_us = std::max(m_worst_us, since_us(due));
            linuxcnc::FromControl seen;
            linuxcnc::LinkMemory* memory = link.take();
            if (memory == nullptr || !memory->fromControl.latest(seen) || seen.beat == beat) {
                continue;
            }
            const std::int64_t gap_us = since_us(beaten);
            if (beat != 0 && seen.beat > beat && gap_us < kGone_us) {
                m_worst_us = std::max(m_worst_us, gap_us);
            }
            beat = seen.beat;
            beaten = Clock::now();
        }
    }

    std::atomic<bool> m_done{false};
    std::int64_t m_worst_us{0};
    std::thread m_thread;  // last: it uses the others
};

/// Runs `test`, unless it has passed with the very same programs and files before: skipped, and said. When it fails and
/// something was late by more than kTooLate_us, the computer was busy: said with the measured delay, and skipped. A
/// failure in time fails.
inline int runInTime(const std::function<int()>& test) {
    const PassedBefore before;
    const bool whole = QCoreApplication::arguments().size() == 1 && LinuxCncControl::whyNot().isEmpty();
    if (whole && before.passed()) {
        std::puts("SKIPPED: passed before with the very same programs and files (KERF_AGAIN=1 runs it again)");
        return kSkipped;
    }
    Lateness lateness;
    const int result = test();
    const std::int64_t worst_us = lateness.worst_us();
    const bool late = result != 0 && worst_us > kTooLate_us;
    std::printf("%sthis computer was late by %.1f ms at most (allowed: %.0f ms)\n", late ? "SKIPPED: " : "",
                static_cast<double>(worst_us) / 1000.0, static_cast<double>(kTooLate_us) / 1000.0);
    if (result == 0 && whole) {
        before.remember();
    }
    return late ? kSkipped : result;
}

}  // namespace kerf::test

#define KERF_APPLICATION_TEST_IN_TIME(Application, TestClass)                          \
    int main(int argc, char** argv) {                                                  \
        Application application(argc, argv);                                           \
        TestClass test;                                                                \
        return kerf::test::runInTime([&] { return QTest::qExec(&test, argc, argv); }); \
    }
#define KERF_TEST_IN_TIME(TestClass) KERF_APPLICATION_TEST_IN_TIME(QCoreApplication, TestClass)
#define KERF_GUI_TEST_IN_TIME(TestClass) KERF_APPLICATION_TEST_IN_TIME(QApplication, TestClass)
