// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <regex>
#include <vector>

#include "app/machines/machine_file.h"
#include "app/machines/machine_module_loader.h"

namespace kerf::console {

namespace {

/// "simulator", or "replay" and a file. @throws CLI::ParseError
void takeMachine(const std::vector<std::string>& words, Options& options) {
    const bool replay = words[0] == "replay";
    std::vector<std::string> known = machineModules();
    known.insert(known.begin(), {"simulator", "diamond-lathe"});
    known.emplace_back("replay");
    if (std::ranges::find(known, words[0]) == known.end()) {
        throw CLI::ValidationError("--machine", fmt::format("{} not in {{{}}}", words[0], fmt::join(known, ",")));
    }
    if (replay != (words.size() == 2)) {
        throw CLI::ValidationError("--machine",
                                   replay ? "replay needs the file of a recorded day" : "only replay takes a file");
    }
    options.machine = words[0];
    options.replayFile = replay ? words[1] : std::string{};
}

}  // namespace

std::optional<Options> parseOptions(int argc, char** argv, int& exitCode) {
    Options options;
    std::string size;
    std::vector<std::string> machine{options.machine};
    CLI::App app("Kerf: operator console for CNC machine tools, with the built-in simulator or a real control.",
                 "kerf-console");
    app.set_version_flag("--version", KERF_VERSION);
    app.add_option("--data", options.dataDir, "Folder of the database and the log (default: the user's data folder)");
    app.add_option(
           "--machine", machine,
           "Machine to work with: simulator (the built-in machining centre), diamond-lathe (the built-in diamond "
           "turning lathe), linuxcnc or another module beside the program, or replay FILE (a recorded day comes again)")
        ->expected(1, 2)
        ->capture_default_str();
    app.add_option(
        "--machine-file", options.machineFile,
        "Machine file (JSON, docs/linuxcnc.md): units, spindle geometry, travel, limits of Kerf's outputs, who "
        "hosts what, addresses; it names the machine itself when --machine does not");
    app.add_option(
        "--sensors", options.sensors,
        "Sensor file of the machine (JSON, docs/sensors.md): temperatures and gauges beside what it brings itself");
    app.add_option("--speed", options.simulationSpeed,
                   "Simulator: machine time per wall time, 1 to 1000; 0 = as fast as it can")
        ->check(CLI::Range(0.0, 1000.0))
        ->check([](const std::string& text) {  // which that range lets pass
            return text.find_first_of("nN") == std::string::npos ? std::string() : text + " is no number";
        })
        ->capture_default_str();
    app.add_option("--seed", options.seed, "Simulator: seed of its noise")->capture_default_str();
    app.add_option("--machine-seed", options.machineSeed,
                   "Simulator: a hard machine drawn from this seed (boring, milling, tapping, thermal, turning); 0: "
                   "the reference machine")
        ->capture_default_str();
    app.add_option("--season", options.season,
                   "Simulator: what differs today from the days the thermal model was trained on: none, coolant, door, "
                   "sun, moved, nonlinear")
        ->check(CLI::IsMember({"none", "coolant", "door", "sun", "moved", "nonlinear"}))
        ->capture_default_str();
    app.add_option("--change-at-part", options.changeAtPart,
                   "Simulator: part from which another insert cuts (the process changes); 0 = never")
        ->check(CLI::Range(0, 100000))
        ->capture_default_str();
    app.add_option("--lot-size", options.lotSize, "Parts of a lot that is new, 1 to 100000")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    app.add_option("--prepared-parts", options.preparedParts,
                   "Simulator: parts bored and measured beforehand when the lot is new, 0 to 100")
        ->check(CLI::Range(0, 100))
        ->capture_default_str();
    app.add_flag("--auto-operator", options.autoOperator, "Simulator: every bore is gauged and entered by itself");
    app.add_option("--language", options.language, "Language of the screen")->check(CLI::IsMember({"en", "ko"}));
    app.add_option("--theme", options.theme, "Light or dark screen")->check(CLI::IsMember({"light", "dark"}));
    app.add_option("--unit", options.unit, "Length unit of the screen")->check(CLI::IsMember({"mm", "inch"}));
    app.add_option("--size", size, "Window size, WIDTHxHEIGHT in pixels")->check([](const std::string& text) {
        return std::regex_match(text, std::regex("[1-9][0-9]{2,4}x[1-9][0-9]{2,4}"))
                   ? std::string()
                   : "must be WIDTHxHEIGHT in pixels, such as 1280x800";
    });
    app.add_flag("--full-screen", options.fullScreen, "Take the whole screen");
    app.add_option("--screenshots", options.screenshotDir, "Render every page to PNG into this folder and end");
    app.add_flag("--time-start", options.timeStart,
                 "Print one line on stdout once the first page has been painted with its content, and end");
    app.add_flag("--print-acceptances", options.printAcceptances,
                 "Print one line on stdout for every accepted measurement, once it is safely on disk");
    try {
        app.parse(argc, argv);
        takeMachine(machine, options);
        if (!options.machineFile.empty()) {
            const MachineFile file =
                readMachineFile(options.machineFile, app.count("--machine") > 0 ? options.machine : std::string());
            options.machine = file.machine;
            options.described = file.description;
        }
    } catch (const CLI::ParseError& error) {
        app.exit(error);
        exitCode = error.get_exit_code() == 0 ? 0 : 2;
        return std::nullopt;
    } catch (const MachineFileFault& fault) {
        std::fprintf(stderr, "kerf-console: %s\n", fault.what());
        exitCode = 3;
        return std::nullopt;
    }
    if (!size.empty()) {
        const auto cross = size.find('x');
        options.size = QSize(std::stoi(size.substr(0, cross)), std::stoi(size.substr(cross + 1)));
    }
    return options;
}

}  // namespace kerf::console
