// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAbstractButton>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>

#include "tests/support/shell_bench.h"
#include "ui/dialogs/settings_sheet.h"
#include "ui/widgets/scroll_box.h"

using namespace kerf;
using namespace kerf::ui;
using kerf::test::ShellBench;

/// Whatever the size of the text: the window is the screen, and the frame stands in it.
class TestFitting : public QObject {
    Q_OBJECT

    static void settle() {
        for (int i = 0; i < 2; ++i) {
            QCoreApplication::sendPostedEvents();
            QCoreApplication::processEvents();
        }
    }
    /// Empty: the frame stands as it should.
    static QString frameTrouble(MainWindow& window, QSize screen) {
        if (window.size() != screen) {
            return QStringLiteral("the window is %1×%2").arg(window.width()).arg(window.height());
        }
        const QSize least = window.minimumSizeHint().expandedTo(window.minimumSize());
        if (least.width() > screen.width() || least.height() > screen.height()) {
            return QStringLiteral("the window wants %1×%2").arg(least.width()).arg(least.height());
        }
        for (const char* name :
             {"holdAll", "alarmShow", "settings", "language", "operator", "lots", "heldRelease", "nav_overview"}) {
            const auto* button = window.findChild<QWidget*>(QLatin1String(name));
            if (button == nullptr) {
                return QStringLiteral("no %1").arg(QLatin1String(name));
            }
            if (!button->isVisible()) {
                continue;
            }
            const QRect place(button->mapTo(&window, QPoint()), button->size());
            if (!window.rect().contains(place) || place.width() < button->minimumSizeHint().width() ||
                place.height() < button->minimumSizeHint().height()) {
                return QStringLiteral("%1 stands at %2,%3 with %4×%5")
                    .arg(QLatin1String(name))
                    .arg(place.x())
                    .arg(place.y())
                    .arg(place.width())
                    .arg(place.height());
            }
        }
        return {};
    }
    static QRect placeOf(MainWindow& window, const char* name) {
        const auto* widget = window.findChild<QWidget*>(QLatin1String(name));
        return {widget->mapTo(&window, QPoint()), widget->size()};
    }
    static QString sheetTrouble(MainWindow& window) {
        const Sheet* sheet = window.sheets().current();
        if (sheet == nullptr) {
            return QStringLiteral("no sheet");
        }
        for (const auto* button : sheet->findChildren<QAbstractButton*>(QStringLiteral("sheetSafe"))) {
            const QRect place(button->mapTo(&window, QPoint()), button->size());
            const QRect area(sheet->mapTo(&window, QPoint()), sheet->size());
            if (!area.contains(place)) {
                return QStringLiteral("the safe button stands outside");
            }
        }
        return {};
    }

 private slots:
    void theFrameStandsOnEveryScreenAtEverySize_data() {
        QTest::addColumn<int>("language");
        QTest::addColumn<double>("scale");
        for (const Language language : {Language::English, Language::Korean}) {
            for (const double scale : {1.0, 1.25, 1.5, 2.0}) {
                QTest::addRow("%s_%.0f", language == Language::English ? "en" : "ko", 100 * scale)
                    << int(language) << scale;
            }
        }
    }
    void theFrameStandsOnEveryScreenAtEverySize() {
        QFETCH(int, language);
        QFETCH(double, scale);
        Preferences preferences;
        preferences.language = Language(language);
        preferences.scale = scale;
        ShellBench bench(kerf::test::allPages(), preferences);
        MainWindow& window = *bench.window;
        for (LoopStatus& loop : bench.engine.fake.loops) {
            loop.fitted = true;
        }
        QVERIFY(window.session().signOn(QStringLiteral("Maximiliane Sophia von Hohenstein-Wagner")));
        window.client().stop();
        window.show();
        for (const QSize screen : {QSize(1024, 768), QSize(1280, 800), QSize(1920, 1080), QSize(3840, 2160)}) {
            window.resize(screen);
            for (const bool troubled : {false, true}) {
                bench.engine.fake.held = troubled;
                if (troubled) {
                    bench.raise(test::kSensorAlarm);
                    bench.raise(test::kToolAlarm);
                    window.client().tick();
                }
                settle();
                const QRect hold = placeOf(window, "holdAll");
                const QRect settings = placeOf(window, "settings");
                for (const PageEntry& entry : window.pages()) {
                    window.showPage(entry.key);
                    window.client().tick();
                    settle();
                    const QString trouble = frameTrouble(window, screen);
                    QVERIFY2(trouble.isEmpty(), qPrintable(QStringLiteral("%1 at %2: %3")
                                                               .arg(QLatin1String(entry.key))
                                                               .arg(screen.width())
                                                               .arg(trouble)));
                    QCOMPARE(placeOf(window, "holdAll"), hold);
                    QCOMPARE(placeOf(window, "settings"), settings);
                }
                openSettings(bench.look, window.sheets());
                settle();
                QVERIFY2(frameTrouble(window, screen).isEmpty(), qPrintable(frameTrouble(window, screen)));
                QVERIFY2(sheetTrouble(window).isEmpty(), qPrintable(sheetTrouble(window)));
                window.sheets().tell(
                    QStringLiteral("A question"),
                    QString(40, u'x') + QString(2000, u' ').replace(QStringLiteral(" "), QStringLiteral("word ")));
                settle();
                QVERIFY2(frameTrouble(window, screen).isEmpty(), qPrintable(frameTrouble(window, screen)));
                QVERIFY2(sheetTrouble(window).isEmpty(), qPrintable(sheetTrouble(window)));
                window.sheets().current()->close();
                settle();
                if (troubled) {
                    bench.raise(test::kSensorAlarm, false);
                    bench.raise(test::kToolAlarm, false);
                }
            }
        }
    }
    void noButtonIsNarrowerThanItsWords() {
        for (const Language language : {Language::English, Language::Korean}) {
            for (const double scale : {1.0, 1.5, 2.0}) {
                Preferences preferences;
                preferences.language = language;
                preferences.scale = scale;
                ShellBench bench(kerf::test::allPages(), preferences);
                bench.window->client().stop();
                bench.window->show();
                for (const QSize screen : {QSize(1024, 768), QSize(1280, 800)}) {
                    bench.window->resize(screen);
                    for (const PageEntry& entry : bench.window->pages()) {
                        bench.window->showPage(entry.key);
                        bench.window->client().tick();
                        settle();
                        for (const auto* button : bench.window->page(entry.key)->findChildren<QPushButton*>()) {
                            QVERIFY2(!button->isVisible() || button->width() >= button->minimumSizeHint().width(),
                                     qPrintable(QStringLiteral("%1 %2 %3 at %4: %5 is %6 wide, wants %7, least %8")
                                                    .arg(QLatin1String(entry.key))
                                                    .arg(int(language))
                                                    .arg(scale)
                                                    .arg(screen.width())
                                                    .arg(button->objectName() + u' ' + button->text())
                                                    .arg(button->width())
                                                    .arg(button->minimumSizeHint().width())
                                                    .arg(button->minimumWidth())));
                        }
                    }
                }
            }
        }
    }
    void pagesDoNotScrollAtTheirOwnSize() {
        for (const Language language : {Language::English, Language::Korean}) {
            Preferences preferences;
            preferences.language = language;
            ShellBench bench(kerf::test::allPages(), preferences);
            bench.window->resize(1280, 800);
            bench.window->show();
            bench.window->client().stop();
            for (const PageEntry& entry : bench.window->pages()) {
                bench.window->showPage(entry.key);
                bench.window->client().tick();
                settle();
                const auto* room =
                    qobject_cast<ScrollBox*>(bench.window->page(entry.key)->parentWidget()->parentWidget());
                QVERIFY(room != nullptr);
                QVERIFY2(!room->scrolls(), qPrintable(QStringLiteral("%1 %2 wants %3×%4 of %5×%6")
                                                          .arg(QLatin1String(entry.key))
                                                          .arg(int(language))
                                                          .arg(room->widget()->width())
                                                          .arg(room->widget()->height())
                                                          .arg(room->viewport()->width())
                                                          .arg(room->viewport()->height())));
            }
        }
    }
    void aLongSentenceOnTheBottomLineMovesNothing() {
        ShellBench bench;
        bench.window->resize(1280, 800);
        bench.window->show();
        bench.window->client().stop();
        settle();
        const QRect before = placeOf(*bench.window, "bottomLine");
        static const QByteArray words = QByteArray("A very long sentence goes on and on. ").repeated(40);
        bench.engine.refuseWith = Sentence(words.constData());
        bench.window->client().sendAction(ReleaseHold{});
        bench.window->client().tick();
        settle();
        QVERIFY(bench.window->bottomLine().size() > 1000);
        QCOMPARE(placeOf(*bench.window, "bottomLine"), before);
        QCOMPARE(bench.window->size(), QSize(1280, 800));
    }
    void theFieldThatASheetAsksForHasTheKeys() {
        ShellBench bench;
        bench.window->resize(1280, 800);
        bench.window->show();
        QVERIFY(QTest::qWaitForWindowActive(bench.window.get()));
        Sheet* sheet = bench.window->sheets().open(QStringLiteral("Two fields"));
        auto* first = new QLineEdit(sheet);
        auto* second = new QLineEdit(sheet);
        sheet->body()->addWidget(first);
        sheet->body()->addWidget(second);
        second->setFocus();  // before it is laid out
        settle();
        QCOMPARE(QApplication::focusWidget(), second);
        sheet = bench.window->sheets().open(QStringLiteral("One field"));
        auto* only = new QLineEdit(sheet);
        sheet->body()->addWidget(only);
        settle();
        QCOMPARE(QApplication::focusWidget(), only);
    }
};

QTEST_MAIN(TestFitting)
#include "tst_fitting.moc"
