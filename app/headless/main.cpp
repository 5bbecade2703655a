// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <exception>
#include <nlohmann/json.hpp>

#include "app/files/table.h"
#include "app/headless/commands.h"

namespace {
constexpr int kDone = 0;
constexpr int kWrongUsage = 2;
constexpr int kBadInput = 3;
constexpr int kProgramFault = 1;

/// No option takes "nan": CLI::Range lets it pass, because it asks whether a value lies outside.
void refuseNan(CLI::App& app) {
    for (CLI::Option* option : app.get_options()) {
        if (option->get_type_name().starts_with("FLOAT")) {
            option->check([](const std::string& text) {
                double value = 0.0;
                const bool number = CLI::detail::lexical_cast(text, value);
                return number && std::isnan(value) ? text + " is no number" : std::string();
            });
        }
    }
    for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; })) {
        refuseNan(*command);
    }
}
}  // namespace

int main(int argc, char** argv) {
    CLI::App kerf(
        "Kerf without a screen: replay, simulate and train with the engine of the console.\n"
        "CSV or JSON on stdout, diagnostics on stderr. Exit 0 done, 2 wrong usage, 3 bad input.",
        "kerf");
    kerf.require_subcommand(1);
    for (const auto& add : kerf::headless::kCommands) {
        add(kerf);
    }
    refuseNan(kerf);
    try {
        kerf.parse(argc, argv);
        kerf::files::finishOut();  // what was printed by other means is on the disk, or this is no success
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
            return kerf.exit(error);  // --help and --version
        }
        kerf.exit(error);
        return kWrongUsage;
    } catch (const kerf::headless::BadInput& error) {
        std::fprintf(stderr, "kerf: %s\n", error.what());
        return kBadInput;
    } catch (const nlohmann::json::exception& error) {  // a document of the right form with a value of the wrong kind
        std::fprintf(stderr, "kerf: the JSON file is not as expected: %s\n", error.what());
        return kBadInput;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "kerf: program fault: %s\n", error.what());
        return kProgramFault;
    }
    return kDone;
}
