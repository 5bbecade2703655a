// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>
#include <cstdio>

#include "app/service/boring/boring_recipe.h"
#include "app/service/tapping/tapping_tuning_json.h"
#include "engine/core/random.h"
#include "engine/process/boring/model.h"
#include "tests/support/console_bench.h"
#include "tests/support/lateness.h"
#include "tests/support/linuxcnc_control.h"
#include "ui/pages/tapping/trial_bars.h"
#include "ui/widgets/lamp.h"

using namespace kerf;

/// The real console on LinuxCNC's own simulator, offscreen, through its widgets: it starts before the control, finds
/// it, makes a lot with entries, tunes its tapping, and takes the control over again after its restart.
class TestConsoleLinuxCnc : public QObject {
    Q_OBJECT

    static constexpr std::uint32_t kParts = 6;

    /// Deep enough to tell feed from overhang, short enough for a test in real time.
    [[nodiscard]] static BoringRecipe shortBore() {
        BoringRecipe recipe;
        recipe.overhangFrom_mm = 40.0;
        recipe.overhangTo_mm = 120.0;
        recipe.spindleSpeed_rpm = 6000.0;
        recipe.firstFeed_mmPerRev = 0.3;
        recipe.depths = {{"top", 40.0}, {"bottom", 120.0}};
        return recipe;
    }
    [[nodiscard]] static double trueDeflection_mm(double feed_mmPerRev, double overhang_mm) {
        return 0.0871 * std::pow(feed_mmPerRev, 0.5025) * std::pow(overhang_mm, 0.2676);
    }
    [[nodiscard]] static double trueFeed_mmPerRev(double overhang_mm) {
        return std::pow(shortBore().targetDeflection_mm / trueDeflection_mm(1.0, overhang_mm), 1.0 / 0.5025);
    }
    /// What a gauge finds in a bore that this tool has cut with the schedule the part began with.
    [[nodiscard]] double gauged_mm(const BorePartView& part, double overhang_mm) {
        const BoringRecipe recipe = shortBore();
        const double deflection_mm = trueDeflection_mm(part.schedule.feed_mmPerRev(overhang_mm), overhang_mm) +
                                     0.5 * recipe.sigma_mm * m_gauge.gauss();
        return boring::diameterFromDeflection_mm(deflection_mm, recipe.targetDiameter_mm, recipe.targetDeflection_mm,
                                                 recipe.phi_deg);
    }
    [[nodiscard]] const BorePartView* awaited() {
        const BoringServiceView& view = m_bench.service();
        for (const BorePartView& part : view.parts) {
            if (view.awaiting == part.id) {
                return &part;
            }
        }
        return nullptr;
    }
    [[nodiscard]] bool waits(std::uint32_t number) {
        const BorePartView* part = awaited();
        return part != nullptr && part->number == number;
    }
    [[nodiscard]] std::size_t measured(std::uint32_t number) {
        for (const BorePartView& part : m_bench.service().parts) {
            if (part.number == number) {
                return part.measurements.size();
            }
        }
        return 0;
    }
    [[nodiscard]] bool enabled(const char* name) {
        const auto* button = m_bench.find<QAbstractButton>(name);
        return button != nullptr && button->isEnabled();
    }
    template <class Action>
    bool send(const Action& action) {
        Command command;
        command.action = action;
        return m_bench.console().engine().send(command).has_value();
    }
    /// What the header says of the machine.
    [[nodiscard]] QString linkText() {
        const auto* lamp = m_bench.find<ui::Lamp>("link");
        return lamp != nullptr ? lamp->word() : QString();
    }
    void show(const char* page) { m_bench.console().window()->showPage(page); }
    [[nodiscard]] QByteArray situation() {
        const Status& status = m_bench.status();
        const LoopStatus& boring = status.loops[static_cast<std::size_t>(ProcessId::Boring)];
        return QStringLiteral("link %1, program %2, boring: %3; last command: %4; bottom line: %5")
            .arg(static_cast<int>(status.link))
            .arg(static_cast<int>(status.program))
            .arg(QString::fromStdString(boring.reason.english()),
                 QString::fromStdString(status.lastCommand.reason.english()), m_bench.console().window()->bottomLine())
            .toUtf8();
    }
    /// One bore, from the button to its last diameter.
    void makeBore(std::uint32_t number) {
        show("overview");
        // A busy computer loses the link for a moment now and then: then the operator is refused and presses again.
        for (int press = 0; press < 3 && !waits(number); ++press) {
            if (m_bench.status().held && m_bench.status().link == LinkState::Up) {  // lost and back: somebody looks
                QVERIFY(m_bench.console().window()->client().sendAction(ReleaseHold{}));
            }
            QTRY_VERIFY2_WITH_TIMEOUT(enabled("startPart"), situation(), 20'000);
            const std::uint32_t before = m_bench.status().lastCommand.number;
            QVERIFY(m_bench.press("startPart"));
            const auto refused = [&] {
                const CommandResult& last = m_bench.status().lastCommand;
                return last.number != before && !last.done;
            };
            QTRY_VERIFY2_WITH_TIMEOUT(waits(number) || refused(), situation(), 30'000);
        }
        QVERIFY2(waits(number), situation());
        show("boring");
        for (const double overhang_mm : {40.0, 120.0}) {
            const BorePartView* part = awaited();
            QVERIFY(part != nullptr);
            const std::size_t before = part->measurements.size();
            QVERIFY(m_bench.keyIn(QString::number(gauged_mm(*part, overhang_mm), 'f', 3)));
            QTRY_VERIFY2_WITH_TIMEOUT(measured(number) > before, situation(), 10'000);
        }
        QTRY_VERIFY(awaited() == nullptr);
    }

 private slots:
    void initTestCase() {
        if (const QString why = test::LinuxCncControl::whyNot(); !why.isEmpty()) {
            QSKIP(qPrintable(why));
        }
    }
    void startsWithoutLinuxCncAndFindsItByItself() {
        m_bench.prepareBores(shortBore());
        console::Options options;
        options.machine = "linuxcnc";
        m_bench.start(options);
        QTRY_VERIFY2_WITH_TIMEOUT(m_bench.up(), qPrintable(m_bench.failure()), 20'000);
        QCOMPARE(m_bench.status().link, LinkState::Down);
        QVERIFY2(m_control.start(), m_control.log());
        QTRY_VERIFY_WITH_TIMEOUT(m_bench.status().link == LinkState::Up && m_bench.status().machineOn, 10'000);
    }
    void loopsTheMachineCannotHostSayWhy() {
        QVERIFY(m_bench.up());
        const auto reason = [this](ProcessId id) {
            return m_bench.status().loops[static_cast<std::size_t>(id)].reason.english();
        };
        QTRY_VERIFY(!m_bench.status().loops[static_cast<std::size_t>(ProcessId::Thermal)].fitted);
        QVERIFY2(reason(ProcessId::Thermal).find("temperatures") != std::string::npos,
                 reason(ProcessId::Thermal).c_str());
        QVERIFY2(reason(ProcessId::Turning).find("0.2 ms") != std::string::npos, reason(ProcessId::Turning).c_str());
    }
    void lotOfSixBoresWithEntries() {
        QVERIFY(m_bench.up());
        QVERIFY(m_bench.console().window()->session().makeFirstEngineer(QStringLiteral("Kim"), QStringLiteral("1234")));
        QVERIFY(send(SetLoopMode{ProcessId::Boring, LoopMode::Control}));
        for (std::uint32_t number = 1; number <= kParts; ++number) {
            makeBore(number);
            if (QTest::currentTestFailed()) return;
        }
        QCOMPARE(m_bench.service().parts.size(), std::size_t{kParts});
        for (const BorePartView& part : m_bench.service().parts) {
            QVERIFY(part.complete);
            QCOMPARE(part.measurements.size(), std::size_t{2});
        }
        // The law has been found: the next bore is on the target at both ends.
        for (const double overhang_mm : {40.0, 120.0}) {
            const double error =
                m_bench.service().nextSchedule.feed_mmPerRev(overhang_mm) / trueFeed_mmPerRev(overhang_mm) - 1.0;
            std::printf("at %.0f mm the next feed is %.1f %% off\n", overhang_mm, 100.0 * error);
            QVERIFY(std::abs(error) < 0.1);
        }
    }
    void tuningTakesMostOfTheContourError() {
        QVERIFY(m_bench.up());
        QVERIFY(send(SetLoopMode{ProcessId::Tapping, LoopMode::Control}));
        show("tapping");
        QTRY_VERIFY2_WITH_TIMEOUT(enabled("tappingTune"), situation(), 20'000);
        QVERIFY(m_bench.press("tappingTune"));
        QTRY_VERIFY2_WITH_TIMEOUT(enabled("tappingAccept"), situation(), 60'000);
        const auto trials = [this] {
            const auto* bars = m_bench.find<ui::TrialBars>("tappingSaecBars");
            return bars != nullptr ? bars->values().size() : 0;
        };
        for (int more = 0; more < 2; ++more) {
            const auto before = trials();
            QTRY_VERIFY2(enabled("tappingOneMore"), situation());
            QVERIFY(m_bench.press("tappingOneMore"));
            QTRY_VERIFY2_WITH_TIMEOUT(trials() > before && enabled("tappingAccept"), situation(), 60'000);
        }
        QVERIFY(m_bench.press("tappingAccept"));
        const auto tunings = [this] {
            std::vector<RecipeRevision> rows;
            if (const auto reader = db::DatabaseReader::open(m_bench.console().databasePath())) {
                if (auto found = (*reader)->allRecipes(ProcessId::Tapping)) {
                    rows = std::move(*found);
                }
            }
            return rows;
        };
        QTRY_COMPARE_WITH_TIMEOUT(tunings().size(), std::size_t{1}, 10'000);
        const auto tuning = formats::tuningFromJson(tunings().front().parametersJson);
        QVERIFY(tuning.has_value());
        std::printf("contour error less by %.1f %%, engaged p-p %.1f -> %.1f um, %u taps\n",
                    100.0 * tuning->proof.reduction(), tuning->proof.first.engagedPp_um,
                    tuning->proof.last.engagedPp_um, tuning->proof.taps);
        QVERIFY(tuning->proof.reduction() >= 0.8);
        QVERIFY(!tuning->proof.rolledBack);
    }
    void controlRestartedIsTakenOverAgain() {
        QVERIFY(m_bench.up());
        m_control.stop();
        QTRY_COMPARE_WITH_TIMEOUT(m_bench.status().link, LinkState::Down, 10'000);
        QCOMPARE(m_bench.service().parts.size(), std::size_t{kParts});  // nothing lost
        QVERIFY2(m_control.start(), m_control.log());
        QTRY_COMPARE_WITH_TIMEOUT(m_bench.status().link, LinkState::Up, 10'000);
    }
    void killedControlIsToldAtOnceAndFoundAgain() {
        QVERIFY(m_bench.up());
        QTRY_VERIFY_WITH_TIMEOUT(m_bench.status().machineOn, 10'000);
        QTRY_COMPARE(linkText(), QStringLiteral("connected"));
        const std::int64_t killed_ns = test::LinuxCncControl::killControl();
        QVERIFY(killed_ns > 0);
        const bool told = QTest::qWaitFor([this] { return linkText() == QStringLiteral("no link"); }, 5000);
        const double after_ms = static_cast<double>(test::monotonic_ns() - killed_ns) * 1e-6;
        QVERIFY(told);
        std::printf("LinuxCNC killed: the console says so after %.0f ms\n", after_ms);
        QVERIFY2(after_ms <= 200.0, qPrintable(QString::number(after_ms)));
        for (const ProcessId process : {ProcessId::Boring, ProcessId::Tapping}) {
            QCOMPARE(m_bench.status().loops[static_cast<std::size_t>(process)].state, LoopState::Held);
        }
        m_control.stop();
        QVERIFY2(m_control.start(), m_control.log());
        QTRY_COMPARE_WITH_TIMEOUT(m_bench.status().link, LinkState::Up, 10'000);
        QTRY_COMPARE_WITH_TIMEOUT(linkText(), QStringLiteral("connected"), 10'000);
        QCOMPARE(m_bench.service().parts.size(), std::size_t{kParts});  // nothing lost
    }
    void cleanupTestCase() { m_bench.stop(); }

 private:
    Random m_gauge{7};
    test::LinuxCncControl m_control;
    test::ConsoleBench m_bench;
};
KERF_GUI_TEST_IN_TIME(TestConsoleLinuxCnc)
#include "tst_console_linuxcnc.moc"
