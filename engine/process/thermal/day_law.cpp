// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engine/process/thermal/training_common.h"

namespace kerf::thermal::detail {
namespace {

using Index = Eigen::Index;

constexpr std::array<double, 6> kWander_min{8.0, 20.0, 50.0, 120.0, 300.0, 800.0};
constexpr double kFreedom = 12.0;    // of the multivariate t over days
constexpr double kPriorWidth = 1.5;  // σ of a log parameter about its prior: a weak one, for few days

/// Products that do not depend on the parameters.
struct Prepared {
    Eigen::MatrixXd gain{};
    Eigen::MatrixXd slope{};
    Eigen::MatrixXd lever{};
    std::array<Eigen::MatrixXd, kWander_min.size()> wander{};
    Eigen::VectorXd error{};
};

Eigen::MatrixXd wanderOf(const Eigen::VectorXd& t, double tau_min) {
    Eigen::MatrixXd out(t.size(), t.size());
    for (Index i = 0; i < t.size(); ++i) {
        for (Index j = 0; j <= i; ++j) {  // symmetric
            out(i, j) = std::exp(-std::abs(t[i] - t[j]) / tau_min) - std::exp(-(t[i] + t[j]) / tau_min);
            out(j, i) = out(i, j);
        }
    }
    return out;
}

/// Every second row of a long day: neighbours say nearly the same, and the cost goes by the cube.
LawDay thinned(const LawDay& day) {
    constexpr Index kEnough = 30;
    const Index step = (day.time_min.size() + kEnough - 1) / kEnough;
    std::vector<Index> rows;
    for (Index row = step - 1; row < day.time_min.size(); row += step) {
        rows.push_back(row);
    }
    return {day.time_min(rows), day.x(rows, Eigen::all), day.z(rows, Eigen::all), day.mean_um(rows),
            day.error_um(rows)};
}

/// Logs of gain, slope, offset, wander, lever.
using Logs = std::array<double, 5>;

class Likelihood {
 public:
    Likelihood(const std::vector<LawDay>& days, double noise_um) : m_noise_um2(noise_um * noise_um) {
        double squares = 0.0;
        double rows = 0.0;
        for (const LawDay& whole : days) {
            const LawDay day = thinned(whole);
            Prepared one;
            one.gain = day.mean_um * day.mean_um.transpose();
            one.slope = day.x * day.x.transpose();
            one.lever = day.z * day.z.transpose();
            for (std::size_t k = 0; k < kWander_min.size(); ++k) {
                one.wander[k] = wanderOf(day.time_min, kWander_min[k]);
            }
            one.error = day.error_um;
            squares += day.error_um.squaredNorm();
            rows += static_cast<double>(day.error_um.size());
            m_days.push_back(std::move(one));
        }
        const double rms_um = std::sqrt(squares / rows + m_noise_um2);
        m_prior = {std::log(0.2), std::log(0.5 * rms_um), std::log(0.2 * rms_um), std::log(0.5 * rms_um),
                   std::log(0.3 * rms_um)};
    }
    [[nodiscard]] const Logs& prior() const { return m_prior; }
    /// −log of the posterior density.
    [[nodiscard]] double operator()(const Logs& logs, std::size_t wander) const {
        double sum = 0.0;
        for (std::size_t k = 0; k < logs.size(); ++k) {
            const double off = (logs[k] - m_prior[k]) / kPriorWidth;
            sum += 0.5 * off * off;
        }
        std::array<double, 5> variance{};
        for (std::size_t k = 0; k < logs.size(); ++k) {
            variance[k] = std::exp(2.0 * logs[k]);
        }
        for (const Prepared& day : m_days) {
            Eigen::MatrixXd s = variance[0] * day.gain + variance[1] * day.slope + variance[3] * day.wander[wander] +
                                variance[4] * day.lever;
            s.array() += variance[2];
            s.diagonal().array() += m_noise_um2;
            const Eigen::LLT<Eigen::MatrixXd> factor(s);
            const Eigen::VectorXd white = factor.matrixL().solve(day.error);
            const auto n = static_cast<double>(white.size());
            sum += factor.matrixLLT().diagonal().array().log().sum() +
                   0.5 * (kFreedom + n) * std::log1p(white.squaredNorm() / kFreedom);
        }
        return sum;
    }

 private:
    std::vector<Prepared> m_days{};
    double m_noise_um2;
    Logs m_prior{};
};

}  // namespace

Eigen::MatrixXd covarianceOf(const LawDay& day, const DayLaw& law) {
    Eigen::MatrixXd s = law.gain * law.gain * (day.mean_um * day.mean_um.transpose()) +
                        law.slope_um * law.slope_um * (day.x * day.x.transpose()) +
                        law.lever_um * law.lever_um * (day.z * day.z.transpose()) +
                        law.wander_um * law.wander_um * wanderOf(day.time_min, law.wander_min);
    s.array() += law.offset_um * law.offset_um;
    s.diagonal().array() += law.noise_um * law.noise_um;
    return s;
}

DayLaw fitDayLaw(const std::vector<LawDay>& days, double noise_um) {
    const Likelihood cost(days, noise_um);
    Logs at = cost.prior();
    std::size_t wander = 2;
    double best = cost(at, wander);
    for (double step = 0.8; step > 0.1;) {  // pattern search: few parameters, no derivatives
        bool moved = false;
        for (std::size_t k = 0; k < at.size(); ++k) {
            for (const double way : {step, -step}) {
                Logs tried = at;
                tried[k] += way;
                const double value = cost(tried, wander);
                if (value < best) {
                    best = value;
                    at = tried;
                    moved = true;
                    break;
                }
            }
        }
        for (const int way : {1, -1}) {
            const auto tried = static_cast<std::size_t>(static_cast<int>(wander) + way);
            if (tried < kWander_min.size()) {
                const double value = cost(at, tried);
                if (value < best) {
                    best = value;
                    wander = tried;
                    moved = true;
                    break;
                }
            }
        }
        step = moved ? step : 0.5 * step;
    }
    DayLaw law;
    law.gain = std::exp(at[0]);
    law.slope_um = std::exp(at[1]);
    law.offset_um = std::exp(at[2]);
    law.wander_um = std::exp(at[3]);
    law.lever_um = std::exp(at[4]);
    law.wander_min = kWander_min[wander];
    law.noise_um = noise_um;
    return law;
}

}  // namespace kerf::thermal::detail
