// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "app/service/tapping/tapping_tuning_json.h"
#include "engine/api/part_results.h"
#include "engine/machine/simulated/simulated_machine.h"
#include "tests/support/console_bench.h"
#include "ui/pages/tapping/trial_bars.h"

using namespace kerf;

/// Tapping on the real console: simulator, engine, database, window; an operator's touches through the widgets.
class TestConsoleTapping : public QObject {
    Q_OBJECT

    [[nodiscard]] static console::Options options() {
        console::Options o;
        o.preparedParts = 0;
        o.lotSize = 1;
        o.simulationSpeed = 0.0;  // as fast as it can
        o.seed = 5;
        return o;
    }
    [[nodiscard]] const TappingStatus& tapping() { return m_bench.status().tapping; }
    [[nodiscard]] double gain_perS() { return tapping().drive.zKp_perS; }
    void bringUp() {
        m_bench.start(options());
        QTRY_VERIFY2_WITH_TIMEOUT(m_bench.up(), qPrintable(m_bench.failure()), 20'000);
        m_bench.console().window()->showPage("tapping");
        QVERIFY(m_bench.press("operator"));
        QTRY_VERIFY(m_bench.find<QLineEdit>("operatorName") != nullptr);
        if (m_bench.find("operator0") != nullptr) {  // known since the first start
            QVERIFY(m_bench.press("operator0"));
        } else {
            QTest::keyClicks(m_bench.find<QLineEdit>("operatorName"), QStringLiteral("Kim"));
            QVERIFY(m_bench.press("roleEngineer"));
            QVERIFY(m_bench.press("signOn"));
        }
        QCOMPARE(m_bench.console().window()->session().role(), ui::Role::Engineer);
        // The lot's only bore is cut first; it waits for its gauge and leaves the machine free.
        QTRY_VERIFY_WITH_TIMEOUT(m_bench.service().awaiting.has_value(), 60'000);
        QTRY_VERIFY_WITH_TIMEOUT(enabled("tappingTap"), 60'000);
    }
    [[nodiscard]] QString situation() {
        return QStringLiteral("%1, %2, phase %3, tap %4, outcome %5, %6 samples, %7 missing, peak %8 µm, %9")
            .arg(m_bench.text("tappingState"), m_bench.text("tappingReason"))
            .arg(static_cast<int>(tapping().phase))
            .arg(tapping().taps)
            .arg(static_cast<int>(tapping().outcome))
            .arg(tapping().last.samples)
            .arg(tapping().last.missing)
            .arg(tapping().last.peak_um)
            .arg(m_bench.console().window()->bottomLine());
    }
    [[nodiscard]] bool enabled(const char* name) {
        const auto* button = m_bench.find<QAbstractButton>(name);
        return button != nullptr && button->isEnabled();
    }
    [[nodiscard]] int trials() {
        return static_cast<int>(m_bench.find<ui::TrialBars>("tappingSaecBars")->values().size());
    }
    bool tap() {
        const std::uint32_t before = tapping().taps;
        if (!m_bench.press("tappingTap")) return false;
        return QTest::qWaitFor(
            [&] { return tapping().taps > before && tapping().phase == TapPhase::Idle && enabled("tappingTap"); },
            20'000);
    }
    [[nodiscard]] std::vector<tapping::StoredTuning> storedTunings() {
        std::vector<tapping::StoredTuning> tunings;
        const auto reader = db::DatabaseReader::open(m_bench.console().databasePath());
        if (!reader) return tunings;
        auto rows = (*reader)->allRecipes(ProcessId::Tapping);
        if (!rows) return tunings;
        std::ranges::reverse(*rows);  // newest first
        for (const RecipeRevision& row : *rows) {
            if (auto tuning = formats::tuningFromJson(row.parametersJson)) tunings.push_back(std::move(*tuning));
        }
        return tunings;
    }
    void setSpeed(double factor) {
        Command command;
        command.action = SetSimulationSpeed{factor};
        (void)m_bench.console().engine().send(command);
    }

 private slots:
    void aJobIsTunedMadeRecoveredAndKeptThroughTheScreen() {
        bringUp();
        const double own_perS = gain_perS();
        QVERIFY(own_perS > 0.0);
        tunesAndAccepts(own_perS);
        if (QTest::currentTestFailed()) return;
        makesProductionTaps();
        if (QTest::currentTestFailed()) return;
        switchesTheLanguage();
        stopsInTheHoleAndTurnsOut();
        if (QTest::currentTestFailed()) return;
        keepsTheTuningOverARestart(own_perS);
        if (QTest::currentTestFailed()) return;
        rollsBack(own_perS);
        m_bench.stop();
    }

 private:
    void tunesAndAccepts(double own_perS) {
        QVERIFY(m_bench.press("tappingTune"));
        QTRY_VERIFY2_WITH_TIMEOUT(enabled("tappingAccept"), qPrintable(situation()), 20'000);
        QVERIFY(tapping().airTapPassed);
        QVERIFY(!m_bench.text("tappingReason").isEmpty());
        for (int trial = 1; trial < 4; ++trial) {  // four trial taps
            QVERIFY(m_bench.press("tappingOneMore"));
            QTRY_VERIFY2_WITH_TIMEOUT(trials() == trial + 1 && enabled("tappingAccept"), qPrintable(situation()),
                                      20'000);
        }
        QVERIFY(m_bench.press("tappingAccept"));
        QTRY_COMPARE_WITH_TIMEOUT(storedTunings().size(), std::size_t{1}, 10'000);
        const tapping::StoredTuning tuning = storedTunings().front();
        QVERIFY2(tuning.proof.reduction() >= 0.95, qPrintable(QString::number(tuning.proof.reduction())));
        QCOMPARE(tuning.proof.author, std::string("Kim"));
        QCOMPARE(tuning.choice.thread, std::string("M8"));
        QCOMPARE(tuning.choice.speed_rpm, 3000.0);
        QVERIFY(std::abs(tuning.own.zKp_perS - own_perS) < 1e-9);
        QVERIFY(!tuning.settings.zTrim_mm.empty());
        QTRY_VERIFY(m_bench.text("tappingNote").contains(QStringLiteral("Kim")));
        qInfo("reduction %.2f %%, engaged p-p %.1f -> %.1f um, %u taps", 100.0 * tuning.proof.reduction(),
              tuning.proof.first.engagedPp_um, tuning.proof.last.engagedPp_um, tuning.proof.taps);
    }
    void makesProductionTaps() {
        for (int i = 0; i < 3; ++i) {
            QVERIFY(tap());
            QCOMPARE(tapping().kind, TapKind::Production);
            QCOMPARE(tapping().outcome, TapOutcome::Counted);
            QVERIFY2(tapping().last.engagedPp_um < 56.0, qPrintable(QString::number(tapping().last.engagedPp_um)));
        }
        const auto reader = db::DatabaseReader::open(m_bench.console().databasePath());
        QVERIFY(reader.has_value());
        PartQuery query;
        query.process = ProcessId::Tapping;
        QTRY_COMPARE_WITH_TIMEOUT((*reader)->parts(query)->size(), std::size_t{3}, 10'000);
        const auto parts = (*reader)->parts(query);
        QCOMPARE(parts->front().figures.size(), partResultRows(ProcessId::Tapping).size());
        QVERIFY(parts->front().complete);
    }
    void switchesTheLanguage() {
        const QString english = m_bench.text("tappingNote");
        QVERIFY(m_bench.press("language"));
        QVERIFY(m_bench.text("tappingNote") != english);
        QVERIFY(m_bench.press("language"));
        QCOMPARE(m_bench.text("tappingNote"), english);
    }
    void stopsInTheHoleAndTurnsOut() {
        setSpeed(1.0);  // slow enough to stop it in the hole
        QVERIFY(m_bench.press("tappingTap"));
        QTRY_VERIFY_WITH_TIMEOUT(tapping().phase == TapPhase::Tapping && tapping().spindle_rev > 5.0, 10'000);
        InjectedFaults faults;
        faults.emergencyStop = true;
        m_bench.console().simulator()->machine().inject(faults);
        QTRY_VERIFY2(tapping().phase == TapPhase::InHole,
                     qPrintable(QStringLiteral("%1 rev, cycle %2, stop %3, program %4, %5")
                                    .arg(tapping().spindle_rev)
                                    .arg(m_bench.status().cycle)
                                    .arg(m_bench.status().emergencyStop)
                                    .arg(static_cast<int>(m_bench.status().program))
                                    .arg(situation())));
        QVERIFY(tapping().stoppedSpindle_rev > 3.0);
        QTRY_VERIFY(m_bench.find("tappingRecover") != nullptr);
        QVERIFY(!enabled("tappingTap"));
        QVERIFY(m_bench.press("tappingRecover"));
        QTRY_VERIFY(m_bench.find("recoveryTurn") != nullptr);
        QVERIFY(!enabled("recoveryTurn"));  // the emergency stop is still pressed
        m_bench.console().simulator()->machine().inject({});
        QTRY_VERIFY(!m_bench.status().emergencyStop);
        QVERIFY(!enabled("recoveryTurn"));  // nobody has looked
        QVERIFY(m_bench.console().window()->client().sendAction(ReleaseHold{}));
        QTRY_VERIFY(enabled("recoveryTurn"));
        QVERIFY(m_bench.press("recoveryTurn"));
        QTRY_COMPARE_WITH_TIMEOUT(tapping().phase, TapPhase::Idle, 20'000);
        QVERIFY(std::abs(tapping().z_mm) < 0.1);
        QTRY_VERIFY(m_bench.text("recoveryState").contains(QStringLiteral("Gauge")));
        QVERIFY(m_bench.press("recoveryClose"));
        setSpeed(0.0);
        QTRY_VERIFY_WITH_TIMEOUT(enabled("tappingTap"), 10'000);
        QVERIFY(tap());  // with the accepted gains and trim
        QVERIFY(tapping().last.engagedPp_um < 56.0);
    }
    void keepsTheTuningOverARestart(double own_perS) {
        const double tuned_perS = gain_perS();
        QVERIFY(std::abs(tuned_perS - own_perS) > 1.0);
        m_bench.stop();
        bringUp();  // the simulated drive starts with its own gains again
        QVERIFY(m_bench.text("tappingNote").contains(QStringLiteral("Kim")));
        QVERIFY(tap());
        QCOMPARE(tapping().kind, TapKind::Air);
        QVERIFY(tap());
        QCOMPARE(tapping().kind, TapKind::Production);
        QVERIFY(std::abs(gain_perS() - tuned_perS) < 1e-9);
        QVERIFY2(tapping().last.engagedPp_um < 56.0, qPrintable(QString::number(tapping().last.engagedPp_um)));
        // Another gear: the machine's own gains.
        QVERIFY(m_bench.press("tappingJob"));
        QTRY_VERIFY(m_bench.find<QLineEdit>("jobGearEdit") != nullptr);
        auto* gear = m_bench.find<QLineEdit>("jobGearEdit");
        gear->setFocus();
        gear->selectAll();
        QTest::keyClicks(gear, QStringLiteral("2"));
        QTRY_COMPARE(gear->text(), QStringLiteral("2"));  // keys wait whether they belong to a gauge
        QVERIFY(m_bench.press("jobApply"));
        QTRY_VERIFY2_WITH_TIMEOUT(m_bench.find("jobApply") == nullptr, qPrintable(m_bench.text("jobMessage")), 5'000);
        QTRY_VERIFY2_WITH_TIMEOUT(enabled("tappingTap") && !tapping().airTapPassed, qPrintable(situation()), 10'000);
        QVERIFY(tap());
        QVERIFY(std::abs(gain_perS() - own_perS) < 1e-9);
    }
    void rollsBack(double own_perS) {
        QVERIFY(m_bench.press("tappingAutomatic"));
        QTRY_VERIFY(m_bench.find<QAbstractButton>("tappingAutomatic")->isChecked());
        QVERIFY(m_bench.press("tappingTune"));
        QTRY_COMPARE_WITH_TIMEOUT(storedTunings().size(), std::size_t{2}, 60'000);
        QTRY_VERIFY_WITH_TIMEOUT(enabled("tappingRollBack"), 10'000);
        QVERIFY(m_bench.press("tappingRollBack"));
        QTRY_COMPARE_WITH_TIMEOUT(storedTunings().size(), std::size_t{3}, 10'000);
        QVERIFY(storedTunings().front().proof.rolledBack);
        QTRY_VERIFY_WITH_TIMEOUT(enabled("tappingTap"), 10'000);
        QVERIFY(tap());
        QVERIFY(std::abs(gain_perS() - own_perS) < 1e-9);
    }

    test::ConsoleBench m_bench;
};
QTEST_MAIN(TestConsoleTapping)
#include "tst_console_tapping.moc"
