// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QLineEdit>
#include <QTableWidget>
#include <QTextStream>

#include "tests/support/console_bench.h"
#include "ui/dialogs/sheet.h"
#include "ui/link/texts.h"
#include "ui/services/milling_service.h"
#include "ui/shell/services.h"
#include "ui/widgets/action_button.h"
#include "ui/widgets/value_field.h"

using namespace kerf;

/// A milling shift on the real console: simulator, engine, database, window; an engineer's touches through the widgets.
class TestConsoleMilling : public QObject {
    Q_OBJECT

    static constexpr double kFast = 400.0;     ///< machine time per wall time
    static constexpr double kCutSpeed = 20.0;  ///< where something is done within a cut

    [[nodiscard]] static console::Options options() {
        console::Options o;
        o.preparedParts = 0;
        o.simulationSpeed = kFast;
        o.seed = 5;
        return o;
    }
    [[nodiscard]] const MillingStatus& milling() { return m_bench->status().milling; }
    [[nodiscard]] const LoopStatus& loop() {
        return m_bench->status().loops[static_cast<std::size_t>(ProcessId::Milling)];
    }
    void speed(double factor) {
        Command command;
        command.action = SetSimulationSpeed{factor};
        QVERIFY(m_bench->console().engine().send(command));
    }
    /// The milling page on the screen, and the bore that the shift has begun out of the way.
    void openPage() {
        m_bench->start(options());
        QTRY_VERIFY_WITH_TIMEOUT(m_bench->up() || !m_bench->failure().isEmpty(), 20'000);
        QVERIFY2(m_bench->up(), qPrintable(m_bench->failure()));
        QTRY_VERIFY_WITH_TIMEOUT(m_bench->service().awaiting.has_value(), 60'000);  // its bore waits for the gauge
        m_bench->console().window()->showPage("milling");
        QTRY_VERIFY(m_bench->find("millingPage") != nullptr);
        QTRY_VERIFY_WITH_TIMEOUT(milling().setup != 0 && loop().mode == LoopMode::Control, 20'000);
        QTRY_VERIFY_WITH_TIMEOUT(enabled("millingStart"), 60'000);
    }
    void start(double factor) {
        speed(factor);
        QTRY_VERIFY_WITH_TIMEOUT(enabled("millingStart"), 60'000);
        const std::uint32_t before = milling().partsCut;
        QVERIFY(m_bench->press("millingStart"));
        QTRY_VERIFY_WITH_TIMEOUT(milling().cutting || milling().partsCut > before, 10'000);
    }
    void cutPart() {
        const std::uint32_t before = milling().partsCut;
        start(kFast);
        QTRY_VERIFY_WITH_TIMEOUT(milling().partsCut == before + 1, 60'000);
    }
    [[nodiscard]] std::vector<PartRow> stored() {
        auto reader = db::DatabaseReader::open(m_bench->console().databasePath());
        PartQuery query;
        query.process = ProcessId::Milling;
        const auto parts = reader ? (*reader)->parts(query) : Result<std::vector<PartRow>>();
        return parts ? *parts : std::vector<PartRow>();
    }
    [[nodiscard]] static double figure(const PartRow& part, const char* key) {
        for (const PartFigure& one : part.figures) {
            if (one.key == key) {
                return one.value;
            }
        }
        return -1.0;
    }
    void signOn() { QVERIFY(m_bench->console().window()->session().signOn(QStringLiteral("Kim"), ui::Role::Setter)); }
    [[nodiscard]] bool type(const char* name, const char* number) {
        const auto* field = m_bench->find<ui::ValueField>(name);
        if (field == nullptr) {
            return false;
        }
        field->edit()->setFocus();
        field->edit()->selectAll();
        QTest::keyClicks(field->edit(), QLatin1String(number));
        // Keys that could begin a gauge's frame are held back for a moment.
        return QTest::qWaitFor([&] { return field->edit()->text() == QLatin1String(number); });
    }
    [[nodiscard]] bool enterFile(const QString& file) {
        auto* edit = m_bench->find<QLineEdit>("millingBlankFile");
        if (edit != nullptr) {
            edit->setText(file);
        }
        return edit != nullptr;
    }
    [[nodiscard]] bool enabled(const char* name) {
        const auto* button = m_bench->find<QAbstractButton>(name);
        return button != nullptr && button->isEnabled();
    }
    [[nodiscard]] QString buttonText(const char* name) {
        const auto* button = m_bench->find<QAbstractButton>(name);
        return button != nullptr ? button->text() : QString();
    }

 private slots:
    void init() {
        m_bench = std::make_unique<test::ConsoleBench>();  // a data folder of its own
        openPage();
    }
    void cleanup() { m_bench.reset(); }

    void aControlledCutIsStoredWithItsFigures() {
        cutPart();
        QTRY_COMPARE_WITH_TIMEOUT(stored().size(), std::size_t{1}, 10'000);
        const PartRow part = stored().front();
        QVERIFY(part.complete);
        QVERIFY(figure(part, "waviness_um") > 0.0 && figure(part, "waviness_um") < 40.0);
        QVERIFY(std::abs(figure(part, "force_mean_N") - 392.0) < 40.0);
        QVERIFY(figure(part, "force_peak_N") < 45.0 * 9.80665);
        QVERIFY(figure(part, "planned_time_s") > 60.0 && figure(part, "cut_time_s") > 30.0);
        QTRY_VERIFY_WITH_TIMEOUT(m_bench->text("millingLastCut").contains(QStringLiteral("waviness")), 5'000);
        QVERIFY(m_bench->press("millingLog"));
        QVERIFY(m_bench->press("millingCutLogClose"));
    }
    void theLawIsSwitchedWhileCutting() {
        signOn();  // laws are a setter's
        start(kCutSpeed);
        QTRY_VERIFY_WITH_TIMEOUT(milling().position_mm > 24.0 || !milling().cutting, 20'000);
        const double before_mmPerS = milling().wantedFeed_mmPerS;
        QVERIFY(m_bench->press("millingLawPi"));
        QTRY_COMPARE_WITH_TIMEOUT(milling().law, MillingLaw::Pi, 5'000);
        QVERIFY(milling().cutting);
        QVERIFY(std::abs(milling().wantedFeed_mmPerS - before_mmPerS) < 0.5);
        const auto* preview = m_bench->find<ui::ActionButton>("millingLawPreview");
        QVERIFY(preview != nullptr);
        QVERIFY(!preview->isEnabled() && !preview->reason().isEmpty());
        speed(kFast);
        QTRY_VERIFY_WITH_TIMEOUT(!milling().cutting, 60'000);
        QCOMPARE(milling().stops, 0U);
    }
    void aReferenceIsTaughtFromTheCutAndKept() {
        signOn();
        QVERIFY(m_bench->press("millingLawConstant"));
        cutPart();
        const double mean_N = milling().meanForce_N;
        QVERIFY(mean_N > 0.0);
        QTRY_VERIFY_WITH_TIMEOUT(enabled("millingTeach"), 5'000);
        QVERIFY(m_bench->press("millingTeach"));
        QTRY_VERIFY_WITH_TIMEOUT(std::abs(milling().reference_N - mean_N) < 1e-9, 5'000);
        QTRY_COMPARE_WITH_TIMEOUT(setups(), std::size_t{3}, 10'000);  // what it began with, the law, the reference
        restart();
        QTRY_COMPARE_WITH_TIMEOUT(milling().reference_N, mean_N, 10'000);
        QCOMPARE(milling().law, MillingLaw::Constant);
    }
    void aSetupIsRolledBackOnTheScreen() {
        signOn();
        const double before_N = milling().reference_N;
        QVERIFY(m_bench->press("millingSetup"));
        QVERIFY(type("millingField0", "380"));
        QVERIFY(m_bench->press("millingSetupSave"));
        QTRY_COMPARE_WITH_TIMEOUT(milling().reference_N, 380.0, 10'000);
        QTRY_VERIFY_WITH_TIMEOUT(enabled("millingSetup"), 5'000);
        QVERIFY(m_bench->press("millingSetup"));
        QVERIFY(m_bench->press("recipeHistory"));
        QTRY_VERIFY_WITH_TIMEOUT(m_bench->find<QTableWidget>("recipeRevisions") != nullptr, 5'000);
        auto* revisions = m_bench->find<QTableWidget>("recipeRevisions");
        QCOMPARE(revisions->rowCount(), 2);
        QVERIFY(!enabled("recipeRestore"));
        revisions->selectRow(1);
        const QString difference = m_bench->text("recipeDifference");
        QVERIFY2(difference.contains(QStringLiteral("380")) && difference.contains(QString::number(before_N)),
                 qPrintable(difference));
        QVERIFY(!enabled("recipeRestore"));  // not without a reason
        m_bench->find<QLineEdit>("recipeReason")->setText(QStringLiteral("as before"));
        QVERIFY(m_bench->press("recipeRestore"));
        QTRY_COMPARE_WITH_TIMEOUT(milling().reference_N, before_N, 10'000);
        QTRY_COMPARE_WITH_TIMEOUT(setups(), std::size_t{3}, 10'000);
        QTRY_VERIFY(m_bench->find<QTableWidget>("recipeRevisions") != nullptr &&
                    m_bench->find<QTableWidget>("recipeRevisions")->rowCount() == 3);
        QVERIFY(m_bench->press("sheetSafe"));
    }
    void anUnpluggedForceNeverMeansFaster() {
        start(kCutSpeed);
        QTRY_VERIFY_WITH_TIMEOUT(milling().position_mm > 8.0 || !milling().cutting, 20'000);
        InjectedFaults faults;
        faults.force = SignalFault::Unplugged;
        m_bench->console().simulator()->machine().inject(faults);
        QTRY_VERIFY_WITH_TIMEOUT(milling().blind, 10'000);
        double last_mmPerS = milling().wantedFeed_mmPerS;
        QVERIFY(last_mmPerS <= 1.5 + 1e-9);
        const double from_mm = milling().position_mm;
        while (milling().cutting && milling().position_mm < from_mm + 20.0) {
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
            QVERIFY(milling().wantedFeed_mmPerS <= last_mmPerS + 1e-9);
            last_mmPerS = milling().wantedFeed_mmPerS;
        }
        QVERIFY(milling().cutting);
        QTRY_VERIFY_WITH_TIMEOUT(
            m_bench->console().window()->bottomLine().contains(QStringLiteral("Cutting force unknown")), 5'000);
        const ui::AlarmText text = ui::alarmText(m_bench->console().engine().alarmSpec(200), 200);
        QVERIFY(!text.cause.isEmpty() && !text.consequence.isEmpty() && !text.action.isEmpty());
    }
    void aBrokenToolIsHeldUntilReleased() {
        start(kCutSpeed);
        QTRY_VERIFY_WITH_TIMEOUT(milling().position_mm > 30.0 || !milling().cutting, 20'000);
        InjectedFaults faults;
        faults.toolBroken = true;
        m_bench->console().simulator()->machine().inject(faults);
        QTRY_VERIFY_WITH_TIMEOUT(milling().stopped, 10'000);
        m_bench->console().simulator()->machine().inject({});
        QTRY_VERIFY_WITH_TIMEOUT(enabled("millingRelease"), 5'000);
        signOn();  // a stop is released by a person
        QVERIFY(m_bench->press("millingRelease"));
        QTRY_VERIFY_WITH_TIMEOUT(!milling().stopped, 5'000);
        speed(kFast);
        QTRY_VERIFY_WITH_TIMEOUT(!milling().cutting, 60'000);
        QTRY_COMPARE_WITH_TIMEOUT(stored().size(), std::size_t{1}, 10'000);
        QCOMPARE(figure(stored().front(), "stops"), 1.0);
    }
    void setupBlankToolAndLogSurviveARestart() {
        signOn();
        QVERIFY(m_bench->press("millingSetup"));
        QVERIFY(type("millingField0", "380"));
        QVERIFY(m_bench->press("millingSetupSave"));
        QTRY_VERIFY2_WITH_TIMEOUT(milling().reference_N == 380.0, qPrintable(m_bench->text("millingSetupMessage")),
                                  10'000);
        QTRY_VERIFY_WITH_TIMEOUT(enabled("millingBlank"), 5'000);
        const QString file = m_bench->folder() + QStringLiteral("/blank.csv");
        writeFile(file, "x_mm,height_mm\n0,1\n20,two\n40,0\n");
        QVERIFY(m_bench->press("millingBlank"));
        QVERIFY(enterFile(file));
        QVERIFY(m_bench->press("millingBlankImport"));
        for (const char* piece : {"Line 3", "height_mm", "two"}) {
            QVERIFY2(m_bench->text("millingBlankMessage").contains(QLatin1String(piece)),
                     qPrintable(m_bench->text("millingBlankMessage")));
        }
        writeFile(file, "x_mm,height_mm\n0,1\n20,2\n40,3\n60,2\n80,1\n100,0\n");
        QVERIFY(m_bench->press("millingBlankImport"));
        QVERIFY(m_bench->press("millingBlankUse"));
        QTRY_VERIFY_WITH_TIMEOUT(enabled("millingLawPreview"), 10'000);
        QVERIFY(m_bench->press("millingLawPreview"));
        QTRY_COMPARE_WITH_TIMEOUT(milling().law, MillingLaw::Preview, 5'000);
        for (int i = 0; i < 4; ++i) {
            cutPart();
        }
        QTRY_COMPARE_WITH_TIMEOUT(records("tool").size(), std::size_t{4}, 10'000);
        QTRY_COMPARE_WITH_TIMEOUT(setups(), std::size_t{4}, 10'000);  // as it began, setup, blank, law
        const MillingStatus before = milling();
        QVERIFY(before.wear > 0.0 && before.wearPerPart > 0.0);
        QTRY_VERIFY_WITH_TIMEOUT(m_bench->text("millingLastCut").contains(QStringLiteral("Cut 4")), 5'000);
        const QString lastCut = m_bench->text("millingLastCut");
        // What the recipe was before blank and law: told in words.
        QVERIFY(m_bench->press("millingSetup"));
        QVERIFY(m_bench->press("recipeHistory"));
        QTRY_VERIFY(m_bench->find<QTableWidget>("recipeRevisions") != nullptr);
        m_bench->find<QTableWidget>("recipeRevisions")->selectRow(2);
        const QString difference = m_bench->text("recipeDifference");
        QVERIFY2(difference.contains(QStringLiteral("Law: Preview → Model")), qPrintable(difference));
        QVERIFY2(difference.contains(QStringLiteral("Blank profile: ") + file), qPrintable(difference));
        for (int i = 0; i < 3; ++i) {
            QCoreApplication::sendPostedEvents();
            QCoreApplication::processEvents();
        }
        m_bench->console().window()->grab().save(QStringLiteral("milling_revisions.png"));
        QVERIFY(m_bench->press("sheetSafe"));
        restart();
        QTRY_COMPARE_WITH_TIMEOUT(milling().tool, before.tool, 10'000);
        QTRY_COMPARE_WITH_TIMEOUT(milling().law, MillingLaw::Preview, 10'000);
        QCOMPARE(milling().reference_N, 380.0);
        QCOMPARE(milling().wear, before.wear);
        QCOMPARE(milling().wearPerPart, before.wearPerPart);
        QCOMPARE(m_bench->text("millingLastCut"), lastCut);
        cutPart();  // the worn tool is still in the spindle
        QVERIFY(milling().wear > before.wear - 0.01);
        QCOMPARE(milling().partsWithTool, 5U);
        signOn();
        QTRY_VERIFY_WITH_TIMEOUT(enabled("millingNewTool"), 5'000);
        QVERIFY(m_bench->press("millingNewTool"));
        QVERIFY(m_bench->press("sheetProceed"));
        QTRY_COMPARE_WITH_TIMEOUT(milling().partsWithTool, 0U, 10'000);
        cutPart();
        QCOMPARE(milling().wear, 0.0);
    }
    void languageAndUnitSwitchWhileCutting() {
        start(kCutSpeed);
        ui::Look& look = m_bench->console().look();
        ui::Preferences preferences = look.preferences();
        preferences.language = ui::Language::Korean;
        preferences.length = ui::LengthUnit::Inch;
        look.apply(preferences);
        QVERIFY(milling().cutting);
        QTRY_VERIFY_WITH_TIMEOUT(buttonText("millingStart").contains(QStringLiteral("절삭")), 5'000);
        const auto& specs = m_bench->console().look().units().of("mm/s");
        QCOMPARE(specs.symbol, QStringLiteral("in/min"));
    }

 private:
    [[nodiscard]] std::vector<RoomRecordRow> records(const char* kind) {
        auto reader = db::DatabaseReader::open(m_bench->console().databasePath());
        const auto rows =
            reader ? (*reader)->roomRecords(ProcessId::Milling, kind, {}, 100) : Result<std::vector<RoomRecordRow>>();
        return rows ? *rows : std::vector<RoomRecordRow>();
    }
    [[nodiscard]] std::size_t setups() {
        auto reader = db::DatabaseReader::open(m_bench->console().databasePath());
        const auto rows = reader ? (*reader)->allRecipes(ProcessId::Milling) : Result<std::vector<RecipeRevision>>();
        return rows ? rows->size() : 0;
    }
    void restart() {
        m_bench->stop();
        openPage();
    }
    static void writeFile(const QString& name, const char* text) {
        QFile file(name);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(text);
    }

    std::unique_ptr<test::ConsoleBench> m_bench;
};

QTEST_MAIN(TestConsoleMilling)
#include "tst_console_milling.moc"
