// SPDX-License-Identifier: GPL-3.0-or-later
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QTableWidget>
#include <QTest>

#include "engine/process/milling/cut_simulation.h"
#include "tests/support/fake_milling_service.h"
#include "tests/support/layout_check.h"
#include "tests/support/page_bench.h"
#include "tests/support/page_look.h"
#include "tests/support/start_rests.h"
#include "ui/pages/milling/milling_page.h"
#include "ui/widgets/value_field.h"

using namespace kerf;
using namespace kerf::ui;
using kerf::test::FakeMillingService;
using kerf::test::PageBench;

/// The milling page on a fake engine and service, and the touches of an engineer.
class TestMillingPage : public QObject {
    Q_OBJECT
 private slots:
    void init() {
        m_service = std::make_unique<FakeMillingService>();
        m_bench = std::make_unique<PageBench>();
        m_bench->services.millingService = m_service.get();
        m_bench->engine.caps.cycleStart.fitted = true;
        LoopStatus& loop = m_bench->engine.loop(ProcessId::Milling);
        loop.fitted = true;
        loop.mode = LoopMode::Control;
        loop.state = LoopState::Controlling;
        loop.reason = Sentence(KERF_TEXT("Ready: the next cut holds the reference force."));
        MillingStatus& milling = m_bench->engine.fake.milling;
        milling.setup = 1;
        milling.reference_N = 392.0;
        milling.overload_N = 650.0;
        milling.lawUnavailable[static_cast<std::size_t>(MillingLaw::Preview)] =
            Sentence(KERF_TEXT("No blank profile is loaded: enter or import one."));
    }
    void cleanup() {
        m_bench.reset();
        m_service.reset();
    }

    // Live.
    void forceAndFeedRunWithReferenceAndLimit() {
        show();
        cutHalf();
        settle();
        QTRY_VERIFY((m_bench->client.tick(), !m_bench->find<LivePlot>("millingForceChart")->drawn(kAverage).isEmpty()));
        QTRY_VERIFY((m_bench->client.tick(), !m_bench->find<LivePlot>("millingFeedChart")->drawn(kMade).isEmpty()));
        QCOMPARE(m_bench->find<NumberDisplay>("millingForce")->text(), QStringLiteral("395"));
        QCOMPARE(m_bench->find<NumberDisplay>("millingFeed")->text(), QStringLiteral("1.42"));
    }
    void theRawForceStandsBehindOnDemand() {
        show();
        cutHalf();
        auto* chart = m_bench->find<LivePlot>("millingForceChart");
        QVERIFY(chart->drawn(kRaw).isEmpty());
        QVERIFY(m_bench->press("millingRawForce"));
        cutHalf();
        QTRY_VERIFY((m_bench->client.tick(), !chart->drawn(kRaw).isEmpty()));
        QVERIFY(m_bench->press("millingRawForce"));
        QVERIFY(chart->drawn(kRaw).isEmpty());
    }
    void anUntrustedForceIsNotDrawnAsZero() {
        show();
        MillingStatus& milling = m_bench->engine.fake.milling;
        milling.blind = true;
        milling.force_N = {0.0, m_bench->engine.fake.machineTime_ns, Quality::Missing};
        cutHalf(false);
        QVERIFY(m_bench->find<LivePlot>("millingForceChart")->drawn(kAverage).isEmpty());
        QTRY_VERIFY((m_bench->client.tick(), !m_bench->find<LivePlot>("millingFeedChart")->drawn(kMade).isEmpty()));
        settle();
        QVERIFY(!m_bench->find<NumberDisplay>("millingForce")->text().contains(u'0'));
    }
    void samplesOfAnotherProcessAreNotMilling() {
        show();
        cutHalf();
        const auto before = m_bench->find<LivePlot>("millingFeedChart")->drawn(kMade).size();
        m_bench->engine.fake.programProcess = ProcessId::Boring;
        Sample sample;
        sample.machineTime_ns = m_bench->engine.fake.machineTime_ns + 1;
        m_bench->engine.samples.push_back(sample);
        m_bench->client.tick();
        QVERIFY(m_bench->find<LivePlot>("millingFeedChart")->drawn(kMade).size() <= before);
    }
    void theWallOfTheCutBeforeStaysBehind() {
        show();
        cutHalf();
        auto* wall = m_bench->find<Chart>("millingWallChart");
        QTRY_VERIFY((m_bench->client.tick(), wall->drawn(1).size() > 20));
        QVERIFY(wall->drawn(0).isEmpty());
        m_bench->engine.fake.milling.cutting = false;
        m_bench->client.tick();
        m_bench->engine.fake.milling.cutting = true;
        QTRY_VERIFY((m_bench->client.tick(), wall->drawn(0).size() > 20));
        QVERIFY(wall->drawn(1).isEmpty());
        QVERIFY(text("millingWaviness").contains(QStringLiteral("9.3")));
    }
    void adviceSaysWhatControlWouldSaveAndPrevent() {
        m_bench->engine.loop(ProcessId::Milling).mode = LoopMode::Advise;
        MillingStatus& milling = m_bench->engine.fake.milling;
        milling.overReference_s = 21.4;
        milling.stops = 1;
        show();
        cutHalf();
        settle();
        QVERIFY(text("millingAdvice").contains(QStringLiteral("21.4")));
        QVERIFY(text("millingAdvice").contains(QStringLiteral("would have stopped")));
        QVERIFY(m_bench->find<NumberDisplay>("millingSaved")->accessibleName().contains(QStringLiteral("would save")));
    }
    void wearIsDrawnOverTheParts() {
        m_service->cutParts(6);
        m_bench->engine.fake.milling.partsWithTool = 6;
        m_bench->engine.fake.milling.wear = 0.0953;
        m_bench->engine.fake.milling.wearPerPart = 0.0149;
        show();
        m_bench->client.tick();
        QCOMPARE(m_bench->find<Chart>("millingWearChart")->drawn(0).size(), 6);
        QVERIFY(text("millingWear").contains(QStringLiteral("10 %")));
        QVERIFY(text("millingWear").contains(QStringLiteral("1.5 %")));
    }

    // What may be told the loop.
    void aLawIsChosenAndShownAsTheEngineSays() {
        show();
        m_bench->engine.answer = false;
        QVERIFY(m_bench->press("millingLawPi"));
        const auto* law = std::get_if<SetMillingLaw>(&m_bench->engine.commands.back().action);
        QVERIFY(law != nullptr);
        QCOMPARE(law->law, MillingLaw::Pi);
        QVERIFY(m_bench->find<QPushButton>("millingLawModel")->isChecked());
        m_bench->engine.fake.milling.law = MillingLaw::Pi;
        m_bench->client.tick();
        QVERIFY(m_bench->find<QPushButton>("millingLawPi")->isChecked());
    }
    void anUnavailableLawSaysWhy() {
        show();
        auto* preview = m_bench->find<ActionButton>("millingLawPreview");
        QVERIFY(!preview->isEnabled());
        QVERIFY(preview->reason().contains(QStringLiteral("blank profile")));
    }
    void aStartSaysWhatStandsInItsWay() {
        show();
        test::startSaysWhyNot(*m_bench, "millingStart");
    }
    void aStartRestsUntilTheNewestIsShown() {
        show();
        test::startRests(*m_bench, "millingStart", ProcessId::Milling);
    }
    void teachStartAndReleaseSaySoWhenTheyCannot() {
        show();
        QVERIFY(!m_bench->press("millingTeach"));
        QVERIFY(!m_bench->press("millingRelease"));
        QVERIFY(m_bench->press("millingStart"));
        QCOMPARE(std::get<StartPart>(m_bench->engine.commands.back().action).process, ProcessId::Milling);
        m_bench->engine.fake.program = ProgramState::Running;
        m_bench->engine.fake.programProcess = ProcessId::Boring;
        m_bench->engine.fake.milling.meanForce_N = 371.0;
        m_bench->client.tick();
        QVERIFY(!m_bench->press("millingStart"));
        QVERIFY(m_bench->find<ActionButton>("millingStart")->reason().contains(QStringLiteral("Boring")));
        m_bench->engine.fake.milling.stopped = true;  // a stop is the nearer reason
        m_bench->engine.fake.stops[1].slot = {7, 6, StopKind::FeedHold, 201};
        m_bench->client.tick();
        QVERIFY(!m_bench->press("millingStart"));
        QVERIFY(!m_bench->find<ActionButton>("millingStart")->reason().contains(QStringLiteral("Boring")));
        QVERIFY(m_bench->press("millingTeach"));
        QVERIFY(std::holds_alternative<TeachMillingReference>(m_bench->engine.commands.back().action));
        QVERIFY(m_bench->press("millingRelease"));
        const auto* release = std::get_if<ReleaseStop>(&m_bench->engine.commands.back().action);
        QVERIFY(release != nullptr && release->process == ProcessId::Milling && release->number == 7);
        QVERIFY(!release->person.view().empty());
    }
    void theSwitchAsksTheEngine() {
        show();
        QVERIFY(m_bench->press("millingModeAdvise"));
        const auto* mode = std::get_if<SetLoopMode>(&m_bench->engine.commands.back().action);
        QVERIFY(mode != nullptr && mode->process == ProcessId::Milling && mode->mode == LoopMode::Advise);
        QVERIFY(m_bench->find<QPushButton>("millingModeControl")->isChecked());
    }
    void aNewToolIsAskedAboutFirst() {
        show();
        QVERIFY(m_bench->press("millingNewTool"));
        QVERIFY(m_service->calls.empty());
        QVERIFY(m_bench->press("sheetProceed"));
        QCOMPARE(m_service->calls.at(0).what, std::string("new tool"));
        QCOMPARE(m_service->calls.at(0).author, std::string("Kim"));
    }
    void whatIsBeingCutKeepsItsSetup() {
        show();
        m_bench->engine.fake.milling.cutting = true;
        m_bench->client.tick();
        for (const char* name : {"millingSetup", "millingBlank", "millingNewTool"}) {
            QVERIFY2(!m_bench->press(name), name);
        }
    }
    void withoutALoopThePageSaysSo() {
        m_bench->services.millingService = nullptr;
        show();
        QVERIFY(m_bench->page->findChild<QLabel*>()->isVisible());
    }

    // Setup.
    void aNumberIsChangedAndSaved() {
        show();
        QVERIFY(m_bench->press("millingSetup"));
        QVERIFY(text("millingSetupHint").contains(QStringLiteral("default 392")));
        field(0)->edit()->setFocus();
        QTest::keyClicks(field(0)->edit(), QStringLiteral("350"));
        QVERIFY(m_bench->press("millingSetupSave"));
        QCOMPARE(m_service->calls.at(0).what, std::string("setup"));
        QCOMPARE(m_service->calls.at(0).setup.reference_N, 350.0);
        QVERIFY(m_bench->sheets->current() == nullptr);
    }
    void aBadNumberIsRefusedWithItsRangeAndNothingIsLost() {
        show();
        QVERIFY(m_bench->press("millingSetup"));
        QVERIFY(m_bench->press("millingGroup1"));
        field(6)->edit()->setFocus();
        QTest::keyClicks(field(6)->edit(), QStringLiteral("99999"));
        QVERIFY(m_bench->press("millingGroup0"));
        QVERIFY(m_bench->press("millingSetupSave"));
        QVERIFY(m_service->calls.empty());
        for (const char* piece : {"Spindle speed", "60", "12000"}) {
            QVERIFY2(text("millingSetupMessage").contains(QLatin1String(piece)),
                     qPrintable(text("millingSetupMessage")));
        }
        QVERIFY(field(6)->isVisible());  // its group comes up
        QCOMPARE(field(6)->edit()->text(), QStringLiteral("99999"));
    }
    void numbersThatDoNotAgreeAreRefused() {
        show();
        QVERIFY(m_bench->press("millingSetup"));
        field(3)->setValue(0.5);  // highest feed below the planned one
        QVERIFY(m_bench->press("millingSetupSave"));
        QVERIFY(m_service->calls.empty());
        QVERIFY(text("millingSetupMessage").contains(QStringLiteral("Highest feed")));
    }
    void aNewNameMakesAPartType() {
        show();
        QVERIFY(m_bench->press("millingSetup"));
        QVERIFY(!m_bench->press("millingSetupOpen"));
        auto* name = m_bench->find<QLineEdit>("millingPartType");
        name->selectAll();
        QTest::keyClicks(name, QStringLiteral("Cover"));
        QVERIFY(!m_bench->press("millingSetupOpen"));  // nothing stored under it
        QVERIFY(m_bench->press("millingSetupSave"));
        QCOMPARE(m_service->calls.at(0).text, std::string("Cover"));
        QCOMPARE(m_service->calls.at(1).what, std::string("setup"));
    }
    void aStoredPartTypeIsOpened() {
        show();
        QVERIFY(m_bench->press("millingSetup"));
        auto* name = m_bench->find<QLineEdit>("millingPartType");
        name->selectAll();
        QTest::keyClicks(name, QStringLiteral("Housing"));
        QVERIFY(m_bench->press("millingSetupOpen"));
        QCOMPARE(m_service->view().partType, std::string("Housing"));
        QCOMPARE(m_service->calls.size(), std::size_t{1});
    }
    void whatCannotBeStoredStaysOnTheSheet() {
        m_service->storeFails = Sentence("disk full");
        show();
        QVERIFY(m_bench->press("millingSetup"));
        QVERIFY(m_bench->press("millingSetupSave"));
        QVERIFY(text("millingSetupMessage").contains(QStringLiteral("disk full")));
        QVERIFY(m_bench->sheets->current() != nullptr);
    }

    // Blank.
    void aBlankIsTypedStepByStep() {
        show();
        QVERIFY(m_bench->press("millingBlank"));
        step("0", "1");
        step("40", "3");
        step("20", "2");  // in any order
        step("20", "2.5");
        QVERIFY(m_bench->press("millingBlankUse"));
        const MillingBlank& blank = m_service->calls.at(0).blank;
        QCOMPARE(blank.count, std::uint16_t{3});
        QCOMPARE(blank.begin_mm[1], 20.0);
        QCOMPARE(blank.height_mm[1], 2.5);
        QCOMPARE(blank.end_mm, 100.0);
    }
    void aBadFileSaysLineAndColumnAndChangesNothing() {
        show();
        QVERIFY(m_bench->press("millingBlank"));
        step("0", "1");
        QVERIFY(m_bench->press("millingBlankImport"));
        for (const char* piece : {"Line 4", "height_mm", "two"}) {
            QVERIFY2(text("millingBlankMessage").contains(QLatin1String(piece)),
                     qPrintable(text("millingBlankMessage")));
        }
        QCOMPARE(m_bench->find<Chart>("millingBlankChart")->drawn(0).size(), 2);
        QVERIFY(m_service->calls.empty());
    }
    void aFileIsImportedAndSavedWithItsName() {
        MillingBlank blank;
        blank.count = 1;
        blank.height_mm[0] = 2.0;
        blank.end_mm = 60.0;
        m_service->files["/tmp/wall.csv"] = blank;
        show();
        QVERIFY(m_bench->press("millingBlank"));
        m_bench->find<QLineEdit>("millingBlankFile")->setText(QStringLiteral("/tmp/wall.csv"));
        QVERIFY(m_bench->press("millingBlankImport"));
        QVERIFY(m_bench->press("millingBlankUse"));
        QCOMPARE(m_service->calls.at(0).text, std::string("/tmp/wall.csv"));
        QCOMPARE(m_service->calls.at(0).blank.end_mm, 60.0);
    }
    void stepsThatCannotBeAreNotSaved() {
        show();
        QVERIFY(m_bench->press("millingBlank"));
        step("0", "1");
        step("120", "2");  // behind the end of the blank
        auto* use = m_bench->find<ActionButton>("millingBlankUse");
        QVERIFY(!use->isEnabled() && !use->reason().isEmpty());
        QVERIFY(m_bench->press("millingBlankRemove"));
        QVERIFY(use->isEnabled());
    }
    void aStepThatIsTypedIsNotLost() {
        show();
        QVERIFY(m_bench->press("millingBlank"));
        step("0", "1");
        auto* use = m_bench->find<ActionButton>("millingBlankUse");
        QVERIFY(use->isEnabled());
        auto* begin = m_bench->find<ValueField>("millingBlankBegin")->edit();
        QTest::keyClicks(begin, QStringLiteral("4"));
        QVERIFY(!use->isEnabled());
        QVERIFY2(use->reason().contains(QStringLiteral("not added")), qPrintable(use->reason()));
        QTest::keyClick(begin, Qt::Key_Backspace);
        QVERIFY(use->isEnabled());
    }
    void theLogShowsTheLastCuts() {
        show();
        QVERIFY(!m_bench->press("millingLog"));
        m_service->cutParts(4);
        QVERIFY(m_bench->press("millingLog"));
        auto* log = m_bench->find<QTableWidget>("millingCutLog");
        QCOMPARE(log->rowCount(), 4);
        QCOMPARE(log->item(0, 0)->text(), QStringLiteral("4"));
        QCOMPARE(log->item(1, 5)->text(), QStringLiteral("634"));
    }

    void everyTextFitsInEveryLook_data() { test::addPageLooks(kSmall, kMiddle); }
    void everyTextFitsInEveryLook() {
        QFETCH(test::PageLook, look);
        m_bench->look.apply(look.preferences());
        if (look.full) {
            m_service->cutParts(14);
        }
        m_bench->show<MillingPage>(look.size);
        const QString name = QStringLiteral("milling_%1").arg(QLatin1String(QTest::currentDataTag()));
        if (look.full) {
            QVERIFY(m_bench->press("millingRawForce"));
            cutHalf();
            settle();
        }
        check(m_bench->page, name);
        if (look.full) {
            stopped();
            check(m_bench->page, name + QStringLiteral("_stopped"));
            m_bench->engine.fake.milling.cutting = false;
            m_bench->client.tick();
        }
        QVERIFY(m_bench->press("millingSetup"));
        for (int group = 0; group < 3; ++group) {
            QVERIFY(m_bench->press(qPrintable(QStringLiteral("millingGroup%1").arg(group))));
            check(m_bench->sheets->current(), name + QStringLiteral("_setup%1").arg(group));
        }
        m_bench->sheets->current()->close();
        QVERIFY(m_bench->press("millingBlank"));
        step("0", "1");
        step("2", "1.5");
        check(m_bench->sheets->current(), name + QStringLiteral("_blank"));
        m_bench->sheets->current()->close();
        if (look.full) {
            QVERIFY(m_bench->press("millingLog"));
            check(m_bench->sheets->current(), name + QStringLiteral("_log"));
        }
    }

 private:
    static constexpr QSize kSmall{1083, 670};
    static constexpr QSize kMiddle{1723, 950};
    static constexpr Chart::CurveId kRaw = 0;  // in the order the panels add them
    static constexpr Chart::CurveId kAverage = 1;
    static constexpr Chart::CurveId kMade = 1;

    void show() { m_bench->show<MillingPage>(); }
    [[nodiscard]] QString text(const char* name) {
        auto* label = m_bench->find<QLabel>(name);
        return label != nullptr ? label->text() : QString();
    }
    [[nodiscard]] ValueField* field(int index) {
        return m_bench->find<ValueField>(qPrintable(QStringLiteral("millingField%1").arg(index)));
    }
    void step(const char* begin, const char* height) {
        for (const auto& [name, typed] : {std::pair("millingBlankBegin", begin), {"millingBlankHeight", height}}) {
            auto* edit = m_bench->find<ValueField>(name)->edit();
            edit->selectAll();
            QTest::keyClicks(edit, QLatin1String(typed));
        }
        QVERIFY(m_bench->press("millingBlankAdd"));
    }
    /// Numbers settle at 5 Hz.
    void settle() {
        auto* number = m_bench->find<NumberDisplay>("millingFeed");
        QTRY_VERIFY((m_bench->client.tick(), number->accessibleName().endsWith(number->text())));
    }
    void check(QWidget* shown, const QString& name) {
        m_bench->save(name + QStringLiteral(".png"));
        const QStringList problems = test::clippedTexts(shown) + test::smallTargets(shown, m_bench->look);
        if (!problems.isEmpty()) {
            QTest::qFail(qPrintable(name + u'\n' + problems.join(u'\n')), __FILE__, __LINE__);
        }
    }
    /// The published blank up to its middle under the default law, as the engine would tell it.
    void cutHalf(bool good = true) {
        milling::CutCase cut;
        const double heights_mm[] = {1, 2, 3, 2, 1};
        cut.blank = *milling::BlankProfile::ofSegments(heights_mm, 20.0);
        cut.forceNoise_N = 5.0;
        Status& status = m_bench->engine.fake;
        status.program = ProgramState::Running;
        status.programProcess = ProcessId::Milling;
        MillingStatus& milling = status.milling;
        milling.cutting = true;
        m_bench->client.tick();
        for (const milling::CutRow& row : milling::simulateCut(cut).rows) {
            if (row.x_mm > 64.0) {
                break;
            }
            status.machineTime_ns += 100'000'000;
            Sample sample;
            sample.machineTime_ns = status.machineTime_ns;
            sample.cutting = true;
            sample.force_N = static_cast<float>(row.forceMeasured_N);
            sample.forceLow_N = static_cast<float>(0.5 * row.forceMeasured_N);
            sample.forceHigh_N = static_cast<float>(1.5 * row.forceMeasured_N);
            sample.feed_mmPerS = static_cast<float>(row.feedCommand_mmPerS);
            sample.wantedFeed_mmPerS = static_cast<float>(row.feedCommand_mmPerS);
            sample.path_mm = static_cast<float>(row.x_mm);
            sample.wallDeviation_um = static_cast<float>(1e3 * row.deflectionY_mm);
            m_bench->engine.samples.push_back(sample);
        }
        if (good) {
            milling.force_N = {395.2, status.machineTime_ns, Quality::Good};
        }
        status.actualFeed_mmPerS = {1.42, status.machineTime_ns, Quality::Good};
        milling.stiffnessKnown = true;
        milling.stiffness = 7.93;
        milling.stiffnessHalf95 = 0.05;
        milling.waviness_um = 9.3;
        milling.gainMargin = 3.6;
        milling.peakForce_N = 424.0;
        milling.savedTime_s = 3.4;
        milling.partsWithTool = static_cast<std::uint32_t>(m_service->view().cuts.size());
        milling.wear = 0.19;
        milling.wearPerPart = 0.0148;
        LoopStatus& loop = m_bench->engine.loop(ProcessId::Milling);
        loop.reason = Sentence(KERF_TEXT("The feed holds the reference force."));
        while (!m_bench->engine.samples.empty()) {
            m_bench->client.tick();
        }
        m_bench->client.tick();
    }
    void stopped() {
        MillingStatus& milling = m_bench->engine.fake.milling;
        milling.stopped = true;
        milling.stops = 1;
        milling.overReference_s = 2.3;
        for (Sentence& why : milling.lawUnavailable) {
            why = Sentence(KERF_TEXT("This machine has no force sensor."));
        }
        LoopStatus& loop = m_bench->engine.loop(ProcessId::Milling);
        loop.state = LoopState::Held;
        loop.reason = Sentence(KERF_TEXT("The feed is held: see the alarm, then release the feed here."));
        m_bench->client.tick();
        settle();
    }

    std::unique_ptr<FakeMillingService> m_service;
    std::unique_ptr<PageBench> m_bench;
};

QTEST_MAIN(TestMillingPage)
#include "tst_milling_page.moc"
