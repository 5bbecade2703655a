// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QTest>
#include <nlohmann/json.hpp>

#include "db/api/store_writer.h"
#include "tests/db/db_test_support.h"
#include "tests/support/kerf_program.h"

using kerf::test::csvRows;
using kerf::test::KerfRun;
using kerf::test::runKerf;
using kerf::test::scratchFile;
using nlohmann::json;

namespace {

KerfRun quality(const QStringList& arguments) {
    return runKerf(QStringList{QStringLiteral("quality")} + arguments);
}

json jsonOf(const KerfRun& run) {
    return json::parse(run.out.toStdString(), nullptr, false);
}

QString column(const QString& name, const QList<double>& values) {
    QString text = name + u'\n';
    for (const double value : values) {
        text += QString::number(value, 'g', 17) + u'\n';
    }
    return text;
}

const QList<double> kNistCusum{324.925, 324.675, 324.725, 324.350, 325.350, 325.225, 324.125,
                               324.525, 325.225, 324.600, 324.625, 325.150, 328.325, 327.250,
                               327.825, 328.500, 326.675, 327.775, 326.875, 328.350};

/// AIAG's crossed example, persons by letter.
QString aiag() {
    constexpr double kRows[9][10] = {{0.29, -0.56, 1.34, 0.47, -0.80, 0.02, 0.59, -0.31, 2.26, -1.36},
                                     {0.41, -0.68, 1.17, 0.50, -0.92, -0.11, 0.75, -0.20, 1.99, -1.25},
                                     {0.64, -0.58, 1.27, 0.64, -0.84, -0.21, 0.66, -0.17, 2.01, -1.31},
                                     {0.08, -0.47, 1.19, 0.01, -0.56, -0.20, 0.47, -0.63, 1.80, -1.68},
                                     {0.25, -1.22, 0.94, 1.03, -1.20, 0.22, 0.55, 0.08, 2.12, -1.62},
                                     {0.07, -0.68, 1.34, 0.20, -1.28, 0.06, 0.83, -0.34, 2.19, -1.50},
                                     {0.04, -1.38, 0.88, 0.14, -1.46, -0.29, 0.02, -0.46, 1.77, -1.49},
                                     {-0.11, -1.13, 1.09, 0.20, -1.07, -0.67, 0.01, -0.56, 1.45, -1.77},
                                     {-0.15, -0.96, 0.67, 0.11, -1.45, -0.49, 0.21, -0.49, 1.87, -2.16}};
    QString text = QStringLiteral("part,person,trial,value\n");
    for (int row = 0; row < 9; ++row) {
        for (int part = 0; part < 10; ++part) {
            text += QStringLiteral("P%1,%2,%3,%4\n")
                        .arg(part + 1)
                        .arg(QChar(u'A' + row / 3))
                        .arg(row % 3 + 1)
                        .arg(kRows[row][part]);
        }
    }
    return text;
}

/// A data folder with a boring lot: three good parts, one that can be bored again, one scrap, one corrected, one
/// voided.
class BoredLot {
 public:
    BoredLot() {
        if (!kerf::db::prepareDatabase(file().toStdString())) {
            qFatal("no database");
        }
        kerf::test::Shop shop(file().toStdString());
        const double diameters[5][2] = {{50.001, 49.999}, {50.002, 50.0}, {49.98, 50.0}, {50.001, 50.02}, {50.0, 50.0}};
        for (std::uint32_t number = 1; number <= 5; ++number) {
            const auto part = shop.addPart(number);
            for (std::uint8_t station = 0; station < 2; ++station) {
                last = shop.must(kerf::AcceptMeasurement{
                                     kerf::test::measured(part, station, diameters[number - 1][station]), {}, {}})
                           .id;
            }
            parts.push_back(part);
        }
        correct(shop, 1, 50.003, "wrong line");
        takeOut(shop);
    }
    [[nodiscard]] QString path() const { return m_folder.path(); }
    [[nodiscard]] QString file() const { return m_folder.filePath(QStringLiteral("kerf.db")); }

    std::vector<kerf::PartId> parts{};
    kerf::MeasurementId last{0};

 private:
    void correct(kerf::test::Shop& shop, kerf::MeasurementId id, double diameter_mm, const char* reason) {
        kerf::MeasurementRow row = kerf::test::measured(parts[0], 0, diameter_mm);
        row.kind = kerf::MeasurementKind::Correction;
        row.replaces = id;
        row.reason = reason;
        (void)shop.must(kerf::AcceptMeasurement{row, {}, {}});
    }
    void takeOut(kerf::test::Shop& shop) {
        kerf::MeasurementRow row = kerf::test::measured(parts[4], 1, 1.0);
        row.kind = kerf::MeasurementKind::Void;
        row.replaces = last;
        row.diameter_mm.reset();
        row.reason = "dirt";
        (void)shop.must(kerf::AcceptMeasurement{row, {}, {}});
    }
    QTemporaryDir m_folder;
};

}  // namespace

/// `kerf quality …`: what others script against.
class TestQualityCommands : public QObject {
    Q_OBJECT
 private slots:
    void aFileIsReadAsEveryTableIs_data() {
        QTest::addColumn<QString>("text");
        QTest::newRow("decimal commas") << QStringLiteral("part;value\n1;10,01\n2;10,02\n3;9,99\n4;10,00\n");
        QTest::newRow("one column with them") << QStringLiteral("value\n10,01\n10,02\n9,99\n10,00\n");
        QTest::newRow("case, unit, blank rows")
            << QStringLiteral("who,Value [mm]\nKim,10.01\n,\nLee,10.02\nKim,9.99\n\nLee,10.00\n");
        QTest::newRow("a mark costs one row") << QStringLiteral("value\n10.01\n10.02\nOL\n9.99\n10.00\n");
        QTest::newRow("a block before it")
            << QStringLiteral("Station;4\n\npart;value\n1;10,01\n2;10,02\n3;9,99\n4;10,00\n");
    }
    void aFileIsReadAsEveryTableIs() {
        QFETCH(QString, text);
        const QStringList limits{"--lower", "9.9", "--upper", "10.1"};
        const KerfRun plain = quality(
            QStringList{"capability", scratchFile("plain.csv", QStringLiteral("value\n10.01\n10.02\n9.99\n10.00\n"))} +
            limits);
        const KerfRun run = quality(QStringList{"capability", scratchFile("other.csv", text)} + limits);
        QVERIFY2(run.exitCode == 0, qPrintable(run.err));
        QCOMPARE(run.out, plain.out);
        QCOMPARE(run.err.contains("line 4"), text.contains("OL"));
    }
    void chartsOfNistsCusum() {
        const QString file = scratchFile("cusum.csv", column("value", kNistCusum));
        const json report = jsonOf(quality({"charts", file, "--target", "325", "--sigma", "1", "--rules", "cusum",
                                            "--k", "0.3175", "--h", "4.1959", "--json"}));
        QCOMPARE(report["signals"][0]["point"].get<int>(), 14);
        QCOMPARE(QString::number(report["points"][13]["cusum_high"].get<double>(), 'f', 2), QString("4.94"));
        QVERIFY(!report["in_control"].get<bool>());
        const auto rows = csvRows(quality({"charts", file, "--csv"}).out);
        QCOMPARE(rows.size(), 21);
        QCOMPARE(rows[0][0], QString("part"));
    }
    void chartsOfNistsEwma() {
        const QString file = scratchFile("ewma.csv", column("value", {52.0, 47.0, 53.0, 49.3, 50.1, 47.0, 51.0}));
        const json report = jsonOf(quality(
            {"charts", file, "--target", "50", "--sigma", "2.0539", "--lambda", "0.3", "--rules", "ewma", "--json"}));
        QCOMPARE(QString::number(report["ewma_upper"].get<double>(), 'f', 4), QString("52.5884"));
        QCOMPARE(QString::number(report["ewma_lower"].get<double>(), 'f', 4), QString("47.4116"));
        QVERIFY(report["in_control"].get<bool>());
    }
    void chartsOfBoresAreThoseOfTheLaw() {
        const KerfRun lot = runKerf({"boring", "simulate", "--parts", "40", "--csv", "--evaluate-at", "40,310"});
        QString text = QStringLiteral("part,overhang_mm,feed_mm_per_rev,deflection_mm\n");
        for (const QStringList& row : csvRows(lot.out).sliced(1)) {
            text += row[1] + u',' + row[2] + u',' + row[4] + u',' + row[6] + u'\n';
        }
        const json report = jsonOf(quality({"charts", scratchFile("bores.csv", text), "--json"}));
        QCOMPARE(report["n"].get<int>(), 39);  // the first part makes the law known
        QCOMPARE(report["rules"].size(), std::size_t{2});
        QVERIFY(report["points"][0]["t_squared"].get<double>() >= 0.0);
    }
    void capabilityKeysAndFigures() {
        QList<double> values;
        for (int i = 0; i < 60; ++i) {
            values.append(10.0 + ((i * 7) % 11 - 5) * 0.01);
        }
        const QString file = scratchFile("values.csv", column("value", values));
        const json report = jsonOf(quality({"capability", file, "--lower", "9.9", "--upper", "10.1", "--json"}));
        for (const char* key :
             {"n", "mean", "s", "pp", "ppk", "ppk_low", "ppk_high", "cp", "cpk", "cpk_low", "pp_low"}) {
            QVERIFY2(report.contains(key), key);
        }
        QCOMPARE(report["n"].get<int>(), 60);
        const double s = report["s"].get<double>();
        QVERIFY(std::abs(report["pp"].get<double>() - 0.2 / (6.0 * s)) < 1e-12);
        const json upper = jsonOf(quality({"capability", file, "--upper", "10.1", "--json"}));
        QVERIFY(upper["pp"].is_null() && !upper["ppk"].is_null());
        QCOMPARE(quality({"capability", file}).exitCode, 2);
        QCOMPARE(quality({"capability", file, "--lower", "2", "--upper", "1"}).exitCode, 2);
        const json few =
            jsonOf(quality({"capability", scratchFile("few.csv", column("value", {1, 2, 3})), "--upper", "4"}));
        QVERIFY(few["ppk"].is_null() && !few["reason"].get<std::string>().empty());
    }
    void aShiftTakesCapabilityAway() {
        QList<double> values;
        for (int i = 0; i < 60; ++i) {
            values.append(10.0 + ((i * 7) % 11 - 5) * 0.01 + (i > 40 ? 0.2 : 0.0));
        }
        const json report = jsonOf(quality(
            {"capability", scratchFile("shift.csv", column("value", values)), "--lower", "9.5", "--upper", "10.5"}));
        QVERIFY(!report["ppk"].is_null() && report["cpk"].is_null() && !report["quiet"].get<bool>());
    }
    void gaugeStudiesOfTheExample() {
        const QString file = scratchFile("aiag.csv", aiag());
        const json anova = jsonOf(quality({"gauge-study", file, "--method", "anova", "--json"}));
        QCOMPARE(QString::number(anova["ss_part"].get<double>(), 'f', 4), QString("88.3619"));
        QCOMPARE(QString::number(anova["ev"].get<double>(), 'f', 6), QString("0.199933"));
        QVERIFY(anova["pooled"].get<bool>());
        QCOMPARE(anova["ndc"].get<int>(), 4);
        const json range =
            jsonOf(quality({"gauge-study", file, "--method", "average-range", "--tolerance", "4", "--json"}));
        QCOMPARE(QString::number(range["grr_percent"].get<double>(), 'f', 2), QString("26.68"));
        QVERIFY(!range["grr_percent_of_tolerance"].is_null());
    }
    void whatIsNotCrossedIsToldInTheFilesOwnWords() {
        QStringList rows{QStringLiteral("part,person,trial,value")};
        for (const char* part : {"P-1", "P-2", "P-3"}) {
            for (const char* person : {"Kim", "Lee"}) {
                for (const char* trial : {"am", "pm"}) {
                    rows << QStringLiteral("%1,%2,%3,%4").arg(part, person, trial).arg(20.0 + 0.1 * (part[2] - '0'));
                }
            }
        }
        const auto study = [this](const QStringList& lines) {
            return quality({"gauge-study", scratchFile("crossed.csv", lines.join(u'\n') + u'\n'), "--method", "anova"});
        };
        const json same = jsonOf(study(rows));  // every reading of a part alike: no spread to divide by
        QVERIFY(same["f_interaction"].is_null() && same["pooled"].get<bool>());
        QStringList missing = rows;
        missing.removeAt(6);
        const KerfRun gap = study(missing);
        QCOMPARE(gap.exitCode, 3);
        QVERIFY2(gap.err.contains("part P-2, person Kim, trial pm is missing"), qPrintable(gap.err));
        const KerfRun twice = study(rows + QStringList{rows.at(3)});
        QCOMPARE(twice.exitCode, 3);
        QVERIFY2(twice.err.contains("line 14") && twice.err.contains("part P-1, person Lee, trial am stands twice"),
                 qPrintable(twice.err));
    }
    void ofTooFewValuesThereIsNoSpread() {
        const json one = jsonOf(quality({"capability", scratchFile("one.csv", "value\n50.001\n"), "--upper", "51"}));
        QVERIFY(one["s"].is_null() && one["s_moving_range"].is_null());
        QCOMPARE(one["mean"].get<double>(), 50.001);
    }
    void typeOneNeedsReadingsAndATolerance() {
        QList<double> readings;
        for (int i = 0; i < 30; ++i) {
            readings.append(6.0 + (i % 5 - 2) * 0.0005);
        }
        const QString file = scratchFile("ring.csv", column("value", readings));
        const json study =
            jsonOf(quality({"gauge-study", file, "--method", "type1", "--tolerance", "0.06", "--reference", "6.0"}));
        QVERIFY(study["pass"].get<bool>() && study["cg"].get<double>() > 1.33 && !study["cgk"].is_null());
        QCOMPARE(quality({"gauge-study", file, "--method", "type1"}).exitCode, 2);
        const QString few = scratchFile("few_ring.csv", column("value", readings.sliced(6)));
        const KerfRun refused = quality({"gauge-study", few, "--method", "type1", "--tolerance", "0.06"});
        QCOMPARE(refused.exitCode, 3);
        QVERIFY(refused.err.contains("24"));
    }
    void badInputNamesFileLineAndColumn() {
        const QString file = scratchFile("bad.csv", "value\n1\nx\n");
        for (const QStringList& command :
             {QStringList{"charts", file}, QStringList{"capability", file, "--upper", "3"}}) {
            const KerfRun run = quality(command);
            QCOMPARE(run.exitCode, 3);
            QVERIFY2(run.err.contains("line 3") && run.err.contains("value"), qPrintable(run.err));
            QVERIFY(run.out.isEmpty());
        }
        QCOMPARE(quality({"charts"}).exitCode, 2);
        QCOMPARE(quality({"charts", file, "--rules", "nelson9"}).exitCode, 2);
    }
    void lotsDfqHoldsWhatTheDataFileHolds() {
        const BoredLot lot;
        const KerfRun written =
            quality({"dfq", "write", "--data", lot.path(), "--lot", "12", "-o", QStringLiteral("lot.dfq")});
        QVERIFY2(written.exitCode == 0, qPrintable(written.err));
        const json file = jsonOf(quality({"dfq", "read", "lot.dfq", "--json"}));
        QCOMPARE(file["characteristics"].size(), std::size_t{2});
        QCOMPARE(file["values"].size(), std::size_t{10});
        QVERIFY(file["oddities"].empty());
        const json& corrected = file["values"][0];
        QCOMPARE(corrected["value"].get<double>(), 50.003);
        QVERIFY((corrected["events"] == json::array({1})));
        const auto remark = corrected["fields"]["K0009"].get<std::string>();
        QVERIFY(remark.find("50.001") != std::string::npos && remark.find("wrong line") != std::string::npos);
        QCOMPARE(file["values"][9]["attribute"].get<int>(), 255);
        QVERIFY(!file["values"][9]["fields"]["K0014"].get<std::string>().empty());
        QCOMPARE(quality({"dfq", "write", "--data", lot.path(), "--lot", "12", "--history", "-o", "all.dfq"}).exitCode,
                 0);
        const json all = jsonOf(quality({"dfq", "read", "all.dfq"}));
        QCOMPARE(all["values"].size(), std::size_t{11});  // the replaced value too
        QVERIFY(QDir().entryList({"*.part"}).isEmpty());
    }
    void copyIsEqual() {
        const QString head = QStringLiteral("K1001/1 x\r\nK2001/1 a\r\nK4092/1 17\r\n");
        scratchFile("odd.dfq", head + QStringLiteral("1,5\x14"
                                                     "0\x14"
                                                     "1.2.2020/3:04:05\x14"
                                                     "1,3\x14#lot\x14\x14"
                                                     "17\r\nK0009/1 why\r\n"));
        QCOMPARE(quality({"dfq", "copy", "odd.dfq", "copied.dfq"}).exitCode, 0);
        const json before = jsonOf(quality({"dfq", "read", "odd.dfq"}));
        const json after = jsonOf(quality({"dfq", "read", "copied.dfq"}));
        QVERIFY(!before["oddities"].empty() && after["oddities"].empty());
        QVERIFY(before["values"] == after["values"]);
        QVERIFY(before["other"] == after["other"]);
    }
    void aPairIsFoundWhicheverIsNamed() {
        scratchFile("Pair.DFD", QStringLiteral("K0100 1\r\nK2001/1 a\r\n"));
        scratchFile("Pair.dfx", QStringLiteral("2.5\x14"
                                               "0\r\n"));
        for (const char* name : {"Pair.DFD", "Pair.dfx"}) {
            const json file = jsonOf(quality({"dfq", "read", name}));
            QCOMPARE(file["values"][0]["value"].get<double>(), 2.5);
            QCOMPARE(file["characteristics"].size(), std::size_t{1});
        }
        QVERIFY(!jsonOf(quality({"dfq", "read", "Pair.DFD", "Pair.dfx"})).contains("files"));
    }
    void aPairNamedTogetherBelongsTogetherWhateverItsNames() {
        scratchFile("station7.dfd", QStringLiteral("K0100 1\r\nK2001/1 a\r\n"));
        scratchFile("values_0815.DFX", QStringLiteral("2.5\x14"
                                                      "0\r\n"));
        for (const QStringList& pair :
             {QStringList{"station7.dfd", "values_0815.DFX"}, QStringList{"values_0815.DFX", "station7.dfd"}}) {
            const json file = jsonOf(quality(QStringList{"dfq", "read"} + pair));
            QCOMPARE(file["values"][0]["value"].get<double>(), 2.5);
            QCOMPARE(file["characteristics"].size(), std::size_t{1});
            QVERIFY(file["oddities"].empty());
        }
    }
    void whatCannotBeReadIsExit3WithLineAndField() {
        scratchFile("bad.dfq", QStringLiteral("K0100 1\r\nK2001/1 a\r\n1.x\x14"
                                              "0\r\n"));
        const KerfRun run = quality({"dfq", "read", "bad.dfq"});
        QCOMPARE(run.exitCode, 3);
        QVERIFY2(run.err.contains("bad.dfq, line 3, field K0001"), qPrintable(run.err));
        QCOMPARE(quality({"dfq", "read", "nothing.dfq"}).exitCode, 3);
        QCOMPARE(quality({"dfq", "copy", "bad.dfq", "never.dfq"}).exitCode, 3);
        QVERIFY(!QFile::exists("never.dfq"));
    }
    void aLotIsFoundByNameOrNumber() {
        const BoredLot lot;
        const json named = jsonOf(quality({"charts", "--data", lot.path(), "--lot", "12", "--json"}));
        QVERIFY(named.contains("points"));
        QCOMPARE(quality({"charts", "--data", lot.path(), "--lot", "nothing"}).exitCode, 3);
    }
};

QTEST_GUILESS_MAIN(TestQualityCommands)
#include "tst_quality_commands.moc"
