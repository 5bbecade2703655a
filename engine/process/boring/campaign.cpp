// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/boring/campaign.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace kerf::boring {
namespace {

constexpr std::uint64_t kNoiseStream = 1;
constexpr std::uint64_t kTypoStream = 2;
constexpr std::uint64_t kLotStream = 1000;  // the first lot keeps the run's own streams
constexpr std::uint64_t kShopStream = 5;
constexpr double kExpansion_perK = 20e-6;
constexpr double kThermometer_K = 0.5;
constexpr std::uint32_t kUnstableParts = 10;
constexpr std::uint32_t kSteadyFrom = 4;
constexpr double kLeastAllowed = 0.05;  // of d0, where the band reaches down to 0
constexpr double kTwoSided95 = 1.959963984540054;

BoringSchedule scheduleFor(const CampaignParams& params, const EstimatorState& state, const TruthPlan& truth,
                           std::uint32_t part, bool drewOnMemory) {
    FeedLawParams feed = params.feed;
    if (drewOnMemory) {
        feed.allowedFrom_mm =
            std::max(kLeastAllowed * feed.targetDeflection_mm, feed.targetDeflection_mm - params.scrapBand_mm);
        feed.allowedTo_mm = feed.targetDeflection_mm + params.scrapBand_mm;
    }
    FeedAdvice advice = adviseFeed(state, feed);
    const auto useTruth = [&](const LawConstants& law) {
        advice.schedule.constantFeed_mmPerRev = 0.0;
        advice.schedule.lnC = law.lnC;
        advice.schedule.alpha = law.alpha;
        advice.schedule.beta = law.beta;
        advice.schedule.targetDeflection_mm = params.feed.targetDeflection_mm;
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

/// What the lot begins from, and what an announced change brings back. Idle without memory.
class LotMemory {
 public:
    LotMemory(const CampaignParams& params, const LotPlace& place) : m_params(params), m_place(place) {}

    void begin(EstimatorState& state) {
        if (m_params.memory) {
            use(Memory(m_place.past, {}, m_params.estimator.kalman), StretchKind::Insert, state);
        }
    }
    void announce(std::uint32_t part, EstimatorState& state) {
        const auto change = std::ranges::find(m_place.announced, part, &AnnouncedChange::part);
        if (m_params.memory && part > 1 && change != m_place.announced.end()) {
            use(Memory(m_place.past, {}, m_params.estimator.kalman, stretches()), change->kind, state);
        }
    }
    void keep(const PartVisit& visit) {
        if (m_params.memory && visit.count > 0) {
            m_visits.push_back(visit);
        }
    }
    /// The lot has begun from it, or an announced change has.
    [[nodiscard]] bool drawnOn() const noexcept { return m_drawnOn; }
    [[nodiscard]] std::vector<Stretch> stretches() const {
        return stretchesOf(m_visits, m_place.announced, m_params.estimator.kalman);
    }

 private:
    void use(const Memory& memory, StretchKind kind, EstimatorState& state) {
        if (memory.usable()) {
            m_drawnOn = true;
            state = stateFrom(memory.start(kind), m_params.estimator.kalman);
        }
    }
    const CampaignParams& m_params;
    const LotPlace& m_place;
    std::vector<PartVisit> m_visits{};
    bool m_drawnOn{false};
};

/// What the shop floor adds to the law, part by part. The reference machine adds nothing, to the last digit.
class ShopFloor {
 public:
    ShopFloor(const CampaignParams& params, Random random) : m_params(params), m_random(random) {
        m_hardness = params.hard.hardnessSpread * m_random.gauss();
    }
    void nextPart() {
        const HardMachine& hard = m_params.hard;
        if (hard.seed == 0) {
            return;
        }
        m_hardness = hard.hardnessMemory * m_hardness + std::sqrt(1.0 - hard.hardnessMemory * hard.hardnessMemory) *
                                                            hard.hardnessSpread * m_random.gauss();
        const double warm_K = hard.warm_K + hard.warmSpread_K * m_random.gauss();
        const double left_K = m_params.temperatureEntered ? kThermometer_K * m_random.gauss() : warm_K;
        const double larger_mm = kExpansion_perK * m_params.boreDiameter_mm * left_K;
        m_gauge_mm = larger_mm / (2.0 * std::cos(m_params.phi_deg * std::numbers::pi / 180.0));
    }
    [[nodiscard]] double true_mm(const LawConstants& law, double feed_mmPerRev, double overhang_mm) const {
        const double d_mm = deflection_mm(law, feed_mmPerRev, overhang_mm);
        const FeedLawParams& feed = m_params.feed;
        const double along = (overhang_mm - feed.overhangFrom_mm) / (feed.overhangTo_mm - feed.overhangFrom_mm);
        return m_params.hard.seed == 0 ? d_mm : d_mm * std::exp(m_hardness + m_params.hard.wearAlongBore * along);
    }
    /// A warm bore is larger, so its deflection seems smaller by this.
    [[nodiscard]] double gauge_mm() const { return m_gauge_mm; }

 private:
    const CampaignParams& m_params;
    Random m_random;
    double m_hardness{0.0};
    double m_gauge_mm{0.0};
};

}  // namespace

std::vector<double> teachDepths_mm(const CampaignParams& params) {
    std::vector<double> depths_mm = params.measureAt_mm;
    const double middle_mm = teachMiddle_mm(params.feed);
    if (depths_mm.size() < kTeachDepths && std::ranges::find(depths_mm, middle_mm) == depths_mm.end()) {
        depths_mm.push_back(middle_mm);
    }
    return depths_mm;
}

LotResult simulateLot(const CampaignParams& params, const TruthPlan& truth, std::uint64_t seed, std::uint32_t run,
                      const std::function<void(const CampaignRow&)>& sink, const LotPlace& place) {
    assert(!params.measureAt_mm.empty() && params.measureAt_mm.size() <= kMaxBoreDepths);
    const double d0_mm = params.feed.targetDeflection_mm;
    const double sigma_mm = params.estimator.sigma_mm();
    const Random ofRun = Random(seed).stream(run);
    const Random base = place.lot == 1 ? ofRun : ofRun.stream(kLotStream + place.lot);
    Random noise = base.stream(kNoiseStream);
    Operator person(params, base.stream(kTypoStream));
    LotResult lot;
    EstimatorState state = initialState(params.estimator);
    LotMemory memory(params, place);
    memory.begin(state);
    ShopFloor shop(params, base.stream(kShopStream));
    std::optional<SigmaBank> bank;
    if (params.learnSigma && params.estimator.kind == EstimatorKind::Kalman) {
        bank = SigmaBank::from(std::get<KalmanState>(state));
    }
    std::uint32_t badInARow = 0;
    for (std::uint32_t part = 1; part <= params.parts; ++part) {
        const LawConstants law = truth.at(part);
        memory.announce(part, state);
        shop.nextPart();
        const bool teaching = params.teach && part == 1 && !estimateOf(state).ready;
        const BoringSchedule schedule =
            teaching ? teachSchedule(params.feed) : scheduleFor(params, state, truth, part, memory.drawnOn());
        const std::vector<double> measureAt_mm = teaching ? teachDepths_mm(params) : params.measureAt_mm;
        bool scrap = false;
        double feedError = 0.0;
        double squares = 0.0;
        for (const double overhang_mm : params.evaluateAt_mm) {
            const double feed_mmPerRev = schedule.feed_mmPerRev(overhang_mm);
            const double error_mm = shop.true_mm(law, feed_mmPerRev, overhang_mm) - d0_mm;
            const double best_mmPerRev = optimalFeed_mmPerRev(law, d0_mm, overhang_mm);
            scrap = scrap || std::abs(error_mm) > params.scrapBand_mm;
            feedError += std::abs(feed_mmPerRev - best_mmPerRev) / best_mmPerRev;
            squares += (error_mm / sigma_mm) * (error_mm / sigma_mm);
        }
        const auto evaluated = static_cast<double>(std::max<std::size_t>(1, params.evaluateAt_mm.size()));
        lot.scrap.push_back(scrap);
        const auto within = [&](double overhang_mm) {
            const double best_mmPerRev = optimalFeed_mmPerRev(law, d0_mm, overhang_mm);
            return best_mmPerRev > params.feed.minFeed_mmPerRev && best_mmPerRev < params.feed.maxFeed_mmPerRev;
        };
        const bool could = within(params.feed.overhangFrom_mm) && within(params.feed.overhangTo_mm);
        badInARow = scrap && could ? badInARow + 1 : 0;
        lot.feedError_percent.push_back(100.0 * feedError / evaluated);
        lot.squaredError.push_back(squares / evaluated);

        PartVisit visit;
        visit.part = part;
        std::array<CampaignRow, kMaxBoreDepths> rows{};
        std::array<std::optional<std::size_t>, kMaxBoreDepths> used{};
        const std::size_t depths = measureAt_mm.size();
        for (std::size_t i = 0; i < depths; ++i) {
            const double overhang_mm = measureAt_mm[i];
            const double true_mm = shop.true_mm(law, schedule.feed_mmPerRev(overhang_mm), overhang_mm);
            const double drawn = noise.gauss();  // always drawn: noise given from outside does not shift the others
            const double z = params.noise ? params.noise(run, place.lot, part, i) : drawn;
            const Measurement measured = measurementAt(
                schedule, overhang_mm, measured_mm(true_mm, sigma_mm * params.hard.sigmaFactor, z) - shop.gauge_mm());
            const auto entry = person.enter(state, measured, lot);
            rows[i] = {run,
                       place.lot,
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
        if (bank && visit.count > 0) {
            bank = update(*bank, params.estimator.kalman, visit, &all.back());
            state = bank->state();
        } else if (wantRows) {
            state = step(state, params.estimator, visit, all, knowledge);
        } else if (visit.count > 0) {  // the last row is enough: the Kalman filter judges the whole part
            state = update(std::get<KalmanState>(state), params.estimator.kalman, visit, &all.back(), knowledge);
        }
        memory.keep(visit);
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
                if (std::ranges::find(measureAt_mm, overhang_mm) == measureAt_mm.end()) {
                    const double feed_mmPerRev = schedule.feed_mmPerRev(overhang_mm);
                    sink({run, place.lot, part, overhang_mm, false, feed_mmPerRev,
                          shop.true_mm(law, feed_mmPerRev, overhang_mm), 0.0, end});
                }
            }
        }
    }
    lot.unstable = badInARow >= kUnstableParts;
    lot.sigmaFactor = bank ? bank->factor() : 1.0;
    lot.stretches = memory.stretches();
    return lot;
}

void CampaignTally::add(const LotResult& lot, const TruthPlan& truth, std::uint32_t place) {
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
    m_scrapOfLot.resize(std::max<std::size_t>(m_scrapOfLot.size(), place));
    m_runsOfLot.resize(m_scrapOfLot.size());
    m_scrapOfLot[place - 1] += scrap;
    ++m_runsOfLot[place - 1];
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
    for (std::size_t i = 0; i < m_scrapOfLot.size(); ++i) {
        out.scrapPerLot.push_back(m_scrapOfLot[i] / std::max(1U, m_runsOfLot[i]));
    }
    return out;
}

}  // namespace kerf::boring
