// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAbstractButton>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>

#include "tests/support/layout_check.h"
#include "tests/support/page_bench.h"
#include "tests/support/shell_bench.h"
#include "tests/support/start_rests.h"
#include "ui/pages/overview/overview_page.h"
#include "ui/widgets/action_button.h"
#include "ui/widgets/number_display.h"

using namespace kerf;
using namespace kerf::ui;
using kerf::test::ShellBench;

class TestShell : public QObject {
    Q_OBJECT
 private slots:
    void nothingIsClippedAtAnySizeLanguageOrTheme_data() {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<int>("language");
        QTest::addColumn<int>("brightness");
        QTest::addColumn<double>("scale");
        QTest::addColumn<int>("unit");
        struct Screen {
            QSize size;
            double scale;
        };
        for (const Screen& screen : {Screen{{1280, 800}, 1.0}, Screen{{1920, 1080}, 1.0}, Screen{{1920, 1080}, 1.25},
                                     Screen{{3840, 2160}, 1.0}, Screen{{3840, 2160}, 2.0}}) {
            for (const Language language : {Language::English, Language::Korean}) {
                for (const Brightness brightness : {Brightness::Light, Brightness::Dark}) {
                    // Units change texts, themes do not: one with the other covers both.
                    const LengthUnit unit = brightness == Brightness::Dark ? LengthUnit::Inch : LengthUnit::Millimetre;
                    QTest::addRow("%dx%d %.2f %s %s", screen.size.width(), screen.size.height(), screen.scale,
                                  language == Language::English ? "en" : "ko",
                                  brightness == Brightness::Light ? "light" : "dark")
                        << screen.size << int(language) << int(brightness) << screen.scale << int(unit);
                }
            }
        }
    }
    void nothingIsClippedAtAnySizeLanguageOrTheme() {
        QFETCH(QSize, size);
        QFETCH(int, language);
        QFETCH(int, brightness);
        QFETCH(double, scale);
        QFETCH(int, unit);
        Preferences preferences;
        preferences.language = Language(language);
        preferences.brightness = Brightness(brightness);
        preferences.scale = scale;
        preferences.length = LengthUnit(unit);
        ShellBench bench(kerf::test::allPages(), preferences);
        bench.window->resize(size);
        bench.window->show();
        bench.window->session().signOn(QStringLiteral("Kim Minji"));
        bench.raise(test::kSensorAlarm);
        bench.raise(test::kToolAlarm);
        bench.window->client().stop();  // nothing changes between layout and check
        for (const PageEntry& entry : bench.window->pages()) {
            bench.window->showPage(entry.key);
            bench.window->client().tick();
            for (int i = 0; i < 3; ++i) {
                QCoreApplication::sendPostedEvents();
                QCoreApplication::processEvents();
            }
            QCOMPARE(bench.window->size(), size);
            const QStringList clipped = test::clippedTexts(bench.window.get());
            QVERIFY2(clipped.isEmpty(), qPrintable(QLatin1String(entry.key) + u'\n' + clipped.join(u'\n')));
            const QStringList small = test::smallTargets(bench.window.get(), bench.look);
            QVERIFY2(small.isEmpty(), qPrintable(QLatin1String(entry.key) + u'\n' + small.join(u'\n')));
        }
    }
    void aNameIsTypedByTouchAlone() {
        ShellBench bench;
        bench.window->resize(1280, 800);
        bench.window->show();
        const auto touch = [&](const char* name) {
            QCoreApplication::processEvents();
            for (QWidget* widget : bench.window->findChildren<QWidget*>(QLatin1String(name))) {
                if (widget->isVisible() && widget->isEnabled()) {
                    QTest::mouseClick(widget, Qt::LeftButton);
                    return true;
                }
            }
            return false;
        };
        QVERIFY(touch("operator"));
        QVERIFY(touch("operatorName"));
        for (const char* key : {"touchShift", "touchKey_l", "touchKey_e", "touchKey_e"}) {
            QVERIFY2(touch(key), key);
        }
        QVERIFY(touch("touchHide"));
        QVERIFY(touch("signOn"));
        QCOMPARE(bench.window->session().name(), QStringLiteral("Lee"));
        QVERIFY(bench.window->focusWidget() == nullptr ||
                qobject_cast<QAbstractButton*>(bench.window->focusWidget()) == nullptr);
    }
    void keysThatNobodyWantsGoToTheFieldThatWaits() {
        ShellBench bench;
        bench.window->resize(1280, 800);
        bench.window->show();
        bench.window->session().signOn(QStringLiteral("Kim Minji"));
        bench.window->showPage("boring");
        QCoreApplication::processEvents();
        auto* settings = bench.window->findChild<QPushButton*>(QStringLiteral("settings"));
        QVERIFY(settings != nullptr);
        settings->setFocus();
        QKeyEvent press(QEvent::KeyPress, Qt::Key_7, Qt::NoModifier, QStringLiteral("7"));
        QCoreApplication::sendEvent(settings, &press);
        auto* field = bench.window->findChild<QLineEdit*>(QStringLiteral("boringDiameterField"));
        QVERIFY(field->text().contains(u'7'));
    }
    void holdAllReachesTheEngineWithAFrozenPage() {
        ShellBench bench;
        bench.window->resize(1280, 800);
        bench.window->show();
        auto* hold = bench.window->findChild<QPushButton*>(QStringLiteral("holdAll"));
        QVERIFY(hold != nullptr);
        bench.window->client().stop();                                                    // no tick any more
        bench.window->page("overview")->setEnabled(false);                                // the page takes nothing
        bench.window->sheets().tell(QStringLiteral("Question"), QStringLiteral("open"));  // and a question lies on it
        QTest::mousePress(hold, Qt::LeftButton);
        QCOMPARE(bench.engine.holds.load(), 1);  // inside the press itself: no event loop, no tick in between
        QTest::mouseRelease(hold, Qt::LeftButton);
    }
    void aFrozenScreenLosesChartSamplesOnlyAndTheEngineGoesOn() {
        ShellBench bench;
        bench.window->client().stop();
        bench.engine.samples.assign(10'000, Sample{});
        QCOMPARE(bench.engine.samples.size(), std::size_t{10'000});  // nobody waits for the screen
        bench.window->client().tick();
        QCOMPARE(bench.engine.samples.size(), 10'000 - EngineClient::kSamplesPerTick);
    }
    void overviewCountsThePartsOfEveryProcess() {
        ShellBench bench;
        bench.window->resize(1280, 800);
        bench.window->show();
        bench.engine.fake.boring.partsCut = 3;
        bench.engine.fake.milling.partsCut = 4;
        bench.engine.fake.turning.partsCut = 5;
        bench.engine.fake.tapping.partsCut = 6;
        bench.window->showPage("overview");
        auto* counter = bench.window->findChild<NumberDisplay*>(QStringLiteral("partCounter"));
        QVERIFY(counter != nullptr);
        bench.window->client().tick();
        QTRY_COMPARE(counter->text(), QStringLiteral("18"));
    }
    void aRefusedCommandIsToldOnTheBottomLine() {
        ShellBench bench;
        bench.window->resize(1280, 800);
        bench.window->show();
        bench.engine.fake.program = ProgramState::Idle;
        bench.engine.refuseWith = Sentence("The door is open.");
        bench.window->client().tick();
        QTRY_VERIFY(bench.window->findChild<QPushButton*>(QStringLiteral("startPart"))->isEnabled());
        QTest::mouseClick(bench.window->findChild<QPushButton*>(QStringLiteral("startPart")), Qt::LeftButton);
        bench.window->client().tick();
        QVERIFY(bench.window->bottomLine().contains(QStringLiteral("The door is open.")));
    }
    void aStartSaysWhatStandsInItsWay() {
        test::PageBench bench;
        bench.engine.caps.cycleStart.fitted = true;
        bench.show<OverviewPage>();
        test::startSaysWhyNot(bench, "startPart");
    }
    void aStartRestsUntilTheNewestIsShown() {
        test::PageBench bench;
        bench.engine.caps.cycleStart.fitted = true;
        bench.show<OverviewPage>();
        test::startRests(bench, "startPart", ProcessId::Boring);
    }
    void aButtonThatIsOffSaysWhy() {
        ShellBench bench;
        bench.window->client().tick();
        auto* start = bench.window->findChild<ActionButton*>(QStringLiteral("startPart"));
        QVERIFY(!start->isEnabled());
        QVERIFY(!start->reason().isEmpty());
    }
    void theFirstUnseenAlarmStandsOnTheBottomLineUntilSeen() {
        ShellBench bench;
        bench.window->show();
        bench.raise(test::kSensorAlarm);
        QVERIFY(bench.window->bottomLine().contains(QStringLiteral("Thermocouple disagrees")));
        bench.raise(test::kToolAlarm);
        QVERIFY(bench.window->bottomLine().contains(QStringLiteral("Tool broken")));  // priority 1 goes first
        bench.window->session().signOn(QStringLiteral("Kim Minji"));
        QTest::mouseClick(bench.window->findChild<QPushButton*>(QStringLiteral("alarmShow")), Qt::LeftButton);
        auto* seen = bench.window->findChild<QPushButton*>(QStringLiteral("acknowledge"));
        QVERIFY(seen->isVisible());
        QTest::mouseClick(seen, Qt::LeftButton);
        QVERIFY(bench.window->bottomLine().contains(QStringLiteral("Thermocouple disagrees")));
        QTest::mouseClick(seen,
                          Qt::LeftButton);  // the tool alarm stands still, but has been seen: next comes the other
        bench.raise(test::kSensorAlarm, false);
        bench.raise(test::kToolAlarm, false);
    }
    void anAlarmThatIsGoneGivesWayAndSaysSo() {
        ShellBench bench;
        bench.window->show();
        bench.raise(test::kSensorAlarm);
        bench.raise(test::kToolAlarm);
        bench.raise(test::kToolAlarm, false);
        QVERIFY(bench.window->bottomLine().contains(QStringLiteral("Thermocouple disagrees")));  // it still stands
        bench.raise(test::kSensorAlarm, false);
        QVERIFY(bench.window->bottomLine().contains(QStringLiteral("Tool broken")));
        QVERIFY(bench.window->bottomLine().contains(QStringLiteral("gone since")));
    }
    void acknowledgingAsksWhoIsThere() {
        ShellBench bench;
        bench.window->resize(1280, 800);
        bench.window->show();
        bench.raise(test::kToolAlarm);
        bench.window->showPage("alarms");
        QTest::mouseClick(bench.window->findChild<QPushButton*>(QStringLiteral("acknowledge")), Qt::LeftButton);
        QVERIFY(bench.window->sheets().current() != nullptr);
        QTest::mouseClick(bench.window->findChild<QPushButton*>(QStringLiteral("operator0")), Qt::LeftButton);
        QVERIFY(bench.window->sheets().current() == nullptr);
        QCOMPARE(bench.window->session().name(), QStringLiteral("Kim Minji"));
        QCOMPARE(bench.window->bottomLine(), QStringLiteral("No alarms."));
    }
    void everythingSwitchesLive() {
        ShellBench bench;
        bench.window->resize(1280, 800);
        bench.window->show();
        bench.window->client().tick();
        QTest::mouseClick(bench.window->findChild<QPushButton*>(QStringLiteral("settings")), Qt::LeftButton);
        QTest::mouseClick(bench.window->findChild<QPushButton*>(QStringLiteral("unitInch")), Qt::LeftButton);
        QCOMPARE(bench.look.units().length(), LengthUnit::Inch);
        QTest::mouseClick(bench.window->findChild<QPushButton*>(QStringLiteral("themeDark")), Qt::LeftButton);
        QTest::mouseClick(bench.window->findChild<QPushButton*>(QStringLiteral("languageKorean")), Qt::LeftButton);
        QCOMPARE(bench.look.preferences().language, Language::Korean);
        QTest::mouseClick(bench.window->findChild<QPushButton*>(QStringLiteral("language")), Qt::LeftButton);
        QCOMPARE(bench.look.preferences().language, Language::English);
    }
    void theLanguageWaitsForASheetThatKeepsItsWords() {
        ShellBench bench;
        bench.window->resize(1280, 800);
        bench.window->show();
        bench.window->client().tick();
        const auto touch = [&](const char* name) {
            QTest::mouseClick(bench.window->findChild<QPushButton*>(QLatin1String(name)), Qt::LeftButton);
        };
        bench.window->sheets().tell(QStringLiteral("A title"), QStringLiteral("A sentence."));
        touch("language");
        QCOMPARE(bench.look.preferences().language, Language::English);
        QVERIFY2(bench.window->bottomLine().startsWith(QStringLiteral("Close what is open first")),
                 qPrintable(bench.window->bottomLine()));
        bench.window->sheets().current()->close();
        // Who is at the machine is asked in the language that is read here, with what was typed already.
        touch("operator");
        const QString english = bench.window->sheets().current()->findChild<QPushButton*>("signOn")->text();
        bench.window->sheets().current()->findChild<QLineEdit*>("operatorName")->setText(QStringLiteral("Choi"));
        touch("language");
        QCOMPARE(bench.look.preferences().language, Language::Korean);
        QVERIFY(bench.window->sheets().current() != nullptr);
        QVERIFY(bench.window->sheets().current()->findChild<QPushButton*>("signOn")->text() != english);
        QCOMPARE(bench.window->sheets().current()->findChild<QLineEdit*>("operatorName")->text(),
                 QStringLiteral("Choi"));
        bench.window->sheets().current()->close();
        touch("language");
        QCOMPARE(bench.look.preferences().language, Language::English);
    }
    void whatIsHeldIsSaidOnEveryPageWithTheWayOut() {
        ShellBench bench;
        bench.window->resize(1280, 800);
        bench.window->show();
        bench.window->session().signOn(QStringLiteral("Kim Minji"));
        bench.window->client().tick();
        auto* band = bench.window->findChild<QWidget*>(QStringLiteral("heldBand"));
        const auto text = [&](const char* name) {
            return bench.window->findChild<QLabel*>(QLatin1String(name))->text();
        };
        auto* release = bench.window->findChild<QPushButton*>(QStringLiteral("heldRelease"));
        QVERIFY(!band->isVisible());
        QTest::mousePress(bench.window->findChild<QPushButton*>(QStringLiteral("holdAll")), Qt::LeftButton);
        bench.engine.fake.held = true;
        bench.window->client().tick();
        for (const auto& page : bench.window->pages()) {
            bench.window->showPage(page.key);
            QVERIFY(band->isVisible() && band->width() == bench.window->width());
        }
        QVERIFY(bench.window->grab().save(QStringLiteral("held.png")));
        QVERIFY(text("heldWhat").contains(QStringLiteral("HELD")));
        QVERIFY2(text("heldWhy").contains(QStringLiteral("Kim Minji")), qPrintable(text("heldWhy")));
        QVERIFY(text("heldWhy").contains(QStringLiteral("since")));
        QTest::mouseClick(release, Qt::LeftButton);
        QVERIFY(std::holds_alternative<ReleaseHold>(bench.engine.commands.back().action));
        // The stop of a loop, behind the hold.
        StopStatus& stop = bench.engine.fake.stops[static_cast<std::size_t>(ProcessId::Milling)];
        stop.slot.number = 7;
        stop.slot.kind = StopKind::FeedHold;
        stop.slot.cause = test::kToolAlarm.code;
        bench.engine.fake.held = false;
        bench.window->client().tick();
        QVERIFY(band->isVisible());
        QVERIFY2(text("heldWhy").contains(QStringLiteral("Tool broken")), qPrintable(text("heldWhy")));
        QTest::mouseClick(release, Qt::LeftButton);
        const auto* sent = std::get_if<ReleaseStop>(&bench.engine.commands.back().action);
        QVERIFY(sent != nullptr && sent->number == 7 && sent->process == ProcessId::Milling);
        stop.slot.released = 7;
        bench.window->client().tick();
        QVERIFY(!band->isVisible());
    }
    void closingAsksWhileAPartIsCut() {
        ShellBench bench;
        bench.window->show();
        bench.window->client().tick();
        bench.window->close();
        QVERIFY(bench.window->isVisible());
        QVERIFY(bench.window->sheets().current() != nullptr);
        bench.window->sheets().current()->close();
        bench.engine.fake.program = ProgramState::Finished;
        bench.window->client().tick();
        bench.window->close();
        QVERIFY(!bench.window->isVisible());
    }
    void everyPageIsRendered() {
        ShellBench bench;
        bench.window->resize(1280, 800);
        bench.window->show();
        const QStringList files = bench.window->renderPages(QStringLiteral("pages"));
        QCOMPARE(files.size(), static_cast<qsizetype>(bench.window->pages().size()));
        for (const QString& file : files) {
            QCOMPARE(QImage(file).size(), QSize(1280, 800));
        }
    }
};

QTEST_MAIN(TestShell)
#include "tst_shell.moc"
