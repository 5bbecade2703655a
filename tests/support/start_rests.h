// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>
#include <algorithm>

#include "tests/support/layout_check.h"
#include "tests/support/page_bench.h"
#include "ui/widgets/action_button.h"

namespace kerf::test {

/// What a button says has room on it in both languages; pictures of it on request.
inline void roomForWords(PageBench& bench, const char* button, const char* what) {
    const auto* start = bench.find<ui::ActionButton>(button);
    for (const ui::Language language : {ui::Language::Korean, ui::Language::English}) {
        ui::Preferences face = bench.look.preferences();
        face.language = language;
        bench.look.apply(face);
        bench.client.tick();
        for (int i = 0; i < 3; ++i) {
            QApplication::processEvents();
        }
        if (const QString folder = qEnvironmentVariable("KERF_SAVE_PAGES"); !folder.isEmpty()) {
            bench.save(folder + u'/' + QLatin1String(button) + u'_' + QLatin1String(what) +
                       (language == ui::Language::Korean ? QStringLiteral("_ko.png") : QStringLiteral(".png")));
        }
        if (!start->parentWidget()->rect().contains(start->geometry())) {
            continue;  // Overview without its cards lays nothing out
        }
        const QStringList clipped = clippedTexts(&bench.window).filter(u'#' + QLatin1String(button));
        QVERIFY2(clipped.isEmpty(), qPrintable(QLatin1String(what) + u'\n' + clipped.join(u'\n')));
    }
}

/// A start rests while what the next part is made with is on its way, and until the screen shows what the engine has:
/// what is sent in the end names that. On a page whose start is possible; `asks`: a question comes before anything is
/// sent.
inline void startRests(PageBench& bench, const char* button, ProcessId process, bool asks = false) {
    ui::Services& services = bench.services;
    FakeEngine& engine = bench.engine;
    ui::EngineClient& client = bench.client;
    auto* start = bench.find<ui::ActionButton>(button);
    QVERIFY(start != nullptr);
    bool underWay = true;
    services.underWay = [&underWay, process](ProcessId asked) { return asked == process && underWay; };
    const auto starts = [&engine] {
        return std::ranges::count_if(
            engine.commands, [](const Command& command) { return std::holds_alternative<StartPart>(command.action); });
    };
    client.tick();
    QVERIFY(!start->isEnabled());
    QVERIFY2(start->reason().contains(QStringLiteral("just stored")), qPrintable(start->reason()));
    roomForWords(bench, button, "rests");
    underWay = false;
    client.tick();
    QVERIFY2(start->isEnabled(), qPrintable(start->reason()));
    // The engine has something newer, and the screen does not show it yet.
    const WorkOrder newer{7, 3, 0};
    engine.fake.orders[static_cast<std::size_t>(process)] = newer;
    QTest::mouseClick(start, Qt::LeftButton);
    QCOMPARE(starts(), std::ptrdiff_t{0});
    QVERIFY(!start->isEnabled());
    client.tick();
    QVERIFY2(start->isEnabled(), qPrintable(start->reason()));
    services.underWay = {};
    if (asks) {
        return;
    }
    QTest::mouseClick(start, Qt::LeftButton);
    QCOMPARE(starts(), std::ptrdiff_t{1});
    QVERIFY(std::get<StartPart>(engine.commands.back().action).order == newer);
}

/// Whatever keeps a machine from starting keeps the button off, in the words of all pages.
inline void startSaysWhyNot(PageBench& bench, const char* button) {
    const Status free = bench.engine.fake;
    const auto says = [&](const char* words, const auto& change) {
        bench.engine.fake = free;
        change(bench.engine.fake);
        bench.client.tick();
        const auto* start = bench.find<ui::ActionButton>(button);
        QVERIFY2(!start->isEnabled(), words);
        QVERIFY2(start->reason().contains(QLatin1String(words)), qPrintable(start->reason()));
        roomForWords(bench, button, words);
    };
    says("No link", [](Status& s) { s.link = LinkState::Down; });
    says("Emergency stop", [](Status& s) { s.emergencyStop = true; });
    says("is off", [](Status& s) { s.machineOn = false; });
    says("Hold", [](Status& s) { s.held = true; });
    says("A stop stands", [](Status& s) { s.stops[0].slot = {7, 6, StopKind::FeedHold, 201}; });
    says("not stored yet", [](Status& s) { s.partsBlocked = true; });
    for (const ProcessId other :
         {ProcessId::Boring, ProcessId::Milling, ProcessId::Turning, ProcessId::Thermal, ProcessId::Tapping}) {
        for (const ProgramState program : {ProgramState::Running, ProgramState::Paused}) {
            bench.engine.fake = free;
            bench.engine.fake.program = program;
            bench.engine.fake.programProcess = other;
            bench.client.tick();
            const auto* start = bench.find<ui::ActionButton>(button);
            QVERIFY(!start->isEnabled() && !start->reason().isEmpty());
        }
    }
    bench.engine.fake = free;
    bench.client.tick();
    QVERIFY2(bench.find<ui::ActionButton>(button)->isEnabled(),
             qPrintable(bench.find<ui::ActionButton>(button)->reason()));
}

}  // namespace kerf::test
