// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/service/milling/milling_json.h"
#include "engine/process/milling/milling_setup.h"

using namespace kerf;

/// What the milling room keeps as text, and blank profiles from elsewhere.
class TestMillingJson : public QObject {
    Q_OBJECT

 private slots:
    void aProfileIsReadAsTheHeadlessProgramReadsIt() {
        const auto blank = millingBlankFromCsv("\xEF\xBB\xBFx_mm,height_mm\r\n# measured\n-2,1\n\n20,2.5\n60,0\n");
        QVERIFY(blank.has_value());
        QCOMPARE(blank->count, std::uint16_t{2});
        QCOMPARE(blank->begin_mm[0], -2.0);
        QCOMPARE(blank->height_mm[1], 2.5);
        QCOMPARE(blank->end_mm, 60.0);
    }
    void aBadProfileSaysLineAndColumn_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QStringList>("pieces");
        const QByteArray head("x_mm,height_mm\n");
        QTest::newRow("no header") << QByteArray("0,1\n10,0\n") << QStringList{"Line 1", "x_mm,height_mm"};
        QTest::newRow("word") << head + "0,1\n10,two\n20,0\n" << QStringList{"Line 3", "height_mm", "two"};
        QTest::newRow("comma") << head + "0,1,5\n20,0\n" << QStringList{"Line 2", "3 columns"};
        QTest::newRow("not finite") << head + "0,nan\n20,0\n" << QStringList{"Line 2", "height_mm"};
        QTest::newRow("backwards") << head + "0,1\n10,1\n5,0\n" << QStringList{"Line 4", "x_mm", "5.000", "10.000"};
        QTest::newRow("too high") << head + "0,1\n10,51\n20,0\n" << QStringList{"Line 3", "height_mm", "50"};
        QTest::newRow("one row") << head + "0,1\n" << QStringList{"1 rows", "2"};
        QTest::newRow("empty") << QByteArray() << QStringList{"0 rows"};
    }
    void aBadProfileSaysLineAndColumn() {
        QFETCH(QByteArray, text);
        QFETCH(QStringList, pieces);
        const auto blank =
            millingBlankFromCsv(std::string_view(text.constData(), static_cast<std::size_t>(text.size())));
        QVERIFY(!blank.has_value());
        const QString why = QString::fromStdString(blank.error().english());
        for (const QString& piece : pieces) {
            QVERIFY2(why.contains(piece), qPrintable(why));
        }
    }
    void moreStepsThanTheLoopHoldsAreRefused() {
        std::string text = "x_mm,height_mm\n";
        for (std::size_t i = 0; i <= MillingBlank::kMaxSteps + 1; ++i) {
            text += std::to_string(i) + ",1\n";
        }
        QVERIFY(!millingBlankFromCsv(text).has_value());
    }
    void whatIsKeptComesBackToTheLastDigit() {
        MillingSetup setup;
        setup.reference_N = 374.94364833400001;
        setup.law = MillingLaw::Preview;
        MillingBlank blank;
        blank.count = 1;
        blank.height_mm[0] = 1.0 / 3.0;
        blank.end_mm = 60.1;
        const auto again = millingRecipeFromJson(millingRecipeJson({setup, {blank, "wall.csv"}}), {});
        QVERIFY(again.has_value());
        QCOMPARE(again->setup.law, MillingLaw::Preview);
        for (const MillingField& field : milling::setupFields()) {
            QVERIFY2(field.get(again->setup) == field.get(setup), field.spec.key);
        }
        QVERIFY(again->blank.blank.height_mm[0] == 1.0 / 3.0 && again->blank.source == "wall.csv");
        // Of before blanks stood in the recipe: what holds otherwise. A recipe of today that has none has none.
        const auto of = millingRecipeFromJson("{}", {blank, "wall.csv"});
        QVERIFY(of && of->blank.source == "wall.csv" && of->blank.blank.count == 1);
        const auto none = millingRecipeFromJson(millingRecipeJson({setup, {}}), {blank, "wall.csv"});
        QVERIFY(none && none->blank.blank.count == 0);
        MillingToolRecord record;
        record.learnt = true;
        record.lastPart = 7;
        record.advised = true;
        record.law = MillingLaw::Constant;
        record.tool = {4, 7.738057556405839, 7.81, 0.1 + 0.2, 1.0 / 3.0, {-0.1, -2.5, 0.0, -1.0, -7.0, -30.0}};
        const auto tool = millingToolFromJson(millingToolJson(record));
        QVERIFY(tool.has_value());
        QVERIFY(tool->tool == record.tool && tool->lastPart == 7 && tool->advised && tool->law == record.law);
    }
    void aToolOfAnEarlierVersionHasNoWordAboutStiffTools() {
        MillingToolRecord record;
        record.tool.parts = 3;
        nlohmann::json json = nlohmann::json::parse(millingToolJson(record));
        json["kx_log_weight"] = {-1.0, 0.0, -2.0, -3.0, -4.0, -5.0};
        const auto read = millingToolFromJson(json.dump());
        QVERIFY(read.has_value());
        QCOMPARE(read->tool.kxLogWeight[5], -5.0);
        for (std::size_t i = 6; i < kMillingKxFilters; ++i) {
            QCOMPARE(read->tool.kxLogWeight[i], -6.0);
        }
        json["kx_log_weight"] = std::vector<double>(kMillingKxFilters + 1, -1.0);
        QVERIFY(!millingToolFromJson(json.dump()).has_value());
    }
    void rubbishIsNoValue() {
        for (const char* text : {"", "{", "[]", "null", "{\"milling.reference_n\": \"many\"}"}) {
            QVERIFY2(!millingRecipeFromJson(text, {}).has_value(), text);
            QVERIFY2(!millingBlankFromJson(text).has_value(), text);
            QVERIFY2(!millingToolFromJson(text).has_value(), text);
        }
        QVERIFY(!millingRecipeFromJson("{\"blank\": {\"begin_mm\": [0]}}", {}));
        QVERIFY(!millingRecipeFromJson("{\"milling.reference_n\": 5}", {}).has_value());  // below its range
    }
};

QTEST_APPLESS_MAIN(TestMillingJson)
#include "tst_milling_json.moc"
