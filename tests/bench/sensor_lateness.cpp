// SPDX-License-Identifier: GPL-3.0-or-later
// What 64 channels at 1 Hz cost the cycle: an engine at 1 kHz, in turns without and with the reading process and its
// port, in one run, so that whatever else the computer does meets both alike.
//   sensor_lateness [blocks of each, 6] [seconds per block, 20]
// Prints CSV, a row per block and one for all blocks of a kind together.
#include <QCoreApplication>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/sensors/sensor_session.h"
#include "engine/machine/sensors/sensor_port.h"
#include "tests/support/boring_bench.h"
#include "tests/support/modbus_modules.h"

using namespace kerf;

namespace {

constexpr int kModules = 8;
constexpr int kPerModule = 8;

/// Bins of blocks of one kind, added up.
struct Together {
    std::array<std::uint64_t, TimeHistogram::kBins> bins{};
    std::uint64_t count{0};
    std::int64_t max_ns{0};
    void add(const TimeHistogram& one) {
        for (std::size_t i = 0; i < TimeHistogram::kBins; ++i) {
            bins[i] += one.bin(i);
        }
        count += one.count();
        max_ns = std::max(max_ns, one.max_ns());
    }
    void add(const Together& other) {
        for (std::size_t i = 0; i < TimeHistogram::kBins; ++i) {
            bins[i] += other.bins[i];
        }
        count += other.count;
        max_ns = std::max(max_ns, other.max_ns);
    }
    [[nodiscard]] double percentile_us(double share) const {
        std::uint64_t seen = 0;
        for (std::size_t i = 0; i < TimeHistogram::kBins; ++i) {
            seen += bins[i];
            if (static_cast<double>(seen) > share * static_cast<double>(count)) {
                return static_cast<double>(TimeHistogram::upperEdge_ns(i)) * 1e-3;
            }
        }
        return 0.0;
    }
};

void print(const char* kind, int block, const Together& all, int good) {
    std::printf("%s,%d,%llu,%.1f,%.1f,%.1f,%.1f,%d\n", kind, block, static_cast<unsigned long long>(all.count),
                all.percentile_us(0.5), all.percentile_us(0.99), all.percentile_us(0.999),
                static_cast<double>(all.max_ns) * 1e-3, good);
    std::fflush(stdout);
}

/// The engine on a thread of its own for so long; its lateness. `port`: what stands before the simulated machine.
TimeHistogram run(MachinePort& port, double seconds) {
    (void)port.connect();
    std::vector<std::unique_ptr<ProcessLoop>> loops;
    loops.push_back(std::make_unique<BoringLoop>());
    Engine engine(port, std::move(loops));
    engine.start();
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
    const TimeHistogram late = engine.status().stats.lateness;
    engine.stop();
    return late;
}

}  // namespace

int main(int argc, char** argv) {
    const QCoreApplication app(argc, argv);
    const int blocks = argc > 1 ? std::atoi(argv[1]) : 6;
    const double seconds = argc > 2 ? std::atof(argv[2]) : 20.0;
    test::ModbusModules modules;
    if (const QString why = test::ModbusModules::whyNot(); !why.isEmpty() || !modules.start()) {
        std::fprintf(stderr, "%s\n", qPrintable(why));
        return 1;
    }
    nlohmann::json file;
    for (int m = 0; m < kModules; ++m) {
        int id = 0;
        std::string name("M");
        name += std::to_string(m);
        file["modules"].push_back(
            {{"name", name}, {"transport", "tcp"}, {"host", "127.0.0.1"}, {"port", modules.addTcp(id)}});
        (void)modules.set(id, "input", 0, std::vector<int>(kPerModule, 215), 1);
        for (int k = 0; k < kPerModule; ++k) {
            file["channels"].push_back({{"name", name + "-" + std::to_string(k)},
                                        {"quantity", "temperature"},
                                        {"module", name},
                                        {"address", k},
                                        {"scale", 0.1}});
        }
    }
    std::ofstream("sensor_lateness.json") << file;
    std::printf("kind,block,cycles,p50_us,p99_us,p99.9_us,max_us,good_channels\n");
    Together without;
    Together with;
    for (int block = 0; block < blocks; ++block) {
        {
            test::BoringBench bench;
            Together one;
            one.add(run(*bench.machine, seconds));
            without.add(one);
            print("without", block, one, 0);
        }
        sensors::SensorSession session("sensor_lateness.json");
        if (!session.start()) {
            std::fprintf(stderr, "kerf-sensors does not start\n");
            return 1;
        }
        sensors::SensorFrame frame;
        std::this_thread::sleep_for(std::chrono::seconds(3));
        test::BoringBench bench;
        SensorPort::Params params;
        params.memoryName = session.memoryName();
        for (std::uint16_t k = 0; k < kModules * kPerModule; ++k) {
            params.temperatures.push_back(k);
        }
        SensorPort port(*bench.machine, params);
        Together one;
        one.add(run(port, seconds));
        with.add(one);
        int good = 0;
        if (session.latest(frame)) {
            for (std::size_t k = 0; k < frame.count; ++k) {
                good += frame.channel[k].quality == Quality::Good ? 1 : 0;
            }
        }
        print("with", block, one, good);
    }
    print("without", -1, without, 0);
    print("with", -1, with, kModules * kPerModule);
    return 0;
}
