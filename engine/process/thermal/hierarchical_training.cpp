// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/process/thermal/mean_law.h"
#include "engine/process/thermal/training.h"
#include "engine/process/thermal/training_common.h"

namespace kerf::thermal {
namespace {

using Index = Eigen::Index;
using detail::BlockDay;
using detail::blockMeans;
using detail::blocksOf;
using detail::blockStep;
using detail::bounded;
using detail::Form;
using detail::LawDay;
using detail::MeanLaw;
using detail::meanOf;

constexpr std::size_t kAllSensors = 8;     // up to that many no sensor is chosen: the ridge does it
constexpr double kLuck = 0.8;              // by that over days² the log error of a new law must be smaller, per axis
constexpr std::size_t kDaysToChoose = 3;   // with fewer the mean law is the regression
constexpr std::size_t kDaysToAverage = 5;  // from here on an average with the regression is tried even if it is better
constexpr std::size_t kFinalists = 6;
constexpr double kNear = 0.05;  // laws whose log error is so near the best's are averaged with it, per axis
constexpr double kNearRegression = 0.3;
constexpr double kRegressionShare = 0.5;

using DayRms = std::array<std::vector<double>, kAxes>;
/// Σ_axes log of the mean rms over the days left out; smaller is better.
double scoreOf(const DayRms& rms) {
    double sum = 0.0;
    for (const auto& axis : rms) {
        sum += std::log(meanOf(bounded(axis)));
    }
    return sum;
}

/// Days left out as the between-day law sees them, for every axis.
using LawDays = std::array<std::vector<LawDay>, kAxes>;
std::vector<double> scalesOf(const std::vector<BlockDay>& days, const std::vector<Index>& columns) {
    std::vector<double> out;
    for (const Index column : columns) {
        double squares = 0.0;
        for (const BlockDay& day : days) {
            squares += day.x.col(column).squaredNorm() / static_cast<double>(day.x.rows());
        }
        out.push_back(std::sqrt(squares / static_cast<double>(days.size()) * static_cast<double>(columns.size())) +
                      1e-9);
    }
    return out;
}
Eigen::MatrixXd scaledTerms(const BlockDay& day, const std::vector<Index>& columns, const std::vector<double>& scale) {
    Eigen::MatrixXd x = day.x(Eigen::all, columns);
    for (Index k = 0; k < x.cols(); ++k) {
        x.col(k) /= scale[static_cast<std::size_t>(k)];
    }
    return x;
}

/// W with z = W·x, E[z·zᵀ] over the training days = 1 per term on the mean; directions the days hardly had count by
/// what they had, up to a floor.
Eigen::MatrixXd whiteningOf(const std::vector<BlockDay>& days, const std::vector<Index>& columns,
                            const std::vector<double>& scale) {
    constexpr double kFloor = 0.01;
    const auto p = static_cast<Index>(columns.size());
    Eigen::MatrixXd moment = Eigen::MatrixXd::Zero(p, p);
    for (const BlockDay& day : days) {
        const Eigen::MatrixXd x = scaledTerms(day, columns, scale);
        moment += x.transpose() * x / static_cast<double>(x.rows()) / static_cast<double>(days.size());
    }
    const double floor = kFloor * std::max(moment.trace(), 1e-9) / static_cast<double>(p);
    const Eigen::MatrixXd damped = moment + floor * Eigen::MatrixXd::Identity(p, p);
    const Eigen::LLT<Eigen::MatrixXd> factor(damped);
    const double effective = factor.solve(moment).trace();
    return factor.matrixL().solve(Eigen::MatrixXd::Identity(p, p)) / std::sqrt(std::max(effective, 1e-9));
}

PerAxis noiseOf(const PerAxis& variance_um2) {
    PerAxis out{};
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        out[axis] = std::max(std::sqrt(variance_um2[axis]), 0.1);
    }
    return out;
}

/// Student's t, 97.5 %, over the normal's 1.96; Cornish-Fisher, good to 2 % from 3 degrees of freedom on.
double studentOver(double freedom) {
    constexpr double kZ = 1.96;
    const double z2 = kZ * kZ;
    return 1.0 + (z2 + 1.0) / (4.0 * freedom) + (5.0 * z2 * z2 + 16.0 * z2 + 3.0) / (96.0 * freedom * freedom);
}

/// The factor over the standard deviation that holds for 95 % of the minutes of days left out.
double wideningOf(const std::vector<LawDay>& days, const DayLaw& law) {
    constexpr double kFloor_um2 = 0.0025;
    std::vector<double> ratio;
    for (const LawDay& day : days) {
        DayLaw silent = law;
        silent.noise_um = 0.0;
        const Eigen::VectorXd variance = detail::covarianceOf(day, silent).diagonal();
        for (Index row = 0; row < variance.size(); ++row) {
            ratio.push_back(std::abs(day.error_um[row]) / std::sqrt(variance[row] + kFloor_um2));
        }
    }
    // Some reserve, because the mean law was chosen by these days; with few days they were predicted from still fewer,
    // which is reserve enough.
    const double share = 0.97 - 0.06 / static_cast<double>(days.size());
    const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(ratio.size()));
    std::ranges::nth_element(ratio, ratio.begin() + rank);
    return std::max(ratio[static_cast<std::size_t>(rank)], 1.0) * studentOver(4.0 * static_cast<double>(days.size()));
}

/// How much of the mean law the days left out bear out (see DayLaw).
void weighEvidence(const std::vector<LawDay>& days, DayLaw& law) {
    constexpr double kCaution = 0.15;    // of the mean law's square that the spread of days takes off
    constexpr double kUnforetold = 0.1;  // share of the drift's square from which strange states are doubted by half
    constexpr double kUsualShare = 0.5;  // of the strangest state trained on
    constexpr double kSmallest_um2 = 1e-6;
    double spread_um2 = kSmallest_um2;
    double law_um2 = kSmallest_um2;
    double error_um2 = 0.0;
    double drift_um2 = kSmallest_um2;
    double strangest = 0.0;
    for (const LawDay& day : days) {
        DayLaw coefficients = law;
        coefficients.offset_um = coefficients.wander_um = coefficients.noise_um = 0.0;
        DayLaw silent = law;
        silent.noise_um = 0.0;
        spread_um2 += detail::covarianceOf(day, coefficients).diagonal().mean();
        error_um2 += detail::covarianceOf(day, silent).diagonal().mean();
        law_um2 += day.mean_um.squaredNorm() / static_cast<double>(day.mean_um.size());
        drift_um2 += (day.mean_um + day.error_um).squaredNorm() / static_cast<double>(day.mean_um.size());
        strangest = std::max(strangest, day.z.rowwise().squaredNorm().maxCoeff());
    }
    law.trust = law_um2 / (law_um2 + kCaution * spread_um2);
    const double unforetold = std::min(error_um2 / drift_um2, 1.0);
    law.doubt = unforetold * unforetold / (unforetold * unforetold + kUnforetold * kUnforetold);
    law.usual = kUsualShare * strangest;
}

/// Covariance of whole days for the fit of the mean law, one for all axes: the mean of the axes' laws relative to their
/// drift.
std::vector<Eigen::MatrixXd> dayCovariances(const LawDays& days, const std::array<DayLaw, kAxes>& laws,
                                            const std::array<bool, kAxes>& axes) {
    std::vector<Eigen::MatrixXd> out;
    for (std::size_t d = 0; d < days[0].size(); ++d) {
        Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(days[0][d].error_um.size(), days[0][d].error_um.size());
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
            if (axes[axis]) {
                const Eigen::MatrixXd one = detail::covarianceOf(days[axis][d], laws[axis]);
                sum += one / one.diagonal().mean();
            }
        }
        out.push_back(std::move(sum));
    }
    return out;
}

class HierarchicalTraining {
 public:
    HierarchicalTraining(const std::vector<ThermalHistory>& days, detail::JudgedRegression regression,
                         const TrainingOptions& options)
        : m_days(days), m_regression(std::move(regression)), m_axes(m_regression.model.axes) {
        m_noise_um = noiseOf(measurementVariance_um2(days));
        FeatureSpec slow = options.features;
        slow.leak_min = {3.0 * slow.leak_min[0], 3.0 * slow.leak_min[1]};
        m_specs = {options.features, slow};
        for (const FeatureSpec& spec : m_specs) {
            m_blocks.push_back(blocksOf(days, spec));
        }
        m_available = static_cast<Index>(days.front().sensors.size());
        if (days.front().sensors.size() <= kAllSensors) {
            for (Index s = 0; s < m_available; ++s) {
                m_sensors.push_back(s);
            }
        } else {
            m_sensors = m_regression.sensors;
        }
    }

    std::optional<ThermalModel> run(const TrainingProgress& progress) {
        std::vector<MeanLaw> laws = finalists();
        for (std::size_t k = 0; k < laws.size(); ++k) {
            if (progress && !progress(static_cast<double>(k) / static_cast<double>(laws.size()))) {
                return std::nullopt;
            }
            MeanLaw weighed = laws[k];
            weighed.weighBy(dayCovariances(lawDays(laws[k]), fit(lawDays(laws[k])), m_axes));
            if (scoreOf(weighed.rms()) < scoreOf(laws[k].rms())) {
                laws[k] = weighed;
            }
        }
        const auto best = std::ranges::min_element(
            laws, [](const MeanLaw& a, const MeanLaw& b) { return scoreOf(a.rms()) < scoreOf(b.rms()); });
        const DayRms old = regressionRms();
        // With few days a choice among many laws is luck: the regression's sensors were chosen more carefully.
        const double measured = measuredAxes();
        const auto count = static_cast<double>(m_days.size());
        const bool regressionWins = scoreOf(old) < scoreOf(best->rms()) + kLuck * measured / (count * count);
        if (m_days.size() < kDaysToChoose || (m_days.size() < kDaysToAverage && regressionWins)) {
            return finish(m_regression.model, regressionLawDays(), old);
        }
        const Averaged law = averaged(laws, *best, old);
        if (scoreOf(old) < scoreOf(rmsOf(law))) {
            return finish(m_regression.model, regressionLawDays(), old);
        }
        return finish(modelOf(*best, law), lawDays(law), rmsOf(law));
    }

 private:
    /// The forms with the smallest error by least squares, and the simplest within reach of the best.
    std::vector<MeanLaw> finalists() {
        const bool speed = std::ranges::none_of(m_days, [](const ThermalHistory& d) { return d.speed_rpm.empty(); });
        const std::vector<bool> atRest = detail::restPatternOf(m_days).atRest;
        const bool heatHolds = speed && std::ranges::all_of(atRest, [](bool rest) { return rest; });
        std::vector<MeanLaw> laws;
        for (std::size_t spec = 0; spec < m_specs.size(); ++spec) {
            for (const unsigned terms : {1U, 2U, 4U, 3U, 5U, 7U}) {
                if (terms == 1U && spec > 0) {
                    continue;  // rises have no leak
                }
                for (const bool heat : {false, true}) {
                    if (!heat || heatHolds) {
                        laws.emplace_back(m_blocks[spec], m_sensors, m_available, Form{spec, terms, heat});
                    }
                }
            }
        }
        const std::size_t plain = laws.size();
        for (std::size_t k = 0; k < plain; ++k) {
            laws.push_back(laws[k]);
            laws.back().weighByDraws(m_axes);
        }
        std::ranges::stable_sort(
            laws, [](const MeanLaw& a, const MeanLaw& b) { return scoreOf(a.rms()) < scoreOf(b.rms()); });
        laws.erase(laws.begin() + static_cast<std::ptrdiff_t>(std::min(kFinalists, laws.size())), laws.end());
        return laws;
    }

    [[nodiscard]] double measuredAxes() const { return static_cast<double>(std::ranges::count(m_axes, true)); }
    /// The mean of several laws: their faults are not the same ones, and a choice by few days is luck.
    struct Averaged {
        Form form{};
        Eigen::MatrixXd weights{};               ///< the model's terms × axes
        std::vector<Eigen::MatrixXd> leftOut{};  ///< per day what the laws without it make of it; blocks × axes
        void add(const Eigen::MatrixXd& otherWeights, const std::vector<Eigen::MatrixXd>& other, double share) {
            weights += share * (otherWeights - weights);
            for (std::size_t d = 0; d < leftOut.size(); ++d) {
                leftOut[d] += share * (other[d] - leftOut[d]);
            }
        }
    };
    [[nodiscard]] std::vector<Eigen::MatrixXd> leftOutOf(const MeanLaw& law) const {
        std::vector<Eigen::MatrixXd> out;
        for (std::size_t d = 0; d < m_days.size(); ++d) {
            out.push_back(law.leftOut(d));
        }
        return out;
    }
    /// The best law, those of its form whose error on days left out is near its, and the regression if it is.
    [[nodiscard]] Averaged averaged(const std::vector<MeanLaw>& laws, const MeanLaw& best,
                                    const DayRms& regression) const {
        Averaged out{best.form(), best.weights(), leftOutOf(best)};
        double count = 1.0;
        for (const MeanLaw& law : laws) {
            if (&law != &best && law.form().spec == best.form().spec && law.form().heat == best.form().heat &&
                scoreOf(law.rms()) <= scoreOf(best.rms()) + kNear * measuredAxes()) {
                out.add(law.weights(), leftOutOf(law), 1.0 / ++count);
            }
        }
        const RegressionPart& part = *m_regression.model.regression;
        if (best.form().spec == 0 && best.form().heat == part.withSpeed.has_value() &&
            m_regression.leftOut.size() == m_days.size() &&
            scoreOf(regression) <= scoreOf(best.rms()) + kNearRegression * measuredAxes()) {
            out.add(regressionWeights(best), regressionLeftOut(), kRegressionShare);
        }
        return out;
    }
    /// The regression's coefficients by the places of a law on all of its sensors.
    [[nodiscard]] Eigen::MatrixXd regressionWeights(const MeanLaw& like) const {
        const RegressionPart& part = *m_regression.model.regression;
        const Eigen::MatrixXd own = solveWithout(part.withSpeed ? *part.withSpeed : part.temperatures, {});
        Eigen::MatrixXd out = Eigen::MatrixXd::Zero(like.places(), static_cast<Index>(kAxes));
        for (std::size_t k = 0; k < m_regression.sensors.size(); ++k) {
            const auto place = std::ranges::find(m_sensors, m_regression.sensors[k]) - m_sensors.begin();
            out.middleRows(place * kTermsPerSensor, kTermsPerSensor) =
                own.middleRows(static_cast<Index>(k) * kTermsPerSensor, kTermsPerSensor);
        }
        if (part.withSpeed) {
            out.bottomRows(kSpeedTerms) = own.bottomRows(kSpeedTerms);
        }
        return out;
    }
    [[nodiscard]] std::vector<Eigen::MatrixXd> regressionLeftOut() const {
        std::vector<Eigen::MatrixXd> out(m_days.size());
        for (const detail::LeftOutDay& left : m_regression.leftOut) {
            out[left.day] = blockMeans(left.predicted_um, blockStep(m_days[left.day]));
        }
        return out;
    }
    [[nodiscard]] DayRms rmsOf(const Averaged& law) const {
        DayRms out;
        for (std::size_t d = 0; d < m_days.size(); ++d) {
            const Eigen::MatrixXd error = m_blocks[law.form.spec][d].y - law.leftOut[d];
            for (std::size_t axis = 0; axis < kAxes; ++axis) {
                out[axis].push_back(
                    std::sqrt(error.col(static_cast<Index>(axis)).squaredNorm() / static_cast<double>(error.rows())));
            }
        }
        return out;
    }
    [[nodiscard]] ThermalModel modelOf(const MeanLaw& best, const Averaged& law) const {
        ThermalModel model = modelOf(best);
        NormalEquations& equations = law.form.heat ? *model.regression->withSpeed : model.regression->temperatures;
        equations = projected(law.form, law.weights, std::move(equations));
        return model;
    }
    /// Normal equations whose solution is these weights and, without some of the sensors, what the sensors left make of
    /// the same prediction.
    [[nodiscard]] NormalEquations projected(const Form& form, const Eigen::MatrixXd& weights,
                                            NormalEquations like) const {
        constexpr double kRidge = 1e-3;
        std::vector<Index> columns;
        for (const Index s : m_sensors) {
            for (Index k = 0; k < kTermsPerSensor; ++k) {
                columns.push_back(s * kTermsPerSensor + k);
            }
        }
        for (Index k = 0; form.heat && k < kSpeedTerms; ++k) {
            columns.push_back(m_available * kTermsPerSensor + k);
        }
        like.gram = Eigen::MatrixXd::Zero(weights.rows(), weights.rows());
        for (const BlockDay& day : m_blocks[form.spec]) {
            const Eigen::MatrixXd x = day.x(Eigen::all, columns);
            like.gram += x.transpose() * x;
        }
        like.ridge.fill(kRidge);
        const Index heat = static_cast<Index>(m_sensors.size()) * kTermsPerSensor;
        Eigen::MatrixXd damped = like.gram;
        for (Index k = 0; k < damped.rows(); ++k) {
            damped(k, k) += (k < heat ? kRidge : kSpeedRidge) * like.gram(k, k);
        }
        like.moment = damped * weights;
        return like;
    }
    [[nodiscard]] LawDays lawDays(const MeanLaw& law) const { return lawDays({law.form(), {}, leftOutOf(law)}); }
    [[nodiscard]] LawDays lawDays(const Averaged& law) const {
        const std::vector<BlockDay>& blocks = m_blocks[law.form.spec];
        const std::vector<Index> columns = termColumns(m_sensors);
        const std::vector<double> scale = scalesOf(blocks, columns);
        const Eigen::MatrixXd whiten = whiteningOf(blocks, columns, scale);
        LawDays out;
        for (std::size_t d = 0; d < blocks.size(); ++d) {
            const Eigen::MatrixXd& predicted = law.leftOut[d];
            const Eigen::MatrixXd x = scaledTerms(blocks[d], columns, scale);
            for (std::size_t axis = 0; axis < kAxes; ++axis) {
                const auto a = static_cast<Index>(axis);
                out[axis].push_back({blocks[d].time_min, x, x * whiten.transpose(), predicted.col(a),
                                     blocks[d].y.col(a) - predicted.col(a)});
            }
        }
        return out;
    }
    [[nodiscard]] LawDays regressionLawDays() const {
        const std::vector<Index> columns = termColumns(m_regression.sensors);
        const std::vector<double> scale = scalesOf(m_blocks[0], columns);
        const Eigen::MatrixXd whiten = whiteningOf(m_blocks[0], columns, scale);
        LawDays out;
        for (const detail::LeftOutDay& left : m_regression.leftOut) {
            const BlockDay& block = m_blocks[0][left.day];
            const Index step = blockStep(m_days[left.day]);
            const Eigen::MatrixXd predicted = blockMeans(left.predicted_um, step);
            const Eigen::MatrixXd error = blockMeans(left.error_um, step);
            const Eigen::MatrixXd x = scaledTerms(block, columns, scale);
            for (std::size_t axis = 0; axis < kAxes; ++axis) {
                const auto a = static_cast<Index>(axis);
                out[axis].push_back({block.time_min, x, x * whiten.transpose(), predicted.col(a), error.col(a)});
            }
        }
        return out;
    }
    [[nodiscard]] static std::vector<Index> termColumns(const std::vector<Index>& sensors) {
        std::vector<Index> out;
        for (const Index s : sensors) {
            for (Index k = 0; k < kTermsPerSensor; ++k) {
                out.push_back(s * kTermsPerSensor + k);
            }
        }
        return out;
    }
    [[nodiscard]] DayRms regressionRms() const {
        DayRms out;
        for (const detail::LeftOutDay& left : m_regression.leftOut) {
            const Eigen::MatrixXd error = blockMeans(left.error_um, blockStep(m_days[left.day]));
            for (std::size_t axis = 0; axis < kAxes; ++axis) {
                out[axis].push_back(
                    std::sqrt(error.col(static_cast<Index>(axis)).squaredNorm() / static_cast<double>(error.rows())));
            }
        }
        return out;
    }
    [[nodiscard]] std::array<DayLaw, kAxes> fit(const LawDays& days) const {
        std::array<DayLaw, kAxes> laws{};
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
            const bool same = axis > 0 && days[axis].front().error_um == days[0].front().error_um &&
                              days[axis].back().error_um == days[0].back().error_um;
            if (same) {
                laws[axis] = laws[0];
            } else if (m_axes[axis]) {
                laws[axis] = detail::fitDayLaw(days[axis], m_noise_um[axis]);
            }
        }
        return laws;
    }

    [[nodiscard]] ThermalModel modelOf(const MeanLaw& law) const {
        ThermalModel model = detail::modelFrame(ModelKind::Hierarchical, m_days, m_sensors, m_specs[law.form().spec]);
        RegressionPart part;
        Form plainForm = law.form();
        plainForm.heat = false;
        const MeanLaw plain =
            law.form().heat ? MeanLaw(m_blocks[law.form().spec], m_sensors, m_available, plainForm) : law;
        part.temperatures = plain.equations();
        fillIntervals(plain, part.temperatures);
        if (law.form().heat) {
            part.withSpeed = law.equations();
            fillIntervals(law, *part.withSpeed);
        }
        model.regression = std::move(part);
        return model;
    }
    void fillIntervals(const MeanLaw& law, NormalEquations& equations) const {
        const std::size_t count = m_sensors.size();
        equations.half_um.assign(lostSetCount(count), PerAxis{});
        const PerAxis whole = law.rmsWithout({});
        const auto store = [&](std::size_t set, const std::vector<std::size_t>& lost) {
            const PerAxis rms = lost.empty() ? whole : law.rmsWithout(lost);
            for (std::size_t axis = 0; axis < kAxes; ++axis) {
                equations.half_um[set][axis] = 1.7 * std::max({rms[axis], whole[axis], detail::kSmallestRms_um});
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

    ThermalModel finish(ThermalModel model, const LawDays& days, const DayRms& rms) const {
        model.kind = ModelKind::Hierarchical;
        DayLayer layer;
        layer.axis = fit(days);
        const std::vector<BlockDay>& blocks = m_blocks[model.features == m_specs[1] ? 1 : 0];
        std::vector<Index> sensors;
        for (const ModelSensor& sensor : model.sensors) {
            sensors.push_back(*m_days.front().sensorIndex(sensor.name));
        }
        layer.termScale_K = scalesOf(blocks, termColumns(sensors));
        const Eigen::MatrixXd whiten = whiteningOf(blocks, termColumns(sensors), layer.termScale_K);
        for (Index row = 0; row < whiten.rows(); ++row) {
            for (Index column = 0; column < whiten.cols(); ++column) {
                layer.whiten.push_back(whiten(row, column));
            }
        }
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
            DayLaw& law = layer.axis[axis];
            if (m_axes[axis]) {
                weighEvidence(days[axis], law);
                law.widening = wideningOf(days[axis], law);
            }
            double squares = 0.0;
            for (const double value : rms[axis]) {
                squares += value * value;
            }
            model.judgement.rms_um[axis] =
                std::max(std::sqrt(squares / static_cast<double>(rms[axis].size())), detail::kSmallestRms_um);
            model.judgement.worst_um[axis] = 0.0;
            for (const LawDay& day : days[axis]) {
                model.judgement.worst_um[axis] =
                    std::max(model.judgement.worst_um[axis], day.error_um.cwiseAbs().maxCoeff());
            }
        }
        model.judgement.heldOut = true;
        model.axes = m_axes;
        model.days = std::move(layer);
        return model;
    }

    const std::vector<ThermalHistory>& m_days;
    detail::JudgedRegression m_regression;
    std::array<bool, kAxes> m_axes;
    PerAxis m_noise_um{};
    std::vector<FeatureSpec> m_specs{};
    std::vector<std::vector<BlockDay>> m_blocks{};
    Index m_available{0};
    std::vector<Index> m_sensors{};
};

}  // namespace

Result<ThermalModel> detail::hierarchicalOn(const JudgedRegression& regression, const std::vector<ThermalHistory>& days,
                                            const TrainingOptions& options, const TrainingProgress& progress) {
    if (days.size() < 2) {
        return fail(KERF_TEXT("A hierarchical model needs at least two days; train a network, or record another day."));
    }
    auto model = HierarchicalTraining(days, regression, options).run(progress);
    if (!model) {
        return fail(KERF_TEXT("Training was cancelled."));
    }
    return std::move(*model);
}

Result<ThermalModel> trainHierarchical(const std::vector<ThermalHistory>& days, const TrainingOptions& options,
                                       const TrainingProgress& progress) {
    if (days.size() < 2) {
        return fail(KERF_TEXT("A hierarchical model needs at least two days; train a network, or record another day."));
    }
    const TrainingProgress half = [&](double share) { return !progress || progress(0.5 * share); };
    auto regression = detail::trainJudgedRegression(days, options, half);
    if (!regression) {
        return tl::unexpected(regression.error());
    }
    return detail::hierarchicalOn(*regression, days, options,
                                  [&](double share) { return !progress || progress(0.5 + 0.5 * share); });
}

}  // namespace kerf::thermal
