// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QLineEdit>
#include <QTableView>
#include <QTableWidget>
#include <QTest>
#include <algorithm>
#include <memory>

#include "app/service/tapping/tapping_tuning_json.h"
#include "db/readers/database_reader.h"
#include "engine/machine/simulated/simulated_machine.h"
#include "tests/support/console_bench.h"
#include "tests/support/layout_check.h"
#include "tests/support/step.h"
#include "ui/widgets/value_field.h"

using namespace kerf;

/// Sheets that one meets once a shift or once a month, walked on the real console in both languages: earlier revisions
/// of every process, second person, people taken off, history of the alarms, handover, a backup put back.
/// KERF_SCREENSHOTS: a folder that keeps what was seen.
class TestConsoleSheets : public QObject {
    Q_OBJECT

    std::unique_ptr<test::ConsoleBench> m_bench;
    QTemporaryDir m_home;  ///< whose documents are offered as a place for files
    bool m_korean{false};

    ui::MainWindow& window() { return *m_bench->console().window(); }
    void start(const char* machine) {
        console::Options options;
        options.machine = machine;
        options.simulationSpeed = 20.0;
        start(options);
    }
    void start(console::Options options) {
        options.language = m_korean ? "ko" : "en";
        m_bench = std::make_unique<test::ConsoleBench>();
        m_bench->start(options);
        QTRY_VERIFY2_WITH_TIMEOUT(m_bench->up(), qPrintable(m_bench->failure()), 60'000);
    }
    void settle() {
        for (int i = 0; i < 4; ++i) {
            QCoreApplication::sendPostedEvents();
            QCoreApplication::processEvents();
        }
    }
    void look(const QString& what) {
        settle();
        for (const QSize size : {QSize(1920, 1080), QSize(1280, 800)}) {
            window().resize(size);
            settle();
            const QString name =
                what + (m_korean ? QStringLiteral("_ko_") : QStringLiteral("_en_")) + QString::number(size.width());
            if (const QString folder = qEnvironmentVariable("KERF_SCREENSHOTS"); !folder.isEmpty()) {
                window().grab().save(folder + u'/' + name + QStringLiteral(".png"));
            }
            const QStringList clipped = test::clippedTexts(&window());
            QVERIFY2(clipped.isEmpty(), qPrintable(name + u'\n' + clipped.join(u'\n')));
        }
    }
    void press(const char* name) { QVERIFY2(m_bench->press(name), qPrintable(m_bench->obstacle(name))); }
    void type(const char* name, const QString& text) {
        QTRY_VERIFY2(m_bench->find<QLineEdit>(name) != nullptr, name);
        m_bench->find<QLineEdit>(name)->setText(text);
    }
    /// Into one of the folders that are offered: the documents of the test's own home.
    void pressOwnFolder(const QString& prefix) {
        for (int i = 0; i < 20; ++i) {
            auto* button = m_bench->find<QAbstractButton>(qPrintable(prefix + QString::number(i)));
            if (button != nullptr && button->text().startsWith(m_home.path())) {
                QTest::mouseClick(button, Qt::LeftButton);
                return;
            }
        }
        QFAIL("the documents are not offered");
    }
    [[nodiscard]] QString asBefore() const {
        return m_korean ? QStringLiteral("이전 값이 나았음") : QStringLiteral("as before");
    }
    /// Every tuning that was kept, oldest first.
    [[nodiscard]] std::vector<RecipeRevision> tunings() {
        const auto reader = db::DatabaseReader::open(m_bench->console().databasePath());
        const auto rows = reader ? (*reader)->allRecipes(ProcessId::Tapping) : Result<std::vector<RecipeRevision>>();
        return rows ? *rows : std::vector<RecipeRevision>();
    }
    /// The revisions, from a sheet that offers them; the older one is put back.
    void walkRevisions(const char* page, int before, int row = 1) {
        KERF_STEP(press("recipeHistory"));
        QTRY_VERIFY(m_bench->find<QTableWidget>("recipeRevisions") != nullptr);
        auto* table = m_bench->find<QTableWidget>("recipeRevisions");
        QVERIFY2(table->rowCount() >= before, qPrintable(QString::number(table->rowCount())));
        const int rows = table->rowCount();
        table->selectRow(row);
        for (int i = 0; m_korean && i < rows; ++i) {  // whose words they are, they are Korean
            const QString why = table->item(i, 2)->text();
            QVERIFY2(std::ranges::any_of(why, [](QChar c) { return c.script() == QChar::Script_Hangul; }),
                     qPrintable(why));
        }
        const QString difference = m_bench->text("recipeDifference");
        QVERIFY2(difference.contains(QStringLiteral(" → ")), qPrintable(difference));
        QVERIFY2(!difference.contains(u'_'), qPrintable(difference));  // words, and no keys
        KERF_STEP(look(QStringLiteral("revisions_%1").arg(QLatin1String(page))));
        KERF_STEP(type("recipeReason", asBefore()));
        KERF_STEP(press("recipeRestore"));
        const auto said = [this] { return m_bench->text("recipeMessage") + u'|' + window().bottomLine(); };
        QTRY_VERIFY2(m_bench->find<QTableWidget>("recipeRevisions") != nullptr &&
                         m_bench->find<QTableWidget>("recipeRevisions")->rowCount() == rows + 1,
                     qPrintable(said()));
        KERF_STEP(look(QStringLiteral("revisions_%1_back").arg(QLatin1String(page))));
        KERF_STEP(press("sheetSafe"));
    }
    void typeInto(QLineEdit* field, const QString& figure) {
        QVERIFY(field != nullptr);
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, figure);
        QTRY_COMPARE(field->text(), figure);  // keys that could begin a gauge's frame are held back for a moment
    }
    QLineEdit* largestShift() {
        auto* field = m_bench->find<ui::ValueField>("thermalMaxShift");
        return field != nullptr ? field->edit() : nullptr;
    }

    void walkCentre() {
        KERF_STEP(start("simulator"));
        QVERIFY(window().session().signOn(QStringLiteral("Kim"), ui::Role::Engineer));
        window().showPage("thermal");
        KERF_STEP(press("thermalLimits"));
        QTRY_VERIFY(largestShift() != nullptr);
        KERF_STEP(typeInto(largestShift(), QStringLiteral("90")));
        KERF_STEP(type("thermalLimitsReason", m_korean ? QStringLiteral("새 공작물") : QStringLiteral("new part")));
        KERF_STEP(look(QStringLiteral("thermal_limits")));
        KERF_STEP(press("thermalLimitsUse"));
        QTRY_VERIFY(largestShift() == nullptr);  // it closes once it is stored
        KERF_STEP(press("thermalLimits"));
        QTRY_VERIFY(largestShift() != nullptr && largestShift()->text() == QStringLiteral("90"));
        KERF_STEP(walkRevisions("thermal", 2));
        QTRY_VERIFY(window().sheets().current() == nullptr);
        window().showPage("tapping");
        KERF_STEP(press("tappingJob"));
        KERF_STEP(look(QStringLiteral("tapping_job")));
        KERF_STEP(press("recipeHistory"));  // nothing has been tuned on this machine
        QTRY_VERIFY(m_bench->find("recipeDifference") != nullptr || m_bench->find("recipeRevisions") != nullptr);
        KERF_STEP(look(QStringLiteral("revisions_tapping")));
        KERF_STEP(press("sheetSafe"));
        QTRY_VERIFY(m_bench->find("jobApply") != nullptr);  // the form it was opened from
        window().sheets().current()->close();
    }
    void walkPeople() {
        ui::OperatorSession& session = window().session();
        QVERIFY(session.setPin(QStringLiteral("Kim"), QStringLiteral("2468")));
        QVERIFY(session.signOn(QStringLiteral("Lee"), ui::Role::Operator));
        QVERIFY(session.signOn(QStringLiteral("Kim"), ui::Role::Operator, QStringLiteral("2468")));
        session.setRole(QStringLiteral("Lee"), ui::Role::Setter);
        QVERIFY(session.setPin(QStringLiteral("Lee"), QStringLiteral("1357")));
        KERF_STEP(press("operator"));
        KERF_STEP(look(QStringLiteral("sign_on")));
        KERF_STEP(press("secondPerson"));
        KERF_STEP(look(QStringLiteral("second_person")));
        KERF_STEP(press("second0"));
        KERF_STEP(look(QStringLiteral("second_person_pin")));
        QVERIFY(m_bench->keyIn(QStringLiteral("1357")));
        QTRY_COMPARE(session.second(), QStringLiteral("Lee"));
        QTRY_VERIFY(m_bench->find("sheetSafe") != nullptr);  // it is said, not only done
        KERF_STEP(look(QStringLiteral("second_person_said")));
        KERF_STEP(press("sheetSafe"));
        KERF_STEP(press("operator"));
        KERF_STEP(press("people"));
        KERF_STEP(look(QStringLiteral("people")));
        int row = 0;
        while (m_bench->text(qPrintable(QStringLiteral("person%1").arg(row))) != QStringLiteral("Lee")) {
            QVERIFY(++row < 8);
        }
        KERF_STEP(press(qPrintable(QStringLiteral("personRemove%1").arg(row))));
        KERF_STEP(look(QStringLiteral("people_take_off")));
        KERF_STEP(press("sheetProceed"));
        QTRY_VERIFY(!session.known().contains(QStringLiteral("Lee")));
        KERF_STEP(look(QStringLiteral("people_without")));
        KERF_STEP(press("peoplePermissions"));
        KERF_STEP(look(QStringLiteral("people_rights")));
        KERF_STEP(press("sheetSafe"));
        if (m_bench->find("sheetSafe") != nullptr) {
            KERF_STEP(press("sheetSafe"));
        }
    }
    void walkAlarms() {
        window().showPage("alarms");
        InjectedFaults faults;
        faults.emergencyStop = true;
        m_bench->console().simulator()->machine().inject(faults);
        QTRY_VERIFY(m_bench->find<QTableView>("alarmTable") != nullptr &&
                    m_bench->find<QTableView>("alarmTable")->model()->rowCount() > 0);
        KERF_STEP(look(QStringLiteral("alarms_now")));
        m_bench->console().simulator()->machine().inject({});
        KERF_STEP(press("alarmsHistory"));
        QTRY_VERIFY(m_bench->find<QTableView>("alarmTable") != nullptr &&
                    m_bench->find<QTableView>("alarmTable")->model()->rowCount() > 0);
        KERF_STEP(look(QStringLiteral("alarms_history")));
        KERF_STEP(press("alarmFilter"));
        KERF_STEP(look(QStringLiteral("alarms_filtered")));
        KERF_STEP(press("alarmExport"));
        KERF_STEP(look(QStringLiteral("alarms_export")));
        KERF_STEP(pressOwnFolder(QStringLiteral("alarmFolder")));
        KERF_STEP(look(QStringLiteral("alarms_exported")));
        const QStringList files = filesOf(QStringLiteral("kerf_alarms_*.csv"));
        QCOMPARE(files.size(), 1);
        QFile file(files.front());
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(
            file.readAll().startsWith("\xEF\xBB\xBF"
                                      "code,priority,alarm"));
    }
    void walkShift() {
        window().showPage("shift");
        KERF_STEP(look(QStringLiteral("shift")));
        KERF_STEP(press("shiftNote"));
        KERF_STEP(
            type("shiftText", m_korean ? QStringLiteral("3번 인서트 교체함") : QStringLiteral("insert 3 is new")));
        KERF_STEP(look(QStringLiteral("shift_note")));
        KERF_STEP(press("shiftSave"));
        QTRY_VERIFY(window().sheets().current() == nullptr);
        KERF_STEP(press("shiftHandOver"));
        KERF_STEP(type("shiftText",
                       m_korean ? QStringLiteral("게이지 G-07 확인 필요") : QStringLiteral("look at gauge G-07")));
        KERF_STEP(look(QStringLiteral("shift_hand_over")));
        KERF_STEP(press("shiftSave"));
        QTRY_VERIFY(window().sheets().current() == nullptr);
        QTRY_VERIFY(m_bench->find<QAbstractButton>("shiftEarlier")->isEnabled());
        KERF_STEP(look(QStringLiteral("shift_new")));
        KERF_STEP(press("shiftEarlier"));
        KERF_STEP(look(QStringLiteral("shift_before")));
        KERF_STEP(press("shiftPdf"));
        KERF_STEP(look(QStringLiteral("shift_pdf")));
        KERF_STEP(pressOwnFolder(QStringLiteral("shiftFolder")));
        QTRY_COMPARE_WITH_TIMEOUT(filesOf(QStringLiteral("*.pdf")).size(), 1, 20'000);
    }
    void walkBackup() {
        window().showPage("diagnostics");
        KERF_STEP(press("backup"));
        KERF_STEP(look(QStringLiteral("backup")));
        KERF_STEP(pressOwnFolder(QStringLiteral("backupFolder")));
        QTRY_COMPARE_WITH_TIMEOUT(filesOf(QStringLiteral("kerf_2*.db")).size(), 1, 20'000);
        KERF_STEP(look(QStringLiteral("backed_up")));
        KERF_STEP(press("restore"));
        KERF_STEP(look(QStringLiteral("restore")));
        KERF_STEP(press("restoreFile0"));
        KERF_STEP(type("restoreReason", m_korean ? QStringLiteral("디스크 교체") : QStringLiteral("new disk")));
        KERF_STEP(look(QStringLiteral("restore_why")));
        KERF_STEP(press("restoreGo"));
        QTRY_VERIFY_WITH_TIMEOUT(m_bench->find("restoreEnd") != nullptr, 20'000);
        KERF_STEP(look(QStringLiteral("restore_ready")));
        KERF_STEP(press("sheetSafe"));
    }
    QStringList filesOf(const QString& pattern) {
        QStringList found;
        QDirIterator all(m_home.path(), {pattern}, QDir::Files, QDirIterator::Subdirectories);
        while (all.hasNext()) {
            found << all.next();
        }
        return found;
    }

 private slots:
    void initTestCase() { qputenv("HOME", m_home.path().toUtf8()); }
    void init() {
        QVERIFY(QDir(m_home.filePath(QStringLiteral("Documents"))).removeRecursively());
        QVERIFY(QDir(m_home.path()).mkpath(QStringLiteral("Documents")));
    }
    void cleanup() {
        if (m_bench) {
            m_bench->stop();
        }
    }
    void sheets_data() {
        QTest::addColumn<bool>("korean");
        QTest::newRow("en") << false;
        QTest::newRow("ko") << true;
    }
    void sheets() {
        QFETCH(bool, korean);
        m_korean = korean;
        for (const auto step :
             {&TestConsoleSheets::walkCentre, &TestConsoleSheets::walkPeople, &TestConsoleSheets::walkAlarms,
              &TestConsoleSheets::walkShift, &TestConsoleSheets::walkBackup}) {
            KERF_STEP((this->*step)());
        }
    }
    void turning_data() { sheets_data(); }
    void turning() {
        QFETCH(bool, korean);
        m_korean = korean;
        KERF_STEP(start("diamond-lathe"));
        QVERIFY(window().session().signOn(QStringLiteral("Kim"), ui::Role::Engineer));
        window().showPage("turning");
        m_bench->pause();  // what is live behind the sheets is another test's matter
        for (const char* to : {"0.8", "0.9"}) {
            KERF_STEP(press("turningSetup"));
            QTRY_VERIFY(m_bench->find<QLineEdit>("turningField5Edit") != nullptr);
            KERF_STEP(typeInto(m_bench->find<QLineEdit>("turningField5Edit"), QLatin1String(to)));
            KERF_STEP(look(QStringLiteral("turning_setup")));
            KERF_STEP(press("turningSetupApply"));
            QTRY_VERIFY(window().sheets().current() == nullptr);
        }
        KERF_STEP(press("turningSetup"));
        KERF_STEP(walkRevisions("turning", 2));
    }
    void tapping_data() { sheets_data(); }
    /// Two tunings of one thread, the first rolled back: what differs is told in the shop's words, and the first is in
    /// force again, with a reason.
    void tapping() {
        QFETCH(bool, korean);
        m_korean = korean;
        console::Options options;  // one bore is cut and waits for its gauge: the machine is free
        options.preparedParts = 0;
        options.lotSize = 1;
        options.simulationSpeed = 0.0;
        options.seed = 5;
        KERF_STEP(start(options));
        QVERIFY(window().session().signOn(QStringLiteral("Kim"), ui::Role::Engineer));
        QTRY_VERIFY_WITH_TIMEOUT(m_bench->service().awaiting.has_value(), 60'000);
        window().showPage("tapping");
        KERF_STEP(press("tappingAutomatic"));
        std::size_t kept = 0;
        for (const char* touch : {"tappingTune", "tappingRollBack", "tappingTune"}) {
            KERF_STEP(press(touch));
            ++kept;
            QTRY_COMPARE_WITH_TIMEOUT(tunings().size(), kept, 60'000);
        }
        const auto first = formats::tuningFromJson(tunings().front().parametersJson);
        QVERIFY(first.has_value());
        KERF_STEP(press("tappingJob"));
        KERF_STEP(walkRevisions("tapping", 3, 2));
        QTRY_VERIFY(window().sheets().current() == nullptr);  // what stood in the job's form holds no longer
        const std::vector<RecipeRevision> all = tunings();
        QCOMPARE(all.size(), std::size_t{4});
        QCOMPARE(all.back().restoredFrom.value_or(0), 1U);
        QCOMPARE(all.back().author, std::string("Kim"));
        QCOMPARE(QString::fromStdString(all.back().reason), asBefore());
        const std::uint32_t before = m_bench->status().tapping.taps;
        KERF_STEP(press("tappingTap"));
        QTRY_VERIFY_WITH_TIMEOUT(m_bench->status().tapping.taps > before, 20'000);
        QCOMPARE(m_bench->status().tapping.drive.zKp_perS, first->settings.zKp_perS);
    }
};

QTEST_MAIN(TestConsoleSheets)
#include "tst_console_sheets.moc"
