// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <functional>
#include <thread>

/// Tells lateness from wrongness in tests that run beside another program in real time.
namespace kerf::test {

inline constexpr int kSkipped = 77;  ///< SKIP_RETURN_CODE of these tests
/// A control whose watchdog bites at 60 ms, read at 1 kHz, is not to be judged on a computer that is later than this.
inline constexpr std::chrono::milliseconds kTooLate{20};

/// Runs `test` beside a bare 1 ms clock. When it fails and the clock was late by more than kTooLate, the computer was
/// busy: said with the measured delay, and skipped. A failure in time fails.
inline int runInTime(const std::function<int()>& test) {
    using Clock = std::chrono::steady_clock;
    std::atomic<bool> done{false};
    std::atomic<std::int64_t> worst_us{0};
    std::thread watch([&] {
        auto due = Clock::now();
        while (!done.load()) {
            due = std::max(due + std::chrono::milliseconds(1), Clock::now());
            std::this_thread::sleep_until(due);
            const auto late = std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - due).count();
            worst_us.store(std::max<std::int64_t>(worst_us.load(), late));
        }
    });
    const int result = test();
    done.store(true);
    watch.join();
    const double worst_ms = static_cast<double>(worst_us.load()) / 1000.0;
    if (result != 0 && worst_us.load() > std::chrono::microseconds(kTooLate).count()) {
        std::printf("SKIPPED: this computer was busy: a clock of 1 ms was late by %.1f ms (at most %lld are allowed)\n",
                    worst_ms, static_cast<long long>(kTooLate.count()));
        return kSkipped;
    }
    std::printf("a clock of 1 ms beside the test was late by at most %.1f ms\n", worst_ms);
    return result;
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
