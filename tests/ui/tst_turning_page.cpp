// SPDX-License-Identifier: GPL-3.0-or-later
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QTableWidget>
#include <QTest>
#include <cmath>

#include "tests/support/fake_turning_service.h"
#include "tests/support/layout_check.h"
#include "tests/support/page_bench.h"
#include "tests/support/page_look.h"
#include "tests/support/start_rests.h"
#include "ui/pages/turning/spectrum_chart.h"
#include "ui/pages/turning/turning_page.h"
#include "ui/widgets/action_button.h"
#include "ui/widgets/number_display.h"

using namespace kerf;
using namespace kerf::ui;
using kerf::test::FakeTurningService;
using kerf::test::PageBench;

/// Two parts on the fake service, a cut on the fake engine, and the touches of an operator.
class TestTurningPage : public QObject {
    Q_OBJECT
 private slots:
    void init() {
        m_service = std::make_unique<FakeTurningService>();
        m_bench = std::make_unique<PageBench>();
        m_bench->services.turningService = m_service.get();
        LoopStatus& loop = m_bench->engine.loop(ProcessId::Turning);
        loop.fitted = true;
        loop.mode = LoopMode::Advise;
        loop.state = LoopState::Advising;
        loop.reason = Sentence("Ready: force feedback begins at the touch of the next part.");
        m_bench->engine.caps.cycleStart.fitted = true;
        m_bench->engine.caps.cycle_ns = 200'000;
    }
    void cleanup() {
        m_bench.reset();
        m_service.reset();
    }

    // Control.
    void modeStartAndControllerAreAskedFor() {
        show();
        QVERIFY(m_bench->press("turningModeControl"));
        const auto* mode = std::get_if<SetLoopMode>(&m_bench->engine.commands.back().action);
        QVERIFY(mode != nullptr);
        QCOMPARE(mode->mode, LoopMode::Control);
        QCOMPARE(mode->process, ProcessId::Turning);
        QVERIFY(m_bench->find<QPushButton>("turningModeAdvise")->isChecked());  // the engine says what the mode is
        QVERIFY(m_bench->press("turningStart"));
        const auto* start = std::get_if<StartPart>(&m_bench->engine.commands.back().action);
        QVERIFY(start != nullptr);
        QCOMPARE(start->process, ProcessId::Turning);
        QVERIFY(m_bench->press("turningPi"));
        QCOMPARE(m_service->view().controller, TurningController::Pi);
        QVERIFY(m_bench->find<QPushButton>("turningPi")->isChecked());
        QCOMPARE(m_service->authors.back(), std::string("Kim"));
    }
    void aControllerThatCannotBeStoredStaysTheOldOne() {
        show();
        m_service->failWith = Sentence("The disk is full.");
        QVERIFY(m_bench->press("turningPaper"));
        QVERIFY(m_bench->find<QPushButton>("turningTones")->isChecked());
        QVERIFY(m_bench->notices.back().contains(QStringLiteral("The disk is full.")));
    }
    void aStartSaysWhatStandsInItsWay() {
        show();
        test::startSaysWhyNot(*m_bench, "turningStart");
    }
    void aStartRestsUntilTheNewestIsShown() {
        show();
        test::startRests(*m_bench, "turningStart", ProcessId::Turning);
    }
    void startSaysWhyItIsOff() {
        show();
        auto* start = m_bench->find<ActionButton>("turningStart");
        QVERIFY(start->isEnabled());
        m_bench->engine.fake.held = true;
        m_bench->client.tick();
        QVERIFY(!start->isEnabled());
        QVERIFY(!start->reason().isEmpty());
        m_bench->engine.fake.held = false;
        cut();
        m_bench->client.tick();
        QVERIFY(!start->isEnabled());
        QVERIFY(start->reason().contains(QStringLiteral("being cut")));
    }
    void withoutANameNothingIsChanged() {
        show();
        m_bench->session.signOff();
        QVERIFY(m_bench->press("turningPi"));
        QVERIFY(m_bench->press("turningSetup"));
        QCOMPARE(m_bench->askedForName, 2);
        QVERIFY(m_service->authors.empty());
    }
    void withoutAServiceThePageSaysWhatIsMissing() {
        m_bench->services.turningService = nullptr;
        show();
        const auto* label = m_bench->page->findChild<QLabel*>();
        QVERIFY(label->isVisible() && label->text().contains(QStringLiteral("0.2 ms")));
    }

    // Live.
    void theForceIsDrawnBetweenItsLowestAndHighestWithItsTarget() {
        show();
        cut();
        run(50);
        auto* chart = m_bench->find<Chart>("turningForceChart");
        QVERIFY(chart->drawn(0).size() >= 2);
        double low = 1e9;
        double high = -1e9;
        for (const QPointF& p : chart->drawn(0)) {
            low = std::min(low, p.y());
            high = std::max(high, p.y());
        }
        QVERIFY(std::abs(low - 1.1) < 0.06 && std::abs(high - 1.8) < 0.06);
        QVERIFY(!chart->drawn(1).isEmpty());
        QTRY_VERIFY((run(1), text("turningForceNow").contains(QStringLiteral("1.44"))));
        QVERIFY(m_bench->find<QProgressBar>("turningProgress")->value() == 40);
        QVERIFY(text("turningDepthNow").contains(QStringLiteral("6.0")));
    }
    void surfaceProcessMarginsAndTrimAreShown() {
        show();
        cut();
        m_service->archiveTwo();
        run(20);
        QTRY_VERIFY((run(1), number("turningSurfaceRms") == QStringLiteral("0.053")));
        QTRY_VERIFY((run(1), number("turningUntreatedRms") == QStringLiteral("0.668")));
        QVERIFY(text("turningFound1").contains(QStringLiteral("0.7470 ± 0.0030")));
        QVERIFY(text("turningLaw1").contains(QStringLiteral("0.7470")));
        QVERIFY(text("turningExcitation").contains(QStringLiteral("enough")));
        QTRY_COMPARE(number("turningGainMargin"), QStringLiteral("74.5"));
        QTRY_COMPARE(number("turningPhaseMargin"), QStringLiteral("83"));
        QVERIFY(text("turningMarginNote").contains(QStringLiteral("Guaranteed")));
        QVERIFY(text("turningTrim").contains(QStringLiteral("1.20")));
        QVERIFY(text("turningTrim").contains(QStringLiteral("2.00")));
    }
    void aPartCutWhileAnotherPageWasOpenHasItsFigures() {
        show();
        run(20);
        QCOMPARE(number("turningSurfaceRms"), QStringLiteral("–"));
        m_service->archiveTwo();
        run(20);
        QTRY_VERIFY((run(1), number("turningSurfaceRms") != QStringLiteral("–")));
        QTRY_VERIFY((run(1), number("turningUntreatedRms") != QStringLiteral("–")));
    }
    void withoutAMotionSensorTheProcessIsSaidToBeAssumed() {
        show();
        cut();
        m_bench->engine.fake.turning.identification = {};
        run(20);
        QCOMPARE(text("turningFound1"), QStringLiteral("–"));
        QVERIFY(text("turningProcessNote").contains(QStringLiteral("sensor of the tool")));
        QVERIFY(text("turningMarginNote").contains(QStringLiteral("as soon as")));
    }

    // Tones.
    void blindTonesAreNamedAndABetterSpeedIsOffered() {
        show();
        cut();
        m_service->archiveTwo();
        run(2);
        QVERIFY(text("turningBlind").contains(QStringLiteral("86.0 Hz")));
        auto* spectrum = m_bench->find<SpectrumChart>("turningSpectrum");
        QCOMPARE(spectrum->tones().size(), std::size_t{5});
        QVERIFY(spectrum->toneLabel(spectrum->tones()[2]).contains(QStringLiteral("blind")));
        QVERIFY(!spectrum->toneLabel(spectrum->tones()[4]).contains(QStringLiteral("blind")));
        QVERIFY(spectrum->drawn(1).size() > 100);
        QVERIFY(m_bench->press("turningUseSpeed"));
        auto* speed = m_bench->find<QLineEdit>("turningField1Edit");
        QVERIFY(speed != nullptr);
        QCOMPARE(speed->text(), QStringLiteral("1119"));
        QVERIFY(m_bench->press("turningSetupApply"));
        QCOMPARE(m_service->view().setup.spindleSpeed_rpm, 1119.4);
        m_service->fake.blind = {1119.4, {{86.0, 0.9, false, false}}, false, {}, 0.0};
        m_service->change();
        QVERIFY(!m_bench->find<QWidget>("turningUseSpeed")->isVisible());
        QVERIFY(text("turningBlind").contains(QStringLiteral("every known tone")));
    }

    // Setup.
    void theSetupIsTypedAndItsOverlapShown() {
        show();
        QVERIFY(m_bench->press("turningSetup"));
        QVERIFY(text("turningOverlap").contains(QStringLiteral("0.9556")));
        type("turningField2Edit", "2.61");
        QVERIFY(text("turningOverlap").contains(QStringLiteral("0.98")));
        type("turningField0Edit", "5.5");
        QVERIFY(m_bench->press("turningSetupTones"));
        type("turningTone5Edit", "150");
        QVERIFY(m_bench->press("turningSetupApply"));
        const TurningSetup& setup = m_service->view().setup;
        QCOMPARE(setup.depth_um, 5.5);
        QCOMPARE(setup.feed_umPerRev, 2.61);
        QCOMPARE(static_cast<int>(setup.knownToneCount), 1);
        QCOMPARE(setup.knownTones_Hz[0], 150.0);
        QVERIFY(m_bench->sheets->current() == nullptr);
        QVERIFY(text("turningSetupText").contains(QStringLiteral("5.50")));
    }
    void aSetupThatCannotBeCutIsRefusedWhereItIsTyped() {
        show();
        QVERIFY(m_bench->press("turningSetup"));
        type("turningField0Edit", "99");
        QVERIFY(!m_bench->press("turningSetupApply"));
        QVERIFY(!m_bench->find<ActionButton>("turningSetupApply")->reason().isEmpty());
        type("turningField0Edit", "6");
        type("turningField5Edit", "-3");
        QVERIFY(!m_bench->press("turningSetupApply"));
        QVERIFY(m_bench->find<ActionButton>("turningSetupApply")->reason().contains(QStringLiteral("face")));
        QCOMPARE(m_service->view().setup.depth_um, 6.0);
    }
    void aSetupThatCannotBeStoredStaysOpenWithTheReason() {
        show();
        QVERIFY(m_bench->press("turningSetup"));
        m_service->failWith = Sentence("The disk is full.");
        QVERIFY(m_bench->press("turningSetupApply"));
        QVERIFY(text("turningSetupMessage").contains(QStringLiteral("The disk is full.")));
        QVERIFY(m_bench->sheets->current() != nullptr);
    }
    void theSetupKeepsItsValueInInch() {
        show();
        Preferences preferences;
        preferences.length = LengthUnit::Inch;
        m_bench->look.apply(preferences);
        QVERIFY(m_bench->press("turningSetup"));
        QVERIFY(m_bench->press("turningSetupApply"));
        QCOMPARE(m_service->view().setup.depth_um, 6.0);
        QCOMPARE(m_service->view().setup.toolRadius_um, 800.0);
    }

    // Comparison and archive.
    void theComparisonAppearsWithTheSecondPart() {
        show();
        QVERIFY(m_bench->find<QWidget>("turningNoComparison")->isVisible());
        QVERIFY(!m_bench->press("turningArchive"));
        m_service->archiveTwo();
        QVERIFY(!m_bench->find<QWidget>("turningNoComparison")->isVisible());
        QCOMPARE(text("turningComparison13"), QStringLiteral("−92.1 %"));
        QCOMPARE(text("turningComparison23"), QStringLiteral("−88.7 %"));
        QVERIFY(text("turningComparison33").contains(QStringLiteral("0.0 %")));
        QVERIFY(text("turningComparison02").contains(QStringLiteral("part 2")));
    }
    void theArchiveShowsEveryPart() {
        show();
        m_service->archiveTwo();
        QVERIFY(m_bench->press("turningArchive"));
        auto* table = m_bench->find<QTableWidget>("turningArchiveTable");
        QCOMPARE(table->rowCount(), 2);
        QCOMPARE(table->item(0, 0)->text(), QStringLiteral("2"));
        QVERIFY(text("turningArchiveText").startsWith(QStringLiteral("Part 2")));
        table->setCurrentCell(1, 0);
        QVERIFY(text("turningArchiveText").startsWith(QStringLiteral("Part 1")));
        QVERIFY(m_bench->find<Chart>("turningArchiveForce")->drawn(0).size() == 200);
        QVERIFY(m_bench->press("turningArchiveClose"));
    }
    void aPartIsLeftOutWithAReason() {
        show();
        m_service->archiveTwo();
        m_service->fake.memory = {2U, 2U};
        QVERIFY(m_bench->press("turningArchive"));
        m_bench->find<QTableWidget>("turningArchiveTable")->setCurrentCell(1, 0);
        m_bench->find<QLineEdit>("turningArchiveReason")->setText(QStringLiteral("chip in the cut"));
        QVERIFY(m_bench->press("turningArchiveLeaveOut"));
        QVERIFY(m_service->fake.parts.front().leftOut);
        QCOMPARE(m_service->fake.parts.front().leftOutReason, std::string("chip in the cut"));
        QVERIFY(!m_service->fake.parts.back().leftOut);
        QVERIFY(text("turningArchiveText").contains(QStringLiteral("chip in the cut")));
        QVERIFY(m_bench->find<QLineEdit>("turningArchiveReason")->text().isEmpty());
        QVERIFY(m_bench->press("turningArchiveLeaveOut"));  // the fake wants no reason
        QVERIFY(!m_service->fake.parts.front().leftOut);
        m_service->failWith = Sentence("There is no such part.");
        m_bench->find<QLineEdit>("turningArchiveReason")->setText(QStringLiteral("again"));
        QVERIFY(m_bench->press("turningArchiveLeaveOut"));
        QCOMPARE(text("turningArchiveMessage"), QStringLiteral("There is no such part."));
        QCOMPARE(m_bench->find<QLineEdit>("turningArchiveReason")->text(), QStringLiteral("again"));
        QVERIFY(m_bench->press("turningArchiveClose"));
    }
    void theKeyFigureIsTheSurface() {
        cut();
        const KeyFigure figure = turningFigure(m_bench->services, m_bench->engine.fake);
        QCOMPARE(figure.value.value_or(0.0), 0.053);
        m_bench->engine.fake.turning.stage = TurningStage::Idle;
        QVERIFY(!turningFigure(m_bench->services, m_bench->engine.fake).value.has_value());
    }

    void everyTextFitsInEveryLook_data() { test::addPageLooks(kSmall, kMiddle); }
    void everyTextFitsInEveryLook() {
        QFETCH(test::PageLook, look);
        m_bench->look.apply(look.preferences());
        m_bench->show<TurningPage>(look.size);
        m_wanted = look.size;
        const QString name = QStringLiteral("turning_%1").arg(QLatin1String(QTest::currentDataTag()));
        if (!look.full) {
            check(m_bench->page, name);
            return;
        }
        m_service->archiveTwo();
        cut();
        run(400);
        QTRY_VERIFY((
            run(1),
            m_bench->find<NumberDisplay>("turningSurfaceRms")->accessibleName().contains(number("turningSurfaceRms"))));
        check(m_bench->page, name);
        QVERIFY(m_bench->press("turningSetup"));
        check(m_bench->sheets->current(), name + QStringLiteral("_setup"));
        QVERIFY(m_bench->press("turningSetupTones"));
        check(m_bench->sheets->current(), name + QStringLiteral("_tones"));
        m_bench->sheets->current()->close();
        QVERIFY(m_bench->press("turningArchive"));
        check(m_bench->sheets->current(), name + QStringLiteral("_archive"));
        m_bench->sheets->current()->close();
        LoopStatus& loop = m_bench->engine.loop(ProcessId::Turning);
        loop.state = LoopState::Faulted;
        loop.reason = Sentence(KERF_TEXT("The cutting force has jumped: the trim is zero, look at the tool."));
        m_bench->engine.fake.turning.stage = TurningStage::Out;
        m_bench->engine.fake.turning.identification = {};
        run(20);
        check(m_bench->page, name + QStringLiteral("_fault"));
    }

 private:
    static constexpr QSize kSmall{1083, 670};   ///< the page area of 1280×800
    static constexpr QSize kMiddle{1723, 950};  ///< of 1920×1080

    void show() { m_bench->show<TurningPage>(); }
    void cut() {
        Status& s = m_bench->engine.fake;
        s.program = ProgramState::Running;
        s.programProcess = ProcessId::Turning;
        LoopStatus& loop = m_bench->engine.loop(ProcessId::Turning);
        loop.mode = LoopMode::Control;
        loop.state = LoopState::Controlling;
        loop.reason = Sentence(KERF_TEXT("The trim cancels %1 tones of the disturbance."), SentenceArg(5.0, 0));
        TurningStatus& t = s.turning;
        t.stage = TurningStage::Cutting;
        t.activeSetup = 1;
        t.progress = 0.4;
        t.forceMean_N = 1.441;
        t.forceTarget_N = 1.44;
        t.depth_um = 6.0;
        t.depthEstimate_um = 6.01;
        t.appliedTrim_um = 1.2;
        t.acting = true;
        t.surfaceRms_um = 0.053;
        t.surfacePv_um = 0.41;
        t.untreatedRms_um = 0.668;
        t.tones = {FakeTurningService::tone(17.0, 0.5), FakeTurningService::tone(52.0, 0.4),
                   FakeTurningService::tone(86.0, 0.25, true), FakeTurningService::tone(113.0, 0.25),
                   FakeTurningService::tone(120.0, 0.6)};
        t.toneCount = 5;
        t.identification.available = true;
        t.identification.sure = true;
        t.identification.value = {0.8725, 0.747, -0.7164};
        t.identification.half95 = {0.005, 0.003, 0.003};
        t.identification.trace = 0.02;
        t.identification.excitation = 6.2;
    }
    /// Cycles of the machine with samples, as the engine sends them.
    void run(int ticks) {
        for (int i = 0; i < ticks; ++i) {
            Status& s = m_bench->engine.fake;
            s.machineTime_ns += 20'000'000;
            const double phase = static_cast<double>(s.machineTime_ns) * 1e-9;
            s.turning.forceMean_N = 1.441 + 0.003 * std::sin(phase);
            s.turning.depthEstimate_um = 6.01 + 0.05 * std::sin(0.7 * phase);
            s.turning.identification.trace =
                s.turning.identification.available ? 0.02 * (1.0 + 0.5 * std::sin(phase)) : 0.0;
            for (int k = 0; k < 2; ++k) {
                Sample sample;
                sample.machineTime_ns = s.machineTime_ns + k * 10'000'000;
                sample.cutting = s.program == ProgramState::Running;
                sample.forceLow_N = static_cast<float>(1.13 + 0.03 * std::sin(11.0 * phase + k));
                sample.forceHigh_N = static_cast<float>(1.77 + 0.03 * std::cos(13.0 * phase + k));
                m_bench->engine.samples.push_back(sample);
            }
            m_bench->client.tick();
        }
    }
    void type(const char* name, const char* value) {
        auto* edit = m_bench->find<QLineEdit>(name);
        QVERIFY(edit != nullptr);
        edit->setFocus();
        edit->selectAll();
        QTest::keyClicks(edit, QLatin1String(value));
    }
    [[nodiscard]] QString text(const char* name) {
        const auto* label = m_bench->find<QLabel>(name);
        return label != nullptr ? label->text() : QString();
    }
    [[nodiscard]] QString number(const char* name) {
        const auto* display = m_bench->find<NumberDisplay>(name);
        return display != nullptr ? display->text() : QString();
    }
    void check(QWidget* shown, const QString& name) {
        m_bench->save(name + QStringLiteral(".png"));
        QVERIFY2(m_bench->window.height() <= m_wanted.height() && m_bench->window.width() <= m_wanted.width(),
                 qPrintable(QStringLiteral("%1 grows to %2×%3")
                                .arg(name)
                                .arg(m_bench->window.width())
                                .arg(m_bench->window.height())));
        const QStringList problems = test::clippedTexts(shown) + test::smallTargets(shown, m_bench->look);
        if (!problems.isEmpty()) {
            QTest::qFail(qPrintable(name + u'\n' + problems.join(u'\n')), __FILE__, __LINE__);
        }
    }

    QSize m_wanted;
    std::unique_ptr<FakeTurningService> m_service;
    std::unique_ptr<PageBench> m_bench;
};
QTEST_MAIN(TestTurningPage)
#include "tst_turning_page.moc"
