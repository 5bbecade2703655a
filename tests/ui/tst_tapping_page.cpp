// SPDX-License-Identifier: GPL-3.0-or-later
#include <QLabel>
#include <QLineEdit>
#include <QTest>

#include "tests/support/fake_tapping_service.h"
#include "tests/support/layout_check.h"
#include "tests/support/page_bench.h"
#include "tests/support/start_rests.h"
#include "ui/pages/tapping/tapping_page.h"

using namespace kerf;
using namespace kerf::ui;
using kerf::test::FakeTappingService;
using kerf::test::PageBench;

namespace {
constexpr QSize kSmall{1083, 670};  // the page area of 1280×800
constexpr QSize kMiddle{1723, 930};
}  // namespace

/// A tuning on the fake service, its page, and the touches of an operator.
class TestTappingPage : public QObject {
    Q_OBJECT
 private slots:
    void init() {
        m_service = std::make_unique<FakeTappingService>();
        m_bench = std::make_unique<PageBench>();
        m_bench->services.tappingService = m_service.get();
        LoopStatus& loop = m_bench->engine.loop(ProcessId::Tapping);
        loop.fitted = true;
        loop.mode = LoopMode::Control;
        loop.state = LoopState::Controlling;
        loop.reason = Sentence(KERF_TEXT("Ready: the next tap uses the gains shown."));
        m_bench->engine.caps.servoGains.fitted = true;
        m_bench->engine.caps.cycleStart.fitted = true;
        m_bench->engine.fake.tapping.job = 1;
    }
    void cleanup() {
        m_bench.reset();
        m_service.reset();
    }

    // What the operator sees.
    void firstAndLastTapStandAgainstTheTolerance() {
        m_service->tune(3);
        show();
        auto* chart = m_bench->find<ContourChart>("tappingContourChart");
        QVERIFY(chart->drawn(0).size() > 1000);
        QVERIFY(chart->drawn(1).size() > 1000);
        QVERIFY(chart->drawn(0).back().x() > 43.0);  // the way out is drawn on behind the way in
        QTest::mouseClick(chart->viewport(), Qt::LeftButton);
        QVERIFY(chart->zoomed());
        QCOMPARE(m_bench->find<TrialBars>("tappingSaecBars")->values().size(), 3);
        QCOMPARE(m_bench->find<TrialBars>("tappingPpBars")->values().size(), 3);
    }
    void theProposalStandsBesideTheGainsWithReasonAndMargin() {
        m_service->tune(1);
        show();
        QCOMPARE(text("tappingGain11"), QStringLiteral("48.00"));
        QVERIFY(visible("tappingGain12"));
        QVERIFY(text("tappingGain12") != QStringLiteral("48.00"));
        QVERIFY(text("tappingReason").contains(QStringLiteral("trim")));
        QVERIFY(text("tappingSafe").contains(QStringLiteral("dB")));
        QVERIFY(visible("tappingSafeBar"));
        QVERIFY(m_bench->find<ActionButton>("tappingOneMore")->property("primary").toBool());
    }
    void anEmptyPageSaysWhatWillAppear() {
        show();
        QVERIFY(m_bench->find<ContourChart>("tappingContourChart")->drawn(0).isEmpty());
        QVERIFY(!text("tappingSafe").isEmpty());
        QVERIFY(text("tappingReason").contains(QStringLiteral("own gains")));
        QVERIFY(!visible("tappingNote"));
    }
    void theProofStaysOnThePage() {
        m_service->tune(3);
        m_service->acceptTuning();
        show();
        QVERIFY(text("tappingNote").contains(QStringLiteral("Kim")));
        QVERIFY(text("tappingNote").contains(QStringLiteral("−99.")));
        QCOMPARE(text("tappingGain10"), QStringLiteral("48.00"));
        m_service->edit().storeProblem = Sentence("The disk is full.");
        tick();
        QVERIFY(text("tappingNote").contains(QStringLiteral("The disk is full.")));
    }
    void withoutAServiceThePageSaysSo() {
        m_bench->services.tappingService = nullptr;
        show();
        QVERIFY(m_bench->page->findChild<QLabel*>()->isVisible());
    }

    // What the operator does.
    void tuningIsBegunWithAName() {
        show();
        QVERIFY(m_bench->press("tappingTune"));
        QCOMPARE(m_service->calls.back(), std::string("begin Kim"));
        m_bench->session.signOff();
        QVERIFY(m_bench->press("tappingTune"));
        QCOMPARE(m_bench->askedForName, 1);
        QCOMPARE(m_service->calls.size(), std::size_t{1});
    }
    void aRefusalIsTold() {
        m_service->failWith = Sentence("The gear is not engaged.");
        show();
        QVERIFY(m_bench->press("tappingTune"));
        QCOMPARE(m_bench->notices.back(), QStringLiteral("The gear is not engaged."));
    }
    void theProposalIsTappedAcceptedOrRolledBack() {
        m_service->tune(2);
        show();
        QVERIFY(m_bench->press("tappingOneMore"));
        QVERIFY(m_bench->press("tappingAccept"));
        QVERIFY(m_bench->press("tappingRollBack"));
        QCOMPARE(m_service->calls, (std::vector<std::string>{"one more", "accept Kim", "roll back Kim"}));
        m_service->edit().mayTapMore = false;
        tick();
        QVERIFY(!m_bench->press("tappingOneMore"));
        QVERIFY(reason("tappingOneMore").contains(QStringLiteral("used")));
    }
    void theAutomaticIsWhatTheServiceSays() {
        show();
        QVERIFY(m_bench->press("tappingAutomatic"));
        QCOMPARE(m_service->calls.back(), std::string("automatic"));
        tick();
        QVERIFY(m_bench->find<QPushButton>("tappingAutomatic")->isChecked());
        QVERIFY(m_bench->press("tappingTune"));
        QCOMPARE(m_service->calls.back(), std::string("begin automatic Kim"));
    }
    void theFirstTapOfAJobIsNamedAnAirTap() {
        show();
        QCOMPARE(button("tappingTap")->text(), QStringLiteral("Air tap"));
        m_bench->engine.fake.tapping.airTapPassed = true;
        tick();
        QCOMPARE(button("tappingTap")->text(), QStringLiteral("Tap"));
        QVERIFY(m_bench->press("tappingTap"));
        const auto* start = std::get_if<StartPart>(&m_bench->engine.commands.back().action);
        QVERIFY(start != nullptr);
        QCOMPARE(start->process, ProcessId::Tapping);
    }
    void buttonsSayWhyTheyAreOff() {
        show();
        for (const char* name : {"tappingOneMore", "tappingAccept", "tappingRollBack", "tappingAbort"}) {
            QVERIFY2(!button(name)->isEnabled() && !reason(name).isEmpty(), name);
        }
        m_bench->engine.loop(ProcessId::Tapping).mode = LoopMode::Advise;
        tick();
        QVERIFY(reason("tappingTune").contains(QStringLiteral("control")));
        QVERIFY(button("tappingTap")->isEnabled());  // with the machine's own gains
        m_bench->engine.fake.held = true;
        tick();
        QVERIFY(reason("tappingTap").contains(QStringLiteral("Hold")));
        m_bench->engine.fake.held = false;
        m_bench->engine.fake.program = ProgramState::Running;
        m_bench->engine.fake.programProcess = ProcessId::Boring;
        tick();
        QVERIFY(reason("tappingTap").contains(QStringLiteral("Boring")));
    }
    void aStartSaysWhatStandsInItsWay() {
        show();
        test::startSaysWhyNot(*m_bench, "tappingTap");
    }
    /// What is tapped next is chosen whether or not it can be begun now, or from here at all.
    void aJobIsChosenOnAMachineThatCannotStart() {
        show();
        m_bench->engine.caps.cycleStart = {};
        m_bench->engine.fake.stops[0].slot = {7, 6, StopKind::FeedHold, 201};
        m_bench->engine.fake.held = true;
        tick();
        QVERIFY(!button("tappingTap")->isEnabled());
        QVERIFY2(button("tappingJob")->isEnabled(), qPrintable(reason("tappingJob")));
    }
    void aStartRestsUntilTheNewestIsShown() {
        show();
        test::startRests(*m_bench, "tappingTap", ProcessId::Tapping);
    }
    void aRunningTapCanBeAborted() {
        m_bench->engine.fake.tapping.phase = TapPhase::Tapping;
        m_bench->engine.fake.tapping.spindle_rev = 12.3;
        m_bench->engine.fake.tapping.error_um = 45.0;
        show();
        QVERIFY(text("tappingLive").contains(QStringLiteral("12.3")));
        QVERIFY(m_bench->press("tappingAbort"));
        QCOMPARE(m_service->calls.back(), std::string("abort"));
    }
    void theSwitchAsksTheEngineAndShowsWhatItSays() {
        show();
        QVERIFY(m_bench->press("tappingModeAdvise"));
        const auto* mode = std::get_if<SetLoopMode>(&m_bench->engine.commands.back().action);
        QVERIFY(mode != nullptr && mode->process == ProcessId::Tapping && mode->mode == LoopMode::Advise);
        QVERIFY(m_bench->find<QPushButton>("tappingModeControl")->isChecked());
        m_bench->engine.loop(ProcessId::Tapping).mode = LoopMode::Advise;
        tick();
        QVERIFY(m_bench->find<QPushButton>("tappingModeAdvise")->isChecked());
    }
    void driftAsksForANewTune() {
        TappingStatus& tapping = m_bench->engine.fake.tapping;
        tapping.productionTaps = 40;
        tapping.driftShare = 0.2;
        show();
        QVERIFY(text("tappingDrift").contains(QStringLiteral("40 %")));
        tapping.wantsTuning = true;
        tick();
        QVERIFY(text("tappingDrift").contains(QStringLiteral("Tune again")));
        QVERIFY(button("tappingTune")->property("primary").toBool());
    }

    // Job.
    void aThreadIsChosenFromTheTable() {
        show();
        QVERIFY(m_bench->press("tappingJob"));
        QVERIFY(m_bench->press("jobFine"));
        QVERIFY(m_bench->press("thread_M10x1"));
        QVERIFY(text("jobThreadText").contains(QStringLiteral("ISO 965-1")));
        auto* speed = m_bench->find<QLineEdit>("jobSpeedEdit");
        speed->setText(QStringLiteral("4500"));
        emit speed->textEdited(speed->text());
        QVERIFY(m_bench->press("jobApply"));
        QCOMPARE(m_service->loaded.size(), std::size_t{1});
        QCOMPARE(m_service->loaded.back().thread, std::string("M10x1"));
        QCOMPARE(m_service->loaded.back().speed_rpm, 4500.0);
        QCOMPARE(m_service->loaded.back().depth_rev, 22.0);
        QVERIFY(m_bench->sheets->current() == nullptr);
    }
    void aSpeedOutOfRangeStaysOnTheSheet() {
        show();
        QVERIFY(m_bench->press("tappingJob"));
        auto* speed = m_bench->find<QLineEdit>("jobSpeedEdit");
        speed->setText(QStringLiteral("99999"));
        emit speed->textEdited(speed->text());
        QVERIFY(m_bench->press("jobApply"));
        QVERIFY(m_service->loaded.empty());
        QVERIFY(!text("jobMessage").isEmpty());
        QCOMPARE(speed->text(), QStringLiteral("99999"));
    }
    void theServiceMayRefuseAJob() {
        m_service->failWith = Sentence("This tap takes 20 s.");
        show();
        QVERIFY(m_bench->press("tappingJob"));
        QVERIFY(m_bench->press("jobApply"));
        QVERIFY(text("jobMessage").contains(QStringLiteral("20 s")));
        QVERIFY(m_bench->sheets->current() != nullptr);
    }
    void aTunedSpeedIsPickedFromTheChart() {
        m_service->tune(3);
        m_service->acceptTuning();
        show();
        TapChoice choice;
        choice.speed_rpm = 4500.0;
        emit m_bench->find<SpeedChart>("tappingSpeedChart")->picked(choice);
        QVERIFY(m_bench->press("sheetProceed"));
        QCOMPARE(m_service->loaded.back().speed_rpm, 4500.0);
    }

    // Recovery.
    void aTapInTheHoleIsTurnedOutStepByStep() {
        TappingStatus& tapping = m_bench->engine.fake.tapping;
        tapping.phase = TapPhase::InHole;
        tapping.stoppedSpindle_rev = 12.25;
        tapping.stoppedZ_mm = 15.3125;
        m_bench->engine.fake.emergencyStop = true;
        show();
        QVERIFY(text("tappingNote").contains(QStringLiteral("12.3")) ||
                text("tappingNote").contains(QStringLiteral("12.2")));
        QVERIFY(!visible("tappingAbort"));
        QVERIFY(!button("tappingTap")->isEnabled());
        QVERIFY(m_bench->press("tappingRecover"));
        QVERIFY(text("recoveryWhere").contains(QStringLiteral("12.25")));
        QVERIFY(text("recoveryWhere").contains(QStringLiteral("15.313")) ||
                text("recoveryWhere").contains(QStringLiteral("15.312")));
        QVERIFY(text("recoveryWhere").contains(QStringLiteral("90°")));
        QVERIFY(!m_bench->press("recoveryTurn"));  // emergency stop is pressed
        QVERIFY(text("recoveryState").contains(QStringLiteral("Emergency stop")));
        m_bench->engine.fake.emergencyStop = false;
        m_bench->client.tick();
        QVERIFY(m_bench->press("recoveryTurn"));
        QCOMPARE(m_service->calls.back(), std::string("recover"));
        tapping.phase = TapPhase::Retracting;
        tapping.spindle_rev = 6.0;
        m_bench->client.tick();
        QVERIFY(text("recoveryState").contains(QStringLiteral("6.0")));
        tapping.phase = TapPhase::Idle;
        m_bench->client.tick();
        QVERIFY(text("recoveryState").contains(QStringLiteral("Gauge")));
        QVERIFY(m_bench->press("recoveryClose"));
    }
    void theSheetWaitsUntilTheEngineHasTakenTheRecovery() {
        TappingStatus& tapping = m_bench->engine.fake.tapping;
        tapping.phase = TapPhase::InHole;
        show();
        QVERIFY(m_bench->press("tappingRecover"));
        QVERIFY(m_bench->press("recoveryTurn"));
        m_bench->client.tick();
        QVERIFY(!text("recoveryState").contains(QStringLiteral("Gauge")));
    }

    // Looks.
    void everyTextFitsInEveryLook_data() {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<double>("scale");
        QTest::addColumn<bool>("korean");
        QTest::addColumn<int>("state");
        for (const bool korean : {false, true}) {
            const char* language = korean ? "ko" : "en";
            for (int state = 0; state < kStates; ++state) {
                QTest::addRow("1280x800_%s_%d", language, state) << kSmall << 1.0 << korean << state;
            }
            QTest::addRow("1920x1080_%s", language) << kMiddle << 1.0 << korean << 2;
            QTest::addRow("3840x2160_%s_x2", language) << 2 * kMiddle << 2.0 << korean << 2;
        }
    }
    void everyTextFitsInEveryLook() {
        QFETCH(QSize, size);
        QFETCH(double, scale);
        QFETCH(bool, korean);
        QFETCH(int, state);
        Preferences preferences;
        preferences.scale = scale;
        preferences.language = korean ? Language::Korean : Language::English;
        preferences.brightness = state % 2 == 0 ? Brightness::Light : Brightness::Dark;
        preferences.length = state == 3 ? LengthUnit::Inch : LengthUnit::Millimetre;
        m_bench->look.apply(preferences);
        TappingStatus& tapping = m_bench->engine.fake.tapping;
        if (state >= 1 && state < 5) m_service->tune(state == 1 ? 1 : 4);
        if (state == 2 || state == 3) {
            m_service->acceptTuning();
            tapping.airTapPassed = true;
            tapping.productionTaps = 123;
        }
        if (state == 4) {
            tapping.phase = TapPhase::InHole;
            tapping.stoppedSpindle_rev = 12.34;
            tapping.stoppedZ_mm = 15.425;
            m_bench->engine.fake.emergencyStop = true;
            m_bench->engine.loop(ProcessId::Tapping).state = LoopState::Held;
            m_bench->engine.loop(ProcessId::Tapping).reason =
                Sentence(KERF_TEXT("Emergency stop: the control has stopped the machine."));
        }
        m_bench->show<TappingPage>(size);
        if (state == 5) QVERIFY(m_bench->press("tappingJob"));
        if (state == 4) QVERIFY(m_bench->press("tappingRecover"));
        QApplication::processEvents();
        QApplication::processEvents();
        if (const QString folder = qEnvironmentVariable("KERF_PNG"); !folder.isEmpty()) {
            m_bench->save(folder + u'/' + QLatin1String(QTest::currentDataTag()) + QStringLiteral(".png"));
        }
        const QStringList clipped = test::clippedTexts(&m_bench->window);
        QVERIFY2(clipped.isEmpty(), qPrintable(clipped.join(u'\n')));
        const QStringList small = test::smallTargets(&m_bench->window, m_bench->look);
        QVERIFY2(small.isEmpty(), qPrintable(small.join(u'\n')));
    }

 private:
    static constexpr int kStates = 6;
    void show() { m_bench->show<TappingPage>(kSmall); }
    void tick() { m_bench->client.tick(); }
    [[nodiscard]] QString text(const char* name) { return m_bench->find<QLabel>(name)->text(); }
    [[nodiscard]] bool visible(const char* name) { return m_bench->find<QWidget>(name)->isVisible(); }
    [[nodiscard]] ActionButton* button(const char* name) { return m_bench->find<ActionButton>(name); }
    [[nodiscard]] QString reason(const char* name) { return button(name)->reason(); }

    std::unique_ptr<FakeTappingService> m_service;
    std::unique_ptr<PageBench> m_bench;
};
QTEST_MAIN(TestTappingPage)
#include "tst_tapping_page.moc"
