// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>
#include <cmath>
#include <memory>

#include "engine/core/random.h"
#include "tests/support/fake_boring_service.h"
#include "tests/support/fake_engine.h"
#include "ui/pages/boring/boring_page.h"
#include "ui/pages/milling/milling_page.h"
#include "ui/pages/tapping/tapping_page.h"
#include "ui/pages/thermal/thermal_page.h"
#include "ui/pages/turning/turning_page.h"
#include "ui/shell/main_window.h"
#include "ui/theme/look.h"

namespace kerf::test {

inline constexpr AlarmSpec kToolAlarm{101,
                                      1,
                                      KERF_TEXT("Tool broken"),
                                      KERF_TEXT("The force fell to nothing inside the cut."),
                                      KERF_TEXT("Feed hold is on. The part is probably scrap."),
                                      KERF_TEXT("Retract, change the tool, release the hold.")};
inline constexpr AlarmSpec kSensorAlarm{401,
                                        2,
                                        KERF_TEXT("Thermocouple disagrees with its neighbours"),
                                        KERF_TEXT("It is loose, wet or broken."),
                                        KERF_TEXT("It is left out; the interval is wider."),
                                        KERF_TEXT("Check its mounting.")};

/// The pages as the console has them.
inline ui::PageList allPages() {
    return ui::standardPages({ui::boringPageEntry(), ui::millingPageEntry(), ui::turningPageEntry(),
                              ui::thermalPageEntry(), ui::tappingPageEntry()});
}

/// The console's frame on a fake engine with a plausible machine behind it.
struct ShellBench {
    explicit ShellBench(ui::PageList pages = allPages(), ui::Preferences preferences = {}) : look(96.0) {
        look.apply(preferences);
        engine.specs[kToolAlarm.code] = kToolAlarm;
        engine.specs[kSensorAlarm.code] = kSensorAlarm;
        Status& s = engine.fake;
        s.machineTime_ns = 3'600'000'000'000;
        s.simulationSpeed = 20.0;
        s.actualFeed_mmPerS = {1.53, s.machineTime_ns, Quality::Good};
        s.spindleSpeed_rpm = {400.0, s.machineTime_ns, Quality::Good};
        for (std::size_t i = 0; i < kAxisCount; ++i) {
            s.position_mm[i] = {-12.3456 + 120.0 * static_cast<double>(i), s.machineTime_ns, Quality::Good};
        }
        s.program = ProgramState::Running;
        s.boring.cutting = true;
        s.boring.feed_mmPerRev = {0.2301, s.machineTime_ns, Quality::Good};
        s.boring.overhang_mm = {133.0, s.machineTime_ns, Quality::Good};
        s.boring.remaining_s = 84.0;
        s.boring.partsCut = 6;
        engine.caps.cycleStart.fitted = true;
        LoopStatus& boring = engine.loop(ProcessId::Boring);
        boring.mode = LoopMode::Control;
        boring.state = LoopState::Controlling;
        boring.reason = Sentence(KERF_TEXT("Feed follows the schedule of part %1."), SentenceArg(7.0, 0));
        Random random(7);
        for (int i = 0; i < 200'000; ++i) {
            const double u = random.uniform();
            s.stats.cost.add(
                static_cast<std::int64_t>(4'000.0 + 3'000.0 * u * u - 9'000.0 * std::log(1.0 - 0.999 * u)));
            s.stats.lateness.add(static_cast<std::int64_t>(50'000.0 - 20'000.0 * std::log(1.0 - 0.9999 * u)));
        }
        s.stats.cycles = 200'000;
        s.stats.overruns = 3;
        services = std::make_unique<ui::Services>(ui::Services{engine});
        service.runParts(6);
        service.cutPart();
        services->boringService = &service;
        services->signOn.accounts = {{QStringLiteral("Kim Minji"), ui::Role::Operator, {}},
                                     {QStringLiteral("A. Berger"), ui::Role::Engineer, {}}};
        window = std::make_unique<ui::MainWindow>(look, *services, std::move(pages));
    }
    void raise(const AlarmSpec& spec, bool raised = true) {
        engine.alarms.push_back({spec.code, raised, engine.fake.machineTime_ns, Sentence()});
        window->client().tick();
    }

    FakeEngine engine;
    FakeBoringService service;
    ui::Look look;
    std::unique_ptr<ui::Services> services;
    std::unique_ptr<ui::MainWindow> window;
};

}  // namespace kerf::test
