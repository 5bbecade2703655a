// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/boring/memory.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace kerf::boring {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr std::size_t at(MemoryStep step) noexcept {
    return static_cast<std::size_t>(step);
}
constexpr int kPasses = 3;
constexpr std::int64_t kLotInWork = -1;

/// Prior of one τ: log-normal. The centre is a guess of the trade, the width says that it is one.
struct SpreadPrior {
    Vector3d centre;
    double lnWidth;
};
const SpreadPrior& priorOf(MemoryStep step) {
    static const std::array<SpreadPrior, kMemorySteps> kPriors{{
        {{0.20, 0.06, 0.08}, 1.0},    // machine
        {{0.15, 0.04, 0.06}, 1.0},    // part type
        {{0.15, 0.06, 0.06}, 1.0},    // insert grade
        {{0.15, 0.06, 0.06}, 1.0},    // material
        {{0.05, 0.025, 0.025}, 1.3},  // lot
        {{0.12, 0.06, 0.06}, 0.9},    // insert
        {{0.08, 0.03, 0.03}, 1.0},    // regrind
        {{0.08, 0.03, 0.03}, 1.0},    // batch of material
    }};
    return kPriors[at(step)];
}

/// exp(−½θᵀΛθ + hᵀθ + c): what a branch says about the node it hangs on.
struct Message {
    Matrix3d information{Matrix3d::Zero()};
    Vector3d vector{Vector3d::Zero()};
    double lnScale{0.0};

    Message& operator+=(const Message& other) {
        information += other.information;
        vector += other.vector;
        lnScale += other.lnScale;
        return *this;
    }
    /// Through a step with spread τ²: θ(child) = θ(parent) + N(0, τ²).
    [[nodiscard]] Message through(const Matrix3d& variance) const {
        const Matrix3d m = (Matrix3d::Identity() + information * variance).inverse();
        Message up;
        const Vector3d mh = m * vector;
        const Matrix3d mi = m * information;
        up.information = 0.5 * (mi + mi.transpose());
        up.vector = mh;
        up.lnScale = lnScale + 0.5 * std::log(m.determinant()) + 0.5 * vector.dot(variance * mh);
        return up;
    }
    [[nodiscard]] Message through(const Vector3d& variance) const { return through(Matrix3d(variance.asDiagonal())); }
};

struct Leaf {
    StretchKind kind;
    Message message;
};
/// A lot as leaves in centred coordinates about the prior.
struct LotLeaves {
    std::int64_t id;
    const MemoryContext* context;
    std::vector<Leaf> leaves;
};

/// What the spreads of a tree are.
struct Spreads {
    std::array<Vector3d, kMemorySteps> variance{};
    Vector3d unexplained{Vector3d::Zero()};

    [[nodiscard]] const Vector3d& of(MemoryStep step) const { return variance[at(step)]; }
    /// Within a tool: what the stretch differs by from the tool at its begin.
    [[nodiscard]] const Vector3d& within(StretchKind kind) const {
        return kind == StretchKind::Material ? of(MemoryStep::Batch) : unexplained;
    }
    [[nodiscard]] const Vector3d& toolStep(StretchKind kind) const {
        return of(kind == StretchKind::Reground ? MemoryStep::Regrind : MemoryStep::Insert);
    }
};

bool beginsTool(StretchKind kind) noexcept {
    return kind == StretchKind::Insert || kind == StretchKind::Reground;
}

/// The leaves of the tool that begins at `first`; `end` is set behind them.
Message toolMessage(std::span<const Leaf> leaves, std::size_t first, std::size_t& end, const Spreads& spreads) {
    Message tool = leaves[first].message;
    end = first + 1;
    Message later;  // a change stays until the tool goes: each stretch hangs on the one before
    std::size_t last = first + 1;
    while (last < leaves.size() && !beginsTool(leaves[last].kind)) {
        ++last;
    }
    for (std::size_t i = last; i-- > first + 1;) {
        later += leaves[i].message;
        later = later.through(spreads.within(leaves[i].kind));
    }
    end = last;
    return tool += later;
}

Message lotMessage(std::span<const Leaf> leaves, const Spreads& spreads) {
    Message lot;
    for (std::size_t i = 0; i < leaves.size();) {
        std::size_t end = i;
        const StretchKind kind = leaves[i].kind;
        const Message tool = toolMessage(leaves, i, end, spreads);
        lot += tool.through(spreads.toolStep(beginsTool(kind) ? kind : StretchKind::Insert));
        i = end;
    }
    return lot;
}

std::vector<Leaf> leavesOf(std::span<const Stretch> stretches, const Matrix3d& uncentring, const Vector3d& origin) {
    std::vector<Leaf> leaves;
    for (const Stretch& stretch : stretches) {
        Message message;
        message.information = uncentring.transpose() * stretch.information * uncentring;
        message.vector = uncentring.transpose() * (stretch.vector - stretch.information * origin);
        leaves.push_back({stretch.kind, message});
    }
    return leaves;
}

/// Lots [first, last) share their context down to `level`; their message to the node of that level.
Message contextMessage(std::span<const LotLeaves> lots, std::size_t level, const Spreads& spreads) {
    Message node;
    if (level == MemoryContext::kLevels) {
        for (const LotLeaves& lot : lots) {
            node += lotMessage(lot.leaves, spreads).through(spreads.of(MemoryStep::Lot));
        }
        return node;
    }
    for (std::size_t first = 0; first < lots.size();) {
        std::size_t last = first + 1;
        while (last < lots.size() && lots[last].context->names[level] == lots[first].context->names[level]) {
            ++last;
        }
        node += contextMessage(lots.subspan(first, last - first), level + 1, spreads).through(spreads.variance[level]);
        first = last;
    }
    return node;
}

/// Branches below each kind of step, to know which spread can be estimated: all that hang beside another one.
std::array<std::uint32_t, kMemorySteps> branchesOf(std::span<const LotLeaves> lots) {
    std::array<std::uint32_t, kMemorySteps> count{};
    const auto sameTo = [](const LotLeaves& a, const LotLeaves& b, std::size_t level) {
        return std::equal(a.context->names.begin(), a.context->names.begin() + static_cast<std::ptrdiff_t>(level),
                          b.context->names.begin());
    };
    for (std::size_t level = 0; level < MemoryContext::kLevels; ++level) {
        for (std::size_t i = 0; i < lots.size(); ++i) {
            const bool newNode = i == 0 || !sameTo(lots[i - 1], lots[i], level + 1);
            count[level] += newNode ? 1U : 0U;
        }
    }
    count[at(MemoryStep::Lot)] = static_cast<std::uint32_t>(lots.size());
    for (const LotLeaves& lot : lots) {
        for (std::size_t i = 0; i < lot.leaves.size(); ++i) {
            const StretchKind kind = lot.leaves[i].kind;
            const bool tool = beginsTool(kind) || i == 0;
            count[at(MemoryStep::Insert)] += tool && kind != StretchKind::Reground ? 1U : 0U;
            count[at(MemoryStep::Regrind)] += tool && kind == StretchKind::Reground ? 1U : 0U;
            count[at(MemoryStep::Batch)] += kind == StretchKind::Material ? 1U : 0U;
        }
    }
    return count;
}

/// One-dimensional posterior mean of τ² on a grid; `set` puts τ into the spreads.
template <class Set, class LnEvidence>
double meanOverGrid(double lnWidth, const Set& set, const LnEvidence& lnEvidence) {
    constexpr int kPoints = 13;
    constexpr double kReach = 2.6;  // in widths of the prior
    std::array<double, kPoints> ln{};
    std::array<double, kPoints> factor{};
    for (int i = 0; i < kPoints; ++i) {
        const double z = kReach * (2.0 * i / (kPoints - 1.0) - 1.0);
        factor[static_cast<std::size_t>(i)] = std::exp(2.0 * z * lnWidth);
        set(factor[static_cast<std::size_t>(i)]);
        ln[static_cast<std::size_t>(i)] = lnEvidence() - 0.5 * z * z;
    }
    const double most = *std::ranges::max_element(ln);
    double sum = 0.0;
    double mean = 0.0;
    for (std::size_t i = 0; i < ln.size(); ++i) {
        const double weight = std::exp(ln[i] - most);
        sum += weight;
        mean += weight * factor[i];
    }
    return mean / sum;
}

}  // namespace

const char* memoryStepKey(MemoryStep step) noexcept {
    static constexpr std::array<const char*, kMemorySteps> kKeys{"machine", "part_type", "insert_grade", "material",
                                                                 "lot",     "insert",    "regrind",      "batch"};
    return kKeys[at(step)];
}

Memory::Memory(std::span<const PastLot> past, MemoryContext now, const KalmanParams& params,
               std::span<const Stretch> lotSoFar)
    : m_params(params), m_lotSoFar(lotSoFar.begin(), lotSoFar.end()) {
    // The working point: where the past was bored.
    double bores = 0.0;
    const auto addBores = [&](std::span<const Stretch> stretches) {
        for (const Stretch& stretch : stretches) {
            m_lnFeed += stretch.bores * stretch.lnFeed;
            m_lnOverhang += stretch.bores * stretch.lnOverhang;
            bores += stretch.bores;
        }
    };
    for (const PastLot& lot : past) {
        addBores(lot.stretches);
    }
    addBores(lotSoFar);
    if (bores > 0.0) {
        m_lnFeed /= bores;
        m_lnOverhang /= bores;
    } else {
        m_lnOverhang = 0.5 * (std::log(kTableOverhangFrom_mm) + std::log(kTableOverhangTo_mm));
        m_lnFeed = std::log(optimalFeed_mmPerRev(params.prior, kTableTargetDeflection_mm, std::exp(m_lnOverhang)));
    }
    Matrix3d uncentring = Matrix3d::Identity();
    uncentring(0, 1) = -m_lnFeed;
    uncentring(0, 2) = -m_lnOverhang;
    std::vector<LotLeaves> lots;
    const auto addLot = [&](std::int64_t id, const MemoryContext& context, std::span<const Stretch> stretches) {
        if (!stretches.empty()) {
            lots.push_back({id, &context, leavesOf(stretches, uncentring, vectorOf(params.prior))});
        }
    };
    for (const PastLot& lot : past) {
        addLot(lot.id, lot.context, lot.stretches);
    }
    addLot(kLotInWork, now, lotSoFar);
    std::ranges::stable_sort(
        lots, [](const LotLeaves& a, const LotLeaves& b) { return a.context->names < b.context->names; });

    Spreads spreads;
    const auto squares = [](const KalmanParams::Spread& s) {
        return Vector3d(s.level * s.level, s.alpha * s.alpha, s.beta * s.beta);
    };
    spreads.unexplained = squares(params.change);
    for (std::size_t i = 0; i < kMemorySteps; ++i) {
        const SpreadPrior& prior = priorOf(static_cast<MemoryStep>(i));
        // mean of a log-normal's square
        spreads.variance[i] = prior.centre.cwiseAbs2() * std::exp(2.0 * prior.lnWidth * prior.lnWidth);
    }
    // Between machines a context that all of them share is no difference: what they differ by is the machine's step.
    const auto same = [&](std::size_t level) {
        return std::ranges::all_of(lots,
                                   [&](const LotLeaves& lot) { return lot.context->names[level] == now.names[level]; });
    };
    for (std::size_t level = 1; level < MemoryContext::kLevels && !same(0); ++level) {
        if (same(level)) {
            spreads.variance[level].setZero();
        }
    }
    const Matrix3d shop = squares(params.priorSpread).asDiagonal();
    const auto lnEvidence = [&] { return contextMessage(lots, 0, spreads).through(shop).lnScale; };
    const auto branches = branchesOf(lots);
    const auto estimable = [&](std::size_t step) {
        if (step < MemoryContext::kLevels) {
            if (spreads.variance[step].isZero()) {
                return false;
            }
            const std::uint32_t above = step == 0 ? 1 : branches[step - 1];
            return branches[step] > above;
        }
        return branches[step] > (step == at(MemoryStep::Lot) || step == at(MemoryStep::Insert) ? 1U : 0U);
    };
    for (int pass = 0; pass < kPasses && !lots.empty(); ++pass) {
        for (std::size_t i = kMemorySteps; i-- > 0;) {
            if (!estimable(i)) {
                continue;
            }
            const SpreadPrior& prior = priorOf(static_cast<MemoryStep>(i));
            const Vector3d base = prior.centre.cwiseAbs2();
            Vector3d& variance = spreads.variance[i];
            if (i == at(MemoryStep::Insert)) {  // the one with the most branches: level, α and β each for itself
                for (int c = 0; c < 3; ++c) {
                    variance(c) =
                        base(c) * meanOverGrid(
                                      prior.lnWidth, [&](double f) { variance(c) = base(c) * f; }, lnEvidence);
                }
            } else {
                variance = base * meanOverGrid(
                                      prior.lnWidth, [&](double f) { variance = base * f; }, lnEvidence);
            }
        }
    }
    m_variance = spreads.variance;
    for (std::size_t i = 0; i < kMemorySteps; ++i) {
        MemorySpread spread;
        spread.step = static_cast<MemoryStep>(i);
        for (std::size_t c = 0; c < 3; ++c) {
            spread.tau[c] = std::sqrt(m_variance[i](static_cast<Eigen::Index>(c)));
        }
        spread.branches = branches[i];
        m_spreads.push_back(spread);
    }

    std::erase_if(lots, [](const LotLeaves& lot) { return lot.id == kLotInWork; });  // start() takes it as it is
    // Down the tree along `now`: at each node the parent's Gaussian and all branches but the one that is followed.
    // `share` of a lot: derivative of the expected level by that lot's own level.
    Vector3d mean = Vector3d::Zero();
    Matrix3d covariance = shop;
    std::vector<Matrix3d> influence;
    for (std::size_t i = 0; i < lots.size(); ++i) {
        influence.emplace_back(Matrix3d::Zero());
    }
    Matrix3d ofPrior = Matrix3d::Identity();
    std::size_t first = 0;
    std::size_t last = lots.size();
    for (std::size_t level = 0; level <= MemoryContext::kLevels; ++level) {
        // Branches of this node.
        Message others;
        std::vector<std::pair<std::size_t, Message>> perLot;  // which lots, through which message
        std::size_t followFirst = last;
        std::size_t followLast = last;
        const auto addLots = [&](std::size_t from, std::size_t to, const Message& message) {
            others += message;
            // within a branch lots count by their own information
            std::vector<double> own;
            for (std::size_t i = from; i < to; ++i) {
                own.push_back(
                    lotMessage(lots[i].leaves, spreads).through(spreads.of(MemoryStep::Lot)).information(0, 0));
            }
            const double sum = std::accumulate(own.begin(), own.end(), 0.0);
            for (std::size_t i = from; i < to; ++i) {
                Message part = message;
                part.information *= sum > 0.0 ? own[i - from] / sum : 0.0;
                perLot.emplace_back(i, part);
            }
        };
        if (level == MemoryContext::kLevels) {
            for (std::size_t i = first; i < last; ++i) {
                addLots(i, i + 1, lotMessage(lots[i].leaves, spreads).through(spreads.of(MemoryStep::Lot)));
            }
        } else {
            for (std::size_t i = first; i < last;) {
                std::size_t end = i + 1;
                while (end < last && lots[end].context->names[level] == lots[i].context->names[level]) {
                    ++end;
                }
                if (lots[i].context->names[level] == now.names[level]) {
                    followFirst = i;
                    followLast = end;
                } else {
                    addLots(i, end,
                            contextMessage(std::span(lots).subspan(i, end - i), level + 1, spreads)
                                .through(spreads.variance[level]));
                }
                i = end;
            }
        }
        const Matrix3d gain = (Matrix3d::Identity() + covariance * others.information).inverse();
        const Matrix3d posterior = gain * covariance;
        mean = gain * (mean + covariance * others.vector);
        covariance = 0.5 * (posterior + posterior.transpose());
        ofPrior = gain * ofPrior;
        for (Matrix3d& one : influence) {
            one = gain * one;
        }
        for (const auto& [lot, message] : perLot) {
            influence[lot] += posterior * message.information;
        }
        if (level < MemoryContext::kLevels) {
            covariance += spreads.variance[level].asDiagonal();
            first = followFirst;
            last = followLast;
        }
    }
    m_mean = mean;
    m_covariance = covariance;
    m_priorShare = ofPrior(0, 0);
    for (const PastLot& lot : past) {
        const auto found = std::ranges::find(lots, lot.id, &LotLeaves::id);
        if (found != lots.end()) {
            m_weights.push_back({lot.id, influence[static_cast<std::size_t>(found - lots.begin())](0, 0)});
        }
    }
    m_usable = (!lots.empty() || !lotSoFar.empty()) && start().spread[0] < params.priorSpread.level;
}

MemoryStart Memory::startOf(const Vector3d& mean, const Matrix3d& covariance) const {
    Matrix3d uncentring = Matrix3d::Identity();
    uncentring(0, 1) = -m_lnFeed;
    uncentring(0, 2) = -m_lnOverhang;
    MemoryStart start;
    const Vector3d theta = vectorOf(m_params.prior) + uncentring * mean;
    start.law = lawOf(theta);
    start.covariance = boring::covarianceOf(Matrix3d(uncentring * covariance * uncentring.transpose()));
    start.lnFeed = m_lnFeed;
    start.lnOverhang = m_lnOverhang;
    start.level = theta(0) + theta(1) * m_lnFeed + theta(2) * m_lnOverhang;
    for (std::size_t c = 0; c < 3; ++c) {
        start.spread[c] = std::sqrt(covariance(static_cast<Eigen::Index>(c), static_cast<Eigen::Index>(c)));
    }
    return start;
}

MemoryStart Memory::start(StretchKind kind) const {
    Spreads spreads;
    spreads.variance = m_variance;
    spreads.unexplained = Vector3d(m_params.change.level, m_params.change.alpha, m_params.change.beta).cwiseAbs2();
    Matrix3d uncentring = Matrix3d::Identity();
    uncentring(0, 1) = -m_lnFeed;
    uncentring(0, 2) = -m_lnOverhang;
    const std::vector<Leaf> leaves = leavesOf(m_lotSoFar, uncentring, vectorOf(m_params.prior));
    std::size_t tool = 0;
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        tool = beginsTool(leaves[i].kind) ? i : tool;
    }
    const auto meet = [](Vector3d& mean, Matrix3d& covariance, const Message& message) {
        const Matrix3d gain = (Matrix3d::Identity() + covariance * message.information).inverse();
        const Matrix3d posterior = gain * covariance;
        mean = gain * (mean + covariance * message.vector);
        covariance = 0.5 * (posterior + posterior.transpose());
    };
    Vector3d mean = m_mean;
    Matrix3d covariance = m_covariance + Matrix3d(spreads.of(MemoryStep::Lot).asDiagonal());
    const std::span<const Leaf> all(leaves);
    if (beginsTool(kind)) {
        meet(mean, covariance, lotMessage(all, spreads));
        covariance += spreads.toolStep(kind).asDiagonal();
        return startOf(mean, covariance);
    }
    // The same tool goes on: its stretches one after the other, then the step.
    meet(mean, covariance, lotMessage(all.first(tool), spreads));
    covariance += spreads.toolStep(leaves.empty() ? StretchKind::Insert : leaves[tool].kind).asDiagonal();
    for (std::size_t i = tool; i < leaves.size(); ++i) {
        if (i > tool) {
            covariance += spreads.within(leaves[i].kind).asDiagonal();
        }
        meet(mean, covariance, leaves[i].message);
    }
    covariance += spreads.within(kind).asDiagonal();
    return startOf(mean, covariance);
}

KalmanState stateFrom(const MemoryStart& start, const KalmanParams& params) noexcept {
    KalmanState state;
    state.ready = true;
    state.lnFeed = start.lnFeed;
    state.lnOverhang = start.lnOverhang;
    state.modes.fill({start.law, start.covariance});
    state.movingProbability = params.startMoving / (params.startMoving + params.stopMoving);
    return state;
}

}  // namespace kerf::boring
