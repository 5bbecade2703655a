// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/thermal/gmdh.h"

#include <Eigen/QR>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <set>

#include "engine/process/thermal/pair_moments.h"

namespace kerf::thermal {
namespace {

/// Below this the criterion is rounding error: the model is exact and growth ends.
constexpr double kExact = 1e-12;

Eigen::MatrixXd rowsOf(const Eigen::MatrixXd& all, const std::vector<Eigen::Index>& rows) {
    return all(rows, Eigen::all);
}

double criterionOf(double r2, double u2, GmdhCriterion criterion) {
    switch (criterion) {
        case GmdhCriterion::Regularity:
            return std::sqrt(r2);
        case GmdhCriterion::Unbiased:
            return std::sqrt(u2);
        case GmdhCriterion::Combined:
            break;
    }
    return std::sqrt(r2 + u2);
}

template <int K>
GmdhCoefficients widen(const typename PairBasis<K>::Vector& v) {
    if constexpr (K == 6) {
        return v;
    } else {
        return {v[0], v[1], v[2], 0.0, 0.0, v[3]};
    }
}

double evaluate(const GmdhCoefficients& k, double a, double b) noexcept {
    return k[0] + k[1] * a + k[2] * b + k[3] * a * a + k[4] * b * b + k[5] * a * b;
}

Eigen::MatrixXd design(const Eigen::MatrixXd& x, int i, int j, GmdhBasis basis) {
    const auto a = x.col(i).array();
    const auto b = x.col(j).array();
    Eigen::MatrixXd d(x.rows(), basis == GmdhBasis::Quadratic ? 6 : 4);
    d.col(0).setOnes();
    d.col(1) = a;
    d.col(2) = b;
    if (basis == GmdhBasis::Quadratic) {
        d.col(3) = a * a;
        d.col(4) = b * b;
    }
    d.rightCols<1>() = a * b;
    return d;
}

GmdhCoefficients widen(const Eigen::VectorXd& v) {
    if (v.size() == 6) {
        return {v[0], v[1], v[2], v[3], v[4], v[5]};
    }
    return {v[0], v[1], v[2], 0.0, 0.0, v[3]};
}

/// The rows of one layer, split, and the moments of each part.
struct LayerData {
    Eigen::MatrixXd xA, xB, xC;
};

/// Sums that normalise the criteria: Σ y² over the check rows and over all rows, in the scale of the fit, uncentred.
struct Norms {
    double check{1.0};
    double all{1.0};
};

/// Fits every pair for every output from moments. `best[output]` gets all candidates, unsorted.
template <int K>
void fitAllPairs(const PairMoments& mA, const PairMoments& mB, const PairMoments& mC, double ridge,
                 GmdhCriterion criterion, const std::vector<Norms>& norms,
                 std::vector<std::vector<GmdhCandidate>>& candidates) {
    using Basis = PairBasis<K>;
    PairMoments mAB = mA;
    mAB += mB;
    PairMoments mAll = mAB;
    mAll += mC;
    const Eigen::Index inputs = mA.x.size();
    typename Basis::Gram gA{}, gB{}, gAB{}, gC{}, gAll{};
    typename Basis::Vector a{}, b{}, ab{}, target{}, difference{};
    for (Eigen::Index j = 1; j < inputs; ++j) {
        for (Eigen::Index i = 0; i < j; ++i) {
            Basis::gram(mA, i, j, gA);
            Basis::gram(mB, i, j, gB);
            Basis::gram(mAB, i, j, gAB);
            Basis::gram(mC, i, j, gC);
            Basis::gram(mAll, i, j, gAll);
            Basis::factor(gA, ridge * mA.rows);
            Basis::factor(gB, ridge * mB.rows);
            Basis::factor(gAB, ridge * mAB.rows);
            for (std::size_t output = 0; output < candidates.size(); ++output) {
                const auto column = static_cast<Eigen::Index>(output);
                Basis::rhs(mA, i, j, column, a);
                Basis::rhs(mB, i, j, column, b);
                Basis::rhs(mAB, i, j, column, ab);
                Basis::rhs(mC, i, j, column, target);
                Basis::solve(gA, a);
                Basis::solve(gB, b);
                Basis::solve(gAB, ab);
                double dot = 0.0;
                for (std::size_t k = 0; k < ab.size(); ++k) {
                    dot += ab[k] * target[k];
                    difference[k] = a[k] - b[k];
                }
                const double residual = mC.yy[column] - 2.0 * dot + Basis::quadraticForm(gC, ab);
                const double r2 = std::max(residual, 0.0) / norms[output].check;
                const double u2 = std::max(Basis::quadraticForm(gAll, difference), 0.0) / norms[output].all;
                candidates[output].push_back({static_cast<int>(i), static_cast<int>(j), widen<K>(ab), widen<K>(a),
                                              widen<K>(b), std::sqrt(r2), std::sqrt(u2),
                                              criterionOf(r2, u2, criterion)});
            }
        }
    }
}

/// The same candidate from its rows by QR: slower, all digits.
void refit(GmdhCandidate& candidate, const LayerData& data, const Eigen::VectorXd& yA, const Eigen::VectorXd& yB,
           const Eigen::VectorXd& yC, const GmdhOptions& options, const Norms& norms) {
    const Eigen::MatrixXd dA = design(data.xA, candidate.i, candidate.j, options.basis);
    const Eigen::MatrixXd dB = design(data.xB, candidate.i, candidate.j, options.basis);
    const Eigen::MatrixXd dC = design(data.xC, candidate.i, candidate.j, options.basis);
    Eigen::MatrixXd dAB(dA.rows() + dB.rows(), dA.cols());
    dAB << dA, dB;
    Eigen::VectorXd yAB(yA.size() + yB.size());
    yAB << yA, yB;
    const Eigen::VectorXd a = dA.colPivHouseholderQr().solve(yA);
    const Eigen::VectorXd b = dB.colPivHouseholderQr().solve(yB);
    const Eigen::VectorXd ab = dAB.colPivHouseholderQr().solve(yAB);
    const Eigen::VectorXd difference = a - b;
    const double r2 = (yC - dC * ab).squaredNorm() / norms.check;
    const double u2 = ((dAB * difference).squaredNorm() + (dC * difference).squaredNorm()) / norms.all;
    candidate.coef = widen(ab);
    candidate.coefA = widen(a);
    candidate.coefB = widen(b);
    candidate.r = std::sqrt(r2);
    candidate.u = std::sqrt(u2);
    candidate.c = criterionOf(r2, u2, options.criterion);
}

bool better(const GmdhCandidate& left, const GmdhCandidate& right) {
    return left.c != right.c ? left.c < right.c : std::pair(left.i, left.j) < std::pair(right.i, right.j);
}

/// Everything the layers of one training share.
struct Problem {
    std::vector<double> mean{};
    std::vector<double> scale{};
    LayerData first{};
    Eigen::RowVectorXd outputMean{};
    Eigen::RowVectorXd outputScale{};
    Eigen::MatrixXd yA{}, yB{}, yC{};
    std::vector<Norms> norms{};
};

Problem prepare(const Eigen::MatrixXd& x, const Eigen::MatrixXd& y, const GmdhRows& rows, const GmdhOptions& options) {
    Problem p;
    p.first = {rowsOf(x, rows.a), rowsOf(x, rows.b), rowsOf(x, rows.check)};
    p.yA = rowsOf(y, rows.a);
    p.yB = rowsOf(y, rows.b);
    p.yC = rowsOf(y, rows.check);
    const double training = static_cast<double>(rows.a.size() + rows.b.size());
    const auto meanOf = [training](const auto& a, const auto& b) -> Eigen::RowVectorXd {
        return (a.colwise().sum() + b.colwise().sum()) / training;
    };
    const auto deviationOf = [training](const auto& a, const auto& b,
                                        const Eigen::RowVectorXd& mean) -> Eigen::RowVectorXd {
        const Eigen::RowVectorXd sum =
            (a.rowwise() - mean).colwise().squaredNorm() + (b.rowwise() - mean).colwise().squaredNorm();
        Eigen::RowVectorXd deviation = (sum / training).cwiseSqrt();
        for (double& value : deviation) {
            value = value > 0.0 ? value : 1.0;
        }
        return deviation;
    };
    Eigen::RowVectorXd inputMean = Eigen::RowVectorXd::Zero(x.cols());
    Eigen::RowVectorXd inputScale = Eigen::RowVectorXd::Ones(x.cols());
    p.outputMean = Eigen::RowVectorXd::Zero(y.cols());
    p.outputScale = Eigen::RowVectorXd::Ones(y.cols());
    if (options.standardise) {
        inputMean = meanOf(p.first.xA, p.first.xB);
        inputScale = deviationOf(p.first.xA, p.first.xB, inputMean);
        p.outputMean = meanOf(p.yA, p.yB);
        p.outputScale = deviationOf(p.yA, p.yB, p.outputMean);
    }
    for (Eigen::Index output = 0; output < y.cols(); ++output) {
        const double scale2 = p.outputScale[output] * p.outputScale[output];
        const double check = p.yC.col(output).squaredNorm() / scale2;
        const double all = check + (p.yA.col(output).squaredNorm() + p.yB.col(output).squaredNorm()) / scale2;
        p.norms.push_back({check > 0.0 ? check : 1.0, all > 0.0 ? all : 1.0});
    }
    const auto toScale = [](Eigen::MatrixXd& part, const Eigen::RowVectorXd& mean, const Eigen::RowVectorXd& scale) {
        part = (part.rowwise() - mean).array().rowwise() / scale.array();
    };
    for (Eigen::MatrixXd* part : {&p.first.xA, &p.first.xB, &p.first.xC}) {
        toScale(*part, inputMean, inputScale);
    }
    for (Eigen::MatrixXd* part : {&p.yA, &p.yB, &p.yC}) {
        toScale(*part, p.outputMean, p.outputScale);
    }
    p.mean.assign(inputMean.begin(), inputMean.end());
    p.scale.assign(inputScale.begin(), inputScale.end());
    return p;
}

/// All candidates of one layer for the given outputs, not sorted.
std::vector<std::vector<GmdhCandidate>> candidatesOf(const LayerData& data, const Eigen::MatrixXd& yA,
                                                     const Eigen::MatrixXd& yB, const Eigen::MatrixXd& yC,
                                                     const std::vector<Norms>& norms, const GmdhOptions& options) {
    const bool cubes = options.basis == GmdhBasis::Quadratic;
    const PairMoments mA(data.xA, yA, cubes);
    const PairMoments mB(data.xB, yB, cubes);
    const PairMoments mC(data.xC, yC, cubes);
    std::vector<std::vector<GmdhCandidate>> candidates(static_cast<std::size_t>(yA.cols()));
    const auto pairs = static_cast<std::size_t>(data.xA.cols() * (data.xA.cols() - 1) / 2);
    for (auto& list : candidates) {
        list.reserve(pairs);
    }
    if (cubes) {
        fitAllPairs<6>(mA, mB, mC, options.ridge, options.criterion, norms, candidates);
    } else {
        fitAllPairs<4>(mA, mB, mC, options.ridge, options.criterion, norms, candidates);
    }
    return candidates;
}

/// Keep the best, with all digits when there is no ridge to make the normal equations harmless.
void keepBest(std::vector<GmdhCandidate>& candidates, const LayerData& data, const Problem& p, Eigen::Index output,
              const GmdhOptions& options) {
    const auto keep = std::min(candidates.size(), static_cast<std::size_t>(options.width));
    const bool exact = options.ridge == 0.0;
    // A few more than are kept: exact digits may change the order at the edge.
    const auto look = exact ? std::min(candidates.size(), keep + keep / 2 + 2) : keep;
    std::partial_sort(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(look), candidates.end(),
                      better);
    candidates.resize(look);
    if (exact) {
        for (GmdhCandidate& candidate : candidates) {
            refit(candidate, data, p.yA.col(output), p.yB.col(output), p.yC.col(output), options,
                  p.norms[static_cast<std::size_t>(output)]);
        }
        std::sort(candidates.begin(), candidates.end(), better);
        candidates.resize(keep);
    }
}

GmdhNeuron neuronFrom(const GmdhCandidate& candidate, const LayerData& data, const GmdhOptions& options) {
    GmdhNeuron neuron{candidate.i, candidate.j, candidate.coef, {}, {}, candidate.c, candidate.r, candidate.u};
    neuron.low = -std::numeric_limits<double>::max();
    neuron.high = std::numeric_limits<double>::max();
    if (options.clampSpans) {
        double low = std::numeric_limits<double>::max();
        double high = -low;
        for (const Eigen::MatrixXd* part : {&data.xA, &data.xB}) {
            for (Eigen::Index row = 0; row < part->rows(); ++row) {
                const double z = evaluate(neuron.coef, (*part)(row, neuron.i), (*part)(row, neuron.j));
                low = std::min(low, z);
                high = std::max(high, z);
            }
        }
        const double span = high - low;
        neuron.low = low - *options.clampSpans * span;
        neuron.high = high + *options.clampSpans * span;
    }
    return neuron;
}

LayerData outputsOf(const std::vector<GmdhNeuron>& layer, const LayerData& data) {
    LayerData next;
    const auto through = [&layer](const Eigen::MatrixXd& in) {
        Eigen::MatrixXd out(in.rows(), static_cast<Eigen::Index>(layer.size()));
        for (std::size_t n = 0; n < layer.size(); ++n) {
            for (Eigen::Index row = 0; row < in.rows(); ++row) {
                out(row, static_cast<Eigen::Index>(n)) = std::clamp(
                    evaluate(layer[n].coef, in(row, layer[n].i), in(row, layer[n].j)), layer[n].low, layer[n].high);
            }
        }
        return out;
    };
    next.xA = through(data.xA);
    next.xB = through(data.xB);
    next.xC = through(data.xC);
    return next;
}

/// Keeps only the neurons the best one of the last layer needs.
void dropUnused(GmdhModel& model) {
    std::vector<int> wanted{0};
    for (auto layer = model.layers.rbegin(); layer != model.layers.rend(); ++layer) {
        std::vector<GmdhNeuron> kept;
        std::set<int> below;
        for (const int index : wanted) {
            kept.push_back((*layer)[static_cast<std::size_t>(index)]);
            below.insert({kept.back().i, kept.back().j});
        }
        *layer = std::move(kept);
        if (std::next(layer) == model.layers.rend()) {
            break;  // layer 1 keeps the model's input numbers
        }
        wanted.assign(below.begin(), below.end());
        const auto renumber = [&wanted](int old) {
            return static_cast<int>(std::ranges::find(wanted, old) - wanted.begin());
        };
        for (GmdhNeuron& neuron : *layer) {
            neuron.i = renumber(neuron.i);
            neuron.j = renumber(neuron.j);
        }
    }
}

std::optional<Sentence> whyUntrainable(const Eigen::MatrixXd& x, const GmdhRows& rows, const GmdhOptions& options) {
    if (x.cols() < 2) {
        return Sentence(KERF_TEXT("A network of pairs needs at least 2 inputs; got %1."),
                        {static_cast<double>(x.cols()), 0});
    }
    if (options.width < 1 || options.width > kMaxGmdhWidth || options.maxLayers < 1 || !(options.ridge >= 0.0)) {
        return Sentence(KERF_TEXT("Network width %1 is out of range; expected 1 to %2."),
                        {static_cast<double>(options.width), 0}, {static_cast<double>(kMaxGmdhWidth), 0});
    }
    const auto smallest = std::min({rows.a.size(), rows.b.size(), rows.check.size()});
    if (smallest < 8) {
        return Sentence(KERF_TEXT("A training or check set has only %1 rows; expected at least %2."),
                        {static_cast<double>(smallest), 0}, {8.0, 0});
    }
    return std::nullopt;
}

}  // namespace

std::vector<GmdhCandidate> firstLayerCandidates(const Eigen::MatrixXd& x, const Eigen::VectorXd& y,
                                                const GmdhRows& rows, const GmdhOptions& options) {
    const Problem p = prepare(x, y, rows, options);
    auto candidates = candidatesOf(p.first, p.yA, p.yB, p.yC, p.norms, options);
    std::ranges::sort(candidates.front(), {}, [](const GmdhCandidate& c) { return std::pair(c.i, c.j); });
    return std::move(candidates.front());
}

Result<std::vector<GmdhModel>> trainGmdh(const Eigen::MatrixXd& x, const Eigen::MatrixXd& y, const GmdhRows& rows,
                                         const GmdhOptions& options) {
    if (const auto why = whyUntrainable(x, rows, options)) {
        return tl::unexpected(*why);
    }
    const Problem p = prepare(x, y, rows, options);
    // Layer 1 has the same inputs for every output: one factorisation serves all.
    auto firstLayer = candidatesOf(p.first, p.yA, p.yB, p.yC, p.norms, options);
    std::vector<GmdhModel> models;
    for (Eigen::Index output = 0; output < y.cols(); ++output) {
        GmdhModel model;
        model.inputCount = static_cast<int>(x.cols());
        model.inputMean = p.mean;
        model.inputScale = p.scale;
        model.outputMean = p.outputMean[output];
        model.outputScale = p.outputScale[output];
        const std::vector<Norms> norms{p.norms[static_cast<std::size_t>(output)]};
        LayerData data = p.first;
        double best = std::numeric_limits<double>::max();
        for (int layer = 0; layer < options.maxLayers && data.xA.cols() >= 2 && best > kExact; ++layer) {
            auto candidates =
                layer == 0
                    ? std::move(firstLayer[static_cast<std::size_t>(output)])
                    : std::move(candidatesOf(data, p.yA.col(output), p.yB.col(output), p.yC.col(output), norms, options)
                                    .front());
            const int count = static_cast<int>(candidates.size());
            keepBest(candidates, data, p, output, options);
            if (!(candidates.front().c < best * (1.0 - options.minFall))) {
                break;
            }
            best = candidates.front().c;
            model.growth.push_back({static_cast<int>(data.xA.cols()), count, best});
            std::vector<GmdhNeuron> neurons;
            for (const GmdhCandidate& candidate : candidates) {
                neurons.push_back(neuronFrom(candidate, data, options));
            }
            data = outputsOf(neurons, data);
            model.layers.push_back(std::move(neurons));
        }
        dropUnused(model);
        models.push_back(std::move(model));
    }
    return models;
}

std::vector<int> GmdhModel::usedInputs() const {
    std::set<int> used;
    for (const GmdhNeuron& neuron : layers.front()) {
        used.insert({neuron.i, neuron.j});
    }
    return {used.begin(), used.end()};
}

GmdhModel GmdhModel::pruned() const {
    const std::vector<int> used = usedInputs();
    GmdhModel out = *this;
    out.inputCount = static_cast<int>(used.size());
    out.inputMean.clear();
    out.inputScale.clear();
    for (const int input : used) {
        out.inputMean.push_back(inputMean[static_cast<std::size_t>(input)]);
        out.inputScale.push_back(inputScale[static_cast<std::size_t>(input)]);
    }
    const auto renumber = [&used](int old) { return static_cast<int>(std::ranges::find(used, old) - used.begin()); };
    for (GmdhNeuron& neuron : out.layers.front()) {
        neuron.i = renumber(neuron.i);
        neuron.j = renumber(neuron.j);
    }
    return out;
}

double GmdhModel::predict(std::span<const double> x) const noexcept {
    assert(x.size() == static_cast<std::size_t>(inputCount));
    std::array<double, kMaxGmdhWidth> values{};
    std::array<double, kMaxGmdhWidth> next{};
    const auto standardised = [&](int input) {
        const auto k = static_cast<std::size_t>(input);
        return (x[k] - inputMean[k]) / inputScale[k];
    };
    bool first = true;
    for (const auto& layer : layers) {
        for (std::size_t n = 0; n < layer.size(); ++n) {
            const GmdhNeuron& neuron = layer[n];
            const double a = first ? standardised(neuron.i) : values[static_cast<std::size_t>(neuron.i)];
            const double b = first ? standardised(neuron.j) : values[static_cast<std::size_t>(neuron.j)];
            next[n] = std::clamp(evaluate(neuron.coef, a, b), neuron.low, neuron.high);
        }
        std::swap(values, next);
        first = false;
    }
    return values[0] * outputScale + outputMean;
}

}  // namespace kerf::thermal
