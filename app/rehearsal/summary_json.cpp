// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "app/rehearsal/rehearsal.h"
#include "engine/port/state_keys.h"

namespace kerf::rehearsal {
namespace {

using OrderedJson = nlohmann::ordered_json;

const char* kindKey(StopKind kind) {
    switch (kind) {
        case StopKind::NoStart:
            return "no_start";
        case StopKind::LoopOut:
            return "loop_out";
        case StopKind::FeedHold:
            return "feed_hold";
        case StopKind::InWork:
            return "in_work";
        case StopKind::None:
            break;
    }
    return "none";
}

}  // namespace

OrderedJson summaryJson(const Scenario& scenario, const Summary& summary) {
    OrderedJson json;
    json["process"] = processKey(scenario.process);
    json["machine"] = machineKey(scenario.machine);
    json["duration_s"] = scenario.duration_s;
    json["cycles"] = summary.cycles;
    json["states_first_s"] = OrderedJson::object();
    for (const ProcessId id : allProcesses()) {
        OrderedJson& states = json["states_first_s"][processKey(id)] = OrderedJson::object();
        for (const auto& [state, t_s] : summary.states[static_cast<std::size_t>(id)]) {
            states[stateKey(state)] = t_s;
        }
    }
    json["alarms"] = OrderedJson::array();
    for (const auto& [code, t_s] : summary.alarms) {
        const auto title = summary.titles.find(code);
        json["alarms"].push_back(
            {{"code", code}, {"first_s", t_s}, {"title", title == summary.titles.end() ? "" : title->second}});
    }
    json["stops"] = OrderedJson::array();
    for (const StopSeen& stop : summary.stops) {
        json["stops"].push_back(
            {{"process", processKey(stop.process)},
             {"number", stop.number},
             {"kind", kindKey(stop.kind)},
             {"cause", stop.cause},
             {"reason", stop.reason},
             {"first_s", stop.at_s},
             {"released_s", stop.released_s ? OrderedJson(*stop.released_s) : OrderedJson(nullptr)}});
    }
    json["commands"] = OrderedJson::array();
    for (const CommandSeen& command : summary.commands) {
        json["commands"].push_back(
            {{"at_s", command.at_s}, {"do", command.deed}, {"done", command.done}, {"reason", command.reason}});
    }
    json["parts_finished"] = summary.partsFinished;
    json["parts_aborted"] = summary.partsAborted;
    json["settle_s"] = Summary::kSettle_s;
    json["largest_feed_while_stopped_mm_s"] = summary.feedWhileStopped_mmPerS;
    json["way_while_stopped_mm"] = summary.wayWhileStopped_mm;
    json["largest_feed_over_planned_while_unknown_mm_s"] = summary.overPlannedWhileUnknown_mmPerS;
    json["largest_feed_over_planned_at_once_mm_s"] = summary.overPlannedAtOnce_mmPerS;
    json["largest_step_per_cycle"] = {
        {"feed_scale", summary.stepFeedScale},     {"offset_x_um", summary.stepOffset_um[0]},
        {"offset_y_um", summary.stepOffset_um[1]}, {"offset_z_um", summary.stepOffset_um[2]},
        {"tool_trim_um", summary.stepToolTrim_um}, {"z_trim_um", summary.stepZTrim_um}};
    return json;
}

}  // namespace kerf::rehearsal
