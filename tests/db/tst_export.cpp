// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "db/api/csv_export.h"
#include "db/api/recipe_compare.h"
#include "db_test_support.h"

using namespace kerf;

namespace {
QString collected(const std::function<Result<std::uint64_t>(const CsvSink&)>& run) {
    std::string text;
    const auto rows = run([&text](std::string_view piece) {
        text += piece;
        return true;
    });
    return rows ? QString::fromStdString(text) : QString::fromStdString(rows.error().english());
}
}  // namespace

/// CSV for other programs, and what differs between two recipe revisions.
class TestExport : public QObject {
    Q_OBJECT
 private slots:
    void textsWithCommasQuotesAndLinesStayOneField() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        const PartId part = shop.addPart(1);
        const MeasurementId id = shop.must(AcceptMeasurement{test::measured(part, 0, 50.0), {}, std::nullopt}).id;
        MeasurementRow correction = test::measured(part, 0, 50.1);
        correction.kind = MeasurementKind::Correction;
        correction.replaces = id;
        correction.reason = "said \"5\", meant 6,\nKim 김";
        (void)shop.must(AcceptMeasurement{correction, {}, std::nullopt});
        const auto reader = shop.reader();
        const QString text = collected([&](const CsvSink& sink) { return exportMeasurements(*reader, {}, sink); });
        QVERIFY(text.contains(QString::fromUtf8("\"said \"\"5\"\", meant 6,\nKim 김\"")));
    }
    void numbersKeepEveryDigit() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        const double diameter_mm = 50.012345678901234;
        (void)shop.must(AcceptMeasurement{test::measured(shop.addPart(1), 0, diameter_mm), {}, std::nullopt});
        const auto reader = shop.reader();
        const QString text = collected([&](const CsvSink& sink) { return exportParts(*reader, {}, sink); });
        QCOMPARE(text.split(u'\n')[1].split(u',')[11].toDouble(), diameter_mm);
    }
    void manyPagesComeOutOldestFirstAndOnce() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        (void)shop.must(SetActiveLot{ProcessId::Boring, shop.lot, "Lee"});
        QVERIFY(shop.store().addParts(std::vector<PartRecord>(1203, test::boringPart(1))));
        const auto reader = shop.reader();
        const auto lines = collected([&](const CsvSink& sink) {
                               return exportParts(*reader, {}, sink);
                           }).split(u'\n', Qt::SkipEmptyParts);
        QCOMPARE(lines.size(), 1204);
        for (int i = 1; i < lines.size(); ++i) {
            QCOMPARE(lines[i].split(u',')[4].toInt(), i);
        }
    }
    void recipesComeOutWithEveryRevision() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        (void)shop.must(
            KeepRecipe{ProcessId::Milling, "Rail", R"({"milling.reference_n":333.3})", "Lee", "soft, thin", {}});
        (void)shop.must(KeepRecipe{ProcessId::Milling, "Rail", R"({"milling.reference_n":300})", "Kim", "softer", {}});
        (void)shop.must(KeepRecipe{ProcessId::Milling, "Rail", R"({"milling.reference_n":333.3})", "Lee", "back", 1});
        const auto reader = shop.reader();
        const auto lines = collected([&](const CsvSink& sink) {
                               return exportRecipes(*reader, ProcessId::Milling, sink);
                           }).split(u'\n', Qt::SkipEmptyParts);
        QCOMPARE(lines.size(), 4);
        QVERIFY(lines[1].startsWith("2,milling,Rail,1,,Lee,\"soft, thin\","));
        QVERIFY(lines[1].endsWith(R"("{""milling.reference_n"":333.3}")"));
        QVERIFY(lines[3].startsWith("4,milling,Rail,3,1,Lee,back,"));
        QVERIFY(collected([&](const CsvSink& sink) {
                    return exportRecipes(*reader, std::nullopt, sink);
                }).contains("1,boring,Sleeve 50,1,,Lee,part type created,"));
    }
    void sinkCanStopTheExport() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        const auto reader = shop.reader();
        const auto result = exportAudit(*reader, [](std::string_view) { return false; });
        QVERIFY(!result);
    }
    void timesAreIso8601() {
        QCOMPARE(isoTime(0), std::string("1970-01-01T00:00:00.000Z"));
        QCOMPARE(isoTime(1'795'314'496'250), std::string("2026-11-22T02:28:16.250Z"));
    }
    void recipesAreComparedByKeyAndValue() {
        const auto differences = compareRecipes(
            R"({"target_mm":50,"depths":[{"mm":40},{"mm":310}],"gone":true,"same":{"a":1}})",
            R"({"same":{"a":1.0},"target_mm":50.0,"depths":[{"mm":40},{"mm":300},{"mm":175}],"new":"x"})");
        QVERIFY(differences);
        QCOMPARE(differences->size(), std::size_t{4});
        QCOMPARE((*differences)[0].key, std::string("depths.1.mm"));
        QCOMPARE((*differences)[0].before, std::optional<std::string>("310"));
        QCOMPARE((*differences)[0].after, std::optional<std::string>("300"));
        QCOMPARE((*differences)[1].key, std::string("depths.2.mm"));
        QVERIFY(!(*differences)[1].before);
        QCOMPARE((*differences)[2].key, std::string("gone"));
        QVERIFY(!(*differences)[2].after);
        QCOMPARE((*differences)[3].after, std::optional<std::string>("\"x\""));
        QVERIFY(compareRecipes("{}", "{}")->empty());
        QVERIFY(!compareRecipes("nonsense", "{}"));
        QVERIFY(!compareRecipes("{}", "[1]"));
    }
};

QTEST_GUILESS_MAIN(TestExport)
#include "tst_export.moc"
