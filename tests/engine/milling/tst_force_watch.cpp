// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>

#include "engine/core/random.h"
#include "engine/process/milling/force_watch.h"
#include "engine/process/milling/sampled_force.h"

using namespace kerf;
using milling::ForceWatch;

/// One edge of several gone, told from the raw force alone.
class TestForceWatch : public QObject {
    Q_OBJECT

    struct Cut {
        int flutes{4};
        double ripple{0.35};
        double runOut{0.15};
        double markAt_rev{0.0};   ///< where the spindle's mark lies against the edges
        double chipsAt_rev{8.3};  ///< from here on edge 0 cuts `left` of its chip and edge 1 the rest
        double left{0.1};
        double fallsTo{1.0};  ///< the whole force falls to this share within two revolutions from chipsAt on
        double feedTo{
            1.0};  ///< the feed falls to this share within .02 revolutions from chipsAt on, and the force with it
        double feedFor_rev{1e9};  ///< … for so long
        bool feedKnown{true};
        double breaksAt_rev{1e9};  ///< from here on nothing cuts
        int samplesPerCycle{5};
    };
    /// Where it is seen, revolutions; negative: never.
    [[nodiscard]] static double seenAt_rev(const Cut& cut) {
        ForceWatch::Params params;
        params.flutes = cut.flutes;
        params.inWork_N = 100.0;
        ForceWatch watch(params);
        const milling::ForceShape shape{cut.flutes, cut.ripple, cut.runOut};
        Random noise(7);
        constexpr int kPerRevolution = 500;
        for (int i = 0; i < 14 * kPerRevolution; ++i) {
            const double angle_rev = i / static_cast<double>(kPerRevolution);
            const double past_rev = angle_rev - cut.chipsAt_rev;
            double share = past_rev > 0.0 ? std::lerp(1.0, cut.fallsTo, std::min(past_rev / 2.0, 1.0)) : 1.0;
            const double turn_rev = angle_rev + cut.markAt_rev;
            const int edge =
                static_cast<int>(std::floor((turn_rev - std::floor(turn_rev)) * cut.flutes + 0.5)) % cut.flutes;
            if (past_rev > 0.0 && cut.left < 1.0) {
                share *= edge == 0 ? cut.left : edge == 1 ? 2.0 - cut.left : 1.0;
            }
            const double fed = past_rev <= 0.0 || past_rev > cut.feedFor_rev
                                   ? 1.0
                                   : std::lerp(1.0, cut.feedTo, std::min(past_rev / 0.02, 1.0));
            if (i % cut.samplesPerCycle == 0) {  // the feed of the end of the cycle, as the loop sees it
                const double end_rev = past_rev + cut.samplesPerCycle / static_cast<double>(kPerRevolution);
                const double feed = end_rev <= 0.0 || end_rev > cut.feedFor_rev
                                        ? 1.0
                                        : std::lerp(1.0, cut.feedTo, std::min(end_rev / 0.02, 1.0));
                watch.setFeed(cut.feedKnown ? std::optional(3.0 * feed) : std::nullopt);
            }
            share *= angle_rev < cut.breaksAt_rev ? fed : 0.0;
            FastSample sample;
            sample.stamp_ns = i * 200'000LL;
            sample.spindleAngle_rev = angle_rev;
            sample.force_N = share * milling::sampledForce_N(shape, 400.0, turn_rev) + 2.0 * noise.gauss();
            sample.quality = Quality::Good;
            watch.add(sample);
            if (watch.chipped() || watch.collapsed()) {
                return angle_rev;
            }
        }
        return -1.0;
    }

 private slots:
    void oneChippedEdgeIsSeenWhereverTheMarkLies() {
        int cuts = 0;
        for (const int flutes : {2, 3, 4, 6}) {
            for (int mark = 0; mark < 8; ++mark) {
                for (const double left : {0.0, 0.1}) {
                    for (const double runOut : {0.0, 0.2}) {
                        const Cut cut{flutes, 0.35, runOut, mark / 8.0 / flutes, 8.3, left, 1.0};
                        const double seen_rev = seenAt_rev(cut);
                        QVERIFY2(seen_rev >= 8.3 && seen_rev <= 10.3,
                                 qPrintable(QStringLiteral("%1 flutes, mark %2, left %3: %4")
                                                .arg(flutes)
                                                .arg(mark)
                                                .arg(left)
                                                .arg(seen_rev)));
                        ++cuts;
                    }
                }
            }
        }
        QCOMPARE(cuts, 128);
    }
    void wholeEdgesAreNot() {
        for (const int flutes : {1, 2, 3, 4, 6}) {
            for (const double runOut : {0.0, 0.2}) {
                for (const double fallsTo : {1.0, 0.5, 0.2, 2.0}) {  // steps of the blank, up and down
                    const Cut cut{flutes, 0.35, runOut, 0.1, 8.3, 1.0, fallsTo};
                    QVERIFY(seenAt_rev(cut) < 0.0);
                }
            }
        }
    }
    void aFeedThatFallsIsNoBrokenTool() {
        for (const int flutes : {1, 2, 3, 4, 6}) {
            for (const double feedTo : {0.0, 0.05, 0.15, 0.25, 0.5}) {
                for (const double feedFor_rev : {0.1, 0.25, 0.5, 1e9}) {  // dips too
                    for (const int samplesPerCycle : {5, 250}) {  // a late cycle brings half a revolution at once
                        Cut cut{flutes, 0.35, 0.15, 0.1, 8.3, 1.0};
                        cut.feedTo = feedTo;
                        cut.feedFor_rev = feedFor_rev;
                        cut.samplesPerCycle = samplesPerCycle;
                        QVERIFY2(seenAt_rev(cut) < 0.0, qPrintable(QStringLiteral("%1 flutes, feed to %2 for %3")
                                                                       .arg(flutes)
                                                                       .arg(feedTo)
                                                                       .arg(feedFor_rev)));
                    }
                }
            }
        }
        Cut blind{4, 0.35, 0.15, 0.1, 8.3, 1.0};  // the same force without a word about the feed
        blind.feedTo = 0.1;
        blind.feedKnown = false;
        QVERIFY(seenAt_rev(blind) > 8.3);
    }
    void aToolThatBreaksIsSeenWithEveryNumberOfFlutes() {
        for (const int flutes : {1, 2, 3, 4, 6}) {
            for (const double feedTo : {1.0, 0.6, 2.0}) {  // whatever the feed does
                Cut cut{flutes, 0.35, 0.15, 0.1, 5.0, 1.0};
                cut.feedTo = feedTo;
                cut.breaksAt_rev = 9.37;
                const double seen_rev = seenAt_rev(cut);
                const double most_rev = 9.37 + std::max(1.0, 3.0 / flutes);
                QVERIFY2(seen_rev >= 9.37 && seen_rev <= most_rev,
                         qPrintable(QStringLiteral("%1 flutes, feed to %2: %3").arg(flutes).arg(feedTo).arg(seen_rev)));
            }
        }
    }
};
QTEST_APPLESS_MAIN(TestForceWatch)
#include "tst_force_watch.moc"
