// SPDX-License-Identifier: GPL-3.0-or-later
#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

#include "app/console/lot_report.h"
#include "app/service/quality/gauge_records.h"
#include "app/service/quality/quality_watch.h"
#include "app/service/quality/stored_quality_service.h"
#include "db/writer_thread.h"
#include "engine/api/quality_alarms.h"
#include "tests/db/db_test_support.h"
#include "tests/support/page_bench.h"
#include "ui/pages/parts/parts_page.h"
#include "ui/pages/quality/quality_page.h"

using namespace kerf;
using kerf::test::PageBench;

namespace {

constexpr db::WriterThread::Options kQuick{.queueCapacity = 64, .ringPoll_ms = 1, .retry_ms = 2};
constexpr std::uint32_t kParts = 45;
constexpr std::uint32_t kScrapPart = 5;
constexpr std::uint32_t kReworkPart = 8;

QString outputOf(const QString& program, const QStringList& arguments) {
    QProcess process;
    process.start(program, arguments);
    process.waitForFinished();
    return QString::fromUtf8(process.readAllStandardOutput());
}

}  // namespace

/// The Quality page on a data file: a lot with a scrap part, one that can be bored again and a tool that wears; gauges,
/// studies by keys, reports whose figures are the data file's, Q-DAS files by themselves, alarms.
class TestConsoleQuality : public QObject {
    Q_OBJECT
 private slots:
    void init() {
        m_scratch = std::make_unique<test::ScratchDatabase>();
        m_shop = std::make_unique<test::Shop>(m_scratch->path());
        for (std::uint32_t number = 1; number <= kParts; ++number) {
            cut(number);
        }
        m_reader = m_shop->reader();
        m_writer = std::make_unique<db::WriterThread>(m_scratch->path(), &m_ring, kQuick);
        QVERIFY(m_writer->start().has_value());
        openService();
        m_bench = std::make_unique<PageBench>();
        m_bench->services.qualityService = m_service.get();
        m_bench->services.lots = m_reader.get();
    }
    void cleanup() {
        m_bench.reset();
        m_writer->stop();
        m_service.reset();
        m_writer.reset();
        m_reader.reset();
        m_shop.reset();
        m_scratch.reset();
    }

    void theLotIsJudgedAndTheWearingToolNamed() {
        m_bench->show<ui::QualityPage>();
        QVERIFY2(text("qualityCounts").contains(QStringLiteral("43 good, 1 rework possible, 1 scrap, 0 not judged")),
                 qPrintable(text("qualityCounts")));
        QVERIFY2(text("qualitySentence").contains(QStringLiteral("the tool wears")),
                 qPrintable(text("qualitySentence")));
        QVERIFY2(text("qualityIndices").contains(QStringLiteral("Ppk")), qPrintable(text("qualityIndices")));
        QVERIFY(text("qualityGaugeNote").contains(QStringLiteral("typed in the recipe")));
        QVERIFY(!m_bench->find<ui::Chart>("qualityResiduals")->drawn(0).isEmpty());
        QCOMPARE(m_bench->find<ui::Chart>("qualityRaw")->drawn(0).size(), qsizetype(kParts));
        QCOMPARE(m_bench->find<QComboBox>("qualityCharacteristic")->count(), 2);
    }
    void aBadPartIsAcknowledgedWithWhatWasDone() {
        m_bench->show<ui::QualityPage>();
        QVERIFY(press("qualityDecide"));
        QVERIFY(m_bench->find<QPushButton>("decideReworked") == nullptr);  // the first one is scrap
        QVERIFY(press("decideScrapped"));
        QTRY_COMPARE(m_service->dispositions().size(), std::size_t{1});
        QVERIFY(press("qualityDecide"));
        QVERIFY(press("decideReworked"));
        QTRY_COMPARE(m_service->dispositions().size(), std::size_t{2});
        QTRY_VERIFY(!m_bench->find<ui::ActionButton>("qualityDecide")->isEnabled());
        const auto stored = m_reader->roomRecords(ProcessId::Boring, kDispositionRecord, {}, 10);
        QVERIFY(stored && stored->size() == 2);
        QCOMPARE(stored->back().author, std::string("Kim"));
        QVERIFY(stored->back().bodyJson.find("scrapped") != std::string::npos);
        openService();  // over a restart
        QCOMPARE(m_service->dispositions().size(), std::size_t{2});
    }
    void partsAreFoundByTheirVerdict() {
        m_bench->services.parts = m_reader.get();
        auto* page = m_bench->show<ui::PartsPage>();
        auto* model = page->findChild<ui::PartsModel*>();
        QCOMPARE(model->rowCount(), int(kParts));
        const auto verdict = [model](std::uint32_t number) {
            return model->index(int(kParts - number), ui::PartsModel::Verdict).data().toString();
        };
        QCOMPARE(verdict(kParts), QStringLiteral("good"));
        QCOMPARE(verdict(kScrapPart), QStringLiteral("scrap"));
        QCOMPARE(verdict(kReworkPart), QStringLiteral("rework possible"));
        QVERIFY(press("partsBad"));
        QCOMPARE(model->rowCount(), 2);
        QVERIFY2(text("partsCount").startsWith(QStringLiteral("2 ")), qPrintable(text("partsCount")));
        QVERIFY2(text("partFacts").contains(QStringLiteral("rework possible")), qPrintable(text("partFacts")));
    }
    void anOverdueGaugeIsSaidAndAStudyIsDoneByKeys() {
        m_bench->show<ui::QualityPage>();
        addGauge();
        QTRY_VERIFY(m_bench->find<QPushButton>("gauge_G-07") != nullptr);
        QVERIFY(m_bench->find<QPushButton>("gauge_G-07")->text().contains(QStringLiteral("overdue since 2020-01-31")));
        QTRY_VERIFY2(text("qualityGaugeNote").contains(QStringLiteral("G-07")), qPrintable(text("qualityGaugeNote")));
        QVERIFY(press("gauge_G-07"));
        QVERIFY(press("studyTypeOne"));
        auto* reading = m_bench->find<QLineEdit>("studyReading");
        QVERIFY(reading != nullptr);
        QTRY_VERIFY(m_bench->window.focusWidget() == reading);  // a gauge's keys go there
        type(reading, QStringLiteral("5"));                     // out of range: asked for again
        QVERIFY(text("studyPrompt").contains(QStringLiteral("range")));
        for (int i = 0; i < 25; ++i) {
            type(reading, QString::number(50.0 + (i % 5 - 2) * 0.0005, 'f', 4));
        }
        QVERIFY2(text("studyPrompt").contains(QStringLiteral("25")), qPrintable(text("studyPrompt")));
        QVERIFY(press("studySave"));
        QTRY_VERIFY(m_service->gauges().front().sigma_mm.has_value());
        QVERIFY(std::abs(*m_service->gauges().front().sigma_mm - 0.000721688) < 1e-8);
        QVERIFY(m_service->gauges().front().pass);
        QTRY_VERIFY(m_bench->find<QPushButton>("gauge_G-07") != nullptr);
        QTRY_VERIFY(m_bench->find<QPushButton>("gauge_G-07")->text().contains(QStringLiteral("good enough")));
        const auto study = m_reader->roomRecords(ProcessId::Boring, kStudyRecord, "G-07", 2);
        QVERIFY(study && study->size() == 1);
        QVERIFY(study->front().bodyJson.find("50.001") != std::string::npos);  // with what it was computed from
    }
    void theReportsFiguresAreTheDataFiles() {
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("lot.pdf"));
        std::optional<Result<void>> written;
        m_service->writeReport(m_shop->lot, false, file.toStdString(),
                               [&](const Result<void>& done) { written = done; });
        QVERIFY(written && written->has_value());
        const QString report = outputOf(QStringLiteral("pdftotext"), {"-layout", file, "-"});
        QVERIFY2(report.contains(QStringLiteral("43 good, 1 rework possible, 1 scrap")), qPrintable(report));
        QVERIFY(report.contains(QStringLiteral("49.985 to 50.015")));
        QVERIFY(report.contains(QStringLiteral("50.030")) && report.contains(QStringLiteral("49.970")));
        double sum_mm = 0.0;  // the mean of the first depth, from the data file
        const auto history = m_reader->history(m_shop->lot);
        for (const MeasurementRow& row : (*history)->measurements) {
            sum_mm += row.station == 0 ? row.diameter_mm.value_or(0.0) : 0.0;
        }
        QVERIFY(report.contains(QStringLiteral("mean %1").arg(sum_mm / kParts, 0, 'f', 3)));
        QVERIFY(report.contains(QStringLiteral("entry")) && report.contains(QStringLiteral("signature")));
        const QString attached = outputOf(QStringLiteral("pdfdetach"), {"-list", file});
        QVERIFY2(attached.contains(QStringLiteral("lot.dfq")) && attached.contains(QStringLiteral("lot.csv")),
                 qPrintable(attached));
        QVERIFY(outputOf(QStringLiteral("qpdf"), {"--check", file}).contains(QStringLiteral("No syntax or stream")));
        const QString first = folder.filePath(QStringLiteral("first.pdf"));
        m_service->writeReport(m_shop->lot, true, first.toStdString(),
                               [&](const Result<void>& done) { written = done; });
        const QString article = outputOf(QStringLiteral("pdftotext"), {"-layout", first, "-"});
        QVERIFY2(article.contains(QStringLiteral("First article")) && article.contains(QStringLiteral("1 parts")),
                 qPrintable(article));
        QVERIFY(!article.contains(QStringLiteral("Ppk")));
    }
    void badPartsAlarmAndEveryJudgedPartGetsAFile() {
        QTemporaryDir folder;
        std::vector<AlarmEvent> alarms;
        QualityWatch watch({m_scratch->path(), [](const auto& work, const auto& done) { done(work()); },
                            [&](const AlarmEvent& event) { alarms.push_back(event); },
                            [&] { return std::pair(folder.path().toStdString(), std::string("{lot}-{part}.DFQ")); }});
        watch.look({m_shop->lot});
        QVERIFY(alarms.empty() && QDir(folder.path()).isEmpty());  // what was there is known
        const PartId scrap = m_shop->addPart(kParts + 1);
        watch.look({m_shop->lot});
        QVERIFY(QDir(folder.path()).isEmpty());  // not measured yet
        measure(scrap, 0, 50.04);
        measure(scrap, 1, 50.0);
        watch.look({m_shop->lot});
        watch.look({m_shop->lot});
        QCOMPARE(std::ranges::count(alarms, quality_alarm::kOutOfTolerance, &AlarmEvent::code), 1);
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList{QStringLiteral("12-46.DFQ")});
        MeasurementRow fix = test::measured(scrap, 0, 50.001);
        fix.kind = MeasurementKind::Correction;
        fix.replaces = m_lastMeasurement - 1;
        fix.reason = "wrong line";
        (void)m_shop->must(AcceptMeasurement{fix, {}, {}});
        watch.look({m_shop->lot});
        QFile file(folder.filePath(QStringLiteral("12-46.DFQ")));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray bytes = file.readAll();
        QVERIFY2(bytes.contains("50.001") && bytes.contains("wrong line"), bytes.constData());
        watch.tellOverdue({{.identity = "G-07", .dueUtc_ms = 1}}, 2);
        watch.tellOverdue({{.identity = "G-07", .dueUtc_ms = 1}}, 3);
        QCOMPARE(std::ranges::count(alarms, quality_alarm::kGaugeOverdue, &AlarmEvent::code), 1);
    }
    void namesOfFilesAreThePlants() {
        LotRow lot;
        lot.name = "A/1";
        lot.partTypeName = "Sleeve 50";
        PartRow part;
        part.number = 7;
        QCOMPARE(*dfqFileName("{type}_{lot}_{part}.dfq", lot, part), std::string("Sleeve 50_A_1_7.dfq"));
        QCOMPARE(*dfqFileName("{part}", lot, part), std::string("7.dfq"));
        QVERIFY(!dfqFileName("{lot}.dfq", lot, part) && !dfqFileName("{nothing}{part}", lot, part) &&
                !dfqFileName("../{part}", lot, part));
    }
    void figuresOfOtherProcessesAreJudgedByTheirLimits() {
        PartRow tap;
        tap.process = ProcessId::Tapping;
        tap.figures = {{"tolerance_used_percent", 120.0}};
        QVERIFY(m_service->judge(tap).verdict == quality::Verdict::Scrap);
        PartRow face;
        face.process = ProcessId::Turning;
        face.figures = {{"surface_rms_um", 0.9}};
        QVERIFY(m_service->judge(face).verdict == quality::Verdict::NotJudged);
        std::optional<Result<void>> stored;
        m_service->setLimits(ProcessId::Turning, {{"surface_rms_um", {std::nullopt, 0.8, {}}}}, "Kim",
                             [&](const Result<void>& done) { stored = done; });
        QTRY_VERIFY(stored.has_value());
        QVERIFY(stored->has_value());
        QVERIFY(m_service->judge(face).verdict == quality::Verdict::Scrap);
    }

 private:
    void cut(std::uint32_t number) {
        PartRecord record = test::boringPart(number);
        record.schedule.revision = number;
        record.schedule.lnC += 0.01 * number;  // the feed falls: the controller works against the wear
        const PartId part = m_shop->must(AddPart{m_shop->lot, record, {}}).id;
        const double noise_mm = 0.002 * (static_cast<int>(number * 7 % 5) - 2);
        measure(part, 0, number == kScrapPart ? 50.03 : number == kReworkPart ? 49.97 : 50.0 + noise_mm);
        measure(part, 1, 50.0 - noise_mm);
    }
    void measure(PartId part, std::uint8_t station, double diameter_mm) {
        m_lastMeasurement = m_shop->must(AcceptMeasurement{test::measured(part, station, diameter_mm), {}, {}}).id;
    }
    /// Of several of that name (a sheet that is closed lives a little longer) the one that is shown.
    [[nodiscard]] bool press(const char* name) {
        QApplication::processEvents();
        QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        for (auto* button : m_bench->window.findChildren<QAbstractButton*>(QLatin1String(name))) {
            if (button->isVisible() && button->isEnabled()) {
                QTest::mouseClick(button, Qt::LeftButton);
                return true;
            }
        }
        return false;
    }
    void openService() {
        StoredQualityService::Links links{*m_writer, *m_reader, *m_reader, *m_reader, m_scratch->path(), {}, {}};
        links.background = [](const auto& work, const auto& done) { done(work()); };
        links.makeReport = [] {
            return [](const QualityLot& lot, const LotPapers& papers, const std::string& file) {
                return console::writeLotReport(lot, papers, {}, {}, QString::fromStdString(file));
            };
        };
        m_service = std::make_unique<StoredQualityService>(std::move(links));
    }
    void addGauge() {
        QVERIFY(press("qualityGauges"));
        QVERIFY(press("gaugeNew"));
        const std::pair<const char*, const char*> fields[] = {{"gaugeIdentity", "G-07"}, {"gaugeFrom", "40"},
                                                              {"gaugeTo", "60"},         {"gaugeResolution", "0.0005"},
                                                              {"gaugeRing", "50"},       {"gaugeDue", "2020-01-31"}};
        for (const auto& [name, value] : fields) {
            auto* edit = m_bench->find<QLineEdit>(name);
            QVERIFY2(edit != nullptr, name);
            edit->clear();
            QTest::keyClicks(edit, QString::fromLatin1(value));
        }
        QVERIFY(press("gaugeSave"));
    }
    static void type(QLineEdit* edit, const QString& text) {
        QTest::keyClicks(edit, text);
        QTest::keyClick(edit, Qt::Key_Return);
    }
    [[nodiscard]] QString text(const char* name) {
        auto* label = m_bench->find<QLabel>(name);
        return label == nullptr ? QString() : label->text();
    }

    SpscRing<PartRecord> m_ring{16};
    std::unique_ptr<test::ScratchDatabase> m_scratch;
    std::unique_ptr<test::Shop> m_shop;
    std::unique_ptr<db::DatabaseReader> m_reader;
    std::unique_ptr<db::WriterThread> m_writer;
    std::unique_ptr<StoredQualityService> m_service;
    std::unique_ptr<PageBench> m_bench;
    MeasurementId m_lastMeasurement{0};
};

QTEST_MAIN(TestConsoleQuality)
#include "tst_console_quality.moc"
