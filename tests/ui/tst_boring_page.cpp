// SPDX-License-Identifier: GPL-3.0-or-later
#include <QLabel>
#include <QLineEdit>
#include <QTableWidget>
#include <QTest>
#include <QTimer>

#include "tests/support/boring_page_bench.h"
#include "tests/support/layout_check.h"
#include "tests/support/page_look.h"
#include "ui/pages/boring/boring_page.h"

using namespace kerf;
using namespace kerf::ui;
using kerf::test::FakeBoringService;
using kerf::test::PageBench;

/// A lot on the fake service, its page, and the touches of an operator.
class TestBoringPage : public QObject, test::BoringPageBench {
    Q_OBJECT
 private slots:
    void init() { open(); }
    void cleanup() { close(); }

    // Entry.
    void aDiameterIsEnteredInThreeTouches() {
        m_service->cutPart();
        show();
        QCOMPARE(text("boringEntryPrompt"), QStringLiteral("⌀ of part 1, top"));
        QCOMPARE(touches("key1", "key2", "keyEnter"), 3);
        QCOMPARE(m_service->entries.size(), std::size_t{1});
        QCOMPARE(m_service->entries[0].diameter_mm, 50.012);
        QCOMPARE(m_service->entries[0].author, std::string("Kim"));
        QCOMPARE(text("boringEntryPrompt"), QStringLiteral("⌀ of part 1, bottom"));  // the next one is preselected
        QCOMPARE(touches("key9", "key9", "keyEnter"), 3);
        QCOMPARE(m_service->entries[1].diameter_mm, 49.999);
        QCOMPARE(m_service->entries[1].depth, std::uint8_t{1});
        QVERIFY(!field()->isEnabled());
        QVERIFY(!text("boringEntryMessage").isEmpty());
    }
    void aWholeDiameterMayBeTypedOnTheKeyboard() {
        m_service->cutPart();
        show();
        QTest::keyClicks(field(), QStringLiteral("50,013"));
        QTest::keyClick(field(), Qt::Key_Return);
        QTRY_COMPARE(m_service->entries.size(), std::size_t{1});
        QCOMPARE(m_service->entries[0].diameter_mm, 50.013);
    }
    void aTextPutInByOtherMeansCounts() {
        m_service->cutPart();
        show();
        field()->setText(QStringLiteral("50.014"));
        QVERIFY(m_bench->press("keyEnter"));
        QCOMPARE(m_service->entries.at(0).diameter_mm, 50.014);
    }
    void theGaugeButtonFillsTheField() {
        m_service->cutPart();
        m_service->gaugeFitted = true;
        show();
        QCOMPARE(touches("boringGauge", "keyEnter"), 2);
        QCOMPARE(m_service->entries.at(0).diameter_mm, m_service->trueDiameter_mm(101, 0) + 0.00037);
        QVERIFY(m_service->entries.at(0).fromGauge);
    }
    void aDecadeTypoIsAskedAboutAndMeasuredAgain() {
        m_service->runParts(3);
        m_service->cutPart();
        show();
        const std::size_t before = m_service->entries.size();
        type("5.0011");
        QCOMPARE(m_service->entries.size(), before);
        QVERIFY(visible("boringMeasureAgain"));
        QVERIFY(visible("boringConfirm"));
        QVERIFY(text("boringEntryMessage").contains(QStringLiteral("5.001")));
        QVERIFY(m_bench->press("keyEnter"));  // Enter is no answer
        QCOMPARE(m_service->entries.size(), before);
        QVERIFY(visible("boringConfirm"));
        QVERIFY(m_bench->press("boringMeasureAgain"));
        QVERIFY(!visible("boringConfirm"));
        QCOMPARE(touches("key1", "key1", "keyEnter"), 3);
        QCOMPARE(m_service->entries.size(), before + 1);
        QVERIFY(!m_service->entries.back().confirmed);
    }
    void typingOnIsMeasuringAgain() {
        m_service->runParts(3);
        m_service->cutPart();
        show();
        type("5.0011");
        QCOMPARE(touches("key1", "key1", "keyEnter"), 3);
        QCOMPARE(m_service->entries.back().diameter_mm, 50.011);
        QVERIFY(!visible("boringConfirm"));
    }
    void anImplausibleValueMayBeConfirmed() {
        m_service->runParts(3);
        m_service->cutPart();
        show();
        type("49.700");
        QVERIFY(m_bench->press("boringConfirm"));
        QCOMPARE(m_service->entries.back().diameter_mm, 49.7);
        QVERIFY(m_service->entries.back().confirmed);
    }
    void aRefusedEntryKeepsItsTextAndSaysWhatWhereAndRange() {
        m_service->cutPart();
        show();
        type("500.11");
        QVERIFY(m_service->entries.empty());
        QCOMPARE(field()->text(), QStringLiteral("500.11"));
        for (const char* piece : {"500.110", "part 1, top", "50.127"}) {
            QVERIFY2(text("boringEntryMessage").contains(QLatin1String(piece)), qPrintable(text("boringEntryMessage")));
        }
        QVERIFY(field()->property("wrong").toBool());
    }
    void whatIsNoNumberIsRefusedAtTheField_data() {
        QTest::addColumn<QString>("typed");
        for (const char* typed : {"", "5", "abc", "5.0.1", "-", "nan", "inf"}) {
            QTest::newRow(typed) << QString::fromLatin1(typed);
        }
    }
    void whatIsNoNumberIsRefusedAtTheField() {
        QFETCH(QString, typed);
        m_service->cutPart();
        show();
        type(typed.toLatin1().constData());
        QVERIFY(m_service->entries.empty());
        QVERIFY(m_service->checked.empty());
        QCOMPARE(entry()->field()->input().typed(), typed);
        QVERIFY(text("boringEntryMessage").contains(QStringLiteral("part 1, top")));
    }
    void withoutANameNothingIsEntered() {
        m_service->cutPart();
        show();
        m_bench->session.signOff();
        type("50.011");
        QCOMPARE(m_bench->askedForName, 1);
        QVERIFY(m_service->entries.empty());
        QCOMPARE(field()->text(), QStringLiteral("50.011"));
    }
    void anEntryStaysWithThePartItWasBegunFor() {
        m_service->runParts(2);
        m_service->cutPart();
        show();
        QVERIFY(m_bench->press("key1"));
        m_service->voidMeasurement(1, "Lee", "gauge", {});  // now part 1 waits and is older
        QVERIFY(m_bench->press("key2"));
        QVERIFY(m_bench->press("keyEnter"));
        QCOMPARE(m_service->entries.back().part, PartId{103});
        QCOMPARE(text("boringEntryPrompt"), QStringLiteral("⌀ of part 1, top"));
    }

    // Store.
    void aFailingStoreKeepsTheValueAndSaysSo() {
        m_service->cutPart();
        show();
        m_service->setStoreProblem(Sentence("The disk is full."));
        QVERIFY(text("boringNote").contains(QStringLiteral("The disk is full.")));
        type("50.011");
        QVERIFY(m_service->entries.empty());
        QCOMPARE(field()->text(), QStringLiteral("50.011"));
        QVERIFY(text("boringEntryMessage").contains(QStringLiteral("The disk is full.")));
        m_service->setStoreProblem({});
        QVERIFY(m_bench->press("keyEnter"));
        QCOMPARE(m_service->entries.at(0).diameter_mm, 50.011);
        QVERIFY(!visible("boringNote"));
    }
    void aSlowStoreNeitherBlocksThePageNorStoresTwice() {
        m_service->cutPart();
        m_service->keepAnswers = true;
        show();
        type("50.011");
        QVERIFY(m_bench->press("keyEnter"));
        QVERIFY(m_bench->press("keyEnter"));
        int beats = 0;
        QTimer beat;
        connect(&beat, &QTimer::timeout, this, [&beats] { ++beats; });
        beat.start(1);
        QTRY_VERIFY(beats > 3);
        QVERIFY(m_service->entries.empty());
        m_service->answerAll();
        QCOMPARE(m_service->entries.size(), std::size_t{1});
        QCOMPARE(text("boringEntryPrompt"), QStringLiteral("⌀ of part 1, bottom"));
    }
    void anAnswerMayComeAfterThePageHasGone() {
        m_service->cutPart();
        m_service->keepAnswers = true;
        show();
        type("50.011");
        m_bench.reset();
        m_service->answerAll();
        QCOMPARE(m_service->entries.size(), std::size_t{1});
    }

    // Undo and correct.
    void undoTakesTheLastOneOutWithAReason() {
        m_service->cutPart();
        show();
        type("50.011");
        QVERIFY(m_bench->press("boringUndo"));
        QVERIFY(!m_bench->press("measurementApply"));  // no reason yet: off, and it says so
        QVERIFY(!m_bench->find<ActionButton>("measurementApply")->reason().isEmpty());
        QVERIFY(m_bench->press("measurementReason0"));
        QVERIFY(m_bench->press("measurementApply"));
        QCOMPARE(m_service->calls.back().what, std::string("void"));
        QCOMPARE(m_service->calls.back().id, std::int64_t{1});
        QCOMPARE(m_service->calls.back().author, std::string("Kim"));
        QVERIFY(!m_service->calls.back().reason.empty());
        QCOMPARE(text("boringEntryPrompt"), QStringLiteral("⌀ of part 1, top"));
        QVERIFY(!m_bench->notices.empty());
    }
    void aValueIsCorrectedFromTheList() {
        m_service->runParts(3);
        show();
        QVERIFY(m_bench->press("boringCorrect"));
        auto* list = m_bench->find<QTableWidget>("boringMeasurementList");
        QVERIFY(list != nullptr);
        QCOMPARE(list->rowCount(), 3);
        emit list->cellClicked(2, 1);  // part 1, top
        auto* value = m_bench->find<QLineEdit>("measurementField");
        QVERIFY(value != nullptr);
        value->setFocus();
        for (const char* key : {"key2", "key1"}) {
            auto* button = m_bench->find<QWidget>("measurementKeypad")->findChild<QPushButton*>(QLatin1String(key));
            QTest::mouseClick(button, Qt::LeftButton);
        }
        m_bench->find<QLineEdit>("measurementReason")->setText(QStringLiteral("read the wrong line"));
        QVERIFY(m_bench->press("measurementApply"));
        QCOMPARE(m_service->calls.back().what, std::string("correct"));
        QCOMPARE(m_service->calls.back().id, std::int64_t{1});
        QCOMPARE(m_service->calls.back().value_mm, 50.021);
        QCOMPARE(m_service->calls.back().reason, std::string("read the wrong line"));
        QVERIFY(m_service->view().parts[0].measurements[0].corrected);
    }
    void aCorrectionThatCannotBeStoredStaysOpenWithTheReason() {
        m_service->runParts(1);
        show();
        m_service->failWith = Sentence("The disk is full.");
        QVERIFY(m_bench->press("boringUndo"));
        QVERIFY(m_bench->press("measurementReason1"));
        QVERIFY(m_bench->press("measurementApply"));
        QVERIFY(text("measurementMessage").contains(QStringLiteral("The disk is full.")));
        QVERIFY(m_bench->sheets->current() != nullptr);
    }
    void anotherPartMayBeMeasuredFirst() {
        m_service->cutPart();
        m_service->cutPart();
        show();
        QVERIFY(m_bench->press("boringCorrect"));
        emit m_bench->find<QTableWidget>("boringMeasurementList")->cellClicked(0, 2);  // newest part, bottom
        QCOMPARE(text("boringEntryPrompt"), QStringLiteral("⌀ of part 2, bottom"));
        type("50.011");
        QCOMPARE(m_service->entries.at(0).part, PartId{102});
        QCOMPARE(text("boringEntryPrompt"), QStringLiteral("⌀ of part 1, top"));
    }

    // Gauge, whatever has the focus.
    void aGaugeEntersFromAnyFocus() {
        m_service->cutPart();
        show();
        QLineEdit elsewhere;
        elsewhere.show();
        burst(&elsewhere, "50.011");
        QCOMPARE(m_service->entries.size(), std::size_t{1});
        QVERIFY(m_service->entries[0].fromGauge);
        QVERIFY(elsewhere.text().isEmpty());
        burst(&elsewhere, "50.012mm");
        QCOMPARE(m_service->entries.size(), std::size_t{2});
        QCOMPARE(m_service->entries[1].depth, std::uint8_t{1});
    }
    void aGaugeEntersWhileAnotherPageIsShown() {
        m_service->cutPart();
        show();
        m_bench->page->hide();
        QLineEdit elsewhere;
        elsewhere.show();
        burst(&elsewhere, "50.011");
        QCOMPARE(m_service->entries.size(), std::size_t{1});
        QVERIFY(!m_bench->notices.empty());
        burst(&elsewhere, "5.0011");  // a question: the page must come up
        QCOMPARE(m_service->entries.size(), std::size_t{1});
        QCOMPARE(m_bench->shownPages.back(), std::string("boring"));
    }
    void aGaugeInTheOtherUnitIsAskedAbout() {
        m_service->cutPart();
        show();
        burst(field(), "1.9689");
        QVERIFY(m_service->entries.empty());
        QVERIFY(visible("boringConfirm"));
        QVERIFY(text("boringEntryMessage").contains(QStringLiteral("inch")));
        QVERIFY(m_bench->press("boringConfirm"));
        QVERIFY(std::abs(m_service->entries.at(0).diameter_mm - 1.9689 * 25.4) < 1e-9);
    }
    void aReadingSentTwiceIsTakenOnce() {
        m_service->cutPart();
        show();
        burst(field(), "50.011");
        burst(field(), "50.011");
        QCOMPARE(m_service->entries.size(), std::size_t{1});
        QVERIFY(text("boringEntryMessage").contains(QStringLiteral("50.011")));
    }
    void aReadingThatNobodyWaitsForIsTold() {
        show();
        burst(m_bench->page, "50.011");
        QVERIFY(m_service->entries.empty());
        QVERIFY(text("boringEntryMessage").contains(QStringLiteral("50.011")));
    }
    void aGaugeReadingThatCouldNotBeStoredWaitsInTheField() {
        m_service->cutPart();
        show();
        m_service->failWith = Sentence("The disk is full.");
        burst(m_bench->page, "50.011");
        QCOMPARE(field()->text(), QStringLiteral("50.011"));
        m_service->failWith = {};
        QVERIFY(m_bench->press("keyEnter"));
        QCOMPARE(m_service->entries.at(0).diameter_mm, 50.011);
    }

    // Units and language.
    void switchingUnitsInTheMiddleOfAnEntryKeepsTheData() {
        m_service->runParts(2);
        m_service->cutPart();
        show();
        QVERIFY(m_bench->press("key1"));
        const double before = m_service->view().parts[0].measurements[0].diameter_mm;
        Preferences preferences;
        preferences.length = LengthUnit::Inch;
        preferences.brightness = Brightness::Dark;
        m_bench->look.apply(preferences);
        QCOMPARE(text("boringEntryUnit"), QStringLiteral("mm"));  // this entry was begun in mm
        QVERIFY(text("boringNextFeed").contains(QStringLiteral("in/rev")));
        QVERIFY(m_bench->press("key2"));
        QVERIFY(m_bench->press("keyEnter"));
        QCOMPARE(m_service->entries.back().diameter_mm, 50.012);
        QCOMPARE(text("boringEntryUnit"), QStringLiteral("in"));
        type("1.9690");
        QVERIFY(std::abs(m_service->entries.back().diameter_mm - 1.9690 * 25.4) < 1e-9);
        QCOMPARE(m_service->view().parts[0].measurements[0].diameter_mm, before);
    }
    void switchingTheLanguageKeepsEntryAndQuestion() {
        m_service->runParts(2);
        m_service->cutPart();
        show();
        type("5.0011");
        Preferences preferences;
        preferences.language = Language::Korean;
        m_bench->look.apply(preferences);
        QVERIFY(visible("boringConfirm"));
        QCOMPARE(field()->text(), QStringLiteral("5.0011"));
        QVERIFY(m_bench->press("boringConfirm"));
    }

    // Next part.
    void theNextPartIsShownBeforeItIsCut() {
        m_service->runParts(2);
        show();
        auto* top = m_bench->find<NumberDisplay>("boringNextDiameter0");
        QVERIFY(top != nullptr);
        QCOMPARE(top->text(), QStringLiteral("50.010"));
        QVERIFY(text("boringNextFeed").contains(QStringLiteral("→")));
        QVERIFY(!text("boringNextReason").isEmpty());
        QVERIFY(!visible("boringNextLimited"));
        m_service->edit().nextLimited = true;
        m_service->announce();
        QVERIFY(visible("boringNextLimited"));
    }
    void acceptIsOffWithItsReasonUntilThereIsSomethingToAccept() {
        m_service->runParts(2);
        show();
        auto* accept = m_bench->find<ActionButton>("boringAccept");
        QVERIFY(!accept->isEnabled());
        QVERIFY(!accept->reason().isEmpty());
        m_service->adviseMode = true;
        m_service->runParts(1);
        QVERIFY(m_bench->press("boringAccept"));
        QCOMPARE(m_service->calls.back().what, std::string("accept"));
        QVERIFY(!accept->isEnabled());
        m_service->runParts(1);
        m_bench->engine.loop(ProcessId::Boring).mode = LoopMode::Control;
        m_bench->client.tick();
        QVERIFY(!accept->isEnabled());
        QVERIFY(accept->reason().contains(QStringLiteral("control")));
    }
    void aChangeIsAnnouncedWithTwoTouchesAndTakenBack() {
        m_service->runParts(2);
        show();
        QVERIFY(m_bench->press("boringChange"));
        QVERIFY(m_bench->press("boringChangeInsert"));
        QCOMPARE(m_service->calls.back().what, std::string("announce"));
        QVERIFY(m_service->view().announced == BoringChange::Insert);
        QVERIFY(m_bench->find<QPushButton>("boringChange")->text().contains(QStringLiteral("New insert")));
        QVERIFY(m_bench->press("boringChange"));
        QVERIFY(m_bench->press("boringChangeNone"));
        QVERIFY(!m_service->view().announced);
    }
    void whatTheExpectedDiametersRestOnIsSaid() {
        m_service->runParts(1);
        show();
        QVERIFY(!visible("boringNextRests"));
        m_service->restOn(
            kerf::Sentence(KERF_TEXT("Expected from the %1 measured parts of this lot."), kerf::SentenceArg(1.0, 0)));
        QVERIFY(visible("boringNextRests"));
    }
    void theSwitchAsksTheEngineAndShowsWhatItSays() {
        show();
        QVERIFY(m_bench->press("boringModeControl"));
        const auto* mode = std::get_if<SetLoopMode>(&m_bench->engine.commands.back().action);
        QVERIFY(mode != nullptr);
        QCOMPARE(mode->mode, LoopMode::Control);
        QVERIFY(m_bench->find<QPushButton>("boringModeAdvise")->isChecked());
        m_bench->engine.loop(ProcessId::Boring).mode = LoopMode::Control;
        m_bench->client.tick();
        QVERIFY(m_bench->find<QPushButton>("boringModeControl")->isChecked());
    }
    void aLoopThatIsNotFittedSaysWhy() {
        m_bench->engine.loop(ProcessId::Boring).fitted = false;
        m_bench->engine.loop(ProcessId::Boring).reason = Sentence("no boring spindle");
        show();
        QVERIFY(!m_bench->press("boringModeControl"));
        QVERIFY(text("boringLoopReason").contains(QStringLiteral("no boring spindle")));
    }

    // Charts.
    void aTouchOnAChangedPartSaysWhy() {
        m_service->runParts(14);
        show();
        auto* chart = m_bench->find<BoreChart>("boringBoreChart");
        emit chart->partTouched(11);
        QVERIFY(text("boringNote").contains(QStringLiteral("the process has changed")));
        emit chart->partTouched(0);
        QVERIFY(!visible("boringNote"));
    }
    void theLivePointMovesWhileCutting() {
        m_service->runParts(1);
        show();
        auto* chart = m_bench->find<Chart>("boringFeedChart");
        BoringStatus& boring = m_bench->engine.fake.boring;
        boring.cutting = true;
        boring.activeSchedule = m_service->view().nextSchedule.revision;
        boring.overhang_mm = {120.0, 1, Quality::Good};
        boring.feed_mmPerRev = {0.15, 1, Quality::Good};
        QTRY_VERIFY((m_bench->client.tick(), chart->drawn(3).size() == 1));
        QCOMPARE(chart->drawn(3).front(), QPointF(120.0, 0.15));
        boring.overhang_mm.value = 200.0;
        QTRY_VERIFY((m_bench->client.tick(), chart->drawn(3).front().x() == 200.0));
        boring.cutting = false;
        QTRY_VERIFY((m_bench->client.tick(), chart->drawn(3).isEmpty()));
    }
    void atMostTwentyFivePartsAreDrawn() {
        m_service->runParts(30);
        show();
        QCOMPARE(m_bench->find<Chart>("boringBoreChart")->drawn(0).size(), 25);
    }
    void withoutALotThePageSaysSo() {
        m_bench->services.boringService = nullptr;
        show();
        QVERIFY(m_bench->page->findChild<QLabel*>()->isVisible());
    }

    void everyTextFitsInEveryLook_data() { test::addPageLooks(kSmall, kMiddle); }
    void everyTextFitsInEveryLook() {
        QFETCH(test::PageLook, look);
        m_bench->look.apply(look.preferences());
        if (look.full) {
            m_service->runParts(25);
            m_service->cutPart();
            cutHalf();
        }
        m_bench->show<BoringPage>(look.size);
        const QString name = QStringLiteral("boring_%1").arg(QLatin1String(QTest::currentDataTag()));
        if (!look.full) {
            check(m_bench->page, name);
            return;
        }
        settle();
        check(m_bench->page, name);
        emit m_bench->find<BoreChart>("boringBoreChart")->partTouched(11);
        m_service->edit().nextLimited = true;
        m_service->adviseMode = true;
        m_service->announce();
        type(look.inch ? "0.1969" : "5.0011");  // the question
        check(m_bench->page, name + QStringLiteral("_question"));
        type("-");  // a refusal
        check(m_bench->page, name + QStringLiteral("_refusal"));
        QVERIFY(m_bench->press("boringUndo"));
        check(m_bench->sheets->current(), name + QStringLiteral("_undo"));
        m_bench->sheets->current()->close();
        QVERIFY(m_bench->press("boringCorrect"));
        check(m_bench->sheets->current(), name + QStringLiteral("_list"));
    }

 private:
    static constexpr QSize kSmall{1083, 670};   ///< the page area of 1280×800
    static constexpr QSize kMiddle{1723, 950};  ///< of 1920×1080

    /// Numbers settle at 5 Hz.
    void settle() {
        auto* number = m_bench->find<NumberDisplay>("boringNextDiameter0");
        QTRY_VERIFY(
            (m_bench->client.tick(), !number->isVisible() || number->accessibleName().endsWith(number->text())));
    }
    void check(QWidget* shown, const QString& name) {
        m_bench->save(name + QStringLiteral(".png"));
        const QStringList problems = test::clippedTexts(shown) + test::smallTargets(shown, m_bench->look);
        if (!problems.isEmpty()) {
            QTest::qFail(qPrintable(name + u'\n' + problems.join(u'\n')), __FILE__, __LINE__);
        }
    }
    template <class... Names>
    int touches(Names... names) {
        int done = 0;
        ((done += m_bench->press(names) ? 1 : 0), ...);
        return done;
    }
    /// Typed as the program types, so that no gauge is seen in it, and entered.
    void type(const char* text) {
        for (const char c : std::string(text)) {
            QKeyEvent press(QEvent::KeyPress, c, Qt::NoModifier, QString(QLatin1Char(c)));
            QCoreApplication::sendEvent(field(), &press);
        }
        static_cast<void>(m_bench->press("keyEnter"));
    }
    static void burst(QWidget* target, const char* text) {
        for (const char c : std::string(text)) {
            QTest::keyClick(target, c);
        }
        QTest::keyClick(target, Qt::Key_Return);
    }
    void cutHalf() {
        BoringStatus& boring = m_bench->engine.fake.boring;
        const BoringSchedule& schedule = m_service->view().nextSchedule;
        boring.cutting = true;
        boring.activeSchedule = schedule.revision;
        boring.overhang_mm = {150.0, 1, Quality::Good};
        boring.feed_mmPerRev = {schedule.feed_mmPerRev(150.0), 1, Quality::Good};
        for (float overhang_mm = 40.0F; overhang_mm < 150.0F; overhang_mm += 1.0F) {
            Sample sample;
            sample.cutting = true;
            sample.overhang_mm = overhang_mm;
            sample.feed_mmPerRev = static_cast<float>(schedule.feed_mmPerRev(static_cast<double>(overhang_mm)));
            m_bench->engine.samples.push_back(sample);
        }
    }
};

QTEST_MAIN(TestBoringPage)
#include "tst_boring_page.moc"
