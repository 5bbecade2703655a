// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "engine/process/thermal/training.h"
#include "engine/process/thermal/training_common.h"

namespace kerf::thermal {
namespace {

using Index = Eigen::Index;

constexpr double kIntervalFactor = 2.0;
constexpr double kOwnCheck = 1.5;  // the check rows chose the network: its error there is not held out

Eigen::MatrixXd inputsOf(ModelKind kind, const ThermalHistory& day, const FeatureSpec& spec) {
    if (kind == ModelKind::GmdhPaper) {
        return printedInputs(day);
    }
    const Eigen::MatrixXd terms = featureMatrix(day, spec);
    return terms.leftCols(terms.cols() - kSpeedTerms);
}

GmdhInput inputMeaning(ModelKind kind, int column, int sensors) {
    if (kind == ModelKind::GmdhPaper) {
        return column < sensors ? GmdhInput{column, InputKind::Now, 0}
                                : GmdhInput{column - sensors, InputKind::Before, 0};
    }
    return {column / kTermsPerSensor, InputKind::Term, column % kTermsPerSensor};
}

struct Stacked {
    Eigen::MatrixXd x{};
    Eigen::MatrixXd y{};
    GmdhRows rows{};
};

/// All days under each other; check rows of every day, and the rest cut into two contiguous halves.
Stacked stack(ModelKind kind, const std::vector<const ThermalHistory*>& days, const TrainingOptions& options) {
    Stacked out;
    std::vector<Index> training;
    Index begin = 0;
    for (const ThermalHistory* day : days) {
        const Eigen::MatrixXd x = inputsOf(kind, *day, options.features);
        out.x.conservativeResize(begin + x.rows(), x.cols());
        out.y.conservativeResize(begin + x.rows(), static_cast<Index>(kAxes));
        out.x.bottomRows(x.rows()) = x;
        out.y.bottomRows(x.rows()) = detail::measuredDrift(*day);
        for (Index row = 0; row < x.rows(); ++row) {
            const double t_min = day->time_min[static_cast<std::size_t>(row + day->baselineRows())];
            const bool check = options.check_min
                                   ? t_min >= options.check_min->first && t_min <= options.check_min->second
                                   : row >= x.rows() * 2 / 3;
            (check ? out.rows.check : training).push_back(begin + row);
        }
        begin += x.rows();
    }
    const auto half = static_cast<std::ptrdiff_t>(training.size() / 2);
    out.rows.a.assign(training.begin(), training.begin() + half);
    out.rows.b.assign(training.begin() + half, training.end());
    return out;
}

Result<std::vector<GmdhModel>> networksOf(ModelKind kind, const Stacked& data, const TrainingOptions& options) {
    GmdhOptions gmdh = kind == ModelKind::GmdhPaper ? GmdhOptions::asPrinted() : GmdhOptions::guarded();
    gmdh.criterion = options.criterion;
    return trainGmdh(data.x, data.y, data.rows, gmdh);
}

Eigen::MatrixXd errorsOf(const std::vector<GmdhModel>& networks, const Eigen::MatrixXd& x, const Eigen::MatrixXd& y) {
    Eigen::MatrixXd errors = y;
    std::vector<double> row(static_cast<std::size_t>(x.cols()));
    for (Index r = 0; r < x.rows(); ++r) {
        Eigen::Map<Eigen::RowVectorXd>(row.data(), x.cols()) = x.row(r);
        for (std::size_t axis = 0; axis < networks.size(); ++axis) {
            errors(r, static_cast<Index>(axis)) -= networks[axis].predict(row);
        }
    }
    return errors;
}

}  // namespace

Result<ThermalModel> trainNetwork(ModelKind kind, const std::vector<ThermalHistory>& days,
                                  const TrainingOptions& options, const TrainingProgress& progress) {
    if (const auto why = detail::whyNotTogether(days)) {
        return tl::unexpected(*why);
    }
    auto goOn = [&progress, steps = static_cast<double>(days.size() + 1), done = 0.0]() mutable {
        done += 1.0;
        return !progress || progress(done / steps);
    };
    std::vector<const ThermalHistory*> all;
    for (const ThermalHistory& day : days) {
        all.push_back(&day);
    }
    const Stacked data = stack(kind, all, options);
    auto networks = networksOf(kind, data, options);
    if (!networks) {
        return tl::unexpected(networks.error());
    }
    if (!goOn()) {
        return fail(KERF_TEXT("Training was cancelled."));
    }

    std::vector<Eigen::MatrixXd> judged;
    double inflation = 1.0;
    if (days.size() > 1) {
        for (const ThermalHistory* left : all) {
            std::vector<const ThermalHistory*> rest = all;
            std::erase(rest, left);
            const auto others = networksOf(kind, stack(kind, rest, options), options);
            if (!others) {
                return tl::unexpected(others.error());
            }
            judged.push_back(errorsOf(*others, inputsOf(kind, *left, options.features), detail::measuredDrift(*left)));
            if (!goOn()) {
                return fail(KERF_TEXT("Training was cancelled."));
            }
        }
    } else {
        const Eigen::MatrixXd x = data.x(data.rows.check, Eigen::all);
        const Eigen::MatrixXd y = data.y(data.rows.check, Eigen::all);
        judged.push_back(errorsOf(*networks, x, y));
        inflation = kOwnCheck;
    }

    // The model carries only the sensors its networks read.
    const int sensorCount = static_cast<int>(days.front().sensors.size());
    std::set<Index> used;
    for (const GmdhModel& network : *networks) {
        for (const int column : network.usedInputs()) {
            used.insert(inputMeaning(kind, column, sensorCount).sensor);
        }
    }
    const std::vector<Index> sensors(used.begin(), used.end());
    if (sensors.size() > kMaxModelSensors) {
        return fail(KERF_TEXT("The network reads %1 sensors; at most %2 are supported."),
                    SentenceArg(static_cast<double>(sensors.size()), 0),
                    SentenceArg(static_cast<double>(kMaxModelSensors), 0));
    }
    ThermalModel model = detail::modelFrame(kind, days, sensors, options.features);
    GmdhPart part;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const GmdhModel& network = (*networks)[axis];
        for (const int column : network.usedInputs()) {
            GmdhInput input = inputMeaning(kind, column, sensorCount);
            input.sensor = static_cast<int>(std::ranges::lower_bound(sensors, input.sensor) - sensors.begin());
            part.inputs[axis].push_back(input);
        }
        part.network[axis] = network.pruned();
    }
    PerAxis rms_um = detail::noiseFreeRms(judged);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        rms_um[axis] *= inflation;
        part.half_um[axis] = kIntervalFactor * rms_um[axis];
    }
    model.judgement = {days.size() > 1, rms_um, detail::worstOf(judged)};
    model.gmdh = std::move(part);
    return model;
}

Result<AutoTraining> trainAuto(const std::vector<ThermalHistory>& days, const TrainingOptions& options,
                               const TrainingProgress& progress) {
    constexpr std::array<ModelKind, 4> kKinds{ModelKind::GmdhPaper, ModelKind::Gmdh, ModelKind::Regression,
                                              ModelKind::Hierarchical};
    constexpr std::array<double, 4> kShareBefore{0.0, 0.1, 0.2, 0.8};
    AutoTraining out;
    std::optional<detail::JudgedRegression> regression;
    const auto trained = [&](ModelKind kind, const TrainingProgress& part) -> Result<ThermalModel> {
        if (kind == ModelKind::Hierarchical) {
            return detail::hierarchicalOn(*regression, days, options, part);
        }
        if (kind != ModelKind::Regression) {
            return trainNetwork(kind, days, options, part);
        }
        auto judged = detail::trainJudgedRegression(days, options, part);
        if (!judged) {
            return tl::unexpected(judged.error());
        }
        regression = std::move(*judged);
        return regression->model;
    };
    for (std::size_t k = 0; k < kKinds.size(); ++k) {
        const double from = kShareBefore[k];
        const double to = k + 1 < kKinds.size() ? kShareBefore[k + 1] : 1.0;
        const TrainingProgress part = [&](double share) { return !progress || progress(from + share * (to - from)); };
        if (days.size() == 1 && kKinds[k] == ModelKind::Hierarchical) {
            break;
        }
        auto model = trained(kKinds[k], part);
        if (!model) {
            return tl::unexpected(model.error());
        }
        out.compared.push_back({kKinds[k], model->judgement, model->sensors.size()});
        if (kKinds[k] == (days.size() == 1 ? ModelKind::Gmdh : ModelKind::Hierarchical)) {
            out.best = std::move(*model);
        }
    }
    return out;
}

}  // namespace kerf::thermal
