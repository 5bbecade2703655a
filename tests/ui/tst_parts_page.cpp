// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/fake_boring_service.h"
#include "tests/support/fake_part_reader.h"
#include "tests/support/layout_check.h"
#include "tests/support/page_bench.h"
#include "ui/pages/parts/parts_page.h"

using namespace kerf;
using namespace kerf::ui;
using kerf::test::FakeBoringService;
using kerf::test::FakePartReader;
using kerf::test::PageBench;

class TestPartsPage : public QObject {
    Q_OBJECT
 private slots:
    void init() {
        m_service = std::make_unique<FakeBoringService>();
        m_reader = std::make_unique<FakePartReader>(250);
        m_bench = std::make_unique<PageBench>();
        m_bench->services.boringService = m_service.get();
        m_bench->services.parts = m_reader.get();
    }
    void cleanup() {
        m_bench.reset();
        m_reader.reset();
        m_service.reset();
    }

    void theNewestPartsComeFirstAndTheOthersPageByPage() {
        show();
        QCOMPARE(model()->rowCount(), int(PartsModel::kPageSize));
        QCOMPARE(cell(0, 0), QStringLiteral("250"));
        model()->fetchMore({});
        model()->fetchMore({});
        QCOMPARE(model()->rowCount(), 250);
        QVERIFY(!model()->canFetchMore({}));
        QCOMPARE(cell(249, 0), QStringLiteral("1"));
        QVERIFY(text("partsCount").contains(QStringLiteral("250")));
    }
    void theSearchFollowsTyping() {
        m_reader->add(1, "77B");
        show();
        m_bench->find<QLineEdit>("partsSearch")->setText(QStringLiteral("77B"));
        QTRY_COMPARE(model()->rowCount(), 1);
        QVERIFY(text("partsCount").contains(QStringLiteral("1")));
        m_bench->find<QLineEdit>("partsSearch")->setText(QStringLiteral("nothing like it"));
        QTRY_COMPARE(model()->rowCount(), 0);
        QVERIFY(!text("partsCount").isEmpty());
    }
    void correctedAndTakenOutDiametersAreMarked() {
        PartDetail& part = m_reader->add(251);
        const MeasurementId first = part.part.measurements[0].id;
        const MeasurementId second = part.part.measurements[1].id;
        m_reader->measure(part, 0, 50.021, MeasurementKind::Correction, first, "read the wrong line");
        m_reader->measure(part, 1, std::nullopt, MeasurementKind::Void, second, "gauge not set");
        show();
        QVERIFY(cell(0, PartsModel::Diameters).contains(QStringLiteral("50.021")));
        QVERIFY(!cell(0, PartsModel::Diameters).contains(QStringLiteral("50.008")));
        QVERIFY(!cell(0, PartsModel::Changes).isEmpty());
        auto* history = m_bench->find<QTableWidget>("partMeasurements");
        QCOMPARE(history->rowCount(), 4);
        QVERIFY(history->item(0, 3)->text().contains(QStringLiteral("no longer holds")));
        QVERIFY(history->item(2, 3)->text().contains(QStringLiteral("read the wrong line")));
        QVERIFY(history->item(3, 3)->text().contains(QStringLiteral("gauge not set")));
    }
    void theDetailShowsScheduleAndCut() {
        show();
        auto* chart = m_bench->find<Chart>("partFeedChart");
        QCOMPARE(chart->drawn(1).size(), int(kFeedTracePoints));
        QVERIFY(!chart->drawn(0).isEmpty());
        QVERIFY(text("partFacts").contains(QStringLiteral("96 s")));
    }
    void aDiameterThatHoldsMayBeTakenOut() {
        show();
        QVERIFY(m_bench->press("partVoid"));
        QVERIFY(m_bench->press("measurementReason2"));
        QVERIFY(m_bench->press("measurementApply"));
        QCOMPARE(m_service->calls.back().what, std::string("void"));
        QCOMPARE(m_service->calls.back().id, m_reader->details.back().part.measurements.back().id);
    }
    void oneThatNoLongerHoldsMayNot() {
        PartDetail& part = m_reader->add(251);
        m_reader->measure(part, 0, 50.021, MeasurementKind::Correction, part.part.measurements[0].id, "x");
        show();
        m_bench->find<QTableWidget>("partMeasurements")->selectRow(0);
        auto* correct = m_bench->find<ActionButton>("partCorrect");
        QVERIFY(!correct->isEnabled());
        QVERIFY(!correct->reason().isEmpty());
        m_bench->find<QTableWidget>("partMeasurements")->selectRow(2);
        QVERIFY(correct->isEnabled());
    }
    void aNewPartAppearsByItself() {
        show();
        m_reader->add(251);
        m_service->cutPart();
        QCOMPARE(cell(0, 0), QStringLiteral("251"));
    }
    void aDatabaseThatCannotBeReadIsSaid() {
        m_reader->failWith = Sentence("The database is locked.");
        show();
        QVERIFY(text("partsCount").contains(QStringLiteral("The database is locked.")));
        m_reader->failWith = {};
        m_bench->find<QLineEdit>("partsSearch")->setText(QStringLiteral("12"));
        QTRY_VERIFY(model()->rowCount() > 0);
    }
    void unitsAreOnlyShown() {
        show();
        Preferences preferences;
        preferences.length = LengthUnit::Inch;
        m_bench->look.apply(preferences);
        QVERIFY(cell(0, PartsModel::Diameters).contains(QStringLiteral("1.9689")));
        QCOMPARE(m_reader->details.back().part.measurements[0].diameter_mm.value_or(0.0), 50.011);
    }
    void theExportIsWrittenOnAWorkerAndIsWholeOrNotThere() {
        QTemporaryDir folder;
        m_bench->services.openParts = [] { return std::make_unique<FakePartReader>(250); };
        show();
        QVERIFY(m_bench->press("partsExport"));
        const QString file = folder.filePath(QStringLiteral("new/parts.csv"));
        m_bench->find<QLineEdit>("exportFile")->setText(file);
        QVERIFY(m_bench->press("exportParts"));
        QTRY_VERIFY(!m_bench->notices.empty());
        QFile written(file);
        QVERIFY(written.open(QIODevice::ReadOnly));
        QCOMPARE(written.readAll().count('\n'), 501);  // a line of names, two depths per part
    }
    void anExportThatCannotBeWrittenSaysWhy() {
        m_bench->services.openParts = [] { return std::make_unique<FakePartReader>(3); };
        show();
        QVERIFY(m_bench->press("partsExport"));
        m_bench->find<QLineEdit>("exportFile")->setText(QStringLiteral("/proc/nowhere/parts.csv"));
        QVERIFY(m_bench->press("exportParts"));
        QTRY_VERIFY(!m_bench->notices.empty());
        QVERIFY(m_bench->notices.back().contains(QStringLiteral("folder")));
    }
    void withoutADatabaseThePageSaysSo() {
        m_bench->services.parts = nullptr;
        show();
        QVERIFY(m_bench->page->findChild<QLabel*>()->isVisible());
    }

    void everyTextFitsInEveryLook_data() {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<bool>("korean");
        QTest::newRow("1280x800 en") << QSize(1083, 670) << false;
        QTest::newRow("1280x800 ko") << QSize(1083, 670) << true;
        QTest::newRow("1920x1080 en") << QSize(1723, 950) << false;
        QTest::newRow("1920x1080 ko") << QSize(1723, 950) << true;
        QTest::newRow("3840x2160 en") << QSize(3640, 2030) << false;
    }
    void everyTextFitsInEveryLook() {
        QFETCH(QSize, size);
        QFETCH(bool, korean);
        Preferences preferences;
        preferences.language = korean ? Language::Korean : Language::English;
        preferences.brightness = korean ? Brightness::Dark : Brightness::Light;
        m_bench->look.apply(preferences);
        PartDetail& part = m_reader->add(251);
        m_reader->measure(part, 0, 50.021, MeasurementKind::Correction, part.part.measurements[0].id, "typed wrong");
        m_bench->show<PartsPage>(size);
        m_bench->save(QStringLiteral("parts_%1_%2.png").arg(size.width()).arg(korean ? "ko" : "en"));
        const QStringList problems =
            test::clippedTexts(m_bench->page) + test::smallTargets(m_bench->page, m_bench->look);
        QVERIFY2(problems.isEmpty(), qPrintable(problems.join(u'\n')));
        QVERIFY(m_bench->press("partVoid"));
        m_bench->save(QStringLiteral("parts_void_%1_%2.png").arg(size.width()).arg(korean ? "ko" : "en"));
        const QStringList inSheet = test::clippedTexts(m_bench->sheets->current()) +
                                    test::smallTargets(m_bench->sheets->current(), m_bench->look);
        QVERIFY2(inSheet.isEmpty(), qPrintable(inSheet.join(u'\n')));
    }

 private:
    void show() { m_bench->show<PartsPage>(); }
    [[nodiscard]] PartsModel* model() { return m_bench->page->findChild<PartsModel*>(); }
    [[nodiscard]] QString cell(int row, int column) {
        return model()->index(row, column).data(Qt::DisplayRole).toString();
    }
    [[nodiscard]] QString text(const char* name) {
        auto* label = m_bench->find<QLabel>(name);
        return label != nullptr ? label->text() : QString();
    }

    std::unique_ptr<FakeBoringService> m_service;
    std::unique_ptr<FakePartReader> m_reader;
    std::unique_ptr<PageBench> m_bench;
};

QTEST_MAIN(TestPartsPage)
#include "tst_parts_page.moc"
