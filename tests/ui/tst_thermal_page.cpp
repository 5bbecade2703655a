// SPDX-License-Identifier: GPL-3.0-or-later
#include <QLabel>
#include <QTableWidget>
#include <QTest>

#include "tests/support/fake_thermal_service.h"
#include "tests/support/layout_check.h"
#include "tests/support/page_bench.h"
#include "tests/support/start_rests.h"
#include "ui/charts/chart.h"
#include "ui/pages/thermal/thermal_page.h"
#include "ui/pages/thermal/thermal_texts.h"
#include "ui/widgets/value_field.h"

using namespace kerf;
using namespace kerf::ui;
using kerf::test::FakeThermalService;
using kerf::test::PageBench;

/// The page on a fake service and engine, and the touches of an operator.
class TestThermalPage : public QObject {
    Q_OBJECT
 private slots:
    void init() {
        m_service = std::make_unique<FakeThermalService>();
        m_bench = std::make_unique<PageBench>();
        m_bench->services.thermalService = m_service.get();
        m_bench->engine.caps.cycleStart.fitted = true;
        FakeThermalService::fill(m_bench->engine.fake);
    }
    void cleanup() {
        m_bench.reset();
        m_service.reset();
    }

    void threeOffsetsWithTheirIntervalAndTheShiftTheControlHas() {
        show();
        QCOMPARE(m_bench->find<NumberDisplay>("thermalDriftY")->text(), QStringLiteral("\u221216.7"));
        QVERIFY(text("thermalShiftY").contains(QStringLiteral("17")));
        QVERIFY(text("thermalReady").contains(QStringLiteral("12 min")));
        QVERIFY(text("thermalLoopReason").contains(QStringLiteral("follows the predicted drift")));
    }
    void withoutAPredictionThereIsNoNumber() {
        m_bench->engine.fake.thermal.stage = ThermalStage::Holding;
        show();
        QCOMPARE(m_bench->find<NumberDisplay>("thermalDriftX")->text(), QStringLiteral("–"));
    }
    void thePredictionIsDrawnBesideTheMeasurements() {
        show();
        auto* chart = m_bench->find<Chart>("thermalChart");
        QCOMPARE(chart->drawn(0).size(), 120);  // X predicted
        QCOMPARE(chart->drawn(1).size(), 3);    // X measured
    }
    void theSwitchAsksTheEngine() {
        show();
        QVERIFY(m_bench->press("thermalModeAdvise"));
        const auto* mode = last<SetLoopMode>();
        QVERIFY(mode != nullptr);
        QCOMPARE(mode->process, ProcessId::Thermal);
        QCOMPARE(mode->mode, LoopMode::Advise);
        QVERIFY(m_bench->find<QPushButton>("thermalModeControl")->isChecked());  // the engine has not said so yet
    }
    void aSickThermocoupleIsNamed() {
        show();
        QVERIFY(text("thermalHealth").contains(QStringLiteral("healthy")));
        m_bench->engine.fake.thermal.couple[7] = CoupleState::Open;
        m_bench->client.tick();
        QVERIFY(text("thermalHealth").contains(QStringLiteral("T07 open")));
        QVERIFY(m_bench->press("thermalSensors"));
        QVERIFY(cell("thermalSensorTable", 0, 0).contains(QStringLiteral("T07")));
        QCOMPARE(cell("thermalSensorTable", 0, 2), QStringLiteral("open"));
    }
    void aTouchedThermocoupleIsRead() {
        show();
        auto* drawing = m_bench->find<MachineDrawing>("thermalDrawing");
        QTest::mouseClick(drawing, Qt::LeftButton, {}, drawing->place(12).toPoint());
        QVERIFY(text("thermalTouched").contains(QStringLiteral("T12")));
        QVERIFY(text("thermalTouched").contains(QStringLiteral("24.2")));
        Preferences preferences;
        preferences.temperature = TemperatureUnit::Fahrenheit;
        m_bench->look.apply(preferences);
        QVERIFY2(text("thermalTouched").contains(QStringLiteral("75.6")), qPrintable(text("thermalTouched")));
    }
    void warmUpAsksFirst() {
        show();
        QVERIFY(m_bench->press("thermalWarmUp"));
        QVERIFY(last<StartPart>() == nullptr);
        auto* sheet = m_bench->sheets->current();
        QVERIFY(sheet != nullptr);
        const auto buttons = sheet->findChildren<QPushButton*>();
        QApplication::processEvents();
        QTest::mouseClick(buttons.back(), Qt::LeftButton);
        QVERIFY(last<StartPart>() != nullptr);
        QCOMPARE(last<StartPart>()->process, ProcessId::Thermal);
        m_bench->engine.fake.thermal.warmUpRunning = true;
        m_bench->client.tick();
        QVERIFY(m_bench->press("thermalWarmUp"));
        QVERIFY(last<StopWarmUp>() != nullptr);
    }
    void aStartSaysWhatStandsInItsWay() {
        show();
        test::startSaysWhyNot(*m_bench, "thermalWarmUp");
    }
    void aStartRestsUntilTheNewestIsShown() {
        show();
        test::startRests(*m_bench, "thermalWarmUp", ProcessId::Thermal, true);
    }
    void stoppingTheWarmUpRestsForNothing() {
        show();
        m_bench->services.underWay = [](ProcessId) { return true; };
        m_bench->engine.fake.thermal.warmUpRunning = true;
        m_bench->client.tick();
        QVERIFY(m_bench->press("thermalWarmUp"));
        QVERIFY(last<StopWarmUp>() != nullptr);
    }
    void aRunningProgramIsTheReasonForNoWarmUp() {
        m_bench->engine.fake.program = ProgramState::Running;
        show();
        auto* button = m_bench->find<ActionButton>("thermalWarmUp");
        QVERIFY(!button->isEnabled());
        QVERIFY(!button->reason().isEmpty());
    }

    // Models.
    void theModelCardShowsSensorsErrorsAndFormula() {
        show();
        QVERIFY(m_bench->press("thermalModel"));
        QString all;
        auto* table = m_bench->find<QTableWidget>("thermalCard");
        for (int row = 0; row < table->rowCount(); ++row)
            all += table->item(row, 1)->text() + u'\n';
        for (const char* piece : {"T44", "0.48", "x_um =", "H0.csv", "Kim"}) {
            QVERIFY2(all.contains(QLatin1String(piece)), qPrintable(all));
        }
    }
    void daysAreChosenTrainedComparedAndGoLive() {
        show();
        QVERIFY(m_bench->press("thermalModel"));
        QVERIFY(m_bench->press("thermalTrainOpen"));
        auto* train = m_bench->find<ActionButton>("thermalTrainAuto");
        QVERIFY(!train->isEnabled());
        touchDay(0);
        touchDay(1);
        touchDay(1);
        QVERIFY(m_bench->press("thermalTrainAuto"));
        QCOMPARE(m_service->trainedDays, std::vector<std::string>{"file:H0.csv"});
        m_bench->client.tick();
        QVERIFY(text("thermalTrainState").contains(QStringLiteral("40 %")));
        QVERIFY(!m_bench->find<ActionButton>("thermalGoLive")->isEnabled());
        m_service->finishTraining();
        m_bench->client.tick();
        QCOMPARE(m_bench->find<QTableWidget>("thermalCompared")->rowCount(), 3);
        QVERIFY(cell("thermalCompared", 2, 0).contains(QStringLiteral("best")));
        QVERIFY(m_bench->press("thermalGoLive"));
        QCOMPARE(m_service->calls.back(), std::string("goLive Kim"));
    }
    void aDayIsLeftOutWithAReasonAndSaysSo() {
        (void)m_bench->session.signOn(QStringLiteral("Lee"), Role::Engineer);
        show();
        QVERIFY(m_bench->press("thermalModel"));
        QVERIFY(m_bench->press("thermalTrainOpen"));
        auto* leave = m_bench->find<ActionButton>("thermalDayLeaveOut");
        QVERIFY(!leave->isEnabled());
        touchDay(1);
        QCOMPARE(leave->reason(), QStringLiteral("give a reason"));
        auto* reason = m_bench->find<QLineEdit>("thermalDayReason");
        reason->setText(QStringLiteral("door open"));
        QVERIFY(m_bench->press("thermalDayLeaveOut"));
        QCOMPARE(m_service->calls.back(), std::string("out session:1 Lee door open"));
        QVERIFY(reason->text().isEmpty());
        m_bench->client.tick();
        QVERIFY(cell("thermalDays", 1, 2).contains(QStringLiteral("Lee")));
        QVERIFY(cell("thermalDays", 1, 2).contains(QStringLiteral("door open")));
        QVERIFY(!m_bench->find<ActionButton>("thermalTrainAuto")->isEnabled());  // it was the only one chosen
        touchDay(1);  // it cannot be chosen, only taken in again
        QVERIFY(!m_bench->find<ActionButton>("thermalTrainAuto")->isEnabled());
        QCOMPARE(leave->text(), QStringLiteral("Take in again"));
        reason->setText(QStringLiteral("it was closed"));
        QVERIFY(m_bench->press("thermalDayLeaveOut"));
        QCOMPARE(m_service->calls.back(), std::string("in session:1 Lee it was closed"));
        m_bench->client.tick();
        QCOMPARE(leave->text(), QStringLiteral("Leave out"));
        touchDay(1);
        QVERIFY(m_bench->press("thermalTrainAuto"));
    }
    void trainingCanBeCancelled() {
        show();
        QVERIFY(m_bench->press("thermalModel"));
        QVERIFY(m_bench->press("thermalTrainOpen"));
        touchDay(2);
        QVERIFY(m_bench->press("thermalTrainAuto"));
        m_bench->client.tick();
        QVERIFY(m_bench->press("thermalTrainCancel"));
        m_bench->client.tick();
        QVERIFY(text("thermalTrainState").contains(QStringLiteral("nothing has changed")));
    }
    void aDayThatCannotBeReadSaysWhereAndWhy() {
        show();
        m_service->edit().training.state = TrainingState::Failed;
        m_service->edit().training.problem = Sentence(KERF_TEXT("A day cannot be used; nothing has changed."));
        m_service->edit().training.detail = "H1.csv, line 12, column T03: no value";
        m_service->announce();
        QVERIFY(m_bench->press("thermalModel"));
        QVERIFY(m_bench->press("thermalTrainOpen"));
        QVERIFY(text("thermalTrainState").contains(QStringLiteral("line 12, column T03")));
    }
    void theOldModelIsOneTouchAway() {
        show();
        QVERIFY(m_bench->press("thermalModel"));
        QVERIFY(m_bench->press("thermalRollBack"));
        QCOMPARE(m_service->calls.back(), std::string("rollBack Kim"));
        m_service->edit().canRollBack = false;
        m_service->announce();
        m_bench->client.tick();
        QVERIFY(!m_bench->press("thermalRollBack"));
        m_service->failWith = Sentence("no");
    }
    void aRefusalIsTold() {
        show();
        m_service->failWith = Sentence(KERF_TEXT("There is no model before this one."));
        QVERIFY(m_bench->press("thermalModel"));
        QVERIFY(m_bench->press("thermalRollBack"));
        QVERIFY(!m_bench->notices.empty());
    }

    // Measuring.
    void aMeasurementIsComparedWithThePrediction() {
        show();
        QVERIFY(m_bench->press("thermalMeasure"));
        QVERIFY(m_bench->press("thermalMeasureNow"));
        QVERIFY(last<MeasureOrigin>() != nullptr);
        QVERIFY(!m_bench->press("thermalAdopt"));
        GapMeasurement& gap = m_bench->engine.fake.thermal.gap;
        gap = {1, GapPhase::Done, {}, 1, {2.9, -16.8, -5.0}, {2.7, -16.2, -8.9}, {0.5, 1.1, 1.9}, true};
        m_bench->client.tick();
        QVERIFY(cell("thermalGapTable", 0, 4).contains(QStringLiteral("inside")));
        QVERIFY(cell("thermalGapTable", 2, 4).contains(QStringLiteral("outside")));
        QVERIFY(m_bench->press("thermalAdopt"));
        QVERIFY(last<AdoptMeasurement>() != nullptr);
    }
    void whatAMeasurementLeavesInAPartHasAVerdict() {
        ThermalGapRow row;
        row.left_um = {1.0, -4.1, 3.9};
        row.allowed_um = 4.0;
        QCOMPARE(row.verdict(0), quality::Verdict::NotJudged);  // the control's shift was not readable
        row.leftKnown = true;
        QCOMPARE(row.verdict(0), quality::Verdict::Good);
        QCOMPARE(row.verdict(1), quality::Verdict::Scrap);
        row.known[1] = false;
        QCOMPARE(row.verdict(1), quality::Verdict::NotJudged);
        row.known[1] = true;
        show();
        m_service->edit().gaps = {row};
        m_service->announce();
        QVERIFY(m_bench->press("thermalMeasure"));
        m_bench->engine.fake.thermal.gap = {1, GapPhase::Done, {}, 1, {2.9, -16.8, -5.0}, {}, {}, false};
        m_bench->client.tick();
        QVERIFY(cell("thermalGapTable", 0, 5).contains(QStringLiteral("good, within ±4.0")));
        QVERIFY(cell("thermalGapTable", 1, 5).contains(QStringLiteral("out of ±4.0")));
    }
    void aFinishedPartIsTakenAsAMeasurement() {
        show();
        QVERIFY(m_bench->press("thermalMeasure"));
        QVERIFY(!m_bench->find<ActionButton>("thermalByPart")->isEnabled());
        m_bench->engine.fake.thermal.partToMeasure = true;
        m_bench->client.tick();
        QVERIFY(m_bench->press("thermalByPart"));
        QVERIFY(!m_bench->find<ActionButton>("thermalPartTake")->isEnabled());  // nothing entered
        type("thermalPartX", QStringLiteral("500"));
        QVERIFY(!m_bench->find<ActionButton>("thermalPartTake")->isEnabled());
        type("thermalPartX", QStringLiteral("-12"));
        QVERIFY(m_bench->press("thermalPartTake"));
        QCOMPARE(m_service->calls.back(), std::string("part Kim"));
        QVERIFY(m_service->part[0].has_value());
        QCOMPARE(*m_service->part[0], -6.0);  // half of a diameter
        QVERIFY(!m_service->part[1].has_value());
        QVERIFY(!m_service->part[2].has_value());
    }
    void whatAPartDidNotShowIsNotShown() {
        show();
        QVERIFY(m_bench->press("thermalMeasure"));
        GapMeasurement& gap = m_bench->engine.fake.thermal.gap;
        gap = {1, GapPhase::Done, {}, 1, {2.9, 0.0, 0.0}, {2.7, -16.2, -8.9}, {0.5, 1.1, 1.9}, true};
        gap.byPart = true;
        gap.known = {true, false, false};
        m_bench->client.tick();
        QVERIFY(cell("thermalGapTable", 0, 4).contains(QStringLiteral("inside")));
        QCOMPARE(cell("thermalGapTable", 1, 1), QStringLiteral("–"));
        QCOMPARE(cell("thermalGapTable", 1, 4), QStringLiteral("–"));
    }
    void shiftingOnlyBetweenPartsIsALimit() {
        show();
        QVERIFY(m_bench->press("thermalLimits"));
        QVERIFY(m_bench->press("thermalBetweenParts"));
        m_bench->find<QLineEdit>("thermalLimitsReason")->setText(QStringLiteral("finishing passes"));
        QVERIFY(m_bench->press("thermalLimitsUse"));
        QVERIFY(m_service->setup.betweenParts);
    }
    void aSessionIsRecordedAndEnded() {
        show();
        QVERIFY(m_bench->press("thermalMeasure"));
        QVERIFY(m_bench->press("thermalSession"));
        QCOMPARE(m_service->calls.back(), std::string("begin Kim"));
        m_bench->client.tick();
        QVERIFY(m_bench->press("thermalSession"));
        QCOMPARE(m_service->calls.back(), std::string("end Kim"));
    }
    void limitsAreChangedInTheirRange() {
        show();
        QVERIFY(m_bench->press("thermalLimits"));
        auto* allowed = m_bench->find<ValueField>("thermalAllowed");
        allowed->edit()->setText(QStringLiteral("900"));
        emit allowed->edit()->textEdited(QStringLiteral("900"));
        QVERIFY(!m_bench->find<ActionButton>("thermalLimitsUse")->isEnabled());
        allowed->edit()->setText(QStringLiteral("2.5"));
        emit allowed->edit()->textEdited(QStringLiteral("2.5"));
        QVERIFY(!m_bench->find<ActionButton>("thermalLimitsUse")->isEnabled());  // not without a reason
        m_bench->find<QLineEdit>("thermalLimitsReason")->setText(QStringLiteral("drawing B"));
        QVERIFY(m_bench->press("thermalLimitsUse"));
        QCOMPARE(m_service->setup.allowed_um, 2.5);
        QCOMPARE(m_service->setup.period_min, 1.0);
    }
    void limitsThatAreNotStoredStayOnTheSheet() {
        show();
        QVERIFY(m_bench->press("thermalLimits"));
        m_bench->find<QLineEdit>("thermalLimitsReason")->setText(QStringLiteral("drawing B"));
        m_service->failWith = Sentence("The disk is full.");
        QVERIFY(m_bench->press("thermalLimitsUse"));
        QVERIFY(m_bench->find<ActionButton>("thermalLimitsUse") != nullptr);
        const auto labels = m_bench->sheets->findChildren<QLabel*>();
        QVERIFY(std::ranges::any_of(labels, [](const QLabel* label) {
            return label->isVisible() && label->text().contains(QStringLiteral("disk is full"));
        }));
        m_service->failWith = {};
        m_service->storeIsSlow = true;
        QVERIFY(m_bench->press("thermalLimitsUse"));
        QVERIFY(!m_bench->find<ActionButton>("thermalLimitsUse")->isEnabled());  // on its way: nobody sends it twice
        m_service->keepSetup();
        QTRY_VERIFY(m_bench->find<ActionButton>("thermalLimitsUse") == nullptr);
        QVERIFY(m_bench->notices.back().contains(QStringLiteral("new limits")));
    }
    void theErrorMapShowsEveryAxis() {
        show();
        QVERIFY(m_bench->press("thermalMap"));
        for (const char* name : {"thermalErrorMapX", "thermalErrorMapY", "thermalErrorMapZ"}) {
            QVERIFY(m_bench->find<QWidget>(name) != nullptr);
        }
    }
    void withoutAServiceThePageSaysSo() {
        m_bench->services.thermalService = nullptr;
        show();
        QVERIFY(m_bench->page->findChild<QLabel*>()->isVisible());
    }
    void theKeyFigureIsTheLargestDrift() {
        const KeyFigure figure = thermalFigure(m_bench->services, m_bench->engine.fake);
        QCOMPARE(*figure.value, -16.7);
        QVERIFY(figure.label.contains(u'Y'));
        QCOMPARE(figure.course.size(), std::size_t{120});
    }

    void everyTextFitsInEveryLook_data() {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<double>("scale");
        QTest::addColumn<bool>("korean");
        QTest::addColumn<QString>("sheet");
        for (const bool korean : {false, true}) {
            const char* language = korean ? "ko" : "en";
            for (const char* sheet : {"", "thermalModel", "thermalMeasure", "thermalHistory", "thermalSensors",
                                      "thermalMap", "thermalLimits", "train", "empty"}) {
                QTest::addRow("1280x800_%s_%s", language, sheet) << QSize(1083, 670) << 1.0 << korean << QString(sheet);
            }
            QTest::addRow("1920x1080_%s", language) << QSize(1700, 950) << 1.0 << korean << QString();
            QTest::addRow("3840x2160_%s", language) << QSize(3400, 1900) << 2.0 << korean << QString();
        }
    }
    void everyTextFitsInEveryLook() {
        QFETCH(QSize, size);
        QFETCH(double, scale);
        QFETCH(bool, korean);
        QFETCH(QString, sheet);
        Preferences preferences;
        preferences.scale = scale;
        preferences.language = korean ? Language::Korean : Language::English;
        preferences.brightness = korean ? Brightness::Dark : Brightness::Light;
        m_bench->look.apply(preferences);
        if (sheet == QStringLiteral("empty")) {
            m_service->edit().course.clear();
            m_bench->engine.fake.thermal = {};
        } else {
            m_bench->engine.fake.thermal.couple[5] = CoupleState::Open;
            m_bench->engine.fake.thermal.couple[30] = CoupleState::Disagrees;
            m_bench->engine.fake.thermal.gap = {
                1, GapPhase::Done, {}, 1, {2.9, -16.8, -5.0}, {2.7, -16.2, -8.9}, {0.5, 1.1, 1.9}, true};
        }
        m_bench->show<ThermalPage>(size);
        m_bench->client.tick();
        if (sheet == QStringLiteral("train")) {
            QVERIFY(m_bench->press("thermalModel"));
            QVERIFY(m_bench->press("thermalTrainOpen"));
            touchDay(0);
            m_service->finishTraining();
        } else if (sheet.startsWith(QStringLiteral("thermal"))) {
            QVERIFY(m_bench->press(sheet.toLatin1().constData()));
        }
        m_bench->client.tick();
        for (int pass = 0; pass < 3; ++pass) {  // a sheet finds its height from what its content asks for
            QApplication::processEvents();
        }
        if (const QString folder = qEnvironmentVariable("KERF_SAVE_PAGES"); !folder.isEmpty()) {
            m_bench->save(folder + QStringLiteral("/thermal_%1.png").arg(QLatin1String(QTest::currentDataTag())));
        }
        const QStringList clipped = test::clippedTexts(&m_bench->window);
        QVERIFY2(clipped.isEmpty(), qPrintable(clipped.join(u'\n')));
        const QStringList small = test::smallTargets(&m_bench->window, m_bench->look);
        QVERIFY2(small.isEmpty(), qPrintable(small.join(u'\n')));
    }

 private:
    void show() { m_bench->show<ThermalPage>(); }
    [[nodiscard]] QString text(const char* name) { return m_bench->find<QLabel>(name)->text(); }
    [[nodiscard]] QString cell(const char* table, int row, int column) {
        return m_bench->find<QTableWidget>(table)->item(row, column)->text();
    }
    template <class Action>
    [[nodiscard]] const Action* last() {
        const auto& commands = m_bench->engine.commands;
        return commands.empty() ? nullptr : std::get_if<Action>(&commands.back().action);
    }
    void type(const char* name, const QString& what) {
        auto* field = m_bench->find<ValueField>(name);
        field->edit()->setText(what);
        emit field->edit()->textEdited(what);
    }
    void touchDay(int row) { emit m_bench->find<QTableWidget>("thermalDays")->cellClicked(row, 0); }

    std::unique_ptr<FakeThermalService> m_service;
    std::unique_ptr<PageBench> m_bench;
};
QTEST_MAIN(TestThermalPage)
#include "tst_thermal_page.moc"
