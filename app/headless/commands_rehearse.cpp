// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>

#include "app/files/output.h"
#include "app/files/table.h"
#include "app/headless/commands.h"
#include "app/machines/machine_file.h"
#include "app/machines/machine_module_loader.h"
#include "app/rehearsal/rehearsal.h"
#include "engine/port/state_keys.h"

namespace kerf::headless {
namespace {

struct RehearseOptions {
    std::string scenario{};
    std::string machine{};
    std::string machineFile{};
    bool csv{false};
    bool summary{false};
    double every_ms{0.0};
};

constexpr const char* kHeader =
    "t_s,link,machine_on,program,feed_mm_s,programmed_feed_mm_s,planned_feed_mm_s,feed_scale,feed_hold,stop_latched,"
    "stop_reason,offset_x_um,offset_y_um,offset_z_um,tool_trim_um,z_trim_um,state_boring,state_milling,state_turning,"
    "state_thermal,state_tapping,alarms";

const char* linkKey(LinkState link) {
    return link == LinkState::Up ? "up" : link == LinkState::Connecting ? "connecting" : "down";
}

std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) {
        return text;
    }
    std::string out = "\"";
    for (const char letter : text) {
        out += letter == '"' ? "\"\"" : std::string(1, letter);
    }
    return out + '"';
}

void writeRow(CsvOutput& csv, const rehearsal::Row& row) {
    const MachineInputs& in = row.machine;
    std::string alarms;
    for (const AlarmCode code : row.alarms) {
        alarms += (alarms.empty() ? "" : "+") + std::to_string(code);
    }
    const auto state = [&](ProcessId id) {
        return row.console ? stateKey(row.states[static_cast<std::size_t>(id)]) : "";
    };
    csv.row(row.t_s, linkKey(in.link), in.machineOn, stateKey(in.program), in.actualFeed_mmPerS.value,
            in.programmedFeed_mmPerS.value, row.plannedFeed_mmPerS, in.appliedFeedScale.value, in.feedHold,
            row.stopLatched, quoted(row.stopReason), in.workOffset_um[0].value, in.workOffset_um[1].value,
            in.workOffset_um[2].value, in.toolTrim_um.value, in.zTrim_um.value, state(ProcessId::Boring),
            state(ProcessId::Milling), state(ProcessId::Turning), state(ProcessId::Thermal), state(ProcessId::Tapping),
            alarms);
}

std::unique_ptr<MachinePort> connected(const MachineDescription& described, bool onlyRead) {
    auto machine = loadMachine("linuxcnc", described);
    if (!machine) {
        throw BadInput(machine.error().english());
    }
    if (onlyRead) {
        (*machine)->onlyRead();
    }
    if (const auto done = (*machine)->connect(); !done) {
        throw BadInput(done.error().english());
    }
    return std::move(*machine);
}

/// A machine that does not answer, or that another program commands, is no place to rehearse on.
void waitForMachine(MachinePort& machine) {
    using Steady = std::chrono::steady_clock;
    constexpr auto kPatience = std::chrono::seconds(1);
    MachineInputs inputs;
    for (const auto end = Steady::now() + kPatience; inputs.link != LinkState::Up && Steady::now() < end;) {
        machine.read((Steady::now() - end).count(), inputs);  // before the rehearsal's time, which begins at 0
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    if (inputs.link != LinkState::Up) {
        throw BadInput(
            "--machine linuxcnc: the machine is not reached: it does not run, or its HAL file does not "
            "load kerf-hal.");
    }
    if (const Capability& start = machine.capabilities().cycleStart; !start.fitted) {
        throw BadInput(std::string("--machine linuxcnc: ") + start.why.english());
    }
}

void rehearse(const RehearseOptions& options) {
    std::string machineKind = options.machine;
    MachineDescription described;
    if (!options.machineFile.empty()) {
        try {
            const MachineFile file = readMachineFile(options.machineFile, options.machine);
            machineKind = file.machine;
            described = file.description;
        } catch (const MachineFileFault& fault) {
            throw BadInput(fault.what());
        }
    }
    rehearsal::Scenario scenario = rehearsal::readScenario(readFile(options.scenario), options.scenario, machineKind);
    if (!described.hosts[static_cast<std::size_t>(scenario.process)]) {
        throw BadInput(options.machineFile + ": hosts: does not name " + processKey(scenario.process) +
                       ", the scenario's process.");
    }
    scenario.limits = described.limits;
    for (const std::string& remark : scenario.remarks) {
        std::fprintf(stderr, "kerf: %s\n", remark.c_str());
    }
    std::unique_ptr<MachinePort> commanded;
    std::unique_ptr<MachinePort> seen;
    std::optional<rehearsal::RealMachine> real;
    if (scenario.machine == rehearsal::MachineKind::LinuxCnc) {
        seen = connected(described, true);
        commanded = connected(described, false);
        waitForMachine(*commanded);
        real.emplace(rehearsal::RealMachine{*commanded, *seen});
    }
    rehearsal::Summary summary;
    if (options.summary) {
        summary = rehearsal::rehearse(scenario, real ? &*real : nullptr, 0.0, {});
        printJson(rehearsal::summaryJson(scenario, summary));
    } else {
        CsvOutput csv(kHeader);
        summary = rehearsal::rehearse(scenario, real ? &*real : nullptr, options.every_ms / 1000.0,
                                      [&](const rehearsal::Row& row) { writeRow(csv, row); });
        csv.flush();
    }
    if (real && summary.programRuns) {
        std::fputs(
            "kerf: the rehearsal has ended while a program runs: it goes on without Kerf, at most at its planned feed. "
            "End it at the control.\n",
            stderr);
    }
}

}  // namespace

void addRehearseCommand(CLI::App& kerf) {
    auto options = std::make_shared<RehearseOptions>();
    auto* command = kerf.add_subcommand(
        "rehearse",
        "Run the engine against the machine with faults and commands at given times, as fast as it can. CSV, one row "
        "per cycle (default), or a summary as JSON. What a scenario may say stands in docs/reliability.md; examples "
        "are in resources/rehearsals.");
    command
        ->add_option("scenario", options->scenario, "Scenario as JSON: process, duration_s, mode, seed, setup, events")
        ->required();
    command->add_option("--machine", options->machine, "Machine to run on; without it the built-in one of the process")
        ->check(CLI::IsMember({"simulator", "diamond-lathe", "linuxcnc"}));
    command->add_option("--machine-file", options->machineFile,
                        "Machine file (JSON, docs/linuxcnc.md): its limits of the outputs, and who hosts what");
    auto* csv = command->add_flag("--csv", options->csv, "Rows as CSV (default)");
    command
        ->add_flag("--summary", options->summary,
                   "Instead: first time of each state, alarm and stop; largest feed while stopped and above the "
                   "planned one while anything was unknown; largest step of each output")
        ->excludes(csv);
    command->add_option("--every-ms", options->every_ms, "Milliseconds from row to row; without it every cycle")
        ->check(CLI::Range(0.1, 3'600'000.0));
    command->callback([options] { rehearse(*options); });
}

}  // namespace kerf::headless
