// SPDX-License-Identifier: GPL-3.0-or-later
#include <QComboBox>
#include <QFile>
#include <QPointer>
#include <QTableWidget>
#include <QTest>
#include <algorithm>
#include <cmath>

#include "db/migrator.h"
#include "db/readers/database_reader.h"
#include "tests/support/console_bench.h"
#include "tests/support/layout_check.h"
#include "ui/help/help_texts.h"
#include "ui/widgets/action_button.h"
#include "ui/widgets/number_display.h"
#include "ui/widgets/value_field.h"

using namespace kerf;

/// Lots, part types, recipes and roles on the real console.
class TestConsoleLots : public QObject {
    Q_OBJECT

    static console::Options options(std::uint32_t lotSize, bool automatic) {
        console::Options options;
        options.lotSize = lotSize;
        options.preparedParts = automatic ? 100 : 0;
        options.autoOperator = automatic;
        options.simulationSpeed = 0.0;
        options.changeAtPart = 0;
        return options;
    }
    static void start(test::ConsoleBench& bench, const console::Options& options) {
        bench.start(options);
        QTRY_VERIFY2_WITH_TIMEOUT(bench.up(), qPrintable(bench.failure()), 20'000);
    }
    static void signOn(test::ConsoleBench& bench, const char* name, ui::Role role) {
        bench.console().window()->session().signOff();
        QVERIFY(bench.console().window()->session().signOn(QLatin1String(name), role));
    }
    static void look(test::ConsoleBench& bench, const char* what) {
        ui::MainWindow* window = bench.console().window();
        for (int i = 0; i < 3; ++i) {
            QCoreApplication::sendPostedEvents();
            QCoreApplication::processEvents();
        }
        window->grab().save(QLatin1String(what) + QStringLiteral(".png"));
        const QStringList clipped = test::clippedTexts(window);
        QVERIFY2(clipped.isEmpty(), qPrintable(QLatin1String(what) + u'\n' + clipped.join(u'\n')));
        const QStringList small = test::smallTargets(window, bench.console().look());
        QVERIFY2(small.isEmpty(), qPrintable(QLatin1String(what) + u'\n' + small.join(u'\n')));
    }
    static bool disabled(test::ConsoleBench& bench, const char* name) {
        const auto* button = bench.find<QAbstractButton>(name);
        return button != nullptr && !button->isEnabled();
    }
    static bool waitForFullLot(test::ConsoleBench& bench) {
        return QTest::qWaitFor([&bench] { return lotFull(bench.service()) && !bench.service().awaiting; }, 60'000);
    }

 private slots:
    void aFullLotSaysSoAndOffersTheNextOne() {
        test::ConsoleBench bench;
        bench.prepareQuickBores();
        start(bench, options(3, true));
        QVERIFY(waitForFullLot(bench));
        bench.console().window()->showPage("boring");
        QTRY_VERIFY(bench.find<QPushButton>("boringNextLot") != nullptr);
        QTRY_VERIFY(bench.text("path").contains(QStringLiteral("full")));
        look(bench, "full");
        QVERIFY(bench.press("boringNextLot"));
        QCOMPARE(bench.find<QLineEdit>("lotName")->text(), QStringLiteral("2"));
        signOn(bench, "Kim", ui::Role::Setter);
        look(bench, "lots");
        QVERIFY(bench.press("lotOpen"));
        QTRY_COMPARE_WITH_TIMEOUT(bench.service().lot, std::string("2"), 30'000);
        QTRY_VERIFY(bench.text("path").contains(QStringLiteral("lot 2")));
        QVERIFY(bench.find<QWidget>("lotForm") == nullptr);
        const std::uint64_t cycle = bench.status().cycle;
        QTRY_VERIFY_WITH_TIMEOUT(bench.status().cycle > cycle + 5'000, 20'000);
        QVERIFY(bench.service().parts.empty());  // opening a lot is opening it
        bench.console().window()->showPage("overview");
        QVERIFY(bench.press("startPart"));
        QVERIFY(waitForFullLot(bench));  // after that the demonstration goes on by itself
        QCOMPARE(bench.service().parts.size(), std::size_t{3});
        bench.stop();
        start(bench, options(3, true));
        QCOMPARE(bench.service().lot, std::string("2"));
        QCOMPARE(bench.service().parts.size(), std::size_t{3});
        QVERIFY(bench.console().boringService().restartFinding().empty());
    }
    void anEarlierLotGoesOnAndCanBeClosed() {
        test::ConsoleBench bench;
        bench.prepareQuickBores();
        start(bench, options(2, true));
        QVERIFY(waitForFullLot(bench));
        signOn(bench, "Kim", ui::Role::Setter);
        QVERIFY(bench.press("lots"));
        QVERIFY(bench.press("lotOpen"));
        QTRY_COMPARE_WITH_TIMEOUT(bench.service().lot, std::string("2"), 30'000);
        QVERIFY(bench.press("startPart"));
        QVERIFY(waitForFullLot(bench));
        QVERIFY(bench.press("lots"));
        auto* table = bench.find<QTableWidget>("lotTable");
        QCOMPARE(table->rowCount(), 2);
        table->selectRow(1);
        QVERIFY(bench.press("lotChoose"));
        QTRY_COMPARE_WITH_TIMEOUT(bench.service().lot, std::string("1"), 30'000);
        QCOMPARE(bench.service().parts.size(), std::size_t{2});
        QVERIFY(bench.press("lots"));
        QVERIFY(bench.press("lotClose"));
        QTRY_VERIFY(bench.service().lotClosed);
        QTRY_VERIFY(bench.text("path").contains(QStringLiteral("closed")));
    }
    void aBoreThatWaitsIsKeptAndTheLawStays() {
        test::ConsoleBench bench;
        bench.prepareQuickBores();
        start(bench, options(5, false));
        QTRY_VERIFY_WITH_TIMEOUT(bench.service().awaiting.has_value(), 60'000);
        const PartId part = *bench.service().awaiting;
        signOn(bench, "Kim", ui::Role::Setter);
        QVERIFY(bench.press("lots"));
        QTRY_VERIFY(bench.text("lotMessage").contains(QStringLiteral("waits for its diameter")));
        QVERIFY(bench.press("lotPerturbation"));
        QVERIFY(bench.press("lotOpen"));
        QTRY_COMPARE_WITH_TIMEOUT(bench.service().lot, std::string("2"), 30'000);
        QVERIFY(bench.console().window()->bottomLine().contains(QStringLiteral("still waits")));
        QVERIFY(bench.press("lots"));
        QVERIFY(bench.find<QPushButton>("lotPerturbation")->isChecked());
        auto* table = bench.find<QTableWidget>("lotTable");
        QVERIFY(table->item(1, 4)->text().contains(u'1'));
        table->selectRow(1);
        QVERIFY(bench.press("lotChoose"));
        QTRY_COMPARE_WITH_TIMEOUT(bench.service().lot, std::string("1"), 30'000);
        QCOMPARE(bench.service().awaiting, std::optional(part));
    }
    void onlyASetterOpensLotsAndTheButtonSaysSo() {
        test::ConsoleBench bench;
        start(bench, options(1, true));
        QVERIFY(waitForFullLot(bench));
        signOn(bench, "Lee", ui::Role::Engineer);
        signOn(bench, "Kim", ui::Role::Operator);
        QVERIFY(bench.press("lots"));
        auto* open = bench.find<ui::ActionButton>("lotOpen");
        QVERIFY(open != nullptr && !open->isEnabled());
        QVERIFY(open->reason().contains(QStringLiteral("Only a setter")));
        QVERIFY(disabled(bench, "lotNewPartType"));
        look(bench, "lots_operator");
        QVERIFY(bench.press("lotCancel"));
        bench.console().window()->showPage("boring");
        QVERIFY(disabled(bench, "boringModeAdvise"));
        QTRY_VERIFY(bench.text("boringLoopReason").contains(QStringLiteral("Only a setter")));
        bench.console().window()->client().sendAction(SetLoopMode{ProcessId::Boring, LoopMode::Off});
        QVERIFY(bench.console().window()->bottomLine().contains(QStringLiteral("Only a setter")));
        signOn(bench, "Lee", ui::Role::Engineer);
        QVERIFY(bench.press("boringModeAdvise"));
        QTRY_COMPARE(bench.status().loops[static_cast<std::size_t>(ProcessId::Boring)].mode, LoopMode::Advise);
    }
    void anEngineerMakesAPartTypeAndRollsItsRecipeBack() {
        test::ConsoleBench bench;
        start(bench, options(1, true));
        QVERIFY(waitForFullLot(bench));
        signOn(bench, "Lee", ui::Role::Engineer);
        QVERIFY(bench.press("lots"));
        QVERIFY(bench.press("lotNewPartType"));
        bench.find<QLineEdit>("recipeName")->setText(QStringLiteral("Sleeve 50"));
        bench.find<ui::ValueField>("recipeField2")->setValue(49.0);  // largest diameter below the target
        emit bench.find<ui::ValueField>("recipeField2")->edited();
        QVERIFY(disabled(bench, "recipeSave"));
        QVERIFY(bench.text("recipeMessage").contains(QStringLiteral("target diameter")));
        bench.find<ui::ValueField>("recipeField2")->setValue(50.03);
        QVERIFY(bench.press("recipeDepthAdd"));
        bench.find<ui::ValueField>("recipeDepth2")->setValue(175.0);
        emit bench.find<ui::ValueField>("recipeField2")->edited();
        look(bench, "recipe_new");
        QVERIFY(bench.press("recipeSave"));
        QTRY_VERIFY(bench.find<QComboBox>("lotPartType") != nullptr);
        QCOMPARE(bench.find<QComboBox>("lotPartType")->currentText(), QStringLiteral("Sleeve 50"));

        QVERIFY(bench.press("lotRecipe"));
        bench.find<ui::ValueField>("recipeField2")->setValue(50.02);
        emit bench.find<ui::ValueField>("recipeField2")->edited();
        QVERIFY(bench.text("recipeDifference").contains(QStringLiteral("50.030")));
        QVERIFY(disabled(bench, "recipeSave"));  // no reason yet
        bench.find<QLineEdit>("recipeReason")->setText(QStringLiteral("drawing B"));
        QVERIFY(bench.press("recipeSave"));
        // Who types on while it is stored keeps field and text.
        const QPointer<QLineEdit> next = bench.find<ui::ValueField>("recipeDepth2")->edit();
        next->setText(QStringLiteral("17"));
        emit bench.find<ui::ValueField>("recipeDepth2")->edited();
        bench.find<QLineEdit>("recipeReason")->setText(QStringLiteral("and deeper"));
        QTRY_COMPARE(bench.find<QTableWidget>("recipeRevisions")->rowCount(), 2);
        QVERIFY(next && next->text() == QStringLiteral("17"));
        QCOMPARE(bench.find<QLineEdit>("recipeReason")->text(), QStringLiteral("and deeper"));
        bench.find<QTableWidget>("recipeRevisions")->selectRow(1);
        QCOMPARE(bench.find<ui::ValueField>("recipeField2")->value(), 50.03);
        bench.find<QLineEdit>("recipeReason")->setText(QStringLiteral("drawing A holds"));
        look(bench, "recipe");
        QVERIFY(bench.press("recipeRestore"));
        QTRY_COMPARE(bench.find<QTableWidget>("recipeRevisions")->rowCount(), 3);
        QVERIFY(bench.press("recipeCancel"));

        bench.find<QComboBox>("lotPartType")->setCurrentText(QStringLiteral("Sleeve 50"));
        QVERIFY(bench.press("lotOpen"));
        QTRY_COMPARE(bench.service().partType, std::string("Sleeve 50"));
        QCOMPARE(bench.service().upperTolerance_mm, 50.03);
        QCOMPARE(bench.service().depths.size(), std::size_t{3});
        QCOMPARE(bench.service().recipeRevision, 3U);
        bench.stop();
        start(bench, options(1, true));
        QCOMPARE(bench.service().partType, std::string("Sleeve 50"));
    }
    void aPartGetsItsSerialAndItsReportAndAllDataABackup() {
        test::ConsoleBench bench;
        start(bench, options(1, true));
        QVERIFY(waitForFullLot(bench));
        signOn(bench, "Kim", ui::Role::Operator);
        bench.console().window()->showPage("parts");
        QTRY_VERIFY(bench.find<ui::ActionButton>("partSerial") != nullptr && !disabled(bench, "partSerial"));
        look(bench, "parts");
        QVERIFY(bench.press("partSerial"));
        QTRY_VERIFY(bench.find<QLineEdit>("serialNumber") != nullptr);
        bench.find<QLineEdit>("serialNumber")->setText(QStringLiteral("SN-0001"));
        QVERIFY(bench.press("serialSave"));
        QTRY_VERIFY(bench.text("partFacts").contains(QStringLiteral("SN-0001")));

        QVERIFY(bench.press("partReport"));
        const QString file = bench.folder() + QStringLiteral("/reports/one");
        QTRY_VERIFY(bench.find<QLineEdit>("reportFile") != nullptr);
        bench.find<QLineEdit>("reportFile")->setText(file);
        QVERIFY(bench.press("reportPdf"));
        QTRY_VERIFY(bench.console().window()->bottomLine().contains(QStringLiteral("one.pdf")));
        QFile pdf(file + QStringLiteral(".pdf"));
        QVERIFY(pdf.open(QIODevice::ReadOnly));
        QVERIFY(pdf.read(5) == "%PDF-");
        QVERIFY(bench.press("partReport"));
        QTRY_VERIFY(bench.find<QLineEdit>("reportFile") != nullptr);
        bench.find<QLineEdit>("reportFile")->setText(file);
        QVERIFY(bench.press("reportCsv"));
        QTRY_VERIFY(QFile::exists(file + QStringLiteral(".csv")));
        QFile csv(file + QStringLiteral(".csv"));
        QVERIFY(csv.open(QIODevice::ReadOnly));
        QCOMPARE(csv.readAll().count('\n'), 3);  // head and two diameters

        const QString copy = bench.folder() + QStringLiteral("/copy/kerf.db");
        bool done = false;
        Result<void> result;
        ui::Services services = bench.console().services();
        QVERIFY(!services.backupFolders().isEmpty());
        services.backUp(copy, [&](const Result<void>& backedUp) {
            result = backedUp;
            done = true;
        });
        QTRY_VERIFY_WITH_TIMEOUT(done, 20'000);
        QVERIFY2(result.has_value(), result ? "" : result.error().english().c_str());
        QVERIFY(db::checkDatabase(copy.toStdString()).has_value());
        bench.console().window()->showPage("diagnostics");
        look(bench, "diagnostics");
        QVERIFY(bench.press("backup"));
        QTRY_VERIFY(bench.find<QPushButton>("backupFolder0") != nullptr);
    }
    /// A lot of taps is opened, tapped and closed at the page; each part names lot, revision and tool it was made with.
    void aLotOfTapsIsOpenedTappedAndClosed() {
        test::ConsoleBench bench;
        start(bench, options(1, false));
        signOn(bench, "Lee", ui::Role::Engineer);
        QTRY_VERIFY_WITH_TIMEOUT(bench.service().awaiting.has_value(), 60'000);  // the machine is free
        bench.console().window()->showPage("tapping");
        const auto openLots = [&bench] {
            return bench.press("tappingJob") && bench.press("processLots") &&
                   QTest::qWaitFor([&bench] { return bench.find<QTableWidget>("lotTable") != nullptr; });
        };
        const auto tapping = [&bench]() -> const TappingStatus& { return bench.status().tapping; };
        const auto tap = [&bench, &tapping] {
            const std::uint32_t before = tapping().taps;
            return bench.press("tappingTap") && QTest::qWaitFor(
                                                    [&] {
                                                        return tapping().taps > before &&
                                                               tapping().phase == TapPhase::Idle &&
                                                               !disabled(bench, "tappingTap");
                                                    },
                                                    20'000);
        };
        QTRY_VERIFY_WITH_TIMEOUT(bench.find("tappingTap") != nullptr && !disabled(bench, "tappingTap"), 60'000);
        QVERIFY(openLots());
        QVERIFY(disabled(bench, "lotOpen"));
        look(bench, "tapping_lots_none");
        bench.find<QLineEdit>("lotName")->setText(QStringLiteral("T-1"));
        bench.find<QLineEdit>("lotSize")->setText(QStringLiteral("2"));
        bench.find<QLineEdit>("lotTool")->setText(QStringLiteral("M8 6HX, spiral point"));
        bench.find<QLineEdit>("lotGauge")->setText(QStringLiteral("Thread plug 6H"));
        QVERIFY(bench.press("lotOpen"));
        QTRY_VERIFY(bench.find<QTableWidget>("lotTable") != nullptr &&
                    bench.find<QTableWidget>("lotTable")->rowCount() == 1);
        look(bench, "tapping_lots");
        QVERIFY(bench.press("sheetSafe"));
        QTRY_COMPARE(bench.text("lotLine"), QStringLiteral("lot T-1"));
        QVERIFY(tap());
        QCOMPARE(tapping().kind, TapKind::Air);  // of a new job; it is no part
        QVERIFY(tap());
        QVERIFY(tap());
        QCOMPARE(tapping().kind, TapKind::Production);
        auto reader = *db::DatabaseReader::open(bench.console().databasePath());
        PartQuery query;
        query.process = ProcessId::Tapping;
        QTRY_COMPARE_WITH_TIMEOUT(reader->parts(query)->size(), std::size_t{2}, 10'000);
        const LotRow lot = reader->lots(std::nullopt, 10, ProcessId::Tapping)->front();
        QCOMPARE(lot.name, std::string("T-1"));
        QCOMPARE(lot.tool, std::string("M8 6HX, spiral point"));
        QCOMPARE(lot.gauge, std::string("Thread plug 6H"));
        const std::vector<PartRow> tapped = *reader->parts(query);
        for (const PartRow& part : tapped) {
            QCOMPARE(part.lot, std::optional(lot.id));
            QCOMPARE(part.recipe, std::optional(lot.recipe));
        }
        // In Korean, with a lot that is closed and one that is not.
        QVERIFY(bench.press("language"));
        QVERIFY(openLots());
        QVERIFY(disabled(bench, "lotClose"));  // not without a reason
        bench.find<QLineEdit>("lotReason")->setText(QStringLiteral("2개 완료"));
        QVERIFY(bench.press("lotClose"));
        QTRY_VERIFY(bench.find<QTableWidget>("lotTable") != nullptr &&
                    bench.find<QTableWidget>("lotTable")->item(0, 6)->text().contains(QStringLiteral("–")));
        bench.find<QLineEdit>("lotName")->setText(QStringLiteral("T-2"));
        QVERIFY(bench.press("lotOpen"));
        QTRY_VERIFY(bench.find<QTableWidget>("lotTable") != nullptr &&
                    bench.find<QTableWidget>("lotTable")->rowCount() == 2);
        look(bench, "tapping_lots_ko");
        QVERIFY(bench.press("lotLeave"));
        QTRY_VERIFY(disabled(bench, "lotLeave"));
        QVERIFY(bench.press("sheetSafe"));
        QVERIFY(bench.find("lotLine") == nullptr);
        QVERIFY(tap());  // of no lot again
        QTRY_COMPARE_WITH_TIMEOUT(reader->parts(query)->size(), std::size_t{3}, 10'000);
        QVERIFY(!reader->parts(query)->front().lot);
        const auto lots = *reader->lots(std::nullopt, 10, ProcessId::Tapping);
        QCOMPARE(std::ranges::count_if(lots, [](const LotRow& one) { return one.closedUtc_ms.has_value(); }), 1);
        const auto verdict = reader->verifyAudit();
        QVERIFY2(verdict && verdict->finding.empty(), verdict->finding.english().c_str());
    }
    void everyButtonAndFigureIsExplained_data() {
        QTest::addColumn<QString>("machine");
        QTest::newRow("machining centre") << "simulator";
        QTest::newRow("diamond lathe") << "diamond-lathe";
    }
    void everyButtonAndFigureIsExplained() {
        QFETCH(QString, machine);
        test::ConsoleBench bench;
        console::Options chosen = options(5, false);
        chosen.machine = machine.toStdString();
        start(bench, chosen);
        const std::vector<ui::HelpText> texts = ui::helpTexts();
        QStringList without;
        for (const ui::PageEntry& page : bench.console().window()->pages()) {
            bench.console().window()->showPage(page.key);
            for (const QWidget* widget : bench.console().window()->findChildren<QWidget*>()) {
                const bool figure = qobject_cast<const ui::NumberDisplay*>(widget) != nullptr;
                const QString name = widget->objectName();
                // The keypad is the field's, the navigation its pages'; scroll bars are Qt's.
                const bool counts = (figure || qobject_cast<const QAbstractButton*>(widget) != nullptr) &&
                                    widget->isVisible() && !name.startsWith(QStringLiteral("key")) &&
                                    !name.startsWith(QStringLiteral("nav_")) && !name.startsWith(QStringLiteral("qt_"));
                if (counts && !name.isEmpty() && name != QStringLiteral("help") &&
                    ui::findHelp(texts, name) == nullptr) {
                    without << QLatin1String(page.key) + u'/' + name;
                }
            }
        }
        without.removeDuplicates();
        QVERIFY2(without.isEmpty(), qPrintable(without.join(u' ')));
    }
    void aBoreThatWaitsCanBeGaugedAfterARestart() {
        test::ConsoleBench bench;
        console::Options first = options(5, false);
        first.changeAtPart = 1;
        start(bench, first);
        QTRY_VERIFY_WITH_TIMEOUT(bench.service().awaiting.has_value(), 60'000);
        const PartId part = *bench.service().awaiting;
        const auto before = bench.console().boringService().gaugeReading_mm(part, 1);
        QVERIFY(before.has_value());
        bench.stop();
        start(bench, first);
        QCOMPARE(*bench.service().awaiting, part);
        const auto after = bench.console().boringService().gaugeReading_mm(part, 1);
        QVERIFY(after.has_value());
        QVERIFY2(std::abs(*after - *before) < 0.0015, qPrintable(QString::number(*after - *before)));
        QCOMPARE(*bench.console().boringService().gaugeReading_mm(part, 1), *after);
    }
};

QTEST_MAIN(TestConsoleLots)
#include "tst_console_lots.moc"
