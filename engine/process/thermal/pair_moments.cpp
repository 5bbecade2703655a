// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/thermal/pair_moments.h"

namespace kerf::thermal {
namespace {

/// AᵀA, computed as a triangle and mirrored.
Eigen::MatrixXd gramOf(const Eigen::MatrixXd& a) {
    Eigen::MatrixXd g = Eigen::MatrixXd::Zero(a.cols(), a.cols());
    g.selfadjointView<Eigen::Lower>().rankUpdate(a.transpose());
    g.triangularView<Eigen::StrictlyUpper>() = g.transpose();
    return g;
}

/// Aᵀ·diag(w)·A for weights of both signs: the positive rows minus the negative ones would be two products; a
/// triangular product of A and the weighted A is one.
Eigen::MatrixXd weightedGram(const Eigen::MatrixXd& a, const Eigen::VectorXd& w) {
    const Eigen::MatrixXd weighted = w.asDiagonal() * a;
    Eigen::MatrixXd g(a.cols(), a.cols());
    g.triangularView<Eigen::Lower>() = a.transpose() * weighted;
    g.triangularView<Eigen::StrictlyUpper>() = g.transpose();
    return g;
}

}  // namespace

PairMoments::PairMoments(const Eigen::MatrixXd& inputs, const Eigen::MatrixXd& outputs, bool withCubes)
    : rows(static_cast<double>(inputs.rows())) {
    const Eigen::MatrixXd squares = inputs.array().square().matrix();
    x = inputs.colwise().sum().transpose();
    xx = gramOf(inputs);
    xxx.noalias() = squares.transpose() * inputs;
    xxxT = xxx.transpose();
    x2x2 = gramOf(squares);
    if (withCubes) {
        const Eigen::MatrixXd cubes = (squares.array() * inputs.array()).matrix();
        x3x.noalias() = cubes.transpose() * inputs;
        x3xT = x3x.transpose();
    }
    y = outputs.colwise().sum();
    yy = outputs.colwise().squaredNorm();
    xy.noalias() = inputs.transpose() * outputs;
    x2y.noalias() = squares.transpose() * outputs;
    xxy.reserve(static_cast<std::size_t>(outputs.cols()));
    for (Eigen::Index output = 0; output < outputs.cols(); ++output) {
        xxy.push_back(weightedGram(inputs, outputs.col(output)));
    }
}

PairMoments& PairMoments::operator+=(const PairMoments& other) {
    rows += other.rows;
    x += other.x;
    xx += other.xx;
    xxx += other.xxx;
    xxxT += other.xxxT;
    x2x2 += other.x2x2;
    if (x3x.size() > 0) {
        x3x += other.x3x;
        x3xT += other.x3xT;
    }
    y += other.y;
    yy += other.yy;
    xy += other.xy;
    x2y += other.x2y;
    for (std::size_t output = 0; output < xxy.size(); ++output) {
        xxy[output] += other.xxy[output];
    }
    return *this;
}

}  // namespace kerf::thermal
