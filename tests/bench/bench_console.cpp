// SPDX-License-Identifier: GPL-3.0-or-later
// Frames per second of the live charts on the real console, its engine running at 1 kHz beside it: five seconds of one
// bore in real time at each screen size. Offscreen, so without a graphics card.
#include <benchmark/benchmark.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QEvent>
#include <algorithm>
#include <ctime>
#include <map>

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

void liveConsole(benchmark::State& state) {
    const QSize size(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    for (auto _ : state) {
        test::ConsoleBench bench;
        console::Options options;
        const double speed = static_cast<double>(state.range(2));
        options.simulationSpeed = speed;
        options.seed = 5;
        bench.setOwnThread(true);
        bench.start(options);
        if (!QTest::qWaitFor([&] { return bench.up(); }, 20'000)) {
            state.SkipWithError("the console did not start");
            return;
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
