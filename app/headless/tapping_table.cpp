// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/headless/tapping_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "engine/process/tapping/trial_machine.h"

namespace kerf::headless {
namespace {

using namespace tapping;

struct Scenario {
    std::string name;
    DriveParams drive{};
    DriveParams assumed{};
    TrialScatter scatter{};
};

Tuning run(const Scenario& scenario, TunerKind kind, std::uint64_t seed) {
    TunerSetup setup;
    setup.kind = kind;
    setup.assumed = knownTo(scenario.drive, scenario.assumed);
    setup.initial = settingsOf(scenario.drive);
    setup.maxTaps = kMaxTaps;
    return runTuning(setup, scenario.drive, scenario.scatter, seed);
}

std::vector<Scenario> scenarios() {
    std::vector<Scenario> out;
    const auto add = [&](std::string name, auto change, TrialScatter scatter = {}) {
        Scenario scenario{std::move(name), {}, middlingDrive(), scatter};
        change(scenario);
        out.push_back(std::move(scenario));
    };
    add("A", [](Scenario&) {});
    add("A 1500 rpm", [](Scenario& s) { s.drive.speed_rpm = 1500.0; });
    add("A 4500 rpm", [](Scenario& s) { s.drive.speed_rpm = 4500.0; });
    add("A 6000 rpm", [](Scenario& s) { s.drive.speed_rpm = 6000.0; });
    add("A 12 rev", [](Scenario& s) { s.drive.depth_rev = 12.0; });
    add("A 30 rev, double load", [](Scenario& s) {
        s.drive.depth_rev = 30.0;
        s.drive.load_revPerS2 *= 2.0;
        s.drive.loadOut_revPerS2 *= 2.0;
    });
    add(
        "A, noise and scatter", [](Scenario&) {}, kShopFloor);
    add(
        "A slaved to the spindle", [](Scenario& s) { s.drive.slaved = 1.0; }, kShopFloor);
    const auto torqueLimited = [](Scenario& s) {
        s.drive.zKp_perS = 44.0;
        s.drive.spindleAccelMax_revPerS2 = 520.0;
    };
    add("B", torqueLimited);
    add("B, noise and scatter", torqueLimited, kShopFloor);
    for (const double delay_s : {0.001, 0.003}) {
        add(
            fmt::format("A, dead time {:g} ms unknown, bandwidth assumed +30 %", 1000.0 * delay_s),
            [delay_s](Scenario& s) {
                s.drive.zDelay_s = delay_s;
                s.assumed.zBandwidth_perS *= 1.3;
            },
            kShopFloor);
    }
    return out;
}

std::string figures(const ContourFigures& f) {
    return fmt::format("{:.2f} / {:.0f} / {:.1f}", f.saec_mm, f.peak_um, f.engagedPp_um);
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
}

/// Random machines: medians and the worst, like the rows above.
void printRandomMachines() {
    constexpr int kMachines = 12;
    constexpr std::uint64_t kSeed = 2024;
    std::string row = fmt::format("| {} random machines, noise and scatter: median (worst)", kMachines);
    for (const TunerKind kind : {TunerKind::Paper, TunerKind::Gain, TunerKind::Default}) {
        Random random(kSeed);
        std::vector<double> before, after, peak, pp, taps;
        for (int i = 0; i < kMachines; ++i) {
            const Scenario scenario{"", randomDrive(random), middlingDrive(), kShopFloor};
            const Tuning tuning = run(scenario, kind, kSeed + static_cast<std::uint64_t>(i));
            before.push_back(tuning.before.saec_mm);
            after.push_back(tuning.after.saec_mm);
            peak.push_back(tuning.after.peak_um);
            pp.push_back(tuning.after.engagedPp_um);
            taps.push_back(static_cast<double>(tuning.trials.size()));
        }
        if (kind == TunerKind::Paper) row += fmt::format(" | {:.2f}", median(before));
        row += fmt::format(" | {:.2f} / {:.0f} / {:.1f} ({:.2f} / {:.0f} / {:.1f}), {:g}", median(after), median(peak),
                           median(pp), std::ranges::max(after), std::ranges::max(peak), std::ranges::max(pp),
                           median(taps));
    }
    fmt::print("{} |\n", row);
}

}  // namespace

void printTappingTable() {
    fmt::print(
        "SAEC mm / peak µm / engaged peak-to-peak µm of the clean drive with the final settings, and taps used (at "
        "most {}).\n\n",
        kMaxTaps);
    fmt::print("| scenario | initial | paper, η .03 | gain | default |\n|---|---|---|---|---|\n");
    for (const Scenario& scenario : scenarios()) {
        std::string row = fmt::format("| {}", scenario.name);
        for (const TunerKind kind : {TunerKind::Paper, TunerKind::Gain, TunerKind::Default}) {
            const Tuning tuning = run(scenario, kind, 1);
            if (kind == TunerKind::Paper) row += fmt::format(" | {}", figures(tuning.before));
            row += fmt::format(" | {}, {}", figures(tuning.after), tuning.trials.size());
        }
        fmt::print("{} |\n", row);
    }
    printRandomMachines();
    std::fflush(stdout);
}

}  // namespace kerf::headless
