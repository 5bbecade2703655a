// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "engine/process/boring/campaign.h"

namespace {

using namespace kerf::boring;

constexpr double kWide_mm = kTableSigma_mm;  // σ of the paper's data
constexpr double kNarrow_mm = 0.005;

enum class World { Paper, NoChange, Random, Drift };

struct Case {
    EstimatorKind kind{EstimatorKind::Kalman};
    double sigma_mm{kWide_mm};
    World world{World::Paper};
    std::uint32_t runs{600};
    double typoRate{0.0};
    bool gated{true};
    std::vector<double> measureAt_mm{40.0, 310.0};
};

CampaignSummary campaign(const Case& c) {
    constexpr std::uint64_t kSeed = 20261122;
    CampaignParams params;
    params.estimator =
        estimatorParams(c.kind, c.sigma_mm, kTableTargetDeflection_mm, c.sigma_mm == kWide_mm ? 0.5 : 1.0);
    params.feed = feedLawParams(c.kind, kTableTargetDeflection_mm, 0.5);
    params.scrapBand_mm = 3.0 * c.sigma_mm;
    params.typoRate = c.typoRate;
    params.gated = c.gated;
    params.measureAt_mm = c.measureAt_mm;
    CampaignTally tally;
    for (std::uint32_t run = 1; run <= c.runs; ++run) {
        TruthPlan truth = c.world == World::Paper ? TruthPlan::paper() : TruthPlan::table();
        if (c.world == World::Random) {
            kerf::Random random = kerf::Random(kSeed).stream(run).stream(3);
            truth = randomChanges(random, kTableTargetDeflection_mm);
        } else if (c.world == World::Drift) {
            truth.drift_percentPerPart = 1.5;
        }
        tally.add(simulateLot(params, truth, kSeed, run), truth);
    }
    return tally.summary();
}

#define KERF_BETWEEN(value, low, high)                                                                              \
    do {                                                                                                            \
        const double kerfValue = (value);                                                                           \
        QVERIFY2(kerfValue >= (low) && kerfValue <= (high),                                                         \
                 qPrintable(QStringLiteral(#value " is %1, expected %2 to %3").arg(kerfValue).arg(low).arg(high))); \
    } while (false)

}  // namespace

class TestBoringCampaign : public QObject {
    Q_OBJECT
 private slots:
    void paperAtItsOwnNoise() {
        const auto s = campaign({EstimatorKind::Perturbation, kWide_mm, World::Paper, 1500});
        KERF_BETWEEN(s.scrap.value, 2.95, 3.19);
        KERF_BETWEEN(s.perturbedAfterChange[0], 0.98, 1.0);
        KERF_BETWEEN(s.perturbedAfterChange[1], 0.0, 0.03);
        KERF_BETWEEN(s.badPartsAfterChange[0], 1.9, 2.2);
        const auto none = campaign({EstimatorKind::Perturbation, kWide_mm, World::NoChange, 1500});
        KERF_BETWEEN(none.falseAlarm, 0.0, 0.01);
        KERF_BETWEEN(none.inBandFromPart4, 0.98, 1.0);
    }
    void paperAtLowNoise() {
        const auto s = campaign({EstimatorKind::Perturbation, kNarrow_mm, World::Paper, 1500});
        KERF_BETWEEN(s.scrap.value, 8.19, 8.69);
        KERF_BETWEEN(s.perturbedAfterChange[0], 0.98, 1.0);
        KERF_BETWEEN(s.perturbedAfterChange[1], 0.95, 1.0);
        KERF_BETWEEN(s.badPartsAfterChange[1], 3.8, 4.3);
        const auto none = campaign({EstimatorKind::Perturbation, kNarrow_mm, World::NoChange, 1500});
        KERF_BETWEEN(none.falseAlarm, 0.0, 0.01);
        KERF_BETWEEN(none.inBandFromPart4, 0.98, 1.0);
    }
    void oursOnThePapersChanges() {
        KERF_BETWEEN(campaign({EstimatorKind::Kalman, kWide_mm, World::Paper}).scrap.value, 2.0, 2.2);
        KERF_BETWEEN(campaign({EstimatorKind::Kalman, kNarrow_mm, World::Paper}).scrap.value, 3.5, 4.2);
    }
    void oursOnRandomChanges() {
        KERF_BETWEEN(campaign({EstimatorKind::Kalman, kWide_mm, World::Random}).scrap.value, 2.0, 3.0);
        KERF_BETWEEN(campaign({EstimatorKind::Kalman, kNarrow_mm, World::Random}).scrap.value, 3.0, 6.0);
    }
    void oursFollowsADrift() {
        KERF_BETWEEN(campaign({EstimatorKind::Kalman, kWide_mm, World::Drift}).scrap.value, 1.0, 1.1);
        KERF_BETWEEN(campaign({EstimatorKind::Kalman, kNarrow_mm, World::Drift}).scrap.value, 1.0, 1.1);
    }
    void oursStaysQuietWhenNothingChanges() {
        const auto wide = campaign({EstimatorKind::Kalman, kWide_mm, World::NoChange, 1000});
        KERF_BETWEEN(wide.scrap.value, 1.0, 1.1);
        KERF_BETWEEN(wide.detectionsPerLot, 0.0, 0.03);
        const auto narrow = campaign({EstimatorKind::Kalman, kNarrow_mm, World::NoChange, 1000});
        KERF_BETWEEN(narrow.scrap.value, 1.0, 1.1);
        KERF_BETWEEN(narrow.detectionsPerLot, 0.0, 0.01);
        KERF_BETWEEN(narrow.steadyRms, 0.2, 0.40);
    }
    void aGatedTypoCostsNothingAndAnUngatedOneDoes() {
        const double clean = campaign({EstimatorKind::Kalman, kNarrow_mm, World::NoChange, 400}).scrap.value;
        const auto gated = campaign({EstimatorKind::Kalman, kNarrow_mm, World::NoChange, 400, 1.0 / 60.0});
        const auto open = campaign({EstimatorKind::Kalman, kNarrow_mm, World::NoChange, 400, 1.0 / 60.0, false});
        KERF_BETWEEN(gated.scrap.value - clean, -0.05, 0.05);
        KERF_BETWEEN(gated.asked, 0.7, 1.3);
        KERF_BETWEEN(open.scrap.value - clean, 1.0, 10.0);
    }
    void theGateSeldomAsksAboutARealChange() {
        const auto s = campaign({EstimatorKind::Kalman, kWide_mm, World::Paper});
        KERF_BETWEEN(s.askedWrongly, 0.0, 0.02);  // two changes per lot, at most 1 % each
    }
    void aThirdDepthDoesNotHurt() {
        const double two = campaign({EstimatorKind::Kalman, kNarrow_mm, World::Random, 400}).scrap.value;
        Case three{EstimatorKind::Kalman, kNarrow_mm, World::Random, 400};
        three.measureAt_mm = {40.0, 175.0, 310.0};
        KERF_BETWEEN(campaign(three).scrap.value, 1.0, two + 0.1);
    }
    void sameSeedSameLotAnotherRunAnother() {
        CampaignParams params;
        const auto lot = [&](std::uint32_t run) {
            return simulateLot(params, TruthPlan::paper(), 7, run).squaredError;
        };
        QVERIFY(lot(3) == lot(3));
        QVERIFY(lot(3) != lot(4));
    }
    void fixedFeedScrapsAllAndTheTruthNone() {
        CampaignParams params;
        params.policy = FeedPolicy::FixedFeed;
        const auto count = [&] {
            const auto lot = simulateLot(params, TruthPlan::paper(), 1, 1);
            return std::count(lot.scrap.begin(), lot.scrap.end(), true);
        };
        QCOMPARE(count(), 30);
        params.policy = FeedPolicy::FrozenOptimum;
        QCOMPARE(count(), 20);
        params.policy = FeedPolicy::ToldTruth;
        QCOMPARE(count(), 0);
    }
};
QTEST_APPLESS_MAIN(TestBoringCampaign)
#include "tst_boring_campaign.moc"
