// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/boring/campaign.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace kerf::boring {
namespace {

constexpr std::uint64_t kNoiseStream = 1;
constexpr std::uint64_t kTypoStream = 2;
constexpr std::uint32_t kSteadyFrom = 4;
constexpr double kTwoSided95 = 1.959963984540054;

BoringSchedule scheduleFor(const CampaignParams& params, const EstimatorState& state, const TruthPlan& truth,
                           std::uint32_t part) {
    FeedAdvice advice = adviseFeed(state, params.feed);
    const auto useTruth = [&](const LawConstants& law) {
        advice.schedule.constantFeed_mmPerRev = 0.0;
        advice.schedule.lnC = law.lnC;
        advice.schedule.alpha = law.alpha;
        advice.schedule.beta = law.beta;
    };
    switch (params.policy) {
        case FeedPolicy::FixedFeed:
            advice.schedule.constantFeed_mmPerRev = params.feed.firstFeed_mmPerRev;
            break;
        case FeedPolicy::FrozenOptimum:
            useTruth(truth.at(1));
            break;
        case FeedPolicy::ToldTruth:
            useTruth(truth.at(part));
            break;
        case FeedPolicy::Estimator:
        case FeedPolicy::ToldChanges:
            break;
    }
    return advice.schedule;
}

ChangeKnowledge knowledgeOf(const CampaignParams& params, const TruthPlan& truth, std::uint32_t part) {
    if (params.policy != FeedPolicy::ToldChanges) {
        return ChangeKnowledge::Unknown;
    }
    const auto changes = truth.changeParts();
    return std::ranges::find(changes, part) != changes.end() ? ChangeKnowledge::Changed : ChangeKnowledge::Same;
}

/// What the operator enters: the measured value, now and then a decade off, and after the gate's question the right
/// one.
class Operator {
 public:
    Operator(const CampaignParams& params, Random random) : m_params(params), m_random(random) {}

    std::optional<Measurement> enter(const EstimatorState& state, Measurement measured, LotResult& lot) {
        ++lot.entries;
        Measurement entry = measured;
        if (m_params.typoRate > 0.0) {
            const bool slips = m_random.uniform() < m_params.typoRate;
            const bool up = m_random.uniform() < 0.5;
            entry.deflection_mm *= slips ? (up ? 10.0 : 0.1) : 1.0;
        }
        if (m_params.gated && judgeEntry(state, m_params.estimator, entry).verdict == GateVerdict::Ask) {
            ++lot.asked;
            lot.askedWrongly += entry == measured ? 1U : 0U;
            entry = measured;
        }
        if (judgeEntry(state, m_params.estimator, entry).verdict == GateVerdict::Refuse) {
            ++lot.refused;
            return std::nullopt;
        }
        return entry;
    }

 private:
    const CampaignParams& m_params;
    Random m_random;
};

}  // namespace

LotResult simulateLot(const CampaignParams& params, const TruthPlan& truth, std::uint64_t seed, std::uint32_t run,
                      const std::function<void(const CampaignRow&)>& sink) {
    assert(!params.measureAt_mm.empty() && params.measureAt_mm.size() <= kMaxBoreDepths);
    const double d0_mm = params.feed.targetDeflection_mm;
    const double sigma_mm = params.estimator.sigma_mm();
    const Random base = Random(seed).stream(run);
    Random noise = base.stream(kNoiseStream);
    Operator person(params, base.stream(kTypoStream));
    LotResult lot;
    EstimatorState state = initialState(params.estimator);
    for (std::uint32_t part = 1; part <= params.parts; ++part) {
        const LawConstants law = truth.at(part);
        const BoringSchedule schedule = scheduleFor(params, state, truth, part);
        bool scrap = false;
        double feedError = 0.0;
        double squares = 0.0;
        for (const double overhang_mm : params.evaluateAt_mm) {
            const double feed_mmPerRev = schedule.feed_mmPerRev(overhang_mm);
            const double error_mm = deflection_mm(law, feed_mmPerRev, overhang_mm) - d0_mm;
            const double best_mmPerRev = optimalFeed_mmPerRev(law, d0_mm, overhang_mm);
            scrap = scrap || std::abs(error_mm) > params.scrapBand_mm;
            feedError += std::abs(feed_mmPerRev - best_mmPerRev) / best_mmPerRev;
            squares += (error_mm / sigma_mm) * (error_mm / sigma_mm);
        }
        const auto evaluated = static_cast<double>(std::max<std::size_t>(1, params.evaluateAt_mm.size()));
        lot.scrap.push_back(scrap);
        lot.feedError_percent.push_back(100.0 * feedError / evaluated);
        lot.squaredError.push_back(squares / evaluated);

        PartVisit visit;
        visit.part = part;
        std::array<CampaignRow, kMaxBoreDepths> rows{};
        std::array<std::optional<std::size_t>, kMaxBoreDepths> used{};
        const std::size_t depths = params.measureAt_mm.size();
        for (std::size_t i = 0; i < depths; ++i) {
            const double overhang_mm = params.measureAt_mm[i];
            const double true_mm = deflection_mm(law, schedule.feed_mmPerRev(overhang_mm), overhang_mm);
            const double drawn = noise.gauss();  // always drawn: noise given from outside does not shift the others
            const double z = params.noise ? params.noise(run, part, i) : drawn;
            const Measurement measured = measurementAt(schedule, overhang_mm, measured_mm(true_mm, sigma_mm, z));
            const auto entry = person.enter(state, measured, lot);
            rows[i] = {run,
                       part,
                       overhang_mm,
                       entry.has_value(),
                       measured.feed_mmPerRev,
                       true_mm,
                       entry ? entry->deflection_mm : measured.deflection_mm,
                       {}};
            if (entry) {
                used[i] = visit.count;
                visit.rows[visit.count++] = *entry;
            }
        }
        std::array<RowOutcome, kMaxBoreDepths> outcomes{};
        const bool wantRows = static_cast<bool>(sink) || params.estimator.kind == EstimatorKind::Perturbation;
        const std::span<RowOutcome> all = std::span(outcomes).first(visit.count);
        const ChangeKnowledge knowledge = knowledgeOf(params, truth, part);
        if (wantRows) {
            state = step(state, params.estimator, visit, all, knowledge);
        } else if (visit.count > 0) {  // the last row is enough: the Kalman filter judges the whole part
            state = update(std::get<KalmanState>(state), params.estimator.kalman, visit, &all.back(), knowledge);
        }
        const bool kalman = params.estimator.kind == EstimatorKind::Kalman;
        const auto fired = [](const RowOutcome& row) { return row.perturbed; };
        lot.perturbed.push_back(!all.empty() && (kalman ? all.back().perturbed : std::ranges::any_of(all, fired)));
        if (sink) {
            const RowOutcome end{estimateOf(state), false, 0.0};
            for (std::size_t i = 0; i < depths; ++i) {
                rows[i].outcome = used[i] ? outcomes[*used[i]] : end;
                sink(rows[i]);
            }
            for (const double overhang_mm : params.evaluateAt_mm) {
                if (std::ranges::find(params.measureAt_mm, overhang_mm) == params.measureAt_mm.end()) {
                    const double feed_mmPerRev = schedule.feed_mmPerRev(overhang_mm);
                    sink({run, part, overhang_mm, false, feed_mmPerRev, deflection_mm(law, feed_mmPerRev, overhang_mm),
                          0.0, end});
                }
            }
        }
    }
    return lot;
}

void CampaignTally::add(const LotResult& lot, const TruthPlan& truth) {
    const auto parts = static_cast<std::uint32_t>(lot.scrap.size());
    const auto changes = truth.changeParts();
    const std::uint32_t steadyTo = std::min(parts, changes.empty() ? parts : changes.front() - 1);
    m_perturbed.resize(std::max(m_perturbed.size(), changes.size()));
    m_bad.resize(m_perturbed.size());
    m_feedError_percent.resize(std::max<std::size_t>(m_feedError_percent.size(), parts));
    double scrap = 0.0;
    double late = 0.0;
    bool falseAlarm = false;
    std::vector<bool> noticed(changes.size());
    for (std::uint32_t part = 1; part <= parts; ++part) {
        const std::size_t i = part - 1;
        const double bad = lot.scrap[i] ? 1.0 : 0.0;
        scrap += bad;
        late += part >= kSteadyFrom ? bad : 0.0;
        m_detections += lot.perturbed[i] ? 1.0 : 0.0;
        m_feedError_percent[i] += lot.feedError_percent[i];
        if (part >= kSteadyFrom && part <= steadyTo) {
            falseAlarm = falseAlarm || lot.perturbed[i];
            m_steadyParts += 1.0;
            m_steadyInBand += 1.0 - bad;
            m_steadySquares += lot.squaredError[i];
        }
        const auto after = static_cast<std::size_t>(std::ranges::upper_bound(changes, part) - changes.begin());
        if (after > 0) {
            m_bad[after - 1] += bad;
            noticed[after - 1] = noticed[after - 1] || lot.perturbed[i];
        }
    }
    for (std::size_t i = 0; i < noticed.size(); ++i) {
        m_perturbed[i] += noticed[i] ? 1.0 : 0.0;
    }
    ++m_lots;
    m_scrap += scrap;
    m_scrapSquared += scrap * scrap;
    m_late += late;
    m_lateSquared += late * late;
    m_falseAlarms += falseAlarm ? 1.0 : 0.0;
    m_asked += lot.asked;
    m_askedWrongly += lot.askedWrongly;
    m_refused += lot.refused;
}

CampaignSummary CampaignTally::summary() const {
    CampaignSummary out;
    const double n = std::max(1.0, static_cast<double>(m_lots));
    const auto mean = [&](double sum, double squares) {
        const double value = sum / n;
        const double variance = std::max(0.0, squares / n - value * value);
        return Mean{value, n > 1.0 ? kTwoSided95 * std::sqrt(variance / (n - 1.0)) : 0.0};
    };
    const auto perLot = [&](std::vector<double> sums) {
        for (double& sum : sums) {
            sum /= n;
        }
        return sums;
    };
    out.scrap = mean(m_scrap, m_scrapSquared);
    out.scrapFromPart4 = mean(m_late, m_lateSquared);
    out.falseAlarm = m_falseAlarms / n;
    out.detectionsPerLot = m_detections / n;
    out.inBandFromPart4 = m_steadyParts > 0.0 ? m_steadyInBand / m_steadyParts : 1.0;
    out.steadyRms = m_steadyParts > 0.0 ? std::sqrt(m_steadySquares / m_steadyParts) : 0.0;
    out.perturbedAfterChange = perLot(m_perturbed);
    out.badPartsAfterChange = perLot(m_bad);
    out.feedErrorMean_percent = perLot(m_feedError_percent);
    out.asked = m_asked / n;
    out.askedWrongly = m_askedWrongly / n;
    out.refused = m_refused / n;
    return out;
}

}  // namespace kerf::boring
