// SPDX-License-Identifier: GPL-3.0-or-later
// Frames per second of the live charts on the real console, its engine running at 1 kHz beside it: five seconds of one
// bore in real time at each screen size. Offscreen, so without a graphics card.
#include <benchmark/benchmark.h>
#include <pthread.h>
#include <sched.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QEvent>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <ctime>
#include <map>
#include <thread>

#include "tests/support/console_bench.h"
#include "ui/charts/chart.h"

namespace {

using namespace kerf;

constexpr int kMeasured_ms = 5000;

/// Counts how often each chart is painted.
class PaintCounter : public QObject {
 public:
    std::map<QObject*, int> frames{};
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::Paint) {
            ++frames[watched];
        }
        return false;
    }
};

template <class Action>
void send(test::ConsoleBench& bench, const Action& action) {
    Command command;
    command.action = action;
    (void)bench.console().engine().send(command);
}

double threadTime_s() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

/// The console on the Boring page, its engine on a thread of its own, in the middle of a bore.
bool beginCut(test::ConsoleBench& bench, const QSize& size, double speed) {
    console::Options options;
    options.simulationSpeed = speed;
    options.seed = 5;
    bench.setOwnThread(true);
    bench.start(options);
    if (!QTest::qWaitFor([&] { return bench.up(); }, 20'000)) {
        return false;
    }
    ui::MainWindow* window = bench.console().window();
    window->resize(size);
    window->showPage("boring");
    // The shift before the operator came is made as fast as it can be.
    (void)QTest::qWaitFor([&] { return bench.console().shift()->prepared(); }, 60'000);
    send(bench, SetSimulationSpeed{speed});
    (void)QTest::qWaitFor([&] { return bench.status().simulationSpeed == speed; }, 10'000);
    if (!bench.status().boring.cutting) {
        send(bench, StartPart{ProcessId::Boring});
        (void)QTest::qWaitFor([&] { return bench.status().boring.cutting; }, 10'000);
    }
    QTest::qWait(500);
    return true;
}

std::int64_t monotonic_ns() {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return static_cast<std::int64_t>(now.tv_sec) * 1'000'000'000 + now.tv_nsec;
}

/// Nothing but clock_nanosleep every millisecond, at the engine's priority: what this computer can do at best.
class BareLoop {
 public:
    BareLoop() : m_thread([this] { run(); }) {}
    ~BareLoop() { (void)stop(); }
    TimeHistogram stop() {
        m_stop = true;
        if (m_thread.joinable()) {
            m_thread.join();
        }
        return m_late;
    }

 private:
    void run() {
        constexpr std::int64_t kPeriod_ns = 1'000'000;
        sched_param param{};
        param.sched_priority = 60;
        (void)pthread_setschedparam(pthread_self(), SCHED_FIFO, &param);
        std::int64_t deadline_ns = monotonic_ns();
        while (!m_stop) {
            timespec when{};
            when.tv_sec = static_cast<time_t>(deadline_ns / 1'000'000'000);
            when.tv_nsec = static_cast<long>(deadline_ns % 1'000'000'000);
            while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &when, nullptr) != 0) {
            }
            const std::int64_t late_ns = std::max<std::int64_t>(monotonic_ns() - deadline_ns, 0);
            m_late.add(late_ns);
            deadline_ns += kPeriod_ns * (1 + late_ns / kPeriod_ns);
        }
    }

    std::atomic<bool> m_stop{false};
    TimeHistogram m_late{};
    std::thread m_thread;
};

/// Percentile of what was added between two histograms; within a bin in proportion of its logarithm.
double percentile_us(const TimeHistogram& before, const TimeHistogram& after, double share) {
    const double wanted = share * static_cast<double>(after.count() - before.count());
    double seen = 0.0;
    for (std::size_t i = 0; i < TimeHistogram::kBins; ++i) {
        const auto here = static_cast<double>(after.bin(i) - before.bin(i));
        if (here > 0.0 && seen + here >= wanted) {
            const double high = static_cast<double>(TimeHistogram::upperEdge_ns(i));
            const double low = i == 0 ? 1.0 : static_cast<double>(TimeHistogram::upperEdge_ns(i - 1));
            return 1e-3 * low * std::pow(high / low, (wanted - seen) / here);
        }
        seen += here;
    }
    return 0.0;
}

/// How late the engine wakes with the screen drawing a cut, and a bare loop beside it in the same seconds. Run it on
/// one processor (taskset -c 0): a virtual machine may be late on one of its processors and not on the other.
void wakeUp(benchmark::State& state) {
    for (auto _ : state) {
        test::ConsoleBench bench;
        if (!beginCut(bench, {1920, 1080}, 1.0)) {
            state.SkipWithError("the console did not start");
            return;
        }
        const TimeHistogram before = bench.status().stats.lateness;
        BareLoop bare;
        QTest::qWait(8 * kMeasured_ms);
        const TimeHistogram bareLate = bare.stop();
        const TimeHistogram after = bench.status().stats.lateness;
        for (const auto& [name, share] : {std::pair("p50", 0.5), std::pair("p99", 0.99), std::pair("p999", 0.999)}) {
            state.counters[std::string("engine_us_") + name] = percentile_us(before, after, share);
            state.counters[std::string("bare_us_") + name] = percentile_us({}, bareLate, share);
        }
        state.counters["wakeups"] = static_cast<double>(after.count() - before.count());
        state.counters["cutting"] = bench.status().boring.cutting ? 1 : 0;
        state.counters["real_time"] = bench.status().stats.realTimeScheduling ? 1 : 0;
    }
}
BENCHMARK(wakeUp)->Iterations(1)->Unit(benchmark::kMillisecond)->UseRealTime();

void liveConsole(benchmark::State& state) {
    const QSize size(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    for (auto _ : state) {
        test::ConsoleBench bench;
        if (!beginCut(bench, size, static_cast<double>(state.range(2)))) {
            state.SkipWithError("the console did not start");
            return;
        }
        ui::MainWindow* window = bench.console().window();
        PaintCounter counter;
        for (ui::Chart* chart : window->findChildren<ui::Chart*>()) {
            if (chart->isVisibleTo(window)) {
                chart->installEventFilter(&counter);
            }
        }
        const CycleStats before = bench.status().stats;
        QElapsedTimer clock;
        clock.start();
        const double before_s = threadTime_s();
        QTest::qWait(kMeasured_ms);
        state.counters["gui_core_percent"] =
            100.0 * (threadTime_s() - before_s) / (static_cast<double>(clock.nsecsElapsed()) * 1e-9);
        const double seconds = static_cast<double>(clock.nsecsElapsed()) * 1e-9;
        const CycleStats after = bench.status().stats;
        int most = 0;
        for (const auto& [chart, frames] : counter.frames) {
            most = std::max(most, frames);
        }
        state.counters["frames_per_second"] = most / seconds;
        state.counters["cycles_per_second"] = static_cast<double>(after.cycles - before.cycles) / seconds;
        state.counters["samples_dropped"] = static_cast<double>(after.droppedSamples - before.droppedSamples);
        state.counters["cutting"] = bench.status().boring.cutting ? 1 : 0;
    }
}
BENCHMARK(liveConsole)
    ->ArgNames({"width", "height", "speed"})
    ->Args({1280, 800, 1})
    ->Args({1920, 1080, 1})
    ->Args({3840, 2160, 1})
    ->Args({1920, 1080, 20})
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// What the screen costs while nothing is cut: CPU time of the GUI thread alone, every page at 1280 × 800, a bore
/// waiting for its diameter; the engine runs on its own thread at ×20.
void idlePages(benchmark::State& state) {
    for (auto _ : state) {
        test::ConsoleBench bench;
        bench.setOwnThread(true);
        bench.start(console::Options{});
        const auto idle = [&] {
            return bench.up() && bench.console().shift()->prepared() && bench.service().awaiting.has_value();
        };
        if (!QTest::qWaitFor(idle, 240'000)) {
            state.SkipWithError("the console did not come to rest");
            return;
        }
        ui::MainWindow* window = bench.console().window();
        for (const ui::PageEntry& page : window->pages()) {
            window->showPage(page.key);
            QTest::qWait(1000);
            PaintCounter counter;
            for (QWidget* widget : window->findChildren<QWidget*>()) {
                if (widget->isVisibleTo(window)) {
                    widget->installEventFilter(&counter);
                }
            }
            QElapsedTimer clock;
            clock.start();
            const double before_s = threadTime_s();
            QTest::qWait(kMeasured_ms);
            const double wall_s = static_cast<double>(clock.nsecsElapsed()) * 1e-9;
            state.counters[std::string(page.key) + "_core_percent"] = 100.0 * (threadTime_s() - before_s) / wall_s;
            int painted = 0;
            for (const auto& [widget, frames] : counter.frames) {
                painted += frames;
            }
            state.counters[std::string(page.key) + "_paints_per_s"] = painted / wall_s;
        }
    }
}
BENCHMARK(idlePages)->Iterations(1)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
