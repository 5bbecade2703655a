// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "engine/process/thermal/training_common.h"

/// The mean law of a hierarchical model while it is trained; for that trainer alone.
namespace kerf::thermal::detail {

using Index = Eigen::Index;

inline constexpr Index kBlocks = 60;  // at most, of a day: block means keep what a law can see and lose the noise
inline constexpr std::array<double, 11> kRidges{1e-3, 1e-2, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0, 1e6};
inline constexpr double kDaysForErrors = 8.0;
inline constexpr double kSimpler =
    1.0;  // standard errors that a simpler law may be worse by: the least is luck among many
inline constexpr double kSamplesOfADay = 5.0;  // independent ones: minutes of a day are not
inline constexpr double kPriorDays = 6.0;      // that the shrinkage of a covariance is worth
inline constexpr double kScoreFloor_um = 0.05;
inline constexpr double kUnlike = 2.0;  // a day whose error is beyond this × the median weighs less in the mean law

struct BlockDay {
    Eigen::VectorXd time_min{};
    Eigen::MatrixXd x{};  ///< blocks × (3 · sensors + 3)
    Eigen::MatrixXd y{};
};

inline Eigen::MatrixXd blockMeans(const Eigen::MatrixXd& rows, Index step) {
    const Index blocks = rows.rows() / step;
    Eigen::MatrixXd out(blocks, rows.cols());
    for (Index b = 0; b < blocks; ++b) {
        out.row(b) = rows.middleRows(b * step, step).colwise().mean();
    }
    return out;
}
inline Index blockStep(const ThermalHistory& day) {
    return (day.workRows() + kBlocks - 1) / kBlocks;
}
inline Eigen::MatrixXd timesOf(const ThermalHistory& day) {
    return Eigen::Map<const Eigen::VectorXd>(day.time_min.data(), day.rows()).bottomRows(day.workRows());
}

inline std::vector<BlockDay> blocksOf(const std::vector<ThermalHistory>& days, const FeatureSpec& spec) {
    std::vector<BlockDay> out;
    for (const ThermalHistory& day : days) {
        const Index step = blockStep(day);
        out.push_back({blockMeans(timesOf(day), step), blockMeans(featureMatrix(day, spec), step),
                       blockMeans(measuredDrift(day), step)});
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

inline double medianOf(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}
inline double meanOf(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) {
        sum += value;
    }
    return sum / static_cast<double>(values.size());
}
/// What laws are compared by, per day: its rms, one very bad day bounded.
inline std::vector<double> bounded(std::vector<double> rms) {
    const double most = 3.0 * medianOf(rms);
    for (double& value : rms) {
        value = std::min(value, most) + kScoreFloor_um;
    }
    return rms;
}
/// a is no worse than b by more than kSimpler standard errors of their paired difference.
inline bool noWorse(const std::vector<double>& a, const std::vector<double>& b) {
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
    // A standard error from three days says little: the rule comes in with the days.
    const double errors = kSimpler * std::clamp((n - 2.0) / kDaysForErrors, 0.1, 1.0);
    return mean <= errors * std::sqrt(squares / std::max(n - 1.0, 1.0) / n);
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
    /// Coefficients by all days, by the model's places; terms × axes.
    [[nodiscard]] Eigen::MatrixXd weights() const {
        const auto [gram, moment] = sums(m_days->size());
        Eigen::MatrixXd out = Eigen::MatrixXd::Zero(places(), static_cast<Index>(kAxes));
        for (Index axis = 0; axis < static_cast<Index>(kAxes); ++axis) {
            const Eigen::VectorXd w = solved(gram, moment, m_ridge[static_cast<std::size_t>(axis)]).col(axis);
            for (std::size_t k = 0; k < m_places.size(); ++k) {
                out(m_places[k], axis) = w[static_cast<Index>(k)];
            }
        }
        return out;
    }
    [[nodiscard]] Index places() const {
        return static_cast<Index>(m_sensors.size()) * kTermsPerSensor + (m_form.heat ? kSpeedTerms : 0);
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

}  // namespace kerf::thermal::detail
