// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>

#include "app/files/dfq_description.h"
#include "app/files/dfq_files.h"
#include "app/files/output.h"
#include "app/files/table.h"
#include "app/headless/commands_quality.h"
#include "app/headless/quality_lot.h"
#include "app/service/quality/lot_dfq.h"

namespace kerf::headless {
namespace {

using nlohmann::ordered_json;

struct DfqOptions {
    std::vector<std::string> files{};
    std::string folder{};
    std::string lot{};
    std::string in{};
    std::string out{};
    bool history{false};
    bool json{false};
    std::optional<dfq::SlashDates> dates{};
};

void addDates(CLI::App& command, const std::shared_ptr<DfqOptions>& options) {
    command
        .add_option_function<std::string>(
            "--dates",
            [options](const std::string& text) {
                options->dates = text == "day-first" ? dfq::SlashDates::DayFirst : dfq::SlashDates::MonthFirst;
            },
            "Of dates with slashes (03/04/2026): day-first or month-first (without it the file must tell)")
        ->check(CLI::IsMember({"day-first", "month-first"}));
}

std::string keyName(int key) {
    return key < 0 ? fmt::format("place_{}", -key) : fmt::format("K{:04}", key);
}

ordered_json fieldsOf(const std::map<int, std::string>& fields) {
    ordered_json json = ordered_json::object();
    for (const auto& [key, text] : fields) {
        json[keyName(key)] = text;
    }
    return json;
}

/// Fields of parts or characteristics by their index; what stands for all first, a line of its own above it.
class Described {
 public:
    Described(const dfq::File& file, bool (*belongs)(int)) {
        for (const dfq::Entry& entry : file.entries) {
            if (belongs(entry.key)) {
                m_fields[entry.index.value_or(1)][entry.key] = entry.text;
            }
        }
    }
    [[nodiscard]] std::map<int, std::string> of(std::uint32_t index) const {
        std::map<int, std::string> fields;
        for (const std::uint32_t place : {0U, index}) {
            if (const auto found = m_fields.find(place); found != m_fields.end()) {
                for (const auto& [key, text] : found->second) {
                    fields[key] = text;
                }
            }
        }
        return fields;
    }
    [[nodiscard]] std::uint32_t last() const { return m_fields.empty() ? 0 : m_fields.rbegin()->first; }

 private:
    std::map<std::uint32_t, std::map<int, std::string>> m_fields{};
};

std::string textOf(const dfq::Value& value, int key) {
    const std::string* text = value.find(key);
    return text == nullptr ? std::string{} : *text;
}

ordered_json valueJson(const dfq::Value& value) {
    ordered_json json;
    json["characteristic"] = value.characteristic;
    json["row"] = value.row;
    json["value"] = value.value ? ordered_json(*value.value) : ordered_json(nullptr);
    json["attribute"] = value.attribute;
    json["time"] = textOf(value, 4);
    json["events"] = value.events;
    json["batch"] = textOf(value, 6);
    json["nest"] = textOf(value, 7);
    json["operator"] = textOf(value, 8);
    json["machine"] = textOf(value, 10);
    json["process_parameter"] = textOf(value, 11);
    json["gauge"] = textOf(value, 12);
    std::map<int, std::string> fields;
    for (const dfq::Field& field : value.fields) {
        if (!field.text.empty()) {
            std::string& text = fields[field.key];
            text += text.empty() ? "" : "\n";
            text += field.text;
        }
    }
    json["fields"] = fieldsOf(fields);
    return json;
}

/// Stands where the values come in: as a document of their own they would need many times their text.
constexpr std::string_view kValuesHere = "\"\x7f values\"";

ordered_json fileJson(const std::string& path, const dfq::File& file) {
    ordered_json json;
    json["file"] = path;
    json["encoding"] = dfq::encodingName(file.encoding);
    json["parts"] = ordered_json::array();
    const Described parts(file, dfq::isOfPart);
    for (std::uint32_t i = 1; i <= parts.last(); ++i) {
        json["parts"].push_back({{"index", i}, {"fields", fieldsOf(parts.of(i))}});
    }
    json["characteristics"] = ordered_json::array();
    const Described characteristics(file, dfq::isOfCharacteristic);
    for (std::uint32_t i = 1; i <= file.characteristics; ++i) {
        const auto fields = characteristics.of(i);
        const auto name = fields.find(2002);
        json["characteristics"].push_back({{"index", i},
                                           {"name", name == fields.end() ? std::string{} : name->second},
                                           {"fields", fieldsOf(fields)}});
    }
    json["other"] = ordered_json::array();  // catalogues, groups, structure
    for (const dfq::Entry& entry : file.entries) {
        if (!dfq::isOfPart(entry.key) && !dfq::isOfCharacteristic(entry.key)) {
            json["other"].push_back({{"key", keyName(entry.key)},
                                     {"index", entry.index ? ordered_json(*entry.index) : ordered_json(nullptr)},
                                     {"text", entry.text}});
        }
    }
    json["values"] = "\x7f values";
    json["oddities"] = ordered_json::array();
    for (const dfq::Oddity& oddity : file.oddities) {
        json["oddities"].push_back(
            {{"line", oddity.line == 0 ? ordered_json(nullptr) : ordered_json(oddity.line)}, {"text", oddity.text}});
    }
    return json;
}

std::string fileText(const std::string& path, const dfq::File& file) {
    constexpr auto kBadBytes = ordered_json::error_handler_t::replace;
    std::string text = fileJson(path, file).dump(2, ' ', false, kBadBytes);
    const std::size_t at = text.find(kValuesHere);
    const std::string behind = text.substr(at + kValuesHere.size());
    text.erase(at);
    text += '[';
    for (std::size_t i = 0; i < file.values.size(); ++i) {
        text += i == 0 ? "\n    " : ",\n    ";
        text += valueJson(file.values[i]).dump(-1, ' ', false, kBadBytes);
    }
    text += file.values.empty() ? "]" : "\n  ]";
    return text + behind;
}

void read(const DfqOptions& options) {
    const auto files = readDfqFiles(options.files, options.dates);
    if (files.size() == 1) {
        files::writeOut(fileText(files.front().first, files.front().second) + "\n");
        return;
    }
    std::string text = "{\n\"files\": [";
    for (std::size_t i = 0; i < files.size(); ++i) {
        text += (i == 0 ? "\n" : ",\n") + fileText(files[i].first, files[i].second);
    }
    files::writeOut(text + "\n]\n}\n");
}

void write(const DfqOptions& options) {
    const StoredLot stored = storedLot(options.folder, options.lot);
    const LotQuality quality = analyseLot(stored.history, stored.limits, stored.announced);
    const dfq::File file =
        lotDfq(stored.history, quality, options.history ? DfqContent::History : DfqContent::Standing);
    writeDfqFile(options.out, file);
    printJson({{"file", options.out},
               {"lot", stored.history.lot.name},
               {"characteristics", file.characteristics},
               {"parts", stored.history.parts.size()},
               {"values", file.values.size()}});
}

void copy(const DfqOptions& options) {
    const auto files = readDfqFiles({options.in}, options.dates);
    const dfq::File& file = files.front().second;
    writeDfqFile(options.out, file);
    printJson({{"file", options.out},
               {"characteristics", file.characteristics},
               {"values", file.values.size()},
               {"oddities", file.oddities.size()}});
}

}  // namespace

void addQualityDfq(CLI::App& quality) {
    CLI::App* dfq = quality.add_subcommand("dfq", "Q-DAS ASCII transfer (AQDEF): read, write, copy");
    dfq->require_subcommand(1);
    const auto options = std::make_shared<DfqOptions>();
    CLI::App* reading = dfq->add_subcommand(
        "read",
        "DFQ files, or a DFD with its DFX (the other one of the pair is found by itself), as JSON: parts,\n"
        "characteristics with their fields, values with all additional data, and what was odd. Several files: "
        "\"files\".\n"
        "What cannot be understood ends with exit 3, its line and its field.");
    reading->add_option("files", options->files, "DFQ, DFD or DFX")->required();
    reading->add_flag("--json", options->json, "JSON (the only form)");
    addDates(*reading, options);
    reading->callback([options] { read(*options); });

    CLI::App* writing =
        dfq->add_subcommand("write", "A lot of the data file as DFQ; the file appears whole or not at all");
    writing->add_option("--data", options->folder, "Folder of kerf.db (default: the user's data folder)");
    writing->add_option("--lot", options->lot, "name or number of the lot")->required();
    writing->add_option("-o,--output", options->out, "DFQ to write")->required();
    writing->add_flag("--history", options->history, "every replaced value too, as void (K0002 255)");
    writing->callback([options] { write(*options); });

    CLI::App* copying = dfq->add_subcommand(
        "copy", "Read and write again: equal values, attributes, times, events and references to catalogues");
    copying->add_option("in", options->in, "DFQ, or one of DFD and DFX")->required();
    copying->add_option("out", options->out, "DFQ to write")->required();
    addDates(*copying, options);
    copying->callback([options] { copy(*options); });
}

}  // namespace kerf::headless
