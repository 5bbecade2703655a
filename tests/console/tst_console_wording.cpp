// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/console_bench.h"
#include "ui/link/vocabulary.h"

using namespace kerf;

/// One set of figures, two ways to name them: in shop words, or as engineers write them. Kept for each role.
class TestConsoleWording : public QObject {
    Q_OBJECT

    static void start(test::ConsoleBench& bench, const char* machine) {
        console::Options options;
        options.machine = machine;
        options.preparedParts = 0;
        bench.start(options);
        QTRY_VERIFY2_WITH_TIMEOUT(bench.up(), qPrintable(bench.failure()), 30'000);
        bench.pause();
    }
    static void settle() {
        for (int i = 0; i < 3; ++i) {
            QCoreApplication::sendPostedEvents();
            QCoreApplication::processEvents();
        }
    }
    /// All that stands on a page.
    static QStringList wordsOn(test::ConsoleBench& bench, const char* page) {
        bench.console().window()->showPage(page);
        settle();
        QStringList words;
        for (const QWidget* widget : bench.console().window()->page(page)->findChildren<QWidget*>()) {
            const auto* label = qobject_cast<const QLabel*>(widget);
            words << (label != nullptr ? label->text() : widget->accessibleName());
        }
        return words;
    }
    static int named(const QStringList& words, ui::Wording wording) {
        int found = 0;
        for (int i = 0; i < static_cast<int>(ui::Term::Count); ++i) {
            const QString name = ui::termText(static_cast<ui::Term>(i), wording).section(QStringLiteral("%1"), 0, 0);
            found += name.size() > 1 && !words.filter(name).isEmpty() ? 1 : 0;
        }
        return found;
    }
    static void pagesSpeakBoth(test::ConsoleBench& bench, const QList<const char*>& pages) {
        ui::OperatorSession& session = bench.console().window()->session();
        for (const char* page : pages) {
            QVERIFY(session.signOn(QStringLiteral("Kim"), ui::Role::Operator));
            const QStringList shop = wordsOn(bench, page);
            QVERIFY(session.signOn(QStringLiteral("Lee"), ui::Role::Engineer));
            const QStringList symbols = wordsOn(bench, page);
            QVERIFY2(named(shop, ui::Wording::Shop) > 0, page);
            QVERIFY2(named(symbols, ui::Wording::Symbols) > 0, page);
            QVERIFY2(named(shop, ui::Wording::Symbols) == 0,
                     qPrintable(QLatin1String(page) + u'\n' + shop.join(u'\n')));
        }
    }

 private slots:
    void everyFigureHasTwoNames() {
        test::ConsoleBench bench;
        start(bench, "simulator");
        for (const ui::Language language : {ui::Language::English, ui::Language::Korean}) {
            ui::Preferences preferences = bench.console().look().preferences();
            preferences.language = language;
            bench.console().look().apply(preferences);
            for (int i = 0; i < static_cast<int>(ui::Term::Count); ++i) {
                const QString shop = ui::termText(static_cast<ui::Term>(i), ui::Wording::Shop);
                const QString symbols = ui::termText(static_cast<ui::Term>(i), ui::Wording::Symbols);
                QVERIFY2(!shop.isEmpty() && !symbols.isEmpty() && shop != symbols, qPrintable(shop));
                QCOMPARE(shop.count(QStringLiteral("%1")), symbols.count(QStringLiteral("%1")));
            }
        }
    }
    void thePagesOfTheMachiningCentreSpeakBoth() {
        test::ConsoleBench bench;
        start(bench, "simulator");
        pagesSpeakBoth(bench, {"boring", "milling", "thermal", "tapping"});
    }
    void thePageOfTheLatheSpeaksBoth() {
        test::ConsoleBench bench;
        start(bench, "diamond-lathe");
        pagesSpeakBoth(bench, {"turning"});
    }
    void eachRoleHasItsOwnAndKeepsIt() {
        test::ConsoleBench bench;
        start(bench, "simulator");
        const auto wording = [&] { return bench.console().look().wording(); };
        QCOMPARE(wording(), ui::Wording::Shop);  // nobody is signed on
        ui::OperatorSession* session = &bench.console().window()->session();
        QVERIFY(session->signOn(QStringLiteral("Kim"), ui::Role::Operator));
        QCOMPARE(wording(), ui::Wording::Shop);
        QVERIFY(session->signOn(QStringLiteral("Lee"), ui::Role::Engineer));
        QCOMPARE(wording(), ui::Wording::Symbols);
        QVERIFY(bench.press("settings"));
        QTRY_VERIFY(bench.find<QAbstractButton>("wordingSymbols") != nullptr);
        QVERIFY(bench.find<QAbstractButton>("wordingSymbols")->isChecked());
        QVERIFY(bench.press("wordingShop"));
        QCOMPARE(wording(), ui::Wording::Shop);
        QVERIFY(bench.press("sheetSafe"));
        QVERIFY(session->signOn(QStringLiteral("Kim")));
        QVERIFY(bench.press("settings"));
        QVERIFY(bench.press("wordingSymbols"));
        QCOMPARE(wording(), ui::Wording::Symbols);
        session->signOff();
        QCOMPARE(wording(), ui::Wording::Symbols);  // as an operator's
        bench.stop();
        start(bench, "simulator");
        session = &bench.console().window()->session();
        QVERIFY(session->signOn(QStringLiteral("Lee")));
        QCOMPARE(wording(), ui::Wording::Shop);
        QVERIFY(session->signOn(QStringLiteral("Kim")));
        QCOMPARE(wording(), ui::Wording::Symbols);
    }
    void engineersSeeFormulaAndPaperAtOnce() {
        test::ConsoleBench bench;
        start(bench, "simulator");
        ui::OperatorSession& session = bench.console().window()->session();
        const auto explain = [&] {
            bench.console().window()->showPage("milling");
            QVERIFY(bench.press("help"));
            QTest::mouseClick(bench.find<QWidget>("millingTool"), Qt::LeftButton);
            settle();
        };
        QVERIFY(session.signOn(QStringLiteral("Kim"), ui::Role::Operator));
        explain();
        QVERIFY(bench.find<QWidget>("helpWords") != nullptr);
        QVERIFY(bench.find<QWidget>("helpBehind") == nullptr);
        QVERIFY(bench.press("helpFormula"));
        QVERIFY(bench.find<QWidget>("helpBehind") != nullptr);
        QVERIFY(bench.press("sheetSafe"));
        QVERIFY(session.signOn(QStringLiteral("Lee"), ui::Role::Engineer));
        explain();
        QVERIFY(bench.find<QWidget>("helpBehind") != nullptr);
        QVERIFY(bench.find<QWidget>("helpFormula") == nullptr);
        QVERIFY(bench.text("helpSource").contains(QStringLiteral("1987")));
    }
};

QTEST_MAIN(TestConsoleWording)
#include "tst_console_wording.moc"
