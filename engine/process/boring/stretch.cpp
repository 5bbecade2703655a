// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/boring/stretch.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace kerf::boring {
namespace {

using Vector4 = Eigen::Vector4d;
using Matrix4 = Eigen::Matrix4d;

constexpr int kMaxSteps = 30;
constexpr int kMaxHalvings = 8;
constexpr double kSmallStep = 1e-10;
constexpr double kLargestLnD = 5.0;
// Standard deviation of w for a tool that is surely quiet, and for one that surely moves.
constexpr double kQuietWear = 0.001;
constexpr double kMovingWear = 0.02;

struct Row {
    Vector4 x;
    double d_mm;
};

/// Cost of (θ, w) against the bores and a Gaussian about (prior, 0): squares in units of their standard deviations.
struct Fit {
    std::span<const Row> rows;
    double sigma_mm;
    Vector4 mean;
    Matrix4 precision;

    [[nodiscard]] double cost(const Vector4& p) const {
        const Vector4 off = p - mean;
        double sum = off.dot(precision * off);
        for (const Row& row : rows) {
            const double e = (row.d_mm - std::exp(std::min(kLargestLnD, row.x.dot(p)))) / sigma_mm;
            sum += e * e;
        }
        return sum;
    }
    /// Gauss-Newton: HᵀH and Hᵀe of the bores alone.
    void linearise(const Vector4& p, Matrix4& information, Vector4& gradient) const {
        information.setZero();
        gradient.setZero();
        for (const Row& row : rows) {
            const double expected_mm = std::exp(std::min(kLargestLnD, row.x.dot(p)));
            const Vector4 h = row.x * (expected_mm / sigma_mm);
            information += h * h.transpose();
            gradient += h * ((row.d_mm - expected_mm) / sigma_mm);
        }
    }
    [[nodiscard]] Vector4 solve(Vector4 p) const {
        double now = cost(p);
        for (int step = 0; step < kMaxSteps; ++step) {
            Matrix4 information;
            Vector4 gradient;
            linearise(p, information, gradient);
            const Vector4 move = (information + precision).ldlt().solve(gradient - precision * (p - mean));
            double share = 1.0;
            double next = cost(p + move);
            for (int half = 0; half < kMaxHalvings && next > now; ++half) {
                share *= 0.5;
                next = cost(p + share * move);
            }
            if (next > now) {
                break;
            }
            p += share * move;
            now = next;
            if (move.cwiseAbs().maxCoeff() < kSmallStep) {
                break;
            }
        }
        return p;
    }
};

/// The visits' bores as evidence. @pre at least one bore
Stretch evidenceOf(std::span<const PartVisit> visits, StretchKind kind, const KalmanState& end,
                   const KalmanParams& params) {
    Stretch stretch;
    stretch.kind = kind;
    stretch.fromPart = visits.front().part;
    stretch.toPart = visits.back().part;
    std::vector<Row> rows;
    for (const PartVisit& visit : visits) {
        for (const Measurement& m : visit.measurements()) {
            const double since = static_cast<double>(visit.part - stretch.fromPart);
            rows.push_back({{1.0, std::log(m.feed_mmPerRev), std::log(m.overhang_mm), since}, m.deflection_mm});
            stretch.lnFeed += rows.back().x(1);
            stretch.lnOverhang += rows.back().x(2);
        }
    }
    const auto count = static_cast<double>(rows.size());
    stretch.bores = static_cast<std::uint32_t>(rows.size());
    stretch.lnFeed /= count;
    stretch.lnOverhang /= count;

    const double moving = end.movingProbability;
    const double wear = std::sqrt((1.0 - moving) * kQuietWear * kQuietWear + moving * kMovingWear * kMovingWear);
    Fit fit{rows, params.sigma_mm, Vector4::Zero(), Matrix4::Zero()};
    fit.mean.head<3>() = vectorOf(params.prior);
    Eigen::Matrix3d centring = Eigen::Matrix3d::Identity();
    centring(0, 1) = stretch.lnFeed;
    centring(0, 2) = stretch.lnOverhang;
    const Eigen::Vector3d spread(params.priorSpread.level, params.priorSpread.alpha, params.priorSpread.beta);
    fit.precision.topLeftCorner<3, 3>() =
        centring.transpose() * spread.cwiseAbs2().cwiseInverse().asDiagonal() * centring;
    fit.precision(3, 3) = 1.0 / (wear * wear);
    Vector4 start = Vector4::Zero();
    start.head<3>() = vectorOf(combined(end).law);
    const Vector4 best = fit.solve(start);

    Matrix4 information;
    Vector4 gradient;
    fit.linearise(best, information, gradient);
    Vector4 h = information * best + gradient;  // of the bores; now the prior of w, which is part of the model
    information(3, 3) += fit.precision(3, 3);
    const Eigen::Vector3d coupling = information.block<3, 1>(0, 3);
    stretch.information = information.topLeftCorner<3, 3>() - coupling * coupling.transpose() / information(3, 3);
    stretch.vector = h.head<3>() - coupling * (h(3) / information(3, 3));
    return stretch;
}

}  // namespace

std::vector<Stretch> stretchesOf(std::span<const PartVisit> visits, std::span<const AnnouncedChange> announced,
                                 const KalmanParams& params) {
    std::vector<Stretch> out;
    std::size_t first = 0;
    StretchKind kind = StretchKind::Insert;
    KalmanState state;
    const auto close = [&](std::size_t end) {
        if (end > first) {
            out.push_back(evidenceOf(visits.subspan(first, end - first), kind, state, params));
        }
        first = end;
    };
    std::uint32_t before = 0;
    for (std::size_t i = 0; i < visits.size(); ++i) {
        const PartVisit& visit = visits[i];
        if (visit.count == 0) {
            continue;
        }
        const AnnouncedChange* change = nullptr;  // the last one since the part measured before
        for (const AnnouncedChange& one : announced) {
            if (one.part > before && one.part <= visit.part && (change == nullptr || one.part >= change->part)) {
                change = &one;
            }
        }
        before = visit.part;
        if (change != nullptr && i > 0) {
            close(i);
            kind = change->kind;
            state = {};
        }
        RowOutcome outcome;
        const KalmanState next = update(state, params, visit, &outcome);
        if (outcome.perturbed) {
            close(i);
            kind = StretchKind::Unexplained;
            state = update({}, params, visit, &outcome);
        } else {
            state = next;
        }
    }
    close(visits.size());
    return out;
}

}  // namespace kerf::boring
