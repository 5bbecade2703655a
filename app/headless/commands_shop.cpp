// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QFile>
#include <QProcess>
#include <csignal>
#include <cstdio>
#include <memory>

#include "app/files/output.h"
#include "app/files/table.h"
#include "app/headless/commands.h"
#include "app/headless/data_file.h"
#include "db/connection.h"
#include "db/shop/outbox.h"
#include "db/shop/shop_push.h"
#include "db/shop/shop_schema.h"
#include "db/shop/shop_sender.h"
#include "db/shop/shop_verify.h"
#include "db/statement.h"

/// `kerf shop …`: many consoles, one PostgreSQL.
namespace kerf::headless {
namespace {

struct ShopOptions {
    std::string folder{};
    std::string database{};
    std::string name{};
    bool json{false};
    bool once{false};
    bool allowUnenrolled{false};
};

db::Interrupt* endOfPush = nullptr;

std::string csvText(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) {
        return text;
    }
    std::string quoted = "\"";
    for (const char c : text) {
        quoted += c == '"' ? "\"\"" : std::string(1, c);
    }
    return quoted + "\"";
}

/// Runs `work` with a connection; what goes wrong is one sentence.
template <class Work>
void withServer(const ShopOptions& options, const Work& work) {
    const std::string conninfo = checkedConninfo("--database", options.database);
    const db::Interrupt interrupt;
    try {
        db::PgConnection server(conninfo, interrupt);
        work(server);
    } catch (const db::PgFailure& failure) {
        if (failure.kind() == db::PgFailure::Kind::NoSchema) {
            throw BadInput(
                "--database: there is no shop in this database (or an older one); run \"kerf shop init\" first.");
        }
        throw BadInput(fmt::format("--database: {}", failure.what()));
    } catch (const db::SqlFailure& failure) {
        throw BadInput(failure.sentence().english());
    }
}

void init(const ShopOptions& options) {
    const QtForSql qt;
    withServer(options, [&](db::PgConnection& server) {
        const db::ShopSchemaReport made = db::prepareShop(server);
        if (options.allowUnenrolled) {
            db::allowUnenrolled(server, true);
        }
        nlohmann::ordered_json report;
        report["from_version"] = made.fromVersion;
        report["schema_version"] = made.toVersion;
        report["allow_unenrolled"] =
            server.value("SELECT value FROM shop.server_settings WHERE key = 'allow_unenrolled'") == "true";
        report["roles"] = {"kerf_console", "kerf_reader"};
        printJson(report);
    });
}

db::ShopIdentity identityOf(const std::string& file) {
    const db::Connection connection(file, db::Access::Read);
    return db::OutboxReader(connection.database()).identity();
}

/// Key and certificate request by OpenSSL's own program; an existing key is kept.
std::string makeRequest(const std::string& file, const std::string& role) {
    const QDir folder(QString::fromStdString(file) + QStringLiteral("/../shop"));
    QDir().mkpath(folder.absolutePath());
    const QString key = QDir::cleanPath(folder.absoluteFilePath(QStringLiteral("console.key")));
    const QString request = QDir::cleanPath(folder.absoluteFilePath(QStringLiteral("console.csr")));
    const auto openssl = [](const QStringList& arguments) {
        QProcess process;
        process.start(QStringLiteral("openssl"), arguments);
        if (!process.waitForStarted(5000) || !process.waitForFinished(30000) || process.exitCode() != 0) {
            throw BadInput(fmt::format("the certificate request could not be made: {}",
                                       process.error() == QProcess::FailedToStart
                                           ? std::string("the program openssl is not installed")
                                           : process.readAllStandardError().trimmed().toStdString()));
        }
    };
    if (!QFile::exists(key)) {
        openssl({QStringLiteral("genpkey"), QStringLiteral("-algorithm"), QStringLiteral("EC"),
                 QStringLiteral("-pkeyopt"), QStringLiteral("ec_paramgen_curve:P-256"), QStringLiteral("-out"), key});
    }
    QFile::setPermissions(key, QFile::ReadOwner | QFile::WriteOwner);  // libpq refuses a key that others can read
    openssl({QStringLiteral("req"), QStringLiteral("-new"), QStringLiteral("-key"), key, QStringLiteral("-subj"),
             QStringLiteral("/CN=") + QString::fromStdString(role), QStringLiteral("-out"), request});
    return request.toStdString();
}

void enroll(const ShopOptions& options) {
    const QtForSql qt;
    const std::string file = checkedDataFile(options.folder);
    const db::ShopIdentity who = identityOf(file);
    const std::string role = db::consoleRole(who.store);
    const std::string name = options.name.empty() ? role : options.name;
    const std::string request = makeRequest(file, role);
    if (!options.database.empty()) {
        withServer(options, [&](db::PgConnection& server) { db::enrolConsole(server, {who.store, role, name}); });
    }
    nlohmann::ordered_json report;
    report["store"] = who.store;
    report["role"] = role;
    report["name"] = name;
    report["certificate_request"] = request;
    report["registered"] = !options.database.empty();
    printJson(report);
}

void status(const ShopOptions& options) {
    const QtForSql qt;
    withServer(options, [&](db::PgConnection& server) {
        const auto rows = server.query(
            "SELECT c.store, c.epoch, c.newest::int, c.reason, c.machine, c.program, c.last_seq, c.last_trace_seq, "
            "extract(epoch FROM now() - c.last_contact), c.quarantined, c.clock_offset_ms, s.first_contact "
            "FROM shop.consoles c JOIN shop.stores s ON s.store = c.store AND s.epoch = c.epoch "
            "ORDER BY c.store, s.first_contact");
        const auto integer = [](const std::optional<std::string>& text) { return std::stoll(text.value_or("0")); };
        nlohmann::ordered_json stores = nlohmann::ordered_json::array();
        CsvOutput csv("store,epoch,newest,machine,last_seq,last_trace_seq,age_s,quarantined,clock_offset_ms");
        for (const db::PgRow& row : rows) {
            nlohmann::ordered_json one;
            one["store"] = *row[0];
            one["epoch"] = *row[1];
            one["newest"] = integer(row[2]) == 1;
            one["reason"] = row[3].value_or("");
            one["machine"] = row[4].value_or("");
            one["program"] = row[5].value_or("");
            one["last_seq"] = integer(row[6]);
            one["last_trace_seq"] = integer(row[7]);
            one["age_s"] = std::stod(row[8].value_or("0"));
            one["quarantined"] = integer(row[9]);
            one["clock_offset_ms"] = integer(row[10]);
            csv.row(*row[0], *row[1], integer(row[2]) == 1, csvText(row[4].value_or("")), integer(row[6]),
                    integer(row[7]), std::stod(row[8].value_or("0")), integer(row[9]), integer(row[10]));
            stores.push_back(std::move(one));
        }
        if (options.json) {
            nlohmann::ordered_json report;
            report["schema_version"] = integer(server.value("SELECT max(version) FROM shop.schema_steps"));
            report["stores"] = std::move(stores);
            printJson(report);
        } else {
            csv.flush();
        }
    });
}

void printProgress(const db::ShopProgress& progress) {
    nlohmann::ordered_json report;
    report["store"] = progress.identity.store;
    report["epoch"] = progress.identity.epoch;
    report["new_epoch"] = progress.newEpoch;
    if (progress.newEpoch) {
        report["reason"] = progress.identity.reason;
    }
    report["sent"] = progress.entriesSent;
    report["quarantined"] = progress.setAside;
    report["last_seq"] = progress.streams[0].last;
    report["last_trace_seq"] = progress.streams[1].last;
    report["unsent"] = progress.unsent();
    report["clock_offset_ms"] = progress.clockOffset_ms;
    printJson(report);
}

std::string sentenceOf(const db::ShopFailure& failure) {
    switch (failure.trouble()) {
        case db::ShopTrouble::NotPrepared:
            return "--database: there is no shop in this database; run \"kerf shop init\" first.";
        case db::ShopTrouble::NotAllowed:
            return fmt::format("--database: the shop refuses this console ({}); see \"kerf shop enroll\".",
                               failure.what());
        case db::ShopTrouble::NewerConsole:
            return fmt::format("this console is newer than the shop and waits: {}.", failure.what());
        default:
            return fmt::format("the shop cannot be reached: {}; nothing is lost, the rest waits here.", failure.what());
    }
}

void push(const ShopOptions& options) {
    const QtForSql qt;
    const std::string file = checkedDataFile(options.folder);
    const std::string conninfo = checkedConninfo("--database", options.database);
    db::Interrupt interrupt;
    if (!options.once) {
        endOfPush = &interrupt;
        std::signal(SIGINT, [](int) { endOfPush->trigger(); });
        std::signal(SIGTERM, [](int) { endOfPush->trigger(); });
        db::runShopSender(file, conninfo, interrupt, [](const db::ShopState& state) {
            if (state.trouble != db::ShopTrouble::None) {
                std::fprintf(stderr, "kerf: %s\n", sentenceOf(db::ShopFailure(state.trouble, state.detail)).c_str());
            }
        });
        return;
    }
    db::ShopPush pushing(file, conninfo, interrupt);
    try {
        pushing.connect();
        while (pushing.step()) {
        }
    } catch (const db::ShopFailure& failure) {
        throw BadInput(sentenceOf(failure));
    }
    printProgress(pushing.progress());
}

void verify(const ShopOptions& options) {
    const QtForSql qt;
    const std::string file = checkedDataFile(options.folder);
    withServer(options, [&](db::PgConnection& server) {
        const db::ShopComparison found = db::compareWithShop(file, server);
        nlohmann::ordered_json report;
        report["store"] = found.store;
        report["epoch"] = found.epoch;
        report["equal"] = !found.difference;
        report["rows"] = found.rows;
        if (found.difference) {
            report["first_difference"] = {
                {"table", found.difference->table}, {"key", found.difference->key}, {"what", found.difference->what}};
        }
        printJson(report);
        if (found.difference) {
            throw BadInput(
                fmt::format("{} {}: {}", found.difference->table, found.difference->key, found.difference->what));
        }
    });
}

}  // namespace

void addShopCommands(CLI::App& kerf) {
    const auto options = std::make_shared<ShopOptions>();
    CLI::App* shop =
        kerf.add_subcommand("shop", "Many consoles, one memory: a PostgreSQL that gets every row exactly once");
    shop->require_subcommand(1);
    const auto add = [&](const char* name, const char* help, void (*run)(const ShopOptions&)) {
        CLI::App* command = shop->add_subcommand(name, help);
        command->callback([options, run] { run(*options); });
        return command;
    };
    const auto data = [&](CLI::App* command) {
        command->add_option("--data", options->folder, "Folder of kerf.db (default: the user's data folder)");
    };
    const auto database = [&](CLI::App* command) {
        return command->add_option("--database", options->database, "Connection to PostgreSQL as libpq takes it");
    };
    CLI::App* initCommand = add("init", "Makes schema, roles and rights, or brings them up to date; JSON", init);
    database(initCommand)->required();
    initCommand->add_flag("--allow-unenrolled", options->allowUnenrolled, "A server for tests: any console may push");
    CLI::App* enrollCommand =
        add("enroll",
            "Makes the console's key and certificate request and, with --database, registers it there "
            "(by an owner of the schema); JSON",
            enroll);
    data(enrollCommand);
    database(enrollCommand);
    enrollCommand->add_option("--name", options->name, "What people call this console (default: its role)");
    CLI::App* statusCommand =
        add("status", "Every history in the shop: how far, how old, what was put aside; CSV", status);
    database(statusCommand)->required();
    statusCommand->add_flag("--json", options->json, "JSON instead of CSV");
    CLI::App* pushCommand =
        add("push", "Sends what the shop does not have yet; without --once it goes on until it is ended", push);
    data(pushCommand);
    database(pushCommand)->required();
    pushCommand->add_flag("--once", options->once, "End when everything is sent; JSON");
    CLI::App* verifyCommand =
        add("verify", "Compares every row with the shop; exit 3 with the first that differs", verify);
    data(verifyCommand);
    database(verifyCommand)->required();
}

}  // namespace kerf::headless
