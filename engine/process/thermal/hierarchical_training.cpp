// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/process/thermal/training.h"
#include "engine/process/thermal/training_common.h"

namespace kerf::thermal {
namespace {

using Index = Eigen::Index;
using detail::LawDay;

constexpr Index kBlocks = 60;           // at most, of a day: block means keep what a law can see and lose the noise
constexpr std::size_t kAllSensors = 8;  // up to that many no sensor is chosen: the ridge does it
constexpr std::array<double, 9> kRidges{1e-3, 1e-2, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0, 1e6};
constexpr double kSimpler = 0.1;          // standard errors that a simpler law may be worse by
constexpr double kLuck = 0.8;             // by that over days² the log error of a new law must be smaller, per axis
constexpr std::size_t kDaysToChoose = 3;  // with fewer the mean law is the regression
constexpr std::size_t kFinalists = 4;
constexpr double kSamplesOfADay = 5.0;  // independent ones: minutes of a day are not
constexpr double kPriorDays = 6.0;      // that the shrinkage of a covariance is worth
constexpr double kScoreFloor_um = 0.05;
constexpr double kUnlike = 2.0;  // a day whose error is beyond this × the median weighs less in the mean law

struct BlockDay {
    Eigen::VectorXd time_min{};
    Eigen::MatrixXd x{};  ///< blocks × (3 · sensors + 3)
    Eigen::MatrixXd y{};
};

Eigen::MatrixXd blockMeans(const Eigen::MatrixXd& rows, Index step) {
    const Index blocks = rows.rows() / step;
    Eigen::MatrixXd out(blocks, rows.cols());
    for (Index b = 0; b < blocks; ++b) {
        out.row(b) = rows.middleRows(b * step, step).colwise().mean();
    }
    return out;
}
Index blockStep(const ThermalHistory& day) {
    return (day.workRows() + kBlocks - 1) / kBlocks;
}
Eigen::MatrixXd timesOf(const ThermalHistory& day) {
    return Eigen::Map<const Eigen::VectorXd>(day.time_min.data(), day.rows()).bottomRows(day.workRows());
}

std::vector<BlockDay> blocksOf(const std::vector<ThermalHistory>& days, const FeatureSpec& spec) {
    std::vector<BlockDay> out;
    for (const ThermalHistory& day : days) {
        const Index step = blockStep(day);
        out.push_back({blockMeans(timesOf(day), step), blockMeans(featureMatrix(day, spec), step),
                       blockMeans(detail::measuredDrift(day), step)});
    }
    return out;
}

/// Which terms a mean law has.
struct Form {
    std::size_t spec{0};
    unsigned terms{7};  ///< bit k: term k of every sensor
    bool heat{false};
};

/// Quadratic form of a day's squared error in the weights, plain and weighted, per axis.
struct DayStats {
    Eigen::MatrixXd plain{};
    Eigen::MatrixXd plainMoment{};
    Eigen::RowVectorXd squares{};
    double rows{0.0};
    Eigen::MatrixXd gram{};
    Eigen::MatrixXd moment{};
};

double medianOf(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}
double meanOf(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) {
        sum += value;
    }
    return sum / static_cast<double>(values.size());
}
/// What laws are compared by, per day: its rms, one very bad day bounded.
std::vector<double> bounded(std::vector<double> rms) {
    const double most = 3.0 * medianOf(rms);
    for (double& value : rms) {
        value = std::min(value, most) + kScoreFloor_um;
    }
    return rms;
}
/// a is no worse than b by more than kSimpler standard errors of their paired difference.
bool noWorse(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> difference;
    for (std::size_t d = 0; d < a.size(); ++d) {
        difference.push_back(a[d] - b[d]);
    }
    const double mean = meanOf(difference);
    double squares = 0.0;
    for (const double value : difference) {
        squares += (value - mean) * (value - mean);
    }
    const auto n = static_cast<double>(difference.size());
    return mean <= kSimpler * std::sqrt(squares / std::max(n - 1.0, 1.0) / n);
}

/// A mean law of one form on days, judged day by day without the day.
class MeanLaw {
 public:
    MeanLaw(const std::vector<BlockDay>& days, std::vector<Index> sensors, Index available, const Form& form)
        : m_days(&days), m_form(form), m_sensors(std::move(sensors)) {
        for (std::size_t s = 0; s < m_sensors.size(); ++s) {
            for (Index k = 0; k < kTermsPerSensor; ++k) {
                if ((form.terms >> static_cast<unsigned>(k) & 1U) != 0U) {
                    m_columns.push_back(m_sensors[s] * kTermsPerSensor + k);
                    m_places.push_back(static_cast<Index>(s) * kTermsPerSensor + k);
                }
            }
        }
        for (Index k = 0; form.heat && k < kSpeedTerms; ++k) {
            m_columns.push_back(available * kTermsPerSensor + k);
            m_places.push_back(static_cast<Index>(m_sensors.size()) * kTermsPerSensor + k);
        }
        m_weight.assign(days.size(), 1.0);
        for (const BlockDay& day : days) {
            const Eigen::MatrixXd x = day.x(Eigen::all, m_columns);
            DayStats stats;
            stats.rows = static_cast<double>(x.rows());
            stats.plain = x.transpose() * x / stats.rows;
            stats.plainMoment = x.transpose() * day.y / stats.rows;
            stats.squares = day.y.colwise().squaredNorm() / stats.rows;
            stats.gram = stats.plain;
            stats.moment = stats.plainMoment;
            m_stats.push_back(std::move(stats));
        }
        judge();
        weighUnlikeDays();
    }

    /// From now on fitted with every day's own covariance.
    void weighBy(const std::vector<Eigen::MatrixXd>& covariance) {
        for (std::size_t d = 0; d < m_days->size(); ++d) {
            const Eigen::MatrixXd x = (*m_days)[d].x(Eigen::all, m_columns);
            const Eigen::LLT<Eigen::MatrixXd> factor(covariance[d]);
            const Eigen::MatrixXd whiteX = factor.matrixL().solve(x);
            const Eigen::MatrixXd whiteY = factor.matrixL().solve((*m_days)[d].y);
            m_stats[d].gram = whiteX.transpose() * whiteX;
            m_stats[d].moment = whiteX.transpose() * whiteY;
        }
        judge();
    }

    /// From now on fitted as the mean of coefficients that are drawn anew each day, N(mean, Ω), Ω by expectation
    /// maximisation and shrunk towards its diagonal; axes relative to their drift share it.
    void weighByDraws(const std::array<bool, kAxes>& axes) {
        constexpr int kRounds = 40;
        const auto p = static_cast<Index>(m_columns.size());
        const auto days = static_cast<double>(m_stats.size());
        PerAxis power{};
        double active = 0.0;
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
            for (const DayStats& day : m_stats) {
                power[axis] += day.squares[static_cast<Index>(axis)] / days;
            }
            active += axes[axis] ? 1.0 : 0.0;
        }
        Eigen::VectorXd scale = Eigen::VectorXd::Constant(p, 1e-12);
        for (const DayStats& day : m_stats) {
            scale += day.plain.diagonal() / days;
        }
        scale = scale.cwiseSqrt().cwiseInverse();
        std::vector<Eigen::MatrixXd> gram;
        for (const DayStats& day : m_stats) {
            gram.push_back(kSamplesOfADay * (scale.asDiagonal() * day.plain * scale.asDiagonal()));
        }
        Eigen::MatrixXd omega = Eigen::MatrixXd::Identity(p, p) / static_cast<double>(p);
        double noise = 0.1;
        std::vector<Eigen::MatrixXd> posterior(m_stats.size());
        Eigen::MatrixXd mean = Eigen::MatrixXd::Zero(p, static_cast<Index>(kAxes));
        Eigen::MatrixXd precision;
        for (int round = 0; round < kRounds; ++round) {
            precision = omega.llt().solve(Eigen::MatrixXd::Identity(p, p));
            std::vector<Eigen::MatrixXd> draws;
            Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(p, static_cast<Index>(kAxes));
            for (std::size_t d = 0; d < m_stats.size(); ++d) {
                posterior[d] = (gram[d] / noise + precision).llt().solve(Eigen::MatrixXd::Identity(p, p));
                Eigen::MatrixXd draw(p, static_cast<Index>(kAxes));
                for (Index axis = 0; axis < static_cast<Index>(kAxes); ++axis) {
                    const double unit = std::sqrt(power[static_cast<std::size_t>(axis)] + 1e-12);
                    draw.col(axis) =
                        posterior[d] *
                        (kSamplesOfADay / noise * (scale.asDiagonal() * m_stats[d].plainMoment.col(axis)) / unit +
                         precision * mean.col(axis));
                }
                sum += draw;
                draws.push_back(std::move(draw));
            }
            mean = sum / days;
            Eigen::MatrixXd spread = Eigen::MatrixXd::Zero(p, p);
            double rest = 0.0;
            for (std::size_t d = 0; d < m_stats.size(); ++d) {
                for (std::size_t axis = 0; axis < kAxes; ++axis) {
                    if (!axes[axis]) {
                        continue;
                    }
                    const auto a = static_cast<Index>(axis);
                    const double unit = std::sqrt(power[axis] + 1e-12);
                    const Eigen::VectorXd draw = draws[d].col(a);
                    spread += posterior[d] + (draw - mean.col(a)) * (draw - mean.col(a)).transpose();
                    rest += kSamplesOfADay * (m_stats[d].squares[a] / (unit * unit)) -
                            2.0 * kSamplesOfADay * draw.dot(scale.asDiagonal() * m_stats[d].plainMoment.col(a)) / unit +
                            draw.dot(gram[d] * draw) + (posterior[d] * gram[d]).trace();
                }
            }
            const double level = spread.trace() / static_cast<double>(p) / (active * days);
            omega = (spread + kPriorDays * level * Eigen::MatrixXd::Identity(p, p)) / (active * days + kPriorDays);
            noise = std::max(rest / (active * days * kSamplesOfADay), 1e-6);
        }
        precision = omega.llt().solve(Eigen::MatrixXd::Identity(p, p));
        const Eigen::VectorXd back = scale.cwiseInverse();
        for (std::size_t d = 0; d < m_stats.size(); ++d) {
            const Eigen::MatrixXd drawn = (gram[d] / noise + precision).llt().solve(Eigen::MatrixXd::Identity(p, p));
            const Eigen::MatrixXd information = precision - precision * drawn * precision;
            m_stats[d].gram = back.asDiagonal() * information * back.asDiagonal();
            m_stats[d].moment = back.asDiagonal() * precision * drawn * scale.asDiagonal() * m_stats[d].plainMoment *
                                (kSamplesOfADay / noise);
        }
        judge();
    }

    [[nodiscard]] const Form& form() const { return m_form; }
    [[nodiscard]] const std::vector<Index>& columns() const { return m_columns; }
    [[nodiscard]] std::size_t size() const { return m_columns.size(); }
    /// rms per axis and day at the ridge chosen.
    [[nodiscard]] const std::array<std::vector<double>, kAxes>& rms() const { return m_rms; }
    [[nodiscard]] const PerAxis& ridge() const { return m_ridge; }

    /// What the law without day d makes of it; blocks × axes.
    [[nodiscard]] Eigen::MatrixXd leftOut(std::size_t d) const {
        const auto [gram, moment] = sums(d);
        Eigen::MatrixXd out((*m_days)[d].y.rows(), static_cast<Index>(kAxes));
        for (Index axis = 0; axis < static_cast<Index>(kAxes); ++axis) {
            out.col(axis) = (*m_days)[d].x(Eigen::all, m_columns) *
                            solved(gram, moment, m_ridge[static_cast<std::size_t>(axis)]).col(axis);
        }
        return out;
    }
    /// In the form of the model file, intervals not filled in.
    [[nodiscard]] NormalEquations equations() const {
        const auto [gram, moment] = sums(m_days->size());
        const Index all = static_cast<Index>(m_sensors.size()) * kTermsPerSensor + (m_form.heat ? kSpeedTerms : 0);
        NormalEquations out;
        out.sensors = static_cast<int>(m_sensors.size());
        out.gram = Eigen::MatrixXd::Zero(all, all);
        out.moment = Eigen::MatrixXd::Zero(all, static_cast<Index>(kAxes));
        for (std::size_t a = 0; a < m_places.size(); ++a) {
            const auto row = static_cast<Index>(a);
            for (std::size_t b = 0; b < m_places.size(); ++b) {
                out.gram(m_places[a], m_places[b]) = gram(row, static_cast<Index>(b));
            }
            out.moment.row(m_places[a]) = moment.row(row);
        }
        out.rows = 1.0;
        for (const BlockDay& day : *m_days) {
            out.rows += static_cast<double>(day.y.rows());
        }
        out.ridge = m_ridge;
        return out;
    }
    /// rms per axis on the days left out, without these of the law's sensors.
    [[nodiscard]] PerAxis rmsWithout(const std::vector<std::size_t>& lost) const {
        std::vector<Index> kept;
        for (std::size_t k = 0; k < m_places.size(); ++k) {
            const auto sensor = static_cast<std::size_t>(m_places[k] / kTermsPerSensor);
            if (std::ranges::find(lost, sensor) == lost.end()) {
                kept.push_back(static_cast<Index>(k));
            }
        }
        PerAxis sum{};
        for (std::size_t d = 0; d < m_days->size(); ++d) {
            const auto [gram, moment] = sums(d);
            const DayStats& own = m_stats[d];
            for (std::size_t axis = 0; axis < kAxes; ++axis) {
                const auto a = static_cast<Index>(axis);
                const Eigen::VectorXd w = solved(gram(kept, kept), moment(kept, Eigen::all), m_ridge[axis]).col(a);
                sum[axis] += own.squares[a] - 2.0 * w.dot(own.plainMoment(kept, a)) + w.dot(own.plain(kept, kept) * w);
            }
        }
        for (double& value : sum) {
            value = std::sqrt(std::max(value, 0.0) / static_cast<double>(m_days->size()));
        }
        return sum;
    }

 private:
    struct Sums {
        Eigen::MatrixXd gram{};
        Eigen::MatrixXd moment{};
    };
    [[nodiscard]] Sums sums(std::size_t without) const {
        const auto n = static_cast<Index>(m_columns.size());
        Sums out{Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, static_cast<Index>(kAxes))};
        for (std::size_t d = 0; d < m_stats.size(); ++d) {
            if (d != without) {
                out.gram += m_weight[d] * m_stats[d].gram;
                out.moment += m_weight[d] * m_stats[d].moment;
            }
        }
        return out;
    }
    [[nodiscard]] Eigen::MatrixXd solved(Eigen::MatrixXd gram, const Eigen::MatrixXd& moment, double ridge) const {
        const Index heat = m_form.heat ? gram.rows() - kSpeedTerms : gram.rows();
        for (Index k = 0; k < gram.rows(); ++k) {
            gram(k, k) += (k < heat ? ridge : kSpeedRidge) * gram(k, k) + 1e-12;
        }
        return gram.llt().solve(moment);
    }
    void judge() {
        std::array<std::array<std::vector<double>, kRidges.size()>, kAxes> rms;
        for (std::size_t d = 0; d < m_days->size(); ++d) {
            const auto [gram, moment] = sums(d);
            const DayStats& own = m_stats[d];
            for (std::size_t r = 0; r < kRidges.size(); ++r) {
                const Eigen::MatrixXd w = solved(gram, moment, kRidges[r]);
                for (std::size_t axis = 0; axis < kAxes; ++axis) {
                    const auto a = static_cast<Index>(axis);
                    const double square = own.squares[a] - 2.0 * w.col(a).dot(own.plainMoment.col(a)) +
                                          w.col(a).dot(own.plain * w.col(a));
                    rms[axis][r].push_back(std::sqrt(std::max(square, 0.0)));
                }
            }
        }
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
            std::size_t best = 0;
            for (std::size_t r = 1; r < kRidges.size(); ++r) {
                if (meanOf(bounded(rms[axis][r])) <= meanOf(bounded(rms[axis][best]))) {
                    best = r;
                }
            }
            std::size_t chosen = best;
            for (std::size_t r = best + 1; r < kRidges.size(); ++r) {
                if (noWorse(bounded(rms[axis][r]), bounded(rms[axis][best]))) {
                    chosen = r;
                }
            }
            m_ridge[axis] = kRidges[chosen];
            m_rms[axis] = rms[axis][chosen];
        }
    }
    /// A day that the others do not foretell pulls less.
    void weighUnlikeDays() {
        for (std::size_t d = 0; d < m_days->size(); ++d) {
            double weight = 1.0;
            for (const auto& axis : m_rms) {
                const double usual = kUnlike * (medianOf(axis) + kScoreFloor_um);
                weight = std::min(weight, axis[d] > usual ? usual * usual / (axis[d] * axis[d]) : 1.0);
            }
            m_weight[d] = weight;
        }
        judge();
    }

    const std::vector<BlockDay>* m_days;
    Form m_form;
    std::vector<Index> m_sensors;
    std::vector<Index> m_columns{};  ///< of the block days
    std::vector<Index> m_places{};   ///< of the model's terms
    std::vector<DayStats> m_stats{};
    std::vector<double> m_weight{};
    std::array<std::vector<double>, kAxes> m_rms{};
    PerAxis m_ridge{};
};

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
        const auto measured = static_cast<double>(std::ranges::count(m_axes, true));
        const auto count = static_cast<double>(m_days.size());
        if (m_days.size() < kDaysToChoose || scoreOf(old) < scoreOf(best->rms()) + kLuck * measured / (count * count)) {
            return finish(m_regression.model, regressionLawDays(), old);
        }
        return finish(modelOf(*best), lawDays(*best), best->rms());
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

    [[nodiscard]] LawDays lawDays(const MeanLaw& law) const {
        const std::vector<BlockDay>& blocks = m_blocks[law.form().spec];
        const std::vector<Index> columns = termColumns(m_sensors);
        const std::vector<double> scale = scalesOf(blocks, columns);
        LawDays out;
        for (std::size_t d = 0; d < blocks.size(); ++d) {
            const Eigen::MatrixXd predicted = law.leftOut(d);
            const Eigen::MatrixXd x = scaledTerms(blocks[d], columns, scale);
            for (std::size_t axis = 0; axis < kAxes; ++axis) {
                const auto a = static_cast<Index>(axis);
                out[axis].push_back({blocks[d].time_min, x, predicted.col(a), blocks[d].y.col(a) - predicted.col(a)});
            }
        }
        return out;
    }
    [[nodiscard]] LawDays regressionLawDays() const {
        const std::vector<Index> columns = termColumns(m_regression.sensors);
        const std::vector<double> scale = scalesOf(m_blocks[0], columns);
        LawDays out;
        for (const detail::LeftOutDay& left : m_regression.leftOut) {
            const BlockDay& block = m_blocks[0][left.day];
            const Index step = blockStep(m_days[left.day]);
            const Eigen::MatrixXd predicted = blockMeans(left.predicted_um, step);
            const Eigen::MatrixXd error = blockMeans(left.error_um, step);
            const Eigen::MatrixXd x = scaledTerms(block, columns, scale);
            for (std::size_t axis = 0; axis < kAxes; ++axis) {
                const auto a = static_cast<Index>(axis);
                out[axis].push_back({block.time_min, x, predicted.col(a), error.col(a)});
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
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
            DayLaw& law = layer.axis[axis];
            if (m_axes[axis]) {
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
