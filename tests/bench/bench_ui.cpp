// SPDX-License-Identifier: GPL-3.0-or-later
// What a frame of a live chart costs with five minutes of samples behind it, drawn as a screen draws it (no OpenGL).
#include <benchmark/benchmark.h>

#include <QApplication>
#include <QImage>
#include <cmath>

#include "ui/charts/live_plot.h"

namespace {

using namespace kerf::ui;

constexpr double kWindow_s = 300.0;
constexpr double kSampleRate_Hz = 100.0;

/// A part a minute: the feed falls along the bore; what is cut follows with 2 % of ripple.
double schedule(double t_s) {
    return 0.09 + 0.16 * std::exp(-3.0 * std::fmod(t_s, 60.0) / 60.0);
}
double signal(double t_s) {
    return schedule(t_s) * (1.0 + 0.02 * std::sin(97.0 * t_s));
}

/// One display tick: the samples of 1/60 s, the axis moved on, the whole chart painted.
void liveFrame(benchmark::State& state) {
    Look look(96.0);
    LivePlot plot(look, kWindow_s);
    plot.setXAxis(QStringLiteral("time"), "s");
    plot.setYAxis(QStringLiteral("feed"), "mm/rev");
    const auto wanted = plot.addCurve({Token::Wanted, Chart::Kind::Dashed});
    const auto live = plot.addCurve({Token::Measured});
    plot.resize(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    plot.show();
    double t_s = 0.0;
    const auto take = [&](double until_s) {
        for (; t_s < until_s; t_s += 1.0 / kSampleRate_Hz) {
            plot.append(wanted, t_s, schedule(t_s));
            plot.append(live, t_s, signal(t_s));
        }
    };
    take(kWindow_s + 1.0);
    plot.advance(t_s);
    QApplication::processEvents();
    QImage screen(plot.size(), QImage::Format_ARGB32_Premultiplied);
    double now_s = t_s;
    for (auto _ : state) {
        now_s += 1.0 / 60.0;
        take(now_s);
        plot.advance(now_s);
        static_cast<QWidget&>(plot).render(&screen);
        benchmark::DoNotOptimize(screen.constBits());
    }
    state.counters["frames_per_second"] =
        benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
    state.counters["points_kept"] = kWindow_s * kSampleRate_Hz;
}
BENCHMARK(liveFrame)
    ->Args({720, 300})
    ->Args({1600, 600})
    ->Args({3300, 1200})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void decimation(benchmark::State& state) {
    std::vector<QPointF> points;
    for (int i = 0; i < static_cast<int>(kWindow_s * kSampleRate_Hz); ++i) {
        points.emplace_back(i / kSampleRate_Hz, signal(i / kSampleRate_Hz));
    }
    QList<QPointF> out;
    for (auto _ : state) {
        decimate(points, 0.0, kWindow_s, 700, out);
        benchmark::DoNotOptimize(out.constData());
    }
}
BENCHMARK(decimation)->Unit(benchmark::kMicrosecond);

}  // namespace

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
