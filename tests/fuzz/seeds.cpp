// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/seeds.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <initializer_list>
#include <string_view>

#include "app/files/whole_file.h"
#include "tests/fuzz/any_reader.h"

namespace kerf::test {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBeginning = 1200;  ///< of a long table: where tables differ
constexpr std::size_t kLargest = 3000;

constexpr std::string_view kLabview =
    "LabVIEW Measurement\t\nWriter_Version\t2\nReader_Version\t2\nSeparator\tTab\nDecimal_Separator\t,\n"
    "Multi_Headings\tNo\nX_Columns\tOne\nTime_Pref\tAbsolute\nOperator\tK\n***End_of_Header***\t\n\t\nChannels\t2\n"
    "Samples\t3\t3\nY_Unit_Label\tNewton\tVolt\nX_Dimension\tTime\tTime\nX0\t0,0E+0\t0,0E+0\nDelta_X\t0,0002\t0,0002\n"
    "***End_of_Header***\t\t\t\nX_Value\tforce_y_n\tangle_rev\tComment\n0,0\t1,5\t0,01\n0,0002\t1,6\t0,06\n"
    "0,0004\t1,7\t0,11\n";
constexpr std::string_view kHalscope =
    "# halscope\nspindle.0.revs;joint.2.pos-fb;spindle.0.speed-in\n0.1;-0.2;50\n0.2;-0.3;50\noverrun\n0.3;-0.4;50\n";
constexpr std::string_view kQdas =
    "K0100 1\nK1001 4711\nK1002 flange\nK2001/1 1\nK2002/1 bore\nK2110/1 49.95\nK2111/1 50.05\nK2142/1 mm\n"
    "50.011\x14\x30\x14"
    "27.11.2026/08:15:00\x14#1\n49.998\x0f"
    "50.002\n";
constexpr std::string_view kGauges =
    "01A+00012.345\n911\n+12.3456mm\n  +12,345 \n12 50.011\n02A-00050.000\n+9999999999.9in\n";
constexpr std::string_view kBores =
    "Teil;Position [mm];Vorschub [mm/U];Durchmesser [mm]\n1;310;0,5;49,951\n1;175;0,5;49,97\n2;310;0,41;50,011\n";

constexpr auto kWords = std::to_array<std::string_view>({"t_min",
                                                         "t_s",
                                                         "rpm",
                                                         "T00",
                                                         "spindle_rev",
                                                         "angle_rev",
                                                         "z_mm",
                                                         "x_mm",
                                                         "height_mm",
                                                         "force_y_n",
                                                         "[mm/rev]",
                                                         "(\xC2\xB0"
                                                         "C)",
                                                         "#N/A",
                                                         "9.9E+37",
                                                         "-----",
                                                         "-9999",
                                                         "1372",
                                                         "1e308",
                                                         "1e-308",
                                                         "nan",
                                                         "***End_of_Header***",
                                                         "Decimal_Separator\t,",
                                                         "X_Columns\tNo",
                                                         "Channels\t99999999",
                                                         "Samples\t4294967296",
                                                         "sep=;",
                                                         "\xBF\xC2\xB5\xB5",
                                                         "\xFF\xFE",
                                                         "\xEF\xBB\xBF",
                                                         "\r\n",
                                                         "\r",
                                                         "0,5",
                                                         "1.234,5",
                                                         "\"",
                                                         "\"\"",
                                                         ",,,,",
                                                         ";;",
                                                         "\t\t",
                                                         "|",
                                                         "{",
                                                         "}",
                                                         "[[[[[[",
                                                         "]",
                                                         "null",
                                                         "true",
                                                         "\"name\":",
                                                         "\"modules\"",
                                                         "1e99999",
                                                         "18446744073709551616",
                                                         "-1",
                                                         "2026-11-27T08:15:03Z",
                                                         "08:15:03",
                                                         "K2001/99999",
                                                         "K0097/1",
                                                         "\x0f",
                                                         "\x14",
                                                         "overrun"});

std::string beginning(const fs::path& path) {
    std::string text = files::readFile(path.string());
    return text.size() > kBeginning && path.extension() == ".csv" ? text.substr(0, kBeginning) : text;
}

std::string wide(std::string_view text) {
    std::string out = "\xFF\xFE";
    for (const char c : text) {
        out += c;
        out += '\0';
    }
    return out;
}

void add(std::vector<std::string>& out, std::string_view text, std::initializer_list<int> readers) {
    for (const int reader : readers) {
        out.push_back(std::string{static_cast<char>(reader), '\0'} + std::string(text));
    }
}

std::vector<fs::path> filesUnder(const fs::path& folder, std::string_view extension) {
    std::vector<fs::path> out;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file() && entry.path().extension() == extension) out.push_back(entry.path());
    }
    std::ranges::sort(out);  // the same on every file system
    return out;
}

std::size_t below(std::size_t limit, std::mt19937_64& random) {
    return limit == 0 ? 0 : random() % limit;  // the same with every library
}

void change(std::string& text, const std::vector<std::string>& inputs, std::mt19937_64& random) {
    const std::size_t at = below(text.size(), random);
    const std::size_t length = below(std::min<std::size_t>(text.size() - at, 64), random) + 1;
    switch (below(9, random)) {
        case 0:
            text[at] = static_cast<char>(random());
            return;
        case 1:
            text.erase(at, length);
            return;
        case 2:
            text.insert(at, text.substr(at, length));
            return;
        case 3:
        case 4:
            text.insert(at, kWords[below(kWords.size(), random)]);
            return;
        case 5: {
            const std::string& other = inputs[below(inputs.size(), random)];
            text.insert(at, other.substr(below(other.size(), random), length * 4));
            return;
        }
        case 6:
            std::ranges::replace(text, ",;\t|"[below(4, random)], ",;\t| .\n"[below(7, random)]);
            return;
        case 7:
            text.resize(at);
            return;
        default: {
            const std::string_view word = kWords[below(kWords.size(), random)];
            text.replace(at, std::min(word.size(), text.size() - at), word);
            return;
        }
    }
}

}  // namespace

std::vector<std::string> seedInputs(const std::string& source) {
    std::vector<std::string> out;
    for (const fs::path& path : filesUnder(fs::path(source) / "tests/fixtures", ".csv")) {
        add(out, beginning(path), {0, 1, 2, 3, 7, 8, 9, 13, 14});
    }
    for (const char* folder : {"tests/fixtures/golden", "resources/rehearsals", "resources/sensors"}) {
        for (const fs::path& path : filesUnder(fs::path(source) / folder, ".json")) {
            if (const std::string text = beginning(path); text.size() < kLargest) add(out, text, {4, 5, 6, 10, 12});
        }
    }
    for (const std::string_view table : {kLabview, kHalscope, kBores}) {
        add(out, table, {0, 1, 8, 9, 13});
        add(out, wide(table), {0, 1});
    }
    add(out, kGauges, {11});
    add(out, kQdas, {0, kReaders - 1});
    return out;
}

std::string mutated(const std::vector<std::string>& inputs, std::mt19937_64& random) {
    const std::string& from = inputs[below(inputs.size(), random)];
    std::string text = from.substr(2);
    for (std::size_t changes = 1 + below(6, random); changes > 0 && !text.empty(); --changes) {
        change(text, inputs, random);
    }
    if (below(12, random) == 0) {
        text = wide(text);
    }
    if (text.size() > kLargest) {
        text.resize(kLargest);
    }
    const bool sameReader = below(4, random) != 0;
    const char reader = sameReader ? from[0] : static_cast<char>(below(kReaders, random));
    const char options = below(2, random) == 0 ? '\0' : static_cast<char>(random());
    return std::string{reader, options} + text;
}

}  // namespace kerf::test
