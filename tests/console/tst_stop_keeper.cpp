// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <map>

#include "app/console/stop_keeper.h"
#include "tests/support/fake_engine.h"

using namespace kerf;

namespace {

class FakeSettings final : public SettingsReader {
 public:
    Result<std::optional<std::string>> setting(const std::string& key) override {
        const auto found = rows.find(key);
        return found == rows.end() ? std::optional<std::string>() : std::optional(found->second);
    }
    Result<std::vector<SettingRow>> settings() override { return std::vector<SettingRow>{}; }
    std::map<std::string, std::string> rows{};
};

struct Bench {
    console::StopKeeper make() {
        return {engine, settings, [this](const std::string& key, const std::string& value, const std::string&) {
                    settings.rows[key] = value;
                    ++saved;
                }};
    }
    [[nodiscard]] StopSlots restored() const {
        const auto* restore = std::get_if<RestoreStops>(&engine.commands.front().action);
        return restore != nullptr ? restore->stops : StopSlots{};
    }
    test::FakeEngine engine;
    FakeSettings settings;
    int saved{0};
};

}  // namespace

/// A stop is in the data file as long as nobody has released it, and comes back with the next console.
class TestStopKeeper : public QObject {
    Q_OBJECT
 private slots:
    void aStopComesBackAfterARestart() {
        Bench bench;
        {
            console::StopKeeper keeper = bench.make();
            bench.engine.fake.stops[1].slot = {3, 2, StopKind::FeedHold, 201};
            keeper.poll();
            keeper.poll();
            QCOMPARE(bench.saved, 1);
        }
        console::StopKeeper next = bench.make();
        next.restore();
        QVERIFY(bench.restored()[1] == (StopSlot{3, 2, StopKind::FeedHold, 201}));
        QVERIFY(!bench.restored()[0].active());
    }
    void aReleaseIsKeptToo() {
        Bench bench;
        console::StopKeeper keeper = bench.make();
        bench.engine.fake.stops[4].slot = {1, 0, StopKind::InWork, 502};
        keeper.poll();
        bench.engine.fake.stops[4].slot.released = 1;
        keeper.poll();
        console::StopKeeper next = bench.make();
        next.restore();
        QVERIFY(!bench.restored()[4].active());
        QCOMPARE(bench.restored()[4].number, 1U);
    }
    void anEngineThatDoesNotKnowItYetDoesNotForgetIt() {
        Bench bench;
        bench.settings.rows["stop.milling"] = "5 4 3 202";
        console::StopKeeper keeper = bench.make();
        keeper.poll();  // the engine's status is still empty
        QCOMPARE(bench.saved, 0);
        QCOMPARE(bench.settings.rows["stop.milling"], std::string("5 4 3 202"));
    }
    void whatCannotBeReadMayHaveBeenAStop() {
        for (const char* text : {"", "x", "1", "1 0 9 201", "99999999999 0 1 1"}) {
            Bench bench;
            bench.settings.rows["stop.turning"] = text;
            console::StopKeeper keeper = bench.make();
            keeper.restore();
            QVERIFY(bench.restored()[2].active());
            QVERIFY(!bench.restored()[1].active());
        }
    }
};
QTEST_GUILESS_MAIN(TestStopKeeper)
#include "tst_stop_keeper.moc"
