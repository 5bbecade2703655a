// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>

#include "ui/models/parts_model.h"

using namespace kerf;
using ui::PartsModel;

namespace {

/// Parts 1…n in memory; can be told to fail.
class FakePartReader final : public PartReader {
 public:
    explicit FakePartReader(int parts) {
        for (int i = 1; i <= parts; ++i) {
            add(i % 10 == 0 ? "B" : "A");
        }
    }
    void add(const std::string& lot) {
        PartRow row;
        row.id = static_cast<PartId>(all.size()) + 1;
        row.number = static_cast<std::uint32_t>(row.id);
        row.lotName = lot;
        row.partTypeName = "Sleeve 50";
        row.endedUtc_ms = row.id * 60'000;
        all.push_back(row);
    }
    void measure(PartId part, std::uint8_t station, double diameter_mm) {
        MeasurementRow row;
        row.id = ++m_lastMeasurement;
        row.part = part;
        row.station = station;
        row.diameter_mm = diameter_mm;
        all[static_cast<std::size_t>(part) - 1].measurements.push_back(row);
    }
    void correct(PartId part, MeasurementId id, std::optional<double> diameter_mm) {
        auto& rows = all[static_cast<std::size_t>(part) - 1].measurements;
        MeasurementRow row = *std::find_if(rows.begin(), rows.end(), [id](const auto& r) { return r.id == id; });
        row.replaces = id;
        row.id = ++m_lastMeasurement;
        row.kind = diameter_mm ? MeasurementKind::Correction : MeasurementKind::Void;
        row.diameter_mm = diameter_mm;
        rows.push_back(row);
    }
    Result<std::vector<PartRow>> parts(const PartQuery& query) override {
        ++reads;
        if (broken) {
            return fail("The disk is gone.");
        }
        std::vector<PartRow> page;
        for (auto row = all.rbegin(); row != all.rend() && page.size() < query.limit; ++row) {
            if (row->id < query.before.value_or(INT64_MAX) && row->lotName.find(query.text) != std::string::npos) {
                page.push_back(*row);
            }
        }
        return page;
    }
    Result<std::uint64_t> count(const PartQuery& query, std::uint64_t atMost) override {
        const auto found = std::count_if(all.begin(), all.end(), [&](const PartRow& row) {
            return row.lotName.find(query.text) != std::string::npos;
        });
        return std::min(static_cast<std::uint64_t>(found), atMost);
    }
    Result<std::optional<PartDetail>> part(PartId) override { return std::optional<PartDetail>(); }

    std::vector<PartRow> all;
    bool broken{false};
    int reads{0};

 private:
    MeasurementId m_lastMeasurement{0};
};

QString shown(const PartsModel& model, int row, int column) {
    return model.index(row, column).data().toString();
}

}  // namespace

/// The table behind the Parts page.
class TestPartsModel : public QObject {
    Q_OBJECT
 private slots:
    void pagesFollowEachOtherWithoutGapOrRepeat() {
        FakePartReader reader(250);
        PartsModel model(reader);
        QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        tester.setUseFetchMore(false);  // it would fetch by itself, in the middle of a reset
        model.setQuery({});
        QCOMPARE(model.rowCount(), 100);
        QCOMPARE(model.matches(), std::uint64_t{250});
        while (model.canFetchMore({})) {
            model.fetchMore({});
        }
        QCOMPARE(model.rowCount(), 250);
        for (int i = 0; i < 250; ++i) {
            QCOMPARE(model.index(i, 0).data(PartsModel::PartIdRole).toLongLong(), 250LL - i);
        }
    }
    void fullLastPageEndsCleanly() {
        FakePartReader reader(200);
        PartsModel model(reader);
        model.setQuery({});
        while (model.canFetchMore({})) {
            model.fetchMore({});
        }
        QCOMPARE(model.rowCount(), 200);
    }
    void searchShowsOnlyMatches() {
        FakePartReader reader(250);
        PartsModel model(reader);
        model.setQuery({.text = "B"});
        QCOMPARE(model.rowCount(), 25);
        QCOMPARE(model.matches(), std::uint64_t{25});
        QCOMPARE(shown(model, 0, PartsModel::Lot), QStringLiteral("B"));
        model.setQuery({.text = "none"});
        QCOMPARE(model.rowCount(), 0);
        QVERIFY(!model.canFetchMore({}));
    }
    void unitSwitchChangesTheViewNotTheData() {
        FakePartReader reader(1);
        reader.measure(1, 1, 50.8);
        reader.measure(1, 0, 25.4);
        PartsModel model(reader);
        model.setQuery({});
        QCOMPARE(shown(model, 0, PartsModel::Diameters), QStringLiteral("25.400   50.800"));
        const int reads = reader.reads;
        QSignalSpy data(&model, &QAbstractItemModel::dataChanged);
        QSignalSpy header(&model, &QAbstractItemModel::headerDataChanged);
        model.setUnits({ui::LengthUnit::Inch, ui::TemperatureUnit::Celsius});
        QVERIFY(shown(model, 0, PartsModel::Diameters).startsWith(QStringLiteral("1.0000")));
        QVERIFY(model.headerData(PartsModel::Diameters, Qt::Horizontal, Qt::DisplayRole).toString().contains("in"));
        QCOMPARE(data.size(), 1);
        QCOMPARE(header.size(), 1);
        QCOMPARE(reader.reads, reads);
        QCOMPARE(*model.row(0)->measurements[0].diameter_mm, 50.8);
    }
    void correctionsShowTheValueThatHolds() {
        FakePartReader reader(2);
        reader.measure(1, 0, 50.1);
        reader.measure(1, 1, 50.2);
        reader.correct(1, 1, 50.0);
        reader.correct(1, 2, std::nullopt);
        PartsModel model(reader);
        model.setQuery({});
        QCOMPARE(shown(model, 1, PartsModel::Diameters), QStringLiteral("50.000"));
        QCOMPARE(shown(model, 1, PartsModel::Changes), QStringLiteral("1 corrected, 1 voided"));
        QVERIFY(model.index(1, 0).data(PartsModel::ChangedRole).toBool());
        QVERIFY(!model.index(0, 0).data(PartsModel::ChangedRole).toBool());
        QCOMPARE(shown(model, 0, PartsModel::Changes), QString());
    }
    void newPartsComeOnTopAndKeepTheSelection() {
        FakePartReader reader(120);
        PartsModel model(reader);
        QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        tester.setUseFetchMore(false);  // it would fetch by itself, in the middle of a reset
        model.setQuery({});
        model.fetchMore({});
        const QPersistentModelIndex selected = model.index(5, 0);
        const auto id = selected.data(PartsModel::PartIdRole);
        QSignalSpy resets(&model, &QAbstractItemModel::modelReset);
        reader.add("A");
        reader.add("A");
        reader.measure(116, 0, 50.0);
        QSignalSpy data(&model, &QAbstractItemModel::dataChanged);
        model.update();
        QCOMPARE(model.rowCount(), 122);
        QCOMPARE(selected.row(), 7);
        QCOMPARE(selected.data(PartsModel::PartIdRole), id);
        QCOMPARE(resets.size(), 0);
        QCOMPARE(data.size(), 1);  // the part that was measured meanwhile, and only it
        QCOMPARE(shown(model, 6, PartsModel::Diameters), QStringLiteral("50.000"));
        QCOMPARE(model.matches(), std::uint64_t{122});
    }
    void manyNewPartsBeginAgain() {
        FakePartReader reader(10);
        PartsModel model(reader);
        model.setQuery({});
        for (int i = 0; i < 300; ++i) {
            reader.add("A");
        }
        model.update();
        QCOMPARE(model.rowCount(), 100);
        QCOMPARE(model.index(0, 0).data(PartsModel::PartIdRole).toLongLong(), 310LL);
        QVERIFY(model.canFetchMore({}));
    }
    void emptyTableFillsOnUpdate() {
        FakePartReader reader(0);
        PartsModel model(reader);
        model.setQuery({});
        QCOMPARE(model.rowCount(), 0);
        reader.add("A");
        model.update();
        QCOMPARE(model.rowCount(), 1);
    }
    void failedReadKeepsTheTableAndSaysWhy() {
        FakePartReader reader(150);
        PartsModel model(reader);
        model.setQuery({});
        QString said;
        connect(&model, &PartsModel::problem, this,
                [&said](const Sentence& sentence) { said = QString::fromStdString(sentence.english()); });
        reader.broken = true;
        model.update();
        QCOMPARE(said, QStringLiteral("The disk is gone."));
        model.fetchMore({});
        QCOMPARE(model.rowCount(), 100);
        QVERIFY(!model.canFetchMore({}));
        reader.broken = false;
        model.setQuery({});
        QVERIFY(model.canFetchMore({}));
    }
    void abortedPartsAreMarked() {
        FakePartReader reader(1);
        reader.all[0].complete = false;
        PartsModel model(reader);
        model.setQuery({});
        QCOMPARE(shown(model, 0, PartsModel::Result), QStringLiteral("aborted"));
        QVERIFY(!model.index(0, 0).data(PartsModel::CompleteRole).toBool());
    }
};

QTEST_GUILESS_MAIN(TestPartsModel)
#include "tst_parts_model.moc"
