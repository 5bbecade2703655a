// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QLineEdit>
#include <QTableView>
#include <QTableWidget>
#include <QTest>
#include <memory>

#include "engine/machine/simulated/simulated_machine.h"
#include "tests/support/console_bench.h"
#include "tests/support/layout_check.h"
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
    void press(const char* name) { QVERIFY2(m_bench->press(name), name); }
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
    /// The revisions, from a sheet that offers them; the older one is put back.
    void walkRevisions(const char* page, int before) {
        press("recipeHistory");
        QTRY_VERIFY(m_bench->find<QTableWidget>("recipeRevisions") != nullptr);
        auto* table = m_bench->find<QTableWidget>("recipeRevisions");
        QVERIFY2(table->rowCount() >= before, qPrintable(QString::number(table->rowCount())));
        const int rows = table->rowCount();
        table->selectRow(1);
        look(QStringLiteral("revisions_%1").arg(QLatin1String(page)));
        type("recipeReason", m_korean ? QStringLiteral("이전 값이 나았음") : QStringLiteral("as before"));
        press("recipeRestore");
        const auto said = [this] { return m_bench->text("recipeMessage") + u'|' + window().bottomLine(); };
        QTRY_VERIFY2(m_bench->find<QTableWidget>("recipeRevisions") != nullptr &&
                         m_bench->find<QTableWidget>("recipeRevisions")->rowCount() == rows + 1,
                     qPrintable(said()));
        look(QStringLiteral("revisions_%1_back").arg(QLatin1String(page)));
        press("sheetSafe");
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
        start("simulator");
        QVERIFY(window().session().signOn(QStringLiteral("Kim"), ui::Role::Engineer));
        window().showPage("thermal");
        press("thermalLimits");
        QTRY_VERIFY(largestShift() != nullptr);
        typeInto(largestShift(), QStringLiteral("90"));
        type("thermalLimitsReason", m_korean ? QStringLiteral("새 공작물") : QStringLiteral("new part"));
        look(QStringLiteral("thermal_limits"));
        press("thermalLimitsUse");
        QTRY_VERIFY(largestShift() == nullptr);  // it closes once it is stored
        press("thermalLimits");
        QTRY_VERIFY(largestShift() != nullptr && largestShift()->text() == QStringLiteral("90"));
        walkRevisions("thermal", 2);
        QTRY_VERIFY(window().sheets().current() == nullptr);
        window().showPage("tapping");
        press("tappingJob");
        look(QStringLiteral("tapping_job"));
        press("recipeHistory");  // nothing has been tuned on this machine
        QTRY_VERIFY(m_bench->find("recipeDifference") != nullptr || m_bench->find("recipeRevisions") != nullptr);
        look(QStringLiteral("revisions_tapping"));
        press("sheetSafe");
    }
    void walkPeople() {
        ui::OperatorSession& session = window().session();
        QVERIFY(session.setPin(QStringLiteral("Kim"), QStringLiteral("2468")));
        QVERIFY(session.signOn(QStringLiteral("Lee"), ui::Role::Operator));
        QVERIFY(session.signOn(QStringLiteral("Kim"), ui::Role::Operator, QStringLiteral("2468")));
        session.setRole(QStringLiteral("Lee"), ui::Role::Setter);
        QVERIFY(session.setPin(QStringLiteral("Lee"), QStringLiteral("1357")));
        press("operator");
        look(QStringLiteral("sign_on"));
        press("secondPerson");
        look(QStringLiteral("second_person"));
        press("second0");
        look(QStringLiteral("second_person_pin"));
        QVERIFY(m_bench->keyIn(QStringLiteral("1357")));
        QTRY_COMPARE(session.second(), QStringLiteral("Lee"));
        QTRY_VERIFY(m_bench->find("sheetSafe") != nullptr);  // it is said, not only done
        look(QStringLiteral("second_person_said"));
        press("sheetSafe");
        press("operator");
        press("people");
        look(QStringLiteral("people"));
        int row = 0;
        while (m_bench->text(qPrintable(QStringLiteral("person%1").arg(row))) != QStringLiteral("Lee")) {
            QVERIFY(++row < 8);
        }
        press(qPrintable(QStringLiteral("personRemove%1").arg(row)));
        look(QStringLiteral("people_take_off"));
        press("sheetProceed");
        QTRY_VERIFY(!session.known().contains(QStringLiteral("Lee")));
        look(QStringLiteral("people_without"));
        press("peoplePermissions");
        look(QStringLiteral("people_rights"));
        press("sheetSafe");
        if (m_bench->find("sheetSafe") != nullptr) {
            press("sheetSafe");
        }
    }
    void walkAlarms() {
        window().showPage("alarms");
        InjectedFaults faults;
        faults.emergencyStop = true;
        m_bench->console().simulator()->machine().inject(faults);
        QTRY_VERIFY(m_bench->find<QTableView>("alarmTable") != nullptr &&
                    m_bench->find<QTableView>("alarmTable")->model()->rowCount() > 0);
        look(QStringLiteral("alarms_now"));
        m_bench->console().simulator()->machine().inject({});
        press("alarmsHistory");
        QTRY_VERIFY(m_bench->find<QTableView>("alarmTable") != nullptr &&
                    m_bench->find<QTableView>("alarmTable")->model()->rowCount() > 0);
        look(QStringLiteral("alarms_history"));
        press("alarmFilter");
        look(QStringLiteral("alarms_filtered"));
        press("alarmExport");
        look(QStringLiteral("alarms_export"));
        pressOwnFolder(QStringLiteral("alarmFolder"));
        look(QStringLiteral("alarms_exported"));
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
        look(QStringLiteral("shift"));
        press("shiftNote");
        type("shiftText", m_korean ? QStringLiteral("3번 인서트 교체함") : QStringLiteral("insert 3 is new"));
        look(QStringLiteral("shift_note"));
        press("shiftSave");
        QTRY_VERIFY(window().sheets().current() == nullptr);
        press("shiftHandOver");
        type("shiftText", m_korean ? QStringLiteral("게이지 G-07 확인 필요") : QStringLiteral("look at gauge G-07"));
        look(QStringLiteral("shift_hand_over"));
        press("shiftSave");
        QTRY_VERIFY(window().sheets().current() == nullptr);
        QTRY_VERIFY(m_bench->find<QAbstractButton>("shiftEarlier")->isEnabled());
        look(QStringLiteral("shift_new"));
        press("shiftEarlier");
        look(QStringLiteral("shift_before"));
        press("shiftPdf");
        look(QStringLiteral("shift_pdf"));
        pressOwnFolder(QStringLiteral("shiftFolder"));
        QTRY_COMPARE_WITH_TIMEOUT(filesOf(QStringLiteral("*.pdf")).size(), 1, 20'000);
    }
    void walkBackup() {
        window().showPage("diagnostics");
        press("backup");
        look(QStringLiteral("backup"));
        pressOwnFolder(QStringLiteral("backupFolder"));
        QTRY_COMPARE_WITH_TIMEOUT(filesOf(QStringLiteral("kerf_2*.db")).size(), 1, 20'000);
        look(QStringLiteral("backed_up"));
        press("restore");
        look(QStringLiteral("restore"));
        press("restoreFile0");
        type("restoreReason", m_korean ? QStringLiteral("디스크 교체") : QStringLiteral("new disk"));
        look(QStringLiteral("restore_why"));
        press("restoreGo");
        QTRY_VERIFY_WITH_TIMEOUT(m_bench->find("restoreEnd") != nullptr, 20'000);
        look(QStringLiteral("restore_ready"));
        press("sheetSafe");
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
            (this->*step)();
            if (QTest::currentTestFailed()) {
                m_bench->stop();
                return;
            }
        }
        m_bench->stop();
    }
    void turning_data() { sheets_data(); }
    void turning() {
        QFETCH(bool, korean);
        m_korean = korean;
        start("diamond-lathe");
        QVERIFY(window().session().signOn(QStringLiteral("Kim"), ui::Role::Engineer));
        window().showPage("turning");
        m_bench->pause();  // what is live behind the sheets is another test's matter
        for (const char* to : {"0.8", "0.9"}) {
            press("turningSetup");
            QTRY_VERIFY(m_bench->find<QLineEdit>("turningField5Edit") != nullptr);
            typeInto(m_bench->find<QLineEdit>("turningField5Edit"), QLatin1String(to));
            look(QStringLiteral("turning_setup"));
            press("turningSetupApply");
            QTRY_VERIFY(window().sheets().current() == nullptr);
        }
        press("turningSetup");
        walkRevisions("turning", 2);
        m_bench->stop();
    }
};

QTEST_MAIN(TestConsoleSheets)
#include "tst_console_sheets.moc"
