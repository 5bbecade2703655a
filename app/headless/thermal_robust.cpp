// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>

#include "app/files/output.h"
#include "app/files/whole_file.h"
#include "app/headless/robust_table.h"
#include "app/headless/thermal_commands.h"
#include "engine/core/random.h"
#include "engine/process/thermal/plant/simulated_day.h"
#include "engine/process/thermal/replay.h"
#include "engine/process/thermal/training.h"

namespace kerf::headless {
namespace {

using namespace thermal;

constexpr std::uint64_t kTrainedDays = 6;
constexpr int kMinutes = 200;
constexpr double kMeasureEvery_min = 60.0;
constexpr double kRunaway = 3.0;      // times uncompensated
constexpr double kSmallest_um = 0.5;  // an error below this cannot be told from the gap sensors' noise

/// Front bearing, motor, head left and right, column upper, bed: what a workshop would fit.
constexpr std::array<Eigen::Index, 6> kFitted{0, 14, 19, 26, 33, 50};
constexpr Eigen::Index kAxis = 1;  // the displacement that is measured

/// A day of random speeds with six thermocouples and one displacement.
ThermalHistory dayOf(std::uint64_t machineSeed, std::uint64_t day, Season season) {
    SimulatedDayOptions options{machineSeed, 7000 + day, kMinutes};
    options.hardSeed = machineSeed;
    options.season = season;
    Random random = Random(machineSeed).stream(day);
    std::array<double, 20> speed_rpm{};
    for (double& value : speed_rpm) {
        value = random.uniform() < 0.2 ? 0.0 : random.uniform(500.0, 5000.0);
    }
    const ThermalHistory all = simulateDay(options, [&](int t_min) {
                                   return speed_rpm[static_cast<std::size_t>(std::max(t_min, 0) / 15)];
                               }).history;
    ThermalHistory out = all;
    out.axes = {false, true, false};
    out.speed_rpm.clear();
    out.sensors.clear();
    for (const Eigen::Index sensor : kFitted) {
        out.sensors.push_back(all.sensors[static_cast<std::size_t>(sensor)]);
    }
    out.temp_degC = all.temp_degC(Eigen::all, kFitted);
    out.present = PresentMask::Constant(out.temp_degC.rows(), out.temp_degC.cols(), true);
    out.drift_um.setZero();
    out.drift_um.col(kAxis) = all.drift_um.col(kAxis);
    return out;
}

struct Judged {
    double rms_um{0.0};
    double inside{0.0};
};
Judged judge(const ThermalModel& model, const ThermalHistory& day, double measureEvery_min) {
    const Replay replayed = replay(model, day, measureEvery_min);
    Judged out;
    const auto n = static_cast<double>(replayed.minutes.size());
    for (std::size_t k = 0; k < replayed.minutes.size(); ++k) {
        const ThermalPrediction& p = replayed.minutes[k].prediction;
        const double error_um =
            day.trueDrift_um(day.baselineRows() + static_cast<Eigen::Index>(k), kAxis) - p.drift_um[kAxis];
        out.rms_um += error_um * error_um / n;
        out.inside += std::abs(error_um) <= p.half_um[kAxis] ? 1.0 / n : 0.0;
    }
    out.rms_um = std::sqrt(out.rms_um);
    return out;
}
double uncompensated_um(const ThermalHistory& day) {
    return std::sqrt(day.trueDrift_um.col(kAxis).bottomRows(day.workRows()).squaredNorm() /
                     static_cast<double>(day.workRows()));
}

template <class Trained>
ThermalModel need(Trained model) {
    if (!model) throw files::BadInput(model.error().english());
    return std::move(*model);
}

void thermalRobust(const RobustOptions& options) {
    CsvOutput csv(
        "machine_seed,season,rms_uncompensated_um,rms_simple_um,rms_default_um,rms_measured_um,inside,ratio,worse,"
        "unstable_default,unstable_simple");
    RobustTally tally;
    double worseThanNothing = 0.0;
    double measuredWorse = 0.0;
    double inside = 0.0;
    double rows = 0.0;
    for (std::uint32_t i = 1; i <= options.machines; ++i) {
        const std::uint64_t seed = options.machineSeed(i);
        std::vector<ThermalHistory> days;
        for (std::uint64_t day = 0; day < kTrainedDays; ++day) {
            days.push_back(dayOf(seed, day, Season::None));
        }
        const ThermalModel ours = need(trainHierarchical(days, {}));
        const ThermalModel simple = need(trainRegression(days, {}));
        const auto held = static_cast<Season>(1 + seed % (kSeasonKeys.size() - 1));
        for (const Season season : {Season::None, held}) {
            const ThermalHistory day = dayOf(seed, kTrainedDays + static_cast<std::uint64_t>(season), season);
            const double nothing_um = uncompensated_um(day);
            const double simple_um = judge(simple, day, 0.0).rms_um;
            const Judged law = judge(ours, day, 0.0);
            const double measured_um = judge(ours, day, kMeasureEvery_min).rms_um;
            const double ratio = (law.rms_um + kSmallest_um) / (simple_um + kSmallest_um);
            const auto runsAway = [&](double value_um) { return !(value_um < kRunaway * (nothing_um + kSmallest_um)); };
            csv.row(seed, kSeasonKeys[static_cast<std::size_t>(season)], nothing_um, simple_um, law.rms_um, measured_um,
                    law.inside, ratio, ratio > 1.0, runsAway(law.rms_um), runsAway(simple_um));
            tally.add({ratio, ratio > 1.0, runsAway(law.rms_um), runsAway(simple_um)});
            rows += 1.0;
            inside += law.inside;
            worseThanNothing += law.rms_um > 1.05 * nothing_um + kSmallest_um ? 1.0 : 0.0;
            measuredWorse += measured_um > 1.05 * nothing_um + kSmallest_um ? 1.0 : 0.0;
        }
    }
    if (options.csv) {
        csv.flush();
        return;
    }
    nlohmann::ordered_json json{{"machines", options.machines}, {"seed", options.seed}};
    for (const auto& [name, value] : tally.figures())
        json[name] = value;
    json["share_worse_than_uncompensated"] = worseThanNothing / rows;
    json["share_measured_worse_than_uncompensated"] = measuredWorse / rows;
    json["share_inside"] = inside / rows;
    printJson(json);
}

}  // namespace

void addThermalRobust(CLI::App& thermal) {
    auto options = std::make_shared<RobustOptions>();
    CLI::App* command = thermal.add_subcommand(
        "robust",
        "Simulated machines that bite, each drawn from a seed of its own (docs/thermal.md): six thermocouples and the "
        "displacement of Y, trained on six ordinary days, judged on another ordinary day and on a day of a season held "
        "out; the default against the regression.\n"
        "--csv: machine_seed (for simulate --machine-seed), season, RMS against the true drift in um of no "
        "compensation,\n"
        "  regression, default and default with one measurement an hour, share of minutes inside the 95 % interval,\n"
        "  ratio (default over regression, .5 um added to both), worse, unstable (above three times uncompensated).\n"
        "  Without it, JSON: share_worse, worst_ratio, share_unstable and more.");
    options->addTo(*command);
    command->callback([options] { thermalRobust(*options); });
}

}  // namespace kerf::headless
