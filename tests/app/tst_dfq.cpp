// SPDX-License-Identifier: GPL-3.0-or-later
#include <rapidcheck.h>

#include <QFile>
#include <QTest>
#include <algorithm>
#include <string>
#include <vector>

#include "app/files/dfq.h"
#include "engine/core/random.h"

using namespace std::string_literals;

namespace {

using namespace kerf;

const std::string kHead =
    "K0100 2\r\nK1001/1 08/15\r\nK1002/1 Welle\r\nK2001/1 1.1\r\nK2002/1 L\xE4nge\r\nK2004/1 0\r\nK2002/2 Tiefe\r\n"
    "K4092/1 17\r\nK4093/1 Kim\r\n";

/// What a copy must keep: all of a value but empty fields and the order of the values among characteristics.
struct Kept {
    std::uint32_t characteristic{0};
    std::optional<double> value{};
    int attribute{0};
    std::optional<dfq::Time> time{};
    std::vector<std::uint32_t> events{};
    std::vector<std::pair<int, std::string>> fields{};
    bool operator==(const Kept&) const = default;
};

std::vector<Kept> keptOf(const dfq::File& file) {
    std::vector<Kept> all;
    for (std::uint32_t i = 1; i <= file.characteristics; ++i) {
        for (const dfq::Value& value : file.values) {
            if (value.characteristic != i) {
                continue;
            }
            Kept kept{i, value.value, value.attribute, value.time, value.events, {}};
            for (const dfq::Field& field : value.fields) {
                if (!field.text.empty()) {
                    kept.fields.emplace_back(field.key, field.text);
                }
            }
            std::ranges::sort(kept.fields);
            all.push_back(std::move(kept));
        }
    }
    return all;
}

dfq::File readOrFail(const std::string& bytes) {
    const auto file = dfq::read(bytes);
    if (!file) {
        qFatal("line %zu, %s: %s", file.error().line, file.error().field.c_str(), file.error().text.c_str());
    }
    return *file;
}

bool copiesEqually(const dfq::File& file) {
    const auto copy = dfq::read(dfq::write(file));
    return copy && keptOf(*copy) == keptOf(file) && copy->entries == file.entries &&
           copy->characteristics == file.characteristics;
}

bool mentions(const dfq::File& file, const char* text) {
    return std::ranges::any_of(
        file.oddities, [text](const dfq::Oddity& oddity) { return oddity.text.find(text) != std::string::npos; });
}

}  // namespace

class TestDfq : public QObject {
    Q_OBJECT
 private slots:
    void tenFieldsWithEverything() {
        const auto file = readOrFail(kHead +
                                     "9.94\x14"
                                     "0\x14"
                                     "12.08.1999/15:23:45\x14"
                                     "1,3,4\x14#Charge 7\x14"
                                     "3\x14"
                                     "17\x14"
                                     "5\x14"
                                     "60\x14"
                                     "2\x0F"
                                     "1.25\x14"
                                     "255\x14"
                                     "12.08.1999/15:23:46\x14\x14#\x14\x14\x14\x14\x14\r\n"
                                     "K0009/1 nachgemessen\r\nK0014/0 Teil 4711\r\n");
        QCOMPARE(file.characteristics, 2U);
        QVERIFY(file.oddities.empty());
        QCOMPARE(file.values.size(), std::size_t{2});
        const dfq::Value& first = file.values[0];
        QCOMPARE(*first.value, 9.94);
        QCOMPARE(first.attribute, 0);
        QVERIFY((first.time == dfq::Time{1999, 8, 12, 15, 23, 45.0}));
        QVERIFY((first.events == std::vector<std::uint32_t>{1, 3, 4}));
        QCOMPARE(*first.find(6), "Charge 7"s);
        QCOMPARE(*first.find(7), "3"s);
        QCOMPARE(*first.find(8), "17"s);
        QCOMPARE(*first.find(10), "5"s);
        QCOMPARE(*first.find(11), "60"s);
        QCOMPARE(*first.find(12), "2"s);
        QCOMPARE(*first.find(9), "nachgemessen"s);
        QCOMPARE(*first.find(14), "Teil 4711"s);
        QCOMPARE(file.values[1].attribute, dfq::kVoid);
        QCOMPARE(*file.values[1].find(14), "Teil 4711"s);
        QVERIFY(file.values[1].find(9) == nullptr);
        QCOMPARE(*file.find(2002, 1), "L\xC3\xA4nge"s);
        QCOMPARE(*file.find(4093, 1), "Kim"s);
        QVERIFY(copiesEqually(file));
        QVERIFY(dfq::write(file).find("L\xE4nge\r\n") != std::string::npos);  // Windows-1252 stays Windows-1252
    }
    void twoFourAndTwelveFields() {
        const auto file = readOrFail(kHead +
                                     "1\x14"
                                     "0\x0F"
                                     "2\x14"
                                     "0\x14"
                                     "1.2.2020/3:04:05\x14"
                                     "7\r\n"
                                     "3\x14"
                                     "0\x14"
                                     "01.02.2020/03:04:05\x14\x14#\x14\x14\x14\x14\x14\x14"
                                     "x\x14"
                                     "y\r\n");
        QCOMPARE(file.values.size(), std::size_t{3});
        QVERIFY((file.values[1].events == std::vector<std::uint32_t>{7}));
        QCOMPARE(*file.values[2].find(-11), "x"s);
        QCOMPARE(*file.values[2].find(-12), "y"s);
        QVERIFY(copiesEqually(file));
    }
    void attributeCharacteristicsBeginWithSampleAndErrors() {
        const std::string head = "K0100 2\r\nK2004/1 1\r\nK2004/2 0\r\n";
        const auto file = readOrFail(head +
                                     "20000\x14"
                                     "2\x14"
                                     "0\x14"
                                     "0\x14"
                                     "19.04.1994/15:22:44\x14"
                                     "1,3,4\x14#\x14"
                                     "0\x14"
                                     "0\x14"
                                     "0\x14"
                                     "0\x14"
                                     "0\x0F"
                                     "5.5\x14"
                                     "0\r\n"
                                     "100\x14"
                                     "1\x14"
                                     "255\x14"
                                     "19.04.1994/15:22:45\r\n");
        QCOMPARE(file.values.size(), std::size_t{3});
        QCOMPARE(*file.values[0].find(20), "20000"s);
        QCOMPARE(*file.values[0].find(21), "2"s);
        QCOMPARE(*file.values[0].find(-3), "0"s);
        QVERIFY((file.values[0].time == dfq::Time{1994, 4, 19, 15, 22, 44.0}));
        QCOMPARE(file.values[2].attribute, dfq::kVoid);
        QVERIFY(copiesEqually(file));
    }
    void kLinesHoldValues() {
        const auto file = readOrFail(
            "K0100 2\r\nK1001/1 part\r\nK2001/1 a\r\nK2001/2 b\r\nK0001/1 1\r\nK0001/2 3\r\n"
            "K0004/0 1.1.2014/10:30:59\r\nK0010/0 153\r\nK0001/1 2\r\nK0001/2 4\r\n"
            "K0004/0 1.1.2014/10:31:00\r\nK0010/0 154\r\n");
        QCOMPARE(file.values.size(), std::size_t{4});
        QCOMPARE(*file.values[0].find(10), "153"s);
        QCOMPARE(*file.values[1].find(10), "153"s);
        QCOMPARE(*file.values[2].find(10), "154"s);
        QVERIFY((file.values[3].time == dfq::Time{2014, 1, 1, 10, 31, 0.0}));
        QCOMPARE(file.values[3].row, 2U);
        QVERIFY(copiesEqually(file));
    }
    void valuesOfOneCharacteristicAfterTheOtherShareRows() {
        const auto file =
            readOrFail("K0100 2\r\nK2001/1 a\r\nK0001/1 1\r\nK0001/1 1.1\r\nK2001/2 b\r\nK0001/2 2\r\nK0001/2 2.1\r\n");
        QCOMPARE(file.values[1].row, 1U);
        QCOMPARE(*file.values[1].value, 2.0);
        QCOMPARE(file.values[2].row, 2U);
        QVERIFY(copiesEqually(file));
    }
    void linesInFrontOfTheirPartBelongToIt_data() {
        QTest::addColumn<QByteArray>("index");
        QTest::newRow("of the first characteristic") << QByteArray("1");
        QTest::newRow("for all") << QByteArray("0");
    }
    void linesInFrontOfTheirPartBelongToIt() {
        QFETCH(QByteArray, index);
        const std::string key = "K0014/" + index.toStdString();
        const auto file = readOrFail("K0100 2\r\nK2001/1 a\r\nK2001/2 b\r\n" + key + " P-1\r\n1\x0F" + "2\r\n" + key +
                                     " P-2\r\n3\x0F" + "4\r\n");
        QCOMPARE(file.values.size(), std::size_t{4});
        QCOMPARE(*file.values[0].find(14), "P-1"s);
        QCOMPARE(*file.values[2].find(14), "P-2"s);
        QCOMPARE(*file.values[2].value, 3.0);
        QCOMPARE(file.values[3].row, 2U);
        QCOMPARE(file.values[1].find(14) != nullptr, index == "0");
        QVERIFY(!file.oddities.empty());
        QVERIFY(copiesEqually(file));
    }
    void aPartHasOneValueOfACharacteristic() {
        // The first line leaves out the characteristic that the field in front is of.
        const auto file = readOrFail(
            "K0100 2\r\nK2001/1 a\r\nK2001/2 b\r\nK0014/2 P-1\r\n1\r\n3\x0F"
            "4\r\n5\x0F"
            "6\r\n");
        QCOMPARE(file.values.size(), std::size_t{5});
        for (std::size_t i = 1; i < file.values.size(); ++i) {
            QVERIFY(std::pair(file.values[i - 1].row, file.values[i - 1].characteristic) <
                    std::pair(file.values[i].row, file.values[i].characteristic));
        }
        QCOMPARE(*file.values[2].value, 4.0);
        QCOMPARE(*file.values[2].find(14), "P-1"s);
        QVERIFY(copiesEqually(file));
    }
    void indexedKeysFindTheirValue() {
        const auto file = readOrFail(
            "K0100 2\r\nK2001/1 a\r\nK2001/2 b\r\n1\x14"
            "0\x0F"
            "2\x14"
            "0\r\n3\x14"
            "0\x0F"
            "4\x14"
            "0\r\n"
            "K0014/0/1 one\r\nK0053/1/0 order\r\nK0014/2/2 two\r\n");
        QCOMPARE(*file.values[0].find(14), "one"s);
        QCOMPARE(*file.values[1].find(14), "one"s);
        QVERIFY(file.values[2].find(14) == nullptr);
        QCOMPARE(*file.values[3].find(14), "two"s);
        QCOMPARE(*file.values[2].find(53), "order"s);
        QVERIFY(copiesEqually(file));
    }
    void whatIsSlightlyOffIsReadAndListed_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QByteArray>("oddity");
        const auto row = [](const char* name, const std::string& bytes, const char* oddity) {
            QTest::newRow(name) << QByteArray(bytes.data(), static_cast<qsizetype>(bytes.size())) << QByteArray(oddity);
        };
        const std::string one = "K2001/1 a\r\n";
        const std::string value =
            "1.5\x14"
            "0\x14"
            "01.02.2020/03:04:05\r\n";
        row("no K0100", one + value, "K0100 is missing");
        row("K0100 wrong", "K0100 7\r\n" + one + value, "K0100 says 7");
        row("bare line feeds",
            "K0100 1\nK2001/1 a\n1.5\x14"
            "0\n",
            "CR LF");
        row("old line ends",
            "K0100 1\rK2001/1 a\r1.5\x14"
            "0\r",
            "CR LF");
        row("printed separators",
            "K0100 1\r\n" + one +
                "1.5\xB6"
                "0\xB6"
                "01.02.2020/03:04:05\r\n",
            "instead of 0x14");
        row("printed separators of characteristics",
            "K0100 2\r\nK2001/1 a\r\nK2001/2 b\r\n1.5\x14"
            "0\xA4"
            "1.5\x14"
            "0\r\n",
            "instead of 0x0F");
        row("decimal comma",
            "K0100 1\r\n" + one +
                "1,5\x14"
                "0\r\n",
            "decimal commas");
        row("small key", "K0100 1\r\nk2001/1 a\r\n" + value, "small letters");
        row("tab behind the key", "K0100\t1\r\nK2001/1\ta\r\n1.5 \x14 0 \r\nK0009\r\nK0014//\r\n", "empty index");
        row("blank in front", "K0100 1\r\n  K2001/1 a\r\n" + value, "blanks in front");
        row("no description", "K0100 1\r\n" + value, "nothing describes");
        row("blanks apart", "K0100 1\r\n" + one + "1.5 0 01.02.2020/03:04:05\r\n", "apart by blanks");
        row("american date",
            "K0100 1\r\n" + one +
                "1.5\x14"
                "0\x14"
                "2/1/2020/3:04:05\r\n",
            "another form");
        row("zero date",
            "K0100 1\r\n" + one +
                "1.5\x14"
                "0\x14"
                "00.00.0000/00:00:00\r\n",
            "zeros");
        row("batch without #",
            "K0100 1\r\n" + one +
                "1.5\x14"
                "0\x14\x14\x14lot\r\n",
            "without #");
        row("utf-8", "K0100 1\r\nK2001/1 \xC3\xA4\r\n" + value, "utf-8");
        row("utf-8 mark", "\xEF\xBB\xBFK0100 1\r\nK2001/1 a\r\n" + value, "utf-8");
        row("text goes on", "K0100 1\r\nK1900 first\r\nsecond\r\n" + one + value, "without a key");
    }
    void whatIsSlightlyOffIsReadAndListed() {
        QFETCH(QByteArray, bytes);
        QFETCH(QByteArray, oddity);
        const auto file = readOrFail(bytes.toStdString());
        QVERIFY2(mentions(file, oddity.constData()),
                 file.oddities.empty() ? "nothing odd" : file.oddities.front().text.c_str());
        QVERIFY(!file.values.empty());
        QCOMPARE(*file.values.front().value, 1.5);
        QVERIFY(copiesEqually(file));
    }
    void trailingSeparatorsAreNoOdditiesTrailingBlanksAre() {
        const auto file = readOrFail(
            "K0100 1 \r\nK2001/1 a  \r\n1.5\x14"
            "0\x14"
            "01.02.2020/03:04:05  \x0F\r\n\r\n\x1A");
        QCOMPARE(file.oddities.size(), std::size_t{1});
        QVERIFY(mentions(file, "blanks at the ends of lines"));
        QCOMPARE(file.values.size(), std::size_t{1});
        QCOMPARE(*file.find(2001, 1), "a"s);
    }
    void valuesStandByPartThenCharacteristic() {
        const auto file =
            readOrFail("K0100 2\r\nK2001/1 a\r\nK2001/2 b\r\nK0001/1 1\r\nK0001/1 2\r\nK0001/2 3\r\nK0001/2 4\r\n");
        const double inOrder[] = {1.0, 3.0, 2.0, 4.0};
        for (std::size_t i = 0; i < 4; ++i) {
            QCOMPARE(*file.values.at(i).value, inOrder[i]);
        }
        const auto copy = readOrFail(dfq::write(file));
        for (std::size_t i = 0; i < 4; ++i) {
            QCOMPARE(*copy.values.at(i).value, inOrder[i]);
        }
    }
    void twoByteLettersAreReadWithAndWithoutAMark() {
        const std::string plain = "K0100 1\r\nK2001/1 a\r\n1.5\r\n";
        for (const bool little : {true, false}) {
            std::string wide;
            for (const char c : plain) {
                wide += little ? std::string{c, '\0'} : std::string{'\0', c};
            }
            QCOMPARE(*readOrFail(wide).values.at(0).value, 1.5);
            QCOMPARE(*readOrFail((little ? "\xFF\xFE" : "\xFE\xFF") + wide).values.at(0).value, 1.5);
        }
    }
    void descriptionAndValuesInTwoFiles() {
        auto file = readOrFail("K0100 1\r\nK1001 x\r\nK2001/1 a\r\nK2004/1 1\r\n");
        QVERIFY(dfq::readValues("1000\x14"
                                "1\x14"
                                "0\x14"
                                "0\x14"
                                "01.02.2020/03:04:05\r\n",
                                file)
                    .has_value());
        QCOMPARE(*file.values.at(0).find(21), "1"s);
        QVERIFY(copiesEqually(file));
    }
    void aMissingValueIsNoZero() {
        const auto file = readOrFail(kHead +
                                     "\x14"
                                     "256\x14"
                                     "01.02.2020/03:04:05\x0F"
                                     "1\x14"
                                     "0\r\n\x0F"
                                     "2\x14"
                                     "0\r\n");
        QCOMPARE(file.values.size(), std::size_t{3});
        QVERIFY(!file.values[0].value);
        QCOMPARE(file.values[0].attribute, dfq::kNoValue);
        QCOMPARE(file.values[2].characteristic, 2U);
        QVERIFY(copiesEqually(file));
    }
    void forAllIsBeatenByALineOfItsOwn() {
        const auto file = readOrFail("K0100 2\r\nK2142/0 mm\r\nK2142/2 um\r\nK2001/1 a\r\nK2001/2 b\r\n");
        QCOMPARE(*file.find(2142, 1), "mm"s);
        QCOMPARE(*file.find(2142, 2), "um"s);
        QVERIFY(file.find(2142, 0) != nullptr);
        QVERIFY(file.find(2101, 1) == nullptr);
    }
    void whatCannotBeReadNamesLineAndField_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<int>("line");
        QTest::addColumn<QByteArray>("field");
        const auto row = [](const char* name, const std::string& bytes, int line, const char* field) {
            QTest::newRow(name) << QByteArray(bytes.data(), static_cast<qsizetype>(bytes.size())) << line
                                << QByteArray(field);
        };
        const std::string head = "K0100 1\r\nK2001/1 a\r\n";
        row("value",
            head +
                "1.x5\x14"
                "0\r\n",
            3, "K0001");
        row("single value", head + "12..5\r\n", 3, "K0001");
        row("value far out",
            head +
                "1E+999\x14"
                "0\r\n",
            3, "K0001");
        row("attribute",
            head +
                "1\x14"
                "zero\r\n",
            3, "K0002");
        row("time",
            head +
                "1\x14"
                "0\x14"
                "31.02.2020/00:00:00\r\n",
            3, "K0004");
        row("hour",
            head +
                "1\x14"
                "0\x14"
                "01.02.2020/25:00:00\r\n",
            3, "K0004");
        row("value by key",
            head +
                "1\x14"
                "0\r\nK0001/1 abc\r\n",
            4, "K0001");
        row("index", "K0100 1\r\nK2001/1-1 a\r\n", 2, "K2001");
        row("index of a value",
            head +
                "1\x14"
                "0\r\nK0014/1/7 x\r\n",
            4, "K0014");
        row("number of characteristics", "K0100 many\r\n", 1, "K0100");
        row("text among values",
            head +
                "1\x14"
                "0\r\nhello\r\n",
            4, "K0001");
        row("sample",
            "K0100 1\r\nK2004/1 1\r\nx\x14"
            "0\r\n",
            3, "K0020");
        row("other file", "part,value\r\n1,2\r\n", 1, "line");
        row("no text", "K0100 1\r\n\0\0\0"s, 2, "line");
        row("empty", "", 0, "line");
    }
    void whatCannotBeReadNamesLineAndField() {
        QFETCH(QByteArray, bytes);
        QFETCH(int, line);
        QFETCH(QByteArray, field);
        const auto file = dfq::read(bytes.toStdString());
        QVERIFY(!file.has_value());
        QCOMPARE(static_cast<int>(file.error().line), line);
        QCOMPARE(QByteArray::fromStdString(file.error().field), field);
        QVERIFY(!file.error().text.empty());
    }
    void timesInCirculation_data() {
        QTest::addColumn<QByteArray>("text");
        for (const char* text :
             {"09.05.2018/10:05:59", "9.5.18/10:5:59", "5/9/2018/10:05:59", "05/09/18 10:05:59", "2018-05-09/10:05:59",
              "18-5-9 10:05:59", "9.5.2018.10:05:59", "2018-05-09T10:05:59", "5/9/2018 10:05:59 AM"}) {
            QTest::newRow(text) << QByteArray(text);
        }
    }
    void timesInCirculation() {
        QFETCH(QByteArray, text);
        const auto time = dfq::timeOf(text.toStdString());
        QVERIFY((time == dfq::Time{2018, 5, 9, 10, 5, 59.0}));
        QCOMPARE(dfq::timeText(*time), "09.05.2018/10:05:59"s);
    }
    void noTimes() {
        for (const char* text : {"", "1", "20/05/2018/18:05:10", "2018.05.20/18:05:10", "1.1.2020/10", "1.1.2020/10:61",
                                 "1.1.2020x10:10", "29.02.2019/00:00:00", "1.13.2020/00:00"}) {
            QVERIFY2(!dfq::timeOf(text), text);
        }
        QVERIFY(dfq::timeOf("29.02.2020/00:00").has_value());
        QVERIFY(dfq::timeOf("29.02.2020").has_value());
    }
    void numbersInCirculation() {
        QCOMPARE(*dfq::numberOf("1.99930000000000E+1"), 19.993);
        QCOMPARE(*dfq::numberOf("+10,5"), 10.5);
        QCOMPARE(*dfq::numberOf("-.5"), -0.5);
        for (const char* text : {"", "1 2", "1.2.3", "nan", "inf", "0x10", "+-1", "1e", "12a"}) {
            QVERIFY2(!dfq::numberOf(text), text);
        }
    }
    void everyByteOfWindows1252SurvivesACopy() {
        std::string text = "K0100 1\r\nK2001/1 x";
        for (int byte = 0x80; byte < 0x100; ++byte) {
            text += static_cast<char>(static_cast<unsigned char>(byte));
        }
        text += "x\r\n";
        QCOMPARE(dfq::write(readOrFail(text)), text);
    }
    void whatWindows1252CannotHoldIsWrittenAsUtf8() {
        auto file = readOrFail(
            "K0100 1\r\nK2001/1 a\r\n1\x14"
            "0\r\n");
        file.entries.front().text = "\xEB\x82\xB4\xEA\xB2\xBD";
        QVERIFY(copiesEqually(file));
    }
    /// Any file a program can build comes back equal.
    void copyPropertyOfBuiltFiles() {
        const bool held = rc::check("copy is equal", [] {
            const auto count = *rc::gen::inRange<std::uint32_t>(1, 6);
            dfq::File file;
            file.characteristics = count;
            const auto letters = rc::gen::container<std::string>(rc::gen::elementOf("abZ09 .,#/;:-_+\xC2\xA4"s));
            const auto clean = [&](std::string text) {
                std::erase_if(text, [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
                const auto first = text.find_first_not_of(' ');
                return first == std::string::npos ? std::string{}
                                                  : text.substr(first, text.find_last_not_of(' ') - first + 1);
            };
            std::vector<bool> attribute;
            for (std::uint32_t i = 1; i <= count; ++i) {
                attribute.push_back(*rc::gen::arbitrary<bool>());
                file.entries.push_back({2001, i, {}, std::to_string(i)});
                file.entries.push_back({2004, i, {}, attribute.back() ? "1" : "0"});
                file.entries.push_back({2002, i, {}, clean(*letters)});
            }
            const auto rows = *rc::gen::inRange<std::uint32_t>(0, 6);
            for (std::uint32_t row = 1; row <= rows; ++row) {
                for (std::uint32_t i = 1; i <= count; ++i) {
                    if (*rc::gen::inRange(0, 4) == 0) {
                        continue;
                    }
                    dfq::Value value;
                    value.characteristic = i;
                    value.row = row;
                    const auto add = [&](int key, std::string text) {
                        if (!text.empty()) {
                            value.fields.push_back({key, std::move(text)});
                        }
                    };
                    if (attribute[i - 1]) {
                        add(20, std::to_string(*rc::gen::inRange(0, 100000)));
                        add(21, std::to_string(*rc::gen::inRange(0, 100)));
                    } else {
                        value.value = *rc::gen::inRange(-1000000, 1000000) / 1024.0;
                        add(1, QByteArray::number(*value.value, 'g', 17).toStdString());
                    }
                    if (*rc::gen::arbitrary<bool>()) {
                        value.attribute = *rc::gen::element(0, 255, 256, 1);
                        add(2, std::to_string(value.attribute));
                    }
                    if (*rc::gen::arbitrary<bool>()) {
                        value.time =
                            dfq::Time{*rc::gen::inRange(1970, 2100), *rc::gen::inRange(1, 13),
                                      *rc::gen::inRange(1, 29),      *rc::gen::inRange(0, 24),
                                      *rc::gen::inRange(0, 60),      static_cast<double>(*rc::gen::inRange(0, 60))};
                        add(4, dfq::timeText(*value.time));
                    }
                    if (*rc::gen::arbitrary<bool>()) {
                        value.events = *rc::gen::container<std::vector<std::uint32_t>>(rc::gen::inRange(0U, 99999U));
                        std::string list;
                        for (const auto event : value.events) {
                            list += (list.empty() ? "" : ",") + std::to_string(event);
                        }
                        add(5, list);
                    }
                    for (const int key : {6, 7, 8, 10, 11, 12, 9, 14, 16, 53, 97}) {
                        if (*rc::gen::inRange(0, 3) == 0) {
                            add(key, clean(*letters));
                        }
                    }
                    if (value.fields.empty()) {
                        add(2, "0");
                    }
                    file.values.push_back(std::move(value));
                }
            }
            RC_ASSERT(copiesEqually(file));
        });
        QVERIFY(held);
    }
    void datesWithSlashesAreReadByWhatTheWholeFileSays() {
        const auto line = [](const char* first, const char* second) {
            return std::string("1\x14") + "0\x14" + first + "\x0F" + "2\x14" + "0\x14" + second + "\r\n";
        };
        const auto american = readOrFail(kHead + line("05/06/2020 03:04:05", "06/13/2020 03:04:05"));
        QVERIFY((american.values[0].time == dfq::Time{2020, 5, 6, 3, 4, 5.0}));
        // The thirteenth is no month: every date of the file has its day first, the one before it too.
        const auto european = readOrFail(kHead + line("05/06/2020 03:04:05", "13/06/2020 03:04:05"));
        QVERIFY((european.values[0].time == dfq::Time{2020, 6, 5, 3, 4, 5.0}));
        QVERIFY((european.values[1].time == dfq::Time{2020, 6, 13, 3, 4, 5.0}));
        QVERIFY(mentions(european, "the day in front"));
        QVERIFY(copiesEqually(european));
        QVERIFY(!dfq::read(kHead + line("13/06/2020 03:04:05", "06/13/2020 03:04:05")));  // both cannot be
    }
    void datesThatMayBeTwoDaysAreRefusedAndCanBeSaid() {
        const auto line = [](const char* first, const char* second) {
            return std::string("1\x14") + "0\x14" + first + "\x0F" + "2\x14" + "0\x14" + second + "\r\n";
        };
        const std::string text = kHead + line("03/04/2026 03:04:05", "05/06/2026 03:04:05");
        const auto refused = dfq::read(text);
        QVERIFY(!refused);
        QVERIFY(refused.error().field == "K0004" && refused.error().line == 10);
        QVERIFY(refused.error().text.find("--dates") != std::string::npos);
        QVERIFY((dfq::read(text, dfq::SlashDates::DayFirst)->values[0].time == dfq::Time{2026, 4, 3, 3, 4, 5.0}));
        QVERIFY((dfq::read(text, dfq::SlashDates::MonthFirst)->values[0].time == dfq::Time{2026, 3, 4, 3, 4, 5.0}));
        // the same day either way; the format's own form; AM
        for (const char* clear : {"04/04/2026 03:04:05", "03/04/2026/03:04:05", "3/4/2026 03:04:05 AM"}) {
            QVERIFY2(dfq::read(kHead + line(clear, "27.11.2026/03:04:05")).has_value(), clear);
        }
    }
    void slightlyOddFilesSayWhatIsOdd() {
        const std::string values =
            "1\x14"
            "0\x14"
            "1.2.2020/3:04:05\x14"
            "1 3;4\x0F"
            "2\x14"
            "0  \r\n";
        const auto file = readOrFail(kHead + values);
        QVERIFY((file.values[0].events == std::vector<std::uint32_t>{1, 3, 4}));
        QVERIFY(mentions(file, "events apart by blanks") && mentions(file, "blanks at the ends"));
        QVERIFY(copiesEqually(file));
        QVERIFY(mentions(readOrFail(kHead + values + kHead + values), "once more"));
        // "내경" in CP949, as a Korean plant's own machines write it.
        const auto korean = readOrFail(
            "K0100 1\r\nK2002/1 \xB3\xBB\xB0\xE6\r\n1\x14"
            "0\r\n");
        QVERIFY(korean.encoding == dfq::Encoding::Cp949);
        QCOMPARE(*korean.find(2002, 1), "\xEB\x82\xB4\xEA\xB2\xBD"s);
        QVERIFY(copiesEqually(korean));
    }
    /// Whatever bytes come, reading ends; what was read copies equally.
    void fuzzedFilesAreReadOrRefused() {
        const std::string seed = kHead +
                                 "9.94\x14"
                                 "0\x14"
                                 "12.08.1999/15:23:45\x14"
                                 "1,3\x14#C 7\x14"
                                 "3\x14"
                                 "17\x14"
                                 "5\x14"
                                 "60\x14"
                                 "2\x0F"
                                 "1\x14"
                                 "0\r\n"
                                 "K0009/1 t\r\nK0001/2 5\r\nK0004/2 1.1.2020/1:1:1\r\nK0014/0 x\r\n2\x14"
                                 "0\r\n";
        kerf::Random random(20);
        const std::string pieces = "K0/1234567890.,\x0F\x14\r\n #E+-\xA4\xB6 ";
        std::size_t readable = 0;
        constexpr int kFiles = 20'000;
        for (int i = 0; i < kFiles; ++i) {
            std::string bytes = seed;
            const int changes = 1 + static_cast<int>(random.uniform() * 4.0);
            for (int change = 0; change < changes; ++change) {
                const auto at = static_cast<std::size_t>(random.uniform() * static_cast<double>(bytes.size()));
                const char with =
                    pieces[static_cast<std::size_t>(random.uniform() * static_cast<double>(pieces.size()))];
                const double what = random.uniform();
                if (what < 0.4) {
                    bytes[at] = with;
                } else if (what < 0.7) {
                    bytes.insert(at, 1, with);
                } else {
                    bytes.erase(at, 1 + static_cast<std::size_t>(random.uniform() * 6.0));
                }
            }
            const auto file = dfq::read(bytes);
            if (file) {
                ++readable;
                QVERIFY2(copiesEqually(*file), QByteArray::fromStdString(bytes).toPercentEncoding().constData());
            }
        }
        QVERIFY2(readable > kFiles / 4, qPrintable(QString::number(readable)));
    }
};

QTEST_GUILESS_MAIN(TestDfq)
#include "tst_dfq.moc"
