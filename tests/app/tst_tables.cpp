// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/files/json_document.h"
#include "app/files/table.h"
#include "app/files/text_encoding.h"

using namespace kerf::files;

namespace {

Table table(std::string_view text, const ReadOptions& options = {}) {
    return Table::parse(text, "t.csv", options);
}

QString refusal(std::string_view text, const char* column, const ReadOptions& options = {}) {
    try {
        const Table read = table(text, options);
        (void)read.column(column);
    } catch (const BadInput& why) {
        return QString::fromUtf8(why.what());
    }
    return {};
}

std::string utf16(std::string_view ascii, bool bigEndian, bool mark) {
    std::string out = mark ? (bigEndian ? "\xFE\xFF" : "\xFF\xFE") : "";
    for (const char c : ascii) {
        out += bigEndian ? std::string{'\0', c} : std::string{c, '\0'};
    }
    return out;
}

bool noted(const Table& read, const char* piece) {
    for (const std::string& note : read.notes()) {
        if (note.find(piece) != std::string::npos) return true;
    }
    return false;
}

constexpr std::string_view kBores =
    "part,overhang_mm,feed_mm_per_rev,diameter_mm\n1,40,0.5,49.951\n1,310,0.25,49.832\n";

}  // namespace

/// The one reader of every table: what is recognised, what is refused. See docs/data.md.
class TestTables : public QObject {
    Q_OBJECT

 private slots:
    void oneTableInManySpellings_data() {
        QTest::addColumn<QByteArray>("text");
        const auto row = [](const char* name, std::string_view text) {
            QTest::newRow(name) << QByteArray(text.data(), static_cast<qsizetype>(text.size()));
        };
        row("plain", kBores);
        row("byte order mark", std::string("\xEF\xBB\xBF") + std::string(kBores));
        row("utf-16", utf16(kBores, false, true));
        row("utf-16 without its mark", utf16(kBores, false, false));
        row("utf-16 big endian", utf16(kBores, true, true));
        row("german", "part;overhang_mm;feed_mm_per_rev;diameter_mm\r\n1;40;0,5;49,951\r\n1;310;0,25;49,832\r\n");
        row("tabs and decimal comma",
            "part\toverhang_mm\tfeed_mm_per_rev\tdiameter_mm\n1\t40\t0,5\t49,951\n1\t310\t0,25\t49,832\n");
        row("pipes", "part|overhang_mm|feed_mm_per_rev|diameter_mm\n1|40|0.5|49.951\n1|310|0.25|49.832\n");
        row("blanks", "part  overhang_mm feed_mm_per_rev diameter_mm\n1  40 0.5 49.951\n1 310 0.25 49.832\n");
        row("quoted names",
            "\"part\",\"overhang_mm\",\"feed_mm_per_rev\",\"diameter_mm\"\n1,40,0.5,49.951\n1,310,0.25,49.832\n");
        row("quoted decimal commas",
            "part,overhang_mm,feed_mm_per_rev,diameter_mm\n1,40,\"0,5\",\"49,951\"\n1,310,\"0,25\",\"49,832\"\n");
        row("carriage returns", "part,overhang_mm,feed_mm_per_rev,diameter_mm\r1,40,0.5,49.951\r1,310,0.25,49.832\r");
        row("plus and exponents",
            "part,overhang_mm,feed_mm_per_rev,diameter_mm\n1,+40,5E-1,+49.951\n1,3.1E2,.25,49.832\n");
        row("blank rows and columns",
            "part,overhang_mm,feed_mm_per_rev,diameter_mm,,\n,,,,,\n1,40,0.5,49.951,,\n,,,,,\n1,310,0.25,49.832,,\n,,,,"
            ",\n");
        row("another order, case, unit",
            "Diameter [mm],who,Feed (mm/rev),PART,Overhang (mm)\n49.951,Kim,0.5,1,40\n49.832,\"Lee, J\",0.25,1,310\n");
        row("a units row", "part;overhang;feed;diameter\n;mm;mm/rev;mm\n1;40;0,5;49,951\n1;310;0,25;49,832\n");
        row("a header block",
            "Gauge station "
            "4\nOperator;Kim\nSerial;1234\n\npart;overhang_mm;feed_mm_per_rev;diameter_mm\n1;40;0,5;49,951\n1;310;0,25;"
            "49,832\n");
        row("several blocks",
            "part,overhang_mm,feed_mm_per_rev,diameter_mm\n1,40,0.5,49.951\n\nBlock "
            "2\npart,overhang_mm,feed_mm_per_rev,diameter_mm\n1,310,0.25,49.832\n");
        row("excel says its separator",
            "sep=;\npart;overhang_mm;feed_mm_per_rev;diameter_mm\n1;40;0,5;49,951\n1;310;0,25;49,832\n");
        row("a comment and a note at the end",
            "# station 4\npart,overhang_mm,feed_mm_per_rev,diameter_mm\n1,40,0.5,49.951\n1,310,0.25,49.832\nend of "
            "shift\n");
        row("inches",
            "part,overhang [in],feed [in/rev],diameter "
            "[inch]\n1,1.574803149606299,0.01968503937007874,1.966574803149606\n1,12.204724409448819,0."
            "00984251968503937,1.961889763779528\n");
        row("another word for it", "number,position_mm,feed,diameter\n1,40,0.5,49.951\n1,310,0.25,49.832\n");
        row("korean",
            "\xED\x92\x88\xEB\xB2\x88,part,overhang_mm,\xEC\x9D\xB4\xEC\x86\xA1 [mm/rev],\xEB\x82\xB4\xEA\xB2\xBD "
            "[mm]\nA,1,40,0.5,49.951\nB,1,310,0.25,49.832\n");
        row("cp949",
            "\xC7\xB0\xB9\xF8,part,overhang_mm,\xC0\xCC\xBC\xDB [mm/rev],\xB3\xBB\xB0\xE6 "
            "[mm]\nA,1,40,0.5,49.951\nB,1,310,0.25,49.832\n");
        row("a units row that begins with a dash",
            "part,overhang_mm,feed_mm_per_rev,diameter_mm\n-,mm,mm/rev,mm\n1,40,0.5,49.951\n1,310,0.25,49.832\n");
        row("units behind a stroke and behind in",
            "part,overhang in mm,feed in mm/rev,Diameter / mm\n1,40,0.5,49.951\n1,310,0.25,49.832\n");
        row("the sign of a diameter",
            "Part No.;Overhang (mm);Feed (mm/U);\xC3\x98 [mm]\n1;40;0,5;49,951\n1;310;0,25;49,832\n");
        row("a shorter table before it",
            "min,max,mean,sd\nstation,1,2,3\n\npart,overhang_mm,feed_mm_per_rev,diameter_mm\n1,40,0.5,49.951\n1,310,0."
            "25,49.832\n");
        row("a short table behind it",
            "part,overhang_mm,feed_mm_per_rev,diameter_mm\n1,40,0.5,49.951\n1,310,0.25,49.832\n\nStatistics\nmean,"
            "sd\n50."
            "0,0.1\n");
        row("no-break blanks",
            "part;overhang_mm;feed_mm_per_rev;diameter_mm\n1;\xC2\xA0"
            "40;0,5\xC2\xA0;49,951\n1;310;0,25;49,832\n");
    }
    void oneTableInManySpellings() {
        QFETCH(QByteArray, text);
        const Table read = table({text.constData(), static_cast<std::size_t>(text.size())});
        QCOMPARE(read.rows(), std::size_t{2});
        QCOMPARE(read.column("part"), (std::vector<double>{1, 1}));
        const auto close = [](const std::vector<double>& a, const std::vector<double>& b) {
            return std::abs(a[0] - b[0]) < 1e-9 && std::abs(a[1] - b[1]) < 1e-9;
        };
        QVERIFY(close(read.column("overhang_mm"), {40, 310}));
        QVERIFY(close(read.column("feed_mm_per_rev"), {0.5, 0.25}));
        QVERIFY(close(read.column("diameter_mm"), {49.951, 49.832}));
    }
    void encodingsAreFoundOut() {
        QCOMPARE(decodeText("Temp \xB0"
                            "C;Gr\xF6\xDF"
                            "e")
                     .encoding,
                 Encoding::Windows1252);
        QCOMPARE(decodeText("Temp \xB0"
                            "C")
                     .utf8,
                 std::string("Temp \xC2\xB0"
                             "C"));
        QCOMPARE(decodeText("\xBF\xC2\xB5\xB5,T1").encoding, Encoding::Cp949);
        QCOMPARE(decodeText("\xBF\xC2\xB5\xB5").utf8, std::string("\xEC\x98\xA8\xEB\x8F\x84"));
        QCOMPARE(decodeText("\xEC\x98\xA8").encoding, Encoding::Utf8);
        QVERIFY(isValidUtf8(utf8Of("\xFF\xC0\x80\xED\xA0\x80 x")));
        QVERIFY(noted(table("t,\xBF\xC2\xB5\xB5\n1,2\n"), "CP949"));
    }
    void whatIsInDoubtIsRefusedAndCanBeSaid() {
        const QString comma = refusal("part\td\n1\t49,951\n2\t50,004\n", "d");
        QVERIFY2(comma.contains("line 2") && comma.contains("--decimal"), qPrintable(comma));
        QCOMPARE(table("part\td\n1\t49,951\n", {0, ',', {}, {}, {}, 0.0}).column("d")[0], 49.951);
        QCOMPARE(table("part\td\n1\t49,951\n", {0, '.', {}, {}, {}, 0.0}).column("d")[0], 49951.0);
        QVERIFY(refusal("part;d\n1;0,5\n2;1.5\n", "d").contains("--decimal"));
        QVERIFY(refusal("part;d\n1;0,5\n2;49.951\n", "d").contains("--decimal"));
        QVERIFY(refusal("part,f,d\n1,0,5,49,951\n", "d").contains("comma"));
        const QString none = refusal("1.5 2 3\n2.5 3 4\n", "d");
        QVERIFY2(none.contains("--columns"), qPrintable(none));
        const ReadOptions named{0, 0, {}, {"d", "-", "z"}, {}, 0.001};
        const Table sampler = table("1.5 2 3 \n2.5 3 4 \n", named);
        QCOMPARE(sampler.column("d"), (std::vector<double>{1.5, 2.5}));
        QCOMPARE(sampler.column("t_s"), (std::vector<double>{0.0, 0.001}));
        QVERIFY(refusal("d,D [mm],d (mm)\n1,2,3\n", "d_mm").contains("twice"));
    }
    void anythingThatMeansNoValueIsNone_data() {
        QTest::addColumn<QByteArray>("mark");
        for (const char* mark : {"",
                                 " ",
                                 "nan",
                                 "NaN",
                                 "NAN",
                                 "NA",
                                 "N/A",
                                 "#N/A",
                                 "#NV",
                                 "null",
                                 "NULL",
                                 "none",
                                 "-----",
                                 "--",
                                 "***",
                                 "?",
                                 "#DIV/0!",
                                 "OL",
                                 "-OL",
                                 "OVER",
                                 "Open",
                                 "9.9E+37",
                                 "-9.9e37",
                                 "9.90000000E+37",
                                 "inf",
                                 "-inf",
                                 "1e999",
                                 "1.#QNAN",
                                 "Overload",
                                 "\xEC\x97\x86\xEC\x9D\x8C",
                                 "n.a.",
                                 "<NULL>",
                                 "TC OPEN",
                                 ">1372",
                                 "S.br",
                                 "burn-out",
                                 "n. v.",
                                 "\xEC\xB8\xA1\xEC\xA0\x95\xEB\xB6\x88\xEA\xB0\x80",
                                 "\xEC\x98\xA4\xEB\xA5\x98",
                                 "\xE2\x88\x9E",
                                 "+OVER",
                                 "Infinity",
                                 "I/O Timeout",
                                 "nan(0x7ff)",
                                 "-9999",
                                 "-99999.0"}) {
            QTest::newRow(*mark != '\0' ? mark : "empty") << QByteArray(mark);
        }
    }
    void anythingThatMeansNoValueIsNone() {
        QFETCH(QByteArray, mark);
        const std::string text = "a,b,c\n1,2,3\n4," + mark.toStdString() + ",6\n7,8,9\n";
        const Table read = table(text);
        const auto b = read.columnWithGaps("b");
        QVERIFY(b[0] == 2.0 && !b[1] && b[2] == 8.0);
        QCOMPARE(read.column("c")[1], 6.0);  // a column nobody asks for spoils nothing
        const QString why = refusal(text, "b");
        QVERIFY2(why.contains("line 3") && why.contains("column b"), qPrintable(why));
        Table dropped = table(text);
        dropped.dropRowsWithGaps({"b"});
        QCOMPARE(dropped.column("a"), (std::vector<double>{1, 7}));
        QVERIFY(noted(dropped, "line 3"));
    }
    void aNumberThatLoggersWriteForNoValueIsANumberAmongItsLike() {
        const Table counting = table("a,b\n-9998,1\n-9999,2\n-10000,3\n");
        QCOMPARE(counting.column("a")[1], -9999.0);
    }
    void aClockIsCountedFromItsFirstRow_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("iso") << QByteArray("time,T1\n2026-11-27T23:59:00Z,1\n2026-11-28T00:00:30Z,2\n");
        QTest::newRow("german") << QByteArray("Datum/Zeit;T1\n27.11.2026 23:59:00;1\n28.11.2026 00:00:30;2\n");
        QTest::newRow("midnight without a date") << QByteArray("Uhrzeit;T1\n23:59:00,0;1\n00:00:30,0;2\n");
        QTest::newRow("american") << QByteArray("timestamp,T1\n11/27/2026 11:59:00 PM,1\n11/28/2026 12:00:30 AM,2\n");
    }
    void aClockIsCountedFromItsFirstRow() {
        QFETCH(QByteArray, text);
        const Table read = table(text.toStdString());
        QCOMPARE(read.column("t_s"), (std::vector<double>{0.0, 90.0}));
        QCOMPARE(read.column("t_min")[1], 1.5);
    }
    void datesAreCountedByTheCalendar_data() {
        QTest::addColumn<QString>("first");
        QTest::addColumn<QString>("second");
        QTest::addColumn<double>("days");
        QTest::newRow("a weekend between points") << "27.11.2026"
                                                  << "30.11.2026" << 3.0;
        QTest::newRow("year first") << "2026-02-28"
                                    << "2026-03-01" << 1.0;
        QTest::newRow("no day has 13 months, month first") << "11/12/2026"
                                                           << "11/13/2026" << 1.0;
        QTest::newRow("no day has 30 months, day first") << "29/11/2026"
                                                         << "30/11/2026" << 1.0;
        QTest::newRow("compact") << "20261231"
                                 << "20270102" << 2.0;
        QTest::newRow("dashes, day first") << "27-11-2026"
                                           << "01-12-2026" << 4.0;
        QTest::newRow("one order alone goes forward") << "05/12/2026"
                                                      << "06/11/2026" << 30.0;
        QTest::newRow("the same day") << "03/04/2026"
                                      << "03/04/2026" << 0.0;
    }
    void datesAreCountedByTheCalendar() {
        QFETCH(QString, first);
        QFETCH(QString, second);
        QFETCH(double, days);
        const Table read =
            table((QStringLiteral("time,v\n%1 08:00:00,1\n%2 09:00:00,2\n").arg(first, second)).toStdString());
        QCOMPARE(read.column("t_s")[1], days * 86400.0 + 3600.0);
    }
    void aDateThatMayBeTwoDaysIsRefusedAndCanBeSaid() {
        const char* text = "time,v\n03/04/2026 08:00:00,1\n04/04/2026 08:00:00,2\n";
        const QString why = refusal(text, "t_s");
        QVERIFY2(why.contains("line 3") && why.contains("04/04/2026") && why.contains("--dates"), qPrintable(why));
        QVERIFY(refusal(text, "v").isEmpty());  // nobody asks for the dates
        ReadOptions options;
        options.dates = DateOrder::DayFirst;
        QCOMPARE(table(text, options).column("t_s")[1], 86400.0);
        options.dates = DateOrder::MonthFirst;
        QCOMPARE(table(text, options).column("t_s")[1], 32.0 * 86400.0 - 86400.0);
        QVERIFY(!refusal("time,v\n26/11/27 08:00,1\n26/11/28 08:00,2\n", "t_s").isEmpty());
        options.dates = DateOrder::YearFirst;
        QCOMPARE(table("time,v\n26/11/27 08:00,1\n26/11/28 08:00,2\n", options).column("t_s")[1], 86400.0);
        QCOMPARE(table("time,v\n12/11/2026 08:00,1\n13/11/2026 08:00,2\n").column("t_s")[1], 86400.0);
    }
    void severalTablesInOneFile() {
        const Table behind = table("a,b,c\n1,2,3\n4,5,6\n7,8,9\n\nsummary,n\nmean,50\nspread,2\n");
        QCOMPARE(behind.rows(), std::size_t{3});
        QVERIFY(noted(behind, "line 6") && noted(behind, "another table"));
        const Table read = table("x,y\n1,2\n\na,b\n1,2\n3,4\n5,6\n");
        QCOMPARE(read.column("b"), (std::vector<double>{2, 4, 6}));
        QVERIFY(noted(read, "line 1"));
        const QString turned = refusal("a,b\n1,2\n\nb,a\n2,1\n3,4\n", "a");
        QVERIFY2(turned.contains("line 4") && turned.contains("another order"), qPrintable(turned));
    }
    void oneColumnWithDecimalCommas() {
        QCOMPARE(table("value\n50,014\n50,011\n").column("value"), (std::vector<double>{50.014, 50.011}));
    }
    void theSameColumnTwiceIsOne() {
        const Table read = table("X_Value,a,X_Value,b\n0,1,0,2\n1,3,1,4\n");
        QCOMPARE(read.column("t_s"), (std::vector<double>{0, 1}));
    }
    void halSamplerSaysWhatItLost() {
        const ReadOptions named{0, 0, {}, {"a", "b"}, {}, 0.001};
        QVERIFY(refusal("1.5 2 \noverrun\n2.5 3 \n", "a", named).contains("line 2"));
        QVERIFY(refusal("1.5 2 \noverrun\n2.5 3 \n", "a", named).contains("overrun"));
        QVERIFY(refusal("a,b\n1,2\n", "t_s").contains("--period-s"));
    }
    void labviewMeasurement() {
        const Table read = table(
            "LabVIEW "
            "Measurement\t\nWriter_Version\t2\nSeparator\tTab\nDecimal_Separator\t,\nX_"
            "Columns\tOne\nOperator\tKim\nDate\t2026/01/01\n"
            "***End_of_Header***\t\n\nChannels\t2\t\nSamples\t2\t2\t\nY_Unit_Label\tkN\trev\nX_"
            "Dimension\tTime\tTime\nX0\t0,0\t0,0\nDelta_X\t0,001\t0,001\n"
            "***End_of_Header***\t\t\nX_Value\tforce_y\tangle\tComment\n0,000\t1,5\t0,1\n0,001\t1,6\t0,"
            "2\n\nChannels\t2\t\nSamples\t1\t1\t\nX0\t0,002\t0,002\n"
            "***End_of_Header***\t\t\nX_Value\tforce_y\tangle\tComment\n0,002\t1,7\t0,3\tstopped\n");
        QCOMPARE(read.column("t_s"), (std::vector<double>{0.0, 0.001, 0.002}));
        QCOMPARE(read.column("force_y_n"), (std::vector<double>{1500.0, 1600.0, 1700.0}));
        QCOMPARE(read.column("angle_rev")[2], 0.3);
        const Table timeless = table(
            "LabVIEW "
            "Measurement\t\nSeparator\tTab\nX_Columns\tNo\n***End_of_Header***\t\n\nChannels\t1\nSamples\t2\nX_"
            "Dimension\tTime\nX0\t0.0\nDelta_X\t0.0002\n"
            "***End_of_Header***\t\nX_Value\tforce_y_n\tComment\n\t1.5\n\t1.6\n");
        QCOMPARE(timeless.column("t_s"), (std::vector<double>{0.0, 0.0002}));
    }
    void labviewWithCommas() {
        const Table read = table(
            "LabVIEW Measurement,\nWriter_Version,2\nSeparator,Comma\nDecimal_Separator,.\nX_Columns,One\n"
            "***End_of_Header***,\n\nChannels,2\nSamples,2,2\nX0,0.0,0.0\nDelta_X,0.001,0.001\n"
            "***End_of_Header***\nX_Value,force_y_n,angle_rev,Comment\n0.000,1.5,0.1\n0.001,1.6,0.2,\"a, b\"\n");
        QCOMPARE(read.column("t_s"), (std::vector<double>{0.0, 0.001}));
        QCOMPARE(read.column("force_y_n"), (std::vector<double>{1.5, 1.6}));
        QCOMPARE(read.column("angle_rev"), (std::vector<double>{0.1, 0.2}));
    }
    void aSecondHeaderLineOfUnitsWithWordsBetween() {
        const Table read = table(
            "Model,GL840\nAMP settings\nCH,Signal name,Input,Range\nCH1,front,TEMP,TC_K\nData\n"
            "Number,Date&Time,ms,CH1,CH2,AlarmOut\nNO.,Time,ms,degC,degC,A1234567890\n"
            "1,2026-11-27 08:00:00,0,+22.1,+22.3,LLLL\n2,2026-11-27 08:01:00,0,+22.2,+BURNOUT,LLLL\n"
            "3,2026-11-27 08:02:00,0,+22.4,+22.5,LLLL\n");
        QCOMPARE(read.column("CH1"), (std::vector<double>{22.1, 22.2, 22.4}));
        QCOMPARE(read.nameOf(*read.find("CH2")).base, std::string("ch2"));
        QVERIFY(!read.columnWithGaps("CH2")[1]);
        QCOMPARE(read.column("t_s"), (std::vector<double>{0.0, 60.0, 120.0}));
        // a header of words that happen to be units, under a title: still the header
        const Table plain = table("Messung,Nr,7\n\nt_s,N,F\n0,1,2\n1,2,3\n");
        QCOMPARE(plain.column("t_s"), (std::vector<double>{0.0, 1.0}));
    }
    void halscope() {
        const Table read = table("spindle.0.revs;z_mm;\n0.00100000;1.2000;\n0.00200000;1.3000;\n");
        QCOMPARE(read.column("z_mm"), (std::vector<double>{1.2, 1.3}));
    }
    void aColumnInAnotherUnitIsConvertedAndTold() {
        const Table read = table(
            "time [s],angle [deg],T1 [\xC2\xB0"
            "F]\n60,90,212\n120,180,32\n");
        QCOMPARE(read.column("t_min"), (std::vector<double>{1.0, 2.0}));
        QCOMPARE(read.column("angle_rev")[0], 0.25);
        QVERIFY(noted(read, "converted"));
        QVERIFY(refusal("t_s,feed [mm/s]\n1,2\n", "feed_mm_per_rev").contains("mm per s"));
    }
    void badRowsSayWhere() {
        QVERIFY(refusal("a,b\n1,2\n3\n", "a").contains("line 3: 1 fields; expected 2"));
        QVERIFY(refusal("a,b\n1,2\n3,x\n", "b").contains("line 3, column b: 'x'"));
        QVERIFY(refusal("", "a").contains("empty"));
        QVERIFY(refusal("a,b\n1,2\n", "c").contains("found a,b"));
        QVERIFY(refusal(std::string_view("a,b\n1,\0\n", 8), "b").contains("zero bytes"));
        QVERIFY(refusal("a,a\n1,2\n", "a").contains("twice"));
        const QString lines = refusal("a,\"two\nlines\"\n1,\"x\ny\"\n", "two lines");  // one sentence, one line
        QVERIFY2(lines.contains("'x y'") && !lines.contains(u'\n'), qPrintable(lines));
    }
    void aKeyThatStandsTwiceIsNoJsonOfOurs_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("key");
        QTest::newRow("once") << R"({"a": {"b": 1}, "b": {"a": [{"b": 2}, {"b": 3}]}})" << QString();
        QTest::newRow("twice") << R"({"k_x": 1, "c": 2, "k_x": 3})" << QStringLiteral("k_x");
        QTest::newRow("within") << R"([{"a": 1}, {"b": {"a": 1, "a": 1}}])" << QStringLiteral("a");
        QTest::newRow("written otherwise") << R"({"a": 1, "\u0061": 2})" << QStringLiteral("a");
    }
    void aKeyThatStandsTwiceIsNoJsonOfOurs() {
        QFETCH(QString, text);
        QFETCH(QString, key);
        const auto document = kerf::files::parseJson(text.toStdString());
        QCOMPARE(document.has_value(), key.isEmpty());
        if (!document) {
            QCOMPARE(QString::fromStdString(document.error().english()),
                     QStringLiteral("The key %1 stands twice in one object; it is expected once.").arg(key));
        }
    }
};

QTEST_APPLESS_MAIN(TestTables)
#include "tst_tables.moc"
