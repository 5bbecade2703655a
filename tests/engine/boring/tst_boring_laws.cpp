// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/LU>
#include <QTest>
#include <cmath>
#include <limits>

#include "engine/process/boring/campaign.h"
#include "engine/process/boring/lot_tracker.h"
#include "tests/support/golden.h"

namespace {

using namespace kerf::boring;
using kerf::BoringSchedule;

/// A Kalman state that stands at `law`, with small spreads and working point (.114 mm/rev, 175 mm).
KalmanState stateAt(const LawConstants& law) {
    KalmanState state;
    state.ready = true;
    state.part = 1;
    state.lnFeed = std::log(0.114);
    state.lnOverhang = std::log(175.0);
    state.modes.fill({law, {1e-4, 0.0, 0.0, 1e-4, 0.0, 1e-4}});
    state.movingProbability = 0.1;
    return state;
}

PartVisit visitOf(std::uint32_t part, const BoringSchedule& schedule, const LawConstants& truth, double factor = 1.0) {
    PartVisit visit;
    visit.part = part;
    for (const double overhang_mm : {40.0, 310.0}) {
        const double d_mm = factor * deflection_mm(truth, schedule.feed_mmPerRev(overhang_mm), overhang_mm);
        visit.rows[visit.count++] = measurementAt(schedule, overhang_mm, d_mm);
    }
    return visit;
}

bool positiveDefinite(const Covariance& p) {
    const double second = p[0] * p[3] - p[1] * p[1];
    const double third = matrixOf(p).determinant();
    return p[0] > 0.0 && second > 0.0 && third > 0.0;
}

const LawConstants kTruth = TruthPlan::table().at(1);

}  // namespace

class TestBoringLaws : public QObject {
    Q_OBJECT
 private slots:
    void whatIsKnownTooBadlyIsAimedWithinTheLimits() {
        FeedLawParams params;
        params.targetDeflection_mm = 0.1165;
        QCOMPARE(aimedDeflection_mm(params, 0.3), 0.1165);  // nobody has said what is allowed
        params.allowedFrom_mm = 0.1165 - 0.0487;
        params.allowedTo_mm = 0.1165 + 0.0487;
        const double room = std::log(params.allowedTo_mm / 0.1165);
        const double middle_mm = std::sqrt(params.allowedFrom_mm * params.allowedTo_mm);
        QVERIFY(std::abs(aimedDeflection_mm(params, 0.99 * room / 3.0) - 0.1165) < 1e-12);
        // Three standard deviations just fit above the aim; never below the middle, from where both limits are equally
        // far.
        const double between_mm = aimedDeflection_mm(params, 1.1 * room / 3.0);
        QVERIFY(std::abs(std::log(params.allowedTo_mm / between_mm) - 1.1 * room) < 1e-12);
        QVERIFY(std::abs(aimedDeflection_mm(params, 2.0) - middle_mm) < 1e-12);
        params.targetDeflection_mm = 0.08;  // nearer to the other limit: the same upwards
        QVERIFY(std::abs(aimedDeflection_mm(params, 2.0) - middle_mm) < 1e-12);
        QVERIFY(aimedDeflection_mm(params, 0.08) > 0.08);
        QCOMPARE(aimedDeflection_mm(params, 0.0), std::exp(std::log(0.08)));
    }
    void firstPartIsCutAtTheConstantFeed() {
        const auto advice = adviseFeed(EstimatorState{KalmanState{}}, FeedLawParams{});
        QCOMPARE(advice.schedule.feed_mmPerRev(40.0), 0.5);
        QCOMPARE(advice.schedule.feed_mmPerRev(310.0), 0.5);
        QVERIFY(!advice.limited);
    }
    void knownLawGivesTheTablesFeed() {
        const auto advice = adviseFeed(EstimatorState{stateAt(kTruth)}, FeedLawParams{});
        KERF_CLOSE(advice.schedule.feed_mmPerRev(40.0), 0.2501508732131917, 1e-12);
        KERF_CLOSE(advice.schedule.feed_mmPerRev(175.0), 0.11398751624199456, 1e-12);
        QVERIFY(!advice.limited && advice.reason.empty());
    }
    void alphaNearZeroOrNegativeIsClippedAndKeepsWhatWasMeasuredAtBothEnds() {
        // ln d known at (.14 mm/rev, 40 mm) and (.01 mm/rev, 310 mm) to .001, α to .1, β then follows.
        const Eigen::RowVector3d top(1.0, std::log(0.14), std::log(40.0));
        const Eigen::RowVector3d deep(1.0, std::log(0.01), std::log(310.0));
        const Eigen::RowVector3d alphaAlone(0.0, 1.0, 0.0);
        const Eigen::Matrix3d information =
            1e6 * (top.transpose() * top + deep.transpose() * deep) + 100.0 * alphaAlone.transpose() * alphaAlone;
        for (const double alpha : {0.17, 0.05, 0.0, -0.4, 2.0}) {
            const double beta = (std::log(0.13 / 0.11) - alpha * (deep(1) - top(1))) / (deep(2) - top(2));
            const LawConstants law{std::log(0.11) - alpha * top(1) - beta * top(2), alpha, beta};
            const Estimate estimate{true, law, covarianceOf(information.inverse())};
            const LawConstants clipped = clippedLaw(estimate, FeedLawParams{});
            KERF_CLOSE(clipped.alpha, std::clamp(alpha, 0.25, 1.2), 1e-12);
            KERF_CLOSE(deflection_mm(clipped, 0.14, 40.0), 0.11, 1e-3);
            KERF_CLOSE(deflection_mm(clipped, 0.01, 310.0), 0.13, 1e-3);
            const FeedAdvice advice = adviseFeed(estimate, FeedLawParams{});
            QVERIFY(advice.limited && !advice.reason.empty());
            QCOMPARE(advice.schedule.alpha, clipped.alpha);
            QVERIFY(advice.schedule.feed_mmPerRev(40.0) > 0.14 && advice.schedule.feed_mmPerRev(310.0) < 0.01);
            const auto paper =
                clippedLaw(estimate, feedLawParams(EstimatorKind::Perturbation, kTableTargetDeflection_mm, 0.5));
            QVERIFY(paper.lnC == law.lnC && paper.beta == law.beta);
        }
    }
    void alphaBelowTheClipIsStillBoredToSizeAtBothEnds() {
        const EstimatorParams params = estimatorParams(EstimatorKind::Kalman, 0.005, kTableTargetDeflection_mm, 0.5);
        const FeedLawParams feed = feedLawParams(EstimatorKind::Kalman, kTableTargetDeflection_mm, 0.5);
        LawConstants flat{0.0, 0.15, 0.35};  // from part 11 on; d0 at .1 mm/rev and 120 mm
        flat.lnC = std::log(kTableTargetDeflection_mm) - flat.alpha * std::log(0.1) - flat.beta * std::log(120.0);
        EstimatorState state = initialState(params);
        for (std::uint32_t part = 1; part <= 30; ++part) {
            const BoringSchedule schedule = adviseFeed(state, feed).schedule;
            const LawConstants& truth = part <= 10 ? kTruth : flat;
            for (const double overhang_mm : {40.0, 310.0}) {
                const double error_mm =
                    deflection_mm(truth, schedule.feed_mmPerRev(overhang_mm), overhang_mm) - kTableTargetDeflection_mm;
                QVERIFY2(part <= 15 || std::abs(error_mm) < (part <= 20 ? 0.009 : 0.006),
                         qPrintable(QStringLiteral("part %1, %2 mm: %3").arg(part).arg(overhang_mm).arg(error_mm)));
            }
            state = step(state, params, visitOf(part, schedule, truth));
        }
    }
    void optimumOutsideTheFeedRangeSitsAtTheLimitAndSaysSo() {
        LawConstants stiff = kTruth;
        stiff.lnC -= 3.0;
        const auto high = adviseFeed(EstimatorState{stateAt(stiff)}, FeedLawParams{});
        QCOMPARE(high.schedule.feed_mmPerRev(40.0), 2.0);
        QVERIFY(high.limited && !high.reason.empty());
        LawConstants soft = kTruth;
        soft.lnC += 3.0;
        const auto low = adviseFeed(EstimatorState{stateAt(soft)}, FeedLawParams{});
        QCOMPARE(low.schedule.feed_mmPerRev(310.0), 0.005);
        QVERIFY(low.limited && !low.reason.empty());
    }
    void feedAtTheLimitDoesNotPerturbForEver() {
        for (const auto kind : {EstimatorKind::Perturbation, EstimatorKind::Kalman}) {
            const EstimatorParams params = estimatorParams(kind, 0.005, kTableTargetDeflection_mm, 0.5);
            FeedLawParams feed = feedLawParams(kind, kTableTargetDeflection_mm, 0.5);
            feed.maxFeed_mmPerRev = 0.04;  // d0 is out of reach everywhere
            feed.firstFeed_mmPerRev = 0.04;
            EstimatorState state = initialState(params);
            int perturbed = 0;
            for (std::uint32_t part = 1; part <= 60; ++part) {
                const PartVisit visit = visitOf(part, adviseFeed(state, feed).schedule, kTruth);
                std::array<RowOutcome, 2> rows{};
                state = step(state, params, visit, rows);
                perturbed += part > 2 && (rows[0].perturbed || rows[1].perturbed) ? 1 : 0;
            }
            QCOMPARE(perturbed, 0);
            QVERIFY(adviseFeed(state, feed).limited);
        }
    }
    void stepChangeIsNoticedWithItsPartAndAnswered() {
        const EstimatorParams params = estimatorParams(EstimatorKind::Kalman, 0.005, kTableTargetDeflection_mm, 0.5);
        const FeedLawParams feed = feedLawParams(EstimatorKind::Kalman, kTableTargetDeflection_mm, 0.5);
        const TruthPlan truth = TruthPlan::paper();
        EstimatorState state = initialState(params);
        for (std::uint32_t part = 1; part <= 15; ++part) {
            std::array<RowOutcome, 2> rows{};
            state = step(state, params, visitOf(part, adviseFeed(state, feed).schedule, truth.at(part)), rows);
            QCOMPARE(rows[1].perturbed, part == 11);
        }
        const double error = deflection_mm(truth.at(16), adviseFeed(state, feed).schedule.feed_mmPerRev(175.0), 175.0) -
                             kTableTargetDeflection_mm;
        QVERIFY(std::abs(error) < 0.005);
    }
    void partiallyMeasuredPartCountsWithWhatItHas() {
        const EstimatorParams params = estimatorParams(EstimatorKind::Kalman, 0.005, kTableTargetDeflection_mm, 0.5);
        EstimatorState state = stateAt(kTruth);
        const BoringSchedule schedule = adviseFeed(state, FeedLawParams{}).schedule;
        PartVisit visit = visitOf(2, schedule, kTruth, 1.6);
        visit.count = 1;
        std::array<RowOutcome, 1> one{};
        const EstimatorState after = step(state, params, visit, one);
        QVERIFY(one[0].perturbed);
        QVERIFY(estimateOf(after).law.lnC != estimateOf(state).law.lnC);
        visit.count = 0;
        QVERIFY(step(state, params, visit) == state);
    }
    void firstPartWithOneBoreBeginsOursButNotThePapers() {
        const auto schedule = adviseFeed(EstimatorState{KalmanState{}}, FeedLawParams{}).schedule;
        PartVisit visit = visitOf(1, schedule, kTruth);
        visit.count = 1;
        const auto kalman = estimatorParams(EstimatorKind::Kalman, 0.005, kTableTargetDeflection_mm, 0.5);
        const auto paper = estimatorParams(EstimatorKind::Perturbation, 0.005, kTableTargetDeflection_mm, 0.5);
        QVERIFY(estimateOf(step(initialState(kalman), kalman, visit)).ready);
        EstimatorState waiting = step(initialState(paper), paper, visit);
        QVERIFY(!estimateOf(waiting).ready);
        visit = visitOf(2, schedule, kTruth);
        visit.rows[0] = visit.rows[1];
        visit.count = 1;
        QVERIFY(estimateOf(step(waiting, paper, visit)).ready);
    }
    void covarianceStaysBoundedAndPositiveForFiveThousandParts_data() {
        QTest::addColumn<bool>("ours");
        QTest::addColumn<int>("everyNth");
        QTest::newRow("ours, steady") << true << 1;
        QTest::newRow("ours, every 50th part measured") << true << 50;
        QTest::newRow("paper, steady") << false << 1;
    }
    void covarianceStaysBoundedAndPositiveForFiveThousandParts() {
        QFETCH(bool, ours);
        QFETCH(int, everyNth);
        const auto kind = ours ? EstimatorKind::Kalman : EstimatorKind::Perturbation;
        const EstimatorParams params = estimatorParams(kind, 0.005, kTableTargetDeflection_mm, 0.5);
        const FeedLawParams feed = feedLawParams(kind, kTableTargetDeflection_mm, 0.5);
        EstimatorState state = initialState(params);
        kerf::Random random(5);
        for (std::uint32_t part = 1; part <= 5000; ++part) {
            if (part > 1 && part % static_cast<std::uint32_t>(everyNth) != 0) {
                continue;
            }
            PartVisit visit = visitOf(part, adviseFeed(state, feed).schedule, kTruth);
            for (std::size_t i = 0; i < visit.count; ++i) {
                visit.rows[i].deflection_mm += 0.005 * random.gauss();
            }
            state = step(state, params, visit);
            const Covariance p = estimateOf(state).covariance;
            QVERIFY2(positiveDefinite(p), qPrintable(QString::number(part)));
            QVERIFY(p[3] < 1.1 && p[5] < 1.1 && p[0] < 50.0);
        }
        const double error_mm = deflection_mm(kTruth, adviseFeed(state, feed).schedule.feed_mmPerRev(175.0), 175.0) -
                                kTableTargetDeflection_mm;
        QVERIFY(std::abs(error_mm) < 0.01);
    }
    void predictionCoversNinetyFivePercent() {
        const EstimatorParams params = estimatorParams(EstimatorKind::Kalman, 0.005, kTableTargetDeflection_mm, 0.5);
        const FeedLawParams feed = feedLawParams(EstimatorKind::Kalman, kTableTargetDeflection_mm, 0.5);
        kerf::Random random(11);
        int inside = 0;
        int all = 0;
        for (int lot = 0; lot < 60; ++lot) {
            EstimatorState state = initialState(params);
            for (std::uint32_t part = 1; part <= 30; ++part) {
                const auto schedule = adviseFeed(state, feed).schedule;
                PartVisit visit = visitOf(part, schedule, kTruth);
                for (std::size_t i = 0; i < visit.count; ++i) {
                    Measurement& m = visit.rows[i];
                    m.deflection_mm += 0.005 * random.gauss();
                    const auto expected = predict(state, params, m.feed_mmPerRev, m.overhang_mm);
                    QCOMPARE(expected.has_value(), part > 1);
                    if (part > 3) {
                        ++all;
                        inside += std::abs(m.deflection_mm - expected->deflection_mm) <= expected->half95_mm ? 1 : 0;
                    }
                }
                state = step(state, params, visit);
            }
        }
        const double share = static_cast<double>(inside) / all;
        QVERIFY2(share > 0.935 && share < 0.985, qPrintable(QString::number(share)));
    }
    void gateAsksAtADecadeAndRefusesTheImpossible() {
        const EstimatorParams params;
        const EstimatorState state = stateAt(kTruth);
        const auto schedule = adviseFeed(state, FeedLawParams{}).schedule;
        const auto verdict = [&](double d_mm, const EstimatorState& s) {
            return judgeEntry(s, params, measurementAt(schedule, 40.0, d_mm)).verdict;
        };
        for (const EstimatorState& s : {state, EstimatorState{KalmanState{}}, EstimatorState{PerturbationState{}}}) {
            QCOMPARE(verdict(0.1165, s), GateVerdict::Accept);
            QCOMPARE(verdict(1.165, s), GateVerdict::Ask);
            QCOMPARE(verdict(0.01165, s), GateVerdict::Ask);
            QCOMPARE(verdict(0.0, s), GateVerdict::Refuse);
            QCOMPARE(verdict(-0.1, s), GateVerdict::Refuse);
            QCOMPARE(verdict(std::numeric_limits<double>::quiet_NaN(), s), GateVerdict::Refuse);
            QCOMPARE(verdict(std::numeric_limits<double>::infinity(), s), GateVerdict::Refuse);
        }
        QCOMPARE(verdict(0.1165 * std::exp(1.19), state), GateVerdict::Accept);
        QCOMPARE(verdict(0.1165 * std::exp(1.21), state), GateVerdict::Ask);
        QVERIFY(!judgeEntry(state, params, measurementAt(schedule, 40.0, -1.0)).reason.english().empty());
    }
    void tinyAndHugeDeflectionsLeaveAFiniteEstimate() {
        const EstimatorParams params;
        for (const double factor : {1e-6, 1e-3, 1e3}) {
            const EstimatorState state = stateAt(kTruth);
            const auto visit = visitOf(2, adviseFeed(state, FeedLawParams{}).schedule, kTruth, factor);
            const Estimate after = estimateOf(step(state, params, visit));
            QVERIFY(std::isfinite(after.law.lnC) && std::isfinite(after.law.alpha) && std::isfinite(after.law.beta));
            QVERIFY(positiveDefinite(after.covariance));
        }
    }
};
QTEST_APPLESS_MAIN(TestBoringLaws)
#include "tst_boring_laws.moc"
