// SPDX-License-Identifier: GPL-3.0-or-later
#include <QComboBox>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <deque>
#include <nlohmann/json.hpp>

#include "app/console/lot_report.h"
#include "app/console/part_report.h"
#include "app/service/boring/boring_memory.h"
#include "app/service/quality/dfq_export.h"
#include "app/service/quality/gauge_records.h"
#include "app/service/quality/lot_dfq.h"
#include "app/service/quality/quality_watch.h"
#include "app/service/quality/stored_quality_service.h"
#include "db/writer_thread.h"
#include "engine/api/part_results.h"
#include "engine/api/quality_alarms.h"
#include "tests/db/db_test_support.h"
#include "tests/support/fake_boring_service.h"
#include "tests/support/page_bench.h"
#include "ui/pages/boring/boring_page.h"
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
    void aCrossedStudyIsDoneByKeys() {
        m_bench->show<ui::QualityPage>();
        addGauge();
        QTRY_VERIFY(m_bench->find<QPushButton>("gauge_G-07") != nullptr);
        QVERIFY(press("gauge_G-07"));
        QVERIFY(press("studyCrossed"));
        auto* reading = m_bench->find<QLineEdit>("studyReading");
        QVERIFY(reading != nullptr);
        QTRY_VERIFY(m_bench->window.focusWidget() == reading);
        const auto valueOf = [](std::uint32_t part, std::uint32_t person, std::uint32_t trial) {
            return 50.0 + 0.004 * part + 0.0005 * person + 0.0005 * ((7 * part + 3 * person + 5 * trial) % 4);
        };
        std::vector<quality::StudyReading> all;
        for (std::uint32_t person = 0; person < 3; ++person) {
            for (std::uint32_t trial = 0; trial < 2; ++trial) {
                for (std::uint32_t part = 0; part < 10; ++part) {
                    QCOMPARE(
                        text("studyPrompt"),
                        QStringLiteral("Person %1, trial %2: part %3").arg(person + 1).arg(trial + 1).arg(part + 1));
                    if (part == 4 && trial == 1) {  // a wrong one, taken back
                        type(reading, QStringLiteral("50.5"));
                        QVERIFY(press("studyUndo"));
                    }
                    if (part == 9) {
                        QVERIFY(press("studySave"));  // not yet
                        QVERIFY(!m_service->gauges().front().sigma_mm);
                        reading->setFocus();
                    }
                    const QString value = QString::number(valueOf(part, person, trial), 'f', 4);
                    type(reading, part % 2 == 0 ? value : QString(value).replace(u'.', u','));
                    all.push_back({part, person, trial, value.toDouble()});
                }
            }
        }
        QVERIFY(press("studySave"));
        QTRY_VERIFY(m_service->gauges().front().sigma_mm.has_value());
        const auto expected = quality::crossedStudy(all, quality::StudyMethod::Anova, 0.03);
        QVERIFY(expected.has_value());
        QCOMPARE(*m_service->gauges().front().sigma_mm, expected->ev);
        QCOMPARE(m_service->gauges().front().sigmaFrom, std::string("anova"));
        const auto study = m_reader->roomRecords(ProcessId::Boring, kStudyRecord, "G-07", 2);
        QVERIFY(study && study->size() == 1);
        const auto json = nlohmann::json::parse(study->front().bodyJson);
        QCOMPARE(json["readings"].size(), std::size_t{60});
        QCOMPARE(json["grr_mm"].get<double>(), expected->grr);
    }
    void aLongLotIsPagedThrough() {
        for (std::uint32_t number = kParts + 1; number <= 260; ++number) {
            cut(number);
        }
        m_bench->show<ui::QualityPage>();
        const auto shown = [this] {
            const auto points = m_bench->find<ui::Chart>("qualityRaw")->drawn(0);
            return points.isEmpty() ? std::pair(0, 0) : std::pair(int(points.front().x()), int(points.back().x()));
        };
        QCOMPARE(shown(), std::pair(161, 260));
        QVERIFY(!press("qualityNewer"));
        QVERIFY(press("qualityOlder"));
        QCOMPARE(shown(), std::pair(61, 160));
        QVERIFY(press("qualityOlder"));
        QCOMPARE(shown(), std::pair(1, 60));
        QVERIFY(!press("qualityOlder"));
        QVERIFY(press("qualityNewer"));
        QCOMPARE(shown(), std::pair(61, 160));
        QVERIFY(press("qualityNewer"));
        QCOMPARE(shown(), std::pair(161, 260));
        // What does not fit into one reading: the worker reads on from where the page stands.
        const auto some = readQualityLot(*m_reader, m_shop->lot, 50);
        QVERIFY(some && some->quality.olderParts && !some->quality.newerParts);
        QCOMPARE(some->quality.parts.front().number, 211U);
        const auto before = readQualityLot(*m_reader, m_shop->lot, 50, some->quality.parts.front().id - 1);
        QVERIFY(before && before->quality.olderParts && before->quality.newerParts);
        QCOMPARE(before->quality.parts.front().number, 161U);
        QCOMPARE(before->quality.parts.back().number, 210U);
        const auto first = readQualityLot(*m_reader, m_shop->lot, 260);
        QVERIFY(first && !first->quality.olderParts);
    }
    void partsAreLookedAtByToolPersonAndGauge() {
        (void)m_shop->must(AddRoomRecord{ProcessId::Boring,
                                         kChangeRecord,
                                         std::to_string(m_shop->lot),
                                         changeJson(21, boring::StretchKind::Insert),
                                         "Kim",
                                         {}});
        MeasurementRow by = test::measured(m_shop->addPart(kParts + 1), 0, 50.0);
        by.author = "Lee";
        by.source = MeasurementSource::Gauge;
        (void)m_shop->must(AcceptMeasurement{by, {}, {}});
        MeasurementRow other = test::measured(by.part, 1, 50.001);  // two gauges at one part
        other.author = "Lee";
        other.source = MeasurementSource::Gauge;
        other.sourceName = "G-07";
        (void)m_shop->must(AcceptMeasurement{other, {}, {}});
        const auto read = readQualityLot(*m_reader, m_shop->lot);
        const auto named = std::ranges::find(read->quality.groups, "G-07", &PartGroup::name);
        QVERIFY(named != read->quality.groups.end() && named->by == PartGroup::By::Source);
        QCOMPARE(named->capability[0].count, std::size_t{0});
        QCOMPARE(named->capability[1].count, std::size_t{1});
        const dfq::File file = lotDfq(read->history, read->quality);
        QVERIFY(file.find(4073, 1) != nullptr);
        QCOMPARE(*file.find(4073, 1), std::string("G-07"));
        const auto value = std::ranges::find_if(file.values, [](const auto& one) { return one.find(12) != nullptr; });
        QVERIFY(value != file.values.end() && *value->find(12) == "1" && *value->value == 50.001);
        QVERIFY(file.find(2401, 2) == nullptr);  // not all values of that bore came from it
        m_bench->show<ui::QualityPage>();
        auto* groups = m_bench->find<QComboBox>("qualityGroup");
        const auto choose = [groups](const char* name) {
            const int at = groups->findText(QString::fromUtf8(name));
            groups->setCurrentIndex(at);
            emit groups->activated(at);
            return at >= 0;
        };
        const auto points = [this] { return m_bench->find<ui::Chart>("qualityRaw")->drawn(0).size(); };
        QVERIFY(choose("tool from part 1"));
        QCOMPARE(points(), qsizetype(20));
        QVERIFY2(text("qualityIndices").startsWith(QStringLiteral("n 20")), qPrintable(text("qualityIndices")));
        QVERIFY(choose("tool from part 21"));
        QCOMPARE(points(), qsizetype(26));
        QVERIFY(choose("entered by Lee"));
        QCOMPARE(points(), qsizetype(1));
        QVERIFY(choose("entered by Kim"));
        QCOMPARE(points(), qsizetype(kParts));
        QVERIFY(choose("read from the gauge"));
        QCOMPARE(points(), qsizetype(1));
        QVERIFY(choose("read from gauge G-07"));
        QCOMPARE(points(), qsizetype(1));
        QVERIFY(choose("all parts"));
        QCOMPARE(points(), qsizetype(kParts + 1));
    }
    void severalLotsStandOneAfterTheOther() {
        const LotId second =
            m_shop->must(EnsureLot{m_shop->machine, m_shop->partType, m_shop->recipe, "13", 30, "kalman", "Lee"}).id;
        constexpr std::uint32_t kMore = 12;
        for (std::uint32_t number = 1; number <= kMore; ++number) {
            const PartId part = m_shop->must(AddPart{second, test::boringPart(number), {}}).id;
            (void)m_shop->must(AcceptMeasurement{test::measured(part, 0, 50.0 + 0.001 * (number % 3)), {}, {}});
            (void)m_shop->must(AcceptMeasurement{test::measured(part, 1, 50.0 + 0.001 * (number % 2)), {}, {}});
        }
        const auto all = readQualityLot(*m_reader, allLotsOf(m_shop->partType));
        QVERIFY2(all.has_value(), all ? "" : all.error().english().c_str());
        const LotQuality& quality = all->quality;
        QCOMPARE(quality.parts.size(), std::size_t{kParts + kMore});
        QCOMPARE(quality.parts.back().number, kParts + kMore);
        QCOMPARE(quality.groups.size(), std::size_t{2});
        QCOMPARE(quality.groups[1].name, std::string("13"));
        QCOMPARE(quality.groups[1].capability[0].count, std::size_t{kMore});
        QCOMPARE(quality.capability[0].count, std::size_t{kParts + kMore});
        const auto begins = std::ranges::count_if(quality.charted, &ChartedPart::announced);
        QCOMPARE(begins, std::ptrdiff_t{2});
        m_bench->show<ui::QualityPage>();
        auto* lots = m_bench->find<QComboBox>("qualityLot");
        const int at = lots->findText(QStringLiteral("Sleeve 50: all lots"));
        QVERIFY(at >= 0);
        lots->setCurrentIndex(at);
        emit lots->activated(at);
        QVERIFY2(text("qualitySentence").startsWith(QStringLiteral("2 lots")), qPrintable(text("qualitySentence")));
        QVERIFY(!m_bench->find<QAbstractButton>("qualityFiles")->isEnabled());
    }
    void anAnnouncedChangeIsNoSignal() {
        constexpr std::uint32_t kFrom = kParts + 1;
        for (std::uint32_t number = kFrom; number < kFrom + 8; ++number) {
            PartRecord record = test::boringPart(number);
            record.schedule.revision = number;
            const PartId part = m_shop->must(AddPart{m_shop->lot, record, {}}).id;
            measure(part, 0, 49.9);  // the new insert presses the bore open less
            measure(part, 1, 49.9);
        }
        const auto at = [&](const LotQuality& lot) {
            return *std::ranges::find(lot.charted, kFrom, &ChartedPart::number);
        };
        const auto untold = readQualityLot(*m_reader, m_shop->lot);
        QVERIFY(untold && at(untold->quality).point.fired.any() && !at(untold->quality).announced);
        (void)m_shop->must(AddRoomRecord{ProcessId::Boring,
                                         kChangeRecord,
                                         std::to_string(m_shop->lot),
                                         changeJson(kFrom, boring::StretchKind::Insert),
                                         "Kim",
                                         {}});
        const auto told = readQualityLot(*m_reader, m_shop->lot);
        QVERIFY(told && !at(told->quality).point.fired.any() && at(told->quality).announced);
        QVERIFY(std::abs(at(told->quality).error) < std::abs(at(untold->quality).error));
    }
    void sentencesNameTheRuleNotItsKey() {
        for (std::size_t i = 0; i < quality::kRules; ++i) {
            const char* words = quality::ruleText(static_cast<quality::Rule>(i));
            QCOMPARE(std::string(SentenceArg(std::string_view(words)).name.data()), std::string(words));  // fits
        }
        const auto read = readQualityLot(*m_reader, m_shop->lot);
        QVERIFY(read.has_value());
        const std::string said = read->quality.sentence.english();
        QVERIFY2(said.find("nelson") == std::string::npos && said.find("ewma") == std::string::npos, said.c_str());
    }
    void theGaugeAtHandIsNamedWithItsReadings() {
        test::FakeBoringService bores(
            30, {{"top", 40.0}, {"second", 100.0}, {"middle", 175.0}, {"fourth", 240.0}, {"bottom", 310.0}});
        bores.cutPart();
        m_bench->services.boringService = &bores;
        QStringList kept;
        m_bench->services.saveSetting = [&](const QString& key, const QString& value) { kept << key + u' ' + value; };
        std::deque<ui::GaugeLineFrame> line;
        m_bench->services.nextGaugeFrame = [&line]() -> std::optional<ui::GaugeLineFrame> {
            if (line.empty()) {
                return std::nullopt;
            }
            const ui::GaugeLineFrame next = line.front();
            line.pop_front();
            return next;
        };
        auto* page = m_bench->show<ui::BoringPage>();
        const auto readingTaken = [&] {
            page->entry()->takeGauge(*ui::parseGaugeFrame(QStringLiteral("50.011")));
            return bores.entries.back();
        };
        QCOMPARE(readingTaken().gauge, std::string());  // nothing is known of it
        m_service->saveGauge({.identity = "G-09", .rangeFrom_mm = 60, .rangeTo_mm = 80}, "Kim", {});
        m_service->saveGauge({.identity = "G-07", .rangeFrom_mm = 40, .rangeTo_mm = 60}, "Kim", {});
        QTRY_COMPARE(m_service->gauges().size(), std::size_t{2});
        auto* button = m_bench->find<QPushButton>("boringChannels");
        QTRY_COMPARE(button->text(), QStringLiteral("G-07"));  // the only one for such a bore
        QCOMPARE(readingTaken().gauge, std::string("G-07"));
        QVERIFY(bores.entries.back().fromGauge);
        m_service->saveGauge({.identity = "G-08", .rangeFrom_mm = 40, .rangeTo_mm = 60}, "Kim", {});
        QTRY_COMPARE(button->text(), QStringLiteral("Which gauge?"));
        QVERIFY(press("boringChannels"));
        auto* box = m_bench->find<QComboBox>("boringGauge0");
        QVERIFY(box != nullptr);
        const int at = box->findText(QStringLiteral("G-08"));
        box->setCurrentIndex(at);
        emit box->activated(at);
        QCOMPARE(button->text(), QStringLiteral("G-08"));
        QCOMPARE(readingTaken().gauge, std::string("G-08"));
        QCOMPARE(kept, QStringList{QStringLiteral("gauge.at_hand 0=G-08")});
        // A gauge on a serial line is who the sensor file says, where the register knows it.
        const auto sent = [&](const char* gauge) {
            line.push_back({QStringLiteral("+50.01100mm"), {}, gauge});
            (void)QTest::qWaitFor([&] { return m_bench->client.tick(), line.empty(); }, 5000);
            return bores.entries.back().gauge;
        };
        QCOMPARE(sent("G-07"), std::string("G-07"));
        QCOMPARE(sent("nobody's"), std::string("G-08"));
        // Of a switch each channel has its own, and what is typed has none.
        auto gauges = ui::GaugesAtHand::fromText(QStringLiteral("0=G-08;2=G%2D07;x=1;3"));
        QCOMPARE(gauges.of(2, m_service->gauges(), 50.0), std::string("G-07"));
        QCOMPARE(gauges.of(1, m_service->gauges(), 70.0), std::string("G-09"));
        QCOMPARE(gauges.text(), QStringLiteral("0=G-08;2=G-07"));
        m_bench.reset();  // the page goes before what it shows
    }
    void anOverdueGaugeIsSaidWhereItsReadingsAreEntered() {
        test::FakeBoringService bores;
        m_bench->services.boringService = &bores;
        auto* page = m_bench->show<ui::BoringPage>();
        auto* note = page->findChild<QLabel*>(QStringLiteral("boringGaugeDue"));
        QVERIFY(note != nullptr && note->isHidden());
        constexpr std::int64_t kLongAgo_ms = 1'500'000'000'000;
        m_service->saveGauge({.identity = "G-09", .rangeFrom_mm = 60, .rangeTo_mm = 80, .dueUtc_ms = kLongAgo_ms},
                             "Kim", {});
        m_service->saveGauge({.identity = "G-07", .rangeFrom_mm = 40, .rangeTo_mm = 60, .dueUtc_ms = kLongAgo_ms},
                             "Kim", {});
        QTRY_VERIFY(!note->isHidden());
        QVERIFY2(note->text().contains(QStringLiteral("G-07 is overdue since 2017-07-14")), qPrintable(note->text()));
        QVERIFY(!note->text().contains(QStringLiteral("G-09")));  // not for bores of this size
        Gauge checked = m_service->gauges().front();
        checked.dueUtc_ms = 0;
        m_service->saveGauge(checked, "Kim", {});
        QTRY_VERIFY(note->isHidden());
        m_bench.reset();  // the page goes before what it shows
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
        QVERIFY2(report.contains(QStringLiteral("Values: typed on the keypad: 90")), qPrintable(report));
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
        QVERIFY2(article.contains(QStringLiteral("First article")) && article.contains(QStringLiteral("Verdict: good")),
                 qPrintable(article));
        QVERIFY(!article.contains(QStringLiteral("Ppk")));
    }
    void theReportHoldsStudyCorrectionsDecisionsAndAlarms() {
        m_service->saveGauge(
            {.identity = "G-07", .rangeFrom_mm = 40, .rangeTo_mm = 60, .ring_mm = 50.0, .dueUtc_ms = 4'000'000'000'000},
            "Lee", {});
        QTRY_COMPARE(m_service->gauges().size(), std::size_t{1});
        GaugeStudyRecord study{"G-07", "type1", 0.03, {}, {}, 0};
        for (std::uint32_t i = 0; i < 25; ++i) {
            study.readings.push_back({0, 0, i, 50.0004 + (static_cast<int>(i % 5) - 2) * 0.0008});
        }
        std::optional<Result<void>> stored;
        m_service->saveStudy(study, "Lee", [&](const Result<void>& done) { stored = done; });
        QTRY_VERIFY(stored.has_value());
        m_service->dispose(scrapPart(), "scrapped", "Kim", [](const Result<void>&) {});
        QTRY_COMPARE(m_service->dispositions().size(), std::size_t{1});
        MeasurementRow fix = test::measured((*m_reader->history(m_shop->lot))->parts.back().part.id, 1, 50.0035);
        fix.kind = MeasurementKind::Correction;
        fix.replaces = m_lastMeasurement;
        fix.author = "Lee";
        fix.reason = "wrong line";
        (void)m_shop->must(AcceptMeasurement{fix, {}, {}});
        openService();  // what is shown comes from the data file
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("lot.pdf"));
        std::optional<Result<void>> written;
        m_service->writeReport(m_shop->lot, false, file.toStdString(),
                               [&](const Result<void>& done) { written = done; });
        QVERIFY(written && written->has_value());
        const QString report = outputOf(QStringLiteral("pdftotext"), {"-layout", file, "-"});
        for (const char* words :
             {"Cg 0.87, Cgk 0.75", "not good enough", "due on 2096-10-02", "scrapped, Kim", "50.004, Lee", "wrong line",
              "Verdicts: 43 good, 1 rework possible, 1 scrap", "Verdicts: 45 good"}) {
            QVERIFY2(report.contains(QString::fromLatin1(words)), qPrintable(QLatin1String(words) + u'\n' + report));
        }
    }
    void rulesThatAreOffFindNothing() {
        m_service->show(m_shop->lot);
        QTRY_VERIFY(m_service->shown() != nullptr && !m_service->shown()->found.empty());
        QVERIFY(m_service->rules() == quality::kDefaultRules);
        std::optional<Result<void>> stored;
        const auto keep = [&](const Result<void>& done) { stored = done; };
        m_service->setRules({}, "Kim", keep);
        QTRY_VERIFY(stored.has_value());
        QVERIFY(stored->has_value() && m_service->shown()->found.empty());
        QVERIFY(m_service->rules().none());
        stored.reset();
        m_service->setRules(quality::rules({quality::Rule::Nelson1, quality::Rule::Western1}), "Kim", keep);
        QTRY_VERIFY(stored.has_value());
        const auto& found = m_service->shown()->found;
        QVERIFY(std::ranges::any_of(found, [](const auto& one) { return one.rule == quality::Rule::Western1; }));
        QVERIFY(readQualityLot(*m_reader, m_shop->lot)->quality.found.size() ==
                found.size());  // alarms and reports too
        QCOMPARE(rulesText(rulesFromText("ewma,of_a_later_version,nelson2")), std::string("nelson2,ewma"));
    }
    /// KERF_REPORTS: a folder that keeps the files, to be looked at.
    void theReportIsKoreanOnAKoreanScreen() {
        QTemporaryDir scratch;
        const QString folder = qEnvironmentVariable("KERF_REPORTS", scratch.path());
        const ui::Preferences english = m_bench->look.preferences();
        ui::Preferences korean = english;
        korean.language = ui::Language::Korean;
        m_bench->look.apply(korean);
        std::optional<Result<void>> written;
        for (const bool first : {false, true}) {
            const QString file = folder + (first ? QStringLiteral("/first.pdf") : QStringLiteral("/lot.pdf"));
            m_service->writeReport(m_shop->lot, first, file.toStdString(),
                                   [&](const Result<void>& done) { written = done; });
            QVERIFY(written && written->has_value());
            const QString report = outputOf(QStringLiteral("pdftotext"), {"-layout", file, "-"});
            QVERIFY2(report.contains(first ? QStringLiteral("초품 검사")
                                           : QStringLiteral("공작물 45개: 양품 43, 재가공 가능 1, 폐기 1")),
                     qPrintable(report));
            QVERIFY(report.contains(QStringLiteral("날짜, 이름, 서명")));
        }
        m_bench->look.apply(english);
    }
    void theReportOfAPartHasToleranceVerdictAndGauge_data() {
        QTest::addColumn<ProcessId>("process");
        QTest::addColumn<bool>("korean");
        for (const ProcessId process :
             {ProcessId::Boring, ProcessId::Milling, ProcessId::Turning, ProcessId::Tapping}) {
            QTest::addRow("%s, en", processKey(process)) << process << false;
            QTest::addRow("%s, ko", processKey(process)) << process << true;
        }
    }
    void theReportOfAPartHasToleranceVerdictAndGauge() {
        QFETCH(ProcessId, process);
        QFETCH(bool, korean);
        const ui::Preferences before = m_bench->look.preferences();
        ui::Preferences preferences = before;
        preferences.language = korean ? ui::Language::Korean : ui::Language::English;
        m_bench->look.apply(preferences);
        PartDetail detail;
        if (process == ProcessId::Boring) {
            MeasurementRow row = test::measured(m_shop->addPart(kParts + 1), 0, 50.04);
            row.source = MeasurementSource::Gauge;
            row.sourceName = "G-07";
            (void)m_shop->must(AcceptMeasurement{row, {}, {}});
            detail = **m_reader->part(row.part);
        } else {
            detail.part.process = process;
            detail.part.number = 7;
            detail.part.figures = {{"waviness_um", 63.5}, {"surface_rms_um", 0.912}, {"tolerance_used_percent", 120.0}};
            std::erase_if(detail.part.figures, [process](const PartFigure& figure) {
                return findPartResult(process, figure.key) == nullptr;
            });
        }
        const std::vector<FigureLimit> limits{{process == ProcessId::Milling   ? "waviness_um"
                                               : process == ProcessId::Turning ? "surface_rms_um"
                                                                               : "tolerance_used_percent",
                                               {std::nullopt,
                                                process == ProcessId::Milling   ? 50.0
                                                : process == ProcessId::Turning ? 0.8
                                                                                : 100.0,
                                                quality::ReworkSide::None}}};
        const auto characteristics = process == ProcessId::Boring ? m_service->characteristics(detail.part)
                                                                  : characteristicsOf(process, {}, limits);
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("part.pdf"));
        QVERIFY(console::writePartReport(detail, characteristics, Disposition{"scrapped", "Kim", 1'800'000'000'000}, {},
                                         file));
        const QString report = outputOf(QStringLiteral("pdftotext"), {"-layout", file, "-"});
        m_bench->look.apply(before);
        QStringList words;
        words << (korean ? QStringLiteral("판정: 폐기") : QStringLiteral("Verdict: scrap"))
              << (korean ? QStringLiteral("조치: 폐기함, Kim") : QStringLiteral("Decided: scrapped, by Kim"));
        if (process == ProcessId::Boring) {
            words << QStringLiteral("50.040") << QStringLiteral("49.985") << QStringLiteral("50.015")
                  << QStringLiteral("G-07");
        } else if (process == ProcessId::Milling) {
            words << QStringLiteral("63.5") << QStringLiteral("50");
        } else if (process == ProcessId::Turning) {
            words << QStringLiteral("0.912") << QStringLiteral("0.800");
        } else {
            words << QStringLiteral("120") << QStringLiteral("100");
        }
        for (const QString& word : words) {
            QVERIFY2(report.contains(word), qPrintable(word + u'\n' + report));
        }
        QVERIFY2(!report.contains(QStringLiteral("lot \n")), qPrintable(report));
        QCOMPARE(outputOf(QStringLiteral("pdfinfo"), {file}).contains(QStringLiteral("Pages:           1")), true);
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
        const MeasurementId fixed = m_shop->must(AcceptMeasurement{fix, {}, {}}).id;
        watch.look({m_shop->lot});
        QFile file(folder.filePath(QStringLiteral("12-46.DFQ")));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray bytes = file.readAll();
        QVERIFY2(bytes.contains("50.001") && bytes.contains("wrong line"), bytes.constData());
        file.close();
        MeasurementRow out =
            test::measured(scrap, 0, 0.0);  // not judged any more, but the file must not stay as it was
        out.kind = MeasurementKind::Void;
        out.diameter_mm.reset();
        out.replaces = fixed;
        out.reason = "dirt";
        (void)m_shop->must(AcceptMeasurement{out, {}, {}});
        watch.look({m_shop->lot});
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray voided = file.readAll();
        QVERIFY2(voided.contains("50.001\x14"
                                 "255\x14") &&
                     voided.contains("dirt"),
                 voided.constData());
        watch.tellOverdue({{.identity = "G-07", .dueUtc_ms = 1}}, 2);
        watch.tellOverdue({{.identity = "G-07", .dueUtc_ms = 1}}, 3);
        QCOMPARE(std::ranges::count(alarms, quality_alarm::kGaugeOverdue, &AlarmEvent::code), 1);
    }
    void everyProcessTellsOfABadPartAsItComes() {
        (void)m_shop->must(AddRoomRecord{
            ProcessId::Milling, kFigureLimits, {}, limitsJson({{"waviness_um", {std::nullopt, 50.0, {}}}}), "Kim", {}});
        (void)m_shop->must(AddRoomRecord{ProcessId::Turning,
                                         kFigureLimits,
                                         {},
                                         limitsJson({{"surface_rms_um", {std::nullopt, 0.8, {}}}}),
                                         "Kim",
                                         {}});
        std::vector<AlarmEvent> alarms;
        QualityWatch watch({m_scratch->path(), [](const auto& work, const auto& done) { done(work()); },
                            [&](const AlarmEvent& event) { alarms.push_back(event); },
                            [] { return std::pair<std::string, std::string>{}; }});
        std::uint32_t sequence = 0;
        const auto cutOne = [&](ProcessId process, double waviness_um, double rms_um, double engagedPp_um) {
            PartRecord record;
            record.process = process;
            record.partSequence = ++sequence;
            record.begin_ns = sequence;
            record.end_ns = sequence + 1;
            record.complete = true;
            record.milling.waviness_um = waviness_um;
            record.turning.surfaceRms_um = rms_um;
            record.turning.valid = true;
            record.tap.job.allowedPp_um = 60.0;
            record.tap.figures.engagedPp_um = engagedPp_um;
            (void)m_shop->must(AddPart{{}, record, {}});
            watch.look({partsWithoutLot(process)});
        };
        for (const ProcessId process : {ProcessId::Milling, ProcessId::Turning, ProcessId::Tapping}) {
            watch.look({partsWithoutLot(process)});
            alarms.clear();
            cutOne(process, 20.0, 0.3, 30.0);
            QVERIFY2(alarms.empty(), processKey(process));
            cutOne(process, 300.0, 1.5, 300.0);
            QVERIFY2(std::ranges::count(alarms, quality_alarm::kOutOfTolerance, &AlarmEvent::code) == 1,
                     processKey(process));
            // … and it waits for what is done with it, as a bore does.
            m_service->show(partsWithoutLot(process));
            QTRY_COMPARE(m_service->shown()->lot.id, partsWithoutLot(process));
            const LotQuality& shown = *m_service->shown();
            QCOMPARE(shown.scrap, 1U);
            const auto bad = std::ranges::find(shown.parts, quality::Verdict::Scrap,
                                               [](const LotPart& part) { return part.judgement.verdict; });
            QVERIFY(bad != shown.parts.end());
            m_service->dispose(bad->id, "scrapped", "Kim", [](const Result<void>&) {});
            QTRY_VERIFY(m_service->dispositions().contains(bad->id));
            const auto kept = m_reader->roomRecords(process, kDispositionRecord, std::to_string(bad->id), 2);
            QVERIFY(kept && kept->size() == 1 && kept->front().author == "Kim");
        }
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
    void aFileOfAnotherPartIsNeverOverwritten() {
        QTemporaryDir folder;
        const std::string to = folder.path().toStdString();
        QualityLot lot = *readQualityLot(*m_reader, m_shop->lot);
        const PartRow first = lot.history.parts.front().part;
        const auto name = [](const Result<std::string>& file) {
            return file ? QFileInfo(QString::fromStdString(*file)).fileName() : QString();
        };
        QCOMPARE(name(exportPart(lot, first, to, "{part}")), QStringLiteral("1.dfq"));
        QCOMPARE(name(exportPart(lot, first, to, "{part}")), QStringLiteral("1.dfq"));  // corrected, after a restart
        QualityLot next = lot;                                                          // part 1 of the next lot
        next.history.lot.name = "13";
        next.history.parts.front().part.lotName = "13";
        const PartRow other = next.history.parts.front().part;
        const auto second = exportPart(next, other, to, "{part}");
        QCOMPARE(name(second), QStringLiteral("1_2.dfq"));
        QCOMPARE(name(exportPart(next, other, to, "{part}")), QStringLiteral("1_2.dfq"));
        next.history.parts.front().part.serial = "S-1";  // known by its number until now
        QCOMPARE(name(exportPart(next, next.history.parts.front().part, to, "{part}", *second)),
                 QStringLiteral("1_2.dfq"));
        QFile theirs(folder.filePath(QStringLiteral("2.dfq")));  // of the plant
        QVERIFY(theirs.open(QIODevice::WriteOnly) && theirs.write("mine") == 4);
        theirs.close();
        QCOMPARE(name(exportPart(lot, lot.history.parts[1].part, to, "{part}")), QStringLiteral("2_2.dfq"));
        QCOMPARE(theirs.size(), 4);
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 4);  // no half-written one left
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
        face.endedUtc_ms = QDateTime::currentMSecsSinceEpoch();
        QVERIFY(m_service->judge(face).verdict == quality::Verdict::NotJudged);
        QVERIFY(!setLimits(ProcessId::Turning, {{"surface_rms_um", {std::nullopt, 0.8, {}}}}, ""));  // why?
        QVERIFY(!setLimits(ProcessId::Turning, {{"surface_rms_um", {0.8, 0.8, {}}}}, "drawing A"));
        QVERIFY(!setLimits(ProcessId::Turning, {{"waviness_um", {std::nullopt, 0.8, {}}}}, "drawing A"));
        nextMillisecond();  // the limits are younger than the part above
        QVERIFY(setLimits(ProcessId::Turning, {{"surface_rms_um", {std::nullopt, 0.8, {}}}}, "drawing A"));
        QVERIFY(m_service->judge(face).verdict == quality::Verdict::NotJudged);  // it was made without any
        PartRow next = face;
        next.endedUtc_ms = QDateTime::currentMSecsSinceEpoch();
        QVERIFY(m_service->judge(next).verdict == quality::Verdict::Scrap);
        // A wider limit is another revision: it is of the parts to come.
        nextMillisecond();
        QVERIFY(setLimits(ProcessId::Turning, {{"surface_rms_um", {std::nullopt, 1.0, {}}}}, "drawing B"));
        QVERIFY(m_service->judge(next).verdict == quality::Verdict::Scrap);
        PartRow last = face;
        last.endedUtc_ms = QDateTime::currentMSecsSinceEpoch();
        QVERIFY(m_service->judge(last).verdict == quality::Verdict::Good);
        QCOMPARE(*m_service->limits(ProcessId::Turning).front().tolerance.upper, 1.0);
        const auto known = m_reader->allRecipes(ProcessId::Turning);
        QVERIFY(known && known->size() == 3);  // what it worked by, and two of limits
        QCOMPARE(known->back().reason, std::string("drawing B"));
        QCOMPARE(known->back().author, std::string("Kim"));
        QCOMPARE(known->back().parametersJson,
                 std::string(R"({"depth":2.50,"figure_limits":{"surface_rms_um":{"upper":1.0,"rework":"none"}}})"));
        QVERIFY(m_reader->verifyAudit()->finding.empty());
    }
    void limitsGoWithTheRecipe() {
        const auto keep = [&](const std::string& parameters, std::optional<std::uint32_t> from = {}) {
            (void)m_shop->must(KeepRecipe{ProcessId::Milling, "Bracket", parameters, "Lee", "setup", from});
            return m_reader->newestRecipes(ProcessId::Milling)->back().parametersJson;
        };
        (void)m_shop->must(AddRoomRecord{ProcessId::Milling, kPartTypeRecord, "Bracket", "{}", "Kim", "chosen"});
        QCOMPARE(keep(R"({"feed":1.50})"), std::string(R"({"feed":1.50})"));  // to the digit, without limits
        const std::string limits = R"("figure_limits":{"waviness_um":{"upper":50.0,"rework":"none"}})";
        QCOMPARE(keep('{' + limits + '}'), R"({"feed":1.50,)" + limits + '}');   // limits alone: the rest stays
        QCOMPARE(keep(R"({"feed":2.0})"), R"({"feed":2.0,)" + limits + '}');     // another setup: they go along
        QCOMPARE(keep(R"({"feed":1.50})", 1), std::string(R"({"feed":1.50})"));  // back to when there were none
        QCOMPARE(keep(R"({"feed":2.0})", 3), R"({"feed":2.0,)" + limits + '}');  // … and to when there were
        QCOMPARE(keep(R"({"figure_limits":{}})"), std::string(R"({"feed":2.0,"figure_limits":{}})"));
        QVERIFY(m_reader->verifyAudit()->finding.empty());
        const RecipeLimits all = recipeLimits(*m_reader, *m_reader, ProcessId::Milling);
        QVERIFY(all.inForce.empty());
        QCOMPARE(all.revisions.size(), std::size_t{7});  // chosen, and six revisions
        PartRow part;
        part.process = ProcessId::Milling;
        part.endedUtc_ms = all.revisions[2].from_ms;
        // Revisions of the same millisecond: the last one holds.
        QVERIFY(all.revisionOf(part) >= 2);
        // One that says what it was cut with: that, whenever it ended.
        const auto revisions = m_reader->allRecipes(ProcessId::Milling);
        QVERIFY(revisions && revisions->size() == 6);
        for (const RecipeRevision& revision : *revisions) {
            part.recipe = revision.id;
            QCOMPARE(all.revisionOf(part), revision.revision);
            QCOMPARE(all.of(part).empty(), revision.parametersJson.find("waviness_um") == std::string::npos);
        }
    }
    void aLimitOfBeforeHoldsUntilARecipeHasOne() {
        (void)m_shop->must(AddRoomRecord{ProcessId::Turning,
                                         kFigureLimits,
                                         {},
                                         limitsJson({{"surface_rms_um", {std::nullopt, 0.8, {}}}}),
                                         "Kim",
                                         {}});
        PartRow old;
        old.process = ProcessId::Turning;
        old.figures = {{"surface_rms_um", 0.9}};
        old.endedUtc_ms = QDateTime::currentMSecsSinceEpoch();
        QVERIFY(m_service->judge(old).verdict == quality::Verdict::Scrap);
        (void)m_shop->must(KeepRecipe{ProcessId::Turning, "Face", R"({"depth":2.5})", "Lee", "setup", {}});
        PartRow next = old;
        next.id = 1'000'000;
        next.endedUtc_ms += 60'000;
        QVERIFY(m_service->judge(next).verdict == quality::Verdict::Scrap);  // that revision says none of its own
        QCOMPARE(*m_service->limits(ProcessId::Turning).front().tolerance.upper, 0.8);
    }
    void eachThreadHasItsOwnLimits() {
        const auto work = [&](const char* thread) {
            nextMillisecond();
            (void)m_shop->must(AddRoomRecord{ProcessId::Tapping, kPartTypeRecord, thread, "{}", "Kerf", "chosen"});
        };
        const auto tap = [&](double used_percent) {
            nextMillisecond();
            PartRow row;
            row.process = ProcessId::Tapping;
            row.id = ++m_tap;
            row.figures = {{"tolerance_used_percent", used_percent}};
            row.endedUtc_ms = QDateTime::currentMSecsSinceEpoch();
            return row;
        };
        work("M8");
        const PartRow first = tap(90.0);
        nextMillisecond();
        (void)m_shop->must(KeepRecipe{ProcessId::Tapping, "M8", R"({"not_tuned":true})", "Kerf", "begun", {}});
        (void)m_shop->must(KeepRecipe{ProcessId::Tapping,
                                      "M8",
                                      R"({"figure_limits":{"tolerance_used_percent":{"upper":80.0}}})",
                                      "Lee",
                                      "4H",
                                      {}});
        const PartRow second = tap(90.0);
        work("M10");
        const PartRow third = tap(90.0);
        work("M8");
        const PartRow fourth = tap(90.0);
        QCOMPARE(m_service->judge(first).verdict, quality::Verdict::Good);  // 6H, as ever
        QCOMPARE(m_service->judge(second).verdict, quality::Verdict::Scrap);
        QCOMPARE(m_service->judge(third).verdict, quality::Verdict::Good);  // another thread
        QCOMPARE(m_service->judge(fourth).verdict, quality::Verdict::Scrap);
    }

 private:
    /// What follows is later than what was stored.
    static void nextMillisecond() {
        const qint64 now_ms = QDateTime::currentMSecsSinceEpoch();
        while (QDateTime::currentMSecsSinceEpoch() == now_ms) {
        }
    }
    Result<void> setLimits(ProcessId process, const std::vector<FigureLimit>& limits, const char* reason) {
        std::optional<Result<void>> stored;
        m_service->setLimits(process, limits, "Kim", reason, [&](const Result<void>& done) { stored = done; });
        if (!QTest::qWaitFor([&] { return stored.has_value(); })) {
            qFatal("no answer");
        }
        return *stored;
    }
    void cut(std::uint32_t number) {
        PartRecord record = test::boringPart(number);
        record.schedule.revision = number;
        record.schedule.lnC += 0.01 * number;  // the feed falls: the controller works against the wear
        const PartId part = m_shop->must(AddPart{m_shop->lot, record, {}}).id;
        const double noise_mm = 0.002 * (static_cast<int>(number * 7 % 5) - 2);
        measure(part, 0, number == kScrapPart ? 50.03 : number == kReworkPart ? 49.97 : 50.0 + noise_mm);
        measure(part, 1, 50.0 - noise_mm);
    }
    [[nodiscard]] PartId scrapPart() { return (*m_reader->history(m_shop->lot))->parts[kScrapPart - 1].part.id; }
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
        links.recipe = [](ProcessId process) {
            return process == ProcessId::Turning ? RecipeHeld{"Face", R"({"depth":2.50})"} : RecipeHeld{};
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
    PartId m_tap{0};
};

QTEST_MAIN(TestConsoleQuality)
#include "tst_console_quality.moc"
