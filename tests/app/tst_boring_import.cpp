// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <QCoreApplication>
#include <QFile>
#include <QTest>
#include <cmath>

#include "app/service/boring/bore_file.h"
#include "app/service/boring/boring_lots.h"
#include "db/writer_thread.h"
#include "engine/process/boring/plant.h"
#include "tests/db/db_test_support.h"
#include "tests/support/fake_engine.h"

using namespace kerf;

namespace {

constexpr db::WriterThread::Options kQuick{.queueCapacity = 64, .ringPoll_ms = 1, .retry_ms = 2};
constexpr const char* kFile = "gauge station 3.csv";

template <class Condition>
void waitUntil(const Condition& happened) {
    while (!happened()) {
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
}

/// A lot whose parts are cut and wait for their diameters.
class Bench {
 public:
    explicit Bench(std::uint32_t parts) {
        m_writer = std::make_unique<db::WriterThread>(m_scratch.path(), &m_ring, kQuick);
        if (!m_writer->start()) {
            qFatal("no database");
        }
        open();
        for (std::uint32_t part = 1; part <= parts; ++part) {
            PartRecord record;
            record.partSequence = part;
            record.begin_ns = part * 60'000'000'000LL;
            record.end_ns = record.begin_ns + 40'000'000'000LL;
            record.schedule = view().nextSchedule;
            record.order.lot = m_reader->activeLot(ProcessId::Boring)->value();
            m_schedule = record.schedule;
            QVERIFY(m_ring.tryPush(record));
            waitUntil([&] { return view().parts.size() == part; });
        }
    }
    ~Bench() {
        lots.reset();
        m_reader.reset();
        m_writer->stop();
    }
    void open() {
        lots.reset();
        m_reader = std::move(*db::DatabaseReader::open(m_scratch.path()));
        StoredBoringService::Links links{*m_writer, engine, {}, [] { return LoopMode::Control; }};
        BoringLotRequest first{"VB-1", "simulator", "Sleeve 50", BoringRecipe{}, "1", 30, boring::EstimatorKind::Kalman,
                               "Lee"};
        lots = std::make_unique<StoredBoringLots>(links, *m_reader, first);
        QVERIFY(wait([&](const auto& done) { lots->start(done); }).has_value());
    }
    [[nodiscard]] CurrentBoringService& service() { return lots->service(); }
    [[nodiscard]] const BoringServiceView& view() { return service().view(); }
    Result<void> wait(const std::function<void(BoringLots::Done)>& call) {
        std::optional<Result<void>> result;
        call([&](const Result<void>& answer) { result = answer; });
        waitUntil([&] { return result.has_value(); });
        return *result;
    }
    Result<void> take(const ReadBores& read, bool confirmed = false, const char* author = "Kim") {
        return wait([&](const auto& done) { service().importBores(read, author, confirmed, done); });
    }
    /// What a good gauge reads there.
    [[nodiscard]] double true_mm(std::uint32_t part, std::uint8_t depth) {
        const double overhang_mm = view().depths[depth].overhang_mm;
        const boring::LawConstants law{boring::TruthPlan::table().at(1)};
        const double d_mm = boring::deflection_mm(law, m_schedule.feed_mmPerRev(overhang_mm), overhang_mm);
        const double bore_mm =
            boring::diameterFromDeflection_mm(d_mm, 50.0, boring::kTableTargetDeflection_mm, boring::kTablePhi_deg);
        return std::round((bore_mm + 0.001 * ((part * 7 + depth * 3) % 5)) * 1000.0) / 1000.0;
    }
    [[nodiscard]] std::vector<MeasurementRow> stored() {
        return (*m_reader->history(m_reader->activeLot(ProcessId::Boring)->value()))->measurements;
    }
    [[nodiscard]] std::string lastState() {
        const auto history = *m_reader->history(m_reader->activeLot(ProcessId::Boring)->value());
        return history->lastState ? history->lastState->stateJson : std::string();
    }
    [[nodiscard]] AuditVerdict verified() { return *m_reader->verifyAudit(); }

    test::FakeEngine engine;
    std::unique_ptr<StoredBoringLots> lots;

 private:
    test::ScratchDatabase m_scratch;
    SpscRing<PartRecord> m_ring{64};
    std::unique_ptr<db::WriterThread> m_writer;
    std::unique_ptr<db::DatabaseReader> m_reader;
    BoringSchedule m_schedule;
};

/// As a German spreadsheet writes it, in no order.
QByteArray tableOf(Bench& bench, std::uint32_t parts) {
    std::string text = "Bediener;diameter [mm];part;overhang (mm)\r\n";
    for (std::uint32_t part = parts; part >= 1; --part) {
        for (std::uint8_t depth = 0; depth < bench.view().depths.size(); ++depth) {
            std::string row = fmt::format("Kim;{:.3f};{};{:.1f}\r\n", bench.true_mm(part, depth), part,
                                          bench.view().depths[depth].overhang_mm);
            std::ranges::replace(row, '.', ',');
            text += row;
        }
    }
    return QByteArray::fromStdString(text);
}

ReadBores read(const QByteArray& bytes) {
    QTemporaryDir folder;
    const QString path = folder.filePath(QString::fromUtf8(kFile));
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) {
        qFatal("no file");
    }
    file.close();
    return readBores(path.toStdString());
}

}  // namespace

/// A file of diameters into the open lot: all or nothing, by the same gate as what is typed.
class TestBoringImport : public QObject {
    Q_OBJECT
 private slots:
    void aFileIsTakenAsIfItHadBeenTyped() {
        Bench typed(3);
        for (std::uint32_t part = 1; part <= 3; ++part) {
            for (std::uint8_t depth = 0; depth < 2; ++depth) {
                BoreEntry entry{typed.view().parts[part - 1].id, depth, typed.true_mm(part, depth), "Kim"};
                QVERIFY(typed.wait([&](const auto& done) { typed.service().enter(entry, done); }).has_value());
            }
        }
        Bench bench(3);
        const ReadBores bores = read(tableOf(bench, 3));
        QCOMPARE(bores.problem, std::string());
        QCOMPARE(bores.file, std::string(kFile));
        const BoreImportPlan plan = bench.service().planImport(bores);
        QVERIFY(!plan.refused);
        QVERIFY(plan.questions.empty());
        QCOMPARE(plan.rows.size(), std::size_t{6});
        QCOMPARE(plan.rows.front().partNumber, 1U);
        QVERIFY(bench.stored().empty());  // saying it takes nothing
        QVERIFY(bench.take(bores).has_value());
        const auto rows = bench.stored();
        QCOMPARE(rows.size(), std::size_t{6});
        for (const MeasurementRow& row : rows) {
            QVERIFY(row.source == MeasurementSource::File);
            QCOMPARE(row.sourceName, std::string(kFile));
            QCOMPARE(row.author, std::string("Kim"));
            QVERIFY(!row.confirmed);
        }
        QCOMPARE(bench.lastState(), typed.lastState());
        QVERIFY(sameLaw(bench.view().nextSchedule, typed.view().nextSchedule));
        QVERIFY(!bench.view().awaiting);
        QVERIFY(bench.verified().finding.empty());
        // The same again is nothing new; and a restart computes the same.
        QCOMPARE(bench.service().planImport(bores).known, 6U);
        QVERIFY(!bench.take(bores).has_value());
        const std::string before = bench.lastState();
        bench.open();
        QVERIFY(bench.service().stored().restartFinding().empty());
        QCOMPARE(bench.lastState(), before);
        // What came from a file is undone and corrected like any other value.
        QVERIFY(bench.wait([&](const auto& done) { bench.service().undoLast("Kim", done); }).has_value());
        QVERIFY(bench.stored().back().kind == MeasurementKind::Void);
        QVERIFY(bench.stored().back().source == MeasurementSource::File);
        QVERIFY(bench.verified().finding.empty());
    }
    void oneRefusedRowTakesNothing_data() {
        QTest::addColumn<QByteArray>("row");
        QTest::addColumn<QByteArray>("why");
        QTest::newRow("part") << QByteArray("9,40,50.01\n") << QByteArray("not in this lot");
        QTest::newRow("depth") << QByteArray("2,177,50.01\n") << QByteArray("not measured at");
        QTest::newRow("inch overhang") << QByteArray("2,1.575,50.01\n") << QByteArray("not measured at");
        QTest::newRow("impossible") << QByteArray("2,40,51.9\n") << QByteArray("cannot be");
        QTest::newRow("twice") << QByteArray("1,40,50.5\n") << QByteArray("twice");
    }
    void oneRefusedRowTakesNothing() {
        QFETCH(QByteArray, row);
        QFETCH(QByteArray, why);
        Bench bench(2);
        QByteArray text = "part,overhang_mm,diameter_mm\n";
        text += QByteArray::fromStdString(fmt::format("1,40,{}\n1,310,{}\n", bench.true_mm(1, 0), bench.true_mm(1, 1)));
        text += row;
        const ReadBores bores = read(text);
        const BoreImportPlan plan = bench.service().planImport(bores);
        QVERIFY(plan.refused.has_value());
        QCOMPARE(plan.refused->line, 4U);
        const std::string said = plan.refused->reason.english();
        QVERIFY2(said.find(why.toStdString()) != std::string::npos, said.c_str());
        QVERIFY(!bench.take(bores, true).has_value());
        QVERIFY(bench.stored().empty());
    }
    void anotherValueOfAStoredBoreIsRefused() {
        Bench bench(1);
        QVERIFY(bench.take(read(tableOf(bench, 1))).has_value());
        const auto plan = bench.service().planImport(read("part,overhang_mm,diameter_mm\n1,40,50.5\n"));
        QVERIFY(plan.refused && plan.refused->reason.english().find("already") != std::string::npos);
    }
    void whatTheGateAsksIsAskedForTheFile() {
        Bench bench(2);
        QByteArray text = "part,overhang_mm,diameter_mm\n";
        text += QByteArray::fromStdString(fmt::format("1,40,{}\n1,310,{}\n2,40,{}\n", bench.true_mm(1, 0),
                                                      bench.true_mm(1, 1), bench.true_mm(2, 0) / 10.0));
        const ReadBores bores = read(text);
        const BoreImportPlan plan = bench.service().planImport(bores);
        QVERIFY(!plan.refused);
        QCOMPARE(plan.questions.size(), std::size_t{1});
        QCOMPARE(plan.questions[0].line, 4U);
        QVERIFY(!bench.take(bores).has_value());
        QVERIFY(bench.stored().empty());
        QVERIFY(!bench.take(bores, true, "").has_value());  // nobody signs
        QVERIFY(bench.take(bores, true).has_value());
        const auto rows = bench.stored();
        QCOMPARE(rows.size(), std::size_t{3});
        QVERIFY(rows[2].confirmed && !rows[0].confirmed);
    }
    void whatCannotBeReadIsSaid() {
        QVERIFY(read("part,diameter_mm\nx,50\n").problem.find("line 2") != std::string::npos);
        QVERIFY(read("a,b\n1,2\n").problem.find("part") != std::string::npos);
        QVERIFY(!read("").problem.empty());
        QVERIFY(!readBores("/nowhere/at all.csv").problem.empty());
        Bench bench(1);
        const auto nowhere = bench.service().planImport(read("part,diameter_mm\n1,50.01\n"));
        QVERIFY(nowhere.refused && nowhere.refused->reason.english().find("overhang_mm") != std::string::npos);
    }
};

QTEST_GUILESS_MAIN(TestBoringImport)
#include "tst_boring_import.moc"
