// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/files/output.h"
#include "app/files/table.h"
#include "app/headless/thermal_commands.h"
#include "engine/process/thermal/plant/simulated_day.h"

namespace kerf::headless {
namespace {

using namespace thermal;

struct SimulateArguments {
    std::string schedule{"0:0,10:3000"};
    double hours{6.0};
    std::uint64_t seed{1};
    std::uint64_t machine{0};
    std::string season{kSeasonKeys.front()};
    double warmSpeed_rpm{0.0};
    double warm_min{120.0};
    double pause_min{15.0};
};

struct SpeedStep {
    double from_min{0.0};
    double speed_rpm{0.0};
};

/// "0:0,10:3000": from minute 0 at 0 rpm, from minute 10 at 3000 rpm.
std::vector<SpeedStep> scheduleFrom(const std::string& text) {
    std::vector<SpeedStep> steps;
    const char* at = text.data();
    const char* end = at + text.size();
    const auto number = [&](double& value) {
        const auto [stop, error] = std::from_chars(at, end, value);
        const bool good = error == std::errc{} && std::isfinite(value);
        at = good ? stop : at;
        return good;
    };
    while (true) {
        SpeedStep step;
        const bool good = number(step.from_min) && at != end && *at == ':' && (++at, number(step.speed_rpm));
        if (!good || step.speed_rpm < 0.0 || step.speed_rpm > 30'000.0 ||
            (steps.empty() ? step.from_min != 0.0 : step.from_min <= steps.back().from_min) ||
            (at != end && *at != ',')) {
            throw BadInput(
                fmt::format("--schedule: wrong at character {} of '{}'; expected MIN:RPM,… beginning at 0, minutes "
                            "rising, 0 to 30000 rpm, as 0:0,10:3000.",
                            at - text.data() + 1, text));
        }
        steps.push_back(step);
        if (at == end) {
            return steps;
        }
        ++at;
    }
}

double speedAt(const std::vector<SpeedStep>& steps, double t_min) {
    double speed_rpm = 0.0;
    for (const SpeedStep& step : steps) {
        if (t_min >= step.from_min) {
            speed_rpm = step.speed_rpm;
        }
    }
    return speed_rpm;
}

void simulate(const SimulateArguments& arguments) {
    const std::vector<SpeedStep> steps = scheduleFrom(arguments.schedule);
    constexpr std::uint64_t kReference = 1;
    SimulatedDayOptions options{arguments.machine > 0 ? arguments.machine : kReference, arguments.seed,
                                static_cast<int>(std::lround(arguments.hours * 60.0))};
    options.warmSpeed_rpm = arguments.warmSpeed_rpm;
    options.warm_min = arguments.warm_min;
    options.pause_min = arguments.pause_min;
    options.hardSeed = arguments.machine;
    options.season = *seasonOf(arguments.season);
    const auto [history, room_degC] = simulateDay(options, [&](int t_min) { return speedAt(steps, t_min); });
    std::string header = "t_min,rpm,amb_true";
    for (const std::string& name : history.sensors) {
        header += ',' + name;
    }
    CsvOutput out(header + ",yx_meas,yy_meas,yz_meas,yx_true,yy_true,yz_true");
    for (Eigen::Index row = 0; row < history.rows(); ++row) {
        const auto index = static_cast<std::size_t>(row);
        std::string line =
            fmt::format("{},{},{:.3f}", history.time_min[index], history.speed_rpm[index], room_degC[index]);
        for (const double temp_degC : history.temp_degC.row(row)) {
            line += fmt::format(",{:.3f}", temp_degC);
        }
        for (const Eigen::MatrixXd* three : {&history.drift_um, &history.trueDrift_um}) {
            for (const double value_um : three->row(row)) {
                line += row >= history.baselineRows() ? fmt::format(",{:.17g}", value_um) : std::string(",nan");
            }
        }
        out.row(line);
    }
    out.flush();
}

}  // namespace

void addThermalSimulate(CLI::App& thermal) {
    auto* command = thermal.add_subcommand("simulate", "A day of the simulated machine as history CSV.");
    auto arguments = std::make_shared<SimulateArguments>();
    command->add_option("--schedule", arguments->schedule, "Spindle speed: MIN:RPM,MIN:RPM,…")->capture_default_str();
    command->add_option("--hours", arguments->hours, "Length of the day, h")
        ->check(CLI::Range(0.1, 240.0))
        ->capture_default_str();
    command->add_option("--seed", arguments->seed, "Day: room temperature and noise")->capture_default_str();
    command
        ->add_option("--machine-seed", arguments->machine,
                     "0: the reference machine; else one that bites, drawn from this seed (docs/thermal.md)")
        ->capture_default_str();
    command->add_option("--season", arguments->season, "What is otherwise on this day")
        ->check(CLI::IsMember(std::vector<std::string>(kSeasonKeys.begin(), kSeasonKeys.end())))
        ->capture_default_str();
    command->add_option("--warm-rpm", arguments->warmSpeed_rpm, "Run at this speed before the baseline (0: cold start)")
        ->check(CLI::Range(0.0, 30'000.0))
        ->capture_default_str();
    command->add_option("--warm-min", arguments->warm_min, "How long, min")
        ->check(CLI::Range(0.0, 1440.0))
        ->capture_default_str();
    command->add_option("--pause-min", arguments->pause_min, "Stop between warm run and baseline, min")
        ->check(CLI::Range(0.0, 1440.0))
        ->capture_default_str();
    command->callback([arguments] { simulate(*arguments); });
}

}  // namespace kerf::headless
