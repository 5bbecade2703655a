// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTableWidget>
#include <algorithm>
#include <cmath>

#include "app/console/rooms/turning_room.h"
#include "engine/process/turning/tone_canceller.h"
#include "engine/process/turning/turning_alarms.h"
#include "tests/support/console_bench.h"
#include "ui/pages/turning/spectrum_chart.h"

using namespace kerf;

/// The diamond lathe on the real console: a part in advise, one under control, one whose force sensor is lost; an
/// operator's touches through the widgets.
class TestConsoleTurning : public QObject {
    Q_OBJECT

    static constexpr auto kTurning = static_cast<std::size_t>(ProcessId::Turning);

    [[nodiscard]] static console::Options options() {
        console::Options o;
        o.machine = "diamond-lathe";
        o.preparedParts = 0;
        o.seed = 7;
        return o;
    }
    void bringUp() {
        m_bench.start(options());
        QTRY_VERIFY2_WITH_TIMEOUT(m_bench.up(), qPrintable(m_bench.failure()), 20'000);
        m_bench.console().window()->showPage("turning");
        Command fast;
        fast.action = SetSimulationSpeed{0.0};
        QVERIFY(m_bench.console().engine().send(fast).has_value());
    }
    void signOn() { QVERIFY(m_bench.console().window()->session().signOn(QStringLiteral("Kim"), ui::Role::Setter)); }
    [[nodiscard]] const TurningServiceView& service() {
        return static_cast<console::TurningRoom*>(m_bench.console().room(ProcessId::Turning))->service().view();
    }
    [[nodiscard]] const TurningStatus& turning() { return m_bench.status().turning; }
    [[nodiscard]] const LoopStatus& loop() { return m_bench.status().loops[kTurning]; }
    [[nodiscard]] bool enabled(const char* name) {
        const auto* button = m_bench.find<QAbstractButton>(name);
        return button != nullptr && button->isEnabled();
    }
    void setMode(const char* button, LoopMode mode) {
        QVERIFY(m_bench.press(button));
        QTRY_COMPARE(loop().mode, mode);
    }
    void startPart() {
        QTRY_VERIFY(enabled("turningStart"));
        QVERIFY(m_bench.press("turningStart"));
        QTRY_COMPARE(m_bench.status().program, ProgramState::Running);
    }
    void cutPart(std::size_t partsAfter) {
        startPart();
        QTRY_COMPARE_WITH_TIMEOUT(service().parts.size(), partsAfter, 60'000);
        QTRY_VERIFY(m_bench.status().program != ProgramState::Running);
    }

 private slots:
    void partsAreTurnedComparedAndKept() {
        bringUp();
        signOn();
        setsUpAShortFace();
        if (QTest::currentTestFailed()) {
            return;
        }
        setMode("turningModeAdvise", LoopMode::Advise);
        cutPart(1);
        QVERIFY(!service().parts[0].record.controlled);
        QCOMPARE(service().parts[0].record.trimPeak_um, 0.0);
        setMode("turningModeControl", LoopMode::Control);
        cutPart(2);
        comparisonHolds();
        blindTonesAreNamed();
        if (QTest::currentTestFailed()) {
            return;
        }
        languageSwitches();
        sensorIsLost();
        archiveSurvivesARestart();
        m_bench.stop();
    }

 private:
    void setsUpAShortFace() {
        QVERIFY(m_bench.press("turningSetup"));
        QTRY_VERIFY(m_bench.find<QLineEdit>("turningField5Edit") != nullptr);
        auto* to = m_bench.find<QLineEdit>("turningField5Edit");
        QVERIFY(to != nullptr);
        to->setFocus();
        to->selectAll();
        QTest::keyClicks(to, QStringLiteral("0.8"));
        QTRY_VERIFY(enabled("turningSetupApply"));
        QVERIFY(m_bench.press("turningSetupApply"));
        QTRY_COMPARE(service().setup.faceTo_mm, 0.8);
        QTRY_COMPARE(turning().nextSetup, service().setup.revision);
    }
    void comparisonHolds() {
        const TurningPartView& open = service().parts[0];
        const TurningPartView& closed = service().parts[1];
        QVERIFY(closed.complete && closed.record.controlled && !closed.record.leftLoop);
        QVERIFY(service().comparison.has_value());
        const TurningComparison& c = *service().comparison;
        QCOMPARE(c.openPart, open.number);
        QCOMPARE(c.closedPart, closed.number);
        QVERIFY2(c.rms_percent() > 80.0, qPrintable(QString::number(c.rms_percent())));
        QVERIFY2(c.pv_percent() > 70.0, qPrintable(QString::number(c.pv_percent())));
        QVERIFY2(std::abs(c.force_percent()) < 2.0, qPrintable(QString::number(c.force_percent())));
        QVERIFY(std::abs(closed.record.steadyForce_N - closed.record.forceTarget_N) < 0.05 * 1.44);
        QVERIFY(m_bench.text("turningComparison13").contains(QStringLiteral("%")));
        QVERIFY(!closed.force.empty() && !closed.spectrum.empty());
        QVERIFY(closed.record.identification.available);
        QVERIFY(std::abs(closed.record.identification.value[1] - 0.747) < 0.05);
        QTRY_VERIFY(service().margins.known);
        QVERIFY(service().margins.phase_deg > 30.0);
    }
    /// The law starts knowing no tone, and one that the force hardly sees is found in one part and not in the next:
    /// what is known is said, on the page and in the chart alike.
    void blindTonesAreNamed() {
        std::vector<double> blind_Hz;
        for (const TurningBlindTone& tone : service().blind.tones) {
            if (tone.blind) {
                blind_Hz.push_back(tone.frequency_Hz);
            }
        }
        QCOMPARE(service().blind.anyBlind, !blind_Hz.empty());
        QVERIFY(!service().blind.tones.empty());
        for (const double frequency_Hz : blind_Hz) {
            QVERIFY(std::abs(std::remainder(frequency_Hz, service().setup.spindleSpeed_rpm / 60.0)) < 0.5);
            QTRY_VERIFY(m_bench.text("turningBlind").contains(QString::number(frequency_Hz, 'f', 1)));
        }
        QCOMPARE(service().blind.suggestedSpeed_rpm.has_value(), !blind_Hz.empty());
        auto* spectrum = m_bench.find<ui::SpectrumChart>("turningSpectrum");
        QVERIFY(spectrum != nullptr);
        QTRY_VERIFY(!spectrum->tones().empty());
        for (const TurningTone& tone : spectrum->tones()) {
            QCOMPARE(tone.blind, tone.visibility < turning::kBlindBelow);
        }
    }
    void languageSwitches() {
        const QString english = m_bench.text("turningBlind");
        QVERIFY(m_bench.press("language"));
        QTRY_VERIFY(m_bench.text("turningBlind") != english);
        QVERIFY(m_bench.press("language"));
        QTRY_COMPARE(m_bench.text("turningBlind"), english);
    }
    /// Real time, so that the fault comes while the law acts.
    void sensorIsLost() {
        Command slow;
        slow.action = SetSimulationSpeed{1.0};
        QVERIFY(m_bench.console().engine().send(slow).has_value());
        startPart();
        QTRY_VERIFY_WITH_TIMEOUT(turning().acting, 20'000);
        InjectedFaults faults;
        faults.force = SignalFault::Unplugged;
        m_bench.console().simulator()->machine().inject(faults);
        QTRY_COMPARE_WITH_TIMEOUT(loop().state, LoopState::Faulted, 10'000);
        QTRY_COMPARE(turning().appliedTrim_um, 0.0);
        QVERIFY(!m_bench.text("turningLoopReason").isEmpty());
        const auto alarms = [this] {
            const auto reader = db::DatabaseReader::open(m_bench.console().databasePath());
            const auto open = (*reader)->openAlarms();
            return open && std::any_of(open->begin(), open->end(),
                                       [](const AlarmRow& row) { return row.code == turning_alarm::kForceLost; });
        };
        QTRY_VERIFY(alarms());
        m_bench.console().simulator()->machine().inject({});
        Command fast;
        fast.action = SetSimulationSpeed{0.0};
        QVERIFY(m_bench.console().engine().send(fast).has_value());
        QTRY_COMPARE_WITH_TIMEOUT(service().parts.size(), std::size_t{3}, 60'000);
        QVERIFY(service().parts[2].record.leftLoop);
        QVERIFY(!service().parts[2].record.controlled);
        QCOMPARE(service().comparison->closedPart, service().parts[1].number);  // that one does not count
    }
    void archiveSurvivesARestart() {
        const TurningServiceView before = service();
        m_bench.stop();
        bringUp();
        const TurningServiceView& after = service();
        QCOMPARE(after.setup.faceTo_mm, before.setup.faceTo_mm);
        QCOMPARE(after.setup.revision, before.setup.revision);
        QCOMPARE(after.parts.size(), before.parts.size());
        for (std::size_t i = 0; i < after.parts.size(); ++i) {
            QCOMPARE(after.parts[i].id, before.parts[i].id);
            QCOMPARE(after.parts[i].record.steadyRms_um, before.parts[i].record.steadyRms_um);
            QCOMPARE(after.parts[i].record.controlled, before.parts[i].record.controlled);
            QCOMPARE(after.parts[i].record.toneCount, before.parts[i].record.toneCount);
            QCOMPARE(after.parts[i].force.size(), before.parts[i].force.size());
            QCOMPARE(after.parts[i].spectrum.treated_um.size(), before.parts[i].spectrum.treated_um.size());
        }
        QVERIFY(after.comparison.has_value());
        QCOMPARE(after.comparison->rms_percent(), before.comparison->rms_percent());
        QTRY_COMPARE(turning().nextSetup, after.setup.revision);
        QVERIFY(m_bench.press("turningArchive"));
        const auto rows = [this] {
            const auto* table = m_bench.find<QTableWidget>("turningArchiveTable");
            return table != nullptr ? table->rowCount() : 0;
        };
        QTRY_COMPARE(rows(), 3);
        QVERIFY(m_bench.press("turningArchiveClose"));
    }

    test::ConsoleBench m_bench;
};
QTEST_MAIN(TestConsoleTurning)
#include "tst_console_turning.moc"
