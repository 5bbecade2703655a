// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/boring/kalman_estimator.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace kerf::boring {
namespace {

constexpr int kMaxDepths = static_cast<int>(kMaxBoreDepths);

/// Shapes of an update with `Depths` bores. The usual two are known to the compiler, which then unrolls; sums keep
/// their order, so that the digits are those of the general shape (other sizes would not).
template <int Depths>
struct Shape {
    static constexpr int kMost = Depths == Eigen::Dynamic ? kMaxDepths : Depths;
    using Vector = Eigen::Matrix<double, Depths, 1, 0, kMost, 1>;
    using Design = Eigen::Matrix<double, Depths, 3, 0, kMost, 3>;
    using Square = Eigen::Matrix<double, Depths, Depths, 0, kMost, kMost>;
    using Gain = Eigen::Matrix<double, 3, Depths, 0, 3, kMost>;
};

constexpr std::array<double, kMaxBoreDepths> kChiSquare{13.831084, 17.034386, 19.656116, 22.004581,
                                                        24.185464, 26.249856, 28.227094, 30.135882};
constexpr int kMaxSteps = 12;
constexpr int kMaxHalvings = 6;
constexpr double kSmallStep = 1e-10;        // of ln d
constexpr double kLargestLnD = 5.0;         // keeps a wild step finite
constexpr double kLeastProbability = 1e-4;  // neither model is ever ruled out
constexpr double kLargestLogOdds = 50.0;
constexpr double kChangeProbability = 0.02;  // per part, for the evidence

struct Gaussian {
    Eigen::Vector3d mean;
    Eigen::Matrix3d p;
};

struct Posterior {
    Gaussian theta;
    double cost;        ///< T²
    double lnEvidence;  ///< up to a constant common to all models
};

/// The part's bores as the update needs them.
template <int Depths>
struct Bores {
    typename Shape<Depths>::Design x;
    typename Shape<Depths>::Vector d_mm;
};

template <int Depths>
Bores<Depths> boresOf(const PartVisit& visit) noexcept {
    Bores<Depths> bores;
    bores.x.resize(visit.count, 3);
    bores.d_mm.resize(visit.count);
    for (Eigen::Index i = 0; i < visit.count; ++i) {
        const Measurement& m = visit.rows[static_cast<std::size_t>(i)];
        bores.x.row(i) << 1.0, std::log(m.feed_mmPerRev), std::log(m.overhang_mm);
        bores.d_mm(i) = m.deflection_mm;
    }
    return bores;
}

/// x θ.
template <int Depths>
typename Shape<Depths>::Vector along(const Bores<Depths>& bores, const Eigen::Vector3d& theta) noexcept {
    if constexpr (Depths == Eigen::Dynamic) {
        return bores.x * theta;
    } else {  // the same sum in the same order
        return bores.x.col(0) * theta(0) + bores.x.col(1) * theta(1) + bores.x.col(2) * theta(2);
    }
}

template <int Depths>
typename Shape<Depths>::Vector predicted_mm(const Bores<Depths>& bores, const Eigen::Vector3d& theta) noexcept {
    return along(bores, theta).array().min(kLargestLnD).exp().matrix();
}

/// From centred (level, α, β) to (ln C, α, β).
Eigen::Matrix3d uncentring(const KalmanState& point) noexcept {
    Eigen::Matrix3d t = Eigen::Matrix3d::Identity();
    t(0, 1) = -point.lnFeed;
    t(0, 2) = -point.lnOverhang;
    return t;
}

Eigen::Matrix3d covarianceOf(const KalmanParams::Spread& spread, double parts, const KalmanState& point) noexcept {
    const Eigen::Vector3d variance(spread.level * spread.level, spread.alpha * spread.alpha, spread.beta * spread.beta);
    const Eigen::Matrix3d t = uncentring(point);
    return t * (parts * variance).asDiagonal() * t.transpose();
}

/// Scales a covariance down where its centred spreads pass the ceiling; a congruence, so it stays positive definite.
Eigen::Matrix3d bounded(const Eigen::Matrix3d& p, const KalmanParams::Spread& ceiling,
                        const KalmanState& point) noexcept {
    const Eigen::Matrix3d t = uncentring(point);
    Eigen::Matrix3d centring = Eigen::Matrix3d::Identity();
    centring(0, 1) = point.lnFeed;
    centring(0, 2) = point.lnOverhang;
    const Eigen::Matrix3d centred = centring * p * centring.transpose();
    const Eigen::Vector3d limit(ceiling.level, ceiling.alpha, ceiling.beta);
    const Eigen::Vector3d scale = (limit.array() / centred.diagonal().array().sqrt()).min(1.0);
    if (scale.minCoeff() >= 1.0) {
        return p;
    }
    return t * (scale.asDiagonal() * centred * scale.asDiagonal()) * t.transpose();
}

/// What is wanted of an update: the test for a change needs no covariance.
enum class Wanted : std::uint8_t { Cost, Everything };

/// rest P restᵀ + r K Kᵀ.
template <int Depths>
Eigen::Matrix3d josephForm(const Eigen::Matrix3d& rest, const Eigen::Matrix3d& p,
                           const typename Shape<Depths>::Gain& gain, double r) noexcept {
    if constexpr (Depths == Eigen::Dynamic) {
        return rest * p * rest.transpose() + r * gain * gain.transpose();
    } else {
        Eigen::Matrix3d sum = rest * p * rest.transpose();
        sum += r * gain.lazyProduct(gain.transpose());
        return sum;
    }
}

/// The most probable θ given a prior and the bores, its covariance (Joseph form) and how well both agree.
template <Wanted W = Wanted::Everything, int Depths>
Posterior posterior(const Gaussian& prior, const Bores<Depths>& bores, double sigma_mm) noexcept {
    using Vector = typename Shape<Depths>::Vector;
    using Square = typename Shape<Depths>::Square;
    const double r = sigma_mm * sigma_mm;
    const Eigen::LDLT<Eigen::Matrix3d> priorInverse(prior.p);
    const auto costOf = [&](const Eigen::Vector3d& theta, const Vector& dHat_mm) {
        const Eigen::Vector3d delta = theta - prior.mean;
        return delta.dot(priorInverse.solve(delta)) + (bores.d_mm - dHat_mm).squaredNorm() / r;
    };
    typename Shape<Depths>::Design h;
    Eigen::LLT<Square> innovation;
    const auto linearise = [&](const Vector& dHat_mm) {
        h = dHat_mm.asDiagonal() * bores.x;
        Square s = h * prior.p * h.transpose();
        s.diagonal().array() += r;
        innovation.compute(s);
    };

    // First step in ln d, about the measured values themselves: right at once after a large change.
    Vector dHat_mm = bores.d_mm.cwiseMax(sigma_mm);
    Vector z = dHat_mm.cwiseProduct(dHat_mm.array().log().matrix() - along(bores, prior.mean));
    Eigen::Vector3d theta = prior.mean;
    double cost = 0.0;
    for (int step = 0; step < kMaxSteps; ++step) {
        linearise(dHat_mm);
        Eigen::Vector3d next = prior.mean + prior.p * h.transpose() * innovation.solve(z);
        Vector nextD_mm = predicted_mm(bores, next);
        double nextCost = costOf(next, nextD_mm);
        for (int half = 0; step > 0 && half < kMaxHalvings && nextCost > cost; ++half) {
            next = 0.5 * (next + theta);
            nextD_mm = predicted_mm(bores, next);
            nextCost = costOf(next, nextD_mm);
        }
        if (step > 0 && nextCost > cost) {
            break;
        }
        const double moved = along<Depths>(bores, next - theta).cwiseAbs().maxCoeff();
        theta = next;
        cost = nextCost;
        dHat_mm = nextD_mm;
        z = bores.d_mm - dHat_mm + dHat_mm.asDiagonal() * along<Depths>(bores, theta - prior.mean);
        if (step > 0 && moved < kSmallStep) {
            break;
        }
    }
    if constexpr (W == Wanted::Cost) {
        return {prior, cost, 0.0};
    }
    linearise(dHat_mm);
    const typename Shape<Depths>::Gain gain = innovation.solve(h * prior.p).transpose();
    const Eigen::Matrix3d rest = Eigen::Matrix3d::Identity() - gain * h;
    double lnDeterminant = 0.0;
    for (Eigen::Index i = 0; i < bores.d_mm.size(); ++i) {
        lnDeterminant += 2.0 * std::log(innovation.matrixLLT()(i, i));
    }
    const Eigen::Matrix3d p = josephForm<Depths>(rest, prior.p, gain, r);
    return {{theta, 0.5 * (p + p.transpose())}, cost, -0.5 * (cost + lnDeterminant)};
}

Gaussian gaussianOf(const KalmanMode& mode) noexcept {
    return {vectorOf(mode.law), matrixOf(mode.covariance)};
}
KalmanMode modeOf(const Gaussian& g) noexcept {
    return {lawOf(g.mean), boring::covarianceOf(g.p)};
}

/// Mean and covariance of a two-part mixture; `share` is the weight of the second.
Gaussian mixture(const Gaussian& first, const Gaussian& second, double share) noexcept {
    const Eigen::Vector3d apart = second.mean - first.mean;
    return {first.mean + share * apart,
            (1.0 - share) * first.p + share * second.p + share * (1.0 - share) * apart * apart.transpose()};
}

void beginWeights(KalmanState& state, const KalmanParams& params, const Gaussian& g) noexcept {
    state.modes.fill(modeOf(g));
    state.movingProbability = params.startMoving / (params.startMoving + params.stopMoving);
}

/// Both models one part on, before the part is seen.
struct Prediction {
    std::array<Gaussian, kKalmanModels> models;
    double movingProbability;
};

Prediction predictionOf(const KalmanState& before, const KalmanParams& params, std::uint32_t part,
                        const KalmanState& point) noexcept {
    const double parts = part > before.part ? static_cast<double>(part - before.part) : 1.0;
    const double wasMoving = before.movingProbability;
    const double moving = (1.0 - wasMoving) * params.startMoving + wasMoving * (1.0 - params.stopMoving);
    const Gaussian quiet = gaussianOf(before.modes[kQuiet]);
    const Gaussian movingBefore = gaussianOf(before.modes[kMoving]);
    Prediction prediction{{mixture(quiet, movingBefore, wasMoving * params.stopMoving / (1.0 - moving)),
                           mixture(quiet, movingBefore, wasMoving * (1.0 - params.stopMoving) / moving)},
                          moving};
    auto& prior = prediction.models;
    prior[kQuiet].p = bounded(prior[kQuiet].p + covarianceOf(params.quiet, parts, point), params.ceiling, point);
    prior[kMoving].p = bounded(prior[kMoving].p + covarianceOf(params.moving, parts, point), params.ceiling, point);
    return prediction;
}

/// `before` with the working point of a part's bores.
template <int Depths>
KalmanState pointOf(const KalmanState& before, const PartVisit& visit, const Bores<Depths>& bores) noexcept {
    KalmanState point = before;
    point.part = visit.part;
    point.lnFeed = bores.x.col(1).mean();
    point.lnOverhang = bores.x.col(2).mean();
    return point;
}

/// update() for a visit of so many bores, at least one.
template <int Depths>
KalmanState updated(const KalmanState& before, const KalmanParams& params, const PartVisit& visit, RowOutcome* outcome,
                    ChangeKnowledge knowledge, double* lnEvidence) noexcept {
    const Bores<Depths> bores = boresOf<Depths>(visit);
    KalmanState state = pointOf(before, visit, bores);
    bool changed = false;
    double t2 = 0.0;
    if (!before.ready) {
        const Gaussian prior{vectorOf(params.prior), covarianceOf(params.priorSpread, 1.0, state)};
        const Posterior first = posterior(prior, bores, params.sigma_mm);
        beginWeights(state, params, first.theta);
        state.ready = true;
        if (lnEvidence != nullptr) {
            *lnEvidence = first.lnEvidence;
        }
    } else {
        const Prediction predicted = predictionOf(before, params, visit.part, state);
        const std::array<Gaussian, kKalmanModels>& prior = predicted.models;
        const double moving = predicted.movingProbability;
        Gaussian weighted = mixture(prior[kQuiet], prior[kMoving], moving);
        t2 = posterior<Wanted::Cost>(weighted, bores, params.sigma_mm).cost;
        changed = knowledge == ChangeKnowledge::Changed ||
                  (knowledge == ChangeKnowledge::Unknown && t2 > changeThreshold(visit.count));
        if (changed) {
            weighted.p += covarianceOf(params.change, 1.0, state);
            const Posterior anew = posterior(weighted, bores, params.sigma_mm);
            beginWeights(state, params, anew.theta);
            if (lnEvidence != nullptr) {
                *lnEvidence = anew.lnEvidence + std::log(kChangeProbability);
            }
        } else {
            const Posterior asQuiet = posterior(prior[kQuiet], bores, params.sigma_mm);
            const Posterior asMoving = posterior(prior[kMoving], bores, params.sigma_mm);
            const double logOdds = std::log(moving / (1.0 - moving)) + asMoving.lnEvidence - asQuiet.lnEvidence;
            const double odds = std::exp(std::clamp(logOdds, -kLargestLogOdds, kLargestLogOdds));
            state.modes = {modeOf(asQuiet.theta), modeOf(asMoving.theta)};
            if (lnEvidence != nullptr) {
                const double most = std::max(asQuiet.lnEvidence, asMoving.lnEvidence);
                *lnEvidence = most + std::log((1.0 - moving) * std::exp(asQuiet.lnEvidence - most) +
                                              moving * std::exp(asMoving.lnEvidence - most));
            }
            state.movingProbability = std::clamp(odds / (1.0 + odds), kLeastProbability, 1.0 - kLeastProbability);
        }
    }
    if (outcome != nullptr) {
        *outcome = {combined(state), changed, t2};
    }
    return state;
}

}  // namespace

double changeThreshold(std::size_t bores) noexcept {
    return kChiSquare[std::clamp<std::size_t>(bores, 1, kMaxBoreDepths) - 1];
}

Estimate combined(const KalmanState& state) noexcept {
    const KalmanMode mode =
        modeOf(mixture(gaussianOf(state.modes[kQuiet]), gaussianOf(state.modes[kMoving]), state.movingProbability));
    return {state.ready, mode.law, mode.covariance};
}

Estimate predictedFor(const KalmanState& before, const KalmanParams& params, const PartVisit& visit) noexcept {
    if (!before.ready || visit.count == 0) {
        return combined(before);
    }
    const KalmanState point = pointOf(before, visit, boresOf<Eigen::Dynamic>(visit));
    const Prediction prediction = predictionOf(before, params, visit.part, point);
    const KalmanMode mode =
        modeOf(mixture(prediction.models[kQuiet], prediction.models[kMoving], prediction.movingProbability));
    return {true, mode.law, mode.covariance};
}

KalmanState update(const KalmanState& before, const KalmanParams& params, const PartVisit& visit, RowOutcome* outcome,
                   ChangeKnowledge knowledge, double* lnEvidence) noexcept {
    if (visit.count == 0) {
        return before;
    }
    return visit.count == 2 ? updated<2>(before, params, visit, outcome, knowledge, lnEvidence)
                            : updated<Eigen::Dynamic>(before, params, visit, outcome, knowledge, lnEvidence);
}

}  // namespace kerf::boring
