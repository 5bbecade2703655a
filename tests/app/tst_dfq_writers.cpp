// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <string>

#include "app/files/dfq.h"
#include "app/files/dfq_loose.h"

using namespace std::string_literals;

namespace {

using namespace kerf;

/// Everything of a value that a copy must keep.
std::string textOf(const dfq::File& file) {
    std::string text;
    for (const dfq::Value& value : file.values) {
        text += std::to_string(value.characteristic) + ':' + std::to_string(value.row) + ':' +
                (value.value ? std::to_string(*value.value) : "none"s) + ':' + std::to_string(value.attribute) + ':' +
                (value.time ? dfq::timeText(*value.time) : "-"s);
        auto fields = value.fields;
        std::ranges::sort(fields, {}, &dfq::Field::key);
        for (const dfq::Field& field : fields) {
            text += field.text.empty() ? ""s : ";" + std::to_string(field.key) + '=' + field.text;
        }
        text += '\n';
    }
    for (const dfq::Entry& entry : file.entries) {
        text += std::to_string(entry.key) + '/' + std::to_string(entry.index.value_or(0)) + ' ' + entry.text + '\n';
    }
    return text;
}

dfq::File readOrFail(const std::string& bytes) {
    const auto file = dfq::read(bytes);
    if (!file) {
        qFatal("line %zu, %s: %s", file.error().line, file.error().field.c_str(), file.error().text.c_str());
    }
    return *file;
}

/// Two bores, 50.011 and 49.998, of one part at 27 November 2026, 10:05:59, both good.
struct Writer {
    const char* name;
    std::string bytes;
};

std::vector<Writer> writers() {
    const std::string description =
        "K0100 2\r\nK1001/1 4711\r\nK2002/1 top\r\nK2142/1 mm\r\nK2002/2 bottom\r\nK2142/2 mm\r\n";
    return {
        {"a measuring machine, strict", description + "50.011\x14"
                                                      "0\x14"
                                                      "27.11.2026/10:05:59\x14\x14#12\x14\x14"
                                                      "1\x14"
                                                      "1\x14\x14"
                                                      "1\x0F"
                                                      "49.998\x14"
                                                      "0\x14"
                                                      "27.11.2026/10:05:59\x14\x14#12\x14\x14"
                                                      "1\x14"
                                                      "1\x14\x14"
                                                      "1\r\n"s},
        {"compact dates of a controller", description + "50.011\x14"
                                                        "0\x14"
                                                        "20261127/100559\x0F"
                                                        "49.998\x14"
                                                        "0\x14"
                                                        "20261127100559\r\n"s},
        {"compact dates, day first", description + "50.011\x14"
                                                   "0\x14"
                                                   "27112026/100559\x0F"
                                                   "49.998\x14"
                                                   "0\x14"
                                                   "27112026 10:05:59\r\n"s},
        {"a Korean office computer",
         "K0100 2\nK1001/1 4711\nK2002/1 \xEC\x83\x81\xEB\xB6\x80\nK2002/2 \xED\x95\x98\xEB\xB6\x80\n"
         "50.011\x14"
         "0\x14"
         "2026-11-27 \xEC\x98\xA4\xEC\xA0\x84 10:05:59\x0F"
         "49.998\x14"
         "0\x14"
         "2026. 11. 27. \xEC\x98\xA4\xEC\xA0\x84 10:05:59\n"s},
        {"a gauge station with names of months", description + "50.011\x14"
                                                               "0\x14"
                                                               "27-Nov-2026 10:05:59\x0F"
                                                               "49.998\x14"
                                                               "0\x14"
                                                               "Nov 27, 2026 10:05:59 AM\r\n"s},
        {"a German shop's macro", "Q-DAS ASCII Transfer Format\r\nexported by hand\r\n" + description +
                                      "50,011\x14"
                                      "0,0\x14"
                                      "Fr., 27.11.2026 10:05:59 Uhr\x0F"
                                      "49,998\x14"
                                      "0\x14"
                                      "27. 11. 2026 10.05.59\r\nEOF\r\n"s},
        {"a spreadsheet",
         "\"K0100 2\"\r\n\"K1001/1 4711\"\r\n\"K2002/1 top\"\r\n\"K2002/2 bottom\"\r\n"
         "50.011,0,27.11.2026/10:05:59,49.998,0,27.11.2026/10:05:59\r\n"s},
        {"a mail program", description + "50.011^T0^T27.11.2026/10:05:59^O49.998^T0^T27.11.2026/10:05:59\r\n"s},
        {"markup", description + "50.011<DC4>0<DC4>27.11.2026/10:05:59<SI>49.998<DC4>0<DC4>27.11.2026/10:05:59\r\n"s},
        {"bars", description + "50.011|0|27.11.2026/10:05:59|49.998|0|27.11.2026/10:05:59\r\n"s},
        {"indices in brackets",
         "K0100 2.0\r\nK1001(1) 4711\r\nK2002(1) top\r\nK2002/2= bottom\r\n"
         "K0001/1 50.011\r\nK0002/1 0\r\nK0004/1 2026.11.27/10:05:59\r\n"
         "K0001/2 49.998\r\nK0002/2 0\r\nK0004/2 2026/11/27 10:05:59\r\n"s},
        {"units behind the values", "; made by station 3\r\nK0100\r\n" + description.substr(9) +
                                        "50.011 mm\x14"
                                        "0\x14"
                                        "27-11-2026/10:05:59\x0F"
                                        "49.998mm\x14"
                                        "0\x14"
                                        "27.11.26/10:05:59\r\n// end\r\n"s},
    };
}

}  // namespace

/// Files in the manner of different programs: one meaning, one reading, and equal copies.
class TestDfqWriters : public QObject {
    Q_OBJECT
 private slots:
    void everyWriterMeansTheSame_data() {
        QTest::addColumn<QByteArray>("bytes");
        for (const Writer& writer : writers()) {
            QTest::newRow(writer.name) << QByteArray(writer.bytes.data(), static_cast<qsizetype>(writer.bytes.size()));
        }
    }
    void everyWriterMeansTheSame() {
        QFETCH(QByteArray, bytes);
        const dfq::File file = readOrFail(bytes.toStdString());
        QCOMPARE(file.characteristics, 2U);
        QCOMPARE(file.values.size(), std::size_t{2});
        for (std::size_t i = 0; i < 2; ++i) {
            QCOMPARE(*file.values[i].value, i == 0 ? 50.011 : 49.998);
            QCOMPARE(file.values[i].attribute, dfq::kValid);
            QCOMPARE(file.values[i].row, 1U);
            QVERIFY((file.values[i].time == dfq::Time{2026, 11, 27, 10, 5, 59.0}));
        }
        QCOMPARE(*file.find(1001, 1), file.find(1001, 1) != nullptr ? "4711"s : ""s);
        const std::string written = dfq::write(file);
        QCOMPARE(textOf(readOrFail(written)), textOf(file));
        QCOMPARE(dfq::write(readOrFail(written)), written);
    }
    void onlyTheStrictOneHasNothingOdd() {
        const auto all = writers();
        for (std::size_t i = 0; i < all.size(); ++i) {
            QCOMPARE(readOrFail(all[i].bytes).oddities.empty(), i == 0);
        }
    }
    void numbersThatAreMeant_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<double>("value");
        QTest::newRow("sign behind") << QByteArray("0.011-") << -0.011;
        QTest::newRow("blank behind the sign") << QByteArray("- 0.011") << -0.011;
        QTest::newRow("German thousands") << QByteArray("1.234,5") << 1234.5;
        QTest::newRow("English thousands") << QByteArray("1,234.5") << 1234.5;
        QTest::newRow("Swiss thousands") << QByteArray("1'234.5") << 1234.5;
        QTest::newRow("millions") << QByteArray("1.234.567") << 1234567.0;
    }
    void numbersThatAreMeant() {
        QFETCH(QByteArray, text);
        QFETCH(double, value);
        const auto number = dfq::looseNumberOf(text.toStdString());
        QVERIFY(number.has_value());
        QCOMPARE(*number, value);
    }
    void whatMayMeanSeveralThingsIsRefused() {
        for (const char* text : {"12..5", "1.2.3", "12a", "1,23,456.7", "--1", "1 2", "", "x"}) {
            QVERIFY2(!dfq::looseNumberOf(text), text);
        }
        for (const char* text : {"1118109100559", "271126", "31.02.2026", "20261327/1000", "27.11.2026/25:00",
                                 "Nov 2026", "27-Foo-2026 10:00", "27.11.2026x10:00", "9999", "", "12345678"}) {
            QVERIFY2(!dfq::looseTimeOf(text, dfq::SlashDates::MonthFirst), text);
        }
        QCOMPARE(dfq::withoutUnit("50.011 mm", ""), "50.011"s);
        QCOMPARE(dfq::withoutUnit("1.969 in", "mm"), "1.969 in"s);  // another unit than the description's
        const std::string head = "K0100 1\r\nK2142/1 mm\r\n";
        QVERIFY(!dfq::read(head + "1.969 in\x14"
                                  "0\r\n")
                     .has_value());
        // Words in front of a table of something else.
        QVERIFY(!dfq::read("title\r\n1,2,3\r\n").has_value());
        QVERIFY(!dfq::read("title\r\nmore\r\n").has_value());
    }
    void midnightThatEndsTheDay() {
        QVERIFY((dfq::looseTimeOf("27.11.2026/24:00:00", dfq::SlashDates::MonthFirst) ==
                 dfq::Time{2026, 11, 28, 0, 0, 0.0}));
        QVERIFY(
            (dfq::looseTimeOf("31.12.2026 24:00", dfq::SlashDates::MonthFirst) == dfq::Time{2027, 1, 1, 0, 0, 0.0}));
    }
    void partsOfASecondSurviveACopy() {
        const std::string head =
            "K0100 1\r\nK2002/1 a\r\n1.5\x14"
            "0\x14";
        for (const char* text :
             {"27.11.2026/10:11:59.9996", "27.11.2026/10:11:12.123456", "27.11.2026/10:11:12.000000001",
              "27.11.2026/23:59:59.999999999", "27.11.2026/10:11:12.500"}) {
            const auto file = readOrFail(head + text + "\r\n");
            QCOMPARE(*file.values.front().find(4), std::string(text));
            QCOMPARE(textOf(readOrFail(dfq::write(file))), textOf(file));
        }
        QCOMPARE(*readOrFail(head + "27.11.2026/10:11:12,5\r\n").values.front().find(4), "27.11.2026/10:11:12.500"s);
    }
    /// Two files put one behind the other: the same characteristics go on, others are counted on.
    void filesPutOneBehindTheOtherKeepTheirDescriptions() {
        const std::string first =
            "K0100 2\r\nK1001/1 4711\r\nK2002/1 bore\r\nK2002/2 depth\r\n50.01\x0F"
            "20.5\r\n50.02\x0F"
            "20.6\r\n";
        const auto same = readOrFail(first + first);
        QCOMPARE(same.characteristics, 2U);
        QCOMPARE(same.values.size(), std::size_t{8});
        QCOMPARE(same.values.back().row, 4U);
        const std::string second =
            "K0100 1\r\nK1001/1 4712\r\nK2002/1 width\r\nK2142/0 mm\r\n7.5\r\nK0014/0 S-1\r\nK0009/1 read again\r\n";
        const auto file = readOrFail(first + second + first);
        QCOMPARE(file.characteristics, 3U);  // the third is the first once more
        QCOMPARE(*file.find(1001, 1), "4711"s);
        QCOMPARE(*file.find(1001, 2), "4712"s);
        QCOMPARE(*file.find(2002, 1), "bore"s);
        QCOMPARE(*file.find(2002, 3), "width"s);
        QCOMPARE(*file.find(2142, 3), "mm"s);
        QVERIFY(file.find(2142, 1) == nullptr);
        QCOMPARE(file.values.size(), std::size_t{9});
        const auto value = std::ranges::find(file.values, 3U, &dfq::Value::characteristic);
        QVERIFY(value != file.values.end());
        QCOMPARE(*value->value, 7.5);
        QCOMPARE(*value->find(14), "S-1"s);
        QCOMPARE(*value->find(9), "read again"s);
        QCOMPARE(std::ranges::count_if(file.values, [](const auto& one) { return one.find(14) != nullptr; }), 1);
        QCOMPARE(textOf(readOrFail(dfq::write(file))), textOf(file));
    }
    void aTimeOfWordsIsNone() {
        const auto with = [](const char* time) {
            return dfq::read(
                "K0100 1\r\nK2002/1 a\r\n1.5\x14"
                "0\x14"s +
                time + "\r\n");
        };
        QVERIFY(!with("yesterday").has_value());
        QCOMPARE(with("yesterday").error().field, "K0004"s);
        for (const char* none : {"n/a", "-", "00.00.0000/00:00:00"}) {
            const auto file = with(none);
            QVERIFY2(file && !file->values.front().time && !file->oddities.empty(), none);
            QCOMPARE(textOf(readOrFail(dfq::write(*file))), textOf(*file));
        }
    }
    /// A line for all is of the part's own values: not of an older one where this part has none.
    void aLineForAllIsOfItsPart() {
        const auto file = readOrFail(
            "K0100 2\r\nK2002/1 a\r\nK2002/2 b\r\n1.1\x0F"
            "2.1\r\nK0014/0 S-1\r\n1.2\r\nK0014/0 S-2\r\n");
        QCOMPARE(file.values.size(), std::size_t{3});
        QCOMPARE(*file.values[1].find(14), "S-1"s);
        QCOMPARE(*file.values[2].find(14), "S-2"s);
        QCOMPARE(textOf(readOrFail(dfq::write(file))), textOf(file));
    }
    void aLimitThatIsNoNumberIsOdd() {
        const auto file = readOrFail("K0100 1\r\nK2110/1 19.9x\r\nK2111/1 20,1 mm\r\n20.0\r\n");
        QCOMPARE(*file.find(2110, 1), "19.9x"s);
        QCOMPARE(std::ranges::count_if(
                     file.oddities, [](const auto& odd) { return odd.text.find("is no number") != std::string::npos; }),
                 1);
    }
    void aMarkForNoValueIsNone() {
        const auto file = readOrFail(
            "K0100 2\r\nK2002/1 a\r\nK2002/2 b\r\n***\x14"
            "256\x0F"
            "1.5\x14"
            "0\r\nn.a.\x14"
            "0\x0F"
            "1.5\x14"
            "0\r\n");
        QCOMPARE(file.values.size(), std::size_t{4});
        QVERIFY(!file.values[0].value && !file.values[2].value);
        QCOMPARE(file.values[0].attribute, dfq::kNoValue);
        QCOMPARE(textOf(readOrFail(dfq::write(file))), textOf(file));
    }
};

QTEST_GUILESS_MAIN(TestDfqWriters)
#include "tst_dfq_writers.moc"
