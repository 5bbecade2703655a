// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <filesystem>
#include <memory>

#include "app/files/output.h"
#include "app/files/table.h"
#include "app/headless/commands.h"
#include "app/headless/data_file.h"
#include "db/api/csv_export.h"
#include "db/location.h"
#include "db/migrator.h"
#include "db/readers/database_reader.h"

namespace kerf::headless {
namespace {

struct DataOptions {
    std::string folder{};
    std::string table{};
    std::string process{};
    std::string text{};
    std::string copy{};
};

PartQuery queryOf(const DataOptions& options) {
    PartQuery query;
    query.text = options.text;
    for (const ProcessId id : kAllProcesses) {
        if (options.process == processKey(id)) {
            query.process = id;
        }
    }
    return query;
}

void exportTable(const DataOptions& options) {
    const QtForSql qt;
    const std::string path = checkedDatabase(options.folder);
    const auto reader = openDatabase(path);
    // Collected first: a file that turns out to be damaged in its middle leaves nothing half-written.
    std::string text;
    const CsvSink sink = [&text](std::string_view piece) {
        text += piece;
        return true;
    };
    const PartQuery query = queryOf(options);
    const Result<std::uint64_t> rows = options.table == "parts"          ? exportParts(*reader, query, sink)
                                       : options.table == "measurements" ? exportMeasurements(*reader, query, sink)
                                       : options.table == "figures"      ? exportFigures(*reader, query, sink)
                                       : options.table == "feed"         ? exportFeed(*reader, query, sink)
                                                                         : exportAudit(*reader, sink);
    if (!rows) {
        throw BadInput(fmt::format("{}: {}", path, rows.error().english()));
    }
    std::fwrite(text.data(), 1, text.size(), stdout);
    std::fflush(stdout);
}

void verify(const DataOptions& options) {
    const QtForSql qt;
    const std::string path = checkedDatabase(options.folder);
    const Result<AuditVerdict> verdict = openDatabase(path)->verifyAudit();
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
    const std::string path = checkedDatabase(options.folder);
    if (const Result<void> whole = db::checkDatabase(path); !whole) {
        throw BadInput(fmt::format("{}: {}", path, whole.error().english()));
    }
    const auto reader = openDatabase(path);
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
    const std::string path = checkedDatabase(options.folder);
    if (const Result<void> copied = db::backupDatabase(path, options.copy); !copied) {
        throw BadInput(fmt::format("{}: {}", options.copy, copied.error().english()));
    }
    nlohmann::ordered_json report;
    report["file"] = path;
    report["backup"] = options.copy;
    report["bytes"] = std::filesystem::file_size(options.copy);
    printJson(report);
}

}  // namespace

void addDataCommands(CLI::App& kerf) {
    const auto options = std::make_shared<DataOptions>();
    CLI::App* data =
        kerf.add_subcommand("data", "The data file: export, check, back up. Only reads; the console may run meanwhile");
    data->require_subcommand(1);
    const auto add = [&](const char* name, const char* help, void (*run)(const DataOptions&)) {
        CLI::App* command = data->add_subcommand(name, help);
        command->add_option("--data", options->folder, "Folder of kerf.db (default: the user's data folder)");
        command->callback([options, run] { run(*options); });
        return command;
    };
    CLI::App* exporting = add("export", "A table as CSV on stdout, oldest first", exportTable);
    exporting->add_option("table", options->table, "parts, measurements, figures, feed or audit")
        ->required()
        ->check(CLI::IsMember({"parts", "measurements", "figures", "feed", "audit"}));
    exporting->add_option("--process", options->process, "Only parts of this process")
        ->check(CLI::IsMember({"boring", "milling", "turning", "thermal", "tapping"}));
    exporting->add_option("--search", options->text,
                          "Only parts whose serial number begins with, or whose lot or part type contains this text");
    add("verify",
        "Recomputes the audit chain, compares measurements, kept records, recipes and settings with it, and the file "
        "with "
        "the head noted at its last commit; exit 3 when something is broken or missing",
        verify);
    add("check", "SQLite's integrity check, references, version, and all that verify looks at; exit 3 when damaged",
        check);
    add("backup", "A checked copy in one file, also while the console runs", backup)
        ->add_option("file", options->copy, "New file; an existing one is never overwritten")
        ->required();
}

}  // namespace kerf::headless
