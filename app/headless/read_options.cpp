// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/headless/read_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <map>

#include "app/files/table.h"

namespace kerf::headless {
namespace {

const std::map<std::string, char> kSeparators{{";", ';'},    {"semicolon", ';'}, {",", ','},     {"comma", ','},
                                              {"|", '|'},    {"pipe", '|'},      {"tab", '\t'},  {"\t", '\t'},
                                              {"\\t", '\t'}, {"blank", ' '},     {"space", ' '}, {" ", ' '}};
const std::map<std::string, char> kDecimals{{",", ','}, {"comma", ','}, {".", '.'}, {"point", '.'}};

const std::map<std::string, files::DateOrder> kDates{{"day-first", files::DateOrder::DayFirst},
                                                     {"month-first", files::DateOrder::MonthFirst},
                                                     {"year-first", files::DateOrder::YearFirst}};

template <class Value>
auto oneOf(const std::map<std::string, char>& names, Value apply) {
    return [names, apply](const std::string& text) {
        const auto found = names.find(text);
        if (found == names.end()) {
            return false;
        }
        apply(found->second);
        return true;
    };
}

}  // namespace

std::shared_ptr<files::ReadOptions> addReadOptions(CLI::App& command) {
    auto options = std::make_shared<files::ReadOptions>();
    command
        .add_option_function<std::string>(
            "--separator",
            [options](const std::string& text) {
                if (!oneOf(kSeparators, [&](char c) { options->separator = c; })(text)) {
                    throw CLI::ValidationError("--separator", text + " is none; expected , ; | tab or blank");
                }
            },
            "Between the fields of the file: , ; | tab or blank (found out without it)")
        ->type_name("CHAR");
    command
        .add_option_function<std::string>(
            "--decimal",
            [options](const std::string& text) {
                if (!oneOf(kDecimals, [&](char c) { options->decimal = c; })(text)) {
                    throw CLI::ValidationError("--decimal", text + " is none; expected . or ,");
                }
            },
            "Decimal mark of the file: . or , (found out without it)")
        ->type_name("CHAR");
    command
        .add_option_function<std::string>(
            "--encoding",
            [options](const std::string& text) {
                options->encoding = files::encodingOf(text);
                if (!options->encoding) {
                    throw CLI::ValidationError("--encoding",
                                               text + " is unknown; expected utf-8, utf-16, windows-1252 or cp949");
                }
            },
            "Of the file's text: utf-8, utf-16, windows-1252 or cp949 (found out without it)")
        ->type_name("NAME");
    command
        .add_option_function<std::string>(
            "--dates", [options](const std::string& text) { options->dates = kDates.at(text); },
            "Of dates like 03/04/2026: day-first, month-first or year-first (found out without it)")
        ->check(CLI::IsMember({"day-first", "month-first", "year-first"}))
        ->type_name("ORDER");
    command
        .add_option("--columns", options->names,
                    "Names of the columns of a file without a header line, comma-separated; - leaves one out")
        ->delimiter(',');
    command.add_option("--period-s", options->period_s, "Seconds between the rows of a file without a time column")
        ->check(CLI::Range(1e-9, 1e6));
    command.add_flag("--accept-implausible", options->acceptImplausible,
                     "Take values that cannot be meant: a decade, an inch, hours for minutes, what a console would ask "
                     "about");
    return options;
}

void tell(const std::vector<std::string>& notes) {
    for (const std::string& note : notes) {
        fmt::print(stderr, "kerf: {}\n", note);
    }
}

void tellNotes(const files::Table& table) {
    tell(table.notes());
}

}  // namespace kerf::headless
