// SPDX-License-Identifier: GPL-3.0-or-later
#include <rapidcheck.h>

#include <QTest>
#include <cmath>
#include <numeric>

#include "engine/process/boring/campaign.h"
#include "engine/process/boring/lot_tracker.h"
#include "engine/process/boring/memory.h"

namespace {

using namespace kerf::boring;
using kerf::Random;

const double kLnFeed = std::log(0.17);
const double kLnOverhang = 0.5 * (std::log(kTableOverhangFrom_mm) + std::log(kTableOverhangTo_mm));
constexpr std::uint32_t kParts = 30;

/// Level, α and β of a tool; level is ln d at .17 mm/rev and √(40·310) mm.
struct Tool {
    double level, alpha, beta;
    [[nodiscard]] LawConstants law() const { return {level - alpha * kLnFeed - beta * kLnOverhang, alpha, beta}; }
};
bool feasible(const Tool& tool) {
    const auto good = [&](double overhang_mm) {
        const double feed_mmPerRev = optimalFeed_mmPerRev(tool.law(), kTableTargetDeflection_mm, overhang_mm);
        return feed_mmPerRev > 0.005 && feed_mmPerRev < 2.0;
    };
    return tool.alpha > 0.1 && good(kTableOverhangFrom_mm) && good(kTableOverhangTo_mm);
}
template <class Make>
Tool draw(Make make) {
    for (;;) {
        if (const Tool tool = make(); feasible(tool)) {
            return tool;
        }
    }
}
Tool machineOf(Random& random) {
    return draw([&] {
        const double level = std::log(kTableTargetDeflection_mm) + 0.3 * random.gauss();
        const double alpha = random.uniform(0.4, 0.8);
        return Tool{level, alpha, random.uniform(0.1, 0.6)};
    });
}
Tool toolOf(Random& random, const Tool& means, const Tool& spread) {
    return draw([&] {
        const double level = means.level + spread.level * random.gauss();
        const double alpha = means.alpha + spread.alpha * random.gauss();
        return Tool{level, alpha, means.beta + spread.beta * random.gauss()};
    });
}

struct Life {
    double sigma_mm{kTableSigma_mm};
    Tool spread{0.1, 0.06, 0.05};
    bool memory{true};
    bool unrelated{false};  ///< the machine's means are drawn anew for every lot
    std::uint32_t machines{12}, lots{8};
};
/// Scrap per lot, lot by lot, mean over machines.
std::vector<double> scrapOf(const Life& life) {
    CampaignParams params;
    params.estimator = estimatorParams(EstimatorKind::Kalman, life.sigma_mm, kTableTargetDeflection_mm, 0.5);
    params.feed = feedLawParams(EstimatorKind::Kalman, kTableTargetDeflection_mm, 0.5);
    params.scrapBand_mm = 3.0 * life.sigma_mm;
    params.memory = life.memory;
    const std::vector<AnnouncedChange> announced{{11, StretchKind::Insert}, {21, StretchKind::Insert}};
    std::vector<double> scrap(life.lots);
    for (std::uint32_t run = 1; run <= life.machines; ++run) {
        Random random = Random(20261127).stream(run).stream(9);
        Tool means = machineOf(random);
        std::vector<PastLot> past;
        for (std::uint32_t lot = 1; lot <= life.lots; ++lot) {
            means = life.unrelated ? machineOf(random) : means;
            TruthPlan truth;
            truth.changes.clear();
            for (const std::uint32_t part : {1U, 11U, 21U}) {
                truth.changes.push_back({part, toolOf(random, means, life.spread).law()});
            }
            LotResult result = simulateLot(params, truth, 1, run, {}, {lot, past, announced});
            scrap[lot - 1] += std::accumulate(result.scrap.begin(), result.scrap.end(), 0.0) / life.machines;
            past.push_back({lot, {}, std::move(result.stretches)});
        }
    }
    return scrap;
}
double meanFrom(const std::vector<double>& scrap, std::size_t first) {
    return std::accumulate(scrap.begin() + static_cast<std::ptrdiff_t>(first), scrap.end(), 0.0) /
           static_cast<double>(scrap.size() - first);
}

EstimatorParams kalman(double sigma_mm = 0.005) {
    return estimatorParams(EstimatorKind::Kalman, sigma_mm, kTableTargetDeflection_mm, 0.5);
}

/// A lot in which `tools` bored five parts each, measured at 40 and 310 mm.
LotTracker boredLot(LotBegin begin, std::vector<Tool> tools, Random& random, std::int64_t firstId) {
    LotTracker lot(kalman(), std::move(begin));
    std::uint32_t number = 0;
    std::vector<AnnouncedChange> announced;
    for (const Tool& tool : tools) {
        if (number > 0) {
            announced.push_back({number + 1, StretchKind::Insert});
            lot.setAnnounced(announced);
        }
        for (int i = 0; i < 5; ++i) {
            CutPart part;
            part.number = ++number;
            part.schedule =
                adviseFeed(lot.state(), feedLawParams(EstimatorKind::Kalman, kTableTargetDeflection_mm, 0.5)).schedule;
            (void)lot.addPart(part);
            for (const double overhang_mm : {40.0, 310.0}) {
                const double true_mm = deflection_mm(tool.law(), part.schedule.feed_mmPerRev(overhang_mm), overhang_mm);
                (void)lot.add(firstId++, number, overhang_mm, std::max(0.001, true_mm + 0.005 * random.gauss()));
            }
        }
    }
    return lot;
}

}  // namespace

class TestBoringMemory : public QObject {
    Q_OBJECT
 private slots:
    void withoutPastThereIsNothingToRestOn() {
        const Memory memory({}, {}, kalman().kalman);
        QVERIFY(!memory.usable());
        QCOMPARE(memory.priorShare(), 1.0);
        QVERIFY(memory.weights().empty());
    }
    void offIsTheSameEstimatorWhateverIsAnnounced() {
        Random random(3);
        const Tool means = machineOf(random);
        const Tool spread{0.1, 0.06, 0.05};
        Random once(7);
        Random again(7);
        const std::vector<Tool> tools{toolOf(random, means, spread), toolOf(random, means, spread)};
        const LotTracker past = boredLot({}, tools, random, 1);
        auto lots = std::make_shared<std::vector<PastLot>>();
        lots->push_back({1, {}, past.stretches()});
        const LotTracker plain = boredLot({}, tools, once, 1);
        const LotTracker off = boredLot({false, {}, lots}, tools, again, 1);
        QVERIFY(plain.state() == off.state());
        QVERIFY(!off.fromMemory());
    }
    void sharesAddUpAndFewLotsAreWide() {
        Random random(5);
        const Tool means = machineOf(random);
        std::vector<PastLot> past;
        double before = 10.0;
        for (int lot = 1; lot <= 9; ++lot) {
            std::vector<Tool> tools;
            for (int i = 0; i < 3; ++i) {
                tools.push_back(toolOf(random, means, {0.05, 0.04, 0.03}));
            }
            past.push_back({lot, {}, boredLot({}, tools, random, 1).stretches()});
            QCOMPARE(past.back().stretches.size(), std::size_t{3});
            if (lot % 3 == 0) {
                const Memory memory(past, {}, kalman().kalman);
                QVERIFY(memory.usable());
                double sum = memory.priorShare();
                for (const MemoryWeight& weight : memory.weights()) {
                    sum += weight.share;
                }
                QVERIFY(std::abs(sum - 1.0) < 1e-9);
                QVERIFY(memory.start().spread[0] < before);  // 3, 6, 9 lots
                before = memory.start().spread[0];
                QVERIFY(before > 0.05);  // never surer than the tools differ
            }
        }
        QVERIFY(before < 0.1);
    }
    void anotherPartTypeCountsLessThanTheSame() {
        Random random(11);
        const Tool means = machineOf(random);
        const Tool other{means.level + 0.4, means.alpha, means.beta};
        std::vector<PastLot> past;
        const MemoryContext a{{"VB-1", "sleeve", "K10", "cast iron"}};
        const MemoryContext b{{"VB-1", "flange", "K10", "cast iron"}};
        for (int lot = 1; lot <= 4; ++lot) {
            const Tool& of = lot % 2 == 0 ? means : other;
            past.push_back({lot, lot % 2 == 0 ? a : b,
                            boredLot({}, {toolOf(random, of, {0.03, 0.02, 0.02})}, random, 1).stretches()});
        }
        const Memory ofA(past, a, kalman().kalman);
        const Memory ofB(past, b, kalman().kalman);
        QVERIFY(ofB.start().level - ofA.start().level > 0.2);
        const auto share = [&](const Memory& memory, std::int64_t lot) {
            return std::ranges::find(memory.weights(), lot, &MemoryWeight::lot)->share;
        };
        QVERIFY(share(ofA, 2) > share(ofA, 1));
        QVERIFY(share(ofB, 1) > share(ofB, 2));
        QVERIFY(share(ofA, 1) > 0.0);
    }
    void aCorrectionInLotThreeIsWhatAReplayOfAllLotsWouldGive() {
        const bool held = rc::check("any corrections in any past lot == fresh replay", [] {
            Random random(*rc::gen::inRange<std::uint64_t>(1, 1'000'000));
            const Tool means = machineOf(random);
            std::vector<LotTracker> lots;
            const auto pastOf = [](const std::vector<LotTracker>& all) {
                auto past = std::make_shared<std::vector<PastLot>>();
                for (const LotTracker& lot : all) {
                    past->push_back({static_cast<std::int64_t>(past->size()) + 1, {}, lot.stretches()});
                }
                return past;
            };
            for (int lot = 1; lot <= 8; ++lot) {
                const Tool spread{0.1, 0.06, 0.05};
                const std::vector<Tool> tools{toolOf(random, means, spread), toolOf(random, means, spread)};
                lots.push_back(boredLot({true, {}, pastOf(lots)}, tools, random, 1));
            }
            // Corrections and voids in lot 3, once its successors are long bored.
            std::int64_t next = 1000;
            const auto changes = *rc::gen::inRange(1, 6);
            for (int i = 0; i < changes; ++i) {
                const auto victim = *rc::gen::inRange<std::size_t>(0, lots[2].entries().size());
                const auto id = lots[2].entries()[victim].id;
                const double d_mm = 0.05 + 0.001 * *rc::gen::inRange(1, 200);
                RC_ASSERT((i % 3 < 2 ? lots[2].correct(id, next++, d_mm) : lots[2].voidEntry(id)).has_value());
            }
            const LotTracker nine(kalman(), {true, {}, pastOf(lots)});
            // All lots again, each from its surviving rows and from the replayed lots before it.
            std::vector<LotTracker> fresh;
            for (const LotTracker& lot : lots) {
                LotTracker again(kalman(), {true, {}, pastOf(fresh)});
                again.setAnnounced(lot.announced());
                again.restore(lot.parts(), lot.entries());
                fresh.push_back(std::move(again));
            }
            const LotTracker replayed(kalman(), {true, {}, pastOf(fresh)});
            RC_ASSERT(nine.fromMemory());
            RC_ASSERT(nine.state() == replayed.state());
        });
        QVERIFY(held);
    }
    void announcingAndCorrectingInAnyOrderIsAReplay() {
        Random random(21);
        const Tool means = machineOf(random);
        const Tool spread{0.1, 0.06, 0.05};
        auto past = std::make_shared<std::vector<PastLot>>();
        past->push_back({1, {}, boredLot({}, {toolOf(random, means, spread)}, random, 1).stretches()});
        LotTracker lot =
            boredLot({true, {}, past}, {toolOf(random, means, spread), toolOf(random, means, spread)}, random, 1);
        QVERIFY(lot.correct(3, 100, 0.13).has_value());  // before the change
        QVERIFY(lot.voidEntry(14).has_value());          // after it
        LotTracker fresh(kalman(), {true, {}, past});
        fresh.setAnnounced(lot.announced());
        fresh.restore(lot.parts(), lot.entries());
        QVERIFY(fresh.state() == lot.state());
        // An announced change that no part shows yet: the next part begins anew, the measured state stays.
        const EstimatorState measured = lot.measuredState();
        auto announced = lot.announced();
        announced.push_back({11, StretchKind::Insert});
        lot.setAnnounced(announced);
        QVERIFY(lot.measuredState() == measured);
        QVERIFY(!(lot.state() == measured));
        QVERIFY(lot.stateBefore(11) == measured);
        QVERIFY(lot.stateBefore(12) == lot.state());
        const auto wide = predict(lot.state(), lot.params(), 0.17, 111.0);
        const auto narrow = predict(measured, lot.params(), 0.17, 111.0);
        QVERIFY(wide->half95_mm / wide->deflection_mm > narrow->half95_mm / narrow->deflection_mm);
        announced.pop_back();
        lot.setAnnounced(announced);
        QVERIFY(lot.state() == measured);
    }
    void aLotThatContradictsItsPastLetsGoWithinThePart() {
        Random random(31);
        const Tool means{std::log(kTableTargetDeflection_mm), 0.55, 0.27};
        auto past = std::make_shared<std::vector<PastLot>>();
        for (int lot = 1; lot <= 6; ++lot) {
            past->push_back(
                {lot, {}, boredLot({}, {toolOf(random, means, {0.03, 0.02, 0.02})}, random, 1).stretches()});
        }
        const Tool odd{means.level + 0.8, 0.55, 0.27};
        const LotTracker lot = boredLot({true, {}, past}, {odd}, random, 1);
        QVERIFY(lot.steps().front().perturbed());
        const auto after = estimateOf(lot.steps().front().after).law;
        const double level = after.lnC + after.alpha * kLnFeed + after.beta * kLnOverhang;
        QVERIFY2(std::abs(level - odd.level) < 0.15, qPrintable(QString::number(level - odd.level)));
    }
    void scrapOfLaterLotsIsWhatACarefulMemoryLeaves() {
        const auto paper = scrapOf({kTableSigma_mm, {0.10, 0.06, 0.05}});
        QVERIFY2(meanFrom(paper, 3) <= 0.15, qPrintable(QString::number(meanFrom(paper, 3))));
        const auto fine = scrapOf({0.005, {0.05, 0.04, 0.03}});
        QVERIFY2(meanFrom(fine, 3) <= 0.6, qPrintable(QString::number(meanFrom(fine, 3))));
    }
    void memoryDoesNotCostWhereThePastSaysNothing() {
        for (const double sigma_mm : {kTableSigma_mm, 0.005}) {
            Life life{sigma_mm, {0.05, 0.04, 0.03}, true, true};
            const double with = meanFrom(scrapOf(life), 1);
            life.memory = false;
            const double without = meanFrom(scrapOf(life), 1);
            QVERIFY2(with <= without + 0.1, qPrintable(QStringLiteral("%1 against %2").arg(with).arg(without)));
        }
    }
    void aFirstPartThatTeachesMakesTheSecondRight() {
        for (const double alpha : {0.4, 0.8}) {
            CampaignParams params;
            params.estimator = kalman();
            params.feed = feedLawParams(EstimatorKind::Kalman, kTableTargetDeflection_mm, 0.5);
            params.scrapBand_mm = 0.015;
            params.teach = true;
            TruthPlan truth{{{1, {std::log(kTableC), alpha, kTableBeta}}}, 0.0};
            double scrap = 0.0;
            constexpr int kRuns = 200;
            for (std::uint32_t run = 1; run <= kRuns; ++run) {
                const LotResult lot = simulateLot(params, truth, 5, run);
                scrap += std::accumulate(lot.scrap.begin(), lot.scrap.end(), 0.0) / kRuns;
            }
            QVERIFY2(scrap <= 1.1, qPrintable(QString::number(scrap)));
        }
    }
    void teachingStaysWithinTheLimits() {
        FeedLawParams params = feedLawParams(EstimatorKind::Kalman, kTableTargetDeflection_mm, 0.5);
        params.minFeed_mmPerRev = 0.2;
        const kerf::BoringSchedule schedule = teachSchedule(params);
        for (double overhang_mm = 40.0; overhang_mm <= 310.0; overhang_mm += 1.0) {
            QVERIFY(schedule.feed_mmPerRev(overhang_mm) >= 0.2 && schedule.feed_mmPerRev(overhang_mm) <= 0.5);
        }
        QCOMPARE(schedule.highestFeed_mmPerRev(), 0.5);
    }
};
QTEST_APPLESS_MAIN(TestBoringMemory)
#include "tst_boring_memory.moc"
