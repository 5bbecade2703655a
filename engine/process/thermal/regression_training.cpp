// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/process/thermal/training.h"
#include "engine/process/thermal/training_common.h"

namespace kerf::thermal {
namespace {

using Index = Eigen::Index;

constexpr std::array<double, 6> kRidges{1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 3e-2};
constexpr std::size_t kBlocksOfOneDay = 4;
/// µm²: an improvement below this mean square error cannot be told from luck.
constexpr double kScoreFloor_um2 = 0.02;
/// Below the 1.96 of a normal error: the days left out leave fewer to train on, so the rms is pessimistic.
constexpr double kIntervalFactor = 1.7;
/// Judged on its own blocks, or without a second choice of sensors, a model looks better than it is.
constexpr double kNotNested = 1.5;

/// One day (or block of one): terms of all sensors, drift, and their products.
struct Fold {
    Eigen::MatrixXd x{};  ///< rows × (3·sensors + 3)
    Eigen::MatrixXd y{};
    Eigen::MatrixXd gram{};
    Eigen::MatrixXd moment{};
    Eigen::RowVectorXd yy{};
    bool atRest{true};
    std::vector<Index> seriesBegin{0};  ///< rows at which an uninterrupted series begins

    void add(const Eigen::MatrixXd& terms, const Eigen::MatrixXd& drift) {
        const Index rows = x.rows();
        if (rows > 0) {
            seriesBegin.push_back(rows);
        }
        x.conservativeResize(rows + terms.rows(), terms.cols());
        y.conservativeResize(rows + terms.rows(), drift.cols());
        x.bottomRows(terms.rows()) = terms;
        y.bottomRows(terms.rows()) = drift;
    }
    /// The products, of all that was added.
    void close() {
        gram = x.transpose() * x;
        moment = x.transpose() * y;
        yy = y.colwise().squaredNorm();
    }
};

/// The day as if the origin had been measured again at work row `start`: what a warm start looks like.
ThermalHistory restartedAt(const ThermalHistory& day, Index start) {
    const Index before = std::min<Index>(day.baselineRows(), start);
    const Index first = day.baselineRows() + start - before;
    const Index rows = day.rows() - first;
    ThermalHistory out;
    out.sensors = day.sensors;
    const double zero_min = day.time_min[static_cast<std::size_t>(first + before)];
    for (Index row = first; row < day.rows(); ++row) {
        out.time_min.push_back(day.time_min[static_cast<std::size_t>(row)] - zero_min);
    }
    out.temp_degC = day.temp_degC.bottomRows(rows);
    const Eigen::RowVectorXd reference = day.drift_um.middleRows(first, before).colwise().mean();
    out.drift_um = day.drift_um.bottomRows(rows).rowwise() - reference;
    return out;
}

/// Cold: every day (or block of one) as recorded. Any start: the same days, begun again at every quarter as well.
struct AllFolds {
    std::vector<Fold> asRecorded{};
    std::vector<Fold> anyStart{};
};
AllFolds foldsOf(const std::vector<ThermalHistory>& days, const FeatureSpec& spec) {
    AllFolds folds;
    const std::vector<bool> atRest = detail::restPatternOf(days).atRest;
    for (std::size_t d = 0; d < days.size(); ++d) {
        const Eigen::MatrixXd x = featureMatrix(days[d], spec);
        const Eigen::MatrixXd y = detail::measuredDrift(days[d]);
        const std::size_t parts = days.size() == 1 ? kBlocksOfOneDay : 1;
        for (std::size_t part = 0; part < parts; ++part) {
            const Index begin = x.rows() * static_cast<Index>(part) / static_cast<Index>(parts);
            const Index end = x.rows() * static_cast<Index>(part + 1) / static_cast<Index>(parts);
            Fold fold;
            fold.atRest = atRest[d];
            fold.add(x.middleRows(begin, end - begin), y.middleRows(begin, end - begin));
            fold.close();
            folds.asRecorded.push_back(fold);
            for (Index quarter = 1; parts == 1 && quarter < 4; ++quarter) {
                const ThermalHistory again = restartedAt(days[d], x.rows() * quarter / 4);
                fold.add(featureMatrix(again, spec), detail::measuredDrift(again));
            }
            if (fold.seriesBegin.size() > 1) {
                fold.close();
            }
            folds.anyStart.push_back(std::move(fold));
        }
    }
    return folds;
}

using FoldSet = std::vector<const Fold*>;

/// One of the two regressions: which folds and which terms it uses.
class Variant {
 public:
    Variant(FoldSet folds, Index sensors, bool withSpeed)
        : m_folds(std::move(folds)), m_sensors(sensors), m_speed(withSpeed) {
        m_gram = Eigen::MatrixXd::Zero(m_folds.front()->gram.rows(), m_folds.front()->gram.cols());
        m_moment = Eigen::MatrixXd::Zero(m_gram.rows(), static_cast<Index>(kAxes));
        for (const Fold* fold : m_folds) {
            m_gram += fold->gram;
            m_moment += fold->moment;
            m_rows += static_cast<double>(fold->x.rows());
        }
    }

    [[nodiscard]] std::vector<Index> terms(const std::vector<Index>& sensors) const {
        std::vector<Index> out;
        for (const Index s : sensors) {
            for (Index k = 0; k < kTermsPerSensor; ++k) {
                out.push_back(s * kTermsPerSensor + k);
            }
        }
        for (Index k = 0; m_speed && k < kSpeedTerms; ++k) {
            out.push_back(m_sensors * kTermsPerSensor + k);
        }
        return out;
    }

    /// Mean square error per axis on each fold by the others, at each ridge: [ridge][axis].
    [[nodiscard]] std::vector<PerAxis> leaveOneOut(const std::vector<Index>& sensors,
                                                   std::span<const double> ridges) const {
        const std::vector<Index> t = terms(sensors);
        const auto heatBegin = static_cast<Index>(sensors.size()) * kTermsPerSensor;
        const Eigen::MatrixXd all = m_gram(t, t);
        const Eigen::MatrixXd allMoment = m_moment(t, Eigen::all);
        std::vector<PerAxis> mse(ridges.size(), PerAxis{});
        for (const Fold* fold : m_folds) {
            const Eigen::MatrixXd own = fold->gram(t, t);
            const Eigen::MatrixXd ownMoment = fold->moment(t, Eigen::all);
            const Eigen::MatrixXd others = all - own;
            const Eigen::MatrixXd othersMoment = allMoment - ownMoment;
            for (std::size_t r = 0; r < ridges.size(); ++r) {
                Eigen::MatrixXd damped = others;
                for (Index k = 0; k < damped.rows(); ++k) {
                    damped(k, k) += (k < heatBegin ? ridges[r] : kSpeedRidge) * others(k, k) + 1e-12;
                }
                const Eigen::MatrixXd w = damped.llt().solve(othersMoment);
                for (Index axis = 0; axis < static_cast<Index>(kAxes); ++axis) {
                    const double error = fold->yy[axis] - 2.0 * w.col(axis).dot(ownMoment.col(axis)) +
                                         w.col(axis).dot(own * w.col(axis));
                    mse[r][static_cast<std::size_t>(axis)] += error / m_rows;
                }
            }
        }
        return mse;
    }

    [[nodiscard]] NormalEquations equations(const std::vector<Index>& sensors, const PerAxis& ridge) const {
        const std::vector<Index> t = terms(sensors);
        NormalEquations out;
        out.sensors = static_cast<int>(sensors.size());
        out.gram = m_gram(t, t);
        out.moment = m_moment(t, Eigen::all);
        out.rows = m_rows;
        out.ridge = ridge;
        return out;
    }
    [[nodiscard]] const FoldSet& folds() const noexcept { return m_folds; }

 private:
    FoldSet m_folds;
    Index m_sensors;
    bool m_speed;
    Eigen::MatrixXd m_gram{};
    Eigen::MatrixXd m_moment{};
    double m_rows{0.0};
};

/// Smallest error over the ridges, per axis, and where.
struct BestRidge {
    PerAxis excess_um2{};  ///< measurement noise taken off, ≥ 0
    PerAxis ridge{};
};
BestRidge bestRidge(const std::vector<PerAxis>& mse, std::span<const double> ridges, const PerAxis& noise_um2) {
    BestRidge best;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        double smallest = std::numeric_limits<double>::max();
        for (std::size_t r = 0; r < ridges.size(); ++r) {
            if (mse[r][axis] < smallest) {
                smallest = mse[r][axis];
                best.ridge[axis] = ridges[r];
            }
        }
        best.excess_um2[axis] = std::max(smallest - noise_um2[axis], 0.0);
    }
    return best;
}

/// The two variants over one set of folds; the one with speed is absent without a recorded speed or two starts at rest.
struct Variants {
    Variant temperatures;
    std::optional<Variant> withSpeed{};
};
/// All folds but the one left out (any number beyond the last: none).
Variants variantsOf(const AllFolds& folds, std::size_t leftOut, Index sensors, bool hasSpeed) {
    FoldSet any;
    FoldSet rested;
    for (std::size_t k = 0; k < folds.anyStart.size(); ++k) {
        if (k == leftOut) {
            continue;
        }
        any.push_back(&folds.anyStart[k]);
        if (folds.asRecorded[k].atRest) {
            rested.push_back(&folds.asRecorded[k]);
        }
    }
    Variants out{Variant(any, sensors, false)};
    if (hasSpeed && rested.size() >= 2) {
        out.withSpeed.emplace(rested, sensors, true);
    }
    return out;
}

/// Thrown inside the trainer only, to leave its loops when the caller cancels.
struct Cancelled {};

class Work {
 public:
    Work(const TrainingProgress& progress, double total) : m_progress(progress), m_total(total) {}
    void step() {
        m_done += 1.0;
        if (m_progress && !m_progress(std::min(m_done / m_total, 1.0))) {
            throw Cancelled{};
        }
    }

 private:
    const TrainingProgress& m_progress;
    double m_total;
    double m_done{0.0};
};

/// Sensors one by one (see trainRegression).
std::vector<Index> chooseSensors(const Variants& variants, Index available, const TrainingOptions& options,
                                 const PerAxis& noise_um2, Work& work) {
    constexpr std::array<double, 3> kCoarse{3e-4, 3e-3, 3e-2};
    const auto scoreOf = [&](const std::vector<Index>& sensors) {
        const auto of = [&](const Variant& variant) {
            const BestRidge best = bestRidge(variant.leaveOneOut(sensors, kCoarse), kCoarse, noise_um2);
            double sum = 0.0;
            for (const double excess_um2 : best.excess_um2) {
                sum += std::log(excess_um2 + kScoreFloor_um2);
            }
            return sum;
        };
        const double plain = of(variants.temperatures);
        return variants.withSpeed ? 0.5 * (plain + of(*variants.withSpeed)) : plain;
    };
    std::vector<Index> chosen;
    double score = std::numeric_limits<double>::max();
    const auto most = std::min<std::size_t>(static_cast<std::size_t>(std::clamp(options.maxSensors, 2, 14)),
                                            static_cast<std::size_t>(available));
    while (chosen.size() < most) {
        double best = std::numeric_limits<double>::max();
        Index bestSensor = -1;
        for (Index s = 0; s < available; ++s) {
            if (std::ranges::find(chosen, s) != chosen.end()) {
                continue;
            }
            chosen.push_back(s);
            const double candidate = scoreOf(chosen);
            chosen.pop_back();
            if (candidate < best) {
                best = candidate;
                bestSensor = s;
            }
        }
        work.step();
        if (chosen.size() >= 3 && best > score - options.smallestGain) {
            break;
        }
        chosen.push_back(bestSensor);
        score = best;
    }
    std::ranges::sort(chosen);
    return chosen;
}

BestRidge fineRidge(const Variant& variant, const std::vector<Index>& sensors, const PerAxis& noise_um2) {
    return bestRidge(variant.leaveOneOut(sensors, kRidges), kRidges, noise_um2);
}

/// Interval for every lost set: the honest rms, scaled by how much the loss costs in leave-one-out.
void fillIntervals(const Variant& variant, const std::vector<Index>& sensors, const PerAxis& noise_um2,
                   const PerAxis& rms_um, NormalEquations& equations) {
    const auto excessWithout = [&](const std::vector<std::size_t>& lost) {
        std::vector<Index> left;
        for (std::size_t k = 0; k < sensors.size(); ++k) {
            if (std::ranges::find(lost, k) == lost.end()) {
                left.push_back(sensors[k]);
            }
        }
        PerAxis excess_um2{};
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
            const std::array<double, 1> ridge{equations.ridge[axis]};
            const auto mse = variant.leaveOneOut(left, ridge);
            excess_um2[axis] = std::max(mse[0][axis] - noise_um2[axis], 0.0) + kScoreFloor_um2;
        }
        return excess_um2;
    };
    const std::size_t count = sensors.size();
    equations.half_um.assign(lostSetCount(count), PerAxis{});
    const PerAxis whole = excessWithout({});
    const auto store = [&](std::size_t set, const std::vector<std::size_t>& lost) {
        const PerAxis excess = lost.empty() ? whole : excessWithout(lost);
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
            equations.half_um[set][axis] =
                kIntervalFactor * rms_um[axis] * std::max(1.0, std::sqrt(excess[axis] / whole[axis]));
        }
    };
    store(lostSetIndex(count), {});
    for (std::size_t i = 0; i < count; ++i) {
        store(lostSetIndex(count, i), {i});
        for (std::size_t j = i + 1; j < count; ++j) {
            store(lostSetIndex(count, i, j), {i, j});
        }
    }
}

/// Errors of a variant on folds that took no part, one entry per uninterrupted series.
using Errors = std::vector<Eigen::MatrixXd>;
void collect(const Fold& fold, const Variant& variant, const std::vector<Index>& sensors, const PerAxis& ridge,
             Errors& errors, std::size_t day, std::vector<detail::LeftOutDay>& leftOut) {
    const Eigen::MatrixXd w = solveWithout(variant.equations(sensors, ridge), {});
    const Eigen::MatrixXd predicted = fold.x(Eigen::all, variant.terms(sensors)) * w;
    const Eigen::MatrixXd all = fold.y - predicted;
    const Index first = fold.seriesBegin.size() > 1 ? fold.seriesBegin[1] : all.rows();
    leftOut.push_back({day, predicted.topRows(first), all.topRows(first)});
    for (std::size_t k = 0; k < fold.seriesBegin.size(); ++k) {
        const Index end = k + 1 < fold.seriesBegin.size() ? fold.seriesBegin[k + 1] : all.rows();
        errors.push_back(all.middleRows(fold.seriesBegin[k], end - fold.seriesBegin[k]));
    }
}

struct Honest {
    Errors temperatures{};
    Errors withSpeed{};
    std::vector<detail::LeftOutDay> daysByTemperatures{};
    std::vector<detail::LeftOutDay> daysBySpeed{};
};

/// Leave each fold out of everything, choose and train on the rest, and collect the errors on it.
Honest nestedErrors(const AllFolds& folds, Index available, bool hasSpeed, const TrainingOptions& options,
                    const PerAxis& noise_um2, Work& work) {
    Honest out;
    for (std::size_t left = 0; left < folds.anyStart.size(); ++left) {
        const Variants variants = variantsOf(folds, left, available, hasSpeed);
        const std::vector<Index> sensors = chooseSensors(variants, available, options, noise_um2, work);
        collect(folds.anyStart[left], variants.temperatures, sensors,
                fineRidge(variants.temperatures, sensors, noise_um2).ridge, out.temperatures, left,
                out.daysByTemperatures);
        if (variants.withSpeed && folds.asRecorded[left].atRest) {
            collect(folds.asRecorded[left], *variants.withSpeed, sensors,
                    fineRidge(*variants.withSpeed, sensors, noise_um2).ridge, out.withSpeed, left, out.daysBySpeed);
        }
    }
    return out;
}

/// With two folds nothing is left to choose by: errors of the chosen sensors, trained on the other fold.
Honest plainErrors(const Variants& variants, const std::vector<Index>& sensors, const PerAxis& noise_um2) {
    Honest out;
    const auto judge = [&](const Variant& variant, Errors& errors, bool speed,
                           std::vector<detail::LeftOutDay>& leftOut) {
        std::size_t day = 0;
        const PerAxis ridge = fineRidge(variant, sensors, noise_um2).ridge;
        for (const Fold* left : variant.folds()) {
            FoldSet rest = variant.folds();
            std::erase(rest, left);
            const Index available = (left->x.cols() - kSpeedTerms) / kTermsPerSensor;
            collect(*left, Variant(rest, available, speed), sensors, ridge, errors, day++, leftOut);
        }
    };
    judge(variants.temperatures, out.temperatures, false, out.daysByTemperatures);
    if (variants.withSpeed) {
        judge(*variants.withSpeed, out.withSpeed, true, out.daysBySpeed);
    }
    return out;
}

}  // namespace

Result<detail::JudgedRegression> detail::trainJudgedRegression(const std::vector<ThermalHistory>& days,
                                                               const TrainingOptions& options,
                                                               const TrainingProgress& progress) {
    if (const auto why = detail::whyNotTogether(days)) {
        return tl::unexpected(*why);
    }
    const AllFolds folds = foldsOf(days, options.features);
    const auto available = static_cast<Index>(days.front().sensors.size());
    const bool hasSpeed = std::ranges::none_of(days, [](const ThermalHistory& d) { return d.speed_rpm.empty(); });
    const PerAxis noise_um2 = measurementVariance_um2(days);
    const std::size_t foldCount = folds.anyStart.size();
    const bool nested = foldCount >= 3;
    Work work(progress,
              static_cast<double>(options.maxSensors) * (nested ? 1.0 + static_cast<double>(foldCount) : 1.0));
    try {
        const Variants variants = variantsOf(folds, foldCount, available, hasSpeed);
        const std::vector<Index> sensors = chooseSensors(variants, available, options, noise_um2, work);
        const Honest honest = nested ? nestedErrors(folds, available, hasSpeed, options, noise_um2, work)
                                     : plainErrors(variants, sensors, noise_um2);
        const double inflation = nested && days.size() > 1 ? 1.0 : kNotNested;
        const auto rmsOf = [inflation](const std::vector<Eigen::MatrixXd>& errors) {
            PerAxis rms_um = detail::noiseFreeRms(errors);
            for (double& value : rms_um) {
                value *= inflation;
            }
            return rms_um;
        };
        ThermalModel model = detail::modelFrame(ModelKind::Regression, days, sensors, options.features);
        RegressionPart part;
        const auto finish = [&](const Variant& variant, const Errors& errors) {
            NormalEquations equations = variant.equations(sensors, fineRidge(variant, sensors, noise_um2).ridge);
            fillIntervals(variant, sensors, noise_um2, rmsOf(errors), equations);
            return equations;
        };
        part.temperatures = finish(variants.temperatures, honest.temperatures);
        const Errors* judged = &honest.temperatures;
        if (variants.withSpeed && !honest.withSpeed.empty()) {
            part.withSpeed = finish(*variants.withSpeed, honest.withSpeed);
            judged = &honest.withSpeed;
        }
        model.judgement = {days.size() > 1, rmsOf(*judged), detail::worstOf(*judged)};
        model.regression = std::move(part);
        std::vector<detail::LeftOutDay> leftOut;
        if (days.size() > 1) {
            leftOut = model.regression->withSpeed ? honest.daysBySpeed : honest.daysByTemperatures;
        }
        return detail::JudgedRegression{std::move(model), sensors, std::move(leftOut)};
    } catch (const Cancelled&) {
        return fail(KERF_TEXT("Training was cancelled."));
    }
}

Result<ThermalModel> trainRegression(const std::vector<ThermalHistory>& days, const TrainingOptions& options,
                                     const TrainingProgress& progress) {
    auto judged = detail::trainJudgedRegression(days, options, progress);
    if (!judged) {
        return tl::unexpected(judged.error());
    }
    return std::move(judged->model);
}

}  // namespace kerf::thermal
