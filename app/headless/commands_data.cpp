// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>
#include <QLockFile>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "app/files/output.h"
#include "app/files/table.h"
#include "app/headless/commands.h"
#include "app/headless/data_file.h"
#include "app/service/quality/part_judge.h"
#include "db/api/csv_export.h"
#include "db/data_file.h"
#include "db/location.h"
#include "db/migrator.h"
#include "db/readers/database_reader.h"
#include "db/restore.h"
#include "engine/process/boring/lot_tracker.h"

namespace kerf::headless {
namespace {

struct DataOptions {
    std::string folder{};
    std::string table{};
    std::string process{};
    std::string text{};
    std::string copy{};
    std::string author{};
    std::string reason{};
    std::string separator{","};
    std::string decimal{"."};
    bool excel{false};
    bool localTime{false};
};

std::vector<std::string> processKeys() {
    std::vector<std::string> keys;
    for (const ProcessDescriptor* process : processes()) {
        keys.emplace_back(process->key);
    }
    return keys;
}

PartQuery queryOf(const DataOptions& options) {
    PartQuery query;
    query.text = options.text;
    if (const ProcessDescriptor* process = findProcess(std::string_view(options.process))) {
        query.process = process->id;
    }
    return query;
}

/// The feed a part was cut with, as the law takes it.
std::optional<double> feedAt(const PartDetail& detail, double overhang_mm) {
    boring::CutPart cut;
    cut.number = detail.part.number;
    cut.schedule = detail.schedule ? detail.schedule->schedule : BoringSchedule{};
    cut.feed = detail.feed;
    if (cut.feed.count == 0 && cut.schedule.revision == 0) {
        return std::nullopt;
    }
    const double feed_mmPerRev = boring::cutFeed_mmPerRev(cut, overhang_mm);
    return feed_mmPerRev > 0.0 && std::isfinite(feed_mmPerRev) ? std::optional(feed_mmPerRev) : std::nullopt;
}

CsvFormat formatOf(const DataOptions& options) {
    CsvFormat format;
    format.separator = options.separator == "tab" ? '\t' : options.separator.front();
    format.decimal = options.decimal.front();
    format.localTime = options.localTime || options.excel;
    if (format.separator == format.decimal) {
        throw CLI::ValidationError("--decimal", "a comma cannot separate fields and decimals; add --separator ';'");
    }
    return format;
}

void exportTable(const DataOptions& options) {
    const CsvFormat format = formatOf(options);
    const QtForSql qt;
    const std::string path = checkedDataFile(options.folder);
    const auto reader = openReader(path);
    // Collected first: a file that turns out to be damaged in its middle leaves nothing half-written.
    std::string text;
    const CsvSink sink = [&text](std::string_view piece) {
        text += piece;
        return true;
    };
    const PartQuery query = queryOf(options);
    PartJudge judge(*reader, *reader);
    const VerdictOf verdictOf = judge.forExport();
    const Result<std::uint64_t> rows =
        options.table == "parts"          ? exportParts(*reader, query, sink, format, verdictOf)
        : options.table == "bores"        ? exportBores(*reader, query, feedAt, sink, format)
        : options.table == "measurements" ? exportMeasurements(*reader, query, sink, format)
        : options.table == "figures"      ? exportFigures(*reader, query, sink, format, verdictOf)
        : options.table == "feed"         ? exportFeed(*reader, query, sink, format)
        : options.table == "lots"         ? exportLots(*reader, query.process, sink, format)
        : options.table == "recipes"      ? exportRecipes(*reader, query.process, sink, format)
                                          : exportAudit(*reader, sink, format);
    if (!rows) {
        throw BadInput(fmt::format("{}: {}", path, rows.error().english()));
    }
    const bool forExcel = options.excel || format.separator != ',' || format.decimal != '.' || format.localTime;
    const bool ascii = std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
    if (forExcel && !ascii) {
        text.insert(0, "\xEF\xBB\xBF");
    }
    files::writeOut(text);
}

void verify(const DataOptions& options) {
    const QtForSql qt;
    const std::string path = checkedDataFile(options.folder);
    const Result<AuditVerdict> verdict = openReader(path)->verifyAudit();
    if (!verdict) {
        throw BadInput(fmt::format("{}: {}", path, verdict.error().english()));
    }
    nlohmann::ordered_json report;
    report["file"] = path;
    report["intact"] = verdict->finding.empty();
    report["entries"] = verdict->entries;
    report["measurements"] = verdict->measurements;
    report["room_records"] = verdict->roomRecords;
    report["redacted"] = verdict->redacted;
    report["head_hash"] = verdict->headHash;
    if (!verdict->finding.empty()) {
        report["finding"] = verdict->finding.english();
        if (verdict->firstBad) {
            report["first_bad"] = *verdict->firstBad;
        }
    }
    printJson(report);
    if (!verdict->finding.empty()) {
        throw BadInput(fmt::format("{}: {}", path, verdict->finding.english()));
    }
}

void check(const DataOptions& options) {
    const QtForSql qt;
    const std::string path = checkedDataFile(options.folder);
    if (const Result<void> whole = db::checkDatabase(path); !whole) {
        throw BadInput(fmt::format("{}: {}", path, whole.error().english()));
    }
    const auto reader = openReader(path);
    nlohmann::ordered_json report;
    report["file"] = path;
    report["version"] = db::builtInMigrations().size();
    report["intact"] = true;
    report["bytes"] = std::filesystem::file_size(path);
    report["parts"] = reader->count({}, INT64_MAX).value_or(0);
    printJson(report);
}

void backup(const DataOptions& options) {
    const QtForSql qt;
    const std::string path = checkedDataFile(options.folder);
    if (const Result<void> copied = db::backupDatabase(path, options.copy); !copied) {
        throw BadInput(fmt::format("{}: {}", options.copy, copied.error().english()));
    }
    nlohmann::ordered_json report;
    report["file"] = path;
    report["backup"] = options.copy;
    report["bytes"] = std::filesystem::file_size(options.copy);
    printJson(report);
}

void restore(const DataOptions& options) {
    const QtForSql qt;
    const std::string path = db::databaseFile(options.folder);
    if (const auto lock = db::lockDataFile(path); !lock) {  // before anything lies ready for the next start
        throw BadInput(fmt::format("{}: {}", path, lock.error().english()));
    }
    if (const auto ready = db::layReady(path, {options.copy, options.author, options.reason}); !ready) {
        throw BadInput(fmt::format("{}: {}", options.copy, ready.error().english()));
    }
    const auto file = db::DataFile::open(path);
    if (!file) {
        throw BadInput(fmt::format("{}: {}", path, file.error().english()));
    }
    nlohmann::ordered_json report;
    report["file"] = path;
    report["restored"] = options.copy;
    report["set_aside"] = (*file)->finding().setAside;
    printJson(report);
}

}  // namespace

void addDataCommands(CLI::App& kerf) {
    const auto options = std::make_shared<DataOptions>();
    CLI::App* data = kerf.add_subcommand(
        "data", "The data file: export, check, back up (they only read; the console may run meanwhile), restore");
    data->require_subcommand(1);
    const auto add = [&](const char* name, const char* help, void (*run)(const DataOptions&)) {
        CLI::App* command = data->add_subcommand(name, help);
        command->add_option("--data", options->folder, "Folder of kerf.db (default: the user's data folder)");
        command->callback([options, run] { run(*options); });
        return command;
    };
    CLI::App* exporting = add("export", "A table as CSV on stdout, oldest first", exportTable);
    exporting
        ->add_option(
            "table", options->table,
            "parts, bores, measurements, figures, feed, lots, recipes or audit; kerf boring replay reads bores")
        ->required()
        ->check(CLI::IsMember({"parts", "bores", "measurements", "figures", "feed", "lots", "recipes", "audit"}));
    exporting->add_option("--process", options->process, "Only parts, lots or recipes of this process")
        ->check(CLI::IsMember(processKeys()));
    exporting->add_option("--search", options->text,
                          "Only parts whose serial number begins with, or whose lot or part type contains this text");
    exporting->add_option("--separator", options->separator, "Between fields: , ; | or tab")
        ->check(CLI::IsMember({",", ";", "|", "tab"}))
        ->capture_default_str();
    exporting->add_option("--decimal", options->decimal, "Decimal mark: . or , (with another separator)")
        ->check(CLI::IsMember({".", ","}))
        ->capture_default_str();
    exporting->add_flag("--local-time", options->localTime, "Local time of each row behind its UTC");
    exporting->add_flag("--excel", options->excel, "Local time, and a byte order mark where names need it");
    add("verify",
        "Recomputes the audit chain and that of the parts, compares measurements, kept records, recipes, lots and "
        "settings "
        "with it, and the file with the head noted at its last commit; exit 3 when something is broken or missing",
        verify);
    add("check", "SQLite's integrity check, references, version, and all that verify looks at; exit 3 when damaged",
        check);
    CLI::App* restoring =
        add("restore",
            "Puts a checked backup in the place of the data file, which is set aside under a name of its own; "
            "not while a console runs",
            restore);
    restoring->add_option("file", options->copy, "The backup")->required();
    restoring->add_option("--author", options->author, "Who does it, for the audit log")->required();
    restoring->add_option("--reason", options->reason, "Why, for the audit log")->required();
    add("backup", "A checked copy in one file, also while the console runs", backup)
        ->add_option("file", options->copy, "New file; an existing one is never overwritten")
        ->required();
}

}  // namespace kerf::headless
