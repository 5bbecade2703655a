// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>
#include <algorithm>

#include "tests/support/fake_engine.h"
#include "ui/link/engine_client.h"
#include "ui/shell/services.h"
#include "ui/widgets/action_button.h"

namespace kerf::test {

/// A start rests while what the next part is made with is on its way, and until the screen shows what the engine has:
/// what is sent in the end names that. On a page whose start is possible; `asks`: a question comes before anything is
/// sent.
inline void startRests(ui::Services& services, FakeEngine& engine, ui::EngineClient& client, ui::ActionButton* start,
                       ProcessId process, bool asks = false) {
    QVERIFY(start != nullptr);
    bool underWay = true;
    services.underWay = [&underWay, process](ProcessId asked) { return asked == process && underWay; };
    const auto starts = [&engine] {
        return std::ranges::count_if(
            engine.commands, [](const Command& command) { return std::holds_alternative<StartPart>(command.action); });
    };
    client.tick();
    QVERIFY(!start->isEnabled());
    QVERIFY2(start->reason().contains(QStringLiteral("what was stored last")), qPrintable(start->reason()));
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

}  // namespace kerf::test
