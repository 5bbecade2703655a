// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <map>

#include "app/console/loop_modes.h"
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

/// Console, settings and engine around the modes.
struct Bench {
    Bench() {
        engine.caps.process[0].fitted = true;  // boring alone
    }
    console::LoopModes make() {
        return {engine, settings,
                [this](const std::string& key, const std::string& value) { settings.rows[key] = value; }};
    }
    [[nodiscard]] std::optional<LoopMode> asked() const {
        if (engine.commands.size() != 1) {
            return std::nullopt;
        }
        const auto* mode = std::get_if<SetLoopMode>(&engine.commands.front().action);
        return mode != nullptr && mode->process == ProcessId::Boring ? std::optional(mode->mode) : std::nullopt;
    }
    test::FakeEngine engine;
    FakeSettings settings;
};

}  // namespace

/// What a person has chosen comes back after a restart; what nobody has chosen never acts on a real machine.
class TestLoopModes : public QObject {
    Q_OBJECT
 private slots:
    void aNewRealMachineIsOnlyAdvised() {
        Bench bench;
        bench.engine.caps.simulated = false;
        bench.make().restore();
        QCOMPARE(bench.asked(), std::optional(LoopMode::Advise));
    }
    void aNewSimulatorIsControlled() {
        Bench bench;
        bench.make().restore();
        QCOMPARE(bench.asked(), std::optional(LoopMode::Control));
    }
    void theChosenModeComesBack() {
        Bench bench;
        {
            console::LoopModes modes = bench.make();
            modes.restore();
            bench.engine.loop(ProcessId::Boring).mode = LoopMode::Control;
            modes.poll();
            QVERIFY(bench.settings.rows.empty());  // nothing has been chosen yet
            bench.engine.loop(ProcessId::Boring).mode = LoopMode::Advise;
            modes.poll();
        }
        bench.engine.commands.clear();
        bench.make().restore();
        QCOMPARE(bench.asked(), std::optional(LoopMode::Advise));
    }
    void theModeBeforeTheEngineAnswersIsNotSaved() {
        Bench bench;
        bench.settings.rows["loop.mode.boring"] = "advise";
        console::LoopModes modes = bench.make();
        modes.restore();
        modes.poll();  // the engine's status still says off
        QCOMPARE(bench.settings.rows["loop.mode.boring"], std::string("advise"));
    }
};

QTEST_GUILESS_MAIN(TestLoopModes)
#include "tst_loop_modes.moc"
